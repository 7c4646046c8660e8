// What is known of an estimate, in words with the units and names of the page.

import { valueText } from "../quantities/parameters.js";
import { namesOf } from "./values.js";

/** @import { ParameterEstimate } from "../api/types.js" */
/** @import { Field } from "../quantities/fields.js" */

/**
 * What the data do not vary, by the code of the warning that says so.
 * @type {Record<string, string>}
 */
export const GAPS = {
  single_slip: "all samples have one slip",
  single_load: "all samples have one load, measured or, where it was not, predicted by the model",
  few_points: "the samples repeat too few operating points to determine that many parameters",
  normal_force_only: "only the normal force is fitted, to which the shear stress adds little",
};

/**
 * @param {ParameterEstimate} estimate
 * @param {Field} field
 */
function uncertainText({ standard_error: error, known: { half_width: width } }, field) {
  if (width !== undefined) return `±\u00a0${valueText(field, width)} (95\u00a0%) is too wide to be of use`;
  return error === null ? "there are too few data to state an error" : "its interval is too wide to be written as a number";
}

/**
 * @param {ParameterEstimate} estimate
 * @param {Field} field
 */
function oneSidedText({ interval_95: interval, known: { end } }, field) {
  const bound = interval?.[end === "upper" ? 1 : 0];
  return `the data bound it only from ${end === "upper" ? "above" : "below"}${bound === undefined ? "" : `, by ${valueText(field, bound)} (95\u00a0%)`}`;
}

/**
 * Whether the data determine a parameter, and if not, why. The interval of one that is determined has a column of its own.
 * @param {ParameterEstimate} estimate
 * @param {Field} field
 */
export function identifiabilityText(estimate, field) {
  const { identifiability, known: { code, end, tied_to: others = [], gap = "", other } } = estimate;
  switch (code) {
    case "determined": return "determined";
    case "at_bound": return `at its ${end} bound, which decides the value: the data may call for a value beyond it`;
    case "without_effect": return "not determined: the data do not change with it";
    case "inseparable": return `not determined: it can change together with ${namesOf(others)} and the data stay the same`;
    case "unseparated":
      if (!GAPS[gap]) return identifiability;
      return others.length ? `not determined by data of this kind: ${GAPS[gap]}, so it cannot be told from ${namesOf(others)}` : `not determined: ${GAPS[gap]}`;
    case "several_solutions":
      return other === undefined ? identifiability : `not determined: ${valueText(field, other)} explains the data as well, found from another start`;
    case "one_sided": return `not determined: ${oneSidedText(estimate, field)}`;
    case "uncertain": return `not determined: ${uncertainText(estimate, field)}`;
    // A finding that the page does not know yet.
    default: return identifiability;
  }
}
