// Scales and ticks: which round numbers an axis shows, and how they are written.

import { fixed } from "./format.js";

const STEPS = [1, 2, 2.5, 5, 10];

/** The smallest round number that covers `span` in about `count` steps. */
export function roundStep(span, count) {
  const rough = span / Math.max(1, count);
  const decade = 10 ** Math.floor(Math.log10(rough));
  return STEPS.find((step) => step * decade >= rough * (1 - 1e-9)) * decade;
}

export function linearScale([from, to], [start, end]) {
  const slope = (end - start) / (to - from);
  const scale = (value) => start + (value - from) * slope;
  scale.invert = (position) => from + (position - start) / slope;
  return scale;
}

function multiplesWithin([from, to], step) {
  const first = Math.ceil(from / step - 1e-9);
  const last = Math.floor(to / step + 1e-9);
  const decimals = decimalsOf(step);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, index) => {
    const value = (first + index) * step;
    return { value, text: fixed(value, decimals) };
  });
}

function decimalsOf(step) {
  for (let decimals = 0; decimals < 12; decimals += 1) {
    const shifted = step * 10 ** decimals;
    if (Math.abs(shifted - Math.round(shifted)) < 1e-6 * shifted) return decimals;
  }
  return 12;
}

/** About `count` round ticks within a given domain. */
export const ticksWithin = ([from, to], count) => multiplesWithin([from, to], roundStep(to - from, count));

/** The smallest axis of whole ticks that holds zero and all values; `limits` cut it where a curve runs away. */
export function roundAxis(values, count, limits = {}) {
  const { min = -Infinity, max = Infinity } = limits;
  const low = Math.max(min, values.reduce((least, value) => Math.min(least, value), 0));
  let high = Math.min(max, values.reduce((most, value) => Math.max(most, value), 0));
  if (low === high) high = low + 1;
  const step = roundStep(high - low, count);
  const domain = [Math.floor(low / step + 1e-9) * step, Math.ceil(high / step - 1e-9) * step];
  return { domain, ticks: multiplesWithin(domain, step) };
}
