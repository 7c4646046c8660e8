// The methods side by side: their results at the operating point, and how far they are apart over slip.

import { html } from "../dom/elements.js";
import { columnHeads, rowHead, table } from "../dom/tables.js";
import { symbolHtml } from "../dom/text.js";
import { fixed, percent, withUnit } from "../numbers/format.js";
import { METHOD_NAMES, methodName, quantity } from "../quantities/results.js";
import { faultText } from "../wording/faults.js";
import { MAIN_RESULTS } from "./tiles.js";

/** @import { Comparison, Difference, Spread } from "../api/types.js" */
/** @import { MethodOutcome, Series } from "../rounds/outcomes.js" */

/** Of the main results. */
const MAIN_SYMBOLS = ["F_x", "F_z", "T", "z"];
/** @type {Record<string, string>} */
const GAP_QUANTITIES = { longitudinal_force_n: "F_x", normal_force_n: "F_z", torque_n_m: "T" };
/** Below this share a gap is that of the solver and of rounding, not of the methods. */
const NO_GAP = 1e-9;

/**
 * One row per method. A method without a result says why in its row.
 * @param {HTMLElement} container
 * @param {MethodOutcome[]} outcomes
 */
export function showComparison(container, outcomes) {
  container.hidden = outcomes.length < 2;
  const rows = outcomes.map(({ method, forces: { answer, problem } }) => {
    const cells = answer
      ? MAIN_RESULTS.map((name) => html("td", { "data-compared": name, "data-value": answer[name] }, quantity(name, answer[name])))
      : [html("td", { colspan: MAIN_RESULTS.length, class: "no-result" }, problem.faults.map((fault) => faultText(fault)).join(" "))];
    return html("tr", { "data-method": method }, rowHead(METHOD_NAMES[method]), ...cells);
  });
  container.replaceChildren(table({ id: "comparison-table" }, {
    caption: "The methods at this operating point",
    heads: [html("tr", {}, ...columnHeads(["Method"]), ...MAIN_SYMBOLS.map((symbol) => html("th", { scope: "col" }, html("i", {}, ...symbolHtml(symbol)))))],
    rows,
  }));
}

/**
 * @typedef {object} Figure
 * @property {string} kind
 * @property {string} name of the quantity
 * @property {number | null | undefined} value
 * @property {number | null | undefined} relative to the reference: no more than rounding counts as none
 * @property {number | null} [share] shown behind the value
 */

/** @param {Figure} figure */
function gapCell({ kind, name, value, relative, share = null }) {
  if (value === null || value === undefined) return html("td", { "data-gap": kind, "data-value": "" }, "no common points");
  const isNone = typeof relative === "number" && relative < NO_GAP;
  const behind = share === null || isNone ? "" : ` (${percent(share * 100)})`;
  return html("td", { "data-gap": kind, "data-value": value, "data-share": share }, isNone ? "none" : quantity(name, value),
    html("span", { class: "share" }, behind));
}

/**
 * The rows of one method, or of the spread, which has no sign and so no mean.
 * @param {string} key
 * @param {string} title
 * @param {Record<string, Difference | Spread>} byQuantity
 */
function gapRows(key, title, byQuantity) {
  return Object.entries(GAP_QUANTITIES).map(([name, symbol], index, all) => {
    const figures = byQuantity[name];
    const { rms, max_abs: largest, relative } = figures;
    return html("tr", { "data-method": key, "data-quantity": name },
      ...(index === 0 ? [html("th", { scope: "rowgroup", rowspan: all.length }, title)] : []),
      rowHead(html("i", {}, ...symbolHtml(symbol))),
      gapCell({ kind: "rms", name, value: rms, relative, share: relative }),
      "mean" in figures ? gapCell({ kind: "mean", name, value: figures.mean, relative }) : html("td"),
      gapCell({ kind: "max_abs", name, value: largest, relative }));
  });
}

/**
 * @param {readonly number[]} slips
 * @param {Comparison["spread"]} spread
 */
function gapNote(slips, spread) {
  /** @param {number} slip */
  const wholePercent = (slip) => withUnit(fixed(slip * 100, 0), "%");
  const { rows } = spread.torque_n_m;
  const unsolved = rows < slips.length ? `, at ${rows} of which all have a solution` : "";
  return `Over ${slips.length} slips from ${wholePercent(slips[0])} to ${wholePercent(slips[slips.length - 1])}${unsolved}: rms is the root mean `
    + "square, in brackets relative to that of the quadrature; the mean is negative where the method gives less. The spread is the "
    + "highest of all methods minus the lowest at each slip.";
}

/**
 * How far each other method is from the quadrature over the slips of the charts, and how far all are apart.
 * @param {HTMLElement} container
 * @param {Series[]} series
 * @param {Comparison["spread"]} [spread] absent for a single method
 */
export function showGaps(container, series, spread) {
  container.hidden = !spread;
  if (!spread) return;
  const others = series.flatMap(({ method, gap_to_quadrature: gaps }) =>
    (gaps && method !== "quadrature" ? gapRows(method, methodName(method), gaps) : []));
  container.replaceChildren(
    table({ id: "gap-table" }, {
      caption: "Gap to the quadrature, over slip",
      heads: [html("tr", {},
        ...columnHeads(["Method"]),
        html("th", { scope: "col" }, html("span", { class: "visually-hidden" }, "Quantity")),
        ...columnHeads(["rms", "Mean", "Largest"]))],
      rows: [...others, ...gapRows("spread", "Spread of all", spread)],
    }),
    html("p", { class: "gap-note" }, gapNote(series[0].columns.slip, spread)));
}
