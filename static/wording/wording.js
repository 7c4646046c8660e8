// The words for warnings and faults of the API. They are made from its data; where it gives none, from its sentence.

import { fixed } from "../numbers/format.js";
import { fieldAt } from "../quantities/fields.js";
import { fieldOf, valueText } from "../quantities/parameters.js";
import { METHOD_NAMES } from "../quantities/results.js";
import * as sentences from "./sentences.js";

/** @import { FieldFault, Method, Warning } from "../api/types.js" */
/** @import { Field } from "../quantities/fields.js" */
/** @import { Unit } from "../quantities/units.js" */

/**
 * A fault with the range that the value left, all in the API's unit of the field.
 * @typedef {FieldFault & { value?: number, minimum?: number, maximum?: number }} Fault
 */

/** @typedef {{ value: number, minimum: number, maximum: number }} LeftRange */

/**
 * A warning in words. `gist` is the same for warnings that say the same of a point and of a curve.
 * @typedef {object} WarningWords
 * @property {string} code
 * @property {string} text
 * @property {string} gist
 * @property {Method[]} methods those it names
 */

/**
 * @param {Fault} fault
 * @param {string} demand
 * @returns {LeftRange | null}
 */
const leftRange = ({ value, minimum, maximum }, demand) =>
  (value !== undefined && minimum !== undefined && maximum !== undefined ? { value, minimum, maximum } : sentences.rangeIn(demand));

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
 * A warning about a single result.
 * @param {Warning} warning
 * @returns {WarningWords}
 */
export function resultWarning({ code, detail }) {
  const text = sentences.inPageUnits(detail);
  return { code, text, gist: `${code} ${text}`, methods: [] };
}

/** @param {number} slip */
const slipText = (slip) => `${fixed(slip * 100, 0)}\u00a0%`;

/** @param {string} pointer */
const labelAt = (pointer) => fieldAt(pointer)?.label.toLowerCase() ?? pointer;

/**
 * A warning about points of a sweep. They are told by their slips, as the charts have no rows, and fields by their labels.
 * @param {Warning} warning
 * @param {readonly number[]} slips of the rows
 * @returns {WarningWords}
 */
export function sweepWarning({ code, detail }, slips) {
  const { series, rest } = sentences.seriesIn(detail, METHOD_NAMES);
  const told = sentences.inPageUnits(rest);
  const atSlips = sentences.withRows(told, (rows) => `at slip ${sentences.eachRow(rows, (row) => slipText(slips[row])).replaceAll("–", " to ")}`);
  const text = sentences.withFirstRow(atSlips, (slip, pointer) => `at ${slipText(slip)}, ${labelAt(pointer)}`);
  return { code, text, gist: `${code} ${sentences.withoutRows(told)}`, methods: /** @type {Method[]} */ (series) };
}

/**
 * A warning about samples of a track. They are told by their lines of the file.
 * @param {Warning} warning
 * @param {readonly number[]} lines of the rows
 */
export function trackWarning({ detail }, lines) {
  const told = sentences.inPageUnits(detail).replace("give `normal_load_n`", "choose “Normal load” at the operating point");
  return sentences.named(sentences.withRows(told, (rows) =>
    `at ${sentences.areSeveral(rows) ? "lines" : "line"} ${sentences.eachRow(rows, (row) => String(lines[row]))} of the file`));
}

/**
 * A warning about a fit. What the API calls a field of its answer is a column of the page's table.
 * @param {Warning} warning
 * @param {string} law of pressure and sinkage
 */
export function fitWarning({ detail }, law) {
  const withBound = sentences.withBound(detail, (parameter, bound) => valueText(fieldOf(parameter, law), bound));
  return sentences.named(sentences.inPageUnits(withBound).replace("see each one's `identifiability`", "the table says why of each"));
}

/**
 * What is known of an estimate.
 * @param {string} identifiability
 * @param {Field} field
 */
export const identifiabilityText = (identifiability, field) =>
  sentences.named(sentences.withOwnNumbers(identifiability, (value) => valueText(field, value)));

/**
 * A warning about predictions, with the names that the charts give the series.
 * @param {Warning} warning
 * @param {Record<string, string>} names of the series
 */
export function predictionWarning({ detail }, names) {
  const { series, rest } = sentences.seriesIn(detail, names);
  return series.length ? `${series.map((name) => names[name]).join("; ")}: ${rest}` : detail;
}
