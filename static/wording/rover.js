// The warnings about a rover: those of the chosen slope, and of the slopes of the charts where they say something else.

import { capitalised } from "../numbers/format.js";
import { resultWarning } from "./warnings.js";

/** @import { VehicleOnSlope, VehicleOverSlopes, Warning } from "../api/types.js" */

/** @param {Warning} warning */
const worded = (warning) => (warning.code === "not_climbed" ? { code: warning.code, text: capitalised(warning.finding) } : resultWarning(warning));

/**
 * @param {VehicleOnSlope} rover
 * @param {VehicleOverSlopes} slopes
 */
export function roverWarnings({ warnings }, { warnings: further }) {
  const codes = warnings.map(({ code }) => code);
  // That a curve ends is seen in the curve.
  const added = further.filter(({ code }) => !codes.includes(code) && code !== "not_climbed");
  return [...warnings, ...added].map(worded);
}
