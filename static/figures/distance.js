// How far measured points lie from a drawn curve: arithmetic of the drawing, with straight lines between the samples.

import { columnOf } from "../numbers/columns.js";

/** @import { FitData, SweepColumns } from "../api/types.js" */
/** @import { Cell } from "../numbers/columns.js" */

/**
 * A column between its samples; null beyond them and at gaps.
 * @param {readonly number[]} slips
 * @param {readonly Cell[]} values
 * @param {number} slip
 */
function between(slips, values, slip) {
  const next = slips.findIndex((each) => each >= slip);
  if (next < 0 || slip < slips[0]) return null;
  const before = Math.max(0, next - 1);
  const [from, to] = [values[before], values[next]];
  if (from === null || to === null) return null;
  return next === before ? to : from + ((slip - slips[before]) / (slips[next] - slips[before])) * (to - from);
}

/**
 * Root of the mean squared distance of the points from the curve, where it has values; null where it has none.
 * @param {string} name
 * @param {FitData} measured
 * @param {SweepColumns} columns
 */
export function distanceFromCurve(name, measured, columns) {
  const values = columnOf(measured, name);
  const curve = columnOf(columns, name);
  const gaps = measured.slip.flatMap((slip, row) => {
    const [shown, value] = [between(columns.slip, curve, slip), values[row]];
    return shown === null || value === null ? [] : [value - shown];
  });
  return { count: gaps.length, rms: gaps.length ? Math.sqrt(gaps.reduce((sum, gap) => sum + gap * gap, 0) / gaps.length) : null };
}
