// The warnings about a rover: those of the chosen slope, and of the slopes of the charts where they say something else.

import { capitalised } from "../numbers/format.js";
import { resultWarning } from "./warnings.js";

/** @import { VehicleOnSlope, VehicleOverSlopes, Warning } from "../api/types.js" */

/** What the page says of the slope in a sentence of its own, and in the curves. */
const OF_THE_SLOPE = ["not_climbed", "slip_beyond_limit"];
/** What the page says of the wheel and of what is assumed. */
const SAID = ["assumed_values"];

/** @param {Warning} warning */
const worded = (warning) => (OF_THE_SLOPE.includes(warning.code) ? { code: warning.code, text: capitalised(warning.finding) } : resultWarning(warning));

/**
 * @param {VehicleOnSlope} rover
 * @param {VehicleOverSlopes} slopes
 * @param {string[]} said codes of the warnings about the wheel by itself
 */
export function roverWarnings({ warnings }, { warnings: further }, said) {
  const own = warnings.filter(({ code }) => !said.includes(code) && !SAID.includes(code));
  const codes = [...said, ...SAID, ...OF_THE_SLOPE, ...own.map(({ code }) => code)];
  const added = further.filter(({ code }) => !codes.includes(code));
  return [...own.map(worded), ...added.map((warning) => ({ code: warning.code, text: `On other slopes: ${worded(warning).text}` }))];
}
