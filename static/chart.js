// A line chart in SVG: axes, curves with gaps, marked positions, and a cursor for pointer and keyboard whose values stand
// in the legend. It knows nothing of wheels: it is given columns, and draws them.

import { linearScale, roundAxis, ticksWithin } from "./axis.js";
import { html, svg, svgText } from "./elements.js";

const CHARACTER_PX = 6.8;
const LINE_PX = 14;
const MARGIN = { top: 10, right: 14, bottom: 36 };
const TICK_SPACING = { x: 75, y: 34 };
const PAGE_STEPS = 10;
const POINT_PX = 3.5;
const LEAST_BAND_PX = 2;

const isNumber = (value) => value !== null && value !== undefined;

/** Path of a curve; a null lifts the pen, and a lone point keeps a dot's worth of line. */
function curvePath(xs, ys, x, y) {
  let path = "";
  let drawing = false;
  xs.forEach((at, index) => {
    if (!isNumber(ys[index])) {
      drawing = false;
      return;
    }
    const point = `${x(at).toFixed(2)} ${y(ys[index]).toFixed(2)}`;
    path += drawing ? `L${point}` : `M${point}h0.01`;
    drawing = true;
  });
  return path;
}

/** Rows for labels that would overlap: each goes to the first row in which it is clear of its neighbours. */
function labelRows(labels) {
  const ends = [];
  return labels.map(({ start, end }) => {
    const free = ends.findIndex((taken) => start > taken);
    const row = free < 0 ? ends.length : free;
    ends[row] = end;
    return row;
  });
}

/** The measured points between the ends of the axis. */
function pointsWithin({ points, x: { domain } }) {
  if (!points) return [];
  return points.at.map((at, index) => ({ at, value: points.values[index] }))
    .filter(({ at }) => at >= domain[0] && at <= domain[1]);
}

/** All points as circles in one path: telemetry has thousands. */
function pointsPath(points, x, y) {
  const [r, d] = [POINT_PX, 2 * POINT_PX];
  return points.map(({ at, value }) => `M${(x(at) - r).toFixed(2)} ${y(value).toFixed(2)}a${r} ${r} 0 1 0 ${d} 0a${r} ${r} 0 1 0 ${-d} 0`).join("");
}

function nearestIndex(values, target) {
  let best = 0;
  values.forEach((value, index) => {
    if (Math.abs(value - target) < Math.abs(values[best] - target)) best = index;
  });
  return best;
}

/**
 * `onCursor(x)` reports the cursor's position, null when it leaves; `onPick(x)`, if given, a position that was chosen.
 *
 * draw() takes {
 *   label: what the chart shows, for those who cannot see it,
 *   x: { values, domain, label, name, spoken, format },   name in the legend, spoken by screen readers
 *   y: { unit, limits, missing, format }, limits cut the axis, missing says what a null means
 *   curves: [{ key, name, values }],      key selects colour and dashes in the style sheet
 *   marks: [{ key, at, label }],          vertical lines
 *   dots: [{ key, at, value }],           single points of the curves with the same key
 *   points: { key, name, reading, at: [], values: [] },   measured ones, told apart in the legend by `reading` unless `isListed` is false; may be absent
 *   bands: [{ key, from, to }],           stretches of x; may be absent
 *   rest: x at which the legend reads while there is no cursor, or null,
 * }
 */
export function createChart(host, { onCursor, onPick } = {}) {
  const legend = html("ul", { class: "legend" });
  const surface = svg("svg", { role: "presentation" });
  const plot = html("div", {
    class: "plot", tabindex: "0", role: "slider", "aria-orientation": "horizontal", "aria-valuemin": "0", "aria-valuemax": "0", "aria-valuenow": "0",
  }, surface);
  const note = html("p", { class: "figure-note" });
  let spec = null;
  let cursor = null;
  let x = null;
  let y = null;
  let size = { width: 0, height: 0 };
  let overlay = null;
  let pressedBy = null;

  const indexOfCursor = () => nearestIndex(spec.x.values, cursor ?? spec.rest ?? spec.x.values[0]);

  function readOut() {
    const index = indexOfCursor();
    const resting = cursor === null;
    const at = resting ? spec.rest : spec.x.values[index];
    const textOf = (value) => (isNumber(value) ? spec.y.format(value) : "none");
    // At rest the chosen point itself is read, which need not be one of the curve's samples.
    const reading = (curve) => (resting && spec.dots.length ? spec.dots.find(({ key }) => key === curve.key)?.value : curve.values[index]);
    const items = spec.curves.map((curve) =>
      html("li", { "data-curve": curve.key },
        svg("svg", { class: "swatch", viewBox: "0 0 26 8", "aria-hidden": "true" },
          svg("path", { class: "curve", "data-style": curve.key, d: "M1 4H25" })),
        html("span", {}, curve.name),
        html("span", { class: "reading" }, at === null ? "" : textOf(reading(curve)))));
    if (spec.points && spec.points.isListed !== false) {
      items.push(html("li", { "data-curve": spec.points.key },
        svg("svg", { class: "swatch", viewBox: "0 0 26 8", "aria-hidden": "true" },
          svg("path", { class: "curve", "data-style": spec.points.key, d: "M1 4H25" })),
        html("span", {}, spec.points.name),
        html("span", { class: "reading" }, spec.points.reading)));
    }
    legend.replaceChildren(html("li", { class: "position" }, spec.x.name, " ", at === null ? "" : spec.x.format(at)), ...items);
    legend.classList.toggle("at-cursor", !resting);
    plot.setAttribute("aria-valuemax", spec.x.values.length - 1);
    plot.setAttribute("aria-valuenow", index);
    const spoken = spec.curves.map((curve) => `${curve.name} ${textOf(curve.values[index])}`);
    plot.setAttribute("aria-valuetext", [`${spec.x.spoken} ${spec.x.format(spec.x.values[index])}`, ...spoken].join(", "));
  }

  function drawCursor() {
    overlay.replaceChildren();
    if (cursor === null) return;
    const index = indexOfCursor();
    const px = x(spec.x.values[index]);
    overlay.append(svg("line", { class: "cursor", x1: px, x2: px, y1: y.top, y2: y.bottom }));
    for (const curve of spec.curves) {
      const value = curve.values[index];
      if (isNumber(value)) overlay.append(svg("circle", { class: "cursor-dot", "data-style": curve.key, cx: px, cy: y(value), r: 3.5 }));
    }
  }

  /** The marks on the axis, each with its label kept inside the chart. */
  function placedMarks(left, right) {
    return spec.marks.filter(({ at }) => at >= spec.x.domain[0] && at <= spec.x.domain[1]).map((mark) => {
      const half = (mark.label.replace("_", "").length * CHARACTER_PX) / 2;
      const centre = Math.min(Math.max(x(mark.at), left + half), right - half);
      return { ...mark, centre, start: centre - half - 4, end: centre + half + 4 };
    });
  }

  function render() {
    const { width, height } = size;
    if (!spec || width < 40 || height < 40) return;
    surface.setAttribute("viewBox", `0 0 ${width} ${height}`);
    surface.replaceChildren();

    const yTickCount = Math.max(2, Math.round((height - MARGIN.top - LINE_PX - MARGIN.bottom) / TICK_SPACING.y));
    const measured = pointsWithin(spec);
    const values = [...spec.curves.flatMap((curve) => curve.values.filter(isNumber)), ...measured.map(({ value }) => value)];
    const { domain, ticks: yTicks } = roundAxis(values, yTickCount, spec.y.limits);
    const left = 12 + Math.max(spec.y.unit.length + 1, ...yTicks.map(({ text }) => text.length)) * CHARACTER_PX;
    x = linearScale(spec.x.domain, [left, width - MARGIN.right]);

    const marks = placedMarks(left, width - 2);
    const rows = labelRows(marks);
    const top = MARGIN.top + Math.max(1, ...rows.map((row) => row + 1)) * LINE_PX;
    const bottom = height - MARGIN.bottom;
    y = linearScale(domain, [bottom, top]);
    Object.assign(y, { top, bottom });

    const clip = `${host.id}-clip`;
    surface.append(svg("clipPath", { id: clip }, svg("rect", { x: left, y: top - 2, width: width - MARGIN.right - left, height: bottom - top + 4 })));
    for (const tick of yTicks) {
      const py = y(tick.value);
      surface.append(
        svg("line", { class: tick.value === 0 ? "zero" : "grid", x1: left, x2: width - MARGIN.right, y1: py, y2: py }),
        svg("text", { class: "tick-label", x: left - 6, y: py + 4, "text-anchor": "end" }, tick.text));
    }
    for (const { key, from, to } of spec.bands ?? []) {
      const width = Math.max(LEAST_BAND_PX, x(to) - x(from));
      surface.append(svg("rect", { class: "band", "data-band": key, x: x(from), y: top, width, height: bottom - top }));
    }
    surface.append(svg("text", { class: "axis-label", x: left - 6, y: top - LINE_PX + 4, "text-anchor": "end" }, spec.y.unit));
    for (const tick of ticksWithin(spec.x.domain, Math.max(2, Math.round((width - left) / TICK_SPACING.x)))) {
      const px = x(tick.value);
      surface.append(
        svg("line", { class: "grid", x1: px, x2: px, y1: top, y2: bottom + 4 }),
        svg("text", { class: "tick-label", x: px, y: bottom + 16, "text-anchor": "middle" }, tick.text));
    }
    surface.append(svgText({ class: "axis-label", x: (left + width - MARGIN.right) / 2, y: height - 5, "text-anchor": "middle" }, spec.x.label));

    marks.forEach((mark, index) => {
      const px = x(mark.at);
      const labelY = MARGIN.top + rows[index] * LINE_PX + 2;
      surface.append(
        svg("line", { class: "mark", "data-mark": mark.key, x1: px, x2: px, y1: labelY + 4, y2: bottom }),
        svgText({ class: "mark-label", x: mark.centre, y: labelY, "text-anchor": "middle" }, mark.label));
    });
    const curves = svg("g", { "clip-path": `url(#${clip})` });
    for (const curve of spec.curves) {
      curves.append(svg("path", { class: "curve", "data-style": curve.key, d: curvePath(spec.x.values, curve.values, x, y) }));
    }
    for (const dot of spec.dots) {
      if (isNumber(dot.value)) curves.append(svg("circle", { class: "dot", "data-style": dot.key, cx: x(dot.at), cy: y(dot.value), r: 4 }));
    }
    if (measured.length) curves.append(svg("path", { class: "point", "data-style": spec.points.key, d: pointsPath(measured, x, y) }));
    overlay = svg("g", { class: "overlay" });
    surface.append(curves, overlay);
    drawCursor();
    readOut();
    plot.setAttribute("aria-label", spec.label);
  }

  function setCursor(at) {
    cursor = at;
    if (!spec || !overlay) return;
    drawCursor();
    readOut();
  }

  function moveTo(at) {
    setCursor(at);
    onCursor?.(at);
  }

  function positionOf(event) {
    const at = x.invert(event.clientX - plot.getBoundingClientRect().left);
    return spec.x.values[nearestIndex(spec.x.values, at)];
  }

  plot.addEventListener("pointermove", (event) => x && moveTo(positionOf(event)));
  plot.addEventListener("pointerdown", (event) => {
    pressedBy = event.pointerType;
    if (x) moveTo(positionOf(event));
  });
  plot.addEventListener("pointerleave", () => moveTo(null));
  plot.addEventListener("blur", () => moveTo(null));
  plot.addEventListener("click", (event) => {
    // A finger reads the chart by touching it, so only a mouse picks by clicking.
    if (onPick && x && pressedBy === "mouse") onPick(positionOf(event));
  });
  plot.addEventListener("keydown", (event) => {
    if (!spec) return;
    const last = spec.x.values.length - 1;
    const index = indexOfCursor();
    const target = {
      ArrowLeft: index - 1, ArrowDown: index - 1, ArrowRight: index + 1, ArrowUp: index + 1,
      PageDown: index - PAGE_STEPS, PageUp: index + PAGE_STEPS, Home: 0, End: last,
    }[event.key];
    if (target !== undefined) moveTo(spec.x.values[Math.min(last, Math.max(0, target))]);
    else if (event.key === "Escape") moveTo(null);
    else if (event.key === "Enter" && onPick) onPick(spec.x.values[index]);
    else return;
    event.preventDefault();
  });

  new ResizeObserver(() => {
    size = { width: plot.clientWidth, height: plot.clientHeight };
    render();
  }).observe(plot);

  return {
    draw(next) {
      if (!spec) host.replaceChildren(legend, plot, note);
      spec = next;
      note.textContent = gapNote(spec);
      size = { width: plot.clientWidth, height: plot.clientHeight };
      render();
    },
    setCursor,
  };
}

/** What the curves do not show: points without a value, and stretches beyond the axis. */
function gapNote({ curves, y, x }) {
  const { min = -Infinity, max = Infinity } = y.limits ?? {};
  const affected = new Map();
  const tell = (text, curve) => affected.set(text, [...(affected.get(text) ?? []), curve.name]);
  for (const curve of curves) {
    const gaps = curve.values.filter((value) => !isNumber(value)).length;
    if (gaps) tell(`${y.missing ?? "no solution"} at ${gaps} of ${x.values.length} points`, curve);
    if (curve.values.some((value) => isNumber(value) && (value < min || value > max))) tell("partly outside the axis", curve);
  }
  return [...affected].map(([text, names]) => {
    const sentence = names.length === curves.length ? text : `${names.join(" and ")}: ${text}`;
    return `${sentence.charAt(0).toUpperCase()}${sentence.slice(1)}.`;
  }).join(" ");
}
