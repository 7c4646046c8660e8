// What the rover does over the slope.

import { scaled } from "../numbers/columns.js";
import { degrees, fixed } from "../numbers/format.js";
import { QUANTITIES, methodName, quantity } from "../quantities/results.js";

/** @import { VehicleOnSlope, VehicleOverSlopes } from "../api/types.js" */
/** @import { ChartSpec, Mark } from "../charts/spec.js" */

/** @type {{ id: string, name: "slip" | "energy_per_metre_j_m", symbol: string }[]} */
export const SLOPE_CHARTS = [
  { id: "rover-slip-chart", name: "slip", symbol: "s" },
  { id: "rover-energy-chart", name: "energy_per_metre_j_m", symbol: "" },
];

/** @param {number} slope (°) */
const inDegrees = (slope) => `${fixed(slope, 1)}°`;

/** @param {number} slope (rad) */
export const slopeText = (slope) => inDegrees(degrees(slope));

/**
 * @param {"slip" | "energy_per_metre_j_m"} name
 * @param {VehicleOverSlopes} slopes
 * @param {VehicleOnSlope} rover on the chosen slope
 * @returns {ChartSpec}
 */
export function slopeSpec(name, { method, columns, largest_slope_rad: largest }, rover) {
  const { name: title, unit, factor } = QUANTITIES[name];
  const values = columns.slope_rad.map(degrees);
  const [first, last] = [values[0], values[values.length - 1]];
  const at = degrees(rover.slope_rad);
  const value = rover[name];
  /** @type {Mark[]} */
  const marks = [
    { key: "slope", at, label: `α ${inDegrees(at)}` },
    ...(typeof largest === "number" ? [{ key: "largest", at: degrees(largest), label: `most ${slopeText(largest)}` }] : []),
  ];
  return {
    label: `${title} over slope`,
    x: { values, domain: [Math.min(first, last), Math.max(first, last)], name: "α", spoken: "slope", label: "slope α, °", format: inDegrees },
    y: { unit, missing: "not climbed", format: (shown) => quantity(name, shown / factor) },
    curves: [{ key: method, name: methodName(method), values: scaled(columns[name], factor) }],
    marks,
    dots: typeof value === "number" ? [{ key: method, at, value: value * factor }] : [],
    rest: at >= Math.min(first, last) && at <= Math.max(first, last) ? at : null,
  };
}
