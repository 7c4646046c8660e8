// The sentences of faults and estimates, read for what the API does not give as data, and put into the units and names of the page.
// Only its folder knows this file.

import { MEASURED } from "../quantities/measured.js";
import { PARAMETERS } from "../quantities/parameters.js";
import { DEGREE, KILOPASCAL, MILLIMETRE, MODULUS, beforeUnit } from "../quantities/units.js";

/** @import { Unit } from "../quantities/units.js" */

const SHOWN_DIGITS = 6;
const NUMBER = String.raw`(?<![\p{L}\p{N}_.^])[-−]?\d+(?:\.\d+)?(?:e[+-]?\d+)?`;
const BARE_NUMBER = new RegExp(`${NUMBER}(?![\\p{L}\\p{N}_])`, "gu");

/**
 * The units of the API's sentences that the page does not show.
 * @type {Record<string, Unit>}
 */
const UNITS = { rad: DEGREE, "Pa/m^N": MODULUS, Pa: KILOPASCAL, m: MILLIMETRE };
const WITH_UNIT = new RegExp(`(${NUMBER}) (rad|Pa/m\\^N|Pa|m)(?![\\p{L}\\p{N}/^·])`, "gu");

/**
 * A value of the API (SI) in a unit of the page.
 * @param {number} value
 * @param {Unit} unit
 */
export const inUnit = (value, unit) => beforeUnit(String(Number(unit.fromSi(value).toPrecision(SHOWN_DIGITS))), unit);

/** @param {string} text */
const numberOf = (text) => Number(text.replace("−", "-"));

/**
 * Rewrites what stands outside backticks: quoted names stay as they are.
 * @param {string} text
 * @param {(part: string) => string} rewrite
 */
const outsideQuotes = (text, rewrite) => text.split(/(`[^`]*`)/).map((part) => (part.startsWith("`") ? part : rewrite(part))).join("");

/**
 * The sentence with its lengths, pressures, moduli and angles in the units of the page.
 * @param {string} detail
 */
export const inPageUnits = (detail) =>
  outsideQuotes(detail, (part) => part.replace(WITH_UNIT, (_, number, unit) => inUnit(numberOf(number), UNITS[unit])));

/**
 * The sentence with its bare numbers, which are those of one field, in the unit of that field.
 * @param {string} detail
 * @param {Unit} unit
 */
export const inFieldUnit = (detail, unit) => outsideQuotes(detail, (part) => part.replace(BARE_NUMBER, (number) => inUnit(numberOf(number), unit)));

/** @param {string} detail */
export const hasNumber = (detail) => detail.replace(/`[^`]*`/g, "``").search(BARE_NUMBER) >= 0;

/**
 * The demand at the head of a fault, without the advice behind it, which speaks of the API's unit; null where the fault begins otherwise.
 * @param {string} detail
 */
export const demandIn = (detail) => (/^must\b/.test(detail) ? detail.split("; ")[0] : null);

/** @param {string} detail */
export const isDemand = (detail) => /\bmust\b/.test(detail);

/**
 * Whether the sentence begins with a verb, and so reads on from the name of a field.
 * @param {string} text
 */
export const beginsWithVerb = (text) => /^(is|are|must|has|have|needs?|does|cannot|lies) /.test(text);

const RANGE = new RegExp(`^must be from (${NUMBER}) to (${NUMBER}), not (${NUMBER})$`, "u");

/**
 * The range that a fault states, and the value that left it (SI).
 * @param {string} demand
 */
export function rangeIn(demand) {
  const found = RANGE.exec(demand);
  if (!found) return null;
  const [minimum, maximum, value] = found.slice(1).map(numberOf);
  return { minimum, maximum, value };
}

const FOUND_NUMBER = String.raw`-?\d+(?:\.\d+)?(?:e[+-]?\d+)?`;
const HALF_WIDTH = new RegExp(`(?<=± |, by )${FOUND_NUMBER}(?= \\()`);
const OTHER_VALUE = new RegExp(`(?<=: )${FOUND_NUMBER}(?= explains)`);

/**
 * What is known of an estimate, with its numbers (SI) replaced. The interval of one that is determined has a column of its own.
 * @param {string} identifiability
 * @param {(value: number) => string} replaced
 */
export const withOwnNumbers = (identifiability, replaced) => identifiability.replace(/^determined to ± \S+ \(95 %\)$/, "determined")
  .replace(HALF_WIDTH, (number) => replaced(Number(number)))
  .replace(OTHER_VALUE, (number) => replaced(Number(number)));

/**
 * The sentence with the API's names of parameters and measured quantities as the page has them.
 * @param {string} text
 */
export const named = (text) =>
  text.replace(/\b[a-z]\w*\b/g, (word) => PARAMETERS[word]?.field.label.toLowerCase() ?? MEASURED[word]?.label.toLowerCase() ?? word);
