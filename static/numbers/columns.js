// Columns of numbers, with null where there is none.

/** @typedef {number | null} Cell */
/** @typedef {{ readonly [name: string]: readonly Cell[] | undefined }} Columns */

/**
 * @param {Cell | undefined} value
 * @returns {value is number}
 */
export const isNumber = (value) => value !== null && value !== undefined;

/**
 * A column that must be there.
 * @param {Columns} columns
 * @param {string} name
 */
export function columnOf(columns, name) {
  const column = columns[name];
  if (!column) throw new Error(`there is no column ${name}`);
  return column;
}

/**
 * @param {readonly Cell[]} values
 * @param {number} factor
 */
export const scaled = (values, factor) => values.map((value) => (value === null ? null : value * factor));

/**
 * The least and the largest of the numbers, with `start` among them.
 * @param {readonly number[]} values
 * @param {[number, number]} start
 */
export const extent = (values, start) =>
  values.reduce(([least, most], value) => /** @type {[number, number]} */ ([Math.min(least, value), Math.max(most, value)]), start);
