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
  assert.ok(await page.isVisible("#comparison-table"), "the table is visible");
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

const rootMeanSquare = (values) => Math.sqrt(values.reduce((sum, each) => sum + each * each, 0) / values.length);

/** Figures of differences beside the values that they are relative to. */
const figures = (differences, references) => ({
  rms: rootMeanSquare(differences),
  mean: differences.reduce((sum, each) => sum + each, 0) / differences.length,
  max_abs: Math.max(...differences.map(Math.abs)),
  relative: rootMeanSquare(differences) / rootMeanSquare(references),
});

/** The gap as the page's readers would work it out from the curves. */
function gapBetween(column, reference) {
  const pairs = column.map((value, index) => [value, reference[index]]).filter((pair) => pair.every((each) => each !== null));
  return figures(pairs.map(([value, other]) => value - other), pairs.map(([, other]) => other));
}

/** How far curves are apart, relative to the first of them. */
function spreadOf(columns) {
  const rows = columns[0].map((_, index) => columns.map((column) => column[index])).filter((row) => row.every((each) => each !== null));
  const { mean, ...spread } = figures(rows.map((row) => Math.max(...row) - Math.min(...row)), rows.map(([first]) => first));
  return spread;
}

/** Sums in another order differ by rounding. */
const ROUNDING = 1e-9;

for (const [query, load] of [["?compare=1", null], ["?compare=1&by=load&load_n=60&braking=1&method=linearised", 60]]) {
  check(`the gap to the integral and the spread are told over slip${load ? " at a load" : ""}`, async (page) => {
    await open(page, query);
    assert.ok(await page.isVisible("#gap-table"), "the table is visible");
    const rows = await page.$$eval("#gap-table tr[data-method]", (found) => found.map((row) => ({
      method: row.dataset.method, name: row.dataset.quantity,
      cells: Object.fromEntries([...row.querySelectorAll("td[data-gap]")].map(({ dataset, innerText }) => [dataset.gap, { ...dataset, text: innerText }])),
    })));
    const told = [...METHODS.slice(1), "spread"];
    assert.deepEqual(rows.map(({ method, name }) => [method, name]), told.flatMap((method) => FORCES.map((name) => [method, name])));
    const { sinkage_m, ...rest } = LETTER;
    const asked = load ? { ...rest, normal_load_n: load } : LETTER;
    const curves = Object.fromEntries(await Promise.all(METHODS.map(async (method) =>
      [method, (await ask("/v1/slip-sweep", overSlip({ ...asked, method }, load ? -1 : 0))).columns])));
    for (const { method, name, cells } of rows) {
      const reference = curves.quadrature[name];
      const { relative, ...expected } = method === "spread"
        ? spreadOf(METHODS.map((each) => curves[each][name]))
        : gapBetween(curves[method][name], reference);
      assert.deepEqual(Object.keys(cells).sort(), Object.keys(expected).sort(), `${method} ${name}`);
      const largest = Math.max(...reference.map(Math.abs));
      for (const [kind, { value, share, text }] of Object.entries(cells)) {
        assert.ok(Math.abs(value - expected[kind]) <= ROUNDING * largest, `${method} ${name} ${kind} ${value} is not ${expected[kind]}`);
        if (load && name === "normal_force_n") {
          assert.equal(text, "none");
          continue;
        }
        const [absolute, percent] = text.split(/ \((.+)\u00a0%\)$/);
        assertReads(absolute, Number(value), `${method} ${name} ${kind}`);
        assert.equal(percent !== undefined, kind === "rms", text);
        if (kind !== "rms") continue;
        assert.ok(Math.abs(share - relative) <= ROUNDING, `${method} ${name}: a share of ${share} is not ${relative}`);
        assert.ok(Math.abs(percent - share * 100) <= 0.05 + ROUNDING, text);
      }
    }
    if (load) return;
    for (const { method, name, cells } of rows.filter((row) => row.method !== "spread")) assert.ok(cells.mean.text.startsWith("\u2212"), `${method} gives less ${name}`);
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
  assert.match(await page.innerText("#slip_angle-note"), /^Not used: only the quadrature/, "the closed forms have no slip angle");
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
