// One published set: what is known of it, and its measured points over the predicted curves.

import { html } from "../dom/elements.js";
import { sentenceHtml } from "../dom/text.js";
import { inPercent, slipAxis, withMargin } from "../figures/slip-axis.js";
import { columnOf, scaled } from "../numbers/columns.js";
import { QUANTITIES, quantity } from "../quantities/results.js";
import { predictionWarning } from "../wording/warnings.js";
import { seriesNames } from "./sets.js";

/** @import { ValidationSet } from "../api/types.js" */
/** @import { ChartSpec, Curve } from "../charts/spec.js" */

/** @typedef {{ id: string, column: "drawbar_coefficient" | "lateral_coefficient" | "sinkage_m" | "torque_n_m", title: string, symbol: string }} SetChart */

/** @type {Record<string, string>} */
const GRADES = { measured: "measured", digitised: "read off figures", simulated: "simulated", worked_example: "worked example" };

/** @type {SetChart[]} */
export const SET_CHARTS = [
  { id: "validation-drawbar-chart", column: "drawbar_coefficient", title: "Drawbar pull over load", symbol: "F_x/W" },
  { id: "validation-lateral-chart", column: "lateral_coefficient", title: "Lateral force over load", symbol: "F_y/W" },
  { id: "validation-sinkage-chart", column: "sinkage_m", title: "Sinkage", symbol: "z" },
  { id: "validation-torque-chart", column: "torque_n_m", title: "Torque", symbol: "T" },
];
const LEAST_MARGIN = 1;

/** @param {ValidationSet} set */
export function describedSet(set) {
  const { id, title, source, grade, note, fitted_to: fitted, warnings } = set;
  return [
    html("h3", {}, title),
    html("p", { class: "source" }, html("span", { class: "grade" }, GRADES[grade] ?? grade), " ", source, " ", html("a", { href: `v1/validation/${id}` }, "JSON")),
    ...(fitted ? [html("p", { class: "fitted" }, `Fitted: ${fitted}`)] : []),
    ...(note ? [html("p", { class: "note" }, ...sentenceHtml(note))] : []),
    ...warnings.map((warning) =>
      html("p", { class: "note", "data-warning": warning.code }, ...sentenceHtml(predictionWarning(warning, seriesNames(set), set.columns.slip)))),
  ];
}

/**
 * @param {ValidationSet} set
 * @param {SetChart} chart
 * @returns {ChartSpec}
 */
export function setSpec(set, { column, title }) {
  const { measured, predicted, slip } = set.columns;
  const { unit, factor } = QUANTITIES[column];
  const slips = inPercent(slip);
  const names = seriesNames(set);
  /** @type {Curve[]} */
  const curves = set.results.map(({ series }) => {
    const columns = predicted[/** @type {keyof typeof predicted} */ (series)];
    return { key: series, name: names[series], values: scaled(columnOf(columns ?? {}, column), factor) };
  });
  /** @type {Curve} */
  const points = { key: "measured", name: "Measured", values: scaled(columnOf(measured, column), factor) };
  // A lone point makes no line.
  const dotted = slips.length === 1 ? [points, ...curves] : [points];
  return {
    label: `${title} over slip, measured and predicted: ${set.title}`,
    x: slipAxis(slips, withMargin(slips, LEAST_MARGIN)),
    y: { unit, missing: "not measured or without a solution", format: (value) => quantity(column, value / factor) },
    curves: [points, ...curves],
    dots: dotted.flatMap(({ key, values }) => slips.map((at, index) => ({ key, at, value: values[index] }))),
    rest: null,
  };
}
