// The requests of a rover on a slope: at the chosen slope, and over a range of slopes.

import { options } from "./bodies.js";

/** @import { VehicleRequest } from "../api/types.js" */
/** @import { Settings } from "./settings.js" */

const SLOPES = 61;

/**
 * Two wheels stand side by side on each axle.
 * @param {Settings} settings
 * @param {Settings["rover"] & {}} rover
 */
function wheelsOf({ common: { wheel } }, { count, places, massPlace, massHeight, rut }) {
  if (!places) return { wheels: { count, wheel } };
  return {
    stations: places.flatMap((place) => [{ x_m: place, wheel }, { x_m: place, wheel }]),
    ...(massPlace !== undefined && { centre_of_mass: { x_m: massPlace, ...(massHeight !== undefined && { height_m: massHeight }) } }),
    ...(rut && { rut: true }),
  };
}

/**
 * @param {Settings} settings
 * @param {Settings["rover"] & {}} rover
 * @param {VehicleRequest["slope_rad"]} slope
 * @returns {VehicleRequest}
 */
function bodyAt(settings, rover, slope) {
  const { wheel, ...common } = settings.common;
  return { ...common, ...wheelsOf(settings, rover), ...rover.whole, slope_rad: slope, method: settings.method, ...options(settings, settings.method) };
}

/**
 * @param {Settings} settings
 * @param {Settings["rover"] & {}} rover
 */
export const roverBody = (settings, rover) => bodyAt(settings, rover, rover.slope);

/**
 * @param {Settings} settings
 * @param {Settings["rover"] & {}} rover
 */
export const slopesBody = (settings, rover) => bodyAt(settings, rover, { from: rover.from, to: rover.to, points: SLOPES });
