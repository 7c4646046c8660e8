// What a chart says in words: the legend with the values at the cursor, and the same for screen readers.

import { html, svg } from "../dom/elements.js";
import { isNumber } from "../numbers/columns.js";

/** @import { Cell } from "../numbers/columns.js" */
/** @import { ChartSpec, Curve } from "./spec.js" */

/**
 * @param {ChartSpec} spec
 * @param {Cell | undefined} value
 */
const valueText = ({ y }, value) => (isNumber(value) ? y.format(value) : "none");

/**
 * @param {string} key
 * @param {string} name
 * @param {string} reading
 */
const legendItem = (key, name, reading) => html("li", { "data-curve": key },
  svg("svg", { class: "swatch", viewBox: "0 0 26 8", "aria-hidden": "true" },
    svg("path", { class: "curve", "data-style": key, d: "M1 4H25" })),
  html("span", {}, name),
  html("span", { class: "reading" }, reading));

/**
 * The legend at a sample, or at rest. At rest it reads the dots, which need not be samples of the curves.
 * @param {ChartSpec} spec
 * @param {number} index of the sample nearest to the cursor or to the position at rest
 * @param {boolean} isResting
 */
export function legendItems(spec, index, isResting) {
  const { x, curves, dots = [], measured, basis = [] } = spec;
  const at = isResting ? spec.rest : x.values[index];
  /** @param {Curve} curve */
  const valueOf = (curve) => (isResting && dots.length ? dots.find(({ key }) => key === curve.key)?.value : curve.values[index]);
  return [
    html("li", { class: "position" }, x.name, " ", at === null ? "" : x.format(at)),
    ...curves.map((curve) => legendItem(curve.key, curve.name, at === null ? "" : valueText(spec, valueOf(curve)))),
    ...(measured && measured.isListed !== false ? [legendItem(measured.key, measured.name, measured.reading)] : []),
    ...basis.map((text) => html("li", { class: "basis" }, text)),
  ];
}

/**
 * @param {ChartSpec} spec
 * @param {number} index of the sample
 */
export const spokenText = (spec, index) => [
  `${spec.x.spoken} ${spec.x.format(spec.x.values[index])}`,
  ...spec.curves.map((curve) => `${curve.name} ${valueText(spec, curve.values[index])}`),
].join(", ");
