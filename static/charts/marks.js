// Marked positions and stretches of the x axis.

import { svg } from "../dom/elements.js";
import { svgText } from "../dom/text.js";

/** @import { Layout } from "./layout.js" */
/** @import { Scale } from "./scales.js" */
/** @import { ChartSpec, Mark } from "./spec.js" */

/** @typedef {Mark & { centre: number, start: number, end: number }} LabelledMark */
/** @typedef {LabelledMark & { labelY: number }} PlacedMark */

export const CHARACTER_PX = 6.8;
const LABEL_GAP_PX = 4;
const LEAST_BAND_PX = 2;

/**
 * The marks on the axis, each with its label between the bounds.
 * @param {ChartSpec} spec
 * @param {Scale} x
 * @param {[number, number]} bounds
 * @returns {LabelledMark[]}
 */
export function placedMarks({ marks = [], x: { domain } }, x, [left, right]) {
  return marks.filter(({ at }) => at >= domain[0] && at <= domain[1]).map((mark) => {
    const half = (mark.label.replace("_", "").length * CHARACTER_PX) / 2;
    const centre = Math.min(Math.max(x(mark.at), left + half), right - half);
    return { ...mark, centre, start: centre - half - LABEL_GAP_PX, end: centre + half + LABEL_GAP_PX };
  });
}

/**
 * The row of each label: the first one in which it is clear of its neighbours.
 * @param {LabelledMark[]} labels
 */
export function labelRows(labels) {
  /** @type {number[]} */
  const ends = [];
  return labels.map(({ start, end }) => {
    const free = ends.findIndex((taken) => start > taken);
    const row = free < 0 ? ends.length : free;
    ends[row] = end;
    return row;
  });
}

/** @param {Layout} layout */
export const markLines = ({ marks, x, bottom }) => marks.flatMap(({ key, at, label, centre, labelY }) => {
  const px = x(at);
  return [
    svg("line", { class: "mark", "data-mark": key, x1: px, x2: px, y1: labelY + 4, y2: bottom }),
    svgText({ class: "mark-label", x: centre, y: labelY, "text-anchor": "middle" }, label),
  ];
});

/**
 * @param {ChartSpec} spec
 * @param {Layout} layout
 */
export const bandAreas = ({ bands = [] }, { x, top, bottom }) => bands.map(({ key, from, to }) =>
  svg("rect", { class: "band", "data-band": key, x: x(from), y: top, width: Math.max(LEAST_BAND_PX, x(to) - x(from)), height: bottom - top }));
