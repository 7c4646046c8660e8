// Figures with a chart.

import { html } from "../dom/elements.js";
import { symbolHtml } from "../dom/text.js";

/** @import { Child } from "../dom/elements.js" */

/**
 * A name with its symbol, or a ratio of two: "F_x/W".
 * @param {string} name
 * @param {string} symbol
 * @returns {Child[]}
 */
export const titleWithSymbol = (name, symbol) =>
  [`${name} `, ...symbol.split("/").flatMap((part, index) => [...(index ? ["/"] : []), html("i", {}, ...symbolHtml(part))])];

/**
 * @param {string} id of the chart
 * @param {Child[]} title
 * @param {Child[]} content shown until the chart is drawn
 */
export const chartFigure = (id, title, ...content) => html("figure", {},
  html("figcaption", {}, html("h3", {}, ...title)),
  html("div", { class: "chart", id }, ...content));
