// Which of the API's columns each chart shows, and in which units.

import { METHOD_NAMES, QUANTITIES, degrees, fixed, quantity, significant, withUnit } from "./format.js";

const scaled = (values, factor) => values.map((value) => (value === null ? null : value * factor));
const percent = (value) => withUnit(fixed(value, 1), "%");
const inKilopascal = (values) => scaled(values, 1e-3);

const STRESS_CURVES = [
  { key: "normal", name: "σ", column: "normal_stress_pa" },
  { key: "normal-linear", name: "σ linearised", column: "normal_stress_linear_pa" },
  { key: "shear", name: "τ", column: "shear_stress_pa" },
  { key: "shear-linear", name: "τ linearised", column: "shear_stress_linear_pa" },
];

export function profileSpec({ angles, columns }) {
  const theta = columns.theta_rad.map(degrees);
  const marks = [
    { key: "exit", at: degrees(angles.exit_rad), symbol: "θ_2" },
    { key: "maximum", at: degrees(angles.maximum_stress_rad), symbol: "θ_m" },
    { key: "entry", at: degrees(angles.entry_rad), symbol: "θ_1" },
  ];
  return {
    label: "Normal and shear stress over the contact angle, exact and linearised",
    x: {
      values: theta,
      domain: [marks[0].at, marks[2].at],
      name: "θ",
      spoken: "angle",
      label: "angle θ from straight down, ° (exit to entry)",
      format: (value) => `${fixed(value, 1)}°`,
    },
    y: { unit: "kPa", format: (value) => withUnit(significant(value), "kPa") },
    // Two zones of a braking wheel have no linear stresses.
    curves: STRESS_CURVES.filter(({ column }) => columns[column].some((value) => value !== null)).map(({ key, name, column }) => ({ key, name, values: inKilopascal(columns[column]) })),
    marks: marks.map(({ key, at, symbol }) => ({ key, at, label: `${symbol} ${fixed(at, 1)}°` })),
    dots: [],
    rest: degrees(angles.maximum_stress_rad),
  };
}

/** Both ratios run away where their denominator vanishes; beyond these values the curves say nothing more. */
const AXIS_LIMITS = { tractive_efficiency: { min: -50, max: 100 }, drawbar_coefficient: { min: -3, max: 3 } };
const MISSING = { tractive_efficiency: "not defined", drawbar_coefficient: "not defined" };

/** A column between its samples, for display; null beyond them and at gaps. */
function between(slips, values, slip) {
  const next = slips.findIndex((each) => each >= slip);
  if (next < 0 || slip < slips[0]) return null;
  const before = Math.max(0, next - 1);
  const [from, to] = [values[before], values[next]];
  if (from === null || to === null) return null;
  return next === before ? to : from + ((slip - slips[before]) / (slips[next] - slips[before])) * (to - from);
}

/** A measured quantity's distance from the fit, as the service gives it, over slip: invisible as a curve, drawn as points. */
export function residualSpec(name, { columns, rmse }) {
  const { name: title, unit, factor } = QUANTITIES[name];
  const rows = columns.slip.map((_, row) => row).sort((a, b) => columns.slip[a] - columns.slip[b]);
  const slips = rows.map((row) => columns.slip[row] * 100);
  const values = scaled(rows.map((row) => columns[`residual_${name}`][row]), factor);
  const present = values.map((_, row) => row).filter((row) => values[row] !== null);
  const margin = Math.max(1, 0.04 * (slips.at(-1) - slips[0]));
  return {
    label: `${title}, predicted less measured, over slip`,
    x: { values: slips, domain: [slips[0] - margin, slips.at(-1) + margin], name: "s", spoken: "slip", label: "slip s, %", format: percent },
    y: { unit, missing: "no prediction", format: (value) => quantity(name, value / factor) },
    curves: [{ key: "measured", name: `Residual, rms ${quantity(name, rmse[name])}`, values }],
    marks: [],
    dots: [],
    points: { key: "measured", name: "", reading: "", at: present.map((row) => slips[row]), values: present.map((row) => values[row]), isListed: false },
    rest: null,
  };
}

/** Root of the mean squared distance of measured points from a curve, where it has values; null where it has none. */
export function residualOf(name, measured, columns) {
  const gaps = measured.slip.map((slip, row) => [between(columns.slip, columns[name], slip), measured[name][row]])
    .filter(([shown]) => shown !== null).map(([shown, value]) => value - shown);
  return { count: gaps.length, rms: gaps.length ? Math.sqrt(gaps.reduce((sum, gap) => sum + gap * gap, 0) / gaps.length) : null };
}

/** Measured points over a quantity's curve, with their distance from it, if the quantity was measured. */
function pointsOf(name, measured, columns) {
  if (!measured?.[name]) return null;
  const { rms } = residualOf(name, measured, columns);
  return {
    key: "measured",
    name: "Measured",
    reading: rms === null ? "" : `rms ${quantity(name, rms)}`,
    at: scaled(measured.slip, 100),
    values: scaled(measured[name], QUANTITIES[name].factor),
  };
}

/** `series`: curves by method; `byMethod`: outcomes at the chosen `slip`, which need not be among the sweep's. */
export function sweepSpec(name, { series, byMethod, slip, method }, measured = null) {
  const { name: title, unit, factor } = QUANTITIES[name];
  const points = byMethod.filter(({ forces }) => forces.answer).map(({ method, forces: { answer } }) => ({
    method,
    value: answer[name] ?? answer.components[name] ?? null,
  }));
  const slips = scaled(series[0].columns.slip, 100);
  const at = slip * 100;
  return {
    label: `${title} over slip`,
    x: { values: slips, domain: [slips[0], slips.at(-1)], name: "s", spoken: "slip", label: "slip s, %", format: percent },
    y: {
      unit,
      limits: AXIS_LIMITS[name],
      missing: MISSING[name],
      format: (value) => quantity(name, value / factor),
    },
    curves: series.map(({ method, columns }) => ({ key: method, name: METHOD_NAMES[method], values: scaled(columns[name], factor) })),
    marks: [{ key: "slip", at, label: `s ${percent(at)}` }],
    dots: points.filter(({ value }) => value !== null).map(({ method, value }) => ({ key: method, at, value: value * factor })),
    points: pointsOf(name, measured, series.find((each) => each.method === method)?.columns ?? series[0].columns),
    rest: at >= slips[0] && at <= slips.at(-1) ? at : null,
  };
}
