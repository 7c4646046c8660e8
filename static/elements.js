// Small builders for HTML and SVG nodes. Attributes never carry styles: the content security policy forbids them.

import { notation } from "./format.js";

const SVG_NAMESPACE = "http://www.w3.org/2000/svg";

function build(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== null && value !== undefined && value !== false) node.setAttribute(name, value === true ? "" : value);
  }
  node.append(...children);
  return node;
}

export const html = (name, attributes = {}, ...children) => build(document.createElement(name), attributes, children);

export const svg = (name, attributes = {}, ...children) =>
  build(document.createElementNS(SVG_NAMESPACE, name), attributes, children);

/** "F_x" as HTML nodes with a real subscript. */
export function symbolHtml(text) {
  return notation(text).map((part) => (part.subscript ? html("sub", {}, part.text) : part.text));
}

/** A sentence of the API: the names that it quotes in backticks stand as code. */
export const sentenceHtml = (text) =>
  text.split(/`([^`]*)`/).map((part, index) => (index % 2 ? html("code", {}, part) : part)).filter(Boolean);

/** A line of SVG text in which "_x" sets a subscript. */
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
