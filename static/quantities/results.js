// The results of the API: their names and units on the page.

import { significant, withUnit } from "../numbers/format.js";

/** @import { Method } from "../api/types.js" */

/**
 * @typedef {object} Quantity
 * @property {string} name
 * @property {string} unit
 * @property {number} factor takes SI to the unit
 */

/** @type {Record<string, Quantity>} */
export const QUANTITIES = {
  longitudinal_force_n: { name: "Drawbar pull", unit: "N", factor: 1 },
  normal_force_n: { name: "Normal force", unit: "N", factor: 1 },
  torque_n_m: { name: "Torque", unit: "N·m", factor: 1 },
  sinkage_m: { name: "Sinkage", unit: "mm", factor: 1e3 },
  slip: { name: "Slip", unit: "%", factor: 100 },
  drawbar_coefficient: { name: "Drawbar coefficient", unit: "", factor: 1 },
  tractive_efficiency: { name: "Tractive efficiency", unit: "%", factor: 100 },
  traction_n: { name: "Traction", unit: "N", factor: 1 },
  resistance_n: { name: "Resistance", unit: "N", factor: 1 },
  normal_support_n: { name: "Normal support", unit: "N", factor: 1 },
  shear_support_n: { name: "Shear support", unit: "N", factor: 1 },
  lateral_force_n: { name: "Lateral force", unit: "N", factor: 1 },
  lateral_coefficient: { name: "Lateral coefficient", unit: "", factor: 1 },
  overturning_moment_n_m: { name: "Overturning moment", unit: "N·m", factor: 1 },
  aligning_moment_n_m: { name: "Aligning moment", unit: "N·m", factor: 1 },
  sinkage_modulus: { name: "Sinkage modulus", unit: "kPa/mᴺ", factor: 1e-3 },
  granular_stiffness_n_m3: { name: "Granular stiffness", unit: "kN/m³", factor: 1e-3 },
  sinkage_exponent: { name: "Sinkage exponent", unit: "", factor: 1 },
  normal_load_n: { name: "Load", unit: "N", factor: 1 },
  rut_depth_m: { name: "Rut depth", unit: "mm", factor: 1e3 },
  x_m: { name: "Place", unit: "mm", factor: 1e3 },
  needed_pull_n: { name: "Pull needed", unit: "N", factor: 1 },
  energy_per_metre_j_m: { name: "Energy per metre", unit: "J/m", factor: 1 },
  power_w: { name: "Power", unit: "W", factor: 1 },
  largest_slope_rad: { name: "Largest slope", unit: "°", factor: 180 / Math.PI },
  gravity_m_s2: { name: "Gravity", unit: "m/s²", factor: 1 },
  shearing_radius_m: { name: "Shearing radius", unit: "mm", factor: 1e3 },
};

/** @type {Record<Method, string>} */
export const METHOD_NAMES = { quadrature: "Quadrature", linearised: "Linearised", explicit: "Explicit", resistive_force: "Resistive force" };

/**
 * The methods that are compared: those of the letter, and the chosen one where it is another, which asks other values of the soil.
 * @param {Method} chosen
 */
export function comparedWith(chosen) {
  /** @type {Method[]} */
  const letter = ["quadrature", "linearised", "explicit"];
  return letter.includes(chosen) ? letter : [...letter, chosen];
}

/**
 * The page's name of a method that the API names.
 * @param {string} method
 */
export const methodName = (method) => METHOD_NAMES[/** @type {Method} */ (method)];

/**
 * A result as text, or a dash where there is none.
 * @param {string} name
 * @param {number | null | undefined} value
 */
export function quantity(name, value) {
  if (value === null || value === undefined) return "–";
  const { unit, factor } = QUANTITIES[name];
  return withUnit(significant(value * factor), unit);
}
