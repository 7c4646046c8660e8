// A track over time: the service's columns, what was recorded of the same, and when the wheel was stuck.

import { METHOD_NAMES, QUANTITIES, quantity, significant, withUnit } from "./format.js";

export const TRACK_CHARTS = [
  { id: "track-slip-chart", name: "slip" },
  { id: "track-sinkage-chart", name: "sinkage_m" },
  { id: "track-force-chart", name: "longitudinal_force_n" },
  { id: "track-torque-chart", name: "torque_n_m" },
];
const COUPLED = { longitudinal_force_n: "longitudinal_force_coupled_n" };
/** These are the service's own where they are not measured, and the measured ones else. */
const TAKEN_AS_MEASURED = ["slip", "sinkage_m"];

const seconds = (value) => withUnit(significant(value, 4), "s");
const isNumber = (value) => value !== null && value !== undefined;

/** `recorded` are the columns of the table by quantity; null where there is nothing to draw. */
export function trackSpec(name, { columns, events }, recorded, method) {
  const { name: title, unit, factor } = QUANTITIES[name];
  const rows = columns.time_s.map((_, row) => row).filter((row) => isNumber(columns.time_s[row]));
  const times = rows.map((row) => columns.time_s[row]);
  const curveOf = (key, label, column) => ({ key, name: label, values: rows.map((row) => (isNumber(column[row]) ? column[row] * factor : null)) });
  const isMeasured = Boolean(recorded[name]);
  const curves = [];
  if (isMeasured && !TAKEN_AS_MEASURED.includes(name)) curves.push(curveOf("recorded", "Measured", recorded[name]));
  if (columns[COUPLED[name]]?.some(isNumber)) curves.push(curveOf("coupled", "From the measured torque", columns[COUPLED[name]]));
  const origin = name === "slip" ? "From the velocities" : METHOD_NAMES[method];
  curves.push(curveOf(method, isMeasured && TAKEN_AS_MEASURED.includes(name) ? "Measured" : origin, columns[name]));
  if (!times.length) return null;
  const [first, last] = times.reduce(([least, most], time) => [Math.min(least, time), Math.max(most, time)], [Infinity, -Infinity]);
  return {
    label: `${title} over time`,
    x: { values: times, domain: [first, last > first ? last : first + 1], name: "t", spoken: "time", label: "time t, s", format: seconds },
    y: { unit, missing: "no result", format: (value) => quantity(name, value / factor) },
    curves,
    marks: [],
    dots: [],
    bands: events.map(({ code, from_s: from, to_s: to }) => ({ key: code, from, to })),
    rest: null,
  };
}
