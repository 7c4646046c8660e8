// What the person has chosen, and its form in the address bar.
//
// Choices hold a value always; fields hold the text as typed, or null while they follow their preset. The address holds
// only what differs from the defaults, in the units on the page, so that an address can be read and written by hand:
// ?wheel=msl-curiosity&soil=wong-dry-sand&by=load&slip_pct=30&c_kpa=0.5

import { FIELDS } from "./fields.js";
import { siFromText, taken } from "./typed.js";

const CHOICES = {
  wheel: "letter",
  soil: "letter-sand",
  method: "quadrature",
  by: "sinkage",
  compare: "",
  braking: "",
  braking_law: "one_zone",
  law: null,
  shear: null,
  rule: null,
  slip_sinkage: "lyasko",
  normal_stress_radius: "rim",
  peak_sinkage: "",
  fourth: "tractive_efficiency",
};

export const DEFAULTS = { ...CHOICES, ...Object.fromEntries(FIELDS.map((field) => [field.key, null])) };

export function stateFromQuery(query) {
  const state = { ...DEFAULTS };
  for (const [key, value] of new URLSearchParams(query)) {
    if (Object.hasOwn(DEFAULTS, key)) state[key] = value;
  }
  return state;
}

/** The state with the default for each choice that `offers(key, value)` denies, and those choices. */
export function offeredState(state, offers) {
  const unknown = Object.keys(CHOICES).filter((key) => state[key] !== CHOICES[key] && !offers(key, state[key]));
  const replaced = Object.fromEntries(unknown.map((key) => [key, CHOICES[key]]));
  return { state: { ...state, ...replaced }, unknown: unknown.map((key) => ({ key, value: state[key] })) };
}

const SLIP = FIELDS.find(({ name }) => name === "slip");

/** A wheel that is set to brake is looked at while it brakes. */
export function consistent(state) {
  const isBraking = state[SLIP.key] !== null && siFromText(SLIP, state[SLIP.key]) < 0;
  return isBraking && state.braking === "" ? { ...state, braking: "1" } : state;
}

/** Who leaves braking out leaves a braking slip as well. */
export const withoutBraking = (state) => (consistent(state) === state ? {} : { [SLIP.key]: "0" });

/** What is no number stays in its box and out of the address. */
export function queryFromState(state) {
  const query = new URLSearchParams();
  for (const [key, usual] of Object.entries(DEFAULTS)) {
    const field = FIELDS.find((each) => each.key === key);
    const value = field && state[key] !== null ? taken(field, state[key]) : state[key];
    if (value !== null && value !== usual) query.set(key, value);
  }
  const text = query.toString();
  return text ? `?${text}` : "";
}
