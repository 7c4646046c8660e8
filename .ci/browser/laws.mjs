// The laws a request can choose are chosen on the page, with their parameters, and travel in the address.
import assert from "node:assert/strict";
import { LETTER, ask } from "./support/api.mjs";
import { check, run } from "./support/checks.mjs";
import { FORCES, assertAnswered, box, faulty, open, openGroups, picked, ready, url, valuesOf } from "./support/page.mjs";

/** The page opened again at its own address asks for the same. */
async function assertTravels(page, body) {
  const other = await page.context().newPage();
  await other.goto(page.url());
  await ready(other);
  assert.deepEqual(await assertAnswered(other), body);
}

check("each shear law takes its own parameters", async (page) => {
  await open(page);
  await openGroups(page);
  const withLetter = (shear) => ({ ...LETTER, method: "quadrature", soil: { preset: "letter-sand", shear } });
  await page.selectOption("#shear", "wong_peak");
  await ready(page);
  assert.ok(await box(page, "shear_modulus").isHidden(), "Janosi–Hanamoto's modulus has no part in it");
  assert.ok(await box(page, "residual_ratio").isHidden(), "there is no residual");
  await box(page, "peak_displacement").fill("12.5");
  await ready(page);
  assert.deepEqual(await assertAnswered(page), withLetter({ law: "wong_peak", peak_displacement_m: 0.0125 }));

  await page.selectOption("#shear", "wong_residual");
  await ready(page);
  await box(page, "residual_ratio").fill("0.5");
  await ready(page);
  const body = await assertAnswered(page);
  assert.deepEqual(body, withLetter({ law: "wong_residual", residual_ratio: 0.5, peak_displacement_m: 0.0125 }));
  await page.waitForURL((address) => address.searchParams.get("kr") === "0.5");
  await assertTravels(page, body);

  await page.click('[data-reset-group="strength"]');
  await ready(page);
  assert.deepEqual(await assertAnswered(page), { ...LETTER, method: "quadrature" });
  assert.ok(await box(page, "shear_modulus").isVisible(), "Janosi–Hanamoto's modulus is back");
});

check("every law that the service has can be chosen, and its fields are those of the service", async (page) => {
  await open(page, "?by=static");
  await openGroups(page);
  const { laws: families } = await (await fetch(url("v1/model"))).json();
  const selects = { "/soil/pressure_sinkage": "law", "/soil/shear": "shear", "/contact": "rule", "/slip_sinkage": "slip_sinkage" };
  for (const [pointer, name] of Object.entries(selects)) {
    for (const law of families.find((family) => family.pointer === pointer).laws) {
      await page.selectOption(`select[name="${name}"]`, law.name);
      await page.waitForSelector('#app[data-busy="false"]');
      for (const parameter of law.parameters) {
        const labels = await page.$$eval(`[data-fault="${parameter.pointer}"]`, (faults) =>
          faults.map((fault) => fault.closest(".field")).filter((field) => field.offsetParent).map((field) => field.querySelector("label").textContent));
        assert.equal(labels.length, 1, `fields for ${parameter.name} of ${law.name}: ${labels}`);
        const words = parameter.meaning.split(/[;:,.](?:\s|$)/)[0].replaceAll("'", "’");
        assert.ok(labels[0].startsWith(words), `${labels[0]}: ${parameter.meaning}`);
      }
    }
  }
}, { refused: true });

check("a residual beyond the largest strength is a fault of the residual", async (page) => {
  await page.goto(url("?shear=wong_residual&kr=1.5"));
  await faulty(page);
  assert.ok(await page.isVisible('[data-fault="/soil/shear/residual_ratio"]'), "the fault is visible");
  assert.equal(await box(page, "residual_ratio").getAttribute("aria-invalid"), "true");
}, { refused: true });

check("the linear slip–sinkage law is asked for beside a static sinkage alone", async (page) => {
  await open(page, "?slip_sinkage=linear&ss_gain=2");
  assert.ok(await page.isHidden("#slip-sinkage"), "a given sinkage follows no slip");
  assert.deepEqual(await assertAnswered(page), { ...LETTER, method: "quadrature" });
  await page.click("label:has(#by-static)");
  await ready(page);
  const body = await assertAnswered(page);
  assert.deepEqual(body.slip_sinkage, { law: "linear", gain: 2 });
  // z0 (1 + S s) with 10 mm, S = 2 and s = 0.2
  assert.ok(Math.abs((await valuesOf(page, ["sinkage_m"])).sinkage_m - 0.014) < 1e-12, "the sinkage is that of the linear law");
  await assertTravels(page, body);
  await page.selectOption("#slip-sinkage", "lyasko");
  await ready(page);
  assert.equal((await assertAnswered(page)).slip_sinkage, undefined);
  // z0 (1 + s)/(1 − s/2)
  assert.ok(Math.abs((await valuesOf(page, ["sinkage_m"])).sinkage_m - 0.012 / 0.9) < 1e-12, "the sinkage is Lyasko's");
});

check("a skid gain is sent with the law it belongs to, and not before it is given", async (page) => {
  await open(page, "?slip_pct=-30&n2=0.2");
  const { soil, ...rest } = await assertAnswered(page);
  const { soil: { pressure_sinkage: own } } = await (await fetch(url("v1/soils/letter-sand"))).json();
  assert.deepEqual(soil.pressure_sinkage, { ...own, n1: 0, n2: 0.2 });
  const before = await valuesOf(page, FORCES);
  await openGroups(page);
  await page.click('[data-reset="n2"]');
  await ready(page);
  assert.deepEqual((await assertAnswered(page)).soil, { preset: "letter-sand" });
  assert.notDeepEqual(await valuesOf(page, FORCES), before);
  assert.deepEqual(picked(await ask("/v1/forces", { ...rest, soil: { preset: "letter-sand" } }), FORCES), await valuesOf(page, FORCES));
});

await run();
