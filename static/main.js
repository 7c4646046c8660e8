// Where the page begins. Its fields are made from the tables of the service, so these are asked for before anything else.

import { Unavailable, messageOf } from "./api/client.js";
import { loadModel } from "./api/model.js";
import { byId } from "./dom/find.js";

const FIRST_RETRY_MS = 1000;
const LAST_RETRY_MS = 15_000;

/**
 * @param {string} state
 * @param {string} text
 */
function show(state, text) {
  byId("app").dataset.state = state;
  byId("status").textContent = text;
}

/** @param {number} milliseconds */
const pause = (milliseconds) => new Promise((resolve) => { setTimeout(resolve, milliseconds); });

for (let wait = FIRST_RETRY_MS; ; wait = Math.min(LAST_RETRY_MS, 2 * wait)) {
  try {
    show("loading", "Asking the service…");
    await loadModel();
    break;
  } catch (error) {
    if (!(error instanceof Unavailable)) {
      show("offline", messageOf(error));
      throw error;
    }
    const seconds = error.retryAfterSeconds ?? wait / 1000;
    show("offline", `${error.message} Trying again in ${seconds} s.`);
    await pause(1000 * seconds);
  }
}
await import("./page.js");
