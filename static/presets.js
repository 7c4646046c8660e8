// The catalogue on the page: the lists of wheels and soils, and where the chosen entry's values come from.

import { html } from "./elements.js";

const KIND_NAMES = {
  letter: "Reference example", paper: "From papers", flight: "Flight wheels", test: "Test wheels", terrestrial: "Terrestrial",
  lunar: "Lunar", simulant_lunar: "Lunar simulants", martian: "Martian", simulant_martian: "Martian simulants",
  test_bed_sand: "Test-bed sands", snow: "Snow", synthetic: "Simulator defaults",
};

const kindName = (kind) => KIND_NAMES[kind] ?? kind.charAt(0).toUpperCase() + kind.slice(1).replaceAll("_", " ");

/** "friction_angle_rad" as words; the unit goes behind the value. */
const UNITS = { _n_m3: "N/m³", _pa: "Pa", _rad: "rad", _n: "N", _m: "m" };

function nameAndUnit(field) {
  const suffix = Object.keys(UNITS).find((candidate) => field.endsWith(candidate)) ?? "";
  return { name: field.slice(0, field.length - suffix.length).replaceAll("_", " "), unit: UNITS[suffix] ?? "" };
}

export function fillPresets(select, entries) {
  const kinds = new Map();
  for (const entry of entries) {
    if (!kinds.has(entry.kind)) kinds.set(entry.kind, html("optgroup", { label: kindName(entry.kind) }));
    kinds.get(entry.kind).append(html("option", { value: entry.id }, entry.name));
  }
  select.replaceChildren(...kinds.values());
}

function valuesTable(entry) {
  const rows = Object.entries(entry.values ?? {}).map(([field, { value, published, source, grade }]) => {
    const { name, unit } = nameAndUnit(field);
    const origin = [published && `as published: ${published}`, source !== entry.source && source].filter(Boolean).join("; ");
    return html("tr", {},
      html("th", { scope: "row" }, name),
      html("td", {}, `${value} ${unit}`.trim()),
      html("td", {}, grade ?? ""),
      html("td", {}, origin));
  });
  return html("table", { class: "values" },
    html("thead", {}, html("tr", {}, ...["Value", "SI", "Grade", "Origin"].map((text) => html("th", { scope: "col" }, text)))),
    html("tbody", {}, ...rows));
}

/** Source, grade, note and the entry's gaps; nothing for an entry the catalogue does not have. */
export function showSource(element, entry) {
  if (element.dataset.entry === (entry?.id ?? "")) return;
  element.dataset.entry = entry?.id ?? "";
  if (!entry) {
    element.replaceChildren();
    return;
  }
  const paragraphs = [html("p", {}, html("span", { class: "grade" }, `Grade ${entry.grade}`), ` ${entry.source}`)];
  if (entry.note) paragraphs.push(html("p", { class: "note" }, entry.note));
  if (entry.missing?.length) {
    const names = entry.missing.map((field) => nameAndUnit(field).name).join(", ");
    paragraphs.push(html("p", { class: "gaps" }, `Not in the catalogue: ${names}.`));
  }
  const values = Object.keys(entry.values ?? {}).length
    ? [html("details", {}, html("summary", {}, "Values and their origin"), html("div", { class: "scroll" }, valuesTable(entry)))]
    : [];
  element.replaceChildren(...paragraphs, ...values);
}
