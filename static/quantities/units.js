// The units of the page, and how they convert to those of the API.

/**
 * @typedef {object} Unit
 * @property {string} text
 * @property {string} si how the API counts, in words; empty where it counts as the page does
 * @property {(plain: string) => number} toSi from a number in the notation of programs
 * @property {(value: number) => number} fromSi
 */

/**
 * A unit that differs from the API's by a power of ten. Shifting the decimal point in the text keeps 20 mm at exactly 0.02 in the
 * request; a division would not always.
 * @param {string} text
 * @param {number} exponent
 * @returns {Unit}
 */
export const power = (text, exponent, si = "") => ({
  text,
  si,
  toSi(plain) {
    const [mantissa, own = "0"] = plain.toLowerCase().split("e");
    return Number(`${mantissa}e${Number(own) + exponent}`);
  },
  fromSi: (value) => Number(value) * 10 ** -exponent,
});

/**
 * A unit that differs from the API's by any other factor.
 * @param {string} text
 * @param {number} toOne
 * @returns {Unit}
 */
export const factor = (text, toOne) => ({ text, si: "", toSi: (plain) => Number(plain) * toOne, fromSi: (value) => value / toOne });

export const ONE = power("", 0);
export const PERCENT = power("%", -2, "as a ratio");
export const NEWTON = power("N", 0);
export const NEWTON_METRE = power("N·m", 0);
export const MILLIMETRE = power("mm", -3, "in m");
export const KILOPASCAL = power("kPa", 3, "in Pa");
export const MODULUS = power("kPa/mᴺ", 3, "in Pa/mᴺ");
/** @type {Unit} */
export const DEGREE = {
  text: "°",
  si: "in rad",
  toSi: (plain) => (Number(plain) * Math.PI) / 180,
  fromSi: (value) => (value * 180) / Math.PI,
};

/** @type {Record<string, Unit>} */
const PAGE_UNITS = { m: MILLIMETRE, Pa: KILOPASCAL, rad: DEGREE, N: NEWTON, 1: ONE, "": ONE, "Pa/m^N": MODULUS, "N/m3": power("kN/m³", 3, "in N/m³"), "kg/m3": power("kg/m³", 0), "m/s2": power("m/s²", 0) };
/** @type {Record<string, string>} */
const RAISED = { n: "ⁿ", m: "ᵐ", N: "ᴺ", "+": "⁺", "-": "⁻", 1: "¹", 2: "²", 3: "³", "(": "", ")": "" };

/**
 * The unit in which the page shows what the API counts in `unit`. A modulus has an exponent in its unit, such as N/m^(n+2), and is
 * shown in a thousand of it.
 * @param {string} unit
 * @returns {Unit}
 */
export function pageUnit(unit) {
  const [, force, exponent] = /^(N|Pa)\/m\^(.+)$/.exec(unit) ?? [];
  if (unit in PAGE_UNITS || !force) return PAGE_UNITS[unit] ?? power(unit, 0);
  const raised = [...exponent].map((letter) => RAISED[letter] ?? letter).join("");
  return power(`k${force}/m${raised}`, 3, `in ${force}/m${raised}`);
}

/**
 * A number behind which its unit stands, as it is set in type.
 * @param {string} text
 * @param {Unit} unit
 */
export const beforeUnit = (text, unit) => (unit.text === "°" ? `${text}°` : unit.text ? `${text}\u00a0${unit.text}` : text);
