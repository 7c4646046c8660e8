// A load that is known beside a sinkage: the sinkage modulus follows, and a soil without moduli of its own answers.
import assert from "node:assert/strict";
import { LETTER, ask } from "./support/api.mjs";
import { check, run } from "./support/checks.mjs";
import { assertAnswered, assertReads, box, open, ready, results } from "./support/page.mjs";

/** A soil of the catalogue whose moduli were never published. */
const WITHOUT_MODULI = "wong-reece-loose-sand";

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

for (const method of ["linearised", "quadrature"]) {
  check(`with the load known, a soil of which the exponent alone was published answers by the ${method} method`, async (page) => {
    await open(page, `?soil=${WITHOUT_MODULI}&method=${method}&load_known=1&load_n=100`);
    const body = await assertAnswered(page);
    assert.deepEqual(body.soil, { preset: WITHOUT_MODULI });
    const answer = await ask("/v1/forces", body);
    const { longitudinal_force_n: pull, sinkage_modulus: modulus } = await results(page);
    assertReads(pull.text, answer.longitudinal_force_n, "pull");
    assertReads(modulus.text, answer.sinkage_modulus, "sinkage modulus");
    assert.ok((await basis(page, "load")).includes(modulus.text), await basis(page, "load"));
    assert.equal(await page.getAttribute("#profile-figure", "data-stale"), "false");
    assert.equal(await page.getAttribute("#slip-charts", "data-stale"), "false");
  });
}

await run();
