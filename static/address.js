// The state in the address bar and in the history.

import { queryFromState } from "./state.js";

/** Browsers refuse addresses that change too often. */
const PAUSE_MS = 250;

/** `stateNow()` gives the state to write; `onMove()` tells that the person went back or forward. */
export function createAddress(stateNow, onMove) {
  let timer = null;

  const wanted = () => location.pathname + queryFromState(stateNow());
  const isCurrent = () => wanted() === location.pathname + location.search;

  function flush() {
    clearTimeout(timer);
    if (!isCurrent()) history.replaceState(null, "", wanted());
  }

  /** A decision can be undone with the back button; the steps of a slider would only be in the way there. */
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
