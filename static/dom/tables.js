// Parts of tables that several sections build.

import { html } from "./elements.js";

/** @import { Attributes, Child } from "./elements.js" */

/**
 * Heading cells of columns.
 * @param {string[]} texts
 * @param {Attributes} attributes
 */
export const columnHeads = (texts, attributes = {}) => texts.map((text) => html("th", { scope: "col", ...attributes }, text));

/** @param {Child[]} children */
export const rowHead = (...children) => html("th", { scope: "row" }, ...children);

/**
 * @param {Attributes} attributes
 * @param {{ caption?: string, heads: HTMLTableRowElement[], rows: HTMLTableRowElement[] }} parts
 */
export const table = (attributes, { caption, heads, rows }) => html("table", attributes,
  ...(caption ? [html("caption", {}, caption)] : []),
  html("thead", {}, ...heads),
  html("tbody", {}, ...rows));
