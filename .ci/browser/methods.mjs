// The three methods side by side, in the table and in the charts.
import assert from "node:assert/strict";
import { LETTER, METHODS, ask, overSlip } from "./support/api.mjs";
import { SLIP_CHARTS, assertSweep, drawn } from "./support/chart.mjs";
import { check, run } from "./support/checks.mjs";
import { FORCES, assertAnswered, assertReads, box, open, picked, ready, valuesOf } from "./support/page.mjs";

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

/** The gap as the page's readers would work it out from the curves. */
function gapBetween(column, reference) {
  const differences = column.map((value, index) => [value, reference[index]]).filter((pair) => pair.every((each) => each !== null))
    .map(([value, other]) => Math.abs(value - other));
  const rms = Math.sqrt(differences.reduce((sum, each) => sum + each * each, 0) / differences.length);
  return { rms, max_abs: Math.max(...differences) };
}

/** Sums in another order differ by rounding. */
const ROUNDING = 1e-9;

for (const [query, load] of [["?compare=1", null], ["?compare=1&by=load&load_n=60&braking=1&method=linearised", 60]]) {
  check(`the gap between the methods is told over slip${load ? " at a load" : ""}`, async (page) => {
    await open(page, query);
    assert.ok(await page.isVisible("#gap-table"), "the table is to be seen");
    const rows = await page.$$eval("#gap-table tr[data-method]", (found) => found.map((row) => ({
      method: row.dataset.method, name: row.dataset.quantity,
      cells: Object.fromEntries([...row.querySelectorAll("td")].map(({ dataset, innerText }) => [dataset.gap, { ...dataset, text: innerText }])),
    })));
    assert.deepEqual(rows.map(({ method, name }) => [method, name]), METHODS.slice(1).flatMap((method) => FORCES.map((name) => [method, name])));
    const { sinkage_m, ...rest } = LETTER;
    const asked = load ? { ...rest, normal_load_n: load } : LETTER;
    const columnsOf = async (method) => (await ask("/v1/slip-sweep", overSlip({ ...asked, method }, load ? -1 : 0))).columns;
    const reference = await columnsOf("quadrature");
    for (const { method, name, cells } of rows) {
      const gaps = gapBetween((await columnsOf(method))[name], reference[name]);
      const largest = Math.max(...reference[name].map(Math.abs));
      const scale = load && name !== "torque_n_m" ? load : largest;
      for (const kind of ["rms", "max_abs"]) {
        const { value, share, text } = cells[kind];
        assert.ok(Math.abs(value - gaps[kind]) <= ROUNDING * largest, `${method} ${name} ${kind} ${value} is not ${gaps[kind]}`);
        assert.ok(Math.abs(share - gaps[kind] / scale) <= ROUNDING, `${method} ${name} ${kind}: a share of ${share}`);
        if (load && name === "normal_force_n") {
          assert.equal(text, "none");
          continue;
        }
        const [, absolute, percent] = /^(.+) \((.+)\u00a0%\)$/.exec(text) ?? assert.fail(text);
        assertReads(absolute, Number(value), `${method} ${name} ${kind}`);
        assert.ok(Math.abs(percent - share * 100) <= 0.05 + ROUNDING, text);
      }
    }
  });
}

check("the compared curves and gaps come from one request", async (page) => {
  const asked = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await open(page, "?compare=1");
  assert.equal(asked.filter((path) => path === "/v1/compare").length, 1);
  assert.equal(asked.filter((path) => path === "/v1/slip-sweep").length, 0);
  await page.uncheck("#compare");
  await ready(page);
  assert.ok(await page.isHidden("#gaps"), "one method has no gap");
  assert.equal(asked.filter((path) => path === "/v1/compare").length, 1);
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

check("a slip angle brings a lateral force and moments, and only the quadrature takes it", async (page) => {
  await open(page);
  assert.ok(await page.isHidden('[data-result="lateral_force_n"]'), "straight ahead there is none");
  await box(page, "slip_angle").fill("10");
  await ready(page);
  const body = await assertAnswered(page);
  assert.ok(Math.abs(body.slip_angle_rad - Math.PI / 18) < 1e-12);
  for (const name of ["lateral_force_n", "overturning_moment_n_m", "aligning_moment_n_m"]) assert.ok(await page.isVisible(`[data-result="${name}"]`), name);
  await page.selectOption("#method", "explicit");
  await ready(page);
  assert.equal((await assertAnswered(page)).slip_angle_rad, undefined);
  assert.ok(await box(page, "slip_angle").isHidden(), "the closed forms have no slip angle");
});

check("two zones of a braking wheel are offered while it brakes", async (page) => {
  await open(page);
  assert.ok(await page.isHidden("#braking-law"), "a driving wheel has no choice");
  await open(page, "?slip_pct=-20&by=load&load_n=60");
  const one = await assertAnswered(page);
  assert.equal(one.braking, undefined);
  await page.selectOption("#braking-law", "two_zone");
  await ready(page);
  assert.equal((await assertAnswered(page)).braking, "two_zone");
  await page.click("#compare");
  await ready(page);
  assert.equal((await assertAnswered(page)).braking, undefined, "the closed forms have one zone");
});

await run();
