// Texts with subscripts and quoted names, as nodes.

import { html, svg } from "./elements.js";

/** @import { Attributes } from "./elements.js" */

/**
 * Splits "F_x" into its letter and its subscript.
 * @param {string} text
 */
const notation = (text) => text.split(/(_[\p{L}\p{N}])/u).filter(Boolean)
  .map((part) => (part.startsWith("_") ? { text: part.slice(1), subscript: true } : { text: part, subscript: false }));

/**
 * A symbol such as "F_x" with a real subscript.
 * @param {string} text
 */
export const symbolHtml = (text) => notation(text).map((part) => (part.subscript ? html("sub", {}, part.text) : part.text));

/**
 * A sentence whose names between backticks become code.
 * @param {string} text
 */
export const sentenceHtml = (text) =>
  text.split(/`([^`]*)`/).map((part, index) => (index % 2 ? html("code", {}, part) : part)).filter(Boolean);

/**
 * A line of SVG text in which "_x" sets a subscript.
 * @param {Attributes} attributes
 * @param {string} text
 */
export function svgText(attributes, text) {
  const node = svg("text", attributes);
  let lowered = false;
  for (const part of notation(text)) {
    const dy = part.subscript ? "0.25em" : lowered ? "-0.19em" : null;
    node.append(svg("tspan", { dy, "font-size": part.subscript ? "75%" : null }, part.text));
    lowered = part.subscript;
  }
  return node;
}
