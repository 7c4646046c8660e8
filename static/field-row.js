// One number a person can set: label, number box, unit, slider, a reset while it is changed, and the place for its fault.

import { html, symbolHtml } from "./elements.js";
import { baseText, shownText, sliderRange } from "./fields.js";
import { plainNumber } from "./typed.js";

const COARSE_STEPS = 10;

/** The text moved by a step, without the digits that binary fractions would add. */
function nudged(text, step) {
  const decimals = Math.max(...[text, String(step)].map((part) => (part.split(".")[1] ?? "").length));
  return String(Number((Number(text) + step).toFixed(decimals)));
}

/** `followsPreset` fields are marked while changed; the others, such as the slip, are simply set. */
export function createFieldRow(field, { followsPreset, onText, onReset }) {
  const { name, label } = field;
  const unit = field.unit.text;
  const unset = field.blank ?? "unknown";
  let usual = "";

  const box = html("input", {
    type: "text", id: name, name, spellcheck: "false", inputmode: field.signed ? "text" : "decimal", "aria-describedby": `${name}-unit ${name}-fault`,
  });
  const reset = html("button", { type: "button", class: "reset", "data-reset": name, hidden: true }, "↺");
  const fault = html("p", { class: "fault", id: `${name}-fault`, "data-fault": field.pointer, hidden: true });
  const element = html("div", { class: "field", "data-field": name },
    html("label", { for: name, id: `${name}-label` }, label, " ", html("i", {}, ...symbolHtml(field.symbol))),
    html("span", { class: "entry" }, reset, box, html("span", { class: "unit", id: `${name}-unit` }, unit)));
  if (field.word) {
    box.setAttribute("list", `${name}-words`);
    element.append(html("datalist", { id: `${name}-words` }, html("option", { value: "0" }), html("option", { value: field.word })));
  }
  let slider = null;
  if (field.slider) {
    slider = html("input", { type: "range", "data-slider": name, "aria-labelledby": `${name}-label` });
    element.append(slider);
    slider.addEventListener("input", () => send(slider.value));
  }
  element.append(fault);

  /** Typing the preset's own value is the same as not touching the field. */
  const send = (text) => onText(text === usual ? null : text);

  box.addEventListener("input", () => send(box.value));
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

  function show(state, context) {
    usual = baseText(field, context);
    const text = shownText(field, state, context);
    const changed = followsPreset && state[field.key] !== null;
    const usualText = usual === "" ? unset : [usual, unit].filter(Boolean).join(" ");
    if (box.value !== text) box.value = text;
    box.placeholder = usual === "" ? unset : "";
    element.classList.toggle("changed", changed);
    reset.hidden = !changed;
    reset.title = `Changed; the preset: ${usualText}`;
    reset.setAttribute("aria-label", `${label} is changed. Reset to the preset: ${usualText}`);
    if (!slider) return;
    Object.assign(slider, sliderRange(field, context));
    slider.value = plainNumber(text) ?? slider.min;
    slider.setAttribute("aria-valuetext", text === "" ? unset : `${text} ${unit}`.trim());
  }

  return { field, element, input: box, fault, show };
}
