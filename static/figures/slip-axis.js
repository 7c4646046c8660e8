// The axis that all charts over slip share.

import { percent } from "../numbers/format.js";

/** @import { Domain, XAxis } from "../charts/spec.js" */

/**
 * @param {readonly number[]} slips in per cent, in rising order
 * @param {Domain} domain
 * @returns {XAxis}
 */
export const slipAxis = (slips, domain) => ({ values: slips, domain, name: "s", spoken: "slip", label: "slip s, %", format: percent });

/** @param {readonly number[]} slips */
export const inPercent = (slips) => slips.map((slip) => slip * 100);

/**
 * The range of the slips, with a part of it free on both sides.
 * @param {readonly number[]} slips in per cent, in rising order
 * @param {number} least what a single point gets (%)
 * @returns {Domain}
 */
export function withMargin(slips, least) {
  const [first, last] = [slips[0], slips[slips.length - 1]];
  const margin = Math.max(least, 0.04 * (last - first));
  return [first - margin, last + margin];
}
