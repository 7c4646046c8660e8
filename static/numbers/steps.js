// Round numbers for axes and sliders.

const STEPS = [1, 2, 2.5, 5, 10];

/**
 * The smallest round number that covers `span` in about `count` steps.
 * @param {number} span
 * @param {number} count
 */
export function roundStep(span, count) {
  const rough = span / Math.max(1, count);
  const decade = 10 ** Math.floor(Math.log10(rough));
  return (STEPS.find((step) => step * decade >= rough * (1 - 1e-9)) ?? 10) * decade;
}

/**
 * The next number with one significant digit.
 * @param {number} value
 */
export function roundedUp(value) {
  const decade = 10 ** Math.floor(Math.log10(value));
  return Math.ceil(value / decade) * decade;
}
