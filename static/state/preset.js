// What untouched fields follow, and which fields matter.

import { numberIn } from "../quantities/field-values.js";
import { fieldNamed } from "../quantities/fields.js";
import { CONTACT, PRESSURE_SINKAGE, SHEAR, SLIP_SINKAGE, groupsOfLaw, sharedNames } from "../quantities/law-fields.js";

/** @import { Catalogue, CatalogueLaw } from "../api/types.js" */
/** @import { Preset } from "../quantities/fields.js" */
/** @import { State } from "./choices.js" */

/**
 * The laws in force, and those of the chosen soil.
 * @typedef {object} Laws
 * @property {string} law
 * @property {string} rule
 * @property {string} shearLaw
 * @property {string} followedLaw
 * @property {string} followedRule
 * @property {string} followedShear
 * @property {number | null} slip as set on the page
 */

/** @typedef {Preset & Laws} Context */

const RADIUS = fieldNamed("radius");
const SLIP = fieldNamed("slip");

/**
 * The moduli of one law mean nothing to another; the exponents do.
 * @param {CatalogueLaw} law
 * @returns {CatalogueLaw}
 */
const exponentsOf = (law) => Object.fromEntries(sharedNames(PRESSURE_SINKAGE).map((name) => [name, law[name]]));

/**
 * @param {State} state
 * @param {Catalogue} catalogue
 * @returns {Context}
 */
export function contextOf(state, catalogue) {
  const wheel = catalogue.wheels.get(state.wheel);
  const soil = catalogue.soils.get(state.soil);
  /** @type {CatalogueLaw} */
  const pressureSinkage = soil?.soil.pressure_sinkage ?? {};
  /** @type {CatalogueLaw} */
  const contact = soil?.contact ?? {};
  /** @type {CatalogueLaw} */
  const shear = soil?.soil.shear ?? {};
  const followedLaw = pressureSinkage.law ?? "bekker";
  const followedRule = contact.rule ?? "midpoint";
  const followedShear = shear.law ?? "janosi_hanamoto";
  const law = state.law ?? followedLaw;
  /** @type {Preset} */
  const preset = { wheel, soil, pressureSinkage: law === followedLaw ? pressureSinkage : exponentsOf(pressureSinkage), contact, shear, braking: state.braking !== "" };
  return {
    ...preset,
    law,
    rule: state.rule ?? followedRule,
    shearLaw: state.shear ?? followedShear,
    followedLaw,
    followedRule,
    followedShear,
    radius: numberIn(RADIUS, state[RADIUS.key], preset),
    slip: numberIn(SLIP, state[SLIP.key], preset),
  };
}

/**
 * The groups of fields that matter now. The others are neither shown nor sent.
 * @param {State} state
 * @param {Context} context
 */
export function activeGroups(state, context) {
  const groups = new Set(["slip", state.by, "wheel", "strength",
    ...groupsOfLaw(PRESSURE_SINKAGE, context.law), ...groupsOfLaw(SHEAR, context.shearLaw), ...groupsOfLaw(CONTACT, context.rule)]);
  // The closed forms know neither a slip angle nor two zones.
  if (state.method === "quadrature" && !state.compare) {
    groups.add("slip_angle");
    if (context.braking || (context.slip !== null && context.slip < 0)) groups.add("braking_law");
  }
  if (state.by === "static") {
    groups.add("static_law");
    groupsOfLaw(SLIP_SINKAGE, state.slip_sinkage).forEach((group) => groups.add(group));
  }
  if (state.method === "explicit" || state.compare) groups.add("explicit");
  if (state.method === "resistive_force") groups.add("grains");
  return groups;
}
