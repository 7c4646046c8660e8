// Published measurements beside what the methods give for them: tables of errors, and the curves of the chosen set. Nothing
// is asked of the service before the section comes near the window.

import { validationSets } from "./api.js";
import { createChart } from "./chart.js";
import { html, sentenceHtml } from "./elements.js";
import { METHOD_NAMES, fixed, quantity, withUnit } from "./format.js";

/** The series of a set: those straight ahead, and those of a wheel at a slip angle, which differ by their laws alone. */
const SERIES_NAMES = { ...METHOD_NAMES, quadrature_two_zone: "Quadrature, two zones" };
const SIDE_NAMES = {
  quadrature: "Independent, full",
  quadrature_mobilised: "Independent, mobilised",
  quadrature_coupled: "Coupled, full",
  quadrature_coupled_mobilised: "Coupled, mobilised",
};
const isSideways = (set) => set.slip_angle_rad !== undefined;
const hasTwoZones = (set) => set.results.some(({ braking }) => braking === "two_zone");
const namesOf = (set) => (isSideways(set) ? SIDE_NAMES : SERIES_NAMES);
const GRADES = { measured: "measured", digitised: "read off figures", simulated: "simulated", worked_example: "worked example" };

/** What a table states: as text, in the unit of its heading. */
const PULL = { name: "drawbar_rmse_over_load", title: "Drawbar pull, error over load", text: (value) => fixed(value, 3) };
const SINKAGE = { name: "sinkage_rmse_m", title: "Sinkage, error in mm", text: (value) => fixed(value * 1e3, 1) };
const TORQUE = { name: "torque_rmse_n_m", title: "Torque, error in N·m", text: (value) => fixed(value, 2) };
const LATERAL = { name: "lateral_rmse_over_load", title: "Lateral force, error over load", text: (value) => fixed(value, 3) };

/** The tables: which sets, which errors, by which series, under which headings. */
const TABLES = [
  { id: "validation-errors", of: (set) => !isSideways(set), errors: [PULL, SINKAGE, TORQUE], series: { quadrature: "Quadr.", linearised: "Linear.", explicit: "Expl." }, names: SERIES_NAMES },
  { id: "validation-braking", of: hasTwoZones, errors: [PULL, SINKAGE], series: { quadrature: "One zone", quadrature_two_zone: "Two zones" }, names: SERIES_NAMES },
  {
    id: "validation-side",
    of: isSideways,
    errors: [LATERAL, PULL],
    series: { quadrature: "Indep., full", quadrature_mobilised: "Indep., mob.", quadrature_coupled: "Coupled, full", quadrature_coupled_mobilised: "Coupled, mob." },
    names: SIDE_NAMES,
  },
];

const CHARTS = [
  { id: "validation-drawbar-chart", column: "drawbar_coefficient", title: "Drawbar pull over load", unit: "", factor: 1 },
  { id: "validation-lateral-chart", column: "lateral_coefficient", title: "Lateral force over load", unit: "", factor: 1 },
  { id: "validation-sinkage-chart", column: "sinkage_m", title: "Sinkage", unit: "mm", factor: 1e3 },
  { id: "validation-torque-chart", column: "torque_n_m", title: "Torque", unit: "N·m", factor: 1 },
];

/** The part of the slips' range that stays free on both sides, and what a single point gets (%). */
const MARGIN = 0.04;
const LEAST_MARGIN = 1;
const NEARBY = "300px";

const byId = (id) => document.getElementById(id);
const percent = (value) => withUnit(fixed(value, 1), "%");
const scaled = (values, factor) => values.map((value) => (value === null ? null : value * factor));

function errorCell({ name, text }, { series, ...result }) {
  const value = result[name];
  const gaps = result.unsolved ? `${result.unsolved} of ${result.solved + result.unsolved} points have no solution and do not count` : null;
  return html("td", { "data-error": name, "data-series": series, "data-value": value ?? "", title: gaps },
    value === null ? "–" : text(value), value !== null && gaps ? "*" : "");
}

function errorTable(sets, { errors, series, names }, choose) {
  const shown = Object.keys(series);
  const row = (set) => {
    const results = set.results.filter((result) => shown.includes(result.series));
    const { fitted } = results[0];
    return html("tr", { "data-set": set.id },
      html("th", { scope: "row" }, choose(set)),
      html("td", {}, set.points),
      html("td", { class: fitted ? "kind fitted" : "kind", "data-fitted": String(fitted) }, fitted ? "fitted" : "predicted"),
      ...errors.flatMap((error) => results.map((result) => errorCell(error, result))));
  };
  return html("table", {},
    html("thead", {},
      html("tr", {},
        html("th", { scope: "col", rowspan: 2 }, "Set"), html("th", { scope: "col", rowspan: 2 }, "Points"), html("th", { scope: "col", rowspan: 2 }, "Kind"),
        ...errors.map(({ title }) => html("th", { scope: "colgroup", colspan: shown.length }, title))),
      html("tr", {}, ...errors.flatMap(() => shown.map((name) => html("th", { scope: "col", title: names[name] }, series[name]))))),
    html("tbody", {}, ...sets.map(row)));
}

/** A warning with the series it is about, which stand before it by their names in the answer, as the charts call them. */
function sentence(detail, names) {
  const [before, ...rest] = detail.split(": ");
  const series = before.split(", ");
  return series.every((name) => name in names) ? [series.map((name) => names[name]).join("; "), ...rest].join(": ") : detail;
}

function describe({ id, title, source, grade, note, fitted_to: fitted, warnings, ...set }) {
  const paragraphs = [
    html("h3", {}, title),
    html("p", { class: "source" }, html("span", { class: "grade" }, GRADES[grade] ?? grade), " ", source, " ", html("a", { href: `/v1/validation/${id}` }, "JSON")),
    fitted && html("p", { class: "fitted" }, `Fitted: ${fitted}`),
    note && html("p", { class: "note" }, ...sentenceHtml(note)),
    ...warnings.map(({ code, detail }) => html("p", { class: "note", "data-warning": code }, ...sentenceHtml(sentence(detail, namesOf(set))))),
  ];
  byId("validation-set").replaceChildren(...paragraphs.filter(Boolean));
}

/** Measured points over predicted curves. */
function spec({ columns, title: set, results, ...rest }, { column, title, unit, factor }) {
  const slips = scaled(columns.slip, 100);
  const margin = Math.max(LEAST_MARGIN, MARGIN * (slips.at(-1) - slips[0]));
  const names = namesOf(rest);
  const predicted = results.map(({ series }) => ({ key: series, name: names[series], values: scaled(columns.predicted[series][column], factor) }));
  const measured = { key: "measured", name: "Measured", values: scaled(columns.measured[column], factor) };
  // A lone point makes no line.
  const dotted = slips.length === 1 ? [measured, ...predicted] : [measured];
  return {
    label: `${title} over slip, measured and predicted: ${set}`,
    x: { values: slips, domain: [slips[0] - margin, slips.at(-1) + margin], name: "s", spoken: "slip", label: "slip s, %", format: percent },
    y: { unit, missing: "not measured or without a solution", format: (value) => quantity(column, value / factor) },
    curves: [measured, ...predicted],
    marks: [],
    dots: dotted.flatMap(({ key, values }) => slips.map((at, index) => ({ key, at, value: values[index] }))),
    rest: null,
  };
}

/** Shows the section once it comes near the window. */
export function connectValidation(section) {
  const status = byId("validation-status");
  let charts = null;

  function show(set) {
    for (const row of section.querySelectorAll("tr[data-set]")) {
      const isChosen = row.dataset.set === set.id;
      row.classList.toggle("chosen", isChosen);
      row.querySelector("button").setAttribute("aria-pressed", isChosen);
    }
    describe(set);
    for (const part of ["validation-set", "validation-charts"]) byId(part).hidden = false;
    charts ??= CHARTS.map((chart) => ({ ...chart, view: createChart(byId(chart.id)) }));
    for (const { id, view, ...chart } of charts) {
      const isMeasured = set.columns.measured[chart.column]?.some((value) => value !== null) ?? false;
      byId(id).closest("figure").hidden = !isMeasured;
      if (isMeasured) {
        view.setCursor(null);
        view.draw(spec(set, chart));
      }
    }
    section.dataset.shown = set.id;
  }

  async function load() {
    section.dataset.state = "loading";
    status.textContent = "Loading the measurements…";
    try {
      const sets = await validationSets();
      const choose = (set) => {
        const button = html("button", { type: "button", class: "small", "aria-pressed": "false" }, set.title);
        button.addEventListener("click", () => show(set));
        return button;
      };
      for (const { id, of, ...table } of TABLES) {
        byId(id).replaceChildren(errorTable(sets.filter(of), table, choose));
        byId(id).closest("[hidden]").hidden = false;
      }
      status.textContent = "Choose a set to see its points. A dash: not measured. An asterisk: some points have no solution and do not count.";
      show(sets[0]);
      section.dataset.state = "ready";
    } catch (error) {
      section.dataset.state = "failed";
      const again = html("button", { type: "button", class: "small" }, "Try again");
      again.addEventListener("click", load);
      status.replaceChildren(`The measurements could not be loaded: ${error.message} `, again);
    }
  }

  const observer = new IntersectionObserver((entries) => {
    if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
    observer.disconnect();
    load();
  }, { rootMargin: NEARBY });
  observer.observe(section);
  return observer;
}
