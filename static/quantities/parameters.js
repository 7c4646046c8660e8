// The soil parameters that can be found from measurements, by the API's names.

import { significant } from "../numbers/format.js";
import { fieldNamed } from "./fields.js";
import { beforeUnit } from "./units.js";

/** @import { FitParameter } from "../api/types.js" */
/** @import { Field } from "./fields.js" */

const SHOWN_DIGITS = 4;

/**
 * Each with the field that has its name and unit; the usual ones are ticked from the start.
 * @type {Record<string, { field: Field, usual?: boolean }>}
 */
export const PARAMETERS = {
  friction_angle_rad: { field: fieldNamed("friction_angle"), usual: true },
  cohesion_pa: { field: fieldNamed("cohesion") },
  shear_modulus_m: { field: fieldNamed("shear_modulus"), usual: true },
  k_s: { field: fieldNamed("k_s"), usual: true },
  n0: { field: fieldNamed("n0"), usual: true },
  n1: { field: fieldNamed("n1") },
  k_c: { field: fieldNamed("bekker_k_c") },
  k_phi: { field: fieldNamed("bekker_k_phi") },
  c1: { field: fieldNamed("c1") },
  c2: { field: fieldNamed("c2") },
};
/** @type {Record<string, Field>} */
const REECE = { k_c: fieldNamed("reece_k_c"), k_phi: fieldNamed("reece_k_phi") };
const LAWS_WITH_MODULI = ["bekker", "reece"];

/**
 * The moduli have the same names under the laws of Bekker and Reece, but other units.
 * @param {string} parameter
 * @param {string} law
 */
export const fieldOf = (parameter, law) => (law === "reece" && REECE[parameter]) || PARAMETERS[parameter].field;

/**
 * A value of the API (SI) as text in the field's unit.
 * @param {Field} field
 * @param {number} value
 */
export const valueText = ({ unit }, value) => beforeUnit(significant(unit.fromSi(value), SHOWN_DIGITS), unit);

/**
 * Why the parameters do not go together with the law on the page, and what to do; null where they do.
 * @param {FitParameter[]} fit
 * @param {string} law
 */
export function mismatch(fit, law) {
  const moduli = fit.filter((name) => name in REECE).map((name) => `the ${PARAMETERS[name].field.label.toLowerCase()}`);
  if (moduli.length && fit.includes("k_s")) return `Untick the sinkage modulus K_s, or ${moduli.join(" and ")}: no law has them all.`;
  if (moduli.length && !LAWS_WITH_MODULI.includes(law)) {
    return `Untick ${moduli.join(" and ")}, or choose the law Bekker or Reece under “Pressure and sinkage”: the law of this page does not have them.`;
  }
  return null;
}
