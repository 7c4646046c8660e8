// The wheel in the soil, to scale. Geometry only: angles, depths and forces come from the API.

import { svg } from "../dom/elements.js";
import { significant } from "../numbers/format.js";
import { quantity } from "../quantities/results.js";
import { soil, stressAlongContact, wheel } from "./contact.js";
import { angleMarks, scaleBar, sinkageMark, travel } from "./dimensions.js";
import { forceArrows } from "./forces.js";
import { layoutOf } from "./layout.js";

/** @import { Forces, StressProfile } from "../api/types.js" */

/**
 * @typedef {object} SceneSpec
 * @property {number} radius (m)
 * @property {number} lugHeight (m)
 * @property {number | null} lugCount null where the catalogue has none
 * @property {Forces} forces
 * @property {StressProfile | undefined} profile
 */

const USUAL_LUG_COUNT = 24;
const LEAST_SIZE = { width: 200, height: 150 };

/** @param {SceneSpec} spec */
function description({ radius, forces }) {
  return `Wheel of radius ${significant(radius * 1e3)} mm, sunk ${quantity("sinkage_m", forces.sinkage_m)}, moving right. `
    + `Drawbar pull ${quantity("longitudinal_force_n", forces.longitudinal_force_n)}, normal force ${
      quantity("normal_force_n", forces.normal_force_n)}, torque ${quantity("torque_n_m", forces.torque_n_m)}.`;
}

/** @param {SceneSpec} spec */
function noteOf({ radius, lugHeight, lugCount, forces }) {
  const dashed = forces.shearing_radius_m > radius ? " Dashed: shearing radius." : "";
  const lugs = lugHeight > 0 && !lugCount ? ` Lug count unknown: ${USUAL_LUG_COUNT} drawn.` : "";
  return `To scale. Both forces share one scale. Shaded: normal stress along the contact.${dashed}${lugs}`;
}

/**
 * @param {HTMLElement} host
 * @param {HTMLElement} note
 */
export function createScene(host, note) {
  const surface = svg("svg", { role: "img" });
  /** @type {SceneSpec | null} */
  let spec = null;

  function render() {
    const size = { width: host.clientWidth, height: host.clientHeight };
    if (!spec || size.width < LEAST_SIZE.width || size.height < LEAST_SIZE.height) return;
    const { radius, lugHeight, lugCount, forces, profile } = spec;
    const place = layoutOf(size, { radius, lugHeight });
    surface.setAttribute("viewBox", `0 0 ${size.width} ${size.height}`);
    surface.setAttribute("aria-label", description(spec));
    surface.replaceChildren(
      ...soil(place, forces.angles),
      ...(profile ? stressAlongContact(place, profile.columns) : []),
      ...wheel(place, { lugHeight, lugCount: lugCount ?? USUAL_LUG_COUNT, shearingRadius: forces.shearing_radius_m }),
      ...sinkageMark(place, forces.sinkage_m),
      ...angleMarks(place, forces.angles),
      ...forceArrows(place, forces),
      travel(),
      scaleBar(place));
    note.textContent = noteOf(spec);
  }

  new ResizeObserver(render).observe(host);

  return {
    /** @param {SceneSpec} next */
    draw(next) {
      if (!spec) host.replaceChildren(surface);
      spec = next;
      render();
    },
  };
}
