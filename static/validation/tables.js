// The errors of the predictions, by set and series.

import { html } from "../dom/elements.js";
import { columnHeads, rowHead, table } from "../dom/tables.js";
import { fixed } from "../numbers/format.js";
import { SERIES_NAMES, SIDE_NAMES, hasTwoZones, isInGrains, isSideways } from "./sets.js";

/** @import { ValidationResult, ValidationSet } from "../api/types.js" */

/** @typedef {"drawbar_rmse_over_load" | "sinkage_rmse_m" | "torque_rmse_n_m" | "lateral_rmse_over_load"} ErrorName */

/**
 * An error as text, in the unit of its heading.
 * @typedef {{ name: ErrorName, title: string, text: (value: number) => string }} ErrorColumn
 */

/**
 * @typedef {object} TableSpec
 * @property {string} id
 * @property {(set: ValidationSet) => boolean} of the sets in the table
 * @property {ErrorColumn[]} errors
 * @property {Record<string, string>} series with their headings
 * @property {Record<string, string>} names of the series in full
 */

/** @type {ErrorColumn} */
const PULL = { name: "drawbar_rmse_over_load", title: "Drawbar pull, error over load", text: (value) => fixed(value, 3) };
/** @type {ErrorColumn} */
const SINKAGE = { name: "sinkage_rmse_m", title: "Sinkage, error in mm", text: (value) => fixed(value * 1e3, 1) };
/** @type {ErrorColumn} */
const TORQUE = { name: "torque_rmse_n_m", title: "Torque, error in N·m", text: (value) => fixed(value, 2) };
/** @type {ErrorColumn} */
const LATERAL = { name: "lateral_rmse_over_load", title: "Lateral force, error over load", text: (value) => fixed(value, 3) };

/** @type {TableSpec[]} */
export const TABLES = [
  {
    id: "validation-errors",
    of: (set) => !isSideways(set),
    errors: [PULL, SINKAGE, TORQUE],
    series: { quadrature: "Quadr.", linearised: "Linear.", explicit: "Expl." },
    names: SERIES_NAMES,
  },
  {
    id: "validation-grains",
    of: isInGrains,
    errors: [PULL, SINKAGE, TORQUE],
    series: { quadrature: "Quadr.", resistive_force: "Grains" },
    names: SERIES_NAMES,
  },
  {
    id: "validation-braking",
    of: hasTwoZones,
    errors: [PULL, SINKAGE],
    series: { quadrature: "One zone", quadrature_two_zone: "Two zones" },
    names: SERIES_NAMES,
  },
  {
    id: "validation-side",
    of: isSideways,
    errors: [LATERAL, PULL],
    series: { quadrature: "Indep., full", quadrature_mobilised: "Indep., mob.", quadrature_coupled: "Coupled, full", quadrature_coupled_mobilised: "Coupled, mob." },
    names: SIDE_NAMES,
  },
];

/**
 * @param {ErrorColumn} error
 * @param {ValidationResult} result
 */
function errorCell({ name, text }, { series, solved, unsolved, ...errors }) {
  const value = errors[name] ?? null;
  const gaps = unsolved ? `${unsolved} of ${solved + unsolved} points left out: no solution` : null;
  return html("td", { "data-error": name, "data-series": series, "data-value": value ?? "", title: gaps },
    value === null ? "–" : text(value), value !== null && gaps ? "*" : "");
}

/**
 * @param {ValidationSet[]} sets
 * @param {TableSpec} spec
 * @param {(set: ValidationSet) => HTMLElement} choose makes the button that shows a set
 */
export function errorTable(sets, { errors, series, names }, choose) {
  const shown = Object.keys(series);
  /** @param {ValidationSet} set */
  const row = (set) => {
    const results = set.results.filter((result) => shown.includes(result.series));
    const isFitted = results.some(({ fitted }) => fitted);
    return html("tr", { "data-set": set.id },
      rowHead(choose(set)),
      html("td", {}, String(set.points)),
      html("td", { class: isFitted ? "kind fitted" : "kind", "data-fitted": String(isFitted) }, isFitted ? "fitted" : "predicted"),
      ...errors.flatMap((error) => results.map((result) => errorCell(error, result))));
  };
  return table({}, {
    heads: [
      html("tr", {},
        ...columnHeads(["Set", "Points", "Kind"], { rowspan: 2 }),
        ...errors.map(({ title }) => html("th", { scope: "colgroup", colspan: shown.length }, title))),
      html("tr", {}, ...errors.flatMap(() => shown.map((name) => html("th", { scope: "col", title: names[name] }, series[name])))),
    ],
    rows: sets.map(row),
  });
}
