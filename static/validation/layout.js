// The places of the tables and charts of the section.

import { chartFigure, titleWithSymbol } from "../charts/figure.js";
import { html } from "../dom/elements.js";
import { SET_CHARTS } from "./set.js";

/** @import { Child } from "../dom/elements.js" */

/**
 * @param {string} id
 * @param {string} label for screen readers
 * @param {boolean} hidden
 */
const tablePlace = (id, label, hidden) => html("div", { class: "comparison", id, tabindex: "0", role: "region", "aria-label": label, hidden });

/**
 * @param {string} title
 * @param {Child[]} text
 * @param {HTMLElement} place
 */
const laws = (title, text, place) => html("div", { class: "laws", hidden: true }, html("h3", {}, title), html("p", {}, ...text), place);

/** @param {string} name of the API */
const code = (name) => html("code", {}, name);

/** @param {HTMLElement} section */
export function fillValidation(section) {
  const set = html("div", { id: "validation-set", hidden: true });
  const charts = html("div", { class: "slip-charts", id: "validation-charts", hidden: true },
    ...SET_CHARTS.map(({ id, title, symbol }) => chartFigure(id, titleWithSymbol(title, symbol))));
  section.append(
    tablePlace("validation-errors", "Errors by set and method", true),
    laws("Dry grains", [
      "The method ", code("resistive_force"), " beside the quadrature, for soils of known density. No set was fitted by what it takes of a soil.",
    ], tablePlace("validation-grains", "Errors in dry grains", false)),
    laws("Laws of braking", [
      "By quadrature. A locked wheel has no solution with two zones, so its point counts for one zone only.",
    ], tablePlace("validation-braking", "Errors by law of braking", false)),
    laws("Side force at a slip angle", [
      "By quadrature, with ", code("independent"), " or ", code("coupled"), " shear stresses and a ", code("full"), " or ", code("mobilised"),
      " pressure on the side wall. The API uses the first pair unless told otherwise.",
    ], tablePlace("validation-side", "Errors of the side force by pair of laws", false)),
    laws("Held out", [
      "By quadrature, with parameters fitted to the pulls of one part and scored on another that the fit has not seen. The error on the part fitted on says little of what a fit is worth.",
    ], tablePlace("validation-held-out", "What a fit is worth on points that it has not seen", false)),
    set,
    charts);
  return { set, charts };
}
