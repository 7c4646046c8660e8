// The model as the API states it (/v1/model), set in readable form in a dialog: conventions, symbols, equations, errata.

import { modelStatement } from "./api.js";
import { html } from "./elements.js";

/** F_x and k_phi, θ1 and n0, θm and σm are letters with subscripts; ^N and ^(n+1) are powers. */
const MATHS = /(?<![\p{L}\p{N}])(\p{L})_(\p{L}+)|(?<![\p{L}\p{N}])([θnzcλ])(\d)(?!\d)|([θστz])_?(m)(?![\p{L}])|\^(\p{L}|\([^)]*\))/gu;

export function formulaHtml(text) {
  const nodes = [];
  let end = 0;
  for (const match of text.matchAll(MATHS)) {
    const [whole, named, name, indexed, index, peaked, peak, power] = match;
    nodes.push(text.slice(end, match.index));
    if (power) nodes.push(html("sup", {}, power.replace(/^\((.*)\)$/, "$1")));
    else nodes.push(named ?? indexed ?? peaked, html("sub", {}, name ?? index ?? peak));
    end = match.index + whole.length;
  }
  return [...nodes, text.slice(end)].filter((node) => node !== "");
}

/** Formulas, and between backticks names of the API. */
const maths = (text) => (text ?? "").split(/`([^`]*)`/).flatMap((part, index) => (index % 2 ? html("code", {}, part) : formulaHtml(part)));

function table(className, heads, rows) {
  return html("div", { class: "wide" }, html("table", { class: `statement ${className}` },
    html("thead", {}, html("tr", {}, ...heads.map((head) => html("th", { scope: "col" }, head)))),
    html("tbody", {}, ...rows.map(({ attributes = {}, cells: [first, ...others] }) => html("tr", attributes,
      html("th", { scope: "row" }, ...first),
      ...others.map((cell, index) => html("td", { "data-head": heads[index + 1] }, ...cell)))))));
}

const list = (items) => html("ul", {}, ...items.map((item) => html("li", {}, ...maths(item))));

/** An equation's number in the letter, its source and note, and the errata that hold for it. */
function aboutEquation({ letter, source, note, errata = [] }) {
  const parts = [
    letter?.length ? [`letter, Eq. ${letter.map((number) => `(${number})`).join(", ")}`] : null,
    source ? [source] : null,
    note ? maths(note) : null,
    errata.length ? [errata.length > 1 ? "errata " : "erratum ",
      ...errata.flatMap((number, index) => [index ? ", " : "", html("a", { href: `#erratum-${number}` }, String(number))])] : null,
  ];
  return parts.filter(Boolean).flatMap((part, index) => (index ? ["; ", ...part] : part));
}

function sections(model) {
  return [
    ["conventions", "Conventions", list(model.conventions)],
    ["symbols", "Symbols", table("symbols", ["Symbol", "Meaning", "Unit", "Field of the API"], model.symbols.map(({ symbol, meaning, unit, field }) =>
      ({ cells: [maths(symbol), maths(meaning), maths(unit), field ? [html("code", {}, field)] : []] })))],
    ["equations", "Equations", table("equations", ["Equation", "As computed", "Source and notes"], model.equations.map((equation) =>
      ({ cells: [[equation.name], maths(equation.formula), aboutEquation(equation)] })))],
    ["methods", "Methods", table("methods", ["Method", "What it does", "Accuracy"], model.methods.map(({ method, description, accuracy }) =>
      ({ cells: [[method], maths(description), maths(accuracy)] })))],
    ["errata", "Errata of the letter", table("errata", ["No.", "As printed", "As computed", "Reason"], model.errata.map(({ number, printed, computed, reason }) =>
      ({ attributes: { id: `erratum-${number}`, tabindex: "-1" }, cells: [[String(number)], maths(printed), maths(computed), maths(reason)] })))],
    ["refusals", "What is refused", list(model.refusals)],
    ["warnings", "Warnings", table("warning-codes", ["Code", "Meaning"], model.warnings.map(({ code, meaning }) =>
      ({ cells: [[html("code", {}, code)], maths(meaning)] })))],
    ["references", "References", list(model.references)],
  ];
}

/** The dialog opens from its link and from an address that ends in #model; the statement is asked for once. */
export function connectEquations(dialog, link) {
  const body = dialog.querySelector("[data-model]");
  let isFilled = false;

  async function fill() {
    try {
      const model = await modelStatement();
      const parts = sections(model);
      body.replaceChildren(
        html("p", { class: "note" }, model.source),
        html("nav", { "aria-label": "Parts of the model" }, ...parts.map(([id, title]) => html("a", { href: `#model-${id}` }, title))),
        ...parts.map(([id, title, content]) => html("section", { id: `model-${id}`, tabindex: "-1" }, html("h3", {}, title), content)));
      isFilled = true;
    } catch (error) {
      body.replaceChildren(html("p", { class: "fault" }, error.message));
    }
  }

  function open() {
    if (!dialog.open) dialog.showModal();
    if (!isFilled) fill();
  }

  link.addEventListener("click", (event) => {
    event.preventDefault();
    event.stopPropagation();
    open();
  });
  dialog.querySelector("[data-close]").addEventListener("click", () => dialog.close());
  // A click on the backdrop comes as one on the dialog itself.
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  if (location.hash === "#model") open();
}
