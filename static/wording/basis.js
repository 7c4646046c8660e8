// What results rest on beside the numbers in the fields: where the normal stress comes from, on which circles is counted, and what was
// assumed. In full beside the results, in brief in the legends of the charts.

import { quantity } from "../quantities/results.js";
import { inUnit, listed } from "./values.js";

/** @import { Forces } from "../api/types.js" */
/** @import { Settings } from "../state/settings.js" */

/** @typedef {{ key: string, text: string, brief: string }} Basis */

const SHOWN_DIGITS = 4;
/** @type {Record<string, string>} */
export const CIRCLE_NAMES = { rim: "the rim", shearing: "the shearing radius", lug_tip: "the tips of the lugs" };

/** @param {Settings} settings @param {Forces} forces @returns {Basis[]} */
function loadBasis({ given }, { normal_stress_from: from, sinkage_modulus: modulus, granular_stiffness_n_m3: stiffness }) {
  if (from !== "load") return [];
  const load = quantity("normal_force_n", given.normal_load_n);
  const found = typeof stiffness === "number" ? `a granular stiffness of ${quantity("granular_stiffness_n_m3", stiffness)}`
    : typeof modulus === "number" ? `a sinkage modulus of ${quantity("sinkage_modulus", modulus)}`
      : "the normal stress; the sinkage modulus cancels and is not needed";
  return [{ key: "load", text: `Known load: from ${load} and the sinkage follows ${found}.`, brief: `load ${load} known` }];
}

/** @param {Settings} settings @param {Forces} forces @returns {Basis[]} */
function circleBasis({ drawing: { lugHeight } }, { slip_radius: slip, shear_displacement_radius: shear }) {
  if (!(lugHeight > 0)) return [];
  // Dry grains have no shear displacement.
  const [alsoShear, briefShear] = shear === null ? ["", ""]
    : [`, the shear displacement at ${CIRCLE_NAMES[shear]}`, `, shear at ${CIRCLE_NAMES[shear]}`];
  return [{
    key: "circles",
    text: `The slip is counted at ${CIRCLE_NAMES[slip]}${alsoShear}.`,
    brief: `slip at ${CIRCLE_NAMES[slip]}${briefShear}`,
  }];
}

/** @param {Settings} settings @returns {Basis[]} */
function assumedBasis({ assumed }) {
  if (!assumed.length) return [];
  const values = assumed.map(({ field, value, reason }) => `${field.label} ${inUnit(value, field.unit, SHOWN_DIGITS)} (${reason})`);
  return [{
    key: "assumed",
    text: `Assumed, because not published: ${values.join("; ")}.`,
    brief: `assumed: ${listed(assumed.map(({ field }) => field.symbol))}`,
  }];
}

/** @param {Settings} settings @returns {Basis[]} */
const fittedBasis = ({ fitted }) => (fitted ? [{ key: "fitted", text: `The soil was fitted from ${fitted}.`, brief: `soil fitted from ${fitted}` }] : []);

/**
 * @param {Settings} settings
 * @param {Forces} forces
 */
export const basisOf = (settings, forces) => [...fittedBasis(settings), ...loadBasis(settings, forces), ...circleBasis(settings, forces), ...assumedBasis(settings)];
