// The rover's section. What draws it is loaded when a rover is first asked for.

import { needed } from "../api/client.js";
import { postForCsv } from "../api/endpoints.js";
import { button, find } from "../dom/find.js";
import { connectFile } from "../share/share.js";

/** @import { RoverOutcome } from "../rounds/outcomes.js" */
/** @import { Settings } from "../state/settings.js" */
/** @import { RoverView } from "./view.js" */

/**
 * @param {HTMLElement} section
 * @param {(slope: number) => void} onSlope takes a slope (°) that was chosen in a chart
 */
export function connectRover(section, onSlope) {
  /** @type {Promise<RoverView> | null} */
  let view = null;
  /** @type {{ settings: Settings, body: object } | null} */
  let shown = null;

  connectFile(button("rover-csv"), () => {
    if (!shown) throw new Error("There is nothing to save yet.");
    const { settings: { common }, body } = shown;
    return { what: "vehicle", wheel: common.wheel, soil: common.soil, text: () => postForCsv("/v1/vehicle", body) };
  });

  return {
    /**
     * @param {Settings} settings
     * @param {RoverOutcome | null} outcome
     * @param {string[]} said codes of the warnings about the wheel by itself
     */
    async show(settings, outcome, said) {
      section.hidden = outcome === null;
      if (!outcome?.slope.answer || !outcome.slopes.answer) return;
      shown = { settings, body: outcome.slopes.body };
      const { slope, slopes } = outcome;
      view ??= needed(() => import("./view.js")).then(({ createRoverView }) => createRoverView(find(section, "[data-rover]"), onSlope));
      view.catch(() => { view = null; });
      (await view).show(settings, slope.answer, slopes.answer, said);
    },
  };
}
