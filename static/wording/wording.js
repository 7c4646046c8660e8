// The words for faults of the API and for its estimates. They are made from its data; where it gives none, from its sentence.

import { valueText } from "../quantities/parameters.js";
import * as sentences from "./sentences.js";

/** @import { FieldFault } from "../api/types.js" */
/** @import { Field } from "../quantities/fields.js" */
/** @import { Unit } from "../quantities/units.js" */

/**
 * A fault with the range that the value left, all in the API's unit of the field.
 * @typedef {FieldFault & { value?: number, minimum?: number, maximum?: number }} Fault
 */

/** @typedef {{ value: number, minimum: number, maximum: number }} LeftRange */

/**
 * The range, where it is all that the sentence says: one that names what the bound follows from is told as it stands.
 * @param {Fault} fault
 * @param {string} demand
 * @returns {LeftRange | null}
 */
const leftRange = ({ value, minimum, maximum }, demand) =>
  (value !== undefined && minimum !== undefined && maximum !== undefined && demand.startsWith("must be ")
    ? { value, minimum, maximum }
    : sentences.rangeIn(demand));

/**
 * @param {LeftRange} range
 * @param {Unit} unit
 */
function rangeText({ value, minimum, maximum }, unit) {
  const [least, most, typed] = [minimum, maximum, value].map((each) => sentences.inUnit(each, unit));
  // Metres may have been typed where millimetres are asked for.
  const metres = unit.fromSi(value);
  const hint = unit.text === "mm" && metres >= minimum && metres <= maximum ? `; ${metres}\u00a0m are ${sentences.inUnit(metres, unit)}` : "";
  return `must be from ${least} to ${most}, not ${typed}${hint}`;
}

/**
 * What is wrong with a value: at its field, in the unit that the field shows.
 * @param {Fault} fault
 * @param {Field} [field]
 */
export function faultText(fault, field) {
  const unit = field?.unit;
  if (!unit?.si) return sentences.inPageUnits(fault.detail);
  const detail = sentences.demandIn(fault.detail) ?? fault.detail;
  const range = leftRange(fault, detail);
  if (range) return rangeText(range, unit);
  const text = sentences.inPageUnits(detail);
  if (text !== detail) return text;
  if (sentences.isDemand(detail)) return sentences.inFieldUnit(detail, unit);
  return sentences.hasNumber(detail) ? `${detail} (${unit.si})` : detail;
}

/**
 * A fault of a search or a track, which is told away from its field.
 * @param {Fault} fault
 * @param {string | null} subject
 */
export const faultSentence = (fault, subject) => about(subject, sentences.named(sentences.inPageUnits(fault.detail)));

/**
 * A text behind what it is about.
 * @param {string | null} subject
 * @param {string} text
 */
export const about = (subject, text) => (subject ? `${subject}${sentences.beginsWithVerb(text) ? "" : ":"} ${text}` : text);

/**
 * What is known of an estimate.
 * @param {string} identifiability
 * @param {Field} field
 */
export const identifiabilityText = (identifiability, field) =>
  sentences.named(sentences.withOwnNumbers(identifiability, (value) => valueText(field, value)));
