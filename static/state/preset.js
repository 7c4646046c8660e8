// What untouched fields follow, and which fields matter.

import { numberIn } from "../quantities/field-values.js";
import { fieldNamed } from "../quantities/fields.js";
import { CONTACT, EXIT, PRESSURE_SINKAGE, SHEAR, SLIP_SINKAGE, groupsOfLaw, sharedGroups, sharedNames } from "../quantities/law-fields.js";
import { offeredSubstitutes, substituteLaw, substitutesInForce, withoutLaw } from "./substitutes.js";

/** @import { Catalogue, CatalogueLaw } from "../api/types.js" */
/** @import { Preset, Substitutes } from "../quantities/fields.js" */
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
 * @property {boolean} hasLugs
 * @property {Substitutes} offered for values that the catalogue lacks
 */

/** @typedef {Preset & Laws} Context */

/** The exit takes the place of c3, which is alone in its group. */
const C3_GROUPS = sharedGroups(CONTACT);
const RADIUS = fieldNamed("radius");
const SLIP = fieldNamed("slip");
const SLIP_ANGLE = fieldNamed("slip_angle");
const LUG_HEIGHT = fieldNamed("lug_height");

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
  const offered = offeredSubstitutes({ wheel, soil });
  const inForce = substitutesInForce({ wheel, soil }, state.assume !== "");
  // A law that is assumed is taken as a whole.
  const assumedLaw = substituteLaw(inForce);
  /** @type {CatalogueLaw} */
  const published = soil?.soil.pressure_sinkage ?? {};
  const pressureSinkage = assumedLaw ? {} : published;
  /** @type {CatalogueLaw} */
  const contact = soil?.contact ?? {};
  /** @type {CatalogueLaw} */
  const shear = soil?.soil.shear ?? {};
  const followedLaw = assumedLaw ?? published.law ?? "bekker";
  const followedRule = contact.rule ?? "midpoint";
  const followedShear = shear.law ?? "janosi_hanamoto";
  const law = state.law ?? followedLaw;
  /** @type {Preset} */
  const preset = { wheel, soil, pressureSinkage: law === followedLaw ? pressureSinkage : exponentsOf(published), contact, shear, braking: state.braking !== "",
    assumed: law === followedLaw ? inForce : withoutLaw(inForce) };
  return {
    ...preset,
    law,
    rule: state.rule ?? followedRule,
    shearLaw: state.shear ?? followedShear,
    followedLaw,
    followedRule,
    followedShear,
    offered,
    hasLugs: (numberIn(LUG_HEIGHT, state[LUG_HEIGHT.key], preset) ?? 0) > 0,
    radius: numberIn(RADIUS, state[RADIUS.key], preset),
    slip: numberIn(SLIP, state[SLIP.key], preset),
  };
}

/**
 * Whether a load is known beside a sinkage, so that the sinkage modulus follows from it.
 * @param {State} state
 */
export const isLoadBeside = ({ by, load_known: known }) => by !== "load" && known !== "";

/**
 * Whether the forces are asked for at the slip angle. The other methods know none, and methods are compared straight ahead.
 * @param {State} state
 */
export const takesSlipAngle = ({ method, compare }) => method === "quadrature" && compare === "";

/**
 * Why a slip angle that was set is not used; empty where it is.
 * @param {State} state
 */
export function slipAngleNote(state) {
  if (takesSlipAngle(state) || !Number(state[SLIP_ANGLE.key])) return "";
  const why = state.compare === "" ? "only the quadrature takes a slip angle" : "methods are compared straight ahead";
  return `Not used: ${why}. The results are those of 0°; the angle is kept.`;
}

/**
 * The groups of fields that matter now. The others are neither shown nor sent.
 * @param {State} state
 * @param {Context} context
 */
export function activeGroups(state, context) {
  const groups = new Set(["slip", "slip_angle", state.by, "wheel", "strength",
    ...groupsOfLaw(PRESSURE_SINKAGE, context.law), ...groupsOfLaw(SHEAR, context.shearLaw), ...groupsOfLaw(CONTACT, context.rule)]);
  groups.add(context.hasLugs ? "circles" : "interface");
  if (state.exit !== "") {
    C3_GROUPS.forEach((group) => groups.delete(group));
    groupsOfLaw(EXIT, state.exit).forEach((group) => groups.add(group));
  }
  // The closed forms know no two zones.
  if (state.method === "quadrature" && !state.compare && (context.braking || (context.slip !== null && context.slip < 0))) groups.add("braking_law");
  if (state.by !== "load") groups.add("load_beside");
  if (isLoadBeside(state)) groups.add("load");
  if (state.by === "static") {
    groups.add("static_law");
    groupsOfLaw(SLIP_SINKAGE, state.slip_sinkage).forEach((group) => groups.add(group));
  }
  if (state.rover !== "") ["rover", state.axles.trim() ? "rover_stations" : "rover_alike"].forEach((group) => groups.add(group));
  if (state.method === "explicit" || state.compare) groups.add("explicit");
  if (state.method === "resistive_force") groups.add("grains");
  return groups;
}
