// The plotting page. It shows what the service computes and computes nothing itself.
//
// For tests: ids and attributes that stay.
//   #app[data-state]          loading | ready | fault | offline; #app[data-round] counts the rounds shown
//   #wheel #soil #method #law #rule #normal-stress-radius #peak-sinkage #fourth (selects), #compare #braking (check boxes),
//   #by-sinkage #by-load #by-static (radio buttons)
//   input[name="slip"] and so on: the number boxes; input[data-slider="slip"]: their sliders; names as in fields.js
//   [data-reset="radius"], [data-reset-group="wheel"]: back to the preset; .field.changed marks a changed field
//   [data-fault="/wheel/radius_m"]: where the fault of a pointer is shown, hidden while there is none
//   [data-result="longitudinal_force_n"]: a result as text, with the API's number in data-value
//   #comparison-table tr[data-method] td[data-compared][data-value], #warnings li[data-warning], #status, #announcement
//   #scene, #profile-chart, #longitudinal-force-chart, #normal-force-chart, #torque-chart, #fourth-chart;
//   [data-part="tiles|scene|profile|sweep"][data-stale="true"] while what is shown is not the answer to the inputs
//   path.curve[data-style], line[data-mark], g[data-arrow], .plot[role="slider"], .legend output.reading
//   #profile-csv #sweep-csv #copy-link #copy-curl #curl #reset-all

import { Problem, catalogueOf, curlCommand, post, postForCsv } from "./api.js";
import { createChart } from "./chart.js";
import { createControls } from "./controls.js";
import { profileSpec, sweepSpec } from "./figures.js";
import { createAnnouncer, showComparison, showTiles, showWarnings } from "./results.js";
import { createRounds } from "./rounds.js";
import { createScene } from "./scene.js";
import { contextOf, forcesBody, profileBody, settingsOf, sweepBody } from "./settings.js";
import { copyText, saveFile } from "./share.js";
import { DEFAULTS, queryFromState, stateFromQuery } from "./state.js";

/** Browsers refuse addresses that change too often. */
const ADDRESS_PAUSE_MS = 250;
const NOTICE_MS = 2500;
const SLIP_CHARTS = {
  "longitudinal-force-chart": () => "longitudinal_force_n",
  "normal-force-chart": () => "normal_force_n",
  "torque-chart": () => "torque_n_m",
  "fourth-chart": () => state.fourth,
};

const byId = (id) => document.getElementById(id);
const app = byId("app");

let state = stateFromQuery(location.search);
let catalogue = null;
/** The last good answers with the requests that gave them: what is on the page, whatever the inputs say since. */
const shown = { forces: null, profile: null, sweep: null };

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
const announce = createAnnouncer(byId("announcement"));
const rounds = createRounds({ run: round, onUnavailable });

let addressTimer = null;

function writeAddress({ discrete }) {
  clearTimeout(addressTimer);
  const address = location.pathname + queryFromState(state);
  if (address === location.pathname + location.search) return;
  // A decision can be undone with the back button; the steps of a slider would only be in the way there.
  if (discrete) history.pushState(null, "", address);
  else addressTimer = setTimeout(() => history.replaceState(null, "", address), ADDRESS_PAUSE_MS);
}

function flushAddress() {
  clearTimeout(addressTimer);
  history.replaceState(null, "", location.pathname + queryFromState(state));
}

function showControls() {
  controls.show(state, contextOf(state, catalogue));
  byId("fourth").value = state.fourth;
}

function change(changes, { discrete }) {
  if (discrete) flushAddress();
  state = { ...state, ...changes };
  writeAddress({ discrete });
  if (!catalogue) return;
  showControls();
  rounds.request({ supersede: discrete });
}

function setStatus(text, stateName) {
  const status = byId("status");
  if (status.textContent !== text) status.textContent = text;
  app.dataset.state = stateName;
}

function markStale(parts) {
  for (const element of app.querySelectorAll("[data-part]")) {
    element.dataset.stale = String(parts.includes(element.dataset.part));
  }
}

const ALL_PARTS = ["tiles", "scene", "profile", "sweep"];

function onUnavailable(error, seconds) {
  markStale(ALL_PARTS);
  const shownMeanwhile = shown.forces ? " Dimmed results are the last good ones." : "";
  setStatus(`${error.message} Trying again in ${Math.round(seconds)} s.${shownMeanwhile}`, "offline");
}

async function outcomeOf(promise) {
  try {
    return { answer: await promise };
  } catch (error) {
    if (error instanceof Problem) return { problem: error };
    throw error;
  }
}

async function askAll(settings, signal) {
  const forces = settings.methods.map((method) => outcomeOf(post("/v1/forces", forcesBody(settings, method), signal)));
  const sweeps = settings.methods.map((method) => outcomeOf(post("/v1/slip-sweep", sweepBody(settings, method), signal)));
  const chosen = settings.methods.indexOf(settings.method);
  const profile = forces[chosen].then(({ answer, problem }) => {
    if (settings.givenName !== "normal_load_n") return askProfile(profileBody(settings), signal);
    return problem ? { problem } : askProfile(profileBody(settings, answer.sinkage_m), signal);
  });
  const [allForces, allSweeps, profileOutcome] = await Promise.all([Promise.all(forces), Promise.all(sweeps), profile]);
  return { forces: allForces, sweeps: allSweeps, profile: profileOutcome, chosen };
}

async function askProfile(body, signal) {
  return { ...await outcomeOf(post("/v1/stress-profile", body, signal)), body };
}

function faultsOf(problems) {
  const faults = problems.flatMap((problem) => (problem.errors.length ? problem.errors : [{ pointer: "", detail: problem.message }]));
  return [...new Map(faults.map((fault) => [`${fault.pointer} ${fault.detail}`, fault])).values()];
}

async function round(signal) {
  if (!catalogue) {
    const loaded = await catalogueOf();
    catalogue = loaded;
    controls.fill(catalogue);
    showControls();
  }
  const settings = settingsOf(state, catalogue);
  if (settings.unreadable.length) {
    showFaults(settings.unreadable.map(({ pointer, usual, word }) => ({
      pointer, local: true, detail: `Type a number${word ? ` or “${word}”` : ""}${usual ? `, such as ${usual}` : ""}.`,
    })), ALL_PARTS);
    return;
  }
  const outcome = await askAll(settings, signal);
  if (!signal.aborted) showOutcome(settings, outcome);
}

function showOutcome(settings, { forces, sweeps, profile, chosen }) {
  const stale = [];
  const outcomes = settings.methods.map((method, index) => ({
    method, forces: forces[index].answer, problem: forces[index].problem?.message,
  }));

  if (forces[chosen].answer) {
    shown.forces = { answer: forces[chosen].answer, body: forcesBody(settings, settings.method), drawing: settings.drawing, outcomes };
    showTiles(app, shown.forces.answer);
    showComparison(byId("comparison"), outcomes);
    byId("curl").textContent = curlCommand("/v1/forces", shown.forces.body);
    announce(shown.forces.answer);
  } else stale.push("tiles", "scene");

  if (profile.answer) {
    shown.profile = { answer: profile.answer, body: profile.body };
    profileChart.draw(profileSpec(profile.answer));
  } else stale.push("profile");

  if (forces[chosen].answer) {
    scene.draw({ ...settings.drawing, forces: forces[chosen].answer, profile: profile.answer ?? null });
  }

  const withColumns = settings.methods
    .map((method, index) => ({ method, ...sweeps[index].answer }))
    .filter(({ columns }) => columns);
  if (sweeps[chosen].answer) {
    shown.sweep = { sweeps: withColumns, points: outcomes, slip: settings.slip, body: sweepBody(settings, settings.method) };
    drawSlipCharts();
  } else stale.push("sweep");

  showWarnings(byId("warnings"), [...forces, ...sweeps, profile].flatMap(({ answer }) => answer?.warnings ?? []));
  showFaults(faultsOf([forces[chosen], sweeps[chosen], profile].map(({ problem }) => problem).filter(Boolean)), stale);
}

function drawSlipCharts() {
  if (!shown.sweep) return;
  for (const { chart, quantityName } of slipCharts) chart.draw(sweepSpec(quantityName(), shown.sweep));
}

function showFaults(faults, stale) {
  const homeless = controls.showFaults(faults);
  markStale(stale);
  if (faults.length === 0) {
    setStatus("Results match the inputs.", "ready");
  } else {
    const marked = faults.length - homeless.length;
    const places = marked === 0 ? "" : marked === 1 ? "One input is refused; it is marked." : `${marked} faults in the inputs; they are marked.`;
    const others = homeless.map(({ pointer, detail }) => (pointer ? `${pointer}: ${detail}` : detail));
    setStatus([...others, places, "Dimmed results are the last good ones."].filter(Boolean).join(" "), "fault");
  }
  app.dataset.round = Number(app.dataset.round) + 1;
}

function notice(button, text) {
  const usual = button.dataset.usual ?? button.textContent;
  button.dataset.usual = usual;
  button.textContent = text;
  byId("announcement").textContent = text;
  setTimeout(() => { button.textContent = usual; }, NOTICE_MS);
}

function onCopy(id, text) {
  const button = byId(id);
  button.addEventListener("click", async () => {
    try {
      await copyText(text());
      notice(button, "Copied");
    } catch {
      notice(button, "Cannot copy here");
    }
  });
}

function onCsv(id, path, kind) {
  const button = byId(id);
  button.addEventListener("click", async () => {
    const body = shown[kind]?.body;
    if (!body) return;
    try {
      const csv = await postForCsv(path, body);
      saveFile(`${path.split("/").at(-1)}_${body.wheel.preset}_${body.soil.preset}.csv`, csv, "text/csv");
      notice(button, "Saved");
    } catch (error) {
      notice(button, "Failed");
      byId("status").textContent = error.message;
    }
  });
}

onCopy("copy-link", () => {
  flushAddress();
  return location.href;
});
onCopy("copy-curl", () => byId("curl").textContent);
onCsv("profile-csv", "/v1/stress-profile", "profile");
onCsv("sweep-csv", "/v1/slip-sweep", "sweep");
byId("reset-all").addEventListener("click", () => change({ ...DEFAULTS }, { discrete: true }));
byId("fourth").addEventListener("change", (event) => {
  state = { ...state, fourth: event.target.value };
  writeAddress({ discrete: true });
  drawSlipCharts();
});
window.addEventListener("popstate", () => {
  clearTimeout(addressTimer);
  state = stateFromQuery(location.search);
  if (!catalogue) return;
  showControls();
  drawSlipCharts();
  rounds.request({ supersede: true });
});
window.addEventListener("pagehide", flushAddress);

if (matchMedia("(max-width: 900px)").matches) {
  for (const group of document.querySelectorAll("#controls details")) group.open = false;
}
rounds.request();
