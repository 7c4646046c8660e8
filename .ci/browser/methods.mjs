// The three methods side by side, in the table and in the charts.
import assert from "node:assert/strict";
import { LETTER, METHODS, ask, overSlip } from "./support/api.mjs";
import { SLIP_CHARTS, assertSweep, drawn } from "./support/chart.mjs";
import { check, run } from "./support/checks.mjs";
import { FORCES, assertReads, open, picked, ready, valuesOf } from "./support/page.mjs";

const rowsOf = (page) => page.$$eval("#comparison-table tr[data-method]", (rows) => rows.map((row) => ({
  method: row.dataset.method,
  cells: [...row.querySelectorAll("td[data-compared]")].map(({ dataset, textContent }) =>
    ({ name: dataset.compared, value: Number(dataset.value), text: textContent })),
})));

check("the methods are compared in numbers", async (page) => {
  await open(page);
  assert.ok(await page.isHidden("#comparison"), "one method is not compared");
  await page.check("#compare");
  await ready(page);
  assert.ok(await page.isVisible("#comparison-table"), "the table is to be seen");
  const rows = await rowsOf(page);
  assert.deepEqual(rows.map(({ method }) => method), METHODS);
  const normalForces = [];
  for (const { method, cells } of rows) {
    const answer = await ask("/v1/forces", { ...LETTER, method });
    assert.deepEqual(Object.fromEntries(cells.map(({ name, value }) => [name, value])), picked(answer, [...FORCES, "sinkage_m"]));
    for (const { name, value, text } of cells) assertReads(text, value, `${method} ${name}`);
    normalForces.push(answer.normal_force_n);
  }
  assert.equal(new Set(normalForces).size, METHODS.length, `different normal forces among ${normalForces}`);
});

check("the methods are compared in curves", async (page) => {
  await open(page, "?compare=1");
  for (const chart of [...Object.keys(SLIP_CHARTS), "#fourth-chart"]) {
    const { curves } = await drawn(page, chart);
    assert.deepEqual([chart, ...Object.keys(curves)], [chart, ...METHODS]);
    assert.equal(new Set(METHODS.map((method) => curves[method].d)).size, METHODS.length, `number of different curves in ${chart}`);
  }
  for (const method of METHODS) {
    const { columns } = await ask("/v1/slip-sweep", overSlip({ ...LETTER, method }));
    await assertSweep(page, method, columns);
  }
});

check("a chosen method alone gives its own forces and curves", async (page) => {
  await open(page);
  for (const method of ["linearised", "explicit"]) {
    await page.selectOption("#method", method);
    await ready(page);
    const answer = await ask("/v1/forces", { ...LETTER, method });
    assert.deepEqual(await valuesOf(page, FORCES), picked(answer, FORCES));
    const { columns } = await ask("/v1/slip-sweep", overSlip({ ...LETTER, method }));
    await assertSweep(page, method, columns);
    assert.deepEqual(Object.keys((await drawn(page, "#torque-chart")).curves), [method]);
  }
});

await run();
