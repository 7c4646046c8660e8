// Arrows, with straight or round shafts.

import { svg } from "../dom/elements.js";
import { joined } from "./layout.js";

/** @import { Position } from "./layout.js" */

const TORQUE_HALF_SPAN = Math.PI / 4;

/**
 * @param {Position} tip
 * @param {number} direction (rad)
 * @param {number} size
 */
export function arrowHead([x, y], direction, size) {
  /** @param {number} along @param {number} across @returns {Position} */
  const at = (along, across) => [
    x + along * Math.cos(direction) - across * Math.sin(direction),
    y + along * Math.sin(direction) + across * Math.cos(direction),
  ];
  return svg("path", { class: "head", d: `M${joined([[x, y], at(-size, size * 0.45), at(-size, -size * 0.45)])}Z` });
}

/**
 * @param {string} kind
 * @param {Position} start
 * @param {Position} way
 */
export function straightArrow(kind, [x, y], [dx, dy]) {
  const length = Math.hypot(dx, dy);
  const size = Math.min(11, length * 0.6);
  const direction = Math.atan2(dy, dx);
  const shaft = length - size * 0.8;
  return svg("g", { class: "arrow", "data-arrow": kind },
    svg("line", { x1: x, y1: y, x2: x + shaft * Math.cos(direction), y2: y + shaft * Math.sin(direction) }),
    arrowHead([x + dx, y + dy], direction, size));
}

/**
 * The torque, left of the hub. While it drives a wheel that moves to the right it is clockwise, so up along that side.
 * @param {Position} centre
 * @param {number} rho radius of the arc
 * @param {number} torque
 */
export function torqueArrow([cx, cy], rho, torque) {
  const sense = torque >= 0 ? 1 : -1;
  const end = Math.PI - sense * TORQUE_HALF_SPAN;
  /** @param {number} angle @returns {Position} */
  const onArc = (angle) => [cx + rho * Math.cos(angle), cy - rho * Math.sin(angle)];
  // The head follows the tangent at the end of the arc, turned back a little because a head is straight.
  const tangent = -end + sense * (Math.PI / 2 + 0.25);
  const arc = `M${joined([onArc(Math.PI + sense * TORQUE_HALF_SPAN)])}A${rho} ${rho} 0 0 ${sense > 0 ? 1 : 0} ${joined([onArc(end)])}`;
  return svg("g", { class: "arrow", "data-arrow": "torque" },
    svg("path", { class: "turn", d: arc }),
    ...(torque === 0 ? [] : [arrowHead(onArc(end), tangent, 10)]));
}
