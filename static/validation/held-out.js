// What a fit is worth on points that it has not seen.

import { html } from "../dom/elements.js";
import { symbolHtml } from "../dom/text.js";
import { columnHeads, rowHead, table } from "../dom/tables.js";
import { fixed } from "../numbers/format.js";
import { inPercent } from "../figures/slip-axis.js";
import { PARAMETERS, valueText } from "../quantities/parameters.js";

/** @import { HeldOut, ValidationFit, ValidationPart, ValidationSet } from "../api/types.js" */

/**
 * A part of the measurements in words: its set, and its slips where it is not all of them.
 * @param {ValidationPart} part
 * @param {ValidationSet[]} sets
 */
function partText({ set: id, rows }, sets) {
  const set = sets.find((each) => each.id === id);
  if (!set) return id;
  const slips = inPercent(set.columns.slip);
  const isWhole = rows.length === slips.length;
  return isWhole ? set.title : `${set.title}; slips ${rows.map((row) => fixed(slips[row], 0)).join(", ")} %`;
}

/** @param {string[]} fitted */
const symbols = (fitted) => fitted.flatMap((name, index) => [index ? ", " : "", html("i", {}, ...symbolHtml(PARAMETERS[name].field.symbol))]);

/** @param {ValidationFit} fit */
const valuesText = ({ fitted, values }) => fitted.filter((name) => name in values)
  .map((name) => `${PARAMETERS[name].field.symbol} = ${valueText(PARAMETERS[name].field, values[name])}`).join("; ") || null;

/**
 * @param {ValidationFit} fit
 * @param {"drawbar_rmse_over_load" | "on_fitted_part"} name
 */
function errorCell(fit, name) {
  const value = fit[name] ?? null;
  return html("td", { "data-error": name, "data-fit": fit.fitted.join(" "), "data-value": value ?? "", title: valuesText(fit) },
    value === null ? "–" : fixed(value, 3));
}

/**
 * @param {HeldOut[]} heldOut
 * @param {ValidationSet[]} sets
 */
export function heldOutTable(heldOut, sets) {
  const fits = heldOut[0].results.map(({ fitted }) => fitted);
  const heads = () => fits.map((fitted) =>
    html("th", { scope: "col" }, ...(fitted.length ? [...symbols(fitted), " fitted"] : ["Nothing fitted"])));
  return table({}, {
    heads: [
      html("tr", {},
        ...columnHeads(["Fitted on", "Scored on"], { rowspan: 2 }),
        ...["Drawbar pull, error over load", "On the part fitted on"].map((title) => html("th", { scope: "colgroup", colspan: fits.length }, title))),
      html("tr", {}, ...heads(), ...heads()),
    ],
    rows: heldOut.map(({ fitted_on: fittedOn, scored_on: scoredOn, results }) => html("tr", {},
      rowHead(partText(fittedOn, sets)),
      html("td", { class: "kind" }, partText(scoredOn, sets)),
      ...results.map((fit) => errorCell(fit, "drawbar_rmse_over_load")),
      ...results.map((fit) => errorCell(fit, "on_fitted_part")))),
  });
}
