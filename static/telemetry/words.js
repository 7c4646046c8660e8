// What is sent of a track, and what became of its samples, in words.

import { html } from "../dom/elements.js";
import { columnHeads, rowHead, table } from "../dom/tables.js";
import { seconds } from "../numbers/format.js";
import { MEASURED } from "../quantities/measured.js";
import { quantity } from "../quantities/results.js";
import { CIRCLE_NAMES } from "../wording/basis.js";
import { trackRequest } from "../state/measured-bodies.js";
import { listed } from "../wording/values.js";

/** @import { TrackColumns, TrackEvent } from "../api/types.js" */
/** @import { LoadSource, SinkageSource } from "../state/measured-bodies.js" */
/** @import { Settings } from "../state/settings.js" */

const MOST_EVENTS = 20;
/** @type {Record<string, string>} */
const EVENT_NAMES = { stall: "Stall", entrapment: "Entrapment" };
/** @type {Record<string, string>} */
const STATUS_NAMES = {
  ok: "followed", static: "at rest", missing_value: "with a missing value", out_of_range: "out of range", slip_out_of_range: "with a slip out of range",
  opposite_rotation: "rolling against the rotation", time_backwards: "with a time that goes backwards", no_solution: "without a solution",
};
/** @type {Record<string, string>} */
const SENT_NAMES = { normal_load_n: "normal force" };

/**
 * Where the sinkage of a sample comes from.
 * @param {SinkageSource} source
 * @param {Settings} settings
 */
function sinkageTerms(source, { given }) {
  switch (source) {
    case "measured": return "The sinkage is the measured one.";
    case "measured_load": return "The sinkage is solved for the measured normal force.";
    case "load": return `The sinkage is solved for the load of ${quantity("normal_force_n", given.normal_load_n)} that is set on this page.`;
    case "static": return `The sinkage follows from the static sinkage of ${quantity("sinkage_m", given.static_sinkage_m)} that is set on this page.`;
    case "page": return `The sinkage of every row is the ${quantity("sinkage_m", given.sinkage_m)} set on this page; for one that changes, give a load.`;
  }
}

/**
 * @param {LoadSource} source
 * @param {Settings} settings
 */
function loadTerms(source, { given }) {
  if (source === null) return "";
  const load = source === "column" ? "measured normal force" : `load of ${quantity("normal_force_n", given.normal_load_n)} that is set on this page`;
  return ` The ${load} takes the place of the sinkage modulus.`;
}

/** @param {Settings} settings */
const circleTerms = ({ drawing: { lugHeight }, circles }) =>
  (lugHeight > 0 ? ` The slip is counted at ${CIRCLE_NAMES[circles.slip_radius ?? "rim"]}.` : "");

/**
 * @param {Settings} settings
 * @param {TrackColumns} track
 */
export function termsOf(settings, track) {
  const { sinkageFrom, loadFrom } = trackRequest(settings, track);
  const sent = listed(Object.keys(track).map((name) => SENT_NAMES[name] ?? MEASURED[name].label.toLowerCase()));
  return `${track.time_s?.length ?? 0} rows of ${sent} are sent, with the wheel, the soil and the method of this page, straight ahead. ${
    sinkageTerms(sinkageFrom, settings)}${loadTerms(loadFrom, settings)}${circleTerms(settings)}`;
}

/**
 * Whether the track has what leads to pull and torque without a sinkage modulus.
 * @param {Settings} settings
 * @param {TrackColumns} track
 */
export function hasLoadBesideSinkage(settings, track) {
  const { sinkageFrom, loadFrom } = trackRequest(settings, track);
  return sinkageFrom !== "page" && loadFrom !== null;
}

/**
 * How many samples came to what.
 * @param {string[]} statuses
 */
export function statusCounts(statuses) {
  /** @type {Map<string, number>} */
  const counts = new Map();
  for (const status of statuses) counts.set(status, (counts.get(status) ?? 0) + 1);
  const told = [...counts].flatMap(([status, count], index) =>
    [index ? ", " : "", html("span", { "data-status": status, "data-count": count }, `${count} ${STATUS_NAMES[status] ?? status}`)]);
  return [html("span", {}, `${statuses.length} samples: `), ...told, "."];
}

/**
 * When the wheel was stuck.
 * @param {TrackEvent[]} events
 * @param {number[]} lines of the file
 */
export function eventTable(events, lines) {
  const told = events.slice(0, MOST_EVENTS);
  const rows = told.map(({ code, row, from_s: from, to_s: to }) => html("tr", { "data-event": code, "data-from": from, "data-to": to },
    rowHead(html("span", { class: "band-swatch", "data-band": code }), EVENT_NAMES[code] ?? code),
    html("td", {}, seconds(from)), html("td", {}, seconds(to)), html("td", {}, `Line ${lines[row]}`)));
  const heads = [html("tr", {}, ...columnHeads(["Event", "From", "To", "Begins at"]))];
  const note = `The first ${told.length} of ${events.length}; the file has more.`;
  return [
    table({}, { caption: "When the wheel was stuck", heads, rows }),
    ...(events.length > told.length ? [html("p", { class: "figure-note" }, note)] : []),
  ];
}
