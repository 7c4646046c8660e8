// Numbers as people and instruments write them.

export const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;
export const WITH_DECIMAL_COMMA = /^[+-]?(\d+,\d*|,\d+)(e[+-]?\d+)?$/i;
/** A comma before three digits may stand for thousands or for decimals, so it is not guessed. */
export const MAYBE_THOUSANDS = /^[+-]?[1-9]\d{0,2},\d{3}$/;

/**
 * The text with a minus sign that programs read.
 * @param {string} text
 */
export const withPlainMinus = (text) => text.replace("\u2212", "-");

/**
 * A number in the notation of programs, or null where the text is none or could be two.
 * @param {string} text
 */
export function plainNumber(text) {
  const plain = withPlainMinus(text.trim());
  if (NUMBER.test(plain)) return plain;
  return WITH_DECIMAL_COMMA.test(plain) && !MAYBE_THOUSANDS.test(plain) ? plain.replace(",", ".") : null;
}
