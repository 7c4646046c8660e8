// What a search found: the estimates, what was held, and what the service warns of.

import { html } from "../dom/elements.js";
import { columnHeads, rowHead, table } from "../dom/tables.js";
import { sentenceHtml, symbolHtml } from "../dom/text.js";
import { LAW_FIELDS, PRESSURE_SINKAGE, lawIn } from "../quantities/law-fields.js";
import { MEASURED } from "../quantities/measured.js";
import { PARAMETERS, fieldOf, valueText } from "../quantities/parameters.js";
import { methodName, quantity } from "../quantities/results.js";
import { showWarnings } from "../results/warnings.js";
import { SOIL_FIELDS, foundValue } from "../state/found-soil.js";
import { identifiabilityText } from "../wording/estimates.js";
import { fitWarning } from "../wording/warnings.js";
import { showResiduals } from "./residuals.js";

/** @import { FitParameter, Identification, ParameterEstimate } from "../api/types.js" */
/** @import { FitForm } from "./form.js" */

/** @typedef {{ fit: FitParameter[], lines: number[], law: string }} AskedFit lines of the file; the law of the page */

const HEADS = ["Parameter", "Estimate", "95 % interval", "Do the data determine it?"];

/** @param {Identification} reply */
const foundLaw = ({ soil }) => lawIn(soil.pressure_sinkage) ?? "direct";

/**
 * @param {ParameterEstimate} estimate
 * @param {string} law
 */
function estimateRow(estimate, law) {
  const { parameter, value, interval_95: interval } = estimate;
  const field = fieldOf(parameter, law);
  const ends = interval ? interval.map((end) => valueText(field, end)).join(" to ") : "–";
  return html("tr", { "data-parameter": parameter },
    rowHead(field.label, " ", html("i", {}, ...symbolHtml(field.symbol))),
    html("td", { "data-estimate": parameter, "data-value": value, "data-head": HEADS[1] }, valueText(field, value)),
    html("td", { "data-head": HEADS[2] }, ends),
    html("td", { class: "words", "data-head": HEADS[3] }, ...sentenceHtml(identifiabilityText(estimate, field))));
}

/** @param {Identification} reply */
const estimateTable = (reply) => table({ class: "stacked" }, {
  heads: [html("tr", {}, ...columnHeads(HEADS))],
  rows: reply.estimates.map((estimate) => estimateRow(estimate, foundLaw(reply))),
});

/**
 * The values of soil and contact that the search took as they were.
 * @param {Identification} reply
 * @param {FitParameter[]} fit
 */
function heldValues(reply, fit) {
  const law = foundLaw(reply);
  const fitted = fit.map((name) => fieldOf(name, law).pointer);
  const foreign = LAW_FIELDS.filter(({ family, laws }) => family === PRESSURE_SINKAGE && !laws.includes(law)).map(({ name }) => name);
  return SOIL_FIELDS.filter(({ name }) => !foreign.includes(name)).flatMap((field) => {
    const value = fitted.includes(field.pointer) ? null : foundValue(field, reply);
    return value === null ? [] : [{ field, value }];
  });
}

/**
 * @param {Identification} reply
 * @param {FitParameter[]} fit
 */
function heldList(reply, fit) {
  const items = heldValues(reply, fit).map(({ field, value }) => html("li", { "data-held": field.name, "data-value": value },
    html("i", {}, ...symbolHtml(field.symbol)), " ", valueText(field, value)));
  return [html("p", {}, "Held as set on this page, not fitted:"), html("ul", { class: "inline" }, ...items)];
}

/**
 * @param {Identification} reply
 * @param {number} count of rows
 */
function summary({ method, converged, identifiable, rmse }, count) {
  const errors = Object.entries(rmse).map(([name, value]) => `${MEASURED[name].label.toLowerCase()} ${quantity(name, value)}`).join(", ");
  return `Fitted to ${count} rows by ${methodName(method).toLowerCase()}. ${converged ? "The search found a minimum" : "The search ended early"}, and the data ${
    identifiable ? "determine" : "do not determine"} every parameter. Errors (rms): ${errors}.`;
}

/**
 * The service says so of a preset's law. Of one that is set on the page, the page has to.
 * @param {Identification} reply
 * @param {string} law
 */
function replacedLaw(reply, law) {
  if (foundLaw(reply) === law || reply.warnings.some(({ code }) => code === "law_replaced")) return [];
  const text = `${PARAMETERS.k_s.field.label} is fitted: the direct law, with the same exponents, replaces the law set on this page`;
  return [{ code: "law_replaced", text }];
}

/**
 * @param {FitForm} form
 * @param {Identification} reply
 * @param {AskedFit} asked
 */
export function showFit({ status, result, warnings, residuals }, reply, { fit, lines, law }) {
  status.textContent = summary(reply, lines.length);
  result.replaceChildren(estimateTable(reply), ...heldList(reply, fit));
  result.hidden = false;
  const said = reply.warnings.map((warning) => ({ code: warning.code, text: fitWarning(warning, foundLaw(reply)) }));
  showWarnings(warnings, [...said, ...replacedLaw(reply, law)]);
  showResiduals(residuals, reply, lines);
}
