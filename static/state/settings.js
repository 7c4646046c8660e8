// From the choices on the page and the catalogue to the parts of the API's requests.

import { siFromText, typingAdvice } from "../quantities/field-values.js";
import { FIELDS } from "../quantities/fields.js";
import { CONTACT, EXIT, PRESSURE_SINKAGE, SHEAR, SLIP_SINKAGE, groupsAt } from "../quantities/law-fields.js";
import { comparedWith } from "../quantities/results.js";
import { axlePlaces } from "./axles.js";
import { DEFAULTS } from "./choices.js";
import { activeGroups, contextOf, isLoadBeside, takesSlipAngle } from "./preset.js";

/** @import { Catalogue, Contact, FieldFault, ForcesRequest, Method, Soil, VehicleRequest, Wheel } from "../api/types.js" */
/** @import { Field } from "../quantities/fields.js" */
/** @import { State } from "./choices.js" */
/** @import { Context } from "./preset.js" */

/** @typedef {Record<string, number | string | undefined>} Values by the API's names */
/** @typedef {FieldFault & { local: true }} TypingFault */
/** @typedef {"sinkage_m" | "normal_load_n" | "static_sinkage_m"} GivenName */
/** @typedef {Pick<ForcesRequest, GivenName | "slip_sinkage">} GivenPart */

/**
 * @typedef {object} Rover
 * @property {number} count
 * @property {number[] | null} places of the axles (m), null where the wheels are alike
 * @property {number | undefined} massPlace
 * @property {number | undefined} massHeight
 * @property {boolean} rut
 * @property {number} slope
 * @property {number} from
 * @property {number} to
 * @property {Pick<VehicleRequest, "mass_kg" | "gravity_m_s2" | "hitch_pull_n" | "slip_limit" | "forward_velocity_m_s">} whole
 */

/**
 * @typedef {object} Settings
 * @property {TypingFault[]} unreadable fields whose text is no number: such a state has no request
 * @property {string} law
 * @property {boolean} isLacking the catalogue lacks a value, and it has not been typed
 * @property {{ field: Field, value: number, reason: string }[]} assumed values that no one published
 * @property {{ wheel: Wheel, soil: Soil, contact?: Contact, assume?: boolean }} common
 * @property {number} slip
 * @property {GivenPart} given
 * @property {GivenName} givenName
 * @property {Pick<ForcesRequest, "braking">} brakingLaw
 * @property {Pick<ForcesRequest, "slip_angle_rad">} slipAngle
 * @property {Method} method
 * @property {Method[]} methods all that are asked for
 * @property {"rim" | "shearing"} normalStressRadius
 * @property {Pick<ForcesRequest, "slip_radius" | "shear_displacement_radius">} circles where they differ from the service's own, and matter
 * @property {"" | "geometric" | "half"} peakSinkage
 * @property {Pick<ForcesRequest, "lambda_a" | "lambda_b">} lambdas
 * @property {boolean} braking
 * @property {Rover | null} rover null where none is asked for
 * @property {{ radius: number | null, lugHeight: number, lugCount: number | null }} drawing
 */

/** @type {Record<State["by"], GivenName>} */
const GIVEN = { sinkage: "sinkage_m", load: "normal_load_n", static: "static_sinkage_m" };
const LAW_GROUPS = groupsAt(PRESSURE_SINKAGE);
const SHEAR_GROUPS = groupsAt(SHEAR);
const CONTACT_GROUPS = groupsAt(CONTACT);
const EXIT_GROUPS = groupsAt(EXIT);

/** @param {Field} field */
const apiName = ({ pointer }) => pointer.slice(pointer.lastIndexOf("/") + 1);

/**
 * The fields that matter, with the values that were typed into them and the texts that are none.
 * @param {State} state
 * @param {Context} context
 */
function readFields(state, context) {
  const groups = activeGroups(state, context);
  const active = FIELDS.filter((field) => groups.has(field.group));
  /** @type {TypingFault[]} */
  const unreadable = [];
  /** @type {Map<Field, number | string>} */
  const typed = new Map();
  for (const field of active) {
    const text = state[field.key];
    if (text === null) continue;
    const value = siFromText(field, text);
    if (value === null) unreadable.push({ pointer: field.pointer, local: true, detail: typingAdvice(field, text, context) });
    else typed.set(field, value);
  }

  /** @param {Field} field */
  const valueOf = (field) => typed.get(field) ?? field.base(context) ?? undefined;
  /** @param {Field[]} fields @returns {Values} */
  const valuesOf = (fields) => Object.fromEntries(fields.map((field) => [apiName(field), valueOf(field)]));
  /** @param {string[]} names */
  const touched = (...names) => active.filter((field) => names.includes(field.group) && typed.has(field));
  return {
    groups,
    unreadable,
    assumed: active.filter(({ key }) => state[key] === null).flatMap((field) => {
      const substitute = field.substitute?.(context.assumed);
      return substitute ? [{ field, value: substitute.value, reason: substitute.reason }] : [];
    }),
    isLacking: active.some((field) => !field.blank && valueOf(field) === undefined),
    /** @param {string[]} names */
    isTouched: (...names) => touched(...names).length > 0,
    /** The typed values of groups. @param {string[]} names */
    overrides: (...names) => valuesOf(touched(...names)),
    /** All values of groups. @param {string[]} names */
    complete: (...names) => valuesOf(active.filter((field) => names.includes(field.group))),
  };
}

/** @typedef {ReturnType<typeof readFields>} Fields */

/**
 * The API takes a law as a whole, so one changed value of it takes the preset's others along.
 * @param {State} state
 * @param {Context} context
 * @param {Fields} fields
 */
function soilOf(state, context, { isTouched, overrides, complete }) {
  /** @type {Values & { shear?: Values, pressure_sinkage?: Values }} */
  const soil = { preset: state.soil, ...overrides("strength", "grains", ...groupsAt("/soil")) };
  if (state.shear !== null || isTouched(...SHEAR_GROUPS)) soil.shear = { law: context.shearLaw, ...complete(...SHEAR_GROUPS) };
  // Spelling out a preset's incomplete law lets the API name the moduli that are missing. Under a known load some methods need none.
  const isIncomplete = context.soil?.missing.includes("pressure_sinkage") && !isLoadBeside(state) && state.assume === "";
  if (state.law !== null || isIncomplete || isTouched(...LAW_GROUPS)) {
    soil.pressure_sinkage = { law: context.law, ...complete(...LAW_GROUPS) };
  }
  return /** @type {Soil} */ (soil);
}

/**
 * @param {State} state
 * @param {Context} context
 * @param {Fields} fields
 */
function commonOf(state, context, fields) {
  const wheel = /** @type {Wheel} */ ({ preset: state.wheel, ...fields.overrides("wheel") });
  const common = { wheel, soil: soilOf(state, context, fields), ...(state.assume !== "" && { assume: true }) };
  const exit = state.exit !== "" && { exit: fields.complete(...EXIT_GROUPS) };
  const lining = fields.isTouched("interface") && { interface: fields.overrides("interface") };
  if (state.rule === null && !exit && !lining && !fields.isTouched(...CONTACT_GROUPS)) return common;
  const contact = { rule: context.rule, ...fields.complete(...CONTACT_GROUPS), ...exit, ...lining };
  return { ...common, contact: /** @type {Contact} */ (/** @type {unknown} */ (contact)) };
}

/**
 * @param {State} state
 * @param {Fields} fields
 */
function givenOf(state, { complete }) {
  const hasOwnLaw = state.by === "static" && state.slip_sinkage !== "lyasko";
  const law = hasOwnLaw && { slip_sinkage: { law: state.slip_sinkage, ...complete(...groupsAt(SLIP_SINKAGE)) } };
  const load = isLoadBeside(state) && complete("load");
  return /** @type {GivenPart} */ ({ ...complete(state.by), ...load, ...law });
}

/** @param {State} state @returns {TypingFault[]} */
const axleFaults = ({ rover, axles }) => (rover !== "" && axles.trim() && !axlePlaces(axles)
  ? [{ pointer: "/stations", local: true, detail: "Type the place of each axle in mm with blanks between them, such as 600 0 -600." }] : []);

/**
 * @param {State} state
 * @param {Fields} fields
 * @returns {Rover}
 */
function roverOf({ axles, rut }, { complete }) {
  const { slope_rad: slope, from, to, ...whole } = complete("rover");
  const { x_m: massPlace, height_m: massHeight } = complete("rover_stations");
  return /** @type {Rover} */ ({
    count: complete("rover_alike").count, places: axles.trim() ? axlePlaces(axles) : null, massPlace, massHeight, rut: rut !== "",
    slope, from, to, whole: /** @type {unknown} */ (JSON.parse(JSON.stringify(whole))),
  });
}

/**
 * Without lugs all circles are one.
 * @param {State} state
 * @param {Context} context
 */
const circlesOf = ({ slip_radius: slip, shear_displacement_radius: shear }, { hasLugs }) => ({
  ...(hasLugs && slip !== DEFAULTS.slip_radius && { slip_radius: slip }),
  ...(hasLugs && shear !== DEFAULTS.shear_displacement_radius && { shear_displacement_radius: shear }),
});

/**
 * Everything a round of requests needs. Every value that can be read is sent as it is: judging it is the API's part.
 * @param {State} state
 * @param {Catalogue} catalogue
 * @returns {Settings}
 */
export function settingsOf(state, catalogue) {
  const context = contextOf(state, catalogue);
  const fields = readFields(state, context);
  return {
    unreadable: [...fields.unreadable, ...axleFaults(state)],
    law: context.law,
    isLacking: fields.isLacking,
    assumed: fields.assumed,
    common: commonOf(state, context, fields),
    slip: Number(fields.complete("slip").slip),
    given: givenOf(state, fields),
    givenName: GIVEN[state.by],
    brakingLaw: fields.groups.has("braking_law") && state.braking_law !== "one_zone" ? { braking: state.braking_law } : {},
    slipAngle: takesSlipAngle(state) ? fields.overrides("slip_angle") : {},
    method: state.method,
    methods: state.compare ? comparedWith(state.method) : [state.method],
    normalStressRadius: state.normal_stress_radius,
    circles: circlesOf(state, context),
    peakSinkage: state.peak_sinkage,
    lambdas: /** @type {Settings["lambdas"]} */ (fields.overrides("explicit")),
    braking: context.braking,
    rover: state.rover === "" ? null : roverOf(state, fields),
    drawing: {
      radius: context.radius ?? null,
      lugHeight: Number(fields.complete("wheel").lug_height_m ?? 0),
      lugCount: context.wheel?.values.lug_count?.value ?? null,
    },
  };
}
