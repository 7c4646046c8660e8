// Values that no one published: the catalogue's substitutes are offered, taken in one click, and always marked.
import assert from "node:assert/strict";
import { ask } from "./support/api.mjs";
import { check, run } from "./support/checks.mjs";
import { assertAnswered, box, faulty, openGroups, ready, url } from "./support/page.mjs";

/** With what they lack. */
const LACKING = [
  { query: "?soil=kls1", at: "shear_modulus", pointers: ["soil.shear_modulus_m"], lacks: /shear deformation modulus/ },
  { query: "?soil=exomars-es1-low", at: "cohesion", pointers: ["soil.cohesion_pa", "soil.friction_angle_rad", "soil.shear_modulus_m"] },
  { query: "?wheel=sojourner&by=load&load_n=6.55", at: "width", pointers: ["wheel.width_m"] },
  { query: "?soil=wong-reece-loose-sand", at: null, pointers: ["soil.pressure_sinkage.k_c", "soil.pressure_sinkage.k_phi", "soil.pressure_sinkage.n0"] },
];

for (const { query, at, pointers, lacks } of LACKING) {
  check(`what is missing is assumed in one click: ${query}`, async (page) => {
    await page.goto(url(query));
    await faulty(page);
    await openGroups(page);
    assert.ok(await page.isHidden("#basis"), "nothing is assumed unasked");
    if (lacks) assert.match(await page.innerText("#soil-grade .gaps"), lacks);
    if (at) await page.click(`[data-assume="${at}"]`);
    else await page.check("#assume");
    await ready(page);
    const body = await assertAnswered(page);
    assert.equal(body.assume, true);
    const { assumed } = await ask("/v1/forces", body);
    const needed = assumed.filter(({ field }) => field !== "wheel.lug_height_m");
    assert.deepEqual(needed.map(({ field }) => field).sort(), [...pointers].sort());
    const told = await page.innerText('#basis [data-basis="assumed"]');
    for (const { reason } of needed) assert.ok(told.includes(reason.replaceAll("`", "")), `${told} has: ${reason}`);
    assert.match(await page.innerText("#torque-chart .legend"), /assumed: /);
    const marked = await page.$$eval(".field.assumed", (fields) => fields.filter(({ offsetParent }) => offsetParent).map(({ dataset }) => dataset.field));
    assert.ok(marked.length >= needed.length, `${marked} are marked`);
    if (at) assert.match(await page.innerText(`#${at}-substitute`), /^Assumed: /);
    assert.ok(new URL(page.url()).searchParams.get("assume") === "1", "the address has it");
    await page.emulateMedia({ media: "print" });
    assert.ok(await page.isVisible('#basis [data-basis="assumed"]'), "the print has it");
    await page.emulateMedia({ media: "screen" });
    if (at) {
      await box(page, at).fill("30");
      await page.waitForSelector(`#${at}-substitute`, { state: "hidden" });
    }
    await page.uncheck("#assume");
    await page.waitForSelector('#app[data-busy="false"]:not([data-state="loading"])');
  }, { refused: true });
}

await run();
