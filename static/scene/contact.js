// The soil, the wheel in it, and the stress between them.

import { svg } from "../dom/elements.js";
import { isNumber } from "../numbers/columns.js";
import { STRESS_REACH, joined } from "./layout.js";

/** @import { Angles, ProfileColumns } from "../api/types.js" */
/** @import { Place } from "./layout.js" */

/**
 * @param {Place} place
 * @param {Angles} angles
 */
export function soil({ width, height, R, at }, { entry_rad: entry, exit_rad: exit }) {
  const [entryX, entryY] = at(entry);
  const [exitX, exitY] = at(exit);
  const arc = `A${R} ${R} 0 0 0 ${entryX} ${entryY}`;
  return [
    svg("path", { class: "soil", d: `M0 ${exitY}H${exitX}${arc}H${width}V${height}H0Z` }),
    svg("path", { class: "soil-surface", d: `M0 ${exitY}H${exitX}${arc}H${width}` }),
  ];
}

/**
 * @param {Place} place
 * @param {ProfileColumns} columns
 */
export function stressAlongContact({ at }, { theta_rad: angles, normal_stress_pa: stresses }) {
  const peak = Math.max(...stresses.filter(isNumber));
  if (!(peak > 0)) return [];
  const outside = angles.map((angle, index) => at(angle, 1 + (STRESS_REACH * Math.max(0, stresses[index] ?? 0)) / peak));
  const inside = angles.map((angle) => at(angle)).reverse();
  return [svg("path", { class: "contact-stress", d: `M${joined(outside)}L${joined(inside)}Z` })];
}

/**
 * @param {Place} place
 * @param {number} count
 */
function lugs({ R, outer, at }, count) {
  const pitch = (2 * Math.PI) / count;
  return Array.from({ length: count }, (_, lug) => {
    const angle = (lug + 0.5) * pitch;
    const [[x1, y1], [x2, y2]] = [at(angle, 0.98), at(angle, outer / R)];
    return svg("line", { class: "lug", x1, y1, x2, y2 });
  });
}

/**
 * @param {Place} place
 * @param {{ lugHeight: number, lugCount: number, shearingRadius: number }} wheel lengths in metres
 */
export function wheel(place, { lugHeight, lugCount, shearingRadius }) {
  const { centre: [cx, cy], R, scale } = place;
  const shearing = shearingRadius * scale;
  return [
    ...(lugHeight > 0 ? lugs(place, lugCount) : []),
    ...(shearing > R + 1 ? [svg("circle", { class: "shearing-radius", cx, cy, r: shearing })] : []),
    svg("circle", { class: "wheel", cx, cy, r: R }),
    svg("circle", { class: "wheel-inner", cx, cy, r: R * 0.93 }),
  ];
}
