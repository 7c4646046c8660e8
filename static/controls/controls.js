// The form: choices, fields, and groups.

import { fillPresets, showGrade } from "../catalogue/presets.js";
import { html } from "../dom/elements.js";
import { enclosing, find, findAll } from "../dom/find.js";
import { capitalised } from "../numbers/format.js";
import { FIELDS } from "../quantities/fields.js";
import { CONTACT, EXIT, PRESSURE_SINKAGE, SHEAR, groupsOf, lawsOf } from "../quantities/law-fields.js";
import { DEFAULTS } from "../state/choices.js";
import { activeGroups, slipAngleNote } from "../state/preset.js";
import { LISTED_POINTERS, fillChoices } from "./choice-list.js";
import { choicePlace, showFaultsAt } from "./faults.js";
import { createFieldRow } from "./field-row.js";

/** @import { Catalogue } from "../api/types.js" */
/** @import { Changes, State } from "../state/choices.js" */
/** @import { Context } from "../state/preset.js" */
/** @import { ShownFault } from "./faults.js" */

/**
 * A change of the form. Discrete changes are single decisions; the others come in streams.
 * @typedef {(changes: Changes, how: { discrete: boolean }) => void} OnChange
 */

/**
 * The groups that can be folded: the field groups in each, and the choices that can differ from the preset.
 * @type {Record<string, { fields: string[], choices: string[] }>}
 */
const SECTIONS = {
  wheel: { fields: ["wheel"], choices: [] },
  strength: { fields: ["strength", "grains", ...groupsOf(SHEAR)], choices: ["shear"] },
  pressure: { fields: groupsOf(PRESSURE_SINKAGE), choices: ["law"] },
  options: { fields: [...groupsOf(CONTACT), ...groupsOf(EXIT), "interface", "explicit"], choices: ["rule", "exit", "normal_stress_radius", "slip_radius", "shear_displacement_radius", "peak_sinkage"] },
};
const PRESET_GROUPS = Object.values(SECTIONS).flatMap(({ fields }) => fields);

/** The choices with a list, and the pointers of their faults. */
const CHOICE_POINTERS = {
  wheel: "/wheel", soil: "/soil", method: "/method", law: "/soil/pressure_sinkage", shear: "/soil/shear",
  rule: "/contact", ...LISTED_POINTERS,
};
const TICKS = ["compare", "braking", "load_known", "assume", "rover", "rut"];
const PRESETS = ["wheel", "soil"];

/** @param {string} text */
const inWords = (text) => capitalised(text.replaceAll("_", " "));

/**
 * The laws of the service that the page has no words for stand behind the others, and each group of a law's fields has its place.
 * @param {HTMLFormElement} form
 */
function addLaws(form) {
  for (const [key, pointer] of Object.entries(CHOICE_POINTERS)) {
    const select = find(form, `select[name="${key}"]`, HTMLSelectElement);
    const offered = [...select.options].map(({ value }) => value);
    const others = lawsOf(pointer).filter(({ name }) => !offered.includes(name));
    select.append(...others.map(({ name, formula }) => html("option", { value: name }, `${inWords(name)}: ${formula}`)));
  }
  for (const place of findAll(form, "[data-law-fields]")) {
    place.append(...groupsOf(place.dataset.lawFields ?? "").map((group) => html("div", { "data-fields": group })));
  }
}

/**
 * Until the catalogue is there, the list has what the address names.
 * @param {HTMLSelectElement} select
 * @param {string} value
 */
function choose(select, value) {
  if (![...select.options].some((option) => option.value === value)) select.append(html("option", { value }, value));
  select.value = value;
}

/**
 * The value of each choice that follows the soil while it is untouched.
 * @param {Context} context
 * @returns {Record<string, string>}
 */
const followedBy = ({ followedLaw, followedShear, followedRule }) => ({ law: followedLaw, shear: followedShear, rule: followedRule });

/**
 * The count of changes of each foldable group, and the button that undoes them.
 * @param {HTMLFormElement} form
 * @param {OnChange} onChange
 */
function createSections(form, onChange) {
  const sections = Object.entries(SECTIONS).map(([name, { fields, choices }]) => {
    const count = find(form, `[data-changes="${name}"]`);
    const reset = html("button", { type: "button", class: "small", "data-reset-group": name, hidden: true }, "Reset these to the preset");
    enclosing(count, "details").append(reset);
    const keys = [...FIELDS.filter(({ group }) => fields.includes(group)).map(({ key }) => key), ...choices];
    reset.addEventListener("click", () => onChange(Object.fromEntries(keys.map((key) => [key, DEFAULTS[key]])), { discrete: true }));
    return { count, reset, keys };
  });

  /** @param {State} state @param {Context} context @param {Set<string>} groups that matter now */
  return (state, context, groups) => {
    const inactive = FIELDS.filter(({ group }) => !groups.has(group)).map(({ key }) => key);
    for (const { count, reset, keys } of sections) {
      const changes = keys.filter((key) => state[key] !== DEFAULTS[key] && !inactive.includes(key)).length;
      const assumed = FIELDS.filter((field) => keys.includes(field.key) && groups.has(field.group) && state[field.key] === null && field.substitute?.(context.assumed)).length;
      count.textContent = [changes && `${changes} changed`, assumed && `${assumed} assumed`].filter(Boolean).join(", ");
      reset.hidden = changes === 0;
    }
  };
}

/**
 * @param {HTMLFormElement} form
 * @param {OnChange} onChange
 */
export function createControls(form, onChange) {
  fillChoices(form);
  addLaws(form);
  const selects = Object.keys(CHOICE_POINTERS).map((key) => ({ key, select: find(form, `select[name="${key}"]`, HTMLSelectElement) }));
  const ticks = TICKS.map((key) => ({ key, box: find(form, `input[name="${key}"]`, HTMLInputElement) }));
  const radios = [...form.querySelectorAll('input[name="by"]')].filter((radio) => radio instanceof HTMLInputElement);
  /** @type {Record<string, string>} */
  let followed = {};
  let isFilled = false;

  const axles = find(form, "#axles", HTMLInputElement);
  axles.addEventListener("input", () => onChange({ axles: axles.value }, { discrete: false }));

  const rows = FIELDS.map((field) => {
    const row = createFieldRow(field, {
      followsPreset: PRESET_GROUPS.includes(field.group),
      onText: (text) => onChange({ [field.key]: text }, { discrete: false }),
      onReset: () => onChange({ [field.key]: null }, { discrete: true }),
      onAssume: () => onChange({ assume: "1" }, { discrete: true }),
    });
    find(form, `[data-fields="${field.group}"]`).append(row.element);
    return row;
  });
  const showSections = createSections(form, onChange);
  const places = [
    ...rows.map(({ field, input, fault }) => ({ pointer: field.pointer, field, input, fault })),
    { pointer: "/stations", input: axles, fault: find(form, "#axles-fault") },
    ...Object.entries(CHOICE_POINTERS).map(([key, pointer]) => choicePlace(find(form, `select[name="${key}"]`, HTMLSelectElement), pointer)),
  ];

  for (const { key, select } of selects) {
    select.addEventListener("change", () => onChange({ [key]: select.value === followed[key] ? null : select.value }, { discrete: true }));
  }
  for (const { key, box } of ticks) box.addEventListener("change", () => onChange({ [key]: box.checked ? "1" : "" }, { discrete: true }));
  for (const radio of radios) radio.addEventListener("change", () => onChange({ by: radio.value }, { discrete: true }));
  form.addEventListener("submit", (event) => event.preventDefault());

  return {
    /** @param {Catalogue} catalogue */
    fill({ wheels, soils }) {
      fillPresets(find(form, "#wheel", HTMLSelectElement), wheels.values());
      fillPresets(find(form, "#soil", HTMLSelectElement), soils.values());
      isFilled = true;
    },

    /**
     * Whether a choice can take a value. The lists of wheels and soils can say so only once they are filled.
     * @param {string} key
     * @param {string | null} value
     */
    offers(key, value) {
      if (PRESETS.includes(key) && !isFilled) return true;
      if (key === "axles") return true;
      if (TICKS.includes(key)) return value === "" || value === "1";
      const input = form.elements.namedItem(key);
      const offered = input instanceof HTMLSelectElement ? [...input.options] : radios;
      return offered.some((each) => each.value === value);
    },

    /**
     * @param {State} state
     * @param {Context} context
     */
    show(state, context) {
      followed = followedBy(context);
      for (const { key, select } of selects) {
        choose(select, state[key] ?? followed[key]);
        if (key in followed) enclosing(select, ".choice").classList.toggle("changed", state[key] !== null);
      }
      for (const { key, box } of ticks) box.checked = state[key] !== "";
      enclosing(find(form, "#assume"), ".assume").hidden = context.offered.size === 0 && state.assume === "";
      if (axles.value !== state.axles) axles.value = state.axles ?? "";
      find(form, "#rover-group").hidden = state.rover === "";
      for (const radio of radios) radio.checked = radio.value === state.by;
      const groups = activeGroups(state, context);
      for (const container of findAll(form, "[data-fields]")) container.hidden = !groups.has(container.dataset.fields ?? "");
      for (const row of rows) row.show(state, context);
      rows.find(({ field }) => field.name === "slip_angle")?.tell(slipAngleNote(state));
      showSections(state, context, groups);
      showGrade(find(form, "#wheel-grade"), context.wheel, "wheel-origin");
      showGrade(find(form, "#soil-grade"), context.soil, "soil-origin");
    },

    /** @param {ShownFault[]} faults */
    showFaults: (faults) => showFaultsAt(places, faults),
  };
}
