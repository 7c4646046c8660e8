// Where the faults of a request are shown in the form.

import { enclosing, find } from "../dom/find.js";
import { sentenceHtml } from "../dom/text.js";
import { faultText } from "../wording/faults.js";

/** @import { Field } from "../quantities/fields.js" */
/** @import { TypingFault } from "../state/settings.js" */
/** @import { Fault } from "../wording/faults.js" */

/** @typedef {Fault | TypingFault} ShownFault */
/** @typedef {{ pointer: string, text: string, input: HTMLInputElement | HTMLSelectElement | null }} PlacedFault with the input it is shown at, if any */

/**
 * An input with the place for its faults.
 * @typedef {object} FaultPlace
 * @property {string} pointer
 * @property {HTMLInputElement | HTMLSelectElement} input
 * @property {HTMLElement} fault
 * @property {Field} [field] absent for a choice, which takes the faults below its pointer as well
 */

/**
 * The place of a pointer: its own field if that is shown now, or else the nearest choice above it.
 * @param {FaultPlace[]} places
 * @param {string} pointer
 */
function placeOf(places, pointer) {
  const own = places.find((place) => place.field && place.pointer === pointer && !place.input.closest("[data-fields]")?.hasAttribute("hidden"));
  if (own) return own;
  const above = places.filter((place) => !place.field && (pointer === place.pointer || pointer.startsWith(`${place.pointer}/`)));
  return above.sort((a, b) => b.pointer.length - a.pointer.length)[0] ?? null;
}

/**
 * @param {FaultPlace} place
 * @param {string} text empty where there is none
 */
function showAt({ input, fault }, text) {
  const group = input.closest("details");
  if (text && fault.hidden && group) group.open = true;
  if (fault.textContent !== text.replaceAll("`", "")) fault.replaceChildren(...sentenceHtml(text));
  fault.hidden = !text;
  if (text) input.setAttribute("aria-invalid", "true");
  else input.removeAttribute("aria-invalid");
}

/**
 * The place for the faults of a choice.
 * @param {HTMLSelectElement} select
 * @param {string} pointer
 * @returns {FaultPlace}
 */
export const choicePlace = (select, pointer) => ({ pointer, input: select, fault: find(enclosing(select, ".choice"), ".fault") });

/**
 * Shows each fault at its input, and opens the group that it is in.
 * @param {FaultPlace[]} places
 * @param {ShownFault[]} faults
 * @returns {PlacedFault[]}
 */
export function showFaultsAt(places, faults) {
  /** @type {Map<FaultPlace, string[]>} */
  const texts = new Map();
  const placed = faults.map((fault) => {
    const place = placeOf(places, fault.pointer);
    const text = "local" in fault ? fault.detail : faultText(fault, place?.field);
    if (place) texts.set(place, [...(texts.get(place) ?? []), text]);
    return { pointer: fault.pointer, text, input: place?.input ?? null };
  });
  for (const place of places) showAt(place, (texts.get(place) ?? []).join(" "));
  return placed;
}
