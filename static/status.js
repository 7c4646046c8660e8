// The line that says whether the results match the inputs, and if not, why.

import { html, sentenceHtml } from "./elements.js";
import { faultOf } from "./wording.js";

/** Each fault behind the name of its input, which leads there: the input may be scrolled out of sight. */
function describedFault({ pointer, text, input }) {
  if (!input) return html("span", {}, ...sentenceHtml(faultOf(pointer, text)));
  const label = input.labels[0].textContent.trim();
  return html("span", {}, html("a", { href: `#${input.id}` }, label), ...sentenceHtml(faultOf(label, text).slice(label.length)));
}

/** `app` carries the state for style sheet and tests, `line` the words. */
export function createStatus(app, line) {
  let hasResults = false;
  const staleNote = () => (hasResults ? ["Dimmed results are the last good ones."] : []);

  function show(state, content) {
    const next = html("p", {}, ...content);
    // An unchanged line is left alone, or screen readers would repeat it.
    if (line.innerHTML !== next.innerHTML) line.replaceChildren(...next.childNodes);
    app.dataset.state = state;
  }

  return {
    loading: () => show("loading", ["Asking the service…"]),
    ready() {
      hasResults = true;
      show("ready", ["Results match the inputs."]);
    },
    /** `placed`: faults with the input each is shown at, or null. */
    faults: (placed) => show("fault", [...placed.map(describedFault), ...staleNote()]),
    offline: (error, seconds) => show("offline", [`${error.message} Trying again in ${Math.round(seconds)} s. `, ...staleNote()]),
  };
}
