// What can be carried away from the page gives the same results elsewhere: its address, its curl command, its files.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { readFile } from "node:fs/promises";
import { promisify } from "node:util";
import { ask, overSlip } from "./support/api.mjs";
import { check, run } from "./support/checks.mjs";
import { FORCES, assertAnswered, box, curlBody, open, openGroups, picked, ready, results, valuesOf } from "./support/page.mjs";

const PROFILE_HEADER = "theta_rad,sinkage_m,normal_stress_pa,shear_stress_pa,normal_stress_linear_pa,shear_stress_linear_pa";
const SWEEP_HEADER = "slip,sinkage_m,longitudinal_force_n,normal_force_n,torque_n_m,traction_n,resistance_n,normal_support_n,"
  + "shear_support_n,drawbar_coefficient,tractive_efficiency";

check("the address holds all inputs", async (page) => {
  await open(page);
  await openGroups(page);
  await page.selectOption("#wheel", "msl-curiosity");
  await page.selectOption("#soil", "wong-dry-sand");
  await page.selectOption("#method", "explicit");
  await page.selectOption("#rule", "half_sinkage");
  await page.selectOption("#normal-stress-radius", "shearing");
  await page.selectOption("#peak-sinkage", "geometric");
  await page.selectOption("#fourth", "sinkage_m");
  await page.click("label:has(#by-static)");
  await page.check("#braking");
  await page.check("#compare");
  for (const [name, text] of [["slip", "-12.5"], ["static_sinkage", "30"], ["width", "350"], ["lug_coefficient", "0.7"],
    ["cohesion", "0.9"], ["friction_angle", "31.5"], ["n1", "0.25"], ["c3", "-0.1"], ["lambda_a", "exact"]]) {
    await box(page, name).fill(text);
  }
  await ready(page);
  // The last thing written is written a moment later.
  await page.waitForURL((address) => address.searchParams.get("lambda_a") === "exact");

  const other = await page.context().newPage();
  await other.goto(page.url());
  await ready(other);
  const stateOf = async (each) => ({
    results: await results(each),
    curl: await each.textContent("#curl"),
    table: await each.innerText("#comparison-table"),
    inputs: await each.$$eval("#app input, #app select", (inputs) => inputs.map(({ id, dataset, type, value, checked }) =>
      [id || dataset.slider, ["checkbox", "radio"].includes(type) ? checked : value])),
    curves: await each.$$eval("path.curve", (curves) => curves.map((curve) => curve.getAttribute("d"))),
  });
  assert.deepEqual(await stateOf(other), await stateOf(page));
  const body = await assertAnswered(other);
  assert.equal(body.slip, -0.125);
  assert.equal(body.static_sinkage_m, 0.03);
  assert.deepEqual(body.wheel, { preset: "msl-curiosity", width_m: 0.35, lug_coefficient: 0.7 });
  assert.equal(body.lambda_a, "exact");
});

check("choices of the address that are not offered give way to the defaults, and the page says so", async (page) => {
  const choices = ["wheel", "soil", "method", "by", "compare", "braking", "law", "shear", "rule", "slip_sinkage", "normal_stress_radius",
    "peak_sinkage", "fourth"];
  const stateOf = (each) => each.$$eval("#app input, #app select", (inputs) => inputs.map(({ id, type, value, checked }) =>
    [id, ["checkbox", "radio"].includes(type) ? checked : value]));
  await open(page, "?slip_pct=30");
  const usual = await stateOf(page);
  assert.ok(await page.isHidden("#notice"), "nothing is amiss");
  for (const unknown of [...choices.map((choice) => `${choice}=unknown`), choices.map((choice) => `${choice}=constructor`).join("&")]) {
    await open(page, `?slip_pct=30&${unknown}`);
    assert.deepEqual(await stateOf(page), usual, unknown);
    assert.equal((await assertAnswered(page)).slip, 0.3);
    for (const part of unknown.split("&")) assert.ok((await page.innerText("#notice")).includes(part), await page.innerText("#notice"));
    assert.ok(await page.locator("#fourth-chart .plot path.curve").isVisible(), "the fourth quantity is drawn");
  }
  await box(page, "slip").fill("40");
  await ready(page);
  assert.ok(await page.isHidden("#notice"), "the notice goes with the next change");
});

check("going back to an address with an unknown choice still gives its forces", async (page) => {
  await open(page);
  await page.evaluate(() => {
    history.pushState(null, "", "?slip_pct=30&fourth=unknown");
    history.pushState(null, "", "?slip_pct=40");
  });
  const round = Number(await page.getAttribute("#app", "data-round"));
  await page.goBack();
  await page.waitForFunction((last) => Number(document.querySelector("#app")?.getAttribute("data-round")) > last, round);
  await ready(page);
  assert.equal((await assertAnswered(page)).slip, 0.3);
  assert.equal(await page.inputValue("#fourth"), "tractive_efficiency");
  assert.match(await page.innerText("#notice"), /fourth=unknown/);
});

check("the curl command gives the shown forces in a shell", async (page) => {
  await open(page, "?slip_pct=30&by=load&load_n=120&lug_mm=5&c_kpa=0.25");
  const { stdout } = await promisify(execFile)("bash", ["-c", await page.textContent("#curl")]);
  const names = [...FORCES, "sinkage_m"];
  assert.deepEqual(picked(JSON.parse(stdout), names), await valuesOf(page, names));
});

async function savedBy(page, button) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(button)]);
  const [header, ...rows] = (await readFile(await download.path(), "utf8")).trimEnd().split(/\r?\n/);
  const table = rows.map((row) => row.split(",").map((cell) => (cell === "" ? null : Number(cell))));
  return { file: download.suggestedFilename(), header, table };
}

const tableOf = (columns, header) => {
  const names = header.split(",");
  return columns[names[0]].map((_, row) => names.map((name) => columns[name][row]));
};

check("the file of the stresses holds what is drawn", async (page) => {
  await open(page, "?slip_pct=30");
  const { file, header, table } = await savedBy(page, "#profile-csv");
  assert.match(file, /\.csv$/);
  assert.equal(header, PROFILE_HEADER);
  assert.equal(table.length, 201);
  const { method, ...body } = await curlBody(page);
  const { columns } = await ask("/v1/stress-profile", { ...body, points: 201 });
  assert.deepEqual(table, tableOf(columns, header));
});

check("the file of the forces over slip holds what is drawn", async (page) => {
  await open(page, "?by=load&braking=1");
  const { file, header, table } = await savedBy(page, "#sweep-csv");
  assert.match(file, /\.csv$/);
  assert.equal(header, SWEEP_HEADER);
  assert.equal(table.length, 101);
  const { columns } = await ask("/v1/slip-sweep", overSlip(await curlBody(page), -1));
  assert.deepEqual(table, tableOf(columns, header));
});

check("the file of compared methods holds all their curves", async (page) => {
  await open(page, "?compare=1");
  const { header, table } = await savedBy(page, "#sweep-csv");
  const { method, ...body } = overSlip(await curlBody(page));
  const { slip, series } = await ask("/v1/compare", body);
  const columns = Object.fromEntries(series.flatMap((each) => Object.entries(each.columns).map(([name, column]) => [`${each.method}.${name}`, column])));
  assert.equal(header.split(",").length, 1 + series.length * (SWEEP_HEADER.split(",").length - 1));
  assert.deepEqual(table, tableOf({ ...columns, slip }, header));
});

await run();
