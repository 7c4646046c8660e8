// The first rows of a table, and what a person takes its columns for.

import { MEASURED, choiceFrom, choiceOf } from "./columns.js";
import { html } from "./elements.js";

const PREVIEW_ROWS = 5;

function columnSelect(column, heading, mapped) {
  const options = Object.entries(MEASURED).map(([key, { label, units }]) => html("optgroup", { label },
    ...units.map((unit) => html("option", { value: choiceOf({ quantity: key, unit }) }, `${label}, ${unit.text}`))));
  const select = html("select", { "data-column": column, "aria-label": `What the column ${heading} is` }, html("option", { value: "" }, "Ignore"), ...options);
  select.value = choiceOf(mapped);
  return select;
}

/** Its heading, what it is taken for, and the first cells; `onChoice(column, mapped)` tells of another choice. */
export function mappingTable({ columns, lines }, mapping, onChoice) {
  const selects = columns.map(({ heading }, column) => columnSelect(column, heading, mapping[column]));
  selects.forEach((select, column) => select.addEventListener("change", () => onChoice(column, choiceFrom(select.value))));
  const rows = lines.slice(0, PREVIEW_ROWS).map((line, row) => html("tr", {},
    html("th", { scope: "row" }, `Line ${line}`),
    ...columns.map(({ cells }, column) => html("td", { "data-cell": `${line} ${column}` }, cells[row] || "–"))));
  return html("table", {},
    html("thead", {},
      html("tr", {}, html("td", {}), ...columns.map(({ heading, unit }) => html("th", { scope: "col" }, [heading, unit].filter(Boolean).join(", ")))),
      html("tr", {}, html("td", {}, "is"), ...selects.map((select) => html("td", {}, select)))),
    html("tbody", {}, ...rows));
}

/** Marks the cells of chosen columns that are no numbers. */
export function markWrong(preview, { faults }, mapping) {
  const wrong = new Set(faults.filter(({ column }) => mapping[column]).map(({ line, column }) => `${line} ${column}`));
  for (const cell of preview.querySelectorAll("[data-cell]")) cell.classList.toggle("wrong", wrong.has(cell.dataset.cell));
}
