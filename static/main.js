// The plotting page. It shows what the service computes. Its own arithmetic is that of drawing: units, axes, and how far measured
// points lie from a drawn curve.
//
// For tests: ids and attributes that stay.
//   #app[data-state]          loading | ready | fault | offline; #app[data-round] counts the rounds shown;
//   #app[data-busy] is true while a round is in flight
//   #notice: what of the address was not taken
//   #wheel #soil #method #law #shear #slip-sinkage #rule #normal-stress-radius #peak-sinkage #fourth (selects), #compare #braking (check boxes), #braking-law (select),
//   #by-sinkage #by-load #by-static (radio buttons)
//   input[name="slip"] and so on: the number boxes; input[data-slider="slip"]: their sliders; names as in fields.js
//   [data-reset="radius"], [data-reset-group="wheel"]: back to the preset; .field.changed marks a changed field
//   [data-fault="/wheel/radius_m"]: where the fault of a pointer is shown, hidden while there is none
//   [data-result="longitudinal_force_n"]: a result as text, with the API's number in data-value
//   #comparison-table tr[data-method] td[data-compared][data-value], #status, #announcement
//   #gap-table tr[data-method][data-quantity] td[data-gap="rms|mean|max_abs"][data-value][data-share]; the method of the spread is `spread`
//   #warnings, #profile-warnings, #sweep-warnings: li[data-warning]
//   #scene, #profile-chart, #longitudinal-force-chart, #normal-force-chart, #torque-chart, #fourth-chart;
//   [data-part="tiles|scene|profile|sweep"][data-stale="true"] while what is shown is not the answer to the inputs
//   path.curve[data-style], line[data-mark], g[data-arrow], .plot[role="slider"], .legend .reading
//   #wheel-grade #soil-grade, #wheel-origin #soil-origin: grade, source, notes and values of the chosen entries
//   #validation[data-state]: waiting | loading | ready | failed; in it tr[data-set], td[data-error][data-method][data-value],
//   #validation-drawbar-chart #validation-sinkage-chart #validation-torque-chart
//   #measurements[data-state]: empty | refused | ready; #measurements-file (file input), [data-column="0"] (selects), #measurements-faults li,
//   td[data-rms="torque_n_m"][data-method][data-value], path.point[data-style="measured"] with a circle for each
//   #telemetry[data-state]: idle | following | followed | failed; #follow-track #cancel-track #track-csv, [data-status][data-count],
//   tr[data-event][data-from][data-to], rect.band[data-band], #track-slip-chart #track-sinkage-chart #track-force-chart #track-torque-chart
//   #identification[data-state]: idle | fitting | fitted | failed; input[data-fit="n0"], #fit-soil #cancel-fit #use-soil,
//   tr[data-parameter] td[data-estimate][data-value], [data-held][data-value], td[data-residual][data-value], #fit-warnings li[data-warning], #fit-status
//   #profile-csv #sweep-csv #copy-link #copy-curl #curl #curl-note #reset-all; button[data-gives="tiles|profile|sweep"] is
//   disabled while that part is stale
//   #open-model, dialog#model[open], #model-equations #erratum-1 and so on

import { askAll, faultsOf, warningsOf } from "./answers.js";
import { createAddress } from "./address.js";
import { catalogueOf, curlCommand } from "./api.js";
import { createChart } from "./chart.js";
import { createControls } from "./controls.js";
import { connectEquations } from "./equations.js";
import { profileSpec, sweepSpec } from "./figures.js";
import { connectMeasurements } from "./measurements.js";
import { showNominalLoad, showOrigin } from "./presets.js";
import { createAnnouncer, showComparison, showGaps, showTiles, showWarnings, showWarningsLink } from "./results.js";
import { createRounds } from "./rounds.js";
import { createScene } from "./scene.js";
import { changesFor, contextOf, settingsOf } from "./settings.js";
import { connectCopy, connectCsv } from "./share.js";
import { DEFAULTS, consistent, offeredState, stateFromQuery, withoutBraking } from "./state.js";
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

let state = DEFAULTS;
/** Choices of the address that nobody offers, as they stand there. */
let notTaken = [];
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
const measurements = connectMeasurements(byId("measurements"), {
  settings: () => settingsOf(state, catalogue),
  onData: drawSlipCharts,
  onSoil: (found) => change(changesFor(found, state, catalogue), { discrete: true }),
});
const rounds = createRounds({ run: round, onUnavailable });
const address = createAddress(() => state, () => {
  takeAddress();
  showControls();
  drawSlipCharts();
  rounds.request({ supersede: true });
});

/** A choice that the address makes and nobody offers gives way to its default, and that is said. */
function takeOffered(wanted) {
  const { state: offered, unknown } = offeredState(wanted, controls.offers);
  state = consistent(offered);
  notTaken.push(...unknown.map(({ key, value }) => `${key}=${value}`));
  const isOne = notTaken.length === 1;
  byId("notice").textContent = `The address says ${notTaken.join(", ")}, which this page does not offer: `
    + `${isOne ? "its default stands in for it" : "their defaults stand in for them"}.`;
  byId("notice").hidden = notTaken.length === 0;
}

function takeAddress() {
  notTaken = [];
  takeOffered(stateFromQuery(location.search));
}

function change(changes, { discrete }) {
  if (discrete) address.flush();
  notTaken = [];
  byId("notice").hidden = true;
  state = { ...state, ...changes };
  state = consistent(changes.braking === "" ? { ...state, ...withoutBraking(state) } : state);
  address.write({ discrete });
  showControls();
  rounds.request({ supersede: discrete });
}

function showControls() {
  const context = contextOf(state, catalogue);
  controls.show(state, context);
  showOrigin(byId("wheel-origin"), context.wheel);
  showOrigin(byId("soil-origin"), context.soil);
  showNominalLoad(byId("nominal-load"), state, context);
  byId("fourth").value = state.fourth;
}

function markStale(parts) {
  for (const element of app.querySelectorAll("[data-part]")) {
    element.dataset.stale = String(parts.includes(element.dataset.part));
  }
  // What is not of the inputs must not be carried away as if it were.
  for (const button of app.querySelectorAll("[data-gives]")) button.disabled = parts.includes(button.dataset.gives);
  byId("curl-note").hidden = !(parts.includes("tiles") && shown.forces);
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
      takeOffered(state);
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
  const { forces, sweep, profile, byMethod, series } = outcomes;
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
    shown.sweep = { ...sweep, series, byMethod, slip: settings.slip, method: settings.method };
    drawSlipCharts();
    showGaps(byId("gaps"), { series, spread: sweep.answer.spread });
  }
  const warnings = warningsOf(outcomes);
  showWarnings(byId("warnings"), warnings.forces);
  showWarningsLink(byId("warnings-link"), warnings.forces);
  showWarnings(byId("profile-warnings"), warnings.profile);
  showWarnings(byId("sweep-warnings"), warnings.sweep);
  const answered = { tiles: forces, scene: forces, profile, sweep };
  showFaults(faultsOf(outcomes), ALL_PARTS.filter((part) => !answered[part].answer));
}

function drawSlipCharts() {
  if (!shown.sweep) return;
  const measured = measurements.data();
  for (const { chart, quantityName } of slipCharts) chart.draw(sweepSpec(quantityName(), shown.sweep, measured));
  measurements.compare(shown.sweep.series);
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
connectCsv(byId("profile-csv"), () => shown.profile);
connectCsv(byId("sweep-csv"), () => shown.sweep);

byId("nominal-load").querySelector("button").addEventListener("click", () => change({ by: "load", load_n: null }, { discrete: true }));
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
  target.scrollIntoView({ block: target.closest("dialog") ? "start" : "center" });
});

// On a narrow page the results come below the controls, so the groups start closed.
if (matchMedia("(max-width: 760px)").matches) {
  for (const group of document.querySelectorAll("#controls details")) group.open = false;
}
connectEquations(byId("model"), byId("open-model"));
status.loading();
takeAddress();
showControls();
rounds.request();
