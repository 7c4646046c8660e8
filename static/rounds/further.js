// What else is asked of the wheel: how it is towed, Bekker's estimates, and the pull that a measured torque gives.

import { coupledBody, resistancesBody, towedBody } from "../state/further-bodies.js";
import { outcomeOf } from "./outcome.js";

/** @import { CoupledForces, Forces, Resistances, Towed } from "../api/types.js" */
/** @import { Settings } from "../state/settings.js" */
/** @import { Outcome } from "./outcome.js" */

/**
 * @typedef {object} FurtherOutcome
 * @property {number} load
 * @property {number} sinkage that of the operating point
 * @property {Outcome<Towed>} towed
 * @property {Outcome<Resistances>} resistances
 * @property {Outcome<CoupledForces> | null} coupled null while no torque is given
 */

/**
 * The load is that of the page. Where a sinkage is given in its place, it is the normal force that goes with it, and the sinkage is found
 * where a load is given: both come with the forces.
 * @param {Settings} settings
 * @param {Promise<Outcome<Forces>>} forces
 * @param {AbortSignal} signal
 * @returns {Promise<FurtherOutcome | null>}
 */
export async function furtherOutcome(settings, forces, signal) {
  const { further, given } = settings;
  if (!further) return null;
  const { answer } = await forces;
  if (!answer) return null;
  const { sinkage_m: sinkage } = answer;
  const load = given.normal_load_n ?? answer.normal_force_n;
  const [towed, resistances, coupled] = await Promise.all([
    outcomeOf("/v1/towed", towedBody(settings, load), signal),
    outcomeOf("/v1/resistances", resistancesBody(settings, load), signal),
    further.torque === undefined ? null : outcomeOf("/v1/coupled", coupledBody(settings, further, { load, sinkage, torque: further.torque }), signal),
  ]);
  return { load, sinkage, towed, resistances, coupled };
}
