// What is wrong with an input is told at that input, in the service's words, until it is put right.
import assert from "node:assert/strict";
import { LETTER, faultOf } from "./support/api.mjs";
import { check, run } from "./support/checks.mjs";
import { assertAnswered, box, curlBody, faulty, open, ready, results } from "./support/page.mjs";

async function assertFault(page, { name, pointer, told }) {
  await faulty(page);
  const fault = page.locator(`[data-fault="${pointer}"]`);
  assert.ok(await fault.isVisible(), `the fault at ${pointer} is to be seen`);
  assert.ok((await fault.innerText()).includes(told), `"${await fault.innerText()}" is not "${told}"`);
  assert.equal(await box(page, name).getAttribute("aria-invalid"), "true");
  assert.equal(await page.locator('[aria-invalid="true"]').count(), 1, "number of inputs marked as wrong");
  assert.ok((await page.innerText("#status")).includes(told), await page.innerText("#status"));
  assert.equal(await page.getAttribute("#tiles", "data-stale"), "true", "the results are marked as old ones");
}

async function assertHealed(page, { name, pointer }) {
  await ready(page);
  assert.ok(await page.locator(`[data-fault="${pointer}"]`).isHidden(), `the fault at ${pointer} is gone`);
  assert.equal(await box(page, name).getAttribute("aria-invalid"), null);
  assert.equal(await page.locator('[data-stale="true"]').count(), 0, "number of parts marked as old");
  await assertAnswered(page);
}

check("a radius out of range", async (page) => {
  await open(page);
  const before = await results(page);
  for (const [text, radius_m] of [["-5", -0.005], ["0", 0]]) {
    const told = await faultOf({ ...LETTER, wheel: { preset: "letter", radius_m } }, "/wheel/radius_m");
    await box(page, "radius").fill(text);
    await assertFault(page, { name: "radius", pointer: "/wheel/radius_m", told });
  }
  assert.deepEqual(await results(page), before);
  await box(page, "radius").fill("200");
  await assertHealed(page, { name: "radius", pointer: "/wheel/radius_m" });
  assert.deepEqual(await results(page), before);
}, { refused: true });

check("a negative cohesion", async (page) => {
  await open(page);
  const told = await faultOf({ ...LETTER, soil: { preset: "letter-sand", cohesion_pa: -1000 } }, "/soil/cohesion_pa");
  await box(page, "cohesion").fill("-1");
  await assertFault(page, { name: "cohesion", pointer: "/soil/cohesion_pa", told });
  await page.click('[data-reset="cohesion"]');
  await assertHealed(page, { name: "cohesion", pointer: "/soil/cohesion_pa" });
}, { refused: true });

check("two faults at once are both told", async (page) => {
  await open(page);
  await box(page, "radius").fill("-5");
  await box(page, "cohesion").fill("-1");
  await faulty(page);
  for (const pointer of ["/wheel/radius_m", "/soil/cohesion_pa"]) {
    assert.ok(await page.locator(`[data-fault="${pointer}"]`).isVisible(), `the fault at ${pointer} is to be seen`);
  }
  await page.click("#reset-all");
  await assertHealed(page, { name: "radius", pointer: "/wheel/radius_m" });
}, { refused: true });

check("a text that is no number is not sent", async (page) => {
  await open(page);
  await box(page, "width").fill("wide");
  await assertFault(page, { name: "width", pointer: "/wheel/width_m", told: "Type a number" });
  await box(page, "width").fill("120");
  await assertHealed(page, { name: "width", pointer: "/wheel/width_m" });
  assert.equal((await curlBody(page)).wheel.width_m, 0.12);
});

check("a soil without a shear modulus asks for one", async (page) => {
  await open(page);
  const soil = { preset: "robomech2020-sand" };
  const told = await faultOf({ ...LETTER, soil }, "/soil/shear_modulus_m");
  await page.selectOption("#soil", soil.preset);
  await assertFault(page, { name: "shear_modulus", pointer: "/soil/shear_modulus_m", told });
  await box(page, "shear_modulus").fill("10");
  await assertHealed(page, { name: "shear_modulus", pointer: "/soil/shear_modulus_m" });
  assert.deepEqual((await curlBody(page)).soil, { ...soil, shear_modulus_m: 0.01 });
}, { refused: true });

await run();
