// The rover on the slope, to scale where the places of its axles are given. Geometry only: loads and depths come from the API.

import { svg } from "../dom/elements.js";
import { svgText } from "../dom/text.js";
import { quantity } from "../quantities/results.js";
import { straightArrow } from "../scene/arrows.js";
import { joined } from "../scene/layout.js";
import { slopeText } from "./slopes.js";

/** @import { VehicleOnSlope } from "../api/types.js" */
/** @import { Position } from "../scene/layout.js" */
/** @import { Settings } from "../state/settings.js" */

/** @typedef {{ settings: Settings, rover: VehicleOnSlope }} RoverSpec */

const LEAST_SIZE = { width: 180, height: 140 };
const MARGIN = 34;
/** In rim radii. */
const DRAWN = { spacing: 3, body: 1.5, clearance: 2.6, overhang: 1.4 };
const ARROW_PX = 62;

/**
 * The axles from the front to the rear with the load and the sinkage of one of their wheels.
 * @param {RoverSpec} spec
 * @param {number} radius
 */
function axlesOf({ settings, rover: { wheels } }, radius) {
  const asked = settings.rover;
  const places = asked?.places ?? [...Array(Math.max(1, Math.ceil((asked?.count ?? 1) / 2))).keys()].map((index) => -index * DRAWN.spacing * radius);
  return [...new Set(places)].map((x, index) => {
    const wheel = wheels.find((each) => each.x_m === x) ?? wheels[Math.min(2 * index, wheels.length - 1)];
    return { x, load: wheel?.normal_load_n, sinkage: wheel?.sinkage_m ?? 0 };
  }).sort((a, b) => a.x - b.x);
}

/**
 * From places along and above the slope to pixels, so that all of it is in the drawing.
 * @param {{ width: number, height: number }} size
 * @param {Position[]} corners along and above the slope (m)
 * @param {number} slope
 */
function projection({ width, height }, corners, slope) {
  const [cos, sin] = [Math.cos(slope), Math.sin(slope)];
  /** @param {number} x @param {number} y @returns {Position} */
  const turned = (x, y) => [x * cos - y * sin, x * sin + y * cos];
  const points = corners.map(([x, y]) => turned(x, y));
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const scale = Math.min((width - 2 * MARGIN) / (right - left), (height - 2 * MARGIN) / (high - low));
  const origin = [width / 2 - scale * (left + right) / 2, height / 2 + scale * (low + high) / 2];
  /** @param {number} x @param {number} y @returns {Position} */
  const at = (x, y) => {
    const [across, up] = turned(x, y);
    return [origin[0] + scale * across, origin[1] - scale * up];
  };
  return { at, scale };
}

/** @param {RoverSpec} spec */
const description = ({ rover: { slope_rad: slope, slip, needed_pull_n: pull } }) =>
  `Rover on a slope of ${slopeText(slope)}, driving to the right. Slip ${quantity("slip", slip)}, pull needed ${quantity("needed_pull_n", pull)}.`;

/**
 * @param {RoverSpec} spec
 * @param {{ width: number, height: number }} size
 */
function drawing(spec, size) {
  const { settings: { rover: asked, drawing: { radius } }, rover } = spec;
  const r = radius ?? 0.1;
  const axles = axlesOf(spec, r);
  const [rear, front] = [axles[0].x, axles[axles.length - 1].x];
  const [left, right] = [rear - 3.2 * r, front + 3.2 * r];
  const top = (DRAWN.clearance + DRAWN.body) * r;
  const slope = rover.slope_rad;
  const { at, scale } = projection(size, [[left, -r], [right, -r], [rear, top + r], [front, top + r]], slope);
  const far = 4 * (right - left) + 10 * r;
  const mass = at(asked?.massPlace ?? (rear + front) / 2, asked?.massPlace === undefined ? DRAWN.clearance * r : asked.massHeight ?? 0);
  const hitch = asked?.whole.hitch_pull_n ?? 0;
  const foot = at(left, 0);
  return [
    svg("path", { class: "soil", d: `M${joined([at(-far, 0), at(far, 0), at(far, -far), at(-far, -far)])}Z` }),
    svg("path", { class: "soil-surface", d: `M${joined([at(-far, 0), at(far, 0)])}` }),
    svg("path", { class: "wheel rover-body", d: `M${joined([at(rear - DRAWN.overhang * r, DRAWN.clearance * r), at(front + DRAWN.overhang * r, DRAWN.clearance * r),
      at(front + DRAWN.overhang * r, top), at(rear - DRAWN.overhang * r, top)])}Z` }),
    ...axles.flatMap(({ x, load, sinkage }) => {
      const [cx, cy] = at(x, r - sinkage);
      const [lx, ly] = at(x, -0.75 * r);
      return [
        svg("path", { class: "dimension", d: `M${joined([[cx, cy], at(x, DRAWN.clearance * r)])}` }),
        svg("circle", { class: "wheel", "data-axle": x, cx, cy, r: r * scale }),
        svg("circle", { class: "hub", cx, cy, r: 3 }),
        ...(load === undefined ? [] : [svg("text", { class: "scene-label", x: lx, y: ly + 6, "text-anchor": "middle" }, quantity("normal_load_n", load))]),
      ];
    }),
    svg("line", { class: "extension", x1: foot[0], y1: foot[1], x2: foot[0] + 70, y2: foot[1] }),
    svg("text", { class: "scene-label strong", x: foot[0] + 4, y: foot[1] + 16 }, `α ${slopeText(slope)}`),
    straightArrow("weight", mass, [0, ARROW_PX]),
    svgText({ class: "arrow-label", x: mass[0] + 7, y: mass[1] + ARROW_PX / 2 }, "m g"),
    ...(hitch === 0 ? [] : [straightArrow("hitch", at(rear - DRAWN.overhang * r, 0.15 * r), [-Math.sign(hitch) * 46 * Math.cos(slope), Math.sign(hitch) * 46 * Math.sin(slope)])]),
  ];
}

/**
 * @param {HTMLElement} host
 * @param {HTMLElement} note
 */
export function createRoverScene(host, note) {
  const surface = svg("svg", { role: "img" });
  host.replaceChildren(surface);
  /** @type {RoverSpec | null} */
  let spec = null;

  function render() {
    const size = { width: host.clientWidth, height: host.clientHeight };
    if (!spec || size.width < LEAST_SIZE.width || size.height < LEAST_SIZE.height) return;
    surface.setAttribute("viewBox", `0 0 ${size.width} ${size.height}`);
    surface.setAttribute("aria-label", description(spec));
    surface.replaceChildren(...drawing(spec, size));
    const spacing = spec.settings.rover?.places ? "Wheels and axles to scale" : "Wheels to scale; the spacing of the axles is not given";
    note.textContent = `${spacing}. Under each axle: the load of a wheel.`;
  }

  new ResizeObserver(render).observe(host);

  return {
    /** @param {RoverSpec} next */
    draw(next) {
      spec = next;
      render();
    },
  };
}
