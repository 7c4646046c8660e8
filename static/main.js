// The plotting page. It shows what the service computes and computes nothing itself.
//
// For tests: ids and attributes that stay.
//   #app[data-state]          loading | ready | fault | offline; #app[data-round] counts the rounds shown;
//   #app[data-busy] is true while a round is in flight
//   #wheel #soil #method #law #rule #normal-stress-radius #peak-sinkage #fourth (selects), #compare #braking (check boxes),
//   #by-sinkage #by-load #by-static (radio buttons)
//   input[name="slip"] and so on: the number boxes; input[data-slider="slip"]: their sliders; names as in fields.js
//   [data-reset="radius"], [data-reset-group="wheel"]: back to the preset; .field.changed marks a changed field
//   [data-fault="/wheel/radius_m"]: where the fault of a pointer is shown, hidden while there is none
//   [data-result="longitudinal_force_n"]: a result as text, with the API's number in data-value
//   #comparison-table tr[data-method] td[data-compared][data-value], #warnings li[data-warning], #status, #announcement
//   #scene, #profile-chart, #longitudinal-force-chart, #normal-force-chart, #torque-chart, #fourth-chart;
//   [data-part="tiles|scene|profile|sweep"][data-stale="true"] while what is shown is not the answer to the inputs
//   path.curve[data-style], line[data-mark], g[data-arrow], .plot[role="slider"], .legend .reading
//   #wheel-grade #soil-grade, #wheel-origin #soil-origin: grade, source, notes and values of the chosen entries
//   #validation[data-state]: waiting | loading | ready | failed; in it tr[data-set], td[data-error][data-method][data-value],
//   #validation-drawbar-chart #validation-sinkage-chart #validation-torque-chart
//   #profile-csv #sweep-csv #copy-link #copy-curl #curl #reset-all

import { askAll, faultsOf, warningsOf } from "./answers.js";
import { createAddress } from "./address.js";
import { catalogueOf, curlCommand } from "./api.js";
import { createChart } from "./chart.js";
import { createControls } from "./controls.js";
import { profileSpec, sweepSpec } from "./figures.js";
import { showOrigin } from "./presets.js";
import { createAnnouncer, showComparison, showTiles, showWarnings } from "./results.js";
import { createRounds } from "./rounds.js";
import { createScene } from "./scene.js";
import { contextOf, settingsOf } from "./settings.js";
import { connectCopy, connectCsv } from "./share.js";
import { DEFAULTS, stateFromQuery } from "./state.js";
import { createStatus } from "./status.js";
import { connectValidation } from "./validation.js";

const EMPTY_CATALOGUE = { wheels: new Map(), soils: new Map() };
/** Beyond this, the status line says that the results are not yet those of the inputs. */
const SLOW_MS = 500;
const ALL_PARTS = ["tiles", "scene", "profile", "sweep"];
const SLIP_CHARTS = {
  "longitudinal-force-chart": () => "longitudinal_force_n",
  "normal-force-chart": () => "normal_force_n",
  "torque-chart": () => "torque_n_m",
  "fourth-chart": () => state.fourth,
};

const byId = (id) => document.getElementById(id);
const app = byId("app");

let state = stateFromQuery(location.search);
let catalogue = EMPTY_CATALOGUE;
/** The last good outcomes: what is on the page, whatever the inputs say since. */
const shown = { forces: null, profile: null, sweep: null };
let validation = null;

const status = createStatus(app, byId("status"));
const announce = createAnnouncer(byId("announcement"));
const controls = createControls(byId("controls"), change);
const scene = createScene(byId("scene"), byId("scene-note"));
const profileChart = createChart(byId("profile-chart"));
const slipCharts = Object.entries(SLIP_CHARTS).map(([id, quantityName]) => ({
  quantityName,
  chart: createChart(byId(id), {
    onCursor: (slip) => slipCharts.forEach(({ chart }) => chart.setCursor(slip)),
    onPick: (percent) => change({ slip_pct: String(Number(percent.toFixed(6))) }, { discrete: true }),
  }),
}));
const rounds = createRounds({ run: round, onUnavailable });
const address = createAddress(() => state, () => {
  state = stateFromQuery(location.search);
  showControls();
  drawSlipCharts();
  rounds.request({ supersede: true });
});

function change(changes, { discrete }) {
  if (discrete) address.flush();
  state = { ...state, ...changes };
  address.write({ discrete });
  showControls();
  rounds.request({ supersede: discrete });
}

function showControls() {
  const context = contextOf(state, catalogue);
  controls.show(state, context);
  showOrigin(byId("wheel-origin"), context.wheel);
  showOrigin(byId("soil-origin"), context.soil);
  byId("fourth").value = state.fourth;
}

function markStale(parts) {
  for (const element of app.querySelectorAll("[data-part]")) {
    element.dataset.stale = String(parts.includes(element.dataset.part));
  }
}

function onUnavailable(error, seconds) {
  markStale(ALL_PARTS);
  status.offline(error, seconds);
}

async function round(signal) {
  app.dataset.busy = "true";
  const slow = setTimeout(status.loading, SLOW_MS);
  try {
    if (catalogue === EMPTY_CATALOGUE) {
      catalogue = await catalogueOf();
      controls.fill(catalogue);
      showControls();
    }
    const settings = settingsOf(state, catalogue);
    if (settings.unreadable.length) {
      showFaults(settings.unreadable, ALL_PARTS);
      return;
    }
    const outcomes = await askAll(settings, signal);
    if (!signal.aborted) showOutcomes(settings, outcomes);
  } finally {
    clearTimeout(slow);
    app.dataset.busy = "false";
  }
}

function showOutcomes(settings, outcomes) {
  const { forces, sweep, profile, byMethod } = outcomes;
  if (forces.answer) {
    shown.forces = forces;
    showTiles(app, forces.answer);
    showComparison(byId("comparison"), byMethod);
    scene.draw({ ...settings.drawing, forces: forces.answer, profile: profile.answer });
    byId("curl").textContent = curlCommand("/v1/forces", forces.body);
    announce(forces.answer);
  }
  if (profile.answer) {
    shown.profile = profile;
    profileChart.draw(profileSpec(profile.answer));
  }
  if (sweep.answer) {
    shown.sweep = { body: sweep.body, byMethod, slip: settings.slip };
    drawSlipCharts();
  }
  showWarnings(byId("warnings"), warningsOf(outcomes));
  const answered = { tiles: forces, scene: forces, profile, sweep };
  showFaults(faultsOf(outcomes), ALL_PARTS.filter((part) => !answered[part].answer));
}

function drawSlipCharts() {
  if (!shown.sweep) return;
  for (const { chart, quantityName } of slipCharts) chart.draw(sweepSpec(quantityName(), shown.sweep));
}

function showFaults(faults, stale) {
  const placed = controls.showFaults(faults);
  markStale(stale);
  if (placed.length) status.faults(placed);
  else status.ready();
  app.dataset.round = Number(app.dataset.round) + 1;
  // Before the first results the page is short, and this section in view though nobody went there.
  validation ??= connectValidation(byId("validation"));
}

connectCopy(byId("copy-curl"), () => byId("curl").textContent);
connectCopy(byId("copy-link"), () => {
  address.flush();
  return location.href;
});
connectCsv(byId("profile-csv"), "/v1/stress-profile", () => shown.profile?.body);
connectCsv(byId("sweep-csv"), "/v1/slip-sweep", () => shown.sweep?.body);

byId("reset-all").addEventListener("click", () => change(DEFAULTS, { discrete: true }));
byId("fourth").addEventListener("change", ({ target }) => {
  state = { ...state, fourth: target.value };
  address.write({ discrete: true });
  drawSlipCharts();
});
// A jump within the page must not become a step of the history.
document.addEventListener("click", (event) => {
  const hash = event.target.closest("a")?.getAttribute("href");
  if (!hash?.startsWith("#")) return;
  event.preventDefault();
  const target = byId(hash.slice(1));
  target.focus({ preventScroll: true });
  target.scrollIntoView({ block: "center" });
});

// On a narrow page the results come below the controls, so the groups start closed.
if (matchMedia("(max-width: 760px)").matches) {
  for (const group of document.querySelectorAll("#controls details")) group.open = false;
}
status.loading();
showControls();
rounds.request();
