// The parameters that can be found from measurements, by the API's names: those that the tables of the service say.

import { model } from "../api/model.js";
import { significant } from "../numbers/format.js";
import { FIELDS } from "./fields.js";
import { LAW_FIELDS, PRESSURE_SINKAGE, lawsOf } from "./law-fields.js";
import { beforeUnit } from "./units.js";

/** @import { FitParameter } from "../api/types.js" */
/** @import { Field } from "./fields.js" */

const SHOWN_DIGITS = 4;
/** Ticked from the start. */
const USUAL = ["friction_angle_rad", "shear_modulus_m", "k_s", "n0"];

/** The fields of what is no law's. */
const OTHERS = model().parameters.filter(({ fittable }) => fittable).flatMap(({ name, pointer }) =>
  FIELDS.filter((field) => field.pointer === pointer).map((field) => ({ api: name, field })));

const FITTABLE = [...OTHERS, ...LAW_FIELDS.filter(({ fittable }) => fittable).map((field) => ({ api: field.api, field }))];

/**
 * Each with its field, that of the first law that has it.
 * @type {Record<string, { field: Field, usual?: boolean }>}
 */
export const PARAMETERS = Object.fromEntries(FITTABLE.filter(({ api }, index) => FITTABLE.findIndex((each) => each.api === api) === index)
  .map(({ api, field }) => [api, { field, usual: USUAL.includes(api) }]));

/**
 * The field of a parameter under a law. Moduli have the same names under the laws of Bekker and Reece, but other units.
 * @param {string} parameter
 * @param {string} law
 */
export const fieldOf = (parameter, law) =>
  LAW_FIELDS.find(({ api, family, laws }) => api === parameter && family === PRESSURE_SINKAGE && laws.includes(law)) ?? PARAMETERS[parameter].field;

/**
 * A value of the API (SI) as text in the field's unit.
 * @param {Field} field
 * @param {number} value
 */
export const valueText = ({ unit }, value) => beforeUnit(significant(unit.fromSi(value), SHOWN_DIGITS), unit);

/**
 * The pressure–sinkage laws that have a parameter, or none where it is no parameter of such a law.
 * @param {string} parameter
 */
const having = (parameter) =>
  lawsOf(PRESSURE_SINKAGE).filter(({ parameters }) => parameters.some(({ name, fittable }) => fittable && name === parameter)).map(({ name }) => name);

/** @param {string} name */
const inWords = (name) => `the ${PARAMETERS[name].field.label.toLowerCase()}`;

/** @param {string} law */
const capital = (law) => law.charAt(0).toUpperCase() + law.slice(1).replaceAll("_", " ");

/**
 * Why the parameters do not go together with the law on the page, and what to do; null where they do. To fit K_s, the direct law takes
 * the place of any other.
 * @param {FitParameter[]} fit
 * @param {string} law
 */
export function mismatch(fit, law) {
  const wanted = fit.includes("k_s") ? "direct" : law;
  const foreign = fit.filter((name) => having(name).length && !having(name).includes(wanted));
  if (!foreign.length) return null;
  const moduli = foreign.map(inWords).join(" and ");
  if (fit.includes("k_s")) return `Untick the sinkage modulus K_s, or ${moduli}: no law has them all.`;
  const laws = having(foreign[0]).map(capital).join(" or ");
  return `Untick ${moduli}, or choose the law ${laws} under “Pressure and sinkage”: the law of this page does not have ${foreign.length === 1 ? "it" : "them"}.`;
}
