// A table with a time: sent to be followed on demand, and what the service makes of it over time.

import { follow, followForCsv } from "../api/endpoints.js";
import { createChart } from "../charts/chart.js";
import { byId, enclosing, find } from "../dom/find.js";
import { fieldAt } from "../quantities/fields.js";
import { showWarnings } from "../results/warnings.js";
import { UNREADABLE_INPUTS, createSearch, onSubmit } from "../search/search.js";
import { connectFile } from "../share/share.js";
import { trackRequest } from "../state/measured-bodies.js";
import { trackWarning } from "../wording/warnings.js";
import { TRACK_CHARTS, trackSpec } from "./figures.js";
import { fillTrackForm } from "./form.js";
import { eventTable, hasLoadBesideSinkage, statusCounts, termsOf } from "./words.js";

/** @import { TrackAsked } from "../api/endpoints.js" */
/** @import { Track, TrackColumns } from "../api/types.js" */
/** @import { Cell } from "../numbers/columns.js" */
/** @import { Settings } from "../state/settings.js" */
/** @import { MeasuredColumns } from "../table/samples.js" */

/** @typedef {{ track: TrackColumns, columns: MeasuredColumns, lines: number[] }} TrackTable with its lines of the file */

/**
 * @typedef {object} TelemetryEvents
 * @property {() => Settings} settings what is on the page
 * @property {() => TrackTable | null} track
 * @property {() => void} onLoadKnown gives the static sinkage and the load on the page
 * @property {(slips: Cell[]) => void} onSlips takes the slip of each row, as the service has it
 */

/**
 * @param {HTMLElement} form
 * @param {TelemetryEvents} events
 */
export function connectTelemetry(form, { settings, track, onSlips, onLoadKnown }) {
  const { lead, terms, controls, status, warnings, result, note, events, csv } = fillTrackForm(form);
  const search = createSearch({ form, running: "following", done: "followed", status, results: [warnings, result], controls });
  const charts = TRACK_CHARTS.map(({ id, name }) => ({ name, host: byId(id), chart: createChart(byId(id)) }));
  /** @type {TrackAsked | null} */
  let asked = null;

  function forget() {
    search.forget();
    asked = null;
  }

  /**
   * @param {Track} reply
   * @param {TrackTable} table
   * @param {string} method
   */
  function showTrack(reply, { columns, lines }, method) {
    status.replaceChildren(...statusCounts(reply.columns.status));
    showWarnings(warnings, reply.warnings.map((warning) => ({ code: warning.code, text: trackWarning(warning, lines) })));
    events.replaceChildren(...eventTable(reply.events, lines));
    events.hidden = !reply.events.length;
    result.hidden = false;
    for (const { name, host, chart } of charts) {
      const spec = trackSpec(name, reply, columns, method);
      enclosing(host, "figure").hidden = !spec;
      chart.setCursor(null);
      if (spec) chart.draw(spec);
    }
  }

  /** The inputs may have changed since the track was asked for. */
  function markStale() {
    const table = track();
    const isStale = form.dataset.state === "followed" && asked !== null && table !== null
      && JSON.stringify(trackRequest(settings(), table.track).settings) !== JSON.stringify(asked.settings);
    result.dataset.stale = String(isStale);
    note.hidden = !isStale;
  }

  onSubmit(form, () => {
    forget();
    const now = settings();
    const table = track();
    if (now.unreadable.length || !table) {
      search.fail(UNREADABLE_INPUTS);
      return;
    }
    const request = trackRequest(now, table.track);
    asked = request;
    search.run({
      text: `Following ${table.lines.length} samples…`,
      ask: (signal) => follow(request, signal),
      onAnswer(reply) {
        showTrack(reply, table, now.method);
        onSlips(reply.columns.slip);
        markStale();
      },
      subjectOf: ({ pointer }) => fieldAt(pointer)?.label ?? null,
    });
  });

  find(lead, "button").addEventListener("click", onLoadKnown);
  connectFile(csv, () => {
    if (!asked) throw new Error("There is no track to save yet.");
    const request = asked;
    const { wheel, soil } = request.settings;
    return { what: "track", wheel, soil, text: () => followForCsv(request) };
  });

  function tell() {
    const table = track();
    if (form.hidden || !table) return;
    terms.textContent = termsOf(settings(), table.track);
    lead.hidden = hasLoadBesideSinkage(settings(), table.track);
    markStale();
  }

  return {
    /**
     * Another table than before has not been followed.
     * @param {boolean} isTrack
     */
    show(isTrack) {
      forget();
      form.hidden = !isTrack;
      tell();
    },
    tell,
  };
}
