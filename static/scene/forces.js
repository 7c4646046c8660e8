// The forces and the torque on the wheel as arrows with labels.

import { svg } from "../dom/elements.js";
import { svgText } from "../dom/text.js";
import { quantity } from "../quantities/results.js";
import { straightArrow, torqueArrow } from "./arrows.js";

/** @import { Forces } from "../api/types.js" */
/** @import { Place } from "./layout.js" */

/** In rim radii. */
const LONGEST_ARROW = 0.8;
const TORQUE_RADIUS = 0.3;
/** On a smaller wheel the symbols stand above their numbers. */
const ROOMY_RADIUS = 112;
const LINE = 14;

/**
 * @param {string} kind
 * @param {string} symbol
 * @param {string} value
 * @param {{ x: number, y: number, "text-anchor"?: string }} place
 * @param {boolean} isStacked
 */
function label(kind, symbol, value, { y, ...place }, isStacked) {
  /** @param {string} text @param {number} at */
  const line = (text, at) => svgText({ class: isStacked ? "arrow-label tight" : "arrow-label", "data-arrow": kind, y: at, ...place }, text);
  return isStacked ? [line(symbol, y - LINE), line(value, y)] : [line(`${symbol} ${value}`, y)];
}

/**
 * @param {Place} place
 * @param {Forces} forces
 */
export function forceArrows({ centre, R }, { longitudinal_force_n: pull, normal_force_n: normal, torque_n_m: torque }) {
  const [cx, cy] = centre;
  const perNewton = (LONGEST_ARROW * R) / (Math.max(Math.abs(pull), Math.abs(normal)) || 1);
  const rho = TORQUE_RADIUS * R;
  const isStacked = R < ROOMY_RADIUS;
  // Right of the hub F_z keeps above F_x; left of it the labels keep above and below the torque's arc.
  const aboveArc = cy - rho - 12;
  const belowArc = cy + rho + (isStacked ? 16 + LINE : 16);
  const clearOfPull = isStacked ? 3 * LINE : 2 * LINE;
  const besideArrow = 0.55 * Math.abs(normal) * perNewton;
  const normalY = cy - Math.sign(normal || 1) * Math.max(besideArrow, clearOfPull);
  const right = { x: cx + 9 };
  const left = { x: cx - 9, "text-anchor": "end" };
  const pullPlace = pull >= 0 ? { ...right, y: cy - 9 } : { ...left, y: belowArc };

  return [
    torqueArrow(centre, rho, torque),
    straightArrow("longitudinal", centre, [pull * perNewton, 0]),
    straightArrow("normal", centre, [0, -normal * perNewton]),
    svg("circle", { class: "hub", cx, cy, r: 3.5 }),
    ...label("normal", "F_z", quantity("normal_force_n", normal), { ...right, y: normalY }, isStacked),
    ...label("longitudinal", "F_x", quantity("longitudinal_force_n", pull), pullPlace, isStacked),
    ...label("torque", "T", quantity("torque_n_m", torque), { ...left, y: aboveArc }, isStacked),
  ];
}
