// The first rows of a table, with what its columns are taken for.

import { html } from "../dom/elements.js";
import { findAll } from "../dom/find.js";
import { columnHeads, rowHead, table } from "../dom/tables.js";
import { MEASURED } from "../quantities/measured.js";
import { choiceFrom, choiceOf } from "./columns.js";

/** @import { Mapped, Mapping } from "./columns.js" */
/** @import { Table } from "./parse.js" */

const PREVIEW_ROWS = 5;

/**
 * @param {number} column
 * @param {string} heading
 * @param {Mapped | null} mapped
 */
function columnSelect(column, heading, mapped) {
  const options = Object.entries(MEASURED).map(([key, { label, units }]) => html("optgroup", { label },
    ...units.map((unit) => html("option", { value: choiceOf({ quantity: key, unit }) }, `${label}, ${unit.text}`))));
  const select = html("select", { "data-column": column, "aria-label": `What the column ${heading} is` }, html("option", { value: "" }, "Ignore"), ...options);
  select.value = choiceOf(mapped);
  return select;
}

/**
 * @param {Table} parsed
 * @param {Mapping} mapping
 * @param {(column: number, mapped: Mapped | null) => void} onChoice
 */
export function mappingTable({ columns, lines }, mapping, onChoice) {
  const selects = columns.map(({ heading }, column) => columnSelect(column, heading, mapping[column]));
  selects.forEach((select, column) => select.addEventListener("change", () => onChoice(column, choiceFrom(select.value))));
  const rows = lines.slice(0, PREVIEW_ROWS).map((line, row) => html("tr", {},
    rowHead(`Line ${line}`),
    ...columns.map(({ cells }, column) => html("td", { "data-cell": `${line} ${column}` }, cells[row] || "–"))));
  return table({}, {
    heads: [
      html("tr", {}, html("td", {}), ...columnHeads(columns.map(({ heading, unit }) => [heading, unit].filter(Boolean).join(", ")))),
      html("tr", {}, html("td", {}, "is"), ...selects.map((select) => html("td", {}, select))),
    ],
    rows,
  });
}

/**
 * Marks the cells of chosen columns that are not numbers.
 * @param {HTMLElement} preview
 * @param {Table} parsed
 * @param {Mapping} mapping
 */
export function markWrong(preview, { faults }, mapping) {
  const wrong = new Set(faults.filter(({ column }) => mapping[column]).map(({ line, column }) => `${line} ${column}`));
  for (const cell of findAll(preview, "[data-cell]")) cell.classList.toggle("wrong", wrong.has(cell.dataset.cell ?? ""));
}
