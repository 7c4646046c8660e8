// Where everything of a chart stands, in pixels.

import { isNumber } from "../numbers/columns.js";
import { pointsWithin } from "./curves.js";
import { CHARACTER_PX, labelRows, placedMarks } from "./marks.js";
import { linearScale, roundAxis, ticksWithin } from "./scales.js";

/** @import { PlacedMark } from "./marks.js" */
/** @import { Scale, Tick } from "./scales.js" */
/** @import { ChartSpec, Point } from "./spec.js" */

/** @typedef {{ width: number, height: number }} Size */

/**
 * @typedef {object} Layout
 * @property {Size} size
 * @property {number} left
 * @property {number} right
 * @property {number} top
 * @property {number} bottom
 * @property {Scale} x
 * @property {Scale} y
 * @property {Tick[]} xTicks
 * @property {Tick[]} yTicks
 * @property {PlacedMark[]} marks
 * @property {Point[]} measured the measured points between the ends of the x axis
 */

const LINE_PX = 14;
const MARGIN = { top: 10, right: 14, bottom: 36 };
const TICK_SPACING = { x: 75, y: 34 };
const LEAST_SIZE_PX = 40;

/** @param {Size} size */
export const isLargeEnough = ({ width, height }) => width >= LEAST_SIZE_PX && height >= LEAST_SIZE_PX;

/**
 * @param {number} length
 * @param {number} spacing
 */
const tickCount = (length, spacing) => Math.max(2, Math.round(length / spacing));

/**
 * @param {ChartSpec} spec
 * @param {Size} size
 * @returns {Layout}
 */
export function layoutOf(spec, size) {
  const { width, height } = size;
  const measured = pointsWithin(spec);
  const values = [...spec.curves.flatMap((curve) => curve.values.filter(isNumber)), ...measured.map(({ value }) => value)];
  const bottom = height - MARGIN.bottom;
  const { domain, ticks: yTicks } = roundAxis(values, tickCount(bottom - MARGIN.top - LINE_PX, TICK_SPACING.y), spec.y.limits);

  const left = 12 + Math.max(spec.y.unit.length + 1, ...yTicks.map(({ text }) => text.length)) * CHARACTER_PX;
  const right = width - MARGIN.right;
  const x = linearScale(spec.x.domain, [left, right]);

  const labelled = placedMarks(spec, x, [left, width - 2]);
  const rows = labelRows(labelled);
  const marks = labelled.map((mark, index) => ({ ...mark, labelY: MARGIN.top + rows[index] * LINE_PX + 2 }));
  const top = MARGIN.top + Math.max(1, ...rows.map((row) => row + 1)) * LINE_PX;

  return {
    size,
    left,
    right,
    top,
    bottom,
    x,
    y: linearScale(domain, [bottom, top]),
    xTicks: ticksWithin(spec.x.domain, tickCount(width - left, TICK_SPACING.x)),
    yTicks,
    marks,
    measured,
  };
}
