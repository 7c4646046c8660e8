// How far measured points lie from the curves that are drawn: arithmetic of the drawing, with straight lines between samples.

import { MEASURED } from "./columns.js";
import { html } from "./elements.js";
import { residualOf } from "./figures.js";
import { METHOD_NAMES, quantity } from "./format.js";

export function residualTable(measured, series) {
  const names = Object.keys(MEASURED).filter((name) => name !== "slip" && measured[name]);
  const cell = (name, { method, columns }) => {
    const { rms, count } = residualOf(name, measured, columns);
    const text = rms === null ? "no curve there" : quantity(name, rms);
    const part = rms !== null && count < measured.slip.length ? ` (${count} of ${measured.slip.length} points)` : "";
    return html("td", { "data-rms": name, "data-method": method, "data-value": rms ?? "" }, text + part);
  };
  return html("table", {},
    html("caption", {}, "Root mean square of measured less shown curve"),
    html("thead", {}, html("tr", {}, html("th", { scope: "col" }, "Quantity"), ...series.map(({ method }) => html("th", { scope: "col" }, METHOD_NAMES[method])))),
    html("tbody", {}, ...names.map((name) => html("tr", {}, html("th", { scope: "row" }, MEASURED[name].label), ...series.map((each) => cell(name, each))))));
}
