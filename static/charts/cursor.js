// The cursor: the sample it stands at, its line and dots, and its steps by the keyboard.

import { svg } from "../dom/elements.js";
import { isNumber } from "../numbers/columns.js";

/** @import { Layout } from "./layout.js" */
/** @import { ChartSpec } from "./spec.js" */

const PAGE_STEPS = 10;

/**
 * @param {readonly number[]} values
 * @param {number} target
 */
export function nearestIndex(values, target) {
  let best = 0;
  values.forEach((value, index) => {
    if (Math.abs(value - target) < Math.abs(values[best] - target)) best = index;
  });
  return best;
}

/**
 * @param {ChartSpec} spec
 * @param {Layout} layout
 * @param {number} index of the sample
 */
export function cursorLine({ x: { values }, curves }, { x, y, top, bottom }, index) {
  const px = x(values[index]);
  return [
    svg("line", { class: "cursor", x1: px, x2: px, y1: top, y2: bottom }),
    ...curves.flatMap((curve) => {
      const value = curve.values[index];
      return isNumber(value) ? [svg("circle", { class: "cursor-dot", "data-style": curve.key, cx: px, cy: y(value), r: 3.5 })] : [];
    }),
  ];
}

/**
 * The sample to which a key moves the cursor, or null for any other key.
 * @param {string} key
 * @param {number} index
 * @param {number} last
 */
export function steppedIndex(key, index, last) {
  /** @type {Record<string, number>} */
  const targets = {
    ArrowLeft: index - 1, ArrowDown: index - 1, ArrowRight: index + 1, ArrowUp: index + 1,
    PageDown: index - PAGE_STEPS, PageUp: index + PAGE_STEPS, Home: 0, End: last,
  };
  return Object.hasOwn(targets, key) ? Math.min(last, Math.max(0, targets[key])) : null;
}
