// What the catalogue proposes for values that were never published, by their places in a request.

import { PRESSURE_SINKAGE, lawsOf } from "../quantities/law-fields.js";

/** @import { CatalogueSoil, CatalogueSubstitute, CatalogueWheel } from "../api/types.js" */
/** @import { Substitutes } from "../quantities/fields.js" */

/** @typedef {CatalogueWheel | CatalogueSoil} Entry */
/** @typedef {{ wheel: CatalogueWheel | undefined, soil: CatalogueSoil | undefined }} Entries */

/**
 * Whether a request has to give the value, or to allow the substitute.
 * @param {Entry} entry
 * @param {CatalogueSubstitute} substitute
 */
const isNeeded = ({ missing }, { field }) => missing.some((name) => field === name || field.startsWith(`${name}.`));

/**
 * @param {Entries} entries
 * @param {(entry: Entry, substitute: CatalogueSubstitute) => boolean} isTaken
 * @returns {Substitutes}
 */
const gathered = (entries, isTaken) => new Map(Object.entries(entries).flatMap(([place, entry]) =>
  (entry?.assumed ?? []).filter((substitute) => entry && isTaken(entry, substitute))
    .map((substitute) => [`/${place}/${substitute.field.replaceAll(".", "/")}`, substitute])));

/** Those that a request has to allow. @param {Entries} entries */
export const offeredSubstitutes = (entries) => gathered(entries, isNeeded);

/**
 * Those in force: all where the page allows them, else those that the service takes in any case.
 * @param {Entries} entries
 * @param {boolean} isAllowed
 */
export const substitutesInForce = (entries, isAllowed) => gathered(entries, (...each) => isAllowed || !isNeeded(...each));

/**
 * The law of pressure and sinkage whose parameters the substitutes are.
 * @param {Substitutes} substitutes
 */
export const substituteLaw = (substitutes) => lawsOf(PRESSURE_SINKAGE).find(({ parameters }) => {
  const own = [...substitutes].filter(([pointer]) => pointer.startsWith(PRESSURE_SINKAGE));
  return own.length && own.every(([pointer, { unit }]) => parameters.some((note) => note.pointer === pointer && note.unit === unit));
})?.name;

/** The substitutes without those of a law. @param {Substitutes} substitutes @returns {Substitutes} */
export const withoutLaw = (substitutes) => new Map([...substitutes].filter(([pointer]) => !pointer.startsWith(PRESSURE_SINKAGE)));
