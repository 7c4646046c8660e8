// The published sets of measurements: their series, by the names of the page.

import { METHOD_NAMES } from "../quantities/results.js";

/** @import { ValidationSet } from "../api/types.js" */

/** @type {Record<string, string>} */
export const SERIES_NAMES = { ...METHOD_NAMES, quadrature_two_zone: "Quadrature, two zones" };

/**
 * The series of a wheel at a slip angle differ by their laws alone.
 * @type {Record<string, string>}
 */
export const SIDE_NAMES = {
  quadrature: "Independent, full",
  quadrature_mobilised: "Independent, mobilised",
  quadrature_coupled: "Coupled, full",
  quadrature_coupled_mobilised: "Coupled, mobilised",
};

/** @param {ValidationSet} set */
export const isSideways = (set) => set.slip_angle_rad !== undefined;

/** @param {ValidationSet} set */
export const hasTwoZones = (set) => set.results.some(({ braking }) => braking === "two_zone");

/** @param {ValidationSet} set */
export const isInGrains = (set) => set.results.some(({ method }) => method === "resistive_force");

/** @param {ValidationSet} set */
export const seriesNames = (set) => (isSideways(set) ? SIDE_NAMES : SERIES_NAMES);
