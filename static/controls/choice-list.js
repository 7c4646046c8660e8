// The choices with a short list of their own: each stands where the page has a place for it.

import { html } from "../dom/elements.js";
import { find } from "../dom/find.js";
import { EXIT, lawsOf } from "../quantities/law-fields.js";

/**
 * @typedef {object} Choice
 * @property {string} key
 * @property {string} pointer of its faults
 * @property {string} label
 * @property {string} [about] behind the label, in small type
 * @property {Record<string, string>} options their texts by their values
 */

/** @type {Choice[]} */
const CHOICES = [
  { key: "braking_law", pointer: "/braking", label: "Shear zones of a braking wheel",
    options: { one_zone: "One: as under a driving wheel", two_zone: "Two: Wong and Reece" } },
  { key: "exit", pointer: EXIT, label: "End of the contact",
    options: { "": "c₃: θ₂ = c₃ θ₁", ...Object.fromEntries(lawsOf(EXIT).map(({ name, formula }) => [name, formula])) } },
  { key: "slip_sinkage", pointer: "/slip_sinkage", label: "Slip–sinkage law",
    options: { lyasko: "Lyasko: z₀ (1 + s)/(1 − s/2)", linear: "Linear: z₀ (1 + S s)" } },
  { key: "normal_stress_radius", pointer: "/normal_stress_radius", label: "Normal stress acts at",
    options: { rim: "The rim", shearing: "The shearing radius" } },
  { key: "slip_radius", pointer: "/slip_radius", label: "Slip is counted at",
    options: { rim: "The rim, r", shearing: "The shearing radius, r + λₛ h", lug_tip: "The tips of the lugs, r + h" } },
  { key: "shear_displacement_radius", pointer: "/shear_displacement_radius", label: "Shear displacement is counted at",
    options: { shearing: "The shearing radius", rim: "The rim, as the letter prints it" } },
  { key: "peak_sinkage", pointer: "/peak_sinkage", label: "Depth under the peak", about: "(closed forms)",
    options: { "": "Default of the method", geometric: "Geometric", half: "Half the sinkage" } },
];

/** @param {Choice} choice */
function choiceElement({ key, pointer, label, about, options }) {
  const id = key.replaceAll("_", "-");
  return html("div", { class: "choice" },
    html("label", { for: id }, label, ...(about ? [" ", html("small", {}, about)] : [])),
    html("select", { id, name: key }, ...Object.entries(options).map(([value, text]) => html("option", { value }, text))),
    html("p", { class: "fault", id: `${id}-fault`, "data-fault": pointer, hidden: true }));
}

/** @param {HTMLElement} form */
export function fillChoices(form) {
  for (const choice of CHOICES) find(form, `[data-choice="${choice.key}"]`).replaceWith(choiceElement(choice));
}

/** The pointers of their faults, by their keys. */
export const LISTED_POINTERS = Object.fromEntries(CHOICES.map(({ key, pointer }) => [key, pointer]));
