// From the person's choices and the catalogue to the bodies of the API's requests.

import { FIELDS, baseText, fieldText } from "./fields.js";
import { siFromText, typingAdvice } from "./typed.js";

const PROFILE_POINTS = 201;
const SWEEP_POINTS = 101;
const GIVEN = { sinkage: "sinkage_m", load: "normal_load_n", static: "static_sinkage_m" };
const METHODS = ["quadrature", "linearised", "explicit"];
const CLOSED_FORMS = ["linearised", "explicit"];
const LAW_GROUPS = ["bekker", "direct", "reece", "diameter"];

/** What untouched fields follow: the chosen entries of the catalogue and the laws in force. */
export function contextOf(state, catalogue) {
  const wheel = catalogue.wheels.get(state.wheel);
  const soil = catalogue.soils.get(state.soil);
  const ownPressureSinkage = soil?.soil.pressure_sinkage ?? { law: "bekker" };
  const law = state.law ?? ownPressureSinkage.law;
  const ownContact = soil?.contact ?? { rule: "midpoint" };
  const rule = state.rule ?? ownContact.rule;
  const ownShear = soil?.soil.shear ?? { law: "janosi_hanamoto" };
  const shearLaw = state.shear ?? ownShear.law;
  const context = {
    wheel,
    soil,
    law,
    rule,
    shearLaw,
    followedLaw: ownPressureSinkage.law,
    followedRule: ownContact.rule,
    followedShear: ownShear.law,
    // The moduli of one law mean nothing to another; the exponents do.
    pressureSinkage: law === ownPressureSinkage.law ? ownPressureSinkage : { n0: ownPressureSinkage.n0, n1: ownPressureSinkage.n1, n2: ownPressureSinkage.n2 },
    contact: ownContact,
    shear: ownShear,
    braking: state.braking !== "",
  };
  const radius = FIELDS.find((field) => field.name === "radius");
  context.radius = state[radius.key] === null ? wheel?.wheel.radius_m : siFromText(radius, state[radius.key]);
  const slip = FIELDS.find((field) => field.name === "slip");
  context.slip = state[slip.key] === null ? slip.base(context) : siFromText(slip, state[slip.key]);
  return context;
}

/** The groups of fields that matter now; the others are neither shown nor sent. */
export function activeGroups(state, context) {
  const groups = new Set(["slip", state.by, "wheel", "strength", "exponent", context.law, "contact"]);
  if (context.shearLaw === "janosi_hanamoto") groups.add("janosi_hanamoto");
  else groups.add("peak");
  if (context.shearLaw === "wong_residual") groups.add("residual");
  // The closed forms know neither a slip angle nor two zones.
  if (state.method === "quadrature" && !state.compare) {
    groups.add("slip_angle");
    if (context.braking || context.slip < 0) groups.add("braking_law");
  }
  if (state.by === "static") groups.add("static_law");
  if (state.by === "static" && state.slip_sinkage === "linear") groups.add("linear");
  if (context.rule === "wong_reece") groups.add("wong_reece");
  if (state.method === "explicit" || state.compare) groups.add("explicit");
  return groups;
}

const lastPart = (pointer) => pointer.slice(pointer.lastIndexOf("/") + 1);

/**
 * Everything a round of requests needs. `unreadable` lists the faults of fields whose text is no number: such a state has
 * no request. All readable values go out as they are, in range or not: judging them is the API's part.
 */
export function settingsOf(state, catalogue) {
  const context = contextOf(state, catalogue);
  const groups = activeGroups(state, context);
  const active = FIELDS.filter((field) => groups.has(field.group));
  const unreadable = [];
  const values = new Map();
  for (const field of active) {
    const text = state[field.key];
    if (text === null) continue;
    const value = siFromText(field, text);
    if (value === null) unreadable.push({ pointer: field.pointer, local: true, detail: typingAdvice(field, text, context) });
    else values.set(field.name, value);
  }

  const valueOf = (field) => values.get(field.name) ?? field.base(context) ?? undefined;
  const touched = (group) => active.filter((field) => field.group === group && values.has(field.name));
  const overrides = (group) => Object.fromEntries(touched(group).map((field) => [lastPart(field.pointer), valueOf(field)]));
  const complete = (names) => Object.fromEntries(
    active.filter((field) => names.includes(field.group)).map((field) => [lastPart(field.pointer), valueOf(field)]));

  const soil = { preset: state.soil, ...overrides("strength"), ...overrides("janosi_hanamoto") };
  if (state.shear !== null || touched("residual").length || touched("peak").length) {
    soil.shear = { law: context.shearLaw, ...complete(["residual", "peak"]) };
  }
  // The API replaces the law as a whole, so one changed modulus takes the preset's others along. Where the preset's law is
  // not complete, spelling it out lets the API name the very moduli that are wanting.
  const isIncomplete = context.soil?.missing?.includes("pressure_sinkage");
  if (state.law !== null || isIncomplete || touched(context.law).length || touched("exponent").length) {
    soil.pressure_sinkage = { law: context.law, ...complete(LAW_GROUPS), ...complete(["exponent"]) };
  }
  const common = { wheel: { preset: state.wheel, ...overrides("wheel") }, soil };
  if (state.rule !== null || touched("wong_reece").length || touched("contact").length) {
    common.contact = { rule: context.rule, ...complete(["wong_reece", "contact"]) };
  }

  return {
    unreadable,
    law: context.law,
    isLacking: active.some((field) => !field.blank && valueOf(field) === undefined),
    common,
    slip: complete(["slip"]).slip,
    given: {
      ...complete([state.by]),
      ...(state.by === "static" && state.slip_sinkage !== "lyasko" && { slip_sinkage: { law: state.slip_sinkage, ...complete(["linear"]) } }),
    },
    brakingLaw: groups.has("braking_law") && state.braking_law !== "one_zone" ? { braking: state.braking_law } : {},
    slipAngle: overrides("slip_angle"),
    givenName: GIVEN[state.by],
    method: state.method,
    methods: state.compare ? METHODS : [state.method],
    normalStressRadius: state.normal_stress_radius,
    peakSinkage: state.peak_sinkage,
    lambdas: overrides("explicit"),
    braking: context.braking,
    drawing: {
      radius: context.radius,
      lugHeight: complete(["wheel"]).lug_height_m ?? 0,
      lugCount: context.wheel?.values?.lug_count?.value ?? null,
    },
  };
}

/** The options that a method has a use for. */
export function options(settings, method) {
  return {
    ...(settings.normalStressRadius !== "rim" && { normal_stress_radius: settings.normalStressRadius }),
    ...(settings.peakSinkage && CLOSED_FORMS.includes(method) && { peak_sinkage: settings.peakSinkage }),
    ...(method === "explicit" && settings.lambdas),
  };
}

/** One body for all methods; the first is the one that the others are compared with. */
export function compareBody(settings) {
  const { method, ...shared } = sweepBody(settings, settings.method);
  return {
    ...shared,
    methods: settings.methods,
    ...(settings.peakSinkage && { peak_sinkage: settings.peakSinkage }),
    ...settings.lambdas,
  };
}

export function forcesBody(settings, method) {
  return { ...settings.common, slip: settings.slip, ...settings.given, ...settings.brakingLaw, ...settings.slipAngle, method, ...options(settings, method) };
}

/** The changes of state that put a soil and a contact of the API into the controls. */
export function changesFor({ soil, contact }, state, catalogue) {
  const shearLaw = soil.shear?.law ?? "janosi_hanamoto";
  const { followedLaw, followedShear, followedRule } = contextOf(state, catalogue);
  const unless = (value, followed) => (value === followed ? null : value);
  const changes = {
    law: unless(soil.pressure_sinkage.law, followedLaw),
    shear: unless(shearLaw, followedShear),
    rule: unless(contact.rule, followedRule),
  };
  const context = contextOf({ ...state, ...changes }, catalogue);
  const groups = activeGroups({ ...state, ...changes }, context);
  for (const field of FIELDS.filter(({ pointer }) => /^\/(soil|contact)\//.test(pointer))) {
    const value = field.pointer.slice(1).split("/").reduce((part, name) => part?.[name], { soil, contact });
    const text = groups.has(field.group) && typeof value === "number" ? fieldText(field, value) : null;
    changes[field.key] = unless(text, baseText(field, context));
  }
  return changes;
}

/** Over driving slips, and over braking ones too when these are wanted or the slip itself is one. */
export function sweepBody(settings, method) {
  const from = settings.braking || settings.slip < 0 ? -1 : 0;
  return { ...forcesBody(settings, method), slip: { from, to: 1, points: SWEEP_POINTS } };
}

/** `sinkage` stands in for a load: the profile then belongs to the sinkage that the chosen method found. */
export function profileBody(settings, sinkage) {
  const given = sinkage === undefined ? settings.given : { sinkage_m: sinkage };
  return {
    ...settings.common,
    slip: settings.slip,
    ...given,
    ...settings.brakingLaw,
    ...(settings.peakSinkage && { peak_sinkage: settings.peakSinkage }),
    points: PROFILE_POINTS,
  };
}
