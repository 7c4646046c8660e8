// What the curves of a chart do not show.

import { isNumber } from "../numbers/columns.js";
import { capitalised } from "../numbers/format.js";

/** @import { ChartSpec } from "./spec.js" */

/**
 * Names points without a value, and stretches beyond the axis.
 * @param {ChartSpec} spec
 */
export function gapNote({ curves, y: { missing = "no solution", limits = {} }, x }) {
  const { min = -Infinity, max = Infinity } = limits;
  /** @type {Map<string, string[]>} */
  const affected = new Map();
  for (const { name, values } of curves) {
    const told = [];
    const gaps = values.filter((value) => !isNumber(value)).length;
    if (gaps) told.push(`${missing} at ${gaps} of ${x.values.length} points`);
    if (values.some((value) => isNumber(value) && (value < min || value > max))) told.push("partly outside the axis");
    for (const text of told) affected.set(text, [...(affected.get(text) ?? []), name]);
  }
  return [...affected].map(([text, names]) => {
    const sentence = names.length === curves.length ? text : `${names.join(" and ")}: ${text}`;
    return `${capitalised(sentence)}.`;
  }).join(" ");
}
