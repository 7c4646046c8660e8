// The stresses along the contact.

import { isNumber, scaled } from "../numbers/columns.js";
import { degrees, fixed, significant, withUnit } from "../numbers/format.js";

/** @import { ProfileColumns, StressProfile } from "../api/types.js" */
/** @import { ChartSpec } from "../charts/spec.js" */

const PASCAL_TO_KILOPASCAL = 1e-3;

/** @type {{ key: string, name: string, column: keyof ProfileColumns }[]} */
const STRESS_CURVES = [
  { key: "normal", name: "σ", column: "normal_stress_pa" },
  { key: "normal-linear", name: "σ linearised", column: "normal_stress_linear_pa" },
  { key: "shear", name: "τ", column: "shear_stress_pa" },
  { key: "shear-linear", name: "τ linearised", column: "shear_stress_linear_pa" },
];

/**
 * @param {StressProfile} profile
 * @param {string[]} basis what the stresses rest on
 * @returns {ChartSpec}
 */
export function profileSpec({ angles, columns }, basis) {
  const [exit, maximum, entry] = [angles.exit_rad, angles.maximum_stress_rad, angles.entry_rad].map(degrees);
  const marks = [
    { key: "exit", at: exit, symbol: "θ_2" },
    { key: "maximum", at: maximum, symbol: "θ_m" },
    { key: "entry", at: entry, symbol: "θ_1" },
  ];
  // Two zones of a braking wheel have no linear stresses.
  const present = STRESS_CURVES.filter(({ column }) => columns[column].some(isNumber));
  return {
    label: "Normal and shear stress over the contact angle, exact and linearised",
    x: {
      values: columns.theta_rad.map(degrees),
      domain: [exit, entry],
      name: "θ",
      spoken: "angle",
      label: "angle θ from straight down, ° (exit to entry)",
      format: (value) => `${fixed(value, 1)}°`,
    },
    y: { unit: "kPa", format: (value) => withUnit(significant(value), "kPa") },
    curves: present.map(({ key, name, column }) => ({ key, name, values: scaled(columns[column], PASCAL_TO_KILOPASCAL) })),
    marks: marks.map(({ key, at, symbol }) => ({ key, at, label: `${symbol} ${fixed(at, 1)}°` })),
    basis,
    rest: maximum,
  };
}
