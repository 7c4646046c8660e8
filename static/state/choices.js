// What has been chosen on the page, and its form in the address.
//
// Choices always have a value. Fields have the text as typed, or null while they follow their preset. The address has only what
// differs from the defaults, in the units of the page, so that it can be read and written by hand:
// ?wheel=msl-curiosity&soil=wong-dry-sand&by=load&slip_pct=30&c_kpa=0.5

import { siFromText, taken } from "../quantities/field-values.js";
import { FIELDS, fieldNamed } from "../quantities/fields.js";

/** @import { Method } from "../api/types.js" */

/** @typedef {"sinkage" | "load" | "static"} Given */

/**
 * @typedef {object} Choices
 * @property {string} wheel
 * @property {string} soil
 * @property {Method} method
 * @property {Given} by
 * @property {string} load_known "1" where the load is known beside a sinkage, else empty
 * @property {string} assume "1" where the catalogue's substitutes for unpublished values are taken, else empty
 * @property {string} compare "1" where it is ticked, else empty
 * @property {string} rover "1" where it is ticked, else empty
 * @property {string} axles the places of its axles (mm) as typed, empty where its wheels carry equal loads
 * @property {string} rut "1" where wheels run in the ruts of those before them, else empty
 * @property {string} braking "1" where it is ticked, else empty
 * @property {"one_zone" | "two_zone"} braking_law
 * @property {string | null} law null while the soil's own
 * @property {string | null} shear null while the soil's own
 * @property {string | null} rule null while the soil's own
 * @property {string} exit empty where the contact ends by c3, else the law by which it ends
 * @property {"lyasko" | "linear"} slip_sinkage
 * @property {"rim" | "shearing"} normal_stress_radius
 * @property {"rim" | "shearing" | "lug_tip"} slip_radius
 * @property {"shearing" | "rim"} shear_displacement_radius
 * @property {"" | "geometric" | "half"} peak_sinkage
 * @property {string} fourth
 */

/**
 * The choices, and the text of every field by its key in the address.
 * @typedef {Choices & { [key: string]: string | null }} State
 */

/** @typedef {{ [key: string]: string | null }} Changes */

/** @type {Choices} */
const CHOICES = {
  wheel: "letter",
  soil: "letter-sand",
  method: "quadrature",
  by: "sinkage",
  load_known: "",
  assume: "",
  compare: "",
  rover: "",
  axles: "",
  rut: "",
  braking: "",
  braking_law: "one_zone",
  law: null,
  shear: null,
  rule: null,
  exit: "",
  slip_sinkage: "lyasko",
  normal_stress_radius: "rim",
  slip_radius: "rim",
  shear_displacement_radius: "shearing",
  peak_sinkage: "",
  fourth: "tractive_efficiency",
};

/** @type {State} */
export const DEFAULTS = Object.assign(Object.fromEntries(FIELDS.map((field) => [field.key, null])), CHOICES);

/**
 * @param {State} state
 * @param {Changes} changes
 * @returns {State}
 */
export const changed = (state, changes) => Object.assign({ ...state }, changes);

/** @param {string} query */
export function stateFromQuery(query) {
  const given = [...new URLSearchParams(query)].filter(([key]) => Object.hasOwn(DEFAULTS, key));
  return changed(DEFAULTS, Object.fromEntries(given));
}

/**
 * The state with the default in place of each choice that is not offered, and those choices.
 * @param {State} state
 * @param {(key: string, value: string | null) => boolean} offers
 */
export function offeredState(state, offers) {
  const unknown = Object.entries(CHOICES).filter(([key, usual]) => state[key] !== usual && !offers(key, state[key]));
  return {
    state: changed(state, Object.fromEntries(unknown)),
    unknown: unknown.map(([key]) => ({ key, value: state[key] })),
  };
}

const SLIP = fieldNamed("slip");

/** @param {State} state */
function isBraking({ [SLIP.key]: text }) {
  const slip = text === null ? null : siFromText(SLIP, text);
  return typeof slip === "number" && slip < 0;
}

/**
 * A braking slip ticks the box for braking, so that the charts show it.
 * @param {State} state
 */
export const consistent = (state) => (isBraking(state) && state.braking === "" ? changed(state, { braking: "1" }) : state);

/**
 * Without braking, a braking slip becomes zero.
 * @param {State} state
 */
export const withoutBraking = (state) => (consistent(state) === state ? state : changed(state, { [SLIP.key]: "0" }));

/**
 * A text that is no number stays in its box and out of the address.
 * @param {State} state
 */
export function queryFromState(state) {
  const query = new URLSearchParams();
  for (const [key, usual] of Object.entries(DEFAULTS)) {
    const field = FIELDS.find((each) => each.key === key);
    const text = state[key];
    const value = field && text !== null ? taken(field, text) : text;
    if (value !== null && value !== usual) query.set(key, value);
  }
  const text = query.toString();
  return text ? `?${text}` : "";
}
