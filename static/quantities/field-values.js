// Values of fields as texts in their boxes, and back.

import { MAYBE_THOUSANDS, plainNumber, withPlainMinus } from "../numbers/plain.js";
import { roundedUp } from "../numbers/steps.js";
import { PERCENT } from "./units.js";

/** @import { Field, Preset, SliderRange } from "./fields.js" */

const SHOWN_DIGITS = 6;
const THOUSANDS = /^[+-]?\d{1,3}(,\d{3})+(\.\d*)?$/;
const WITH_COMMA = /^[+-]?[\d.,]*\d[\d.,]*$/;

/**
 * A value of the API as a text for the box.
 * @param {Field} field
 * @param {number} value
 */
export const fieldText = (field, value) => String(Number(field.unit.fromSi(value).toPrecision(SHOWN_DIGITS)));

/**
 * What the box shows while the field follows its preset.
 * @param {Field} field
 * @param {Preset} preset
 */
export function baseText(field, preset) {
  const base = field.base(preset);
  return base === undefined || base === null ? "" : fieldText(field, base);
}

/**
 * The range of a slider, widened where the preset's own value lies beyond it.
 * @param {SliderRange} range
 * @param {string} usual text of the preset's value
 * @returns {SliderRange}
 */
export function widened({ min, max, step }, usual) {
  const base = Number(usual);
  return { min, max: base > max ? roundedUp(2 * base) : max, step };
}

/**
 * What the field takes of a text: a number in the notation of programs, the field's word, or null.
 * @param {Field} field
 * @param {string} text
 */
export function taken(field, text) {
  if (field.word && withPlainMinus(text.trim()).toLowerCase() === field.word) return field.word;
  const plain = plainNumber(text);
  return plain !== null && Number.isFinite(field.unit.toSi(plain)) ? plain : null;
}

/**
 * The SI value of a text, the field's word where it takes one, or null where the text is neither.
 * @param {Field} field
 * @param {string} text
 */
export function siFromText(field, text) {
  const plain = taken(field, text);
  if (plain === null) return null;
  return field.word && plain === field.word ? field.word : field.unit.toSi(plain);
}

/**
 * The number (SI) in the field, or null where there is none.
 * @param {Field} field
 * @param {string | null} text as typed, null while the field follows its preset
 * @param {Preset} preset
 */
export function numberIn(field, text, preset) {
  const value = text === null ? field.base(preset) : siFromText(field, text);
  return typeof value === "number" ? value : null;
}

/**
 * A ratio may have been typed where a percentage is asked for: the percentage that it would be, or null where the text is none.
 * @param {Field} field
 * @param {string | null} text as typed
 */
export function percentageMeant({ unit }, text) {
  const plain = unit === PERCENT && text !== null ? plainNumber(text) : null;
  const value = plain === null ? 0 : Math.abs(Number(plain));
  return plain !== null && value > 0 && value < 1 ? String(Number(PERCENT.fromSi(Number(plain)).toPrecision(SHOWN_DIGITS))) : null;
}

/**
 * What to type instead of a text that is no number.
 * @param {Field} field
 * @param {string} text
 * @param {Preset} preset
 */
export function typingAdvice(field, text, preset) {
  const plain = withPlainMinus(text.trim());
  const whole = plain.replaceAll(",", "");
  if (MAYBE_THOUSANDS.test(plain)) return `A comma can mean two things: type ${whole} or ${plain.replace(",", ".")}.`;
  if (THOUSANDS.test(plain)) return `Type the number without commas between thousands: ${whole}.`;
  if (plain.includes(",") && WITH_COMMA.test(plain)) return "Type the number with one decimal sign and nothing between thousands.";
  const alternative = field.word ? ` or “${field.word}”` : "";
  const usual = baseText(field, preset);
  return `Type a number${alternative}${usual ? `, such as ${usual}` : ""}.`;
}
