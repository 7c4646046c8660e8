// How far measured points lie from the curves that are drawn, or from what a fit predicts for each of them.

import { html } from "../dom/elements.js";
import { columnHeads, rowHead, table } from "../dom/tables.js";
import { distanceFromCurve } from "../figures/distance.js";
import { MEASURED } from "../quantities/measured.js";
import { methodName, quantity } from "../quantities/results.js";

/** @import { FitData } from "../api/types.js" */
/** @import { SweepSeries } from "../figures/over-slip.js" */

/** A method with its errors at the points' own loads or sinkages. @typedef {{ method: string, errors: Record<string, number> }} OwnPredictions */

/**
 * @param {string} name
 * @param {FitData} measured
 * @param {SweepSeries} series
 * @param {OwnPredictions | null} own
 */
function distanceCell(name, measured, { method, columns }, own) {
  if (method === own?.method) {
    const error = own.errors[name];
    return html("td", { "data-rms": name, "data-method": method, "data-value": error ?? "" }, error === undefined ? "given" : quantity(name, error));
  }
  const { rms, count } = distanceFromCurve(name, measured, columns);
  const all = measured.slip.length;
  const text = rms === null ? "no curve there" : quantity(name, rms);
  const part = rms !== null && count < all ? ` (${count} of ${all} points)` : "";
  return html("td", { "data-rms": name, "data-method": method, "data-value": rms ?? "" }, text + part);
}

/**
 * @param {FitData} measured
 * @param {SweepSeries[]} series
 * @param {OwnPredictions | null} own
 */
export function distanceTable(measured, series, own) {
  const names = Object.keys(MEASURED).filter((name) => name !== "slip" && name in measured);
  return table({}, {
    caption: own ? "Root mean square of measured minus predicted" : "Root mean square of measured minus curve",
    heads: [html("tr", {}, ...columnHeads(["Quantity", ...series.map(({ method }) => methodName(method))]))],
    rows: names.map((name) => html("tr", {}, rowHead(MEASURED[name].label), ...series.map((each) => distanceCell(name, measured, each, own)))),
  });
}
