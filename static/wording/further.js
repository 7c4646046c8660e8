// The words for what the service says of a towed wheel, of Bekker's estimates and of a pull from torque.

import { QUANTITIES } from "../quantities/results.js";
import { resultWarning } from "./warnings.js";

/** @import { Warning } from "../api/types.js" */

/**
 * What an estimate needs, in the names of the page.
 * @type {Record<string, string>}
 */
const NEEDS = {
  needs_unit_weight: "needs the unit weight of the soil: type it under “Soil strength”.",
  needs_driving_slip: "needs a slip above 0.",
  needs_janosi_hanamoto: "is known for Janosi–Hanamoto’s shear law only.",
  needs_exponent_below_three: "needs a sinkage exponent n₀ below 3.",
};

/** @param {Warning} warning */
export function furtherWarning(warning) {
  const { code, quantity: name = "" } = warning;
  const estimate = QUANTITIES[name]?.name.toLowerCase();
  return estimate && NEEDS[code] ? { code, text: `The ${estimate} ${NEEDS[code]}` } : resultWarning(warning);
}
