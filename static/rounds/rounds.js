// One round of requests at a time. While a slider moves, the round in flight finishes and the next one takes the latest state, so that
// the page follows the hand and always ends on the last state. A single decision aborts the round in flight, whose answer is no longer
// needed. A round that does not reach the service is tried again, less and less often.

import { Unavailable } from "../api/client.js";

const FIRST_RETRY_MS = 1000;
const LAST_RETRY_MS = 15_000;

/**
 * @param {object} parts
 * @param {(signal: AbortSignal) => Promise<void>} parts.run does one round
 * @param {(error: Unavailable, seconds: number) => void} parts.onUnavailable told when the round is tried again
 */
export function createRounds({ run, onUnavailable }) {
  /** @type {AbortController | null} */
  let inFlight = null;
  let again = false;
  let failures = 0;
  let retry = 0;

  /** @param {AbortController} controller */
  async function round(controller) {
    try {
      await run(controller.signal);
      failures = 0;
    } catch (error) {
      if (controller.signal.aborted) return;
      if (!(error instanceof Unavailable)) throw error;
      const pause = error.retryAfterSeconds ? error.retryAfterSeconds * 1000 : Math.min(LAST_RETRY_MS, FIRST_RETRY_MS * 2 ** failures);
      failures += 1;
      onUnavailable(error, pause / 1000);
      retry = setTimeout(start, pause);
    }
  }

  async function start() {
    try {
      do {
        clearTimeout(retry);
        again = false;
        inFlight = new AbortController();
        await round(inFlight);
      } while (again);
    } finally {
      inFlight = null;
    }
  }

  function request({ supersede = false } = {}) {
    if (!inFlight) {
      start();
      return;
    }
    again = true;
    if (supersede) inFlight.abort();
  }

  window.addEventListener("online", () => {
    if (!inFlight && failures > 0) start();
  });

  /** Whether the round in flight is that of the latest inputs. */
  const isLatest = () => !again;

  return { request, isLatest };
}
