// Something long that the service does on demand, from a form: its states, its button, cancelling it, and how long it has been going on.

import { Problem, messageOf } from "../api/client.js";
import { html } from "../dom/elements.js";
import { sentenceHtml } from "../dom/text.js";
import { faultSentence } from "../wording/faults.js";

/** @import { Fault } from "../wording/faults.js" */

/**
 * @typedef {object} SearchForm
 * @property {HTMLElement} form has the state in data-state: idle, failed, or one of the next two
 * @property {string} running
 * @property {string} done
 * @property {HTMLElement} status
 * @property {HTMLElement[]} results hidden until there is an answer
 * @property {SearchControls} controls
 */

/**
 * @template Answer
 * @typedef {object} Search
 * @property {string} text said meanwhile
 * @property {(signal: AbortSignal) => Promise<Answer>} ask
 * @property {(answer: Answer) => void} onAnswer not called for a search that was cancelled
 * @property {(fault: Fault) => string | null} subjectOf what a fault is about
 */

/** @typedef {ReturnType<typeof searchControls>} SearchControls */

export const UNREADABLE_INPUTS = "Correct the marked inputs first.";

/**
 * The button that starts a search, and what is shown while it runs.
 * @param {{ start: string, cancel: string, progress: string, elapsed: string }} ids
 * @param {string} startText
 * @param {string} progressText for screen readers
 */
export function searchControls(ids, startText, progressText) {
  const start = html("button", { type: "submit", id: ids.start, class: "main" }, startText);
  const cancel = html("button", { type: "button", id: ids.cancel, hidden: true }, "Cancel");
  const progress = html("progress", { id: ids.progress, "aria-label": progressText, hidden: true });
  const elapsed = html("span", { id: ids.elapsed, hidden: true });
  return { start, cancel, progress, elapsed, row: html("div", { class: "fit-actions" }, start, cancel, progress, elapsed) };
}

/** @param {SearchForm} parts */
export function createSearch({ form, running, done, status, results, controls: { start, cancel, progress, elapsed } }) {
  /** @type {AbortController | null} */
  let current = null;

  /** @param {boolean} isRunning */
  function showRunning(isRunning) {
    for (const element of [cancel, progress, elapsed]) element.hidden = !isRunning;
    start.disabled = isRunning;
  }

  function stop() {
    current?.abort();
    current = null;
    showRunning(false);
  }

  function forget() {
    stop();
    form.dataset.state = "idle";
    status.textContent = "";
    for (const element of results) element.hidden = true;
  }

  /** @param {string[]} reasons */
  function fail(...reasons) {
    form.dataset.state = "failed";
    status.replaceChildren(...reasons.map((reason) => html("span", { class: "fault" }, ...sentenceHtml(reason), " ")));
  }

  /**
   * @template Answer
   * @param {Search<Answer>} search
   */
  async function run({ text, ask, onAnswer, subjectOf }) {
    forget();
    status.textContent = text;
    form.dataset.state = running;
    const mine = new AbortController();
    current = mine;
    const began = performance.now();
    const tell = () => { elapsed.textContent = `${Math.round((performance.now() - began) / 1000)} s`; };
    const clock = setInterval(tell, 1000);
    tell();
    showRunning(true);
    try {
      const answer = await ask(mine.signal);
      if (mine.signal.aborted) return;
      form.dataset.state = done;
      onAnswer(answer);
    } catch (error) {
      if (mine.signal.aborted) return;
      if (error instanceof Problem) fail(...error.faults.map((fault) => faultSentence(fault, subjectOf(fault))));
      else fail(messageOf(error));
    } finally {
      clearInterval(clock);
      if (current === mine) stop();
    }
  }

  cancel.addEventListener("click", () => {
    forget();
    status.textContent = "Cancelled.";
    start.focus();
  });

  return { forget, fail, run };
}

/**
 * @param {HTMLElement} form
 * @param {() => void} run
 */
export function onSubmit(form, run) {
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    run();
  });
}
