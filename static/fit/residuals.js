// How far the measured points lie from the fit, as the service gives it: charts, and a table by row.

import { createChart } from "../charts/chart.js";
import { chartFigure } from "../charts/figure.js";
import { html } from "../dom/elements.js";
import { find } from "../dom/find.js";
import { columnHeads, rowHead, table } from "../dom/tables.js";
import { inPercent, slipAxis, withMargin } from "../figures/slip-axis.js";
import { columnOf, isNumber, scaled } from "../numbers/columns.js";
import { percent } from "../numbers/format.js";
import { MEASURED } from "../quantities/measured.js";
import { QUANTITIES, quantity } from "../quantities/results.js";

/** @import { Identification } from "../api/types.js" */
/** @import { ChartSpec } from "../charts/spec.js" */

/** A longer table helps nobody; the charts show all rows. */
const MOST_ROWS = 1000;
const KINDS = ["measured", "predicted", "residual"];
const LEAST_MARGIN = 1;

/**
 * The measured quantities that were fitted.
 * @param {Identification} reply
 */
const channelsOf = ({ columns }) => Object.keys(MEASURED).filter((name) => `residual_${name}` in columns);

/**
 * The residuals of one quantity over slip: invisible as a curve, drawn as points.
 * @param {string} name
 * @param {Identification} reply
 * @returns {ChartSpec}
 */
function residualSpec(name, { columns, rmse }) {
  const { name: title, unit, factor } = QUANTITIES[name];
  const rows = columns.slip.map((_, row) => row).sort((a, b) => columns.slip[a] - columns.slip[b]);
  const slips = inPercent(rows.map((row) => columns.slip[row]));
  const residuals = columnOf(columns, `residual_${name}`);
  const values = scaled(rows.map((row) => residuals[row]), factor);
  return {
    label: `${title}, predicted minus measured, over slip`,
    x: slipAxis(slips, withMargin(slips, LEAST_MARGIN)),
    y: { unit, missing: "no prediction", format: (value) => quantity(name, value / factor) },
    curves: [{ key: "measured", name: `Residual, rms ${quantity(name, rmse[name])}`, values }],
    measured: {
      key: "measured",
      name: "",
      reading: "",
      points: values.flatMap((value, row) => (isNumber(value) ? [{ at: slips[row], value }] : [])),
      isListed: false,
    },
    rest: null,
  };
}

/**
 * @param {Identification} reply
 * @param {number[]} lines
 */
function rowTable(reply, lines) {
  const { columns } = reply;
  const channels = channelsOf(reply);
  const cells = channels.flatMap((name) => KINDS.map((kind) => ({ kind, name, values: columnOf(columns, `${kind}_${name}`) })));
  const rows = lines.slice(0, MOST_ROWS).map((line, row) => html("tr", {},
    rowHead(`Line ${line}`),
    html("td", {}, percent(columns.slip[row] * 100)),
    ...cells.map(({ kind, name, values }) => html("td", { [`data-${kind}`]: name, "data-value": values[row] }, quantity(name, values[row])))));
  return table({}, {
    heads: [
      html("tr", {}, html("td", {}), html("td", {}), ...channels.map((name) => html("th", { scope: "colgroup", colspan: KINDS.length }, MEASURED[name].label))),
      html("tr", {}, html("td", {}), ...columnHeads(["Slip", ...channels.flatMap(() => ["Measured", "Predicted", "Residual"])])),
    ],
    rows,
  });
}

/**
 * @param {Identification} reply
 * @param {number[]} lines
 */
function residualRows(reply, lines) {
  const note = lines.length > MOST_ROWS ? [html("p", { class: "figure-note" }, `The first ${MOST_ROWS} of ${lines.length} rows.`)] : [];
  return html("div", { class: "comparison", tabindex: "0", role: "region", "aria-label": "Residuals by row" }, rowTable(reply, lines), ...note);
}

/** @param {string} name of the quantity */
const chartId = (name) => `residual-${name.replaceAll("_", "-")}-chart`;

/**
 * The table is built once it is unfolded.
 * @param {HTMLElement} section
 * @param {Identification} reply
 * @param {number[]} lines of the file
 */
export function showResiduals(section, reply, lines) {
  const names = channelsOf(reply);
  const details = html("details", { id: "residual-rows" }, html("summary", {}, "Residuals by row"));
  details.addEventListener("toggle", () => details.append(residualRows(reply, lines)), { once: true });
  section.replaceChildren(
    html("div", { class: "slip-charts" }, ...names.map((name) => chartFigure(chartId(name), [`${MEASURED[name].label}: predicted minus measured`]))),
    details);
  section.hidden = false;
  for (const name of names) createChart(find(section, `#${chartId(name)}`)).draw(residualSpec(name, reply));
}
