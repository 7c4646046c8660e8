// Position and size of the wheel in the drawing.

/** @typedef {readonly [number, number]} Position in pixels */

/**
 * @typedef {object} Place
 * @property {number} width
 * @property {number} height
 * @property {number} scale pixels per metre
 * @property {Position} centre of the wheel
 * @property {number} R rim radius in pixels
 * @property {number} outer radius over the lugs in pixels
 * @property {(angle: number, reach?: number) => Position} at a point at `reach` rim radii from the centre, at an angle from straight down
 */

/** How far the largest normal stress reaches from the rim, in rim radii. */
export const STRESS_REACH = 0.3;

const TOP = 36;
const LABEL_SPACE = 52;
const LEFT_SPACE = 16;
/** For the sinkage and its label. */
const RIGHT_SPACE = 118;

/**
 * @param {{ width: number, height: number }} size
 * @param {{ radius: number, lugHeight: number }} wheel
 * @returns {Place}
 */
export function layoutOf({ width, height }, { radius, lugHeight }) {
  const outer = radius + lugHeight;
  const scale = Math.min(
    (height - TOP - LABEL_SPACE) / (2 * outer + STRESS_REACH * radius),
    (width - LEFT_SPACE - RIGHT_SPACE) / (2 * outer));
  const centre = /** @type {const} */ ([Math.min(width / 2, width - RIGHT_SPACE - outer * scale), TOP + outer * scale]);
  const R = radius * scale;
  return {
    width,
    height,
    scale,
    centre,
    R,
    outer: outer * scale,
    at: (angle, reach = 1) => [centre[0] + reach * R * Math.sin(angle), centre[1] + reach * R * Math.cos(angle)],
  };
}

/**
 * Points of a path, joined by lines.
 * @param {readonly Position[]} points
 */
export const joined = (points) => points.map(([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`).join("L");
