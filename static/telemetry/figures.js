// A track over time: the service's columns, what was recorded of the same, and when the wheel was stuck.

import { isNumber } from "../numbers/columns.js";
import { seconds } from "../numbers/format.js";
import { QUANTITIES, methodName, quantity } from "../quantities/results.js";

/** @import { Track } from "../api/types.js" */
/** @import { ChartSpec, Curve, Domain } from "../charts/spec.js" */
/** @import { Cell } from "../numbers/columns.js" */
/** @import { MeasuredColumns } from "../table/samples.js" */

/** @typedef {"slip" | "sinkage_m" | "longitudinal_force_n" | "torque_n_m"} TrackQuantity */

/** @type {{ id: string, name: TrackQuantity, symbol: string }[]} */
export const TRACK_CHARTS = [
  { id: "track-slip-chart", name: "slip", symbol: "s" },
  { id: "track-sinkage-chart", name: "sinkage_m", symbol: "z" },
  { id: "track-force-chart", name: "longitudinal_force_n", symbol: "F_x" },
  { id: "track-torque-chart", name: "torque_n_m", symbol: "T" },
];
/**
 * Where they are measured, the service takes them as they are, and otherwise computes them.
 * @type {TrackQuantity[]}
 */
const TAKEN_AS_MEASURED = ["slip", "sinkage_m"];

/**
 * @param {number[]} times
 * @returns {Domain}
 */
function timeSpan(times) {
  const [first, last] = times.reduce(([least, most], time) => [Math.min(least, time), Math.max(most, time)], [Infinity, -Infinity]);
  return [first, last > first ? last : first + 1];
}

/**
 * @param {TrackQuantity} name
 * @param {boolean} isMeasured
 * @param {string} method
 */
function originOf(name, isMeasured, method) {
  if (isMeasured && TAKEN_AS_MEASURED.includes(name)) return "Measured";
  return name === "slip" ? "From the velocities" : methodName(method);
}

/**
 * @param {TrackQuantity} name
 * @param {Track} track
 * @param {MeasuredColumns} recorded
 * @param {string} method
 * @returns {ChartSpec | null} null where there is nothing to draw
 */
export function trackSpec(name, { columns, events }, recorded, method) {
  const { name: title, unit, factor } = QUANTITIES[name];
  const rows = columns.time_s.map((_, row) => row).filter((row) => isNumber(columns.time_s[row]));
  const times = rows.map((row) => Number(columns.time_s[row]));
  if (!times.length) return null;

  /** @param {string} key @param {string} label @param {readonly Cell[]} column @returns {Curve} */
  const curveOf = (key, label, column) => ({ key, name: label, values: rows.map((row) => {
    const value = column[row];
    return isNumber(value) ? value * factor : null;
  }) });
  const own = recorded[name];
  const coupled = name === "longitudinal_force_n" ? columns.longitudinal_force_coupled_n : undefined;
  return {
    label: `${title} over time`,
    x: { values: times, domain: timeSpan(times), name: "t", spoken: "time", label: "time t, s", format: seconds },
    y: { unit, missing: "no result", format: (value) => quantity(name, value / factor) },
    curves: [
      ...(own && !TAKEN_AS_MEASURED.includes(name) ? [curveOf("recorded", "Measured", own)] : []),
      ...(coupled?.some(isNumber) ? [curveOf("coupled", "From the measured torque", coupled)] : []),
      curveOf(method, originOf(name, Boolean(own), method), columns[name]),
    ],
    bands: events.map(({ code, from_s: from, to_s: to }) => ({ key: code, from, to })),
    rest: null,
  };
}
