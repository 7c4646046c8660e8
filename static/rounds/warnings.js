// The warnings of a round, by the part of the page that they are about.

import { METHOD_NAMES } from "../quantities/results.js";
import { hasForcesAlone } from "./outcomes.js";
import { faultText } from "../wording/faults.js";
import { resultWarning, sweepWarning } from "../wording/warnings.js";

/** @import { Warning } from "../api/types.js" */
/** @import { WarningWords } from "../wording/warnings.js" */
/** @import { Outcomes } from "./outcomes.js" */

/** @typedef {{ code: string, text: string, methods: string[] }} ShownWarning with the names of the methods it came with */

/**
 * Each warning once.
 * @param {WarningWords[]} warnings
 * @returns {ShownWarning[]}
 */
function gathered(warnings) {
  /** @type {Map<string, ShownWarning>} */
  const shown = new Map();
  for (const { code, text, methods } of warnings) {
    const key = `${code} ${text}`;
    shown.set(key, { code, text, methods: [...(shown.get(key)?.methods ?? []), ...methods.map((method) => METHOD_NAMES[method])] });
  }
  return [...shown.values()];
}

/** @param {ShownWarning} warning */
const isUrgent = ({ code }) => code === "outside_catalogue";

/**
 * A value that no soil of the catalogue comes near may be in the wrong unit: that comes first.
 * @param {ShownWarning[]} warnings
 */
const urgentFirst = (warnings) => [...warnings.filter(isUrgent), ...warnings.filter((warning) => !isUrgent(warning))];

/**
 * What is said of the results is not said again of the curves.
 * @param {Outcomes} outcomes
 */
export function warningsOf(outcomes) {
  const { sweep, profile, byMethod, series } = outcomes;
  /** What was assumed stands with its reasons among what the results rest on. @param {Warning} warning */
  const isNews = ({ code }) => code !== "assumed_values";
  const isCompared = byMethod.length > 1;
  const slips = series[0]?.columns.slip ?? [];
  const ofForces = byMethod.flatMap(({ method, forces: { answer } }) =>
    (answer?.warnings ?? []).filter(isNews).map((warning) => ({ ...resultWarning(warning), methods: isCompared ? [method] : [] })));
  const ofSweep = (sweep.answer?.warnings ?? []).filter(isNews).map((warning) => sweepWarning(warning, slips));
  const ofProfile = (profile.answer?.warnings ?? []).filter(isNews).map(resultWarning);
  const said = new Set(ofForces.map(({ gist }) => gist));
  /** @param {WarningWords[]} warnings */
  const further = (warnings) => gathered(warnings.filter(({ gist }) => !said.has(gist)));
  /** @type {ShownWarning[]} */
  const refused = hasForcesAlone(outcomes) ? [{ code: "no_profile", methods: [],
    text: `The forces need no law of pressure and sinkage here, the stresses do: it ${profile.problem?.faults.map((fault) => faultText(fault)).join(" ")}` }] : [];
  return { forces: urgentFirst(gathered(ofForces)), sweep: further(ofSweep), profile: [...refused, ...further(ofProfile)] };
}
