// One number that can be set: label, box, unit, slider, a reset while it is changed, and the place for its fault.

import { html } from "../dom/elements.js";
import { sentenceHtml, symbolHtml } from "../dom/text.js";
import { plainNumber } from "../numbers/plain.js";
import { baseText, fieldText, widened } from "../quantities/field-values.js";
import { beforeUnit } from "../quantities/units.js";

/** @import { Field } from "../quantities/fields.js" */
/** @import { State } from "../state/choices.js" */
/** @import { Context } from "../state/preset.js" */

/** @typedef {ReturnType<typeof createFieldRow>} FieldRow */

/**
 * @typedef {object} RowEvents
 * @property {boolean} followsPreset such a field is marked while it is changed; any other, such as the slip, is simply set
 * @property {(text: string | null) => void} onText null for the preset's own value
 * @property {() => void} onReset
 * @property {() => void} onAssume takes what the catalogue proposes where no value was published
 */

const COARSE_STEPS = 10;

/**
 * The text moved by a step, without the digits that binary fractions would add.
 * @param {string} text
 * @param {number} step
 */
function nudged(text, step) {
  const decimals = Math.max(...[text, String(step)].map((part) => (part.split(".")[1] ?? "").length));
  return String(Number((Number(text) + step).toFixed(decimals)));
}

/**
 * @param {Field} field
 * @param {string} name
 */
function numberBox({ signed, word }, name) {
  const box = html("input", {
    type: "text", id: name, name, spellcheck: "false", inputmode: signed ? "text" : "decimal", "aria-describedby": `${name}-unit ${name}-fault ${name}-substitute ${name}-note`,
  });
  if (word) box.setAttribute("list", `${name}-words`);
  return box;
}

/**
 * @param {Field} field
 * @param {RowEvents} events
 */
export function createFieldRow(field, { followsPreset, onText, onReset, onAssume }) {
  const { name, label, word } = field;
  const unit = field.unit.text;
  const unset = field.blank ?? "unknown";
  let usual = "";

  const box = numberBox(field, name);
  const reset = html("button", { type: "button", class: "reset", "data-reset": name, hidden: true }, "↺");
  const fault = html("p", { class: "fault", id: `${name}-fault`, "data-fault": field.pointer, hidden: true });
  const note = html("p", { class: "substitute", id: `${name}-note`, hidden: true });
  const substitute = html("p", { class: "substitute", id: `${name}-substitute`, hidden: true });
  const slider = field.slider ? html("input", { type: "range", "data-slider": name, "aria-labelledby": `${name}-label` }) : null;
  const element = html("div", { class: "field", "data-field": name },
    html("label", { for: name, id: `${name}-label` }, label, " ", html("i", {}, ...symbolHtml(field.symbol))),
    html("span", { class: "entry" }, reset, box, html("span", { class: "unit", id: `${name}-unit` }, unit)),
    ...(word ? [html("datalist", { id: `${name}-words` }, html("option", { value: "0" }), html("option", { value: word }))] : []),
    ...(slider ? [slider] : []),
    note,
    substitute,
    fault);

  /**
   * The preset's own value typed is the same as an untouched field.
   * @param {string} text
   */
  const send = (text) => onText(text === usual ? null : text);

  box.addEventListener("input", () => send(box.value));
  slider?.addEventListener("input", () => send(slider.value));
  box.addEventListener("keydown", (event) => {
    const direction = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    const plain = plainNumber(box.value);
    if (!direction || !slider || plain === null) return;
    event.preventDefault();
    send(nudged(plain, direction * Number(slider.step) * (event.shiftKey ? COARSE_STEPS : 1)));
  });
  reset.addEventListener("click", () => {
    onReset();
    box.focus();
  });

  /**
   * @param {HTMLInputElement} input
   * @param {string} text
   * @param {Context} context
   */
  function showSlider(input, text, context) {
    if (!field.slider) return;
    const { min, max, step } = widened(field.slider(context), usual);
    Object.assign(input, { min: String(min), max: String(max), step: String(step) });
    input.value = plainNumber(text) ?? input.min;
    input.setAttribute("aria-valuetext", text === "" ? unset : `${text} ${unit}`.trim());
  }

  /**
   * What stands for a value that no one published, or could.
   * @param {State} state
   * @param {Context} context
   */
  function showSubstitute(state, { assumed, offered }) {
    const isFree = state[field.key] === null;
    const taken = isFree ? field.substitute?.(assumed) : undefined;
    const proposed = isFree && !taken ? field.substitute?.(offered) : undefined;
    const shown = taken ?? proposed;
    substitute.hidden = !shown;
    element.classList.toggle("assumed", Boolean(taken));
    if (!shown) return;
    /** @param {number} value */
    const text = (value) => beforeUnit(fieldText(field, value), field.unit);
    const range = shown.low === shown.high ? "" : `, from ${text(shown.low)} to ${text(shown.high)}`;
    if (taken) substitute.replaceChildren(html("strong", {}, "Assumed"), ...sentenceHtml(`: ${taken.reason}${range}.`));
    else {
      const use = html("button", { type: "button", class: "small", "data-assume": name }, `Assume ${text(shown.value)}`);
      use.addEventListener("click", onAssume);
      substitute.replaceChildren("Not published. ", use, ...sentenceHtml(` ${shown.reason}${range}.`));
    }
  }

  /**
   * @param {State} state
   * @param {Context} context
   */
  function show(state, context) {
    usual = baseText(field, context);
    const text = state[field.key] ?? usual;
    const isChanged = followsPreset && state[field.key] !== null;
    const usualText = usual === "" ? unset : [usual, unit].filter(Boolean).join(" ");
    if (box.value !== text) box.value = text;
    box.placeholder = usual === "" ? unset : "";
    element.classList.toggle("changed", isChanged);
    reset.hidden = !isChanged;
    reset.title = `Changed; the preset: ${usualText}`;
    reset.setAttribute("aria-label", `${label} is changed. Reset to the preset: ${usualText}`);
    if (slider) showSlider(slider, text, context);
    showSubstitute(state, context);
  }

  /** What else is to be said of the field; empty where nothing is. @param {string} text */
  function tell(text) {
    if (note.textContent !== text) note.textContent = text;
    note.hidden = !text;
  }

  return { field, element, input: box, fault, show, tell };
}
