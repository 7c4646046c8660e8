// What can be found from measurements: its names in the API and on the page, and its values in the units of the page.

import { MEASURED } from "./columns.js";
import { html, symbolHtml } from "./elements.js";
import { FIELDS } from "./fields.js";
import { significant, withUnit } from "./format.js";

const SHOWN_DIGITS = 4;

const fieldNamed = (name) => FIELDS.find((field) => field.name === name);

/** By the API's name, with the field of the page that has its name and unit. */
export const PARAMETERS = {
  friction_angle_rad: { field: fieldNamed("friction_angle"), usual: true },
  cohesion_pa: { field: fieldNamed("cohesion") },
  shear_modulus_m: { field: fieldNamed("shear_modulus"), usual: true },
  k_s: { field: fieldNamed("k_s"), usual: true },
  n0: { field: fieldNamed("n0"), usual: true },
  n1: { field: fieldNamed("n1") },
  k_c: { field: fieldNamed("bekker_k_c") },
  k_phi: { field: fieldNamed("bekker_k_phi") },
  c1: { field: fieldNamed("c1") },
  c2: { field: fieldNamed("c2") },
};
const REECE = { k_c: fieldNamed("reece_k_c"), k_phi: fieldNamed("reece_k_phi") };

/** Under one name, the moduli of two laws have different units. */
export const fieldOf = (parameter, law) => (law === "reece" && REECE[parameter]) || PARAMETERS[parameter].field;

export function shown({ unit }, value) {
  const text = significant(unit.fromSi(value), SHOWN_DIGITS);
  return unit.text === "°" ? `${text}°` : withUnit(text, unit.text);
}
export const labelled = ({ label, symbol }) => [label, " ", html("i", {}, ...symbolHtml(symbol))];

/** The API's names as the page has them. */
export const named = (text) => text.replace(/\b[a-z]\w*\b/g, (word) => PARAMETERS[word]?.field.label.toLowerCase() ?? MEASURED[word]?.label.toLowerCase() ?? word);

/** Why the parameters do not go together with the law on the page, and what to do; null where they do. */
export function mismatch(fit, law) {
  const moduli = fit.filter((name) => ["k_c", "k_phi"].includes(name)).map((name) => `the ${PARAMETERS[name].field.label.toLowerCase()}`);
  if (moduli.length && fit.includes("k_s")) return `Untick the sinkage modulus K_s, or ${moduli.join(" and ")}: no law has them all.`;
  if (moduli.length && !["bekker", "reece"].includes(law)) {
    return `Untick ${moduli.join(" and ")}, or choose the law Bekker or Reece under “Pressure and sinkage”: the law of this page does not have them.`;
  }
  return null;
}
