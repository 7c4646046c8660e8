// Scales and ticks: which round numbers an axis shows, and how they are written.

import { fixed } from "../numbers/format.js";
import { roundStep } from "../numbers/steps.js";

/** @import { Domain } from "./spec.js" */

/** @typedef {{ value: number, text: string }} Tick */
/** @typedef {{ (value: number): number, invert(position: number): number }} Scale */

const MOST_DECIMALS = 12;

/**
 * @param {Domain} domain
 * @param {[number, number]} range in pixels
 * @returns {Scale}
 */
export function linearScale([from, to], [start, end]) {
  const slope = (end - start) / (to - from);
  /** @param {number} value */
  const position = (value) => start + (value - from) * slope;
  return Object.assign(position, { invert: (/** @type {number} */ px) => from + (px - start) / slope });
}

/** @param {number} step */
function decimalsOf(step) {
  for (let decimals = 0; decimals < MOST_DECIMALS; decimals += 1) {
    const shifted = step * 10 ** decimals;
    if (Math.abs(shifted - Math.round(shifted)) < 1e-6 * shifted) return decimals;
  }
  return MOST_DECIMALS;
}

/**
 * @param {Domain} domain
 * @param {number} step
 * @returns {Tick[]}
 */
function multiplesWithin([from, to], step) {
  const first = Math.ceil(from / step - 1e-9);
  const last = Math.floor(to / step + 1e-9);
  const decimals = decimalsOf(step);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, index) => {
    const value = (first + index) * step;
    return { value, text: fixed(value, decimals) };
  });
}

/**
 * About `count` round ticks within a given domain.
 * @param {Domain} domain
 * @param {number} count
 */
export const ticksWithin = ([from, to], count) => multiplesWithin([from, to], roundStep(to - from, count));

/**
 * The smallest axis of whole ticks that holds zero and all values.
 * @param {number[]} values
 * @param {number} count of ticks, about
 * @param {{ min?: number, max?: number }} limits
 */
export function roundAxis(values, count, { min = -Infinity, max = Infinity } = {}) {
  const low = Math.max(min, values.reduce((least, value) => Math.min(least, value), 0));
  let high = Math.min(max, values.reduce((most, value) => Math.max(most, value), 0));
  if (low === high) high = low + 1;
  const step = roundStep(high - low, count);
  /** @type {Domain} */
  const domain = [Math.floor(low / step + 1e-9) * step, Math.ceil(high / step - 1e-9) * step];
  return { domain, ticks: multiplesWithin(domain, step) };
}
