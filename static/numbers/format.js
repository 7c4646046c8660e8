// Numbers as people read them.

const MINUS = "\u2212";
const THIN = "\u202f";
const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** @param {number} radians */
export const degrees = (radians) => (radians * 180) / Math.PI;

/**
 * A decimal with a true minus sign and, from five digits on, thin spaces between thousands.
 * @param {string} plain
 */
function typeset(plain) {
  const [, sign, whole, fraction = ""] = /^(-?)(\d+)(\.\d+)?$/.exec(plain) ?? ["", "", plain];
  const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, THIN) : whole;
  const isZero = !/[1-9]/.test(plain);
  return (sign && !isZero ? MINUS : "") + grouped + fraction;
}

/**
 * @param {number} value
 * @param {number} decimals
 */
export const fixed = (value, decimals) => typeset(value.toFixed(decimals));

/** @param {number} exponent */
function powerOfTen(exponent) {
  const digits = String(Math.abs(exponent)).replace(/\d/g, (digit) => SUPERSCRIPTS[Number(digit)]);
  return `10${exponent < 0 ? "⁻" : ""}${digits}`;
}

/**
 * At least `digits` significant digits. Whole numbers keep all of theirs; extremes go to powers of ten.
 * @param {number} value
 */
export function significant(value, digits = 3) {
  if (value === 0) return "0";
  const magnitude = Math.floor(Math.log10(Math.abs(value)));
  if (magnitude >= -4 && magnitude <= 5) return fixed(value, Math.max(0, digits - 1 - magnitude));
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  return `${typeset(mantissa)}×${powerOfTen(Number(exponent))}`;
}

/**
 * @param {string} text
 * @param {string} unit
 */
export const withUnit = (text, unit) => (unit ? `${text}\u00a0${unit}` : text);

/** @param {number} value */
export const percent = (value) => withUnit(fixed(value, 1), "%");

/** @param {number} value */
export const seconds = (value) => withUnit(significant(value, 4), "s");

/** @param {string} text */
export const capitalised = (text) => text.charAt(0).toUpperCase() + text.slice(1);
