// A soil that was found from measurements, put into the fields of the page.

import { baseText, fieldText } from "../quantities/field-values.js";
import { FIELDS } from "../quantities/fields.js";
import { lawIn } from "../quantities/law-fields.js";
import { activeGroups, contextOf } from "./preset.js";
import { changed } from "./choices.js";

/** @import { Catalogue, Identification } from "../api/types.js" */
/** @import { Field } from "../quantities/fields.js" */
/** @import { Changes, State } from "./choices.js" */

/** @typedef {Pick<Identification, "soil" | "contact">} Found */

/** @param {Field} field */
const isOfSoil = ({ pointer }) => pointer.startsWith("/soil/") || pointer.startsWith("/contact/");

export const SOIL_FIELDS = FIELDS.filter(isOfSoil);

/**
 * The number that the answer has for a field, or null.
 * @param {Field} field
 * @param {Found} found
 */
export function foundValue({ pointer }, { soil, contact }) {
  /** @type {any} */
  let part = { soil, contact };
  for (const name of pointer.slice(1).split("/")) part = part?.[name];
  return typeof part === "number" ? part : null;
}

const OF_SOIL = [...SOIL_FIELDS.map(({ key }) => key), "soil", "law", "shear", "rule", "exit", "assume"];

/**
 * A soil that is changed by hand is no longer the one that was fitted.
 * @param {State} before
 * @param {State} after
 */
export const withOwnName = (before, after) =>
  (after.fitted !== "" && after.fitted === before.fitted && OF_SOIL.some((key) => before[key] !== after[key]) ? changed(after, { fitted: "" }) : after);

/**
 * The changes that make the soil and the contact those of the page.
 * @param {Found & { file: string }} found and the file that it was fitted from
 * @param {State} state
 * @param {Catalogue} catalogue
 */
export function changesFor({ file, ...found }, state, catalogue) {
  const { followedLaw, followedShear, followedRule } = contextOf(state, catalogue);
  /** @param {string | null | undefined} value @param {string} followed */
  const unless = (value, followed) => (value === followed ? null : value ?? null);
  /** @type {Changes} */
  const changes = {
    law: unless(lawIn(found.soil.pressure_sinkage), followedLaw),
    shear: unless(lawIn(found.soil.shear) ?? "janosi_hanamoto", followedShear),
    rule: unless(found.contact.rule, followedRule),
    fitted: file,
  };
  const next = changed(state, changes);
  const context = contextOf(next, catalogue);
  const groups = activeGroups(next, context);
  for (const field of SOIL_FIELDS) {
    const value = groups.has(field.group) ? foundValue(field, found) : null;
    changes[field.key] = unless(value === null ? null : fieldText(field, value), baseText(field, context));
  }
  return changes;
}
