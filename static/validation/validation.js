// Published measurements against the predictions of the methods.

import { messageOf } from "../api/client.js";
import { validationSets } from "../api/endpoints.js";
import { createChart } from "../charts/chart.js";
import { html } from "../dom/elements.js";
import { byId, enclosing, find, findAll } from "../dom/find.js";
import { isNumber } from "../numbers/columns.js";
import { fillValidation } from "./layout.js";
import { SET_CHARTS, describedSet, setSpec } from "./set.js";
import { TABLES, errorTable } from "./tables.js";

/** @import { ValidationSet } from "../api/types.js" */
/** @import { Chart } from "../charts/chart.js" */
/** @import { SetChart } from "./set.js" */

/**
 * @param {HTMLElement} section
 * @param {string} id of the chosen set
 */
function markChosen(section, id) {
  for (const row of findAll(section, "tr[data-set]")) {
    const isChosen = row.dataset.set === id;
    row.classList.toggle("chosen", isChosen);
    find(row, "button").setAttribute("aria-pressed", String(isChosen));
  }
}

/** @param {HTMLElement} section */
export function showValidation(section) {
  const status = byId("validation-status");
  const { set: description, charts: chartArea } = fillValidation(section);
  /** @type {(SetChart & { view: Chart })[] | null} */
  let charts = null;

  /** @param {ValidationSet} set */
  function show(set) {
    markChosen(section, set.id);
    description.replaceChildren(...describedSet(set));
    for (const part of [description, chartArea]) part.hidden = false;
    charts ??= SET_CHARTS.map((chart) => ({ ...chart, view: createChart(byId(chart.id)) }));
    for (const { view, ...chart } of charts) {
      const isMeasured = set.columns.measured[chart.column]?.some(isNumber) ?? false;
      enclosing(byId(chart.id), "figure").hidden = !isMeasured;
      if (!isMeasured) continue;
      view.setCursor(null);
      view.draw(setSpec(set, chart));
    }
    section.dataset.shown = set.id;
  }

  /** @param {ValidationSet} set */
  function chooseButton(set) {
    const button = html("button", { type: "button", class: "small", "aria-pressed": "false" }, set.title);
    button.addEventListener("click", () => show(set));
    return button;
  }

  /** @param {ValidationSet[]} sets */
  function showAll(sets) {
    for (const table of TABLES) {
      byId(table.id).replaceChildren(errorTable(sets.filter(table.of), table, chooseButton));
      enclosing(byId(table.id), "[hidden]").hidden = false;
    }
    status.textContent = "Choose a set to see its points. A dash means not measured; an asterisk, that points without a solution are left out.";
    show(sets[0]);
    section.dataset.state = "ready";
  }

  /** @param {unknown} error */
  function tellFailure(error) {
    section.dataset.state = "failed";
    const again = html("button", { type: "button", class: "small" }, "Try again");
    again.addEventListener("click", load);
    status.replaceChildren(`The measurements could not be loaded: ${messageOf(error)} `, again);
  }

  async function load() {
    section.dataset.state = "loading";
    status.textContent = "Loading the measurements…";
    try {
      showAll(await validationSets());
    } catch (error) {
      tellFailure(error);
    }
  }

  load();
}
