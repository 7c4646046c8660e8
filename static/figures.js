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
    curves: STRESS_CURVES.map(({ key, name, column }) => ({ key, name, values: inKilopascal(columns[column]) })),
    marks: marks.map(({ key, at, symbol }) => ({ key, at, label: `${symbol} ${fixed(at, 1)}°` })),
    dots: [],
    rest: degrees(angles.maximum_stress_rad),
  };
}

/** Both ratios run away where their denominator vanishes; beyond these values the curves say nothing more. */
const AXIS_LIMITS = { tractive_efficiency: { min: -50, max: 100 }, drawbar_coefficient: { min: -3, max: 3 } };
const MISSING = { tractive_efficiency: "not defined", drawbar_coefficient: "not defined" };

/** `series`: curves by method; `byMethod`: outcomes at the chosen `slip`, which need not be among the sweep's. */
export function sweepSpec(name, { series, byMethod, slip }) {
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
    rest: at >= slips[0] && at <= slips.at(-1) ? at : null,
  };
}
