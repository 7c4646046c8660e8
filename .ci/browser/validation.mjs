// Published measurements beside the predictions: the table, the points and the curves are the service's.
import assert from "node:assert/strict";
import { assertPoints, drawn } from "./support/chart.mjs";
import { check, run } from "./support/checks.mjs";
import { base } from "./support/launch.mjs";
import { open, ready } from "./support/page.mjs";

const SIDEWAYS = ["quadrature", "quadrature_mobilised", "quadrature_coupled", "quadrature_coupled_mobilised"];
const isSideways = ({ slip_angle_rad: angle }) => angle !== undefined;
const TABLES = {
  "#validation-errors": {
    of: (set) => !isSideways(set),
    errors: ["drawbar_rmse_over_load", "sinkage_rmse_m", "torque_rmse_n_m"],
    series: ["quadrature", "linearised", "explicit"],
  },
  "#validation-grains": {
    of: ({ results }) => results.some(({ method }) => method === "resistive_force"),
    errors: ["drawbar_rmse_over_load", "sinkage_rmse_m", "torque_rmse_n_m"],
    series: ["quadrature", "resistive_force"],
  },
  "#validation-braking": {
    of: ({ id }) => ["cmu-grousered-braking", "cmu-smooth-braking"].includes(id),
    errors: ["drawbar_rmse_over_load", "sinkage_rmse_m"],
    series: ["quadrature", "quadrature_two_zone"],
  },
  "#validation-side": { of: isSideways, errors: ["lateral_rmse_over_load", "drawbar_rmse_over_load"], series: SIDEWAYS },
};
const CHARTS = {
  "#validation-drawbar-chart": { column: "drawbar_coefficient", factor: 1 },
  "#validation-lateral-chart": { column: "lateral_coefficient", factor: 1 },
  "#validation-sinkage-chart": { column: "sinkage_m", factor: 1e3 },
  "#validation-torque-chart": { column: "torque_n_m", factor: 1 },
};

const ofService = async () => (await fetch(`${base}/v1/validation`)).json();
const setsOfService = async () => (await ofService()).sets;

async function openSection(page) {
  await open(page);
  await page.locator("#validation").scrollIntoViewIfNeeded();
  await page.waitForSelector('#validation[data-state="ready"]');
}

const choose = async (page, id) => {
  await page.locator(`#validation tr[data-set="${id}"] button`).first().click();
  await page.waitForSelector(`#validation[data-shown="${id}"]`);
};

check("nothing is asked for before the section comes into view", async (page) => {
  const asked = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await open(page);
  assert.ok(!asked.includes("/v1/validation"), `${asked}`);
  await page.locator("#validation").scrollIntoViewIfNeeded();
  await page.waitForSelector('#validation[data-state="ready"]');
  assert.equal(asked.filter((path) => path === "/v1/validation").length, 1);
  await ready(page);
});

check("the tables have every set with its errors, and say which were fitted", async (page) => {
  await openSection(page);
  const sets = await setsOfService();
  for (const [table, { of, errors, series }] of Object.entries(TABLES)) {
    const rows = await page.$$eval(`${table} tr[data-set]`, (found) => found.map((row) => ({
      id: row.dataset.set,
      fitted: row.querySelector("[data-fitted]").dataset.fitted,
      kind: row.querySelector("[data-fitted]").textContent,
      cells: [...row.querySelectorAll("td[data-error]")].map(({ dataset, textContent }) => ({ ...dataset, text: textContent })),
    })));
    const expectedSets = sets.filter(of);
    assert.ok(await page.isVisible(table) && expectedSets.length >= 2);
    assert.deepEqual(rows.map(({ id }) => id), expectedSets.map(({ id }) => id));
    for (const [index, { id, results }] of expectedSets.entries()) {
      const { fitted, kind, cells } = rows[index];
      assert.equal(fitted, String(results[0].fitted), id);
      assert.equal(kind, results[0].fitted ? "fitted" : "predicted");
      const resultOf = (name) => results.find((result) => result.series === name);
      const expected = errors.flatMap((error) => series.map((name) => ({ error, series: name, value: resultOf(name)[error] })));
      assert.deepEqual(cells.map(({ error, series: name, value }) => ({ error, series: name, value: value === "" ? null : Number(value) })), expected);
      for (const { value, series: name, text } of cells) {
        assert.equal(text.endsWith("*"), value !== "" && resultOf(name).unsolved > 0, `${id} ${name} ${text}`);
      }
    }
  }
});

check("what was fitted on one part is scored on the other, by every fit", async (page) => {
  await openSection(page);
  const { held_out: heldOut } = await ofService();
  const rows = await page.$$eval("#validation-held-out tbody tr", (found) => found.map((row) =>
    [...row.querySelectorAll("td[data-error]")].map(({ dataset }) => ({ error: dataset.error, fit: dataset.fit, value: Number(dataset.value) }))));
  assert.ok(await page.isVisible("#validation-held-out") && heldOut.length > 0);
  assert.deepEqual(rows, heldOut.map(({ results }) => ["drawbar_rmse_over_load", "on_fitted_part"].flatMap((error) =>
    results.map((result) => ({ error, fit: result.fitted.join(" "), value: result[error] })))));
});

check("a chosen set shows its points, curves, source and note", async (page) => {
  await openSection(page);
  for (const id of ["ding-2011-lug10", "cmu-smooth-braking", "yoshida-2003-24n", "cmu-grousered-side-30", "apollo-lrv"]) {
    await choose(page, id);
    const { columns, source, note, results } = (await setsOfService()).find((set) => set.id === id);
    const text = await page.innerText("#validation-set");
    assert.ok(text.includes(source) && text.includes(note.replaceAll("`", "")), id);
    const slips = columns.slip.map((slip) => slip * 100);
    for (const [chart, { column, factor }] of Object.entries(CHARTS)) {
      const isMeasured = columns.measured[column]?.some((value) => value !== null) ?? false;
      assert.equal(await page.isVisible(chart), isMeasured, `${id} ${chart}`);
      if (!isMeasured) continue;
      const shown = await drawn(page, chart);
      const inUnit = (values) => values.map((value) => (value === null ? null : value * factor));
      assertPoints(shown, "measured", slips, inUnit(columns.measured[column]));
      for (const { series } of results) assertPoints(shown, series, slips, inUnit(columns.predicted[series][column]));
      const dots = await page.locator(`${chart} circle.dot[data-style="measured"]`).count();
      assert.equal(dots, columns.measured[column].filter((value) => value !== null).length, `${id} ${chart}`);
    }
  }
});

check("what is to be said of a set is said once, with the names of the charts", async (page) => {
  await openSection(page);
  const said = () => page.$$eval("#validation-set [data-warning]", (found) => found.map(({ dataset, textContent }) => ({ code: dataset.warning, text: textContent.replaceAll("\u00a0", " ") })));
  const slipsOf = async (id) => (await setsOfService()).find((set) => set.id === id).columns.slip.map((slip) => `${Number((100 * slip).toPrecision(3))} %`.replace("-", "\u2212"));
  await choose(page, "ding-2011-smooth");
  assert.equal((await said()).filter(({ code }) => code === "small_wheel").length, 1);
  await choose(page, "cmu-smooth-braking");
  const braking = await said();
  assert.equal(new Set(braking.map(({ text }) => text)).size, braking.length);
  const [first] = await slipsOf("cmu-smooth-braking");
  assert.ok(braking.some(({ text }) => text.startsWith(`Quadrature, two zones, at slip ${first}: no solution`)), JSON.stringify(braking));
  await choose(page, "cmu-smooth-side-30");
  const [from, to] = await slipsOf("cmu-smooth-side-30");
  const sideways = await said();
  assert.ok(sideways.some(({ text }) => text.startsWith(`Coupled, full; Coupled, mobilised, at slip ${from} to ${to}: no solution`)), JSON.stringify(sideways));
});

check("the section fits on a narrow screen", async (page) => {
  await openSection(page);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
}, { context: { viewport: { width: 390, height: 844 } } });

await run();
