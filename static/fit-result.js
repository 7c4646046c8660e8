// What a search found: the estimates, what was held, how far the points lie from the fit, and what the service warns of.

import { createChart } from "./chart.js";
import { MEASURED } from "./columns.js";
import { html, sentenceHtml, symbolHtml } from "./elements.js";
import { FIELDS } from "./fields.js";
import { residualSpec } from "./figures.js";
import { METHOD_NAMES, fixed, quantity } from "./format.js";
import { PARAMETERS, fieldOf, labelled, named, shown } from "./parameters.js";
import { worded } from "./wording.js";

const NUMBER = String.raw`-?\d+(?:\.\d+)?(?:e[+-]?\d+)?`;
const AT_BOUND = new RegExp(`^(\\w+)( lies at its \\w+ bound )(${NUMBER})$`);
/** Beyond these a table helps nobody; the charts show all. */
const MOST_ROWS = 1000;
const LAWS = ["bekker", "direct", "reece", "diameter"];

const byId = (id) => document.getElementById(id);

/** Numbers in these sentences are the parameter's own, in SI; the interval has a column of its own. */
function identifiabilityOf(identifiability, field) {
  const inUnit = (whole, before, number, after) => `${before}${shown(field, Number(number))}${after}`;
  return named(identifiability.replace(/^determined to ± \S+ \(95 %\)$/, "determined")
    .replace(new RegExp(`(± )(${NUMBER})( \\()`), inUnit)
    .replace(new RegExp(`(: )(${NUMBER})( explains)`), inUnit));
}

/** A bound is told as a bare number, in SI; what the API calls a field of its answer is a column of the table. */
function warningText(detail, law) {
  const inUnit = (_, parameter, words, number) => `${parameter}${words}${shown(fieldOf(parameter, law), Number(number))}`;
  return named(worded(detail.replace(AT_BOUND, inUnit)).replace("see each one's `identifiability`", "the table says why of each"));
}

const HEADS = ["Parameter", "Estimate", "95 % interval", "Do the data determine it?"];

function estimateRow({ parameter, value, interval_95: interval, identifiability }, law) {
  const field = fieldOf(parameter, law);
  const ends = interval ? interval.map((end) => shown(field, end)).join(" to ") : "–";
  return html("tr", { "data-parameter": parameter },
    html("th", { scope: "row" }, ...labelled(field)),
    html("td", { "data-estimate": parameter, "data-value": value, "data-head": HEADS[1] }, shown(field, value)),
    html("td", { "data-head": HEADS[2] }, ends),
    html("td", { class: "words", "data-head": HEADS[3] }, identifiabilityOf(identifiability, field)));
}

const resultTable = ({ estimates, soil }) => html("table", { class: "stacked" },
  html("thead", {}, html("tr", {}, ...HEADS.map((text) => html("th", { scope: "col" }, text)))),
  html("tbody", {}, ...estimates.map((estimate) => estimateRow(estimate, soil.pressure_sinkage.law))));

/** The values of soil and contact that the search took as they were. */
function heldValues({ soil, contact }, fit) {
  const fitted = fit.map((name) => fieldOf(name, soil.pressure_sinkage.law).pointer);
  const seen = new Set(fitted);
  return FIELDS.flatMap((field) => {
    if (!/^\/(soil|contact)\//.test(field.pointer) || seen.has(field.pointer)) return [];
    if (LAWS.includes(field.group) && soil.pressure_sinkage.law !== field.group) return [];
    const value = field.pointer.slice(1).split("/").reduce((part, name) => part?.[name], { soil, contact });
    if (typeof value !== "number") return [];
    seen.add(field.pointer);
    return [{ field, value }];
  });
}

function heldList(reply, fit) {
  const items = heldValues(reply, fit).map(({ field, value }) =>
    html("li", { "data-held": field.name, "data-value": value }, html("i", {}, ...symbolHtml(field.symbol)), " ", shown(field, value)));
  return [html("p", {}, "Held as set on this page, not fitted:"), html("ul", { class: "inline" }, ...items)];
}

const channelsOf = ({ columns }) => Object.keys(MEASURED).filter((name) => columns[`residual_${name}`]);

function summary({ method, converged, identifiable, rmse }, count) {
  const errors = Object.entries(rmse).map(([name, value]) => `${MEASURED[name].label.toLowerCase()} ${quantity(name, value)}`).join(", ");
  return `Fitted to ${count} rows by ${METHOD_NAMES[method].toLowerCase()}. ${converged ? "The search found a minimum" : "The search ended early"}, and the data ${
    identifiable ? "determine" : "do not determine"} every parameter. Errors (rms): ${errors}.`;
}

function residualRows(reply, lines) {
  const { columns } = reply;
  const channels = channelsOf(reply);
  const cells = (row) => channels.flatMap((name) => ["measured", "predicted", "residual"].map((kind) =>
    html("td", { [`data-${kind}`]: name, "data-value": columns[`${kind}_${name}`][row] }, quantity(name, columns[`${kind}_${name}`][row]))));
  const rows = lines.slice(0, MOST_ROWS).map((line, row) =>
    html("tr", {}, html("th", { scope: "row" }, `Line ${line}`), html("td", {}, `${fixed(columns.slip[row] * 100, 1)}\u00a0%`), ...cells(row)));
  const table = html("table", {},
    html("thead", {},
      html("tr", {}, html("td", {}), html("td", {}), ...channels.map((name) => html("th", { scope: "colgroup", colspan: 3 }, MEASURED[name].label))),
      html("tr", {}, html("td", {}), html("th", { scope: "col" }, "Slip"), ...channels.flatMap(() =>
        ["Measured", "Predicted", "Residual"].map((text) => html("th", { scope: "col" }, text))))),
    html("tbody", {}, ...rows));
  return lines.length > MOST_ROWS ? [table, html("p", { class: "figure-note" }, `The first ${MOST_ROWS} of ${lines.length} rows.`)] : [table];
}

/** Charts for the channels that were fitted, and the same numbers in a table that is built once it is unfolded. */
function showResiduals(reply, lines) {
  const charts = channelsOf(reply).map((name) => ({ name, host: html("div", { class: "chart", id: `residual-${name.replaceAll("_", "-")}-chart` }) }));
  const details = html("details", { id: "residual-rows" }, html("summary", {}, "Residuals by row"));
  details.addEventListener("toggle", () => {
    const rows = html("div", { class: "comparison", tabindex: "0", role: "region", "aria-label": "Residuals by row" });
    rows.append(...residualRows(reply, lines));
    details.append(rows);
  }, { once: true });
  byId("fit-residuals").replaceChildren(
    html("div", { class: "slip-charts" }, ...charts.map(({ name, host }) =>
      html("figure", {}, html("figcaption", {}, html("h3", {}, `${MEASURED[name].label}: predicted less measured`)), host))),
    details);
  byId("fit-residuals").hidden = false;
  for (const { name, host } of charts) createChart(host).draw(residualSpec(name, reply));
}

/** `asked`: { fit, lines, law } of the search. */
export function showFit(reply, { fit, lines, law }) {
  const { soil, warnings } = reply;
  byId("fit-status").textContent = summary(reply, lines.length);
  byId("fit-result").replaceChildren(resultTable(reply), ...heldList(reply, fit));
  const isReplaced = soil.pressure_sinkage.law !== law && !warnings.some(({ code }) => code === "law_replaced");
  const replaced = { code: "law_replaced", detail: `${PARAMETERS.k_s.field.label} is fitted: the direct law stands in place of the law set on this page, with its exponents` };
  byId("fit-warnings").replaceChildren(...[...warnings, ...(isReplaced ? [replaced] : [])].map(({ code, detail }) =>
    html("li", { "data-warning": code }, ...sentenceHtml(warningText(detail, soil.pressure_sinkage.law)))));
  byId("fit-warnings").hidden = !byId("fit-warnings").children.length;
  byId("fit-result").hidden = false;
  showResiduals(reply, lines);
}
