// The last good answers on the page: tiles, tables, charts and scene, and what of it is no longer the answer to the inputs.

import { curlCommand } from "../api/curl.js";
import { createChart } from "../charts/chart.js";
import { chartFigure, titleWithSymbol } from "../charts/figure.js";
import { html } from "../dom/elements.js";
import { button, byId, findAll } from "../dom/find.js";
import { sweepSpec } from "../figures/over-slip.js";
import { profileSpec } from "../figures/stress-profile.js";
import { QUANTITIES } from "../quantities/results.js";
import { warningsOf } from "../rounds/warnings.js";
import { createScene } from "../scene/scene.js";
import { connectCopy, connectCsv } from "../share/share.js";
import { basisOf } from "../wording/basis.js";
import { showComparison, showGaps } from "./comparison.js";
import { createAnnouncer, fillParts, showBasis, showTiles } from "./tiles.js";
import { showWarnings, showWarningsLink } from "./warnings.js";

/** @import { FitData } from "../api/types.js" */
/** @import { Series, Outcomes } from "../rounds/outcomes.js" */
/** @import { ShownSweep } from "../figures/over-slip.js" */
/** @import { Settings } from "../state/settings.js" */

/** @typedef {"tiles" | "scene" | "profile" | "sweep" | "rover"} Part */
/** @typedef {{ path: string, body: object }} Asked */

/** @type {Part[]} */
export const ALL_PARTS = ["tiles", "scene", "profile", "sweep", "rover"];

const SLIP_CHARTS = [
  { id: "longitudinal-force-chart", quantity: "longitudinal_force_n", symbol: "F_x" },
  { id: "normal-force-chart", quantity: "normal_force_n", symbol: "F_z" },
  { id: "torque-chart", quantity: "torque_n_m", symbol: "T" },
];
/** The chart whose quantity is chosen. */
const FOURTH_CHART = { id: "fourth-chart", quantity: null };

/** The charts over slip that stand before the one with a choice. */
function fillSlipCharts() {
  byId("slip-charts").prepend(...SLIP_CHARTS.map(({ id, quantity, symbol }) =>
    chartFigure(id, titleWithSymbol(QUANTITIES[quantity].name, symbol), html("p", { class: "placeholder" }, "No curve yet."))));
}

/**
 * @typedef {object} ViewEvents
 * @property {() => string} fourth the quantity of the chart that has a choice
 * @property {() => FitData | null} measured
 * @property {(series: Series[]) => void} onCurves told when the curves over slip are drawn
 * @property {(slip: number) => void} onPick a slip (%) that was chosen in a chart
 */

/**
 * @param {HTMLElement} app
 * @param {ViewEvents} events
 */
export function createView(app, { fourth, measured, onCurves, onPick }) {
  fillParts(byId("parts"));
  fillSlipCharts();
  const announce = createAnnouncer(byId("announcement"));
  const scene = createScene(byId("scene"), byId("scene-note"));
  const profileChart = createChart(byId("profile-chart"));
  const slipCharts = [...SLIP_CHARTS, FOURTH_CHART].map(({ id, quantity }) => ({
    quantity,
    chart: createChart(byId(id), { onCursor: (slip) => slipCharts.forEach(({ chart }) => chart.setCursor(slip)), onPick }),
  }));
  /** @type {{ forces: Asked | null, profile: Asked | null, sweep: (Asked & ShownSweep) | null }} */
  const shown = { forces: null, profile: null, sweep: null };

  connectCopy(button("copy-curl"), () => byId("curl").textContent ?? "");
  connectCsv(button("profile-csv"), () => shown.profile);
  connectCsv(button("sweep-csv"), () => shown.sweep);

  function drawSlipCharts() {
    const { sweep } = shown;
    if (!sweep) return;
    const points = measured();
    for (const { chart, quantity } of slipCharts) chart.draw(sweepSpec(quantity ?? fourth(), sweep, points));
    onCurves(sweep.series);
  }

  /**
   * @param {Settings} settings
   * @param {Outcomes} outcomes
   */
  function showForces(settings, { forces: { body, answer }, profile, byMethod }) {
    if (!answer) return;
    const { radius, lugHeight, lugCount } = settings.drawing;
    shown.forces = { path: "/v1/forces", body };
    showTiles(app, answer);
    showBasis(byId("basis"), basisOf(settings, answer));
    showComparison(byId("comparison"), byMethod);
    if (radius !== null) scene.draw({ radius, lugHeight, lugCount, forces: answer, profile: profile.answer });
    byId("curl").textContent = curlCommand("/v1/forces", body);
    announce(answer);
  }

  /**
   * @param {Settings} settings
   * @param {Outcomes} outcomes
   */
  function showProfile(settings, { forces, profile: { path, body, answer } }) {
    if (!answer) return;
    shown.profile = { path, body };
    profileChart.draw(profileSpec(answer, briefly(settings, forces)));
  }

  /**
   * What the results rest on, as the legends have it.
   * @param {Settings} settings
   * @param {Outcomes["forces"]} forces
   */
  const briefly = (settings, { answer }) => (answer ? basisOf(settings, answer).map(({ brief }) => brief) : []);

  /**
   * @param {Settings} settings
   * @param {Outcomes} outcomes
   */
  function showSweep(settings, { forces: chosen, sweep: { path, body, answer }, series, byMethod }) {
    if (!answer) return;
    const forces = byMethod.map((each) => ({ method: each.method, forces: each.forces.answer ?? null }));
    const { slip, method } = settings;
    shown.sweep = { path, body, series, byMethod: forces, slip, method, basis: briefly(settings, chosen) };
    drawSlipCharts();
    showGaps(byId("gaps"), series, "spread" in answer ? answer.spread : undefined);
  }

  /** @param {Outcomes} outcomes */
  function showAllWarnings(outcomes) {
    const { forces, profile, sweep } = warningsOf(outcomes);
    showWarnings(byId("warnings"), forces);
    showWarningsLink(byId("warnings-link"), forces);
    showWarnings(byId("profile-warnings"), profile);
    showWarnings(byId("sweep-warnings"), sweep);
  }

  return {
    drawSlipCharts,

    /**
     * Shows what was answered, and gives back the parts that were not.
     * @param {Settings} settings
     * @param {Outcomes} outcomes
     */
    show(settings, outcomes) {
      showForces(settings, outcomes);
      showProfile(settings, outcomes);
      showSweep(settings, outcomes);
      showAllWarnings(outcomes);
      const { forces, profile, sweep, rover: onSlopes } = outcomes;
      const isRoverAnswered = !onSlopes || Boolean(onSlopes.slope.answer && onSlopes.slopes.answer);
      const answered = { tiles: forces.answer, scene: forces.answer, profile: profile.answer, sweep: sweep.answer, rover: isRoverAnswered };
      return ALL_PARTS.filter((part) => !answered[part]);
    },

    /**
     * What is not the answer to the inputs is dimmed, and must not be carried away as if it were.
     * @param {Part[]} parts
     */
    markStale(parts) {
      /** @param {string | undefined} part */
      const isStale = (part) => parts.some((each) => each === part);
      for (const element of findAll(app, "[data-part]")) element.dataset.stale = String(isStale(element.dataset.part));
      for (const element of findAll(app, "button[data-gives]")) button(element.id).disabled = isStale(element.dataset.gives);
      byId("curl-note").hidden = !(isStale("tiles") && shown.forces);
    },
  };
}
