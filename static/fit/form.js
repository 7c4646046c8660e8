// The form of a fit, and the places for what comes of it.

import { html } from "../dom/elements.js";
import { symbolHtml } from "../dom/text.js";
import { PARAMETERS } from "../quantities/parameters.js";
import { searchControls } from "../search/search.js";

/** @typedef {ReturnType<typeof fillFitForm>} FitForm */

/**
 * A box to tick, with the name and the symbol of the parameter.
 * @param {[string, typeof PARAMETERS[string]]} parameter
 */
function parameterTick([name, { field: { label, symbol }, usual }]) {
  const box = html("input", { type: "checkbox", "data-fit": name, checked: Boolean(usual) });
  return { box, element: html("label", { class: "tick" }, box, html("span", {}, label, " ", html("i", {}, ...symbolHtml(symbol)))) };
}

/** @param {HTMLElement} form */
export function fillFitForm(form) {
  const ticks = Object.entries(PARAMETERS).map(parameterTick);
  const controls = searchControls(
    { start: "fit-soil", cancel: "cancel-fit", progress: "fit-progress", elapsed: "fit-elapsed" },
    "Fit the soil", "The service is searching");
  const status = html("p", { id: "fit-status", role: "status" });
  const result = html("div", { class: "comparison", id: "fit-result", hidden: true });
  const warnings = html("ul", { id: "fit-warnings", class: "warnings", "aria-label": "Warnings about the fit", hidden: true });
  const use = html("button", { type: "button", id: "use-soil", class: "main", hidden: true }, "Use this soil");
  const residuals = html("div", { id: "fit-residuals", class: "measurements", hidden: true });
  form.append(
    html("fieldset", {},
      html("legend", {}, "What to find"),
      html("div", { class: "ticks", id: "fit-parameters" }, ...ticks.map(({ element }) => element)),
      html("p", { class: "figure-note" }, "Everything else is as set on this page: wheel, method, and the rest of the soil. The search takes wheels "
        + "straight ahead and braking in one zone."),
      controls.row),
    status, result, warnings, html("div", { class: "fit-actions" }, use), residuals);
  return { boxes: ticks.map(({ box }) => box), controls, status, result, warnings, use, residuals };
}
