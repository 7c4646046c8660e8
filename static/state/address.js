// The state in the address bar and in the history.

import { queryFromState } from "./choices.js";

/** @import { State } from "./choices.js" */

/** Browsers refuse addresses that change too often. */
const PAUSE_MS = 250;

/**
 * @param {() => State} stateNow the state to write
 * @param {() => void} onMove called after a step back or forward
 */
export function createAddress(stateNow, onMove) {
  let timer = 0;

  const wanted = () => location.pathname + queryFromState(stateNow());
  const isCurrent = () => wanted() === location.pathname + location.search;

  function flush() {
    clearTimeout(timer);
    if (!isCurrent()) history.replaceState(null, "", wanted());
  }

  /**
   * A decision can be undone with the back button. The steps of a slider would only stand in its way.
   * @param {{ discrete: boolean }} how
   */
  function write({ discrete }) {
    clearTimeout(timer);
    if (isCurrent()) return;
    if (discrete) history.pushState(null, "", wanted());
    else timer = setTimeout(flush, PAUSE_MS);
  }

  window.addEventListener("popstate", () => {
    clearTimeout(timer);
    onMove();
  });
  window.addEventListener("pagehide", flush);

  return { write, flush };
}
