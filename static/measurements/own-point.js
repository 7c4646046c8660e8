// What a fit predicts for each measured point at its own load or sinkage. It holds while the page has the soil, the wheel and the method of
// the fit: the curves are those of the one load or sinkage of the page.

import { identifyBody } from "../state/measured-bodies.js";

/** @import { FitData } from "../api/types.js" */
/** @import { Settings } from "../state/settings.js" */

/** Root mean squares of predicted minus measured, by quantity (SI). @typedef {Record<string, number>} OwnErrors */

/** @typedef {ReturnType<typeof createOwnPoints>} OwnPoints */

/** What the predictions depend on. @param {Settings} settings @param {FitData} data */
const questionOf = (settings, data) => {
  const { data: _, fit: __, ...rest } = identifyBody(settings, [], data);
  return JSON.stringify(rest);
};

export function createOwnPoints() {
  /** @type {{ errors: OwnErrors, data: FitData, question: string } | null} */
  let known = null;

  return {
    /**
     * The page has taken the soil of a fit.
     * @param {OwnErrors} errors
     * @param {FitData} data
     * @param {Settings} settings
     */
    take(errors, data, settings) {
      known = { errors, data, question: questionOf(settings, data) };
    },
    /**
     * @param {FitData | null} data
     * @param {Settings} settings
     */
    errors: (data, settings) => (data && known?.data === data && known.question === questionOf(settings, data) ? known.errors : null),
  };
}
