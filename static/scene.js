// The wheel in the soil, to scale: contact, characteristic angles, sinkage, lugs, and the forces as arrows. Geometry only:
// angles, depths and forces come from the API.

import { svg, svgText } from "./elements.js";
import { degrees, fixed, quantity, significant } from "./format.js";

const TOP = 36;
const LABEL_SPACE = 52;
const LEFT_SPACE = 16;
/** For the sinkage and its label. */
const RIGHT_SPACE = 118;
const STRESS_REACH = 0.3;
const LONGEST_ARROW = 0.8;
const TORQUE_RADIUS = 0.3;
const TORQUE_HALF_SPAN = Math.PI / 4;
const LABEL_SPACING = 72;
/** Drawn where the catalogue does not say how many lugs a wheel has. */
const USUAL_LUG_COUNT = 24;
const ROOM_FOR_TEXT = 26;
const ROOMY_RADIUS = 112;
const LINE = 14;
const SCALE_LENGTHS_MM = [5, 10, 20, 50, 100, 200, 500, 1000];

const coordinates = (points) => points.map(([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`).join("L");

function arrowHead([x, y], direction, size) {
  const at = (along, across) => [
    x + along * Math.cos(direction) - across * Math.sin(direction),
    y + along * Math.sin(direction) + across * Math.cos(direction),
  ];
  return svg("path", { class: "head", d: `M${coordinates([[x, y], at(-size, size * 0.45), at(-size, -size * 0.45)])}Z` });
}

function straightArrow(kind, [x, y], [dx, dy]) {
  const length = Math.hypot(dx, dy);
  const size = Math.min(11, length * 0.6);
  const direction = Math.atan2(dy, dx);
  const shaft = length - size * 0.8;
  return svg("g", { class: "arrow", "data-arrow": kind },
    svg("line", { x1: x, y1: y, x2: x + shaft * Math.cos(direction), y2: y + shaft * Math.sin(direction) }),
    arrowHead([x + dx, y + dy], direction, size));
}

/** Label positions at least `LABEL_SPACING` apart that stay near their targets and between the bounds. */
function spread(targets, low, high) {
  const positions = [...targets];
  for (let index = 1; index < positions.length; index += 1) positions[index] = Math.max(positions[index], positions[index - 1] + LABEL_SPACING);
  const shift = positions.reduce((sum, position, index) => sum + position - targets[index], 0) / positions.length;
  const first = Math.max(low, Math.min(positions[0] - shift, high - (positions.at(-1) - positions[0])));
  return positions.map((position) => position - positions[0] + first);
}

function layout({ width, height }, { radius, lugHeight }) {
  const outer = radius + lugHeight;
  const scale = Math.min(
    (height - TOP - LABEL_SPACE) / (2 * outer + STRESS_REACH * radius),
    (width - LEFT_SPACE - RIGHT_SPACE) / (2 * outer));
  const centre = [Math.min(width / 2, width - RIGHT_SPACE - outer * scale), TOP + outer * scale];
  const R = radius * scale;
  /** A point at `reach` rim radii from the centre, at an angle from straight down. */
  const at = (angle, reach = 1) => [centre[0] + reach * R * Math.sin(angle), centre[1] + reach * R * Math.cos(angle)];
  return { width, height, scale, centre, R, outer: outer * scale, at };
}

function soil({ width, height, R, at }, { entry_rad: entry, exit_rad: exit }) {
  const [entryX, entryY] = at(entry);
  const [exitX, exitY] = at(exit);
  const arc = `A${R} ${R} 0 0 0 ${entryX} ${entryY}`;
  return [
    svg("path", { class: "soil", d: `M0 ${exitY}H${exitX}${arc}H${width}V${height}H0Z` }),
    svg("path", { class: "soil-surface", d: `M0 ${exitY}H${exitX}${arc}H${width}` }),
  ];
}

function stressAlongContact({ at }, { theta_rad: angles, normal_stress_pa: stresses }) {
  const peak = Math.max(...stresses.filter((stress) => stress !== null));
  if (!(peak > 0)) return [];
  const outside = angles.map((angle, index) => at(angle, 1 + (STRESS_REACH * Math.max(0, stresses[index] ?? 0)) / peak));
  const inside = angles.map((angle) => at(angle)).reverse();
  return [svg("path", { class: "contact-stress", d: `M${coordinates(outside)}L${coordinates(inside)}Z` })];
}

function wheel({ centre: [cx, cy], R, outer, scale, at }, { lugHeight, lugCount, shearingRadius }) {
  const parts = [];
  if (lugHeight > 0) {
    const pitch = (2 * Math.PI) / lugCount;
    for (let lug = 0; lug < lugCount; lug += 1) {
      const angle = (lug + 0.5) * pitch;
      const [x1, y1] = at(angle, 0.98);
      const [x2, y2] = at(angle, outer / R);
      parts.push(svg("line", { class: "lug", x1, y1, x2, y2 }));
    }
  }
  if (shearingRadius * scale > R + 1) parts.push(svg("circle", { class: "shearing-radius", cx, cy, r: shearingRadius * scale }));
  parts.push(
    svg("circle", { class: "wheel", cx, cy, r: R }),
    svg("circle", { class: "wheel-inner", cx, cy, r: R * 0.93 }));
  return parts;
}

function angleMarks(place, { entry_rad: entry, maximum_stress_rad: maximum, exit_rad: exit }) {
  const { at, centre: [cx, cy], R, outer, width } = place;
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
      svg("path", { class: "leader", d: `M${coordinates([[x, y], [labels[index], labelY - 12]])}` }),
      svg("circle", { class: "rim-point", cx: x, cy: y, r: 2.5 }),
      svg("text", { class: "scene-label", x: labels[index], y: labelY, "text-anchor": "middle" }, name),
      svgText({ class: "scene-label strong", x: labels[index], y: labelY + 15, "text-anchor": "middle" }, `${symbol} ${fixed(degrees(angle), 1)}°`),
    ];
  });
}

function sinkageMark({ centre: [cx, cy], R, outer, scale }, sinkage) {
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

/** Symbol and number on one line, or one above the other where the wheel is drawn small. */
function arrowLabel(kind, symbol, value, { y, ...place }, stacked) {
  const line = (text, at) => svgText({ class: stacked ? "arrow-label tight" : "arrow-label", "data-arrow": kind, y: at, ...place }, text);
  return stacked ? [line(symbol, y - LINE), line(value, y)] : [line(`${symbol} ${value}`, y)];
}

/** The torque on the left of the hub: clockwise, up along that side, while it drives a wheel that moves to the right. */
function torqueArrow([cx, cy], rho, torque) {
  const sense = torque >= 0 ? 1 : -1;
  const end = Math.PI - sense * TORQUE_HALF_SPAN;
  const onArc = (angle) => [cx + rho * Math.cos(angle), cy - rho * Math.sin(angle)];
  // The head follows the circle's tangent at its end, turned back a little because a head is straight.
  const tangent = -end + sense * (Math.PI / 2 + 0.25);
  const arc = `M${coordinates([onArc(Math.PI + sense * TORQUE_HALF_SPAN)])}A${rho} ${rho} 0 0 ${sense > 0 ? 1 : 0} ${coordinates([onArc(end)])}`;
  return svg("g", { class: "arrow", "data-arrow": "torque" },
    svg("path", { class: "turn", d: arc }),
    ...(torque === 0 ? [] : [arrowHead(onArc(end), tangent, 10)]));
}

function forceArrows({ centre, R }, { longitudinal_force_n: pull, normal_force_n: normal, torque_n_m: torque }) {
  const [cx, cy] = centre;
  const perNewton = (LONGEST_ARROW * R) / (Math.max(Math.abs(pull), Math.abs(normal)) || 1);
  const rho = TORQUE_RADIUS * R;
  const stacked = R < ROOMY_RADIUS;
  // Right of the hub F_z keeps above F_x; left of it the labels keep above and below the torque's arc.
  const aboveArc = cy - rho - 12;
  const belowArc = cy + rho + (stacked ? 16 + LINE : 16);
  const clearOfPull = stacked ? 3 * LINE : 2 * LINE;
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
    ...arrowLabel("normal", "F_z", quantity("normal_force_n", normal), { ...right, y: normalY }, stacked),
    ...arrowLabel("longitudinal", "F_x", quantity("longitudinal_force_n", pull), pullPlace, stacked),
    ...arrowLabel("torque", "T", quantity("torque_n_m", torque), { ...left, y: aboveArc }, stacked),
  ];
}

function travel() {
  return svg("g", { class: "travel" },
    svg("text", { class: "scene-label", x: 12, y: 20 }, "travel"),
    svg("line", { x1: 52, y1: 16, x2: 84, y2: 16 }),
    arrowHead([90, 16], 0, 9));
}

function scaleBar({ width, scale }) {
  const fitting = SCALE_LENGTHS_MM.filter((length) => length * 1e-3 * scale <= 90).at(-1) ?? SCALE_LENGTHS_MM[0];
  const length = fitting * 1e-3 * scale;
  const x = width - 14;
  return svg("g", { class: "scale-bar" },
    svg("path", { d: `M${x - length} 12v8h${length}v-8` }),
    svg("text", { class: "scene-label", x: x - length - 6, y: 20, "text-anchor": "end" }, `${fitting} mm`));
}

export function createScene(host, note) {
  const surface = svg("svg", { role: "img" });
  let spec = null;

  function render() {
    const size = { width: host.clientWidth, height: host.clientHeight };
    if (!spec || size.width < 200 || size.height < 150) return;
    const { radius, lugHeight, lugCount, forces, profile } = spec;
    const place = layout(size, { radius, lugHeight });
    surface.setAttribute("viewBox", `0 0 ${size.width} ${size.height}`);
    const said = (name) => quantity(name, forces[name]);
    surface.setAttribute("aria-label",
      `Wheel of radius ${significant(radius * 1e3)} mm, sunk ${said("sinkage_m")}, moving right. `
      + `Drawbar pull ${said("longitudinal_force_n")}, normal force ${said("normal_force_n")}, torque ${said("torque_n_m")}.`);
    surface.replaceChildren(
      ...soil(place, forces.angles),
      ...(profile ? stressAlongContact(place, profile.columns) : []),
      ...wheel(place, { lugHeight, lugCount: lugCount ?? USUAL_LUG_COUNT, shearingRadius: forces.shearing_radius_m }),
      ...sinkageMark(place, forces.sinkage_m),
      ...angleMarks(place, forces.angles),
      ...forceArrows(place, forces),
      travel(),
      scaleBar(place));
    const lugs = lugHeight > 0 && !lugCount ? ` Lug count unknown: ${USUAL_LUG_COUNT} drawn.` : "";
    const dashed = forces.shearing_radius_m > radius ? " Dashed: shearing radius." : "";
    note.textContent = `To scale. Both forces share one scale. Shaded: normal stress along the contact.${dashed}${lugs}`;
  }

  new ResizeObserver(render).observe(host);

  return {
    draw(next) {
      if (!spec) host.replaceChildren(surface);
      spec = next;
      render();
    },
  };
}
