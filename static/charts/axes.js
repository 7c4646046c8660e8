// Grid lines, ticks and labels of the axes.

import { svg } from "../dom/elements.js";
import { svgText } from "../dom/text.js";

/** @import { Layout } from "./layout.js" */
/** @import { ChartSpec } from "./spec.js" */

/** @param {Layout} layout */
export const horizontalGrid = ({ left, right, y, yTicks }) => yTicks.flatMap(({ value, text }) => {
  const py = y(value);
  return [
    svg("line", { class: value === 0 ? "zero" : "grid", x1: left, x2: right, y1: py, y2: py }),
    svg("text", { class: "tick-label", x: left - 6, y: py + 4, "text-anchor": "end" }, text),
  ];
});

/** @param {Layout} layout */
const verticalGrid = ({ top, bottom, x, xTicks }) => xTicks.flatMap(({ value, text }) => {
  const px = x(value);
  return [
    svg("line", { class: "grid", x1: px, x2: px, y1: top, y2: bottom + 4 }),
    svg("text", { class: "tick-label", x: px, y: bottom + 16, "text-anchor": "middle" }, text),
  ];
});

/**
 * The unit of y, the vertical grid, and the label of x.
 * @param {ChartSpec} spec
 * @param {Layout} layout
 */
export const labelledAxes = (spec, layout) => [
  svg("text", { class: "axis-label", x: layout.left - 6, y: layout.top - 10, "text-anchor": "end" }, spec.y.unit),
  ...verticalGrid(layout),
  svgText({ class: "axis-label", x: (layout.left + layout.right) / 2, y: layout.size.height - 5, "text-anchor": "middle" }, spec.x.label),
];
