// The words for faults of the API. Where a fault comes with the range that a number left, they are made of that range; else they are
// the API's own.

import { fieldAt } from "../quantities/fields.js";
import { MILLIMETRE, pageUnit } from "../quantities/units.js";
import { inUnit } from "./values.js";

/** @import { FieldFault } from "../api/types.js" */
/** @import { Field } from "../quantities/fields.js" */
/** @import { Unit } from "../quantities/units.js" */

/** @typedef {FieldFault} Fault */

/**
 * What a number has to be, in words.
 * @typedef {object} Demand
 * @property {string} words
 * @property {boolean} isMet
 */

const SHOWN_DIGITS = 6;

/**
 * A unit with an exponent comes in the braces of an annotation of UCUM.
 * @param {string} code
 */
const unitOfCode = (code) => pageUnit(code.startsWith("{") ? code.slice(1, -1) : code);

/**
 * @param {Fault} fault
 * @param {Unit} unit
 * @returns {Demand | null}
 */
function demandOf({ value, minimum, maximum, exclusive_maximum: limit, maximum_from: source }, unit) {
  if (value === undefined) return null;
  /** @param {number} bound */
  const text = (bound) => inUnit(bound, unit, SHOWN_DIGITS);
  const label = source === undefined ? undefined : fieldAt(source)?.label;
  const from = label ? ` (“${label}”)` : "";
  const isMet = value >= (minimum ?? -Infinity) && value <= (maximum ?? Infinity) && value < (limit ?? Infinity);
  if (minimum !== undefined && maximum !== undefined) return { words: `from ${text(minimum)} to ${text(maximum)}${from}`, isMet };
  const ends = [
    ...(minimum === undefined ? [] : [`at least ${text(minimum)}`]),
    ...(maximum === undefined ? [] : [`at most ${text(maximum)}${from}`]),
    ...(limit === undefined ? [] : [`less than ${text(limit)}`]),
  ];
  return ends.length ? { words: ends.join(" and "), isMet } : null;
}

/**
 * Metres may have been typed where millimetres are asked for.
 * @param {Fault} fault
 * @param {Unit} unit
 */
function hintAt({ value = 0, minimum = Infinity, maximum = -Infinity }, unit) {
  const metres = unit.fromSi(value);
  return unit === MILLIMETRE && metres >= minimum && metres <= maximum ? `; ${metres}\u00a0m are ${inUnit(metres, unit, SHOWN_DIGITS)}` : "";
}

/**
 * What is wrong with a value: at its field, in the unit that the field shows; away from a field, in the page's unit for that of the API.
 * @param {Fault} fault
 * @param {Field} [field]
 */
export function faultText(fault, field) {
  const unit = field?.unit ?? (fault.unit === undefined ? undefined : unitOfCode(fault.unit));
  const demand = unit ? demandOf(fault, unit) : null;
  // A number within its range is wrong for a reason that is in the sentence alone.
  if (!unit || !demand || demand.isMet || fault.value === undefined) return fault.detail;
  return `must be ${demand.words}, not ${inUnit(fault.value, unit, SHOWN_DIGITS)}${field ? hintAt(fault, unit) : ""}`;
}

/**
 * A fault of a search or a track, which is told away from its field.
 * @param {Fault} fault
 * @param {string | null} subject
 */
export const faultSentence = (fault, subject) => about(subject, faultText(fault, fieldAt(fault.pointer)));

/**
 * A text behind what it is about.
 * @param {string | null} subject
 * @param {string} text
 */
export const about = (subject, text) => (subject ? `${subject}: ${text}` : text);
