// Formulas as the API writes them, set with subscripts and powers.

import { html } from "../dom/elements.js";

/** F_x and k_phi, θ1 and n0, θm and σm are letters with subscripts; ^N and ^(n+1) are powers. */
const MATHS = /(?<![\p{L}\p{N}])(\p{L})_(\p{L}+)|(?<![\p{L}\p{N}])([θnzcλ])(\d)(?!\d)|([θστz])_?(m)(?![\p{L}])|\^(\p{L}|\([^)]*\))/gu;

/** @param {string} text */
function formulaHtml(text) {
  /** @type {(Node | string)[]} */
  const nodes = [];
  let end = 0;
  for (const match of text.matchAll(MATHS)) {
    const [whole, named, name, indexed, index, peaked, peak, power] = match;
    nodes.push(text.slice(end, match.index));
    if (power) nodes.push(html("sup", {}, power.replace(/^\((.*)\)$/, "$1")));
    else nodes.push(named ?? indexed ?? peaked, html("sub", {}, name ?? index ?? peak));
    end = match.index + whole.length;
  }
  return [...nodes, text.slice(end)].filter((node) => node !== "");
}

/**
 * A text with formulas, and with names of the API between backticks.
 * @param {string | null | undefined} text
 */
export const maths = (text) =>
  (text ?? "").split(/`([^`]*)`/).flatMap((part, index) => (index % 2 ? [html("code", {}, part)] : formulaHtml(part)));
