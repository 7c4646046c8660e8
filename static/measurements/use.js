// What becomes of the rows of a table, in words.

import { MOST_POINTS, hasSpareVelocities } from "../table/samples.js";

/** @import { Mapping } from "../table/columns.js" */
/** @import { Samples, SlipPoints } from "../table/samples.js" */
/** @import { WrongCell } from "../table/parse.js" */

/** @param {number} count */
const rows = (count) => `${count} ${count === 1 ? "row" : "rows"}`;

/** @param {SlipPoints} points */
function pointsText({ lines, left }) {
  const without = left ? `; ${rows(left)} without a number in every chosen column left out` : "";
  return `${rows(lines.length)} for the curves over slip and a fit${without}.`;
}

/** @param {WrongCell[]} odd */
const oddText = (odd) =>
  `${odd.length === 1 ? "1 cell is not a number and counts as empty" : `${odd.length} cells are not numbers and count as empty, the first`}: ${odd[0].text}`;

/**
 * @param {Samples} samples
 * @param {Mapping} mapping
 */
export function useOf({ points, track, isTooLong, odd }, mapping) {
  const sentences = [];
  if (points) sentences.push(pointsText(points));
  if (isTooLong) sentences.push(`A fit takes ${MOST_POINTS} rows at most, so only the track can be used.`);
  if (track && !points && !isTooLong) {
    sentences.push("Telemetry: follow the track. Points over slip need a measured column, and a slip, which the track gives.");
  }
  if (odd.length) sentences.push(oddText(odd));
  if (track && hasSpareVelocities(mapping)) {
    sentences.push("The velocities are not sent, since there is a slip. To have the slip from them, ignore its column.");
  }
  return sentences.join(" ");
}
