// Lists of warnings.

import { html } from "../dom/elements.js";
import { sentenceHtml } from "../dom/text.js";

/** @typedef {{ code: string, text: string, methods?: string[] }} ListedWarning */

/**
 * @param {HTMLElement} list
 * @param {ListedWarning[]} warnings
 */
export function showWarnings(list, warnings) {
  list.replaceChildren(...warnings.map(({ code, text, methods = [] }) => html("li", { "data-warning": code },
    ...sentenceHtml(text),
    ...(methods.length ? [" ", html("span", { class: "about" }, `(${methods.join(", ")})`)] : []))));
  list.hidden = warnings.length === 0;
}

/**
 * On a narrow page the warnings come below the controls, so the results at its top lead there.
 * @param {HTMLElement} link
 * @param {ListedWarning[]} warnings
 */
export function showWarningsLink(link, { length }) {
  link.textContent = length === 1 ? "1 warning about these results" : `${length} warnings about these results`;
  link.hidden = length === 0;
}
