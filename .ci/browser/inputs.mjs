// Inputs change curves and numbers alike, and what is shown is always the service's answer to the shown request.
import assert from "node:assert/strict";
import { ask, faultOf, overSlip } from "./support/api.mjs";
import { SLIP_CHARTS, assertProfile, assertSweep, drawn, paths, pointAt } from "./support/chart.mjs";
import { check, run } from "./support/checks.mjs";
import { FORCES, assertAnswered, box, curlBody, faulty, open, ready, slider, valuesOf } from "./support/page.mjs";

async function assertShown(page) {
  const body = await assertAnswered(page);
  const { columns } = await ask("/v1/slip-sweep", overSlip(body));
  await assertSweep(page, "quadrature", columns);
  return body;
}

/** Moves a slider and tells which curves and forces are other ones afterwards. */
async function changesBy(page, name, value) {
  const look = async () => ({
    forces: await valuesOf(page, FORCES),
    profile: await paths(page, "#profile-chart"),
    sweep: await Promise.all(Object.keys(SLIP_CHARTS).map((chart) => paths(page, chart))),
  });
  const before = await look();
  await slider(page, name).fill(value);
  await ready(page);
  assert.equal(await box(page, name).inputValue(), value);
  const after = await look();
  for (const force of FORCES) assert.notEqual(after.forces[force], before.forces[force], `${force} stays while the ${name} changes`);
  const isOther = (part) => JSON.stringify(after[part]) !== JSON.stringify(before[part]);
  return { profile: isOther("profile"), sweep: isOther("sweep") };
}

check("the slip slider changes the stresses and the marked slip", async (page) => {
  await open(page);
  const changes = await changesBy(page, "slip", "35");
  assert.deepEqual(changes, { profile: true, sweep: false });
  assert.equal((await assertShown(page)).slip, 0.35);
  const { marks } = await drawn(page, "#torque-chart");
  assert.ok(Math.abs(marks.slip.at - 35) < 0.01, `marked at ${marks.slip.at} %`);
  await slider(page, "slip").press("ArrowRight");
  await ready(page);
  assert.equal((await assertShown(page)).slip, 0.36);
});

check("a slip that may be a ratio is asked about", async (page) => {
  await open(page);
  const question = page.locator("#slip-question");
  assert.ok(await question.isHidden());
  await box(page, "slip").fill("0.2");
  await ready(page);
  assert.match(await question.innerText(), /^0\.2 % is less than one percent\. Was 20 % meant\?/);
  assert.equal((await assertAnswered(page)).slip, 0.002, "what was typed stands until the answer");
  await page.click('[data-meant="slip"]');
  await ready(page);
  assert.equal(await box(page, "slip").inputValue(), "20");
  assert.equal((await assertAnswered(page)).slip, 0.2);
  assert.ok(await question.isHidden());
  for (const [text, isAsked] of /** @type {[string, boolean][]} */ ([["0", false], ["-0.4", true], ["1", false], ["0,35", true], ["12.5", false]])) {
    await box(page, "slip").fill(text);
    await ready(page);
    assert.equal(await question.isVisible(), isAsked, text);
  }
});

check("the radius slider changes every curve", async (page) => {
  await open(page);
  assert.deepEqual(await changesBy(page, "radius", "300"), { profile: true, sweep: true });
  assert.deepEqual((await assertShown(page)).wheel, { preset: "letter", radius_m: 0.3 });
});

check("the lug height slider changes every curve over slip and the shear stress, and leaves the normal stress", async (page) => {
  await open(page);
  const { sweep } = await changesBy(page, "lug_height", "12.5");
  assert.ok(sweep, "the curves over slip stay");
  const { method, ...body } = await assertShown(page);
  assert.deepEqual(body.wheel, { preset: "letter", lug_height_m: 0.0125 });
  const { columns } = await ask("/v1/stress-profile", { ...body, points: 201 });
  await assertProfile(page, columns);
  const bare = await ask("/v1/stress-profile", { ...body, wheel: { preset: "letter" }, points: 201 });
  assert.deepEqual(columns.normal_stress_pa, bare.columns.normal_stress_pa);
  assert.notDeepEqual(columns.shear_stress_pa, bare.columns.shear_stress_pa);
  await page.click('[data-reset="lug_height"]');
  await ready(page);
  assert.deepEqual((await assertShown(page)).wheel, { preset: "letter" });
});

check("a click in a chart over slip sets the slip", async (page) => {
  await open(page);
  const { pxOf } = await drawn(page, "#normal-force-chart");
  await pointAt(page, "#normal-force-chart", pxOf(45));
  await page.mouse.down();
  await page.mouse.up();
  await ready(page);
  assert.equal((await assertShown(page)).slip, 0.45);
  assert.equal(await box(page, "slip").inputValue(), "45");
});

check("a click on the cursor's own dot sets the slip as well", async (page) => {
  await open(page);
  for (const percent of [60, 61]) {
    const { pxOf } = await drawn(page, "#normal-force-chart");
    await pointAt(page, "#normal-force-chart", pxOf(percent));
    const { x, y, width, height } = await page.locator("#normal-force-chart .cursor-dot").boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.up();
    await ready(page);
    assert.equal((await assertShown(page)).slip, percent / 100);
  }
});

check("with a normal load the sinkage is the one that carries it", async (page) => {
  await open(page);
  await page.click("label:has(#by-load)");
  await ready(page);
  assert.ok(await box(page, "normal_load").isVisible(), "the load can be set");
  assert.ok(await box(page, "sinkage").isHidden(), "the sinkage cannot be set");
  await box(page, "normal_load").fill("150");
  await ready(page);
  const body = await assertShown(page);
  assert.equal(body.normal_load_n, 150);
  assert.equal(body.sinkage_m, undefined);
  const { normal_force_n: carried, sinkage_m: sinkage } = await valuesOf(page, ["normal_force_n", "sinkage_m"]);
  assert.ok(Math.abs(carried - 150) < 1e-3, `carries ${carried} N`);
  assert.ok(sinkage > 0.02, `sinks ${sinkage} m`);
});

check("with a normal load the stresses belong to the sinkage of the chosen method", async (page) => {
  await open(page, "?by=load&load_n=80&method=explicit");
  const { normal_load_n, method, ...rest } = await assertAnswered(page);
  assert.equal(method, "explicit");
  const { columns } = await ask("/v1/stress-profile", { ...rest, ...(await valuesOf(page, ["sinkage_m"])), points: 201 });
  await assertProfile(page, columns);
});

check("a load that the soil does not carry is a fault of the load", async (page) => {
  await open(page, "?by=load");
  await box(page, "normal_load").fill("50000");
  await faulty(page);
  const told = await faultOf({ ...(await curlBody(page)), normal_load_n: 50000 }, "/normal_load_n");
  const fault = page.locator('[data-fault="/normal_load_n"]');
  assert.ok(await fault.isVisible(), "the fault is visible");
  assert.ok((await fault.innerText()).includes(told), await fault.innerText());
  assert.equal(await box(page, "normal_load").getAttribute("aria-invalid"), "true");
  await box(page, "normal_load").fill("90");
  await ready(page);
  assert.ok(await fault.isHidden(), "the fault is gone");
  await assertShown(page);
}, { refused: true });

check("with a static sinkage the wheel digs itself in further", async (page) => {
  await open(page);
  await page.click("label:has(#by-static)");
  await ready(page);
  await box(page, "static_sinkage").fill("15");
  await ready(page);
  const body = await assertShown(page);
  assert.equal(body.static_sinkage_m, 0.015);
  const { sinkage_m: sinkage } = await valuesOf(page, ["sinkage_m"]);
  assert.ok(sinkage > 0.015, `sinks ${sinkage} m`);
});

await run();
