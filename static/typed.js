// Numbers as people type them, and what to type instead of what is no number.

import { baseText } from "./fields.js";

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
const DECIMAL_COMMA = /^[+-]?(\d+,\d*|,\d+)(e[+-]?\d+)?$/i;
/** A comma before three digits stands for thousands here and for decimals there, so it is not guessed. */
const MAYBE_THOUSANDS = /^[+-]?[1-9]\d{0,2},\d{3}$/;
const THOUSANDS = /^[+-]?\d{1,3}(,\d{3})+(\.\d*)?$/;
const WITH_COMMA = /^[+-]?[\d.,]*\d[\d.,]*$/;

const trimmed = (text) => text.trim().replace("\u2212", "-");

/** A number in the notation of programs, or null where the text is none or could be two. */
export function plainNumber(text) {
  const plain = trimmed(text);
  if (NUMBER.test(plain)) return plain;
  return DECIMAL_COMMA.test(plain) && !MAYBE_THOUSANDS.test(plain) ? plain.replace(",", ".") : null;
}

/** What the field takes of the text: a number in the notation of programs, the field's word, or null. */
export function taken(field, text) {
  if (field.word && trimmed(text).toLowerCase() === field.word) return field.word;
  const plain = plainNumber(text);
  return plain !== null && Number.isFinite(field.unit.toSi(plain)) ? plain : null;
}

/** The SI value of typed text, the field's word if it takes one, or null if it is neither. */
export function siFromText(field, text) {
  const plain = taken(field, text);
  return plain === null || plain === field.word ? plain : field.unit.toSi(plain);
}

/** What to type instead of a text that is no number. */
export function typingAdvice(field, text, context) {
  const plain = trimmed(text);
  const whole = plain.replaceAll(",", "");
  if (MAYBE_THOUSANDS.test(plain)) return `A comma can mean two things: type ${whole} or ${plain.replace(",", ".")}.`;
  if (THOUSANDS.test(plain)) return `Type the number without commas between thousands: ${whole}.`;
  if (plain.includes(",") && WITH_COMMA.test(plain)) return "Type the number with one decimal sign and nothing between thousands.";
  const alternative = field.word ? ` or “${field.word}”` : "";
  const usual = baseText(field, context);
  return `Type a number${alternative}${usual ? `, such as ${usual}` : ""}.`;
}
