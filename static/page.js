// The plotting page, once the tables of the service are there. It shows what the service computes. Its own arithmetic is that of drawing: units, axes, and how far measured
// points lie from a drawn curve.
//
// Imports go one way, from this file down to dom/, numbers/ and api/. The ids and attributes that the browser checks rely on are listed
// in .ci/browser/README.md.

import { catalogueOf } from "./api/endpoints.js";
import { showNominalLoad, showOrigin } from "./catalogue/presets.js";
import { createControls } from "./controls/controls.js";
import { button, byId, find } from "./dom/find.js";
import { connectMeasurements } from "./measurements/section.js";
import { connectModel } from "./model/dialog.js";
import { connectRover } from "./rover/rover.js";
import { ALL_PARTS, createView } from "./results/view.js";
import { askAll, faultsOf } from "./rounds/outcomes.js";
import { createRounds } from "./rounds/rounds.js";
import { connectCopy } from "./share/share.js";
import { createAddress } from "./state/address.js";
import { DEFAULTS, changed, consistent, offeredState, stateFromQuery, withoutBraking } from "./state/choices.js";
import { changesFor } from "./state/found-soil.js";
import { contextOf } from "./state/preset.js";
import { settingsOf } from "./state/settings.js";
import { createStatus } from "./status/status.js";
import { connectValidation } from "./validation/section.js";

/** @import { Catalogue } from "./api/types.js" */
/** @import { ShownFault } from "./controls/faults.js" */
/** @import { Part } from "./results/view.js" */
/** @import { Changes, State } from "./state/choices.js" */

/** @type {Catalogue} */
const EMPTY_CATALOGUE = { wheels: new Map(), soils: new Map() };
const app = byId("app");
const fourth = find(app, "#fourth", HTMLSelectElement);

let state = DEFAULTS;
/** Choices of the address that are not offered, as they stand there. @type {string[]} */
let notTaken = [];
let catalogue = EMPTY_CATALOGUE;
let isValidationConnected = false;

const status = createStatus(app, byId("status"));
const controls = createControls(find(app, "#controls", HTMLFormElement), change);
const view = createView(app, {
  fourth: () => state.fourth,
  measured: () => measurements.data(),
  onCurves: (series) => measurements.compare(series),
  onPick: (percent) => change({ slip_pct: String(Number(percent.toFixed(6))) }, { discrete: true }),
});
const rover = connectRover(byId("rover-section"), (degrees) => change({ slope_deg: String(Number(degrees.toFixed(6))) }, { discrete: true }));
const measurements = connectMeasurements(byId("measurements"), {
  settings: () => settingsOf(state, catalogue),
  onData: () => view.drawSlipCharts(),
  onLoadKnown: () => change({ by: "static", load_known: "1" }, { discrete: true }),
  onCircle: (circle) => change({ slip_radius: circle }, { discrete: true }),
  onSoil: (found) => change(changesFor(found, state, catalogue), { discrete: true }),
});
const rounds = createRounds({
  run: round,
  onUnavailable(error, seconds) {
    view.markStale(ALL_PARTS);
    status.offline(error, seconds);
  },
});
const address = createAddress(() => state, () => {
  takeAddress();
  showControls();
  view.drawSlipCharts();
  ask({ supersede: true });
});

/**
 * A choice that is not offered gives way to its default, and the page says so.
 * @param {State} wanted
 */
function takeOffered(wanted) {
  const { state: offered, unknown } = offeredState(wanted, controls.offers);
  state = consistent(offered);
  notTaken.push(...unknown.map(({ key, value }) => `${key}=${value}`));
  byId("notice").textContent = `The address asks for ${notTaken.join(", ")}, which this page does not offer; ${
    notTaken.length === 1 ? "the default is" : "the defaults are"} used instead.`;
  byId("notice").hidden = notTaken.length === 0;
}

function takeAddress() {
  notTaken = [];
  takeOffered(stateFromQuery(location.search));
}

/**
 * @param {Changes} changes
 * @param {{ discrete: boolean }} how
 */
function change(changes, { discrete }) {
  if (discrete) address.flush();
  notTaken = [];
  byId("notice").hidden = true;
  const next = changed(state, changes);
  state = consistent(changes.braking === "" ? withoutBraking(next) : next);
  address.write({ discrete });
  showControls();
  ask({ supersede: discrete });
}

function showControls() {
  const context = contextOf(state, catalogue);
  controls.show(state, context);
  showOrigin(byId("wheel-origin"), context.wheel);
  showOrigin(byId("soil-origin"), context.soil);
  showNominalLoad(byId("nominal-load"), state, context);
  fourth.value = state.fourth;
}

async function fillCatalogue() {
  if (catalogue !== EMPTY_CATALOGUE) return;
  catalogue = await catalogueOf();
  controls.fill(catalogue);
  takeOffered(state);
  showControls();
}

/** @param {AbortSignal} signal */
async function round(signal) {
  app.dataset.busy = "true";
  try {
    await fillCatalogue();
    const settings = settingsOf(state, catalogue);
    if (settings.unreadable.length) {
      showFaults(settings.unreadable, ALL_PARTS);
      return;
    }
    const outcomes = await askAll(settings, signal);
    if (signal.aborted) return;
    const stale = view.show(settings, outcomes);
    await rover.show(settings, outcomes.rover, (outcomes.forces.answer?.warnings ?? []).map(({ code }) => code));
    if (!signal.aborted) showFaults(faultsOf(outcomes), stale);
  } finally {
    app.dataset.busy = "false";
  }
}

/** From an input until its answer nothing on the page is the answer to the inputs. */
function markPending() {
  view.markStale(ALL_PARTS);
  measurements.tell();
  status.pending();
}

/** What is asked for after the inputs have changed. @param {{ supersede: boolean }} how */
function ask(how) {
  markPending();
  rounds.request(how);
}

/**
 * Ends a round: whether the results match the inputs, and if not, why.
 * @param {ShownFault[]} faults
 * @param {Part[]} stale
 */
function showFaults(faults, stale) {
  const placed = controls.showFaults(faults);
  if (!rounds.isLatest()) markPending();
  else {
    view.markStale(stale);
    if (placed.length) status.faults(placed);
    else status.ready();
  }
  app.dataset.round = String(Number(app.dataset.round) + 1);
  // Before the first results the page is so short that this section is in view at once.
  if (!isValidationConnected) connectValidation(byId("validation"));
  isValidationConnected = true;
}

/**
 * A jump within the page must not become a step of the history.
 * @param {MouseEvent} event
 */
function jump(event) {
  const hash = event.target instanceof Element ? event.target.closest("a")?.getAttribute("href") : null;
  if (!hash?.startsWith("#")) return;
  event.preventDefault();
  const target = byId(hash.slice(1));
  target.focus({ preventScroll: true });
  target.scrollIntoView({ block: target.closest("dialog") ? "start" : "center" });
}

connectCopy(button("copy-link"), () => {
  address.flush();
  return location.href;
});
find(byId("nominal-load"), "button").addEventListener("click", () => change({ by: "load", load_n: null }, { discrete: true }));
button("reset-all").addEventListener("click", () => change(DEFAULTS, { discrete: true }));
fourth.addEventListener("change", () => {
  state = changed(state, { fourth: fourth.value });
  address.write({ discrete: true });
  view.drawSlipCharts();
});
document.addEventListener("click", jump);

// On a narrow page the results come below the controls, so the groups start closed.
if (matchMedia("(max-width: 760px)").matches) {
  for (const group of document.querySelectorAll("#controls details")) group.removeAttribute("open");
}
connectModel(find(document, "#model", HTMLDialogElement), byId("open-model"));
status.loading();
takeAddress();
showControls();
rounds.request();
