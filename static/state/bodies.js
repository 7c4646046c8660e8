// The bodies of the requests whose answers are drawn.

/** @import { CompareRequest, ForcesRequest, Method, SlipSweepRequest, StressProfileRequest } from "../api/types.js" */
/** @import { Settings } from "./settings.js" */

const PROFILE_POINTS = 201;
const SWEEP_POINTS = 101;
/** @type {Method[]} */
const CLOSED_FORMS = ["linearised", "explicit"];

/**
 * The options that a method can use.
 * @param {Settings} settings
 * @param {Method} method
 */
export const options = (settings, method) => ({
  ...(settings.normalStressRadius !== "rim" && { normal_stress_radius: settings.normalStressRadius }),
  ...settings.circles,
  ...(settings.peakSinkage && CLOSED_FORMS.includes(method) && { peak_sinkage: settings.peakSinkage }),
  ...(method === "explicit" && settings.lambdas),
});

/**
 * @param {Settings} settings
 * @param {Method} method
 * @returns {ForcesRequest}
 */
export const forcesBody = (settings, method) => ({
  ...settings.common,
  slip: settings.slip,
  ...settings.given,
  ...settings.brakingLaw,
  ...settings.slipAngle,
  method,
  ...options(settings, method),
});

/**
 * Over driving slips, and over braking ones too where these are wanted or the slip itself is one.
 * @param {Settings} settings
 * @param {Method} method
 * @returns {SlipSweepRequest & { method?: Method }}
 */
export function sweepBody(settings, method) {
  const from = settings.braking || settings.slip < 0 ? -1 : 0;
  return { ...forcesBody(settings, method), slip: { from, to: 1, points: SWEEP_POINTS } };
}

/**
 * One body for all methods. The first is the one that the others are compared with.
 * @param {Settings} settings
 * @returns {CompareRequest}
 */
export function compareBody(settings) {
  const { method, ...shared } = sweepBody(settings, settings.method);
  return {
    ...shared,
    methods: settings.methods,
    ...(settings.peakSinkage && { peak_sinkage: settings.peakSinkage }),
    ...settings.lambdas,
  };
}

/**
 * @param {Settings} settings
 * @param {number} [sinkage] takes the place of a load: the profile then belongs to the sinkage that the chosen method found
 * @returns {StressProfileRequest}
 */
export function profileBody(settings, sinkage) {
  const given = sinkage === undefined ? settings.given : { sinkage_m: sinkage };
  return {
    ...settings.common,
    slip: settings.slip,
    ...given,
    ...settings.brakingLaw,
    ...settings.circles,
    ...(settings.method === "resistive_force" && { method: settings.method }),
    ...(settings.peakSinkage && { peak_sinkage: settings.peakSinkage }),
    points: PROFILE_POINTS,
  };
}
