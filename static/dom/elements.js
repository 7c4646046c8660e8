// Builders of HTML and SVG nodes. Attributes carry no styles: the content security policy forbids them.

/** @typedef {Record<string, string | number | boolean | null | undefined>} Attributes */
/** @typedef {Node | string} Child */

const SVG_NAMESPACE = "http://www.w3.org/2000/svg";

/**
 * @template {Element} Node
 * @param {Node} node
 * @param {Attributes} attributes null, undefined and false leave an attribute out
 * @param {Child[]} children
 */
function build(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== null && value !== undefined && value !== false) node.setAttribute(name, value === true ? "" : String(value));
  }
  node.append(...children);
  return node;
}

/**
 * @template {keyof HTMLElementTagNameMap} Name
 * @param {Name} name
 * @param {Attributes} attributes
 * @param {Child[]} children
 */
export const html = (name, attributes = {}, ...children) => build(document.createElement(name), attributes, children);

/**
 * @template {keyof SVGElementTagNameMap} Name
 * @param {Name} name
 * @param {Attributes} attributes
 * @param {Child[]} children
 */
export const svg = (name, attributes = {}, ...children) => build(document.createElementNS(SVG_NAMESPACE, name), attributes, children);
