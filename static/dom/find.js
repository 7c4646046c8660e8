// Elements that the page cannot do without. Where one is missing the page is broken, and says which one.

/**
 * @template {Element} Kind
 * @typedef {abstract new (...args: any[]) => Kind} Constructor
 */

/**
 * @template {Element} Kind
 * @param {Element | null} element
 * @param {Constructor<Kind>} kind
 * @param {string} name
 */
function expected(element, kind, name) {
  if (element instanceof kind) return element;
  throw new Error(`${name} is not on the page as ${kind.name}`);
}

/** @param {string} id */
export const byId = (id) => expected(document.getElementById(id), HTMLElement, `#${id}`);

/** @param {string} id */
export const button = (id) => expected(document.getElementById(id), HTMLButtonElement, `#${id}`);

/**
 * The first element in `root` that matches.
 * @template {Element} [Kind=HTMLElement]
 * @param {ParentNode} root
 * @param {string} selector
 * @param {Constructor<Kind>} [kind]
 */
export const find = (root, selector, kind) =>
  expected(root.querySelector(selector), /** @type {Constructor<Kind>} */ (kind ?? HTMLElement), selector);

/**
 * All HTML elements in `root` that match.
 * @param {ParentNode} root
 * @param {string} selector
 * @returns {HTMLElement[]}
 */
export const findAll = (root, selector) => [...root.querySelectorAll(selector)].filter((element) => element instanceof HTMLElement);

/**
 * The nearest element from `inner` outwards that matches.
 * @param {Element} inner
 * @param {string} selector
 */
export const enclosing = (inner, selector) => expected(inner.closest(selector), HTMLElement, selector);
