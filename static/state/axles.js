// The axles of a rover, as they are typed.

import { plainNumber } from "../numbers/plain.js";
import { MILLIMETRE, NEWTON_METRE, PERCENT } from "../quantities/units.js";

/** @import { Unit } from "../quantities/units.js" */

/** An axle at its place (m), with what its wheels do that the others do not. @typedef {{ place: number, own: { slip?: number, torque_n_m?: number } }} Axle */

const AXLE = /^([^@]+)(?:@(.+?)(%|n·?m))?$/i;

/**
 * @param {string | undefined} text
 * @param {Unit} unit
 */
function valueIn(text, unit) {
  const plain = text === undefined ? null : plainNumber(text);
  return plain === null ? null : unit.toSi(plain);
}

/** @param {string} text @returns {Axle | null} */
function axleIn(text) {
  const [, at, own, unit] = AXLE.exec(text) ?? [];
  const place = valueIn(at, MILLIMETRE);
  if (place === null) return null;
  if (own === undefined) return { place, own: {} };
  const value = valueIn(own, unit === "%" ? PERCENT : NEWTON_METRE);
  if (value === null) return null;
  return { place, own: unit === "%" ? { slip: value } : { torque_n_m: value } };
}

/**
 * The axles in a text, front first or in any order: each its place in millimetres, and behind an @ a slip (%) or a torque (Nm) of its
 * own. Null where the text has anything else.
 * @param {string} text
 */
export function axlesIn(text) {
  const axles = text.trim().split(/[\s;]+/).map(axleIn);
  return axles.every((axle) => axle !== null) ? axles : null;
}
