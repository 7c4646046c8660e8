// The form: choices, fields and groups, and the fault of each at its place.

import { html, sentenceHtml } from "./elements.js";
import { createFieldRow } from "./field-row.js";
import { FIELDS } from "./fields.js";
import { fillPresets, showGrade } from "./presets.js";
import { activeGroups } from "./settings.js";
import { DEFAULTS } from "./state.js";
import { wordedFault } from "./wording.js";

/** The collapsible groups: the field groups and the choices in each that can differ from the preset. */
const SECTIONS = {
  wheel: { fields: ["wheel"], choices: [] },
  strength: { fields: ["strength", "janosi_hanamoto", "residual", "peak"], choices: ["shear"] },
  pressure: { fields: ["bekker", "direct", "reece", "diameter", "exponent"], choices: ["law"] },
  options: { fields: ["wong_reece", "contact", "explicit"], choices: ["rule", "normal_stress_radius", "peak_sinkage"] },
};
const PRESET_GROUPS = Object.values(SECTIONS).flatMap((section) => section.fields);

/** Where the fault of each choice is shown; a pointer below one of these belongs to it unless a field claims it. */
const CHOICE_POINTERS = {
  wheel: "/wheel", soil: "/soil", method: "/method", law: "/soil/pressure_sinkage", shear: "/soil/shear",
  rule: "/contact", slip_sinkage: "/slip_sinkage", braking_law: "/braking",
  normal_stress_radius: "/normal_stress_radius", peak_sinkage: "/peak_sinkage",
};

/** Until the catalogue is there, the list holds what the address names. */
function choose(select, value) {
  if (![...select.options].some((option) => option.value === value)) {
    select.append(html("option", { value }, value));
  }
  select.value = value;
}

/** `onChange(changes, { discrete })`: discrete changes are single decisions, the others come in streams. */
export function createControls(form, onChange) {
  const selects = Object.fromEntries(Object.keys(CHOICE_POINTERS).map((key) => [key, form.elements[key]]));
  const followed = { law: null, shear: null, rule: null };
  let isFilled = false;

  const rows = FIELDS.map((field) => {
    const row = createFieldRow(field, {
      followsPreset: PRESET_GROUPS.includes(field.group),
      onText: (text) => onChange({ [field.key]: text }, { discrete: false }),
      onReset: () => onChange({ [field.key]: null }, { discrete: true }),
    });
    form.querySelector(`[data-fields="${field.group}"]`).append(row.element);
    return row;
  });

  for (const [key, select] of Object.entries(selects)) {
    select.addEventListener("change", () => onChange({ [key]: select.value === followed[key] ? null : select.value }, { discrete: true }));
  }
  for (const key of ["compare", "braking"]) {
    const box = form.elements[key];
    box.addEventListener("change", () => onChange({ [key]: box.checked ? "1" : "" }, { discrete: true }));
  }
  for (const radio of form.elements.by) {
    radio.addEventListener("change", () => onChange({ by: radio.value }, { discrete: true }));
  }
  form.addEventListener("submit", (event) => event.preventDefault());

  const sections = Object.entries(SECTIONS).map(([name, { fields, choices }]) => {
    const count = form.querySelector(`[data-changes="${name}"]`);
    const reset = html("button", { type: "button", class: "small", "data-reset-group": name, hidden: true }, "Reset these to the preset");
    count.closest("details").append(reset);
    const keys = [...FIELDS.filter((field) => fields.includes(field.group)).map((field) => field.key), ...choices];
    reset.addEventListener("click", () => onChange(Object.fromEntries(keys.map((key) => [key, DEFAULTS[key]])), { discrete: true }));
    return { count, reset, keys };
  });

  function fill(catalogue) {
    fillPresets(selects.wheel, catalogue.wheels.values());
    fillPresets(selects.soil, catalogue.soils.values());
    isFilled = true;
  }

  /** Whether a choice can take a value. The lists of wheels and soils say so only once they are filled. */
  function offers(key, value) {
    const input = form.elements[key];
    if (["wheel", "soil"].includes(key) && !isFilled) return true;
    if (input instanceof RadioNodeList) return [...input].some((radio) => radio.value === value);
    if (input.type === "checkbox") return ["", "1"].includes(value);
    return [...input.options].some((option) => option.value === value);
  }

  function show(state, context) {
    Object.assign(followed, { law: context.followedLaw, shear: context.followedShear, rule: context.followedRule });
    for (const [key, select] of Object.entries(selects)) {
      choose(select, state[key] ?? followed[key]);
      if (key in followed) select.closest(".choice").classList.toggle("changed", state[key] !== null);
    }
    for (const key of ["compare", "braking"]) form.elements[key].checked = state[key] !== "";
    for (const radio of form.elements.by) radio.checked = radio.value === state.by;

    const groups = activeGroups(state, context);
    for (const container of form.querySelectorAll("[data-fields]")) container.hidden = !groups.has(container.dataset.fields);
    for (const row of rows) row.show(state, context);
    const inactive = FIELDS.filter((field) => !groups.has(field.group)).map((field) => field.key);
    for (const { count, reset, keys } of sections) {
      const changes = keys.filter((key) => state[key] !== DEFAULTS[key] && !inactive.includes(key)).length;
      count.textContent = changes ? `${changes} changed` : "";
      reset.hidden = changes === 0;
    }
    showGrade(form.querySelector("#wheel-grade"), context.wheel, "wheel-origin");
    showGrade(form.querySelector("#soil-grade"), context.soil, "soil-origin");
  }

  /** The place for a pointer: its own field if that is on the page now, else the nearest choice above it. */
  function placeOf(pointer) {
    const row = rows.find(({ field, element }) => field.pointer === pointer && !element.parentElement.hidden);
    if (row) return row;
    const [key] = Object.entries(CHOICE_POINTERS)
      .filter(([, above]) => pointer === above || pointer.startsWith(`${above}/`))
      .sort(([, a], [, b]) => b.length - a.length)[0] ?? [];
    if (!key) return null;
    const input = selects[key];
    return { input, fault: input.closest(".choice").querySelector(".fault") };
  }

  /** Shows each fault at its input, opening the group it is in; returns the faults with that input, null where there is none. */
  function showFaults(faults) {
    const texts = new Map();
    const placed = faults.map(({ pointer, detail, local }) => {
      const place = placeOf(pointer);
      if (!place) return { pointer, text: wordedFault(detail), input: null };
      const text = local ? detail : wordedFault(detail, place.field);
      texts.set(place.fault, [...(texts.get(place.fault) ?? []), text]);
      return { pointer, text, input: place.input };
    });
    const places = [...rows, ...Object.keys(selects).map((key) => placeOf(CHOICE_POINTERS[key]))];
    for (const { input, fault } of places) {
      const text = (texts.get(fault) ?? []).join(" ");
      const group = input.closest("details");
      if (text && fault.hidden && group) group.open = true;
      if (fault.textContent !== text.replaceAll("`", "")) fault.replaceChildren(...sentenceHtml(text));
      fault.hidden = !text;
      if (text) input.setAttribute("aria-invalid", "true");
      else input.removeAttribute("aria-invalid");
    }
    return placed;
  }

  return { fill, offers, show, showFaults };
}
