// One round of requests at a time. While a slider moves, the round in flight finishes and the next one takes the latest
// state, so the page follows the hand and always ends on the last state. A choice of another kind ends the round in
// flight, as nobody waits for its answer any more. A round that found no service is tried again, ever less often.

import { Unavailable } from "./api.js";

const FIRST_RETRY_MS = 1000;
const LAST_RETRY_MS = 15_000;

/** `run(signal)` does one round; `onUnavailable(error, seconds)` tells that it will be tried again. */
export function createRounds({ run, onUnavailable }) {
  let inFlight = null;
  let again = false;
  let failures = 0;
  let retry = null;

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

  return { request };
}
