// What the page asks of the service, by path.

import { answer } from "./client.js";

/** @import { Catalogue, Comparison, CompareRequest, Forces, ForcesRequest, Identification, IdentifyRequest, Model, SlipSweep, SlipSweepRequest, StressProfile, StressProfileRequest, Track, TrackColumns, TrackRequest, ValidationSet, VehicleOnSlope, VehicleOverSlopes, VehicleRequest } from "./types.js" */

/** A search may use up the time that the service allows a computation. */
const SEARCH_PATIENCE_MS = 60_000;

/**
 * The paths whose answers are drawn, with what is sent to them and what they answer.
 * @typedef {{
 *   "/v1/forces": { body: ForcesRequest, answer: Forces },
 *   "/v1/stress-profile": { body: StressProfileRequest, answer: StressProfile },
 *   "/v1/slip-sweep": { body: SlipSweepRequest, answer: SlipSweep },
 *   "/v1/vehicle": { body: VehicleRequest, answer: VehicleOnSlope | VehicleOverSlopes },
 *   "/v1/compare": { body: CompareRequest, answer: Comparison },
 * }} Drawn
 */

/** @typedef {Omit<TrackRequest, "columns">} TrackSettings */
/** @typedef {{ settings: TrackSettings, columns: TrackColumns }} TrackAsked */

/**
 * @template Answer
 * @returns {(response: Response) => Promise<Answer>}
 */
const asJson = () => (response) => response.json();
/** @param {Response} response */
const asText = (response) => response.text();

/**
 * @param {object} body
 * @param {string} accept
 * @returns {RequestInit}
 */
const posted = (body, accept) => ({
  method: "POST",
  headers: { "Content-Type": "application/json", Accept: accept },
  body: JSON.stringify(body),
});

/**
 * @template {keyof Drawn} Path
 * @param {Path} path
 * @param {Drawn[Path]["body"]} body
 * @param {AbortSignal} signal
 * @returns {Promise<Drawn[Path]["answer"]>}
 */
export const post = (path, body, signal) => answer(path, { request: posted(body, "application/json"), read: asJson(), signal });

/**
 * @param {string} path
 * @param {object} body
 */
export const postForCsv = (path, body) => answer(path, { request: posted(body, "text/csv"), read: asText });

/**
 * @param {IdentifyRequest} body
 * @param {AbortSignal} signal
 * @returns {Promise<Identification>}
 */
export const identify = (body, signal) =>
  answer("/v1/identify", { request: posted(body, "application/json"), read: asJson(), signal, patienceMs: SEARCH_PATIENCE_MS });

/**
 * Nested fields as a query has them: with dots.
 * @param {unknown} value
 * @returns {[string, string][]}
 */
const dotted = (value, name = "") => (value !== null && typeof value === "object"
  ? Object.entries(value).flatMap(([key, each]) => dotted(each, name ? `${name}.${key}` : key)) : [[name, String(value)]]);

/**
 * A table has no limit to its size where a body of JSON has one, so the columns are sent as a table.
 * @param {TrackColumns} columns
 */
function csvOf(columns) {
  const names = Object.keys(columns);
  const cells = Object.values(columns);
  const rows = cells[0].map((_, row) => cells.map((column) => column[row] ?? "").join(","));
  return [names.join(","), ...rows, ""].join("\n");
}

/**
 * @template Answer
 * @param {TrackAsked} asked
 * @param {string} accept
 * @param {(response: Response) => Promise<Answer>} read
 * @param {AbortSignal} [signal]
 */
const trackAnswer = ({ settings, columns }, accept, read, signal) => answer(`/v1/track?${new URLSearchParams(dotted(settings))}`, {
  request: { method: "POST", headers: { "Content-Type": "text/csv", Accept: accept }, body: csvOf(columns) },
  read,
  signal,
  patienceMs: SEARCH_PATIENCE_MS,
});

/**
 * @param {TrackAsked} asked
 * @param {AbortSignal} signal
 * @returns {Promise<Track>}
 */
export const follow = (asked, signal) => trackAnswer(asked, "application/json", asJson(), signal);

/** @param {TrackAsked} asked */
export const followForCsv = (asked) => trackAnswer(asked, "text/csv", asText);

/** @returns {Promise<Model>} */
export const modelStatement = () => answer("/v1/model", { read: asJson() });

/**
 * @template {{ id: string }} Entry
 * @param {Entry[]} entries
 */
const byIdentifier = (entries) => new Map(entries.map((entry) => [entry.id, entry]));

/** @returns {Promise<Catalogue>} */
export async function catalogueOf() {
  const [{ wheels }, { soils }] = await Promise.all([answer("/v1/wheels", { read: asJson() }), answer("/v1/soils", { read: asJson() })]);
  return { wheels: byIdentifier(wheels), soils: byIdentifier(soils) };
}

/**
 * Published measurements with what the methods give for them.
 * @returns {Promise<ValidationSet[]>}
 */
export const validationSets = async () => (await answer("/v1/validation", { read: asJson() })).sets;
