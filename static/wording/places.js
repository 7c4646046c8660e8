// Where a warning holds, in words.

import { withUnit } from "../numbers/format.js";
import { listed } from "./values.js";

/** @import { Warning } from "../api/types.js" */

/**
 * How many rows a warning holds for beyond those that it names.
 * @param {Warning} warning
 */
const unnamed = ({ rows = [], count = 0 }) => count - rows.reduce((sum, [first, last]) => sum + last - first + 1, 0);

/**
 * @param {Warning} warning
 * @param {(row: number) => string} named
 */
const stretches = ({ rows = [] }, named) => listed(rows.map(([first, last]) => (first === last ? named(first) : `${named(first)} to ${named(last)}`)));

/** @param {Warning} warning */
function others(warning) {
  const count = unnamed(warning);
  return count > 0 ? ` and at ${count} ${count === 1 ? "other" : "others"}` : "";
}

/** @param {number} slip */
const slipText = (slip) => withUnit(String(Number((slip * 100).toPrecision(3))).replace("-", "\u2212"), "%");

/**
 * Points over slip are told by their slips, as the charts have no rows; empty where the warning holds for all.
 * @param {Warning} warning
 * @param {readonly number[]} slips of the rows
 */
export const atSlips = (warning, slips) => (warning.rows ? `at slip ${stretches(warning, (row) => slipText(slips[row]))}${others(warning)}` : "");

/**
 * Samples of a track are told by their lines of the file; empty where the warning holds for all.
 * @param {Warning} warning
 * @param {readonly number[]} lines of the rows
 */
export function atLines(warning, lines) {
  const { rows } = warning;
  if (!rows) return "";
  const isOne = rows.length === 1 && rows[0][0] === rows[0][1];
  return `at ${isOne ? "line" : "lines"} ${stretches(warning, (row) => String(lines[row]))} of the file${others(warning)}`;
}
