// The catalogue on the page: the lists of wheels and soils, and where the values of the chosen ones come from.

import { html } from "../dom/elements.js";
import { find } from "../dom/find.js";
import { columnHeads, rowHead, table } from "../dom/tables.js";
import { capitalised } from "../numbers/format.js";
import { fieldText, siFromText } from "../quantities/field-values.js";
import { FIELDS, fieldNamed } from "../quantities/fields.js";

/** @import { CatalogueSoil, CatalogueValue, CatalogueWheel } from "../api/types.js" */
/** @import { State } from "../state/choices.js" */
/** @import { Context } from "../state/preset.js" */

/** @typedef {CatalogueWheel | CatalogueSoil} Entry */

/** @type {Record<string, string>} */
const KIND_NAMES = { paper: "From a paper", flight: "Flight wheels", test: "Test wheels" };
/**
 * By the ends of the API's names.
 * @type {Record<string, string>}
 */
const UNITS = { _n_m3: "N/m³", _pa: "Pa", _rad: "rad", _n: "N", _m: "m" };
const SHOWN_DIGITS = 6;
const LOAD = fieldNamed("normal_load");

/** @param {string} name */
const unitSuffix = (name) => Object.keys(UNITS).find((suffix) => name.endsWith(suffix)) ?? "";

/**
 * The name of a catalogue value in words: the label of its field, or else the API's name without the unit.
 * @param {string} name
 */
function valueName(name) {
  if (name === "pressure_sinkage") return "Pressure–sinkage moduli";
  // The interface of rim and soil has names of the soil, but the catalogue has no value for it.
  const field = FIELDS.find(({ pointer, group }) => group !== "interface" && pointer.endsWith(`/${name}`));
  return field ? field.label : capitalised(name.slice(0, name.length - unitSuffix(name).length).replaceAll("_", " "));
}

/** @param {string[]} names */
const listed = (names) => names.map((name) => valueName(name).toLowerCase()).join(", ");

/**
 * Grouped by kind, where an entry has one. What an entry lacks is told before it is chosen.
 * @param {HTMLSelectElement} select
 * @param {Iterable<Entry>} entries
 */
export function fillPresets(select, entries) {
  /** @type {Map<string, HTMLOptGroupElement>} */
  const kinds = new Map();
  const ungrouped = [];
  for (const { id, name, kind, missing } of entries) {
    const lacking = missing.length ? ` (lacks ${listed(missing)})` : "";
    const option = html("option", { value: id }, name + lacking);
    if (!kind) {
      ungrouped.push(option);
      continue;
    }
    const group = kinds.get(kind) ?? html("optgroup", { label: KIND_NAMES[kind] ?? capitalised(kind) });
    kinds.set(kind, group);
    group.append(option);
  }
  select.replaceChildren(...ungrouped, ...kinds.values());
}

/**
 * A value's own source and grade are told where they are not the entry's.
 * @param {Entry} entry
 * @param {string} name
 * @param {CatalogueValue} given
 */
function valueRow(entry, name, { value, published, source, grade, note }) {
  const ownSource = source !== entry.source && source;
  const ownGrade = grade && grade !== entry.grade && `Grade: ${grade}`;
  const shown = [Number(value.toPrecision(SHOWN_DIGITS)), UNITS[unitSuffix(name)]].filter((part) => part !== undefined).join("\u00a0");
  return html("tr", {},
    rowHead(valueName(name)),
    html("td", {}, shown),
    html("td", {}, [published, ownSource, ownGrade, note].filter(Boolean).join(". ")));
}

/** @param {Entry} entry */
const valuesTable = (entry) => table({ class: "values" }, {
  heads: [html("tr", {}, ...columnHeads(["Value", "In SI", "As published"]))],
  rows: Object.entries(entry.values).map(([name, given]) => valueRow(entry, name, given)),
});

/** @param {Entry} entry */
const gradeBadge = ({ grade }) => (grade ? [html("span", { class: "grade" }, `Grade: ${grade}`), " "] : []);

/** @param {Entry} entry */
const gaps = ({ missing }) => (missing.length ? [html("p", { class: "gaps" }, `Not in the catalogue: ${listed(missing)}.`)] : []);

/**
 * Shows an entry in an element once, and nothing for one that the catalogue does not have.
 * @param {HTMLElement} element
 * @param {Entry | undefined} entry
 * @param {(entry: Entry) => Node[]} content
 */
function showOnce(element, entry, content) {
  const id = entry?.id ?? "";
  if (element.dataset.entry === id) return;
  element.dataset.entry = id;
  element.replaceChildren(...(entry ? content(entry) : []));
}

/**
 * Beside the list: how good the entry is and what it lacks, with the way to the rest.
 * @param {HTMLElement} element
 * @param {Entry | undefined} entry
 * @param {string} originId
 */
export const showGrade = (element, entry, originId) => showOnce(element, entry, (shown) =>
  [html("p", {}, ...gradeBadge(shown), html("a", { href: `#${originId}` }, "Source and notes")), ...gaps(shown)]);

/**
 * Source, note, and every value with its origin.
 * @param {HTMLElement} element
 * @param {Entry | undefined} entry
 */
export const showOrigin = (element, entry) => showOnce(element, entry, (shown) => [
  html("h3", {}, shown.name),
  html("p", {}, ...gradeBadge(shown), shown.source),
  ...(shown.note ? [html("p", { class: "note" }, shown.note)] : []),
  ...gaps(shown),
  valuesTable(shown),
]);

/**
 * Offers the load that the catalogue has for the wheel, unless it is set already.
 * @param {HTMLElement} element
 * @param {State} state
 * @param {Context} context
 */
export function showNominalLoad(element, state, { wheel }) {
  const nominal = wheel?.values.nominal_load_n?.value;
  const typed = state[LOAD.key];
  const isSet = state.by === "load" && (typed === null || siFromText(LOAD, typed) === nominal);
  element.hidden = nominal === undefined || isSet;
  if (nominal === undefined) return;
  const text = `${fieldText(LOAD, nominal)}\u00a0${LOAD.unit.text}`;
  find(element, "span").textContent = `Published load of this wheel: ${text}. `;
  find(element, "button").textContent = `Use ${text}`;
}
