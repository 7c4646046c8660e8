// The results of the chosen method: as tiles, and spoken.

import { titleWithSymbol } from "../charts/figure.js";
import { html } from "../dom/elements.js";
import { enclosing, findAll } from "../dom/find.js";
import { sentenceHtml } from "../dom/text.js";
import { QUANTITIES, quantity } from "../quantities/results.js";

/** @import { Forces } from "../api/types.js" */
/** @import { Basis } from "../wording/basis.js" */

/** @type {("longitudinal_force_n" | "normal_force_n" | "torque_n_m" | "sinkage_m")[]} */
export const MAIN_RESULTS = ["longitudinal_force_n", "normal_force_n", "torque_n_m", "sinkage_m"];

/**
 * The parts of the forces and what they are computed with. Optional ones are hidden where the answer does not have them.
 * @type {{ name: string, symbol?: string, isOptional?: boolean }[]}
 */
const PARTS = [
  { name: "traction_n" },
  { name: "resistance_n" },
  { name: "normal_support_n" },
  { name: "shear_support_n" },
  { name: "lateral_force_n", symbol: "F_y", isOptional: true },
  { name: "overturning_moment_n_m", isOptional: true },
  { name: "aligning_moment_n_m", isOptional: true },
  { name: "sinkage_modulus", symbol: "K_s" },
  { name: "granular_stiffness_n_m3", symbol: "ξ", isOptional: true },
  { name: "sinkage_exponent", symbol: "N" },
  { name: "shearing_radius_m", symbol: "r_s" },
];

/** Long enough that a moving slider is not read aloud at every step. */
const SPEECH_PAUSE_MS = 900;

/** @param {HTMLElement} list */
export function fillParts(list) {
  list.append(...PARTS.map(({ name, symbol, isOptional = false }) => html("div", { "data-optional": isOptional, hidden: isOptional },
    html("dt", {}, ...(symbol ? titleWithSymbol(QUANTITIES[name].name, symbol) : [QUANTITIES[name].name])),
    html("dd", { "data-result": name }, "–"))));
}

/**
 * @param {HTMLElement} root
 * @param {Forces} forces
 */
export function showTiles(root, forces) {
  const results = /** @type {Record<string, any>} */ ({ ...forces, ...forces.components });
  for (const tile of findAll(root, "[data-result]")) {
    const name = tile.dataset.result ?? "";
    const value = /** @type {number | null | undefined} */ (results[name]);
    tile.textContent = quantity(name, value);
    tile.dataset.value = String(value ?? "");
    tile.title = value === null ? "Not defined at this operating point" : "";
    if (tile.closest("[data-optional]")) enclosing(tile, "[data-optional]").hidden = value === undefined || (value === null && name === "granular_stiffness_n_m3");
  }
}

/**
 * @param {HTMLElement} list
 * @param {Basis[]} basis
 */
export function showBasis(list, basis) {
  list.replaceChildren(...basis.map(({ key, text }) => html("li", { "data-basis": key }, ...sentenceHtml(text))));
  list.hidden = basis.length === 0;
}

/** @param {HTMLElement} element */
export function createAnnouncer(element) {
  let timer = 0;
  /** @param {Forces} forces */
  return (forces) => {
    clearTimeout(timer);
    timer = setTimeout(() => {
      element.textContent = MAIN_RESULTS.map((name) => `${QUANTITIES[name].name} ${quantity(name, forces[name])}`).join(", ");
    }, SPEECH_PAUSE_MS);
  };
}
