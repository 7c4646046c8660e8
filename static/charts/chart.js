// A line chart in SVG with a cursor for pointer and keyboard. It knows nothing of wheels: it draws what it is given.

import { html, svg } from "../dom/elements.js";
import { horizontalGrid, labelledAxes } from "./axes.js";
import { cursorLine, nearestIndex, steppedIndex } from "./cursor.js";
import { clipArea, clippedCurves } from "./curves.js";
import { gapNote } from "./gap-note.js";
import { isLargeEnough, layoutOf } from "./layout.js";
import { bandAreas, markLines } from "./marks.js";
import { legendItems, spokenText } from "./readings.js";

/** @import { Layout } from "./layout.js" */
/** @import { ChartSpec } from "./spec.js" */

/**
 * @typedef {object} ChartEvents
 * @property {(x: number | null) => void} [onCursor] the position of the cursor, null when it leaves
 * @property {(x: number) => void} [onPick] a position that was chosen
 */

/** @typedef {ReturnType<typeof createChart>} Chart */

/** What is drawn, once there is room for it. @typedef {{ spec: ChartSpec, layout: Layout, overlay: SVGGElement }} Drawing */

/**
 * @param {HTMLElement} host
 * @param {ChartEvents} events
 */
export function createChart(host, { onCursor, onPick } = {}) {
  const legend = html("ul", { class: "legend" });
  const surface = svg("svg", { role: "presentation" });
  const plot = html("div", {
    class: "plot", tabindex: "0", role: "slider", "aria-orientation": "horizontal", "aria-valuemin": "0", "aria-valuemax": "0", "aria-valuenow": "0",
  }, surface);
  const note = html("p", { class: "figure-note" });
  /** @type {ChartSpec | null} */
  let spec = null;
  /** @type {Drawing | null} */
  let drawing = null;
  /** @type {number | null} */
  let cursor = null;
  /** @type {string | null} */
  let pressedBy = null;

  /** @param {ChartSpec} shown */
  const indexOfCursor = ({ x, rest }) => nearestIndex(x.values, cursor ?? rest ?? x.values[0]);

  /** @param {Drawing} drawn */
  function showCursor({ spec: shown, layout, overlay }) {
    const index = indexOfCursor(shown);
    const isResting = cursor === null;
    overlay.replaceChildren(...(isResting ? [] : cursorLine(shown, layout, index)));
    legend.replaceChildren(...legendItems(shown, index, isResting));
    legend.classList.toggle("at-cursor", !isResting);
    plot.setAttribute("aria-valuemax", String(shown.x.values.length - 1));
    plot.setAttribute("aria-valuenow", String(index));
    plot.setAttribute("aria-valuetext", spokenText(shown, index));
  }

  function render() {
    const size = { width: plot.clientWidth, height: plot.clientHeight };
    if (!spec || !isLargeEnough(size)) return;
    const layout = layoutOf(spec, size);
    const clip = `${host.id}-clip`;
    const overlay = svg("g", { class: "overlay" });
    surface.setAttribute("viewBox", `0 0 ${size.width} ${size.height}`);
    surface.replaceChildren(
      clipArea(clip, layout),
      ...horizontalGrid(layout),
      ...bandAreas(spec, layout),
      ...labelledAxes(spec, layout),
      ...markLines(layout),
      clippedCurves(spec, layout, clip),
      overlay);
    drawing = { spec, layout, overlay };
    showCursor(drawing);
    plot.setAttribute("aria-label", spec.label);
  }

  /** @param {number | null} at */
  function setCursor(at) {
    cursor = at;
    if (drawing) showCursor(drawing);
  }

  /** @param {number | null} at */
  function moveTo(at) {
    setCursor(at);
    onCursor?.(at);
  }

  /**
   * @param {Drawing} drawn
   * @param {MouseEvent} event
   */
  function sampleAt({ spec: { x }, layout }, event) {
    const at = layout.x.invert(event.clientX - plot.getBoundingClientRect().left);
    return x.values[nearestIndex(x.values, at)];
  }

  plot.addEventListener("pointermove", (event) => drawing && moveTo(sampleAt(drawing, event)));
  plot.addEventListener("pointerdown", (event) => {
    pressedBy = event.pointerType;
    if (drawing) moveTo(sampleAt(drawing, event));
  });
  plot.addEventListener("pointerleave", () => moveTo(null));
  plot.addEventListener("blur", () => moveTo(null));
  plot.addEventListener("click", (event) => {
    // A finger reads the chart by touching it, so only a mouse picks by clicking.
    if (onPick && drawing && pressedBy === "mouse") onPick(sampleAt(drawing, event));
  });
  plot.addEventListener("keydown", (event) => {
    if (!spec) return;
    const { values } = spec.x;
    const index = indexOfCursor(spec);
    const target = steppedIndex(event.key, index, values.length - 1);
    if (target !== null) moveTo(values[target]);
    else if (event.key === "Escape") moveTo(null);
    else if (event.key === "Enter" && onPick) onPick(values[index]);
    else return;
    event.preventDefault();
  });

  new ResizeObserver(render).observe(plot);

  return {
    /** @param {ChartSpec} next */
    draw(next) {
      if (!spec) host.replaceChildren(legend, plot, note);
      spec = next;
      note.textContent = gapNote(spec);
      render();
    },
    setCursor,
  };
}
