// A load that is known beside a sinkage: the sinkage modulus follows, and a soil without a law of pressure and sinkage answers.
import assert from "node:assert/strict";
import { LETTER, ask } from "./support/api.mjs";
import { check, run } from "./support/checks.mjs";
import { assertAnswered, assertReads, box, faulty, open, ready, results, url } from "./support/page.mjs";

/** A soil of the catalogue whose moduli were never published. */
const WITHOUT_LAW = "wong-reece-loose-sand";

const basis = (page, key) => page.innerText(`#basis [data-basis="${key}"]`);

for (const { by, key, name, shown } of [
  { by: "sinkage", key: "sinkage_mm", name: "sinkage_m", shown: 20 },
  { by: "static", key: "static_mm", name: "static_sinkage_m", shown: 15 },
]) {
  check(`a load beside the ${by} gives the sinkage modulus`, async (page) => {
    await open(page, `?by=${by}&${key}=${shown}`);
    assert.ok(await page.isHidden('[data-field="normal_load"]'), "no load is asked for");
    assert.ok(await page.isHidden("#basis"));
    await page.check("#load-known");
    await ready(page);
    await box(page, "normal_load").fill("120");
    await ready(page);
    const { sinkage_m, ...rest } = LETTER;
    const body = { ...rest, [name]: shown / 1000, normal_load_n: 120, method: "quadrature" };
    assert.deepEqual(await assertAnswered(page), body);
    const answer = await ask("/v1/forces", body);
    assert.equal(answer.normal_stress_from, "load");
    const { sinkage_modulus: told } = await results(page);
    assertReads(told.text, answer.sinkage_modulus, "sinkage modulus");
    assert.ok((await basis(page, "load")).includes(told.text), await basis(page, "load"));
    assert.ok((await page.innerText("#torque-chart .legend .basis")).includes("load 120"), "the legend tells of the load");
    await page.waitForURL(/load_n=120/);
    const query = new URLSearchParams(new URL(page.url()).search);
    assert.deepEqual([query.get("load_known"), query.get("load_n")], ["1", "120"]);
    await page.reload();
    await ready(page);
    assert.deepEqual(await assertAnswered(page), body);
  });
}

check("with the load known, a soil without moduli answers by a closed form", async (page) => {
  await open(page, `?soil=${WITHOUT_LAW}&method=linearised&load_known=1&load_n=100`);
  const body = await assertAnswered(page);
  assert.deepEqual(body.soil, { preset: WITHOUT_LAW });
  const { longitudinal_force_n: pull, sinkage_modulus: modulus } = await results(page);
  assert.ok(pull.value !== null && modulus.value === null, "the modulus cancels");
  assert.match(await basis(page, "load"), /cancels/);
  assert.ok(await page.isVisible('#profile-warnings li[data-warning="no_profile"]'), "the stresses say why they are not there");
  assert.equal(await page.getAttribute("#profile-figure", "data-stale"), "true");
  assert.equal(await page.getAttribute("#slip-charts", "data-stale"), "false");
}, { refused: true });

check("the integral still asks for the moduli", async (page) => {
  await page.goto(url(`?soil=${WITHOUT_LAW}&load_known=1&load_n=100`));
  await faulty(page);
  assert.ok(await page.isVisible('[data-fault="/soil/pressure_sinkage"]'));
}, { refused: true });

await run();
