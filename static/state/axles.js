// The places of a rover's axles, as they are typed.

import { plainNumber } from "../numbers/plain.js";
import { MILLIMETRE } from "../quantities/units.js";

/**
 * The places (m) of the axles in a text, front first or in any order; null where it has something else than numbers.
 * @param {string} text in millimetres
 */
export function axlePlaces(text) {
  const places = text.trim().split(/[\s;]+/).map((part) => plainNumber(part));
  return places.every((place) => place !== null) ? places.map((place) => MILLIMETRE.toSi(String(place))) : null;
}
