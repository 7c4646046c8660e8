// A request with what came of it.

import { Problem } from "../api/client.js";
import { post } from "../api/endpoints.js";

/** @import { Drawn } from "../api/endpoints.js" */

/**
 * An answer or a problem, with the request.
 * @template Answer
 * @typedef {{ path: string, body: object, answer: Answer, problem?: undefined } | { path: string, body: object, answer?: undefined, problem: Problem }} Outcome
 */

/**
 * A problem is an outcome like an answer. Only a missing answer ends the round.
 * @template {keyof Drawn} Path
 * @param {Path} path
 * @param {Drawn[Path]["body"]} body
 * @param {AbortSignal} signal
 * @returns {Promise<Outcome<Drawn[Path]["answer"]>>}
 */
export async function outcomeOf(path, body, signal) {
  try {
    return { path, body, answer: await post(path, body, signal) };
  } catch (error) {
    if (error instanceof Problem) return { path, body, problem: error };
    throw error;
  }
}
