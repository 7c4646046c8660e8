// What the columns of a table are, guessed by name and unit.

import { MEASURED } from "../quantities/measured.js";

/** @import { Unit } from "../quantities/units.js" */
/** @import { TableColumn } from "./parse.js" */

/** @typedef {{ quantity: string, unit: Unit }} Mapped what a column is, by the API's name, and the unit of its numbers */
/** @typedef {(Mapped | null)[]} Mapping */

/** Beyond these, a number without a unit is no ratio, and no sinkage in metres of a rover's wheel. */
const LARGEST_RATIO = 1.5;
const LARGEST_SINKAGE_M = 1;

/**
 * Units that a name brings along.
 * @type {Record<string, string>}
 */
const UNIT_OF_NAME = { rpm: "rpm", drehzahl: "rpm" };

/**
 * How else units are written, in lower case.
 * @type {Record<string, string>}
 */
const UNIT_WORDS = {
  "1": "–", "-": "–", percent: "%", pct: "%", nm: "N·m", n_m: "N·m", "n*m": "N·m", "n.m": "N·m", "n m": "N·m", "n-m": "N·m", nmm: "N·mm", n_mm: "N·mm", knm: "kN·m",
  m_s: "m/s", cm_s: "cm/s", mm_s: "mm/s", "m s-1": "m/s", rad_s: "rad/s", "rad s-1": "rad/s", "1/min": "rpm", "u/min": "rpm", "deg/s": "°/s", deg_s: "°/s",
  sec: "s", seconds: "s", minutes: "min",
};
const UNITS = new Map(Object.values(MEASURED).flatMap(({ units }) => units.map(({ text }) => [text.toLowerCase(), text])));

/** @param {string} text */
function unitWord(text) {
  const word = text.replace(/[[\](){}]/g, "").trim().toLowerCase();
  return UNIT_WORDS[word] ?? UNITS.get(word) ?? word;
}
/** @param {string} text */
const isUnit = (text) => [...UNITS.values()].includes(unitWord(text));

/**
 * "Fx [N]", "z (mm)", "slip / %", "Slip %" and "v m/s" as a name and a unit.
 * @param {string} heading
 * @param {string} unitOfRow
 */
function split(heading, unitOfRow) {
  const [, name, bracketed] = /^(.*?)[\s/_]*[[({]([^\])}]*)[\])}]$/.exec(heading) ?? [];
  if (name) return { name, unit: unitWord(bracketed) };
  for (const { index, 0: gap } of heading.matchAll(/[\s/]+/g)) {
    const rest = heading.slice(index + gap.length);
    if (index && isUnit(rest)) return { name: heading.slice(0, index), unit: unitWord(rest) };
  }
  return { name: heading, unit: unitWord(unitOfRow) };
}

const UNIT_SUFFIX = /^(.+?)_(m|cm|mm|n|kn|n_m|nm|n_mm|nmm|pct|percent|%|s|ms|min|sec|m_s|cm_s|mm_s|rad_s|deg_s|rpm)$/i;

/**
 * A word of a heading as the names have it.
 * @param {string} text
 */
function normal(text) {
  const word = text.trim().replace(/[\s.-]+/g, "_");
  return word.length === 1 ? word : word.toLowerCase();
}

/** @param {string} word */
const quantitiesOf = (word) => Object.keys(MEASURED).filter((key) => MEASURED[key].names.includes(word));

/**
 * The unit of a column that names none.
 * @param {string} quantity
 * @param {string} name
 * @param {(string | null)[]} texts
 */
function usualUnit(quantity, name, texts) {
  const { units } = MEASURED[quantity];
  const largest = texts.reduce((most, text) => Math.max(most, Math.abs(Number(text))), 0);
  if (quantity === "slip" && largest > LARGEST_RATIO) return units[1];
  if (quantity === "sinkage_m" && largest > LARGEST_SINKAGE_M) return units[2];
  return units.find(({ text }) => text === UNIT_OF_NAME[name]) ?? units[0];
}

/**
 * The quantities that a heading may name, and the unit it gives, if any.
 * @param {string} heading
 * @param {string} unitOfRow
 */
function readHeading(heading, unitOfRow) {
  const { name: text, unit } = split(heading, unitOfRow);
  const name = normal(text);
  const quantities = quantitiesOf(name);
  const [, stem, suffix] = UNIT_SUFFIX.exec(heading.replace(/[\s.-]+/g, "_")) ?? [];
  if (quantities.length || !stem) return { name, quantities, unit };
  return { name, quantities: quantitiesOf(normal(stem)), unit: unit || unitWord(suffix) };
}

/**
 * @param {TableColumn} column
 * @returns {Mapped | null}
 */
function guess({ heading, unit: unitOfRow, texts }) {
  const { name, quantities, unit } = readHeading(heading.trim(), unitOfRow);
  if (!unit) return quantities.length === 1 ? { quantity: quantities[0], unit: usualUnit(quantities[0], name, texts) } : null;
  // A unit that the quantity cannot have makes it another quantity. A name that two quantities have says nothing without one.
  const possible = quantities.flatMap((quantity) => {
    const found = MEASURED[quantity].units.find(({ text }) => text === unit);
    return found ? [{ quantity, unit: found }] : [];
  });
  return possible.length === 1 ? possible[0] : null;
}

/**
 * A quantity goes to the first column that may be it.
 * @param {TableColumn[]} columns
 * @returns {Mapping}
 */
export function guessColumns(columns) {
  const taken = new Set();
  return columns.map((column) => {
    const found = guess(column);
    if (!found || taken.has(found.quantity)) return null;
    taken.add(found.quantity);
    return found;
  });
}

/**
 * As the value of an option.
 * @param {Mapped | null} mapped
 */
export const choiceOf = (mapped) => (mapped ? `${mapped.quantity} ${mapped.unit.text}` : "");

/**
 * @param {string} value
 * @returns {Mapped | null}
 */
export function choiceFrom(value) {
  const [quantity, text] = value.split(" ");
  const unit = quantity && MEASURED[quantity].units.find((each) => each.text === text);
  return unit ? { quantity, unit } : null;
}
