// The form of a track, and the places for what comes of it.

import { chartFigure, titleWithSymbol } from "../charts/figure.js";
import { html } from "../dom/elements.js";
import { QUANTITIES } from "../quantities/results.js";
import { searchControls } from "../search/search.js";
import { TRACK_CHARTS } from "./figures.js";

/** @param {HTMLElement} form */
export function fillTrackForm(form) {
  const terms = html("p", { class: "figure-note", id: "track-terms" });
  const lead = html("p", { class: "lead", id: "track-lead", hidden: true },
    "Slip, static sinkage z₀ and load are enough for pull and torque; the soil’s sinkage modulus is not needed. ",
    html("button", { type: "button", id: "track-use-load", class: "small" }, "Use z₀ and the load"));
  const controls = searchControls(
    { start: "follow-track", cancel: "cancel-track", progress: "track-progress", elapsed: "track-elapsed" },
    "Follow the track", "The service follows the track");
  const status = html("p", { id: "track-status", role: "status" });
  const warnings = html("ul", { id: "track-warnings", class: "warnings", "aria-label": "Warnings about the track", hidden: true });
  const note = html("p", { class: "fault", id: "track-note", hidden: true }, "The inputs have changed since: follow the track again.");
  const events = html("div", { class: "comparison", id: "track-events", hidden: true });
  const csv = html("button", { type: "button", id: "track-csv", class: "small" }, "CSV");
  const result = html("div", { id: "track-result", class: "measurements", hidden: true },
    note,
    events,
    html("div", { class: "slip-charts" }, ...TRACK_CHARTS.map(({ id, name, symbol }) => chartFigure(id, titleWithSymbol(QUANTITIES[name].name, symbol)))),
    html("div", { class: "fit-actions" }, csv));
  form.append(html("fieldset", {}, html("legend", {}, "Over time"), lead, terms, controls.row), status, warnings, result);
  return { lead, terms, controls, status, warnings, result, note, events, csv };
}
