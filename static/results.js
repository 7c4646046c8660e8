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

function gapCell(kind, name, gap, scale) {
  if (gap === null) return html("td", { "data-gap": kind, "data-value": "" }, "no common points");
  const share = scale ? gap / scale : null;
  const text = share !== null && share < NO_GAP ? "none" : quantity(name, gap);
  const percent = share === null || share < NO_GAP ? "" : ` (${withUnit(fixed(share * 100, 1), "%")})`;
  return html("td", { "data-gap": kind, "data-value": gap, "data-share": share }, text, html("span", { class: "share" }, percent));
}

/** How far each method is from the first over the slips of the charts: as the API says, and as a share of the load or the largest value. */
export function showGaps(container, { series, load }) {
  container.hidden = series.length < 2;
  if (container.hidden) return;
  const [reference, ...others] = series;
  const largest = (name) => Math.max(...reference.columns[name].map((value) => Math.abs(value ?? 0)));
  const scaleOf = (name) => (load !== null && name !== "torque_n_m" ? load : largest(name));
  const rows = others.flatMap(({ method, difference }) =>
    Object.entries(GAP_QUANTITIES).map(([name, symbol], index, all) => html("tr", { "data-method": method, "data-quantity": name },
      ...(index === 0 ? [html("th", { scope: "rowgroup", rowspan: all.length }, METHOD_NAMES[method])] : []),
      html("th", { scope: "row" }, html("i", {}, ...symbolHtml(symbol))),
      gapCell("rms", name, difference[name].rms, scaleOf(name)),
      gapCell("max_abs", name, difference[name].max_abs, scaleOf(name)))));
  container.querySelector("tbody").replaceChildren(...rows);
  const slips = reference.columns.slip;
  const range = `${withUnit(fixed(slips[0] * 100, 0), "%")} to ${withUnit(fixed(slips.at(-1) * 100, 0), "%")}`;
  const shares = load === null
    ? `Shares are of the largest value that ${METHOD_NAMES[reference.method].toLowerCase()} gives over these slips.`
    : `Shares of the forces are of the load, those of the torque of its largest value by ${METHOD_NAMES[reference.method].toLowerCase()}.`;
  container.querySelector(".gap-note").textContent = `Over ${slips.length} slips from ${range}, where both methods have a solution; rms is the root mean square. ${shares}`;
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
