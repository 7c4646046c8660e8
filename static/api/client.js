// Requests to the service. They fail in two ways: with a problem, in which the service says what is wrong, or without a usable answer.

/** @import { FieldFault, ProblemDocument } from "./types.js" */

const PATIENCE_MS = 20_000;
const PASSING_STATUSES = [408, 429, 500, 502, 503, 504];

export class Problem extends Error {
  /**
   * @param {ProblemDocument} document
   * @param {number} status
   */
  constructor({ title, detail, errors }, status) {
    super(detail ?? title ?? `The service answered with status ${status}.`);
    this.status = status;
    /** @type {FieldFault[]} */
    this.errors = Array.isArray(errors) ? errors : [];
  }

  /** The faults of the fields, or else the problem as a fault of the whole request. */
  get faults() {
    return this.errors.length ? this.errors : [{ pointer: "", detail: this.message }];
  }
}

/** Worth another try: the network is down, the service is starting, or it is busy. */
export class Unavailable extends Error {
  /**
   * @param {string} message
   * @param {number | null} retryAfterSeconds
   */
  constructor(message, retryAfterSeconds = null) {
    super(message);
    this.retryAfterSeconds = retryAfterSeconds;
  }
}

/**
 * @template Answer
 * @typedef {object} Asked
 * @property {RequestInit} [request]
 * @property {(response: Response) => Promise<Answer>} read
 * @property {AbortSignal} [signal]
 * @property {number} [patienceMs]
 */

/**
 * A path of the contract as seen from the page, which may stand behind a proxy under a path of its own.
 * @param {string} path
 */
export const beneath = (path) => path.replace(/^\//, "");

/**
 * @template Answer
 * @param {string} path
 * @param {Asked<Answer>} asked
 */
export async function answer(path, { request = {}, read, signal, patienceMs = PATIENCE_MS }) {
  const patience = new AbortController();
  const giveUp = () => patience.abort();
  const timer = setTimeout(giveUp, patienceMs);
  signal?.addEventListener("abort", giveUp);
  try {
    const response = await fetch(beneath(path), { ...request, signal: patience.signal });
    if (PASSING_STATUSES.includes(response.status)) {
      throw new Unavailable(`The service answered with status ${response.status}.`, Number(response.headers.get("Retry-After")) || null);
    }
    if (!response.ok) throw new Problem(await response.json().catch(() => ({})), response.status);
    return await read(response);
  } catch (error) {
    if (signal?.aborted || error instanceof Problem || error instanceof Unavailable) throw error;
    throw new Unavailable(patience.signal.aborted ? "The service takes too long to answer." : "The service does not answer.");
  } finally {
    clearTimeout(timer);
    signal?.removeEventListener("abort", giveUp);
  }
}

/**
 * A module of the page that is loaded when it is needed.
 * @template Module
 * @param {() => Promise<Module>} load
 */
export async function needed(load) {
  try {
    return await load();
  } catch {
    throw new Unavailable("A part of the page could not be loaded.");
  }
}

/**
 * The message of whatever was thrown.
 * @param {unknown} error
 */
export const messageOf = (error) => (error instanceof Error ? error.message : String(error));
