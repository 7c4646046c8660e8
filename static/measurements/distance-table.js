// How far measured points lie from the curves that are drawn.

import { html } from "../dom/elements.js";
import { columnHeads, rowHead, table } from "../dom/tables.js";
import { distanceFromCurve } from "../figures/distance.js";
import { MEASURED } from "../quantities/measured.js";
import { methodName, quantity } from "../quantities/results.js";

/** @import { FitData } from "../api/types.js" */
/** @import { SweepSeries } from "../figures/over-slip.js" */

/**
 * @param {string} name
 * @param {FitData} measured
 * @param {SweepSeries} series
 */
function distanceCell(name, measured, { method, columns }) {
  const { rms, count } = distanceFromCurve(name, measured, columns);
  const all = measured.slip.length;
  const text = rms === null ? "no curve there" : quantity(name, rms);
  const part = rms !== null && count < all ? ` (${count} of ${all} points)` : "";
  return html("td", { "data-rms": name, "data-method": method, "data-value": rms ?? "" }, text + part);
}

/**
 * @param {FitData} measured
 * @param {SweepSeries[]} series
 */
export function distanceTable(measured, series) {
  const names = Object.keys(MEASURED).filter((name) => name !== "slip" && name in measured);
  return table({}, {
    caption: "Root mean square of measured minus curve",
    heads: [html("tr", {}, ...columnHeads(["Quantity", ...series.map(({ method }) => methodName(method))]))],
    rows: names.map((name) => html("tr", {}, rowHead(MEASURED[name].label), ...series.map((each) => distanceCell(name, measured, each)))),
  });
}
