// What one round asks: the forces, the stresses along the contact, and the sweep over slip, by one method or all.

import { Problem } from "../api/client.js";
import { post } from "../api/endpoints.js";
import { compareBody, forcesBody, profileBody, sweepBody } from "../state/bodies.js";
import { roverBody, slopesBody } from "../state/rover-body.js";

/** @import { Drawn } from "../api/endpoints.js" */
/** @import { Comparison, FieldFault, Forces, Method, SlipSweep, StressProfile, SweepColumns, VehicleOnSlope, VehicleOverSlopes } from "../api/types.js" */
/** @import { Settings } from "../state/settings.js" */

/**
 * An answer or a problem, with the request.
 * @template Answer
 * @typedef {{ path: string, body: object, answer: Answer, problem?: undefined } | { path: string, body: object, answer?: undefined, problem: Problem }} Outcome
 */

/** @typedef {SlipSweep | Comparison} Sweep */
/** @typedef {{ method: string, columns: SweepColumns, gap_to_quadrature?: Comparison["series"][number]["gap_to_quadrature"] }} Series */
/** @typedef {{ method: Method, forces: Outcome<Forces> }} MethodOutcome */

/** @typedef {{ slope: Outcome<VehicleOnSlope>, slopes: Outcome<VehicleOverSlopes> }} RoverOutcome */

/**
 * @typedef {object} Outcomes
 * @property {Outcome<Forces>} forces by the chosen method
 * @property {Outcome<Sweep>} sweep
 * @property {Outcome<StressProfile>} profile
 * @property {RoverOutcome | null} rover null where none is asked for
 * @property {MethodOutcome[]} byMethod the forces by all methods asked for
 * @property {Series[]} series their curves
 */

/**
 * A problem is an outcome like an answer. Only a missing answer ends the round.
 * @template {keyof Drawn} Path
 * @param {Path} path
 * @param {Drawn[Path]["body"]} body
 * @param {AbortSignal} signal
 * @returns {Promise<Outcome<Drawn[Path]["answer"]>>}
 */
async function outcomeOf(path, body, signal) {
  try {
    return { path, body, answer: await post(path, body, signal) };
  } catch (error) {
    if (error instanceof Problem) return { path, body, problem: error };
    throw error;
  }
}

/**
 * Where a load is given, the profile waits for the sinkage that the chosen method finds, so that both belong together.
 * @param {Settings} settings
 * @param {Promise<Outcome<Forces>>} forces
 * @param {AbortSignal} signal
 * @returns {Promise<Outcome<StressProfile>>}
 */
async function profileOutcome(settings, forces, signal) {
  /** @param {number} [sinkage] */
  const ask = (sinkage) => outcomeOf("/v1/stress-profile", profileBody(settings, sinkage), signal);
  if (settings.givenName !== "normal_load_n") return ask();
  const outcome = await forces;
  return outcome.problem ? outcome : ask(outcome.answer.sinkage_m);
}

/**
 * The curves of all methods in one request, so that they and their gaps belong together.
 * @param {Settings} settings
 * @param {AbortSignal} signal
 * @returns {Promise<Outcome<Sweep>>}
 */
const sweepOutcome = (settings, signal) => (settings.methods.length > 1
  ? outcomeOf("/v1/compare", compareBody(settings), signal)
  : outcomeOf("/v1/slip-sweep", sweepBody(settings, settings.method), signal));

/**
 * @param {Settings} settings
 * @param {AbortSignal} signal
 * @returns {Promise<RoverOutcome | null>}
 */
async function roverOutcome(settings, signal) {
  const { rover } = settings;
  if (!rover) return null;
  const [slope, slopes] = await Promise.all([roverBody(settings, rover), slopesBody(settings, rover)].map((body) => outcomeOf("/v1/vehicle", body, signal)));
  return /** @type {RoverOutcome} */ ({ slope, slopes });
}

/** A rover has the wheel of the page in other places of its request. @param {FieldFault} fault */
const ofWheel = (fault) => ({ ...fault, pointer: fault.pointer.replace(/^\/(wheels|stations\/\d+)\/wheel(?=\/|$)/, "/wheel") });

/**
 * The curves of each method, and their gaps to the integral where there are several.
 * @param {Outcome<Sweep>} sweep
 * @returns {Series[]}
 */
function seriesOf({ answer }) {
  if (!answer) return [];
  return "series" in answer ? answer.series : [{ method: answer.method, columns: answer.columns }];
}

/**
 * A value that neither the catalogue nor the page has is asked for once, not by every part of the page.
 * @param {Settings} settings
 * @param {AbortSignal} signal
 * @returns {Promise<Outcomes | null>} null where nothing is refused after all
 */
async function refusal(settings, signal) {
  const forces = await outcomeOf("/v1/forces", forcesBody(settings, settings.method), signal);
  return forces.problem ? { forces, sweep: forces, profile: forces, rover: settings.rover && { slope: forces, slopes: forces }, byMethod: [], series: [] } : null;
}

/**
 * @param {Settings} settings
 * @param {AbortSignal} signal
 * @returns {Promise<Outcomes>}
 */
export async function askAll(settings, signal) {
  const refused = settings.isLacking ? await refusal(settings, signal) : null;
  if (refused) return refused;
  const asked = new Map(settings.methods.map((method) => [method, outcomeOf("/v1/forces", forcesBody(settings, method), signal)]));
  const chosen = asked.get(settings.method) ?? outcomeOf("/v1/forces", forcesBody(settings, settings.method), signal);
  const [forces, profile, sweep, rover, ...byMethod] = await Promise.all([
    chosen,
    profileOutcome(settings, chosen, signal),
    sweepOutcome(settings, signal),
    roverOutcome(settings, signal),
    ...[...asked].map(async ([method, outcome]) => ({ method, forces: await outcome })),
  ]);
  return { forces, sweep, profile, rover, byMethod, series: seriesOf(sweep) };
}

/**
 * Under a known load the closed forms need no law of pressure and sinkage, but the stresses along the contact do: the forces stand
 * without them.
 * @param {Outcomes} outcomes
 */
export const hasForcesAlone = ({ forces, profile }) => forces.answer?.normal_stress_from === "load" && profile.problem !== undefined;

/**
 * The faults of the chosen method's outcomes, each once, though several requests may have it.
 * @param {Outcomes} outcomes
 */
export function faultsOf(outcomes) {
  const { forces, sweep, profile, rover } = outcomes;
  const faults = [forces, sweep, ...(rover ? [rover.slope, rover.slopes] : []), ...(hasForcesAlone(outcomes) ? [] : [profile])].flatMap(({ problem }) => problem?.faults ?? []).map(ofWheel);
  return [...new Map(faults.map((fault) => [`${fault.pointer} ${fault.detail}`, fault])).values()];
}
