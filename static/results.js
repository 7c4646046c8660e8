// The numbers beside the charts: result tiles, the tables of methods, warnings, and the spoken summary.

import { faultsOfProblem } from "./answers.js";
import { html, sentenceHtml, symbolHtml } from "./elements.js";
import { METHOD_NAMES, QUANTITIES, fixed, quantity, withUnit } from "./format.js";
import { worded } from "./wording.js";

const MAIN_RESULTS = ["longitudinal_force_n", "normal_force_n", "torque_n_m", "sinkage_m"];
const GAP_QUANTITIES = { longitudinal_force_n: "F_x", normal_force_n: "F_z", torque_n_m: "T" };
/** Below this share a gap is the solver's and the rounding's, not the methods'. */
const NO_GAP = 1e-9;
/** Long enough that a moving slider is not read aloud at every step. */
const SPEECH_PAUSE_MS = 900;

export function showTiles(root, forces) {
  const results = { ...forces, ...forces.components };
  for (const tile of root.querySelectorAll("[data-result]")) {
    const name = tile.dataset.result;
    const value = results[name];
    tile.textContent = quantity(name, value);
    tile.dataset.value = value ?? "";
    const optional = tile.closest("[data-optional]");
    if (optional) optional.hidden = value === undefined;
    tile.title = value === null ? "Not defined at this operating point" : "";
  }
}

/** One row per method; a method without a result says why in its row. */
export function showComparison(container, outcomes) {
  container.hidden = outcomes.length < 2;
  const rows = outcomes.map(({ method, forces: { answer, problem } }) => {
    const cells = answer
      ? MAIN_RESULTS.map((name) => html("td", { "data-compared": name, "data-value": answer[name] }, quantity(name, answer[name])))
      : [html("td", { colspan: MAIN_RESULTS.length, class: "no-result" }, faultsOfProblem(problem).map(({ detail }) => worded(detail)).join(" "))];
    return html("tr", { "data-method": method }, html("th", { scope: "row" }, METHOD_NAMES[method]), ...cells);
  });
  container.querySelector("tbody").replaceChildren(...rows);
}

/** A figure of a gap or a spread, with its share where one is given; `none` where that is no more than rounding. */
function gapCell(kind, name, figure, relative, share = null) {
  if (figure === null) return html("td", { "data-gap": kind, "data-value": "" }, "no common points");
  const isNone = relative !== null && relative < NO_GAP;
  const percent = share === null || isNone ? "" : ` (${withUnit(fixed(share * 100, 1), "%")})`;
  return html("td", { "data-gap": kind, "data-value": figure, "data-share": share }, isNone ? "none" : quantity(name, figure),
    html("span", { class: "share" }, percent));
}

/** The rows of one method, or of the spread, which has no sign and so no mean. */
function gapRows(key, title, byQuantity) {
  return Object.entries(GAP_QUANTITIES).map(([name, symbol], index, all) => {
    const { rms, max_abs: largest, mean, relative } = byQuantity[name];
    return html("tr", { "data-method": key, "data-quantity": name },
      ...(index === 0 ? [html("th", { scope: "rowgroup", rowspan: all.length }, title)] : []),
      html("th", { scope: "row" }, html("i", {}, ...symbolHtml(symbol))),
      gapCell("rms", name, rms, relative, relative),
      mean === undefined ? html("td") : gapCell("mean", name, mean, relative),
      gapCell("max_abs", name, largest, relative));
  });
}

/** How far each closed form is from the integral over the slips of the charts, and how far all are apart, as the API says. */
export function showGaps(container, { series, spread }) {
  container.hidden = series.length < 2;
  if (container.hidden) return;
  const closedForms = series.filter(({ method }) => method !== "quadrature");
  container.querySelector("tbody").replaceChildren(
    ...closedForms.flatMap(({ method, gap_to_quadrature: gap }) => gapRows(method, METHOD_NAMES[method], gap)),
    ...gapRows("spread", "Spread of all", spread));
  const slips = series[0].columns.slip;
  const range = `${withUnit(fixed(slips[0] * 100, 0), "%")} to ${withUnit(fixed(slips.at(-1) * 100, 0), "%")}`;
  const { rows } = spread.torque_n_m;
  const unsolved = rows < slips.length ? `, at ${rows} of which all have a solution` : "";
  container.querySelector(".gap-note").textContent = `Over ${slips.length} slips from ${range}${unsolved}: rms is the root mean square, in `
    + "brackets relative to that of the quadrature; the mean is negative where the closed form gives less. The spread is the highest "
    + "of all methods minus the lowest at each slip.";
}

export function showWarnings(list, warnings) {
  list.replaceChildren(...warnings.map(({ code, detail, methods }) =>
    html("li", { "data-warning": code }, ...sentenceHtml(detail), ...(methods.length ? [" ", html("span", { class: "about" }, `(${methods.join(", ")})`)] : []))));
  list.hidden = warnings.length === 0;
}

/** On a narrow page the warnings come below the controls, so the results at its top lead there. */
export function showWarningsLink(link, { length }) {
  link.textContent = length === 1 ? "1 warning about these results" : `${length} warnings about these results`;
  link.hidden = length === 0;
}

export function createAnnouncer(element) {
  let timer = null;
  return (forces) => {
    clearTimeout(timer);
    timer = setTimeout(() => {
      element.textContent = MAIN_RESULTS.map((name) => `${QUANTITIES[name].name} ${quantity(name, forces[name])}`).join(", ");
    }, SPEECH_PAUSE_MS);
  };
}
