// Published measurements beside the predictions: the table, the points and the curves are the service's.
import assert from "node:assert/strict";
import { METHODS } from "./support/api.mjs";
import { assertPoints, drawn } from "./support/chart.mjs";
import { check, run } from "./support/checks.mjs";
import { base } from "./support/launch.mjs";
import { open, ready } from "./support/page.mjs";

const ERRORS = ["drawbar_rmse_over_load", "sinkage_rmse_m", "torque_rmse_n_m"];
const CHARTS = {
  "#validation-drawbar-chart": { column: "drawbar_coefficient", factor: 1 },
  "#validation-sinkage-chart": { column: "sinkage_m", factor: 1e3 },
  "#validation-torque-chart": { column: "torque_n_m", factor: 1 },
};

const setsOfService = async () => (await (await fetch(`${base}/v1/validation`)).json()).sets;

async function openSection(page) {
  await open(page);
  await page.locator("#validation").scrollIntoViewIfNeeded();
  await page.waitForSelector('#validation[data-state="ready"]');
}

const choose = async (page, id) => {
  await page.click(`#validation tr[data-set="${id}"] button`);
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

check("the table has every set with its errors, and says which were fitted", async (page) => {
  await openSection(page);
  const rows = await page.$$eval("#validation tr[data-set]", (found) => found.map((row) => ({
    id: row.dataset.set,
    fitted: row.querySelector("[data-fitted]").dataset.fitted,
    kind: row.querySelector("[data-fitted]").textContent,
    cells: [...row.querySelectorAll("td[data-error]")].map(({ dataset, textContent }) => ({ ...dataset, text: textContent })),
  })));
  const sets = await setsOfService();
  assert.deepEqual(rows.map(({ id }) => id), sets.map(({ id }) => id));
  for (const [index, { id, results }] of sets.entries()) {
    const { fitted, kind, cells } = rows[index];
    assert.equal(fitted, String(results[0].fitted), id);
    assert.equal(kind, results[0].fitted ? "fitted" : "predicted");
    const expected = ERRORS.flatMap((error) => results.map((result) => ({ error, method: result.method, value: result[error] })));
    assert.deepEqual(cells.map(({ error, method, value }) => ({ error, method, value: value === "" ? null : Number(value) })), expected);
    for (const { value, method, text } of cells) {
      const { unsolved } = results.find((result) => result.method === method);
      assert.equal(text.endsWith("*"), value !== "" && unsolved > 0, `${id} ${method} ${text}`);
    }
  }
});

check("a chosen set shows its points, curves, source and note", async (page) => {
  await openSection(page);
  for (const id of ["ding-2011-lug10", "cmu-smooth-braking", "yoshida-2003-24n", "apollo-lrv"]) {
    await choose(page, id);
    const { columns, source, note } = (await setsOfService()).find((set) => set.id === id);
    const text = await page.innerText("#validation-set");
    assert.ok(text.includes(source) && text.includes(note), id);
    const slips = columns.slip.map((slip) => slip * 100);
    for (const [chart, { column, factor }] of Object.entries(CHARTS)) {
      const isMeasured = columns.measured[column].some((value) => value !== null);
      assert.equal(await page.isVisible(chart), isMeasured, `${id} ${chart}`);
      if (!isMeasured) continue;
      const shown = await drawn(page, chart);
      const inUnit = (values) => values.map((value) => (value === null ? null : value * factor));
      assertPoints(shown, "measured", slips, inUnit(columns.measured[column]));
      for (const method of METHODS) assertPoints(shown, method, slips, inUnit(columns.predicted[method][column]));
      const dots = await page.locator(`${chart} circle.dot[data-style="measured"]`).count();
      assert.equal(dots, columns.measured[column].filter((value) => value !== null).length, `${id} ${chart}`);
    }
  }
});

check("the section fits on a narrow screen", async (page) => {
  await openSection(page);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
}, { context: { viewport: { width: 390, height: 844 } } });

await run();
