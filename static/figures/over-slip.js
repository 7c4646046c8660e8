// A result over slip: its curves, the chosen slip, and measured points.

import { columnOf, scaled } from "../numbers/columns.js";
import { percent } from "../numbers/format.js";
import { QUANTITIES, methodName, quantity } from "../quantities/results.js";
import { distanceFromCurve } from "./distance.js";
import { inPercent, slipAxis } from "./slip-axis.js";

/** @import { FitData, Forces, Method, SweepColumns } from "../api/types.js" */
/** @import { ChartSpec, Dot, Points } from "../charts/spec.js" */

/** @typedef {{ method: string, columns: SweepColumns }} SweepSeries */

/**
 * @typedef {object} ShownSweep
 * @property {SweepSeries[]} series
 * @property {{ method: Method, forces: Forces | null }[]} byMethod the forces at the chosen slip, which need not be one of the sweep's
 * @property {number} slip
 * @property {string[]} basis what the curves rest on
 * @property {Method} method the chosen one
 */

/**
 * Both ratios run away where their denominator vanishes. Beyond these values the curves say nothing more.
 * @type {Record<string, { min: number, max: number }>}
 */
const AXIS_LIMITS = { tractive_efficiency: { min: -50, max: 100 }, drawbar_coefficient: { min: -3, max: 3 } };
/** @type {Record<string, string>} */
const MISSING = { tractive_efficiency: "not defined", drawbar_coefficient: "not defined" };

/**
 * Measured points over the curve of a quantity, if it was measured.
 * @param {string} name
 * @param {FitData | null} measured
 * @param {SweepColumns} columns
 * @returns {Points | null}
 */
function measuredPoints(name, measured, columns) {
  const values = measured?.[/** @type {keyof FitData} */ (name)];
  if (!measured || !values) return null;
  const { rms } = distanceFromCurve(name, measured, columns);
  const { factor } = QUANTITIES[name];
  return {
    key: "measured",
    name: "Measured",
    reading: rms === null ? "" : `rms ${quantity(name, rms)}`,
    points: inPercent(measured.slip).map((at, row) => ({ at, value: values[row] * factor })),
  };
}

/**
 * @param {string} name
 * @param {Forces} forces
 * @returns {number | null}
 */
function resultOf(name, { components, ...forces }) {
  const results = /** @type {Record<string, any>} */ ({ ...components, ...forces });
  return results[name] ?? null;
}

/**
 * @param {string} name
 * @param {ShownSweep} sweep
 * @param {FitData | null} measured
 * @returns {ChartSpec}
 */
export function sweepSpec(name, { series, byMethod, slip, method: chosen, basis }, measured = null) {
  const { name: title, unit, factor } = QUANTITIES[name];
  const slips = inPercent(series[0].columns.slip);
  const [first, last] = [slips[0], slips[slips.length - 1]];
  const at = slip * 100;
  const dots = byMethod.flatMap(({ method, forces }) => {
    const value = forces && resultOf(name, forces);
    return value === null ? [] : [/** @type {Dot} */ ({ key: method, at, value: value * factor })];
  });
  return {
    label: `${title} over slip`,
    x: slipAxis(slips, [first, last]),
    y: { unit, limits: AXIS_LIMITS[name], missing: MISSING[name], format: (value) => quantity(name, value / factor) },
    curves: series.map(({ method, columns }) => ({ key: method, name: methodName(method), values: scaled(columnOf(columns, name), factor) })),
    marks: [{ key: "slip", at, label: `s ${percent(at)}` }],
    dots,
    basis,
    measured: measuredPoints(name, measured, (series.find(({ method }) => method === chosen) ?? series[0]).columns),
    rest: at >= first && at <= last ? at : null,
  };
}
