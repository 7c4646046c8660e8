// The model as the API states it (/v1/model), set in readable form in a dialog: conventions, symbols, equations, errata.

import { model } from "../api/model.js";
import { html } from "../dom/elements.js";
import { columnHeads, rowHead, table } from "../dom/tables.js";
import { maths } from "./formula.js";

/** @import { Equation, Model } from "../api/types.js" */
/** @import { Attributes, Child } from "../dom/elements.js" */

/** @typedef {{ attributes?: Attributes, cells: [Child[], ...Child[][]] }} StatementRow */

/**
 * @param {string} kind
 * @param {string[]} heads
 * @param {StatementRow[]} rows
 */
const statementTable = (kind, heads, rows) => html("div", { class: "wide" }, table({ class: `statement ${kind}` }, {
  heads: [html("tr", {}, ...columnHeads(heads))],
  rows: rows.map(({ attributes = {}, cells: [first, ...others] }) => html("tr", attributes,
    rowHead(...first),
    ...others.map((cell, index) => html("td", { "data-head": heads[index + 1] }, ...cell)))),
}));

/** @param {string[]} items */
const list = (items) => html("ul", {}, ...items.map((item) => html("li", {}, ...maths(item))));

/** @param {number[]} errata */
const errataLinks = (errata) => [
  errata.length > 1 ? "errata " : "erratum ",
  ...errata.flatMap((number, index) => [index ? ", " : "", html("a", { href: `#erratum-${number}` }, String(number))]),
];

/**
 * An equation's number in the letter, its source and note, and the errata that hold for it.
 * @param {Equation} equation
 * @returns {Child[]}
 */
function aboutEquation({ letter, source, note, errata = [] }) {
  /** @type {Child[][]} */
  const parts = [];
  if (letter.length) parts.push([`letter, Eq. ${letter.map((number) => `(${number})`).join(", ")}`]);
  if (source) parts.push([source]);
  if (note) parts.push(maths(note));
  if (errata.length) parts.push(errataLinks(errata));
  return parts.flatMap((part, index) => (index ? ["; ", ...part] : part));
}

/**
 * @param {Model} stated
 * @returns {[string, string, HTMLElement][]} id, title and content of each part
 */
const sections = (stated) => [
  ["conventions", "Conventions", list(stated.conventions)],
  ["symbols", "Symbols", statementTable("symbols", ["Symbol", "Meaning", "Unit", "Field of the API"], stated.symbols.map(({ symbol, meaning, unit, field }) =>
    ({ cells: [maths(symbol), maths(meaning), maths(unit), field ? [html("code", {}, field)] : []] })))],
  ["equations", "Equations", statementTable("equations", ["Equation", "As computed", "Source and notes"], stated.equations.map((equation) =>
    ({ cells: [[equation.name], maths(equation.formula), aboutEquation(equation)] })))],
  ["methods", "Methods", statementTable("methods", ["Method", "What it does", "Accuracy"], stated.methods.map(({ method, description, accuracy }) =>
    ({ cells: [[method], maths(description), maths(accuracy)] })))],
  ["laws", "Laws", statementTable("laws", ["Law", "Formula", "Parameters", "What it says"], stated.laws.flatMap(({ laws }) => laws).map((law) =>
    ({ cells: [[html("code", {}, law.name)], maths(law.formula), maths(law.parameters.map(({ symbol }) => symbol).join(", ")), maths(law.meaning)] })))],
  ["errata", "Errata of the letter", statementTable("errata", ["No.", "As printed", "As computed", "Reason"], stated.errata.map(({ number, printed, computed, reason }) =>
    ({ attributes: { id: `erratum-${number}`, tabindex: "-1" }, cells: [[String(number)], maths(printed), maths(computed), maths(reason)] })))],
  ["refusals", "What is refused", list(stated.refusals)],
  ["warnings", "Warnings", statementTable("warning-codes", ["Code", "Meaning"], (stated.warnings ?? []).map(({ code, meaning }) =>
    ({ cells: [[html("code", {}, code)], maths(meaning)] })))],
  ["references", "References", list(stated.references)],
];

/** What the dialog has. */
export function statement() {
  const stated = model();
  const parts = sections(stated);
  return [
    html("p", { class: "note" }, stated.source),
    html("nav", { "aria-label": "Parts of the model" }, ...parts.map(([id, title]) => html("a", { href: `#model-${id}` }, title))),
    ...parts.map(([id, title, content]) => html("section", { id: `model-${id}`, tabindex: "-1" }, html("h3", {}, title), content)),
  ];
}
