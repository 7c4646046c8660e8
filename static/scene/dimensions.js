// What is written around the wheel: contact angles, sinkage, direction of travel, and the scale.

import { svg } from "../dom/elements.js";
import { svgText } from "../dom/text.js";
import { degrees, fixed } from "../numbers/format.js";
import { quantity } from "../quantities/results.js";
import { arrowHead } from "./arrows.js";
import { STRESS_REACH, joined } from "./layout.js";

/** @import { Angles } from "../api/types.js" */
/** @import { Place } from "./layout.js" */

const LABEL_SPACING = 72;
const ROOM_FOR_TEXT = 26;
const SCALE_LENGTHS_MM = [5, 10, 20, 50, 100, 200, 500, 1000];
const LONGEST_SCALE_PX = 90;

/**
 * Positions of labels that stay apart, near their targets, and between the bounds.
 * @param {number[]} targets in rising order
 * @param {number} low
 * @param {number} high
 */
function spread(targets, low, high) {
  const positions = [...targets];
  for (let index = 1; index < positions.length; index += 1) positions[index] = Math.max(positions[index], positions[index - 1] + LABEL_SPACING);
  const length = positions[positions.length - 1] - positions[0];
  const shift = positions.reduce((sum, position, index) => sum + position - targets[index], 0) / positions.length;
  const first = Math.max(low, Math.min(positions[0] - shift, high - length));
  return positions.map((position) => position - positions[0] + first);
}

/**
 * @param {Place} place
 * @param {Angles} angles
 */
export function angleMarks({ at, centre: [cx, cy], R, outer, width }, { entry_rad: entry, maximum_stress_rad: maximum, exit_rad: exit }) {
  const marks = [
    { key: "exit", angle: exit, name: "exit", symbol: "θ_2" },
    { key: "maximum", angle: maximum, name: "max. stress", symbol: "θ_m" },
    { key: "entry", angle: entry, name: "entry", symbol: "θ_1" },
  ];
  const labelY = cy + Math.max(R * (1 + STRESS_REACH), outer) + 22;
  const half = LABEL_SPACING / 2;
  const labels = spread(marks.map(({ angle }) => at(angle, 1.3)[0]), half, width - half);
  return marks.flatMap(({ key, angle, name, symbol }, index) => {
    const [x, y] = at(angle);
    return [
      svg("line", { class: "ray", "data-mark": key, x1: cx, y1: cy, x2: x, y2: y }),
      svg("path", { class: "leader", d: `M${joined([[x, y], [labels[index], labelY - 12]])}` }),
      svg("circle", { class: "rim-point", cx: x, cy: y, r: 2.5 }),
      svg("text", { class: "scene-label", x: labels[index], y: labelY, "text-anchor": "middle" }, name),
      svgText({ class: "scene-label strong", x: labels[index], y: labelY + 15, "text-anchor": "middle" }, `${symbol} ${fixed(degrees(angle), 1)}°`),
    ];
  });
}

/**
 * @param {Place} place
 * @param {number} sinkage (m)
 */
export function sinkageMark({ centre: [cx, cy], R, outer, scale }, sinkage) {
  const x = cx + outer + 22;
  const bottom = cy + R;
  const surface = bottom - sinkage * scale;
  const labelY = bottom - surface > ROOM_FOR_TEXT ? (surface + bottom) / 2 + 4 : surface - 6;
  return [
    svg("line", { class: "extension", x1: cx, x2: x + 6, y1: bottom, y2: bottom }),
    svg("line", { class: "dimension", x1: x, x2: x, y1: surface, y2: bottom }),
    ...[surface, bottom].map((y) => svg("line", { class: "dimension", x1: x - 4, x2: x + 4, y1: y, y2: y })),
    svg("text", { class: "scene-label strong", x: x + 8, y: labelY }, `z ${quantity("sinkage_m", sinkage)}`),
  ];
}

export const travel = () => svg("g", { class: "travel" },
  svg("text", { class: "scene-label", x: 12, y: 20 }, "travel"),
  svg("line", { x1: 52, y1: 16, x2: 84, y2: 16 }),
  arrowHead([90, 16], 0, 9));

/** @param {Place} place */
export function scaleBar({ width, scale }) {
  const fitting = SCALE_LENGTHS_MM.filter((length) => length * 1e-3 * scale <= LONGEST_SCALE_PX).at(-1) ?? SCALE_LENGTHS_MM[0];
  const length = fitting * 1e-3 * scale;
  const x = width - 14;
  return svg("g", { class: "scale-bar" },
    svg("path", { d: `M${x - length} 12v8h${length}v-8` }),
    svg("text", { class: "scene-label", x: x - length - 6, y: 20, "text-anchor": "end" }, `${fitting} mm`));
}
