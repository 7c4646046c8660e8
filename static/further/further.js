// The section on towing, Bekker's resistances and the pull from a torque. What draws it is loaded when it is first asked for.

import { needed } from "../api/client.js";

/** @import { FurtherOutcome } from "../rounds/further.js" */
/** @import { Settings } from "../state/settings.js" */
/** @import { FurtherView } from "./view.js" */

/** @param {HTMLElement} section */
export function connectFurther(section) {
  /** @type {Promise<FurtherView> | null} */
  let view = null;

  return {
    /**
     * @param {Settings} settings
     * @param {FurtherOutcome | null} outcome
     * @param {string[]} said codes of the warnings about the operating point
     */
    async show(settings, outcome, said) {
      section.hidden = settings.further === null;
      if (!outcome) return;
      view ??= needed(() => import("./view.js")).then(({ createFurtherView }) => createFurtherView(section));
      view.catch(() => { view = null; });
      (await view).show(settings, outcome, said);
    },
  };
}
