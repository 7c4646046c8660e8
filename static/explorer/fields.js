// Tables of fields.

import { html } from "../dom/elements.js";
import { columnHeads, table } from "../dom/tables.js";
import { sentenceHtml } from "../dom/text.js";

/** @import { Row } from "./contract.js" */
/** @import { Child } from "../dom/elements.js" */

/** Deeper fields are as far in as these. */
const MOST_STEPS = 4;

/** @param {string} text paragraphs, an empty line between two */
export const paragraphs = (text) => text.split(/\n\s*\n/).filter(Boolean).map((each) => html("p", {}, ...sentenceHtml(each)));

/**
 * A part that may be wider than the page, to be scrolled with the keyboard, too.
 * @param {string} label
 * @param {Child[]} children
 */
export const scrolled = (label, ...children) => html("div", { class: "scrolled", role: "region", tabindex: 0, "aria-label": label }, ...children);

/**
 * @param {string} label
 * @param {Row[]} rows
 */
export const fieldTable = (label, rows) => scrolled(label, table({ class: "fields" }, {
  heads: [html("tr", {}, ...columnHeads(["Field", "Kind", "Unit", "Bounds", "Meaning"]))],
  rows: rows.map(({ name, kind, unit, bounds, meaning, depth, required }) => html("tr", {},
    html("th", { scope: "row", "data-depth": Math.min(depth, MOST_STEPS) },
      html("code", {}, name), ...(required ? [html("span", { class: "required" }, " required")] : [])),
    html("td", {}, kind),
    html("td", {}, unit),
    html("td", {}, bounds),
    html("td", {}, ...sentenceHtml(meaning)))),
}));

/**
 * A part that is built when it is opened for the first time.
 * @param {Record<string, string>} attributes
 * @param {Child[]} summary
 * @param {() => Child[]} build
 */
export function folded(attributes, summary, build) {
  const node = html("details", attributes, html("summary", {}, ...summary));
  node.addEventListener("toggle", () => node.append(...build()), { once: true });
  return node;
}
