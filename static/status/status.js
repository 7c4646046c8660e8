// The line that says whether the results match the inputs, and if not, why.

import { html } from "../dom/elements.js";
import { sentenceHtml } from "../dom/text.js";
import { about } from "../wording/faults.js";

/** @import { Child } from "../dom/elements.js" */
/** @import { PlacedFault } from "../controls/faults.js" */

/**
 * A fault behind the name of its input, which leads there: the input may be scrolled out of sight.
 * @param {PlacedFault} fault
 */
function describedFault({ pointer, text, input }) {
  if (!input) return html("span", {}, ...sentenceHtml(about(pointer, text)));
  const label = input.labels?.[0].textContent?.trim() ?? "";
  return html("span", {}, html("a", { href: `#${input.id}` }, label), ...sentenceHtml(about(label, text).slice(label.length)));
}

/**
 * @param {HTMLElement} app carries the state for style sheet and tests
 * @param {HTMLElement} line
 */
export function createStatus(app, line) {
  let hasResults = false;
  const staleNote = () => (hasResults ? ["Dimmed results are the last good ones."] : []);

  /**
   * @param {string} state
   * @param {Child[]} content
   */
  function show(state, content) {
    const next = html("p", {}, ...content);
    // An unchanged line is left alone, or screen readers would repeat it.
    if (line.innerHTML !== next.innerHTML) line.replaceChildren(...next.childNodes);
    app.dataset.state = state;
  }

  return {
    loading: () => show("loading", ["Asking the service…"]),
    /** The inputs have changed: what is shown is not yet the answer to them. */
    pending: () => show("loading", hasResults ? ["Asking the service… What is shown belongs to the inputs before."] : ["Asking the service…"]),
    ready() {
      hasResults = true;
      show("ready", ["Results match the inputs."]);
    },
    /** @param {PlacedFault[]} faults */
    faults: (faults) => show("fault", [...faults.map(describedFault), ...staleNote()]),
    /** @param {Error} error @param {number} seconds until the next try */
    offline: (error, seconds) => show("offline", [`${error.message} Trying again in ${Math.round(seconds)} s. `, ...staleNote()]),
  };
}
