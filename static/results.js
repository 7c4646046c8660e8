// The numbers beside the charts: result tiles, the table of methods, warnings, and the spoken summary.

import { faultsOfProblem } from "./answers.js";
import { html } from "./elements.js";
import { METHOD_NAMES, QUANTITIES, quantity } from "./format.js";

const MAIN_RESULTS = ["longitudinal_force_n", "normal_force_n", "torque_n_m", "sinkage_m"];
/** Long enough that a moving slider is not read aloud at every step. */
const SPEECH_PAUSE_MS = 900;

export function showTiles(root, forces) {
  const results = { ...forces, ...forces.components };
  for (const tile of root.querySelectorAll("[data-result]")) {
    const name = tile.dataset.result;
    const value = results[name];
    tile.textContent = quantity(name, value);
    tile.dataset.value = value ?? "";
    tile.title = value === null ? "Not defined at this operating point" : "";
  }
}

/** One row per method; a method without a result says why in its row. */
export function showComparison(container, outcomes) {
  container.hidden = outcomes.length < 2;
  const rows = outcomes.map(({ method, forces: { answer, problem } }) => {
    const cells = answer
      ? MAIN_RESULTS.map((name) => html("td", { "data-compared": name, "data-value": answer[name] }, quantity(name, answer[name])))
      : [html("td", { colspan: MAIN_RESULTS.length, class: "no-result" }, faultsOfProblem(problem).map(({ detail }) => detail).join(" "))];
    return html("tr", { "data-method": method }, html("th", { scope: "row" }, METHOD_NAMES[method]), ...cells);
  });
  container.querySelector("tbody").replaceChildren(...rows);
}

export function showWarnings(list, warnings) {
  list.replaceChildren(...warnings.map(({ code, detail, abouts }) =>
    html("li", { "data-warning": code }, detail, " ", html("span", { class: "about" }, `(${abouts.join("; ")})`))));
  list.hidden = warnings.length === 0;
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
