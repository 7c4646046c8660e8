// Numbers and names of the API as the page has them.

import { MEASURED } from "../quantities/measured.js";
import { PARAMETERS } from "../quantities/parameters.js";
import { beforeUnit } from "../quantities/units.js";

/** @import { Unit } from "../quantities/units.js" */

/**
 * Names of the API that are none of a parameter or of a quantity in the table of measurements.
 * @type {Record<string, string>}
 */
const OTHER_NAMES = { normal_load_n: "normal force" };

/** @param {string[]} words */
export const listed = (words) => (words.length > 1 ? `${words.slice(0, -1).join(", ")} and ${words[words.length - 1]}` : words.join(""));

/**
 * A value of the API (SI) in a unit of the page.
 * @param {number} value
 * @param {Unit} unit
 * @param {number} digits
 */
export const inUnit = (value, unit, digits) => beforeUnit(String(Number(unit.fromSi(value).toPrecision(digits))), unit);

/**
 * The page's name of a parameter or a measured quantity, to stand within a sentence; the API's, to be shown as code, where the page
 * has none.
 * @param {string} name
 */
export const nameOf = (name) => PARAMETERS[name]?.field.label.toLowerCase() ?? MEASURED[name]?.label.toLowerCase() ?? OTHER_NAMES[name] ?? `\`${name}\``;

/** @param {string[]} names */
export const namesOf = (names) => listed(names.map((name) => `the ${nameOf(name)}`));
