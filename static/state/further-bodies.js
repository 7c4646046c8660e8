// The requests about a towed wheel, Bekker's estimates, and the pull that a measured torque gives.

/** @import { CoupledRequest, ResistancesRequest, TowedRequest } from "../api/types.js" */
/** @import { Settings } from "./settings.js" */

/**
 * By the chosen method where it knows towing, else by the quadrature.
 * @param {Settings} settings
 * @param {number} load
 * @returns {TowedRequest}
 */
export const towedBody = ({ common, circles, method }, load) => ({
  ...common,
  normal_load_n: load,
  ...circles,
  ...(method === "resistive_force" && { method }),
});

/**
 * The thrust needs a driving slip.
 * @param {Settings} settings
 * @param {number} load
 * @returns {ResistancesRequest}
 */
export const resistancesBody = ({ common: { contact, ...common }, slip }, load) => ({ ...common, normal_load_n: load, ...(slip > 0 && { slip }) });

/**
 * @param {Settings} settings
 * @param {NonNullable<Settings["further"]>} further
 * @param {{ load: number, sinkage: number, torque: number }} measured
 * @returns {CoupledRequest}
 */
export const coupledBody = ({ common: { wheel, assume }, slip, circles, normalStressRadius }, { contact }, { load, sinkage, torque }) => ({
  wheel,
  contact,
  ...(assume && { assume }),
  ...circles,
  slip,
  sinkage_m: sinkage,
  normal_load_n: load,
  torque_n_m: torque,
  ...(normalStressRadius !== "rim" && { normal_stress_radius: normalStressRadius }),
});
