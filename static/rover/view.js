// The rover on the page: what it does on the chosen slope, each of its wheels, and slip and energy over the slope.

import { createChart } from "../charts/chart.js";
import { chartFigure, titleWithSymbol } from "../charts/figure.js";
import { html } from "../dom/elements.js";
import { byId, find } from "../dom/find.js";
import { columnHeads, rowHead, table } from "../dom/tables.js";
import { QUANTITIES, quantity } from "../quantities/results.js";
import { showWarnings } from "../results/warnings.js";
import { roverWarnings } from "../wording/rover.js";
import { createRoverScene } from "./scene.js";
import { SLOPE_CHARTS, slopeSpec, slopeText } from "./slopes.js";

/** @import { VehicleOnSlope, VehicleOverSlopes } from "../api/types.js" */
/** @import { Settings } from "../state/settings.js" */

/** @typedef {ReturnType<typeof createRoverView>} RoverView */

const TILES = [
  { name: "slip", symbol: "s" },
  { name: "largest_slope_rad", symbol: "α" },
  { name: "needed_pull_n", symbol: "F_x" },
  { name: "torque_n_m", symbol: "T" },
  { name: "energy_per_metre_j_m", symbol: "" },
  { name: "power_w", symbol: "" },
];
const WHEEL_COLUMNS = /** @type {const} */ (["normal_load_n", "sinkage_m", "rut_depth_m", "longitudinal_force_n", "torque_n_m", "energy_per_metre_j_m", "power_w"]);

/** @param {VehicleOnSlope} rover */
function verdict({ climbs, slip, slope_rad: slope, largest_slope_rad: largest, gravity_m_s2: gravity }) {
  const most = typeof largest === "number" ? ` The largest slope that it climbs is ${slopeText(largest)}.` : "";
  const does = climbs ? `It climbs ${slopeText(slope)}, at a slip of ${quantity("slip", slip)}.`
    : typeof slip === "number" ? `It does not climb ${slopeText(slope)} within the slip limit: that takes ${quantity("slip", slip)}.`
      : `It does not climb ${slopeText(slope)}.`;
  return `${does}${most} Gravity ${quantity("gravity_m_s2", gravity)}.`;
}

/**
 * One row for wheels that are alike, else one for each.
 * @param {VehicleOnSlope} rover
 */
function wheelTable({ wheels, loads_from: from }) {
  const isAlike = from === "equal" && wheels.every(({ rut_depth_m: rut }) => rut === 0);
  const columns = WHEEL_COLUMNS.filter((name) => wheels.some((wheel) => typeof wheel[name] === "number" && !(name === "rut_depth_m" && isAlike)));
  const rows = (isAlike ? wheels.slice(0, 1) : wheels).map((wheel, index) => {
    const place = typeof wheel.x_m === "number" && !isAlike ? ` at ${quantity("x_m", wheel.x_m)}` : "";
    return html("tr", { "data-wheel": index },
      rowHead(isAlike ? `Each of ${wheels.length}` : `${index + 1}${place}`),
      ...columns.map((name) => html("td", { "data-rover-wheel": name, "data-value": wheel[name] ?? "" }, quantity(name, wheel[name]))));
  });
  return table({ id: "rover-wheels" }, {
    caption: from === "statics" ? "The wheels; loads by statics of the centre of mass" : "The wheels; equal loads",
    heads: [html("tr", {}, ...columnHeads(["Wheel", ...columns.map((name) => QUANTITIES[name].name)]))],
    rows,
  });
}

/**
 * @param {HTMLElement} host
 * @param {(slope: number) => void} onSlope takes a slope (°) that was chosen in a chart
 */
export function createRoverView(host, onSlope) {
  host.replaceChildren(
    html("p", { id: "rover-verdict" }),
    html("dl", { class: "tiles", id: "rover-tiles" }, ...TILES.map(({ name, symbol }) => html("div", { class: "tile" },
      html("dt", {}, ...titleWithSymbol(QUANTITIES[name].name, symbol)), html("dd", { "data-rover-result": name }, "–")))),
    html("ul", { id: "rover-warnings", class: "warnings", "aria-label": "Warnings about the rover", hidden: true }),
    html("div", { class: "rover-figures" },
      html("figure", {}, html("figcaption", {}, html("h3", {}, "On the slope")),
        html("div", { class: "plot tall", id: "rover-scene" }), html("p", { class: "figure-note", id: "rover-scene-note" })),
      ...SLOPE_CHARTS.map(({ id, name, symbol }) => chartFigure(id, titleWithSymbol(QUANTITIES[name].name, symbol)))),
    html("div", { class: "comparison", id: "rover-table", tabindex: "0", role: "region", "aria-label": "The wheels of the rover" }));
  const scene = createRoverScene(byId("rover-scene"), byId("rover-scene-note"));
  const charts = SLOPE_CHARTS.map(({ id, name }) => ({
    name, chart: createChart(byId(id), { onCursor: (slope) => charts.forEach(({ chart }) => chart.setCursor(slope)), onPick: onSlope }),
  }));

  return {
    /**
     * @param {Settings} settings
     * @param {VehicleOnSlope} rover
     * @param {VehicleOverSlopes} slopes
     * @param {string[]} said codes of the warnings about the wheel by itself
     */
    show(settings, rover, slopes, said) {
      const values = /** @type {Record<string, any>} */ (rover);
      find(host, "#rover-verdict").textContent = verdict(rover);
      for (const { name } of TILES) {
        const tile = find(host, `[data-rover-result="${name}"]`);
        tile.textContent = quantity(name, values[name]);
        tile.dataset.value = String(values[name] ?? "");
        tile.title = name === "power_w" && typeof values[name] !== "number" ? "Set the velocity" : "";
      }
      showWarnings(find(host, "#rover-warnings"), roverWarnings(rover, slopes, said));
      const wheels = find(host, "#rover-table");
      wheels.replaceChildren(...(rover.wheels.length ? [wheelTable(rover)] : []));
      wheels.hidden = !rover.wheels.length;
      scene.draw({ settings, rover });
      for (const { name, chart } of charts) chart.draw(slopeSpec(name, slopes, rover));
    },
  };
}
