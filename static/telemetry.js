// A table with a time: sent to be followed on demand, and what the service makes of it over time.

import { faultsOfProblem } from "./answers.js";
import { Problem, follow, followForCsv } from "./api.js";
import { createChart } from "./chart.js";
import { MEASURED } from "./columns.js";
import { html, sentenceHtml } from "./elements.js";
import { FIELDS } from "./fields.js";
import { quantity, significant, withUnit } from "./format.js";
import { trackRequest } from "./measured-requests.js";
import { named } from "./parameters.js";
import { createSearch } from "./search.js";
import { connectFile } from "./share.js";
import { TRACK_CHARTS, trackSpec } from "./track-figures.js";
import { faultOf, worded } from "./wording.js";

const MOST_EVENTS = 20;
const EVENT_NAMES = { stall: "Stall", entrapment: "Entrapment" };
const STATUS_NAMES = {
  ok: "followed", static: "at rest", missing_value: "with a missing value", out_of_range: "out of range", slip_out_of_range: "with a slip out of range",
  opposite_rotation: "rolling against the rotation", time_backwards: "with a time that goes backwards", no_solution: "without a solution",
};
const SENT_NAMES = { normal_load_n: "normal force" };

const byId = (id) => document.getElementById(id);
const and = (words) => (words.length > 1 ? `${words.slice(0, -1).join(", ")} and ${words.at(-1)}` : words.join(""));

/** Whence the sinkage of a sample comes; `given` are the page's own values. */
function sinkageTerms(sinkageFrom, { given }) {
  return {
    measured: "The sinkage is the measured one.",
    measured_load: "The sinkage is solved for the measured normal force.",
    load: `The sinkage is solved for the load of ${quantity("normal_force_n", given.normal_load_n)} that is set on this page.`,
    static: `The sinkage follows from the static one of ${quantity("sinkage_m", given.static_sinkage_m)} that is set on this page.`,
    page: `The sinkage is that of ${quantity("sinkage_m", given.sinkage_m)} set on this page, for every row; give a load for one that changes.`,
  }[sinkageFrom];
}

function termsOf(settings, track) {
  const { sinkageFrom } = trackRequest(settings, track);
  const sent = and(Object.keys(track).map((name) => SENT_NAMES[name] ?? MEASURED[name].label.toLowerCase()));
  return `${track.time_s.length} rows of ${sent} are sent, with the wheel, the soil and the method of this page, straight ahead. ${sinkageTerms(sinkageFrom, settings)}`;
}

/** How many samples came to what. */
function statusCounts(statuses) {
  const counts = new Map();
  for (const status of statuses) counts.set(status, (counts.get(status) ?? 0) + 1);
  return [html("span", {}, `${statuses.length} samples: `), ...[...counts].flatMap(([status, count], index) =>
    [index ? ", " : "", html("span", { "data-status": status, "data-count": count }, `${count} ${STATUS_NAMES[status] ?? status}`)]), "."];
}

function eventTable(events, lines) {
  const seconds = (value) => withUnit(significant(value, 4), "s");
  const told = events.slice(0, MOST_EVENTS);
  const rows = told.map(({ code, row, from_s: from, to_s: to }) => html("tr", { "data-event": code, "data-from": from, "data-to": to },
    html("th", { scope: "row" }, html("span", { class: "band-swatch", "data-band": code }), EVENT_NAMES[code] ?? code),
    html("td", {}, seconds(from)), html("td", {}, seconds(to)), html("td", {}, `Line ${lines[row]}`)));
  const table = html("table", {},
    html("caption", {}, "When the wheel was stuck"),
    html("thead", {}, html("tr", {}, ...["Event", "From", "To", "Begins at"].map((text) => html("th", { scope: "col" }, text)))),
    html("tbody", {}, ...rows));
  return events.length > told.length ? [table, html("p", { class: "figure-note" }, `The first ${told.length} of ${events.length}; the file has more.`)] : [table];
}

/** Samples are told by the lines of the file. */
function warningText(detail, lines) {
  return named(worded(detail).replace("give `normal_load_n`", "choose “Normal load” at the operating point").replace(/at ind(?:ex|ices) ([\d–, ]*\d)/, (_, rows) =>
    `at ${/[–,]/.test(rows) ? "lines" : "line"} ${rows.replace(/\d+/g, (row) => lines[row])} of the file`));
}

/**
 * `settings()`: what is on the page; `track()`: { track, columns, lines } of the table, or null; `onSlips` takes the slip of each row as
 * the service has it.
 */
export function connectTelemetry(form, { settings, track, onSlips }) {
  const status = byId("track-status");
  const search = createSearch({ start: "follow-track", cancel: "cancel-track", progress: "track-progress", elapsed: "track-elapsed" });
  const charts = TRACK_CHARTS.map(({ id, name }) => ({ name, host: byId(id), chart: createChart(byId(id)) }));
  let asked = null;

  function forget() {
    search.cancel();
    asked = null;
    form.dataset.state = "idle";
    status.textContent = "";
    for (const id of ["track-warnings", "track-result"]) byId(id).hidden = true;
  }

  function showTrack(reply, { columns, lines }) {
    form.dataset.state = "followed";
    status.replaceChildren(...statusCounts(reply.columns.status));
    byId("track-warnings").replaceChildren(...reply.warnings.map(({ code, detail }) =>
      html("li", { "data-warning": code }, ...sentenceHtml(warningText(detail, lines)))));
    byId("track-warnings").hidden = !reply.warnings.length;
    byId("track-events").replaceChildren(...eventTable(reply.events, lines));
    byId("track-events").hidden = !reply.events.length;
    byId("track-result").hidden = false;
    for (const { name, host, chart } of charts) {
      const spec = trackSpec(name, reply, columns, asked.settings.method);
      host.closest("figure").hidden = !spec;
      chart.setCursor(null);
      if (spec) chart.draw(spec);
    }
  }

  function tellFailure(sentences) {
    form.dataset.state = "failed";
    status.replaceChildren(...sentences.map((sentence) => html("span", { class: "fault" }, ...sentenceHtml(sentence), " ")));
  }

  function run() {
    forget();
    const now = settings();
    if (now.unreadable.length) {
      tellFailure(["First put right the inputs that this page marks."]);
      return;
    }
    const table = track();
    asked = trackRequest(now, table.track);
    status.textContent = `The service follows ${table.lines.length} samples…`;
    form.dataset.state = "following";
    search.run((signal) => follow(asked, signal), {
      onAnswer(reply) {
        showTrack(reply, table);
        onSlips(reply.columns.slip);
        markStale();
      },
      onError: (error) => tellFailure(error instanceof Problem
        ? faultsOfProblem(error).map(({ pointer, detail }) => faultOf(FIELDS.find((field) => field.pointer === pointer)?.label ?? null, named(worded(detail))))
        : [error.message]),
    });
  }

  /** The inputs may have become others since the track was asked for. */
  function markStale() {
    const isStale = form.dataset.state === "followed" && JSON.stringify(trackRequest(settings(), track().track).settings) !== JSON.stringify(asked.settings);
    byId("track-result").dataset.stale = isStale;
    byId("track-note").hidden = !isStale;
  }

  form.addEventListener("submit", (event) => {
    event.preventDefault();
    run();
  });
  byId("cancel-track").addEventListener("click", () => {
    forget();
    status.textContent = "Cancelled.";
    byId("follow-track").focus();
  });
  connectFile(byId("track-csv"), () => {
    const request = asked;
    return { what: "track", ...request.settings, text: () => followForCsv(request) };
  });

  function tell() {
    if (form.hidden) return;
    byId("track-terms").textContent = termsOf(settings(), track().track);
    markStale();
  }

  return {
    /** A table that is another one than before has not been followed. */
    show(isTrack) {
      forget();
      form.hidden = !isTrack;
      tell();
    },
    tell,
  };
}
