// The numbers beside the charts: result tiles, the table of methods, warnings, and the spoken summary.

import { html } from "./elements.js";
import { METHOD_NAMES, QUANTITIES, quantity } from "./format.js";

const SPOKEN = ["longitudinal_force_n", "normal_force_n", "torque_n_m", "sinkage_m"];
const COMPARED = ["longitudinal_force_n", "normal_force_n", "torque_n_m", "sinkage_m"];
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
  const rows = outcomes.map(({ method, forces, problem }) => {
    const cells = forces
      ? COMPARED.map((name) => html("td", { "data-compared": name, "data-value": forces[name] }, quantity(name, forces[name])))
      : [html("td", { colspan: COMPARED.length, class: "no-result" }, problem)];
    return html("tr", { "data-method": method }, html("th", { scope: "row" }, METHOD_NAMES[method]), ...cells);
  });
  container.querySelector("tbody").replaceChildren(...rows);
}

export function showWarnings(list, warnings) {
  const distinct = new Map(warnings.map((warning) => [`${warning.code} ${warning.detail}`, warning]));
  list.replaceChildren(...[...distinct.values()].map(({ code, detail }) => html("li", { "data-warning": code }, detail)));
  list.hidden = distinct.size === 0;
}

export function createAnnouncer(element) {
  let timer = null;
  return (forces) => {
    clearTimeout(timer);
    timer = setTimeout(() => {
      element.textContent = SPOKEN.map((name) => `${QUANTITIES[name].name} ${quantity(name, forces[name])}`).join(", ");
    }, SPEECH_PAUSE_MS);
  };
}
