// The catalogue on the page: the lists of wheels and soils, and where the values of the chosen ones come from.

import { html } from "./elements.js";
import { FIELDS, fieldText } from "./fields.js";
import { siFromText } from "./typed.js";

const KIND_NAMES = { paper: "From a paper", flight: "Flight wheels", test: "Test wheels" };
const UNITS = { _n_m3: "N/m³", _pa: "Pa", _rad: "rad", _n: "N", _m: "m" };
const SHOWN_DIGITS = 6;

const sentenceCase = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/** The name of a catalogue value in words: the field's label if the page has one, else its API name without the unit. */
function valueName(name) {
  if (name === "pressure_sinkage") return "Pressure–sinkage moduli";
  const field = FIELDS.find(({ pointer }) => pointer.endsWith(`/${name}`));
  return field ? field.label : sentenceCase(name.slice(0, name.length - unitSuffix(name).length).replaceAll("_", " "));
}

const unitSuffix = (name) => Object.keys(UNITS).find((suffix) => name.endsWith(suffix)) ?? "";

/** Grouped by kind, where an entry has one. What an entry lacks is told before it is chosen. */
export function fillPresets(select, entries) {
  const kinds = new Map();
  const ungrouped = [];
  for (const entry of entries) {
    const { id, name, kind, missing = [] } = entry;
    const lacking = missing.length ? ` (lacks ${missing.map((value) => valueName(value).toLowerCase()).join(", ")})` : "";
    const option = html("option", { value: id }, name + lacking);
    if (!kind) {
      ungrouped.push(option);
      continue;
    }
    if (!kinds.has(kind)) kinds.set(kind, html("optgroup", { label: KIND_NAMES[kind] ?? sentenceCase(kind) }));
    kinds.get(kind).append(option);
  }
  select.replaceChildren(...ungrouped, ...kinds.values());
}

/** A value's own source and grade are told where they are not the entry's. */
function valuesTable(entry) {
  const rows = Object.entries(entry.values).map(([name, { value, published, source, grade, note }]) => {
    const ownSource = source !== entry.source && source;
    const ownGrade = grade && grade !== entry.grade && `Grade: ${grade}`;
    const shown = [Number(value.toPrecision(SHOWN_DIGITS)), UNITS[unitSuffix(name)]].filter((part) => part !== undefined).join("\u00a0");
    return html("tr", {},
      html("th", { scope: "row" }, valueName(name)),
      html("td", {}, shown),
      html("td", {}, [published, ownSource, ownGrade, note].filter(Boolean).join(". ")));
  });
  return html("table", { class: "values" },
    html("thead", {}, html("tr", {}, ...["Value", "In SI", "As published"].map((text) => html("th", { scope: "col" }, text)))),
    html("tbody", {}, ...rows));
}

const gradeBadge = (entry) => (entry.grade ? [html("span", { class: "grade" }, `Grade: ${entry.grade}`), " "] : []);

function gaps(entry) {
  if (!entry.missing?.length) return [];
  return [html("p", { class: "gaps" }, `Not in the catalogue: ${entry.missing.map((name) => valueName(name).toLowerCase()).join(", ")}.`)];
}

/** True once for each entry that comes to an element; nothing is shown for an entry the catalogue does not have. */
function isNew(element, entry) {
  const id = entry?.id ?? "";
  if (element.dataset.entry === id) return false;
  element.dataset.entry = id;
  if (!entry) element.replaceChildren();
  return Boolean(entry);
}

/** Beside the list: how good the entry is and what it lacks, with the way to the rest. */
export function showGrade(element, entry, originId) {
  if (!isNew(element, entry)) return;
  element.replaceChildren(html("p", {}, ...gradeBadge(entry), html("a", { href: `#${originId}` }, "Source and notes")), ...gaps(entry));
}

const LOAD = FIELDS.find(({ name }) => name === "normal_load");

/** Offers the load that the catalogue has for the wheel, unless it is the one that is set. */
export function showNominalLoad(element, state, { wheel }) {
  const nominal = wheel?.values.nominal_load_n?.value ?? null;
  const isSet = state.by === "load" && (state[LOAD.key] === null || siFromText(LOAD, state[LOAD.key]) === nominal);
  element.hidden = nominal === null || isSet;
  if (nominal === null) return;
  const text = `${fieldText(LOAD, nominal)}\u00a0${LOAD.unit.text}`;
  element.querySelector("span").textContent = `Published load of this wheel: ${text}. `;
  element.querySelector("button").textContent = `Use ${text}`;
}

/** Source, note and every value with where it comes from. */
export function showOrigin(element, entry) {
  if (!isNew(element, entry)) return;
  element.replaceChildren(
    html("h3", {}, entry.name),
    html("p", {}, ...gradeBadge(entry), entry.source),
    ...(entry.note ? [html("p", { class: "note" }, entry.note)] : []),
    ...gaps(entry),
    valuesTable(entry));
}
