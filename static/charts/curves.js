// Curves with gaps, single dots, and measured points.

import { svg } from "../dom/elements.js";
import { isNumber } from "../numbers/columns.js";

/** @import { Layout } from "./layout.js" */
/** @import { ChartSpec, Curve, Point } from "./spec.js" */

const POINT_PX = 3.5;
const DOT_PX = 4;
const CLIP_MARGIN_PX = 2;

/**
 * Path of a curve. A null lifts the pen, and a lone point keeps a dot's worth of line.
 * @param {readonly number[]} xs
 * @param {Curve} curve
 * @param {Layout} layout
 */
function curvePath(xs, { values }, { x, y }) {
  let path = "";
  let isDrawing = false;
  xs.forEach((at, index) => {
    const value = values[index];
    if (!isNumber(value)) {
      isDrawing = false;
      return;
    }
    const point = `${x(at).toFixed(2)} ${y(value).toFixed(2)}`;
    path += isDrawing ? `L${point}` : `M${point}h0.01`;
    isDrawing = true;
  });
  return path;
}

/**
 * The measured points between the ends of the x axis.
 * @param {ChartSpec} spec
 */
export const pointsWithin = ({ measured, x: { domain } }) =>
  (measured?.points ?? []).filter(({ at }) => at >= domain[0] && at <= domain[1]);

/**
 * All points as circles in one path: telemetry has thousands.
 * @param {Point[]} points
 * @param {Layout} layout
 */
function pointsPath(points, { x, y }) {
  const [r, d] = [POINT_PX, 2 * POINT_PX];
  return points.map(({ at, value }) => `M${(x(at) - r).toFixed(2)} ${y(value).toFixed(2)}a${r} ${r} 0 1 0 ${d} 0a${r} ${r} 0 1 0 ${-d} 0`).join("");
}

/**
 * @param {ChartSpec} spec
 * @param {Layout} layout
 */
const dotCircles = ({ dots = [] }, { x, y }) => dots.flatMap(({ key, at, value }) =>
  (isNumber(value) ? [svg("circle", { class: "dot", "data-style": key, cx: x(at), cy: y(value), r: DOT_PX })] : []));

/**
 * The area beyond which curves are cut.
 * @param {string} id
 * @param {Layout} layout
 */
export const clipArea = (id, { left, right, top, bottom }) => svg("clipPath", { id },
  svg("rect", { x: left, y: top - CLIP_MARGIN_PX, width: right - left, height: bottom - top + 2 * CLIP_MARGIN_PX }));

/**
 * @param {ChartSpec} spec
 * @param {Layout} layout
 * @param {string} clip id of the area
 */
export const clippedCurves = (spec, layout, clip) => svg("g", { "clip-path": `url(#${clip})` },
  ...spec.curves.map((curve) => svg("path", { class: "curve", "data-style": curve.key, d: curvePath(spec.x.values, curve, layout) })),
  ...dotCircles(spec, layout),
  ...(spec.measured && layout.measured.length
    ? [svg("path", { class: "point", "data-style": spec.measured.key, d: pointsPath(layout.measured, layout) })] : []));
