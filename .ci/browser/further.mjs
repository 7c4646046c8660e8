// Towing, Bekker's resistances, and the pull from a measured torque.
import assert from "node:assert/strict";
import { ask } from "./support/api.mjs";
import { check, run } from "./support/checks.mjs";
import { assertReads, box, open, ready } from "./support/page.mjs";

const WHEEL = { preset: "letter" };
const SOIL = { preset: "letter-sand" };
const SYSTEM = { wheel: WHEEL, soil: SOIL };

/** The results of a block, as text and as the number that it stands for. */
const shown = async (page, block) => Object.fromEntries(await page.$$eval(`[data-further="${block}"] [data-further-result]`, (cells) =>
  cells.map(({ dataset, textContent }) => [dataset.furtherResult, { text: textContent, value: dataset.value ? Number(dataset.value) : null }])));

async function assertBlock(page, block, answer) {
  for (const [name, { text, value }] of Object.entries(await shown(page, block))) {
    assert.equal(value, answer[name] ?? null, `${block} ${name}`);
    if (value !== null) assertReads(text, value, name);
  }
}

const warned = (page, block) => page.$$eval(`[data-further="${block}"] li[data-warning]`, (items) => items.map(({ dataset }) => dataset.warning));
const said = (page) => page.$$eval("#warnings li[data-warning]", (items) => items.map(({ dataset }) => dataset.warning));

check("towing, resistances and pull from torque are asked for under the load of the page", async (page) => {
  const loaded = [];
  page.on("request", (request) => loaded.push(new URL(request.url()).pathname));
  await open(page, "?by=load&load_n=100");
  assert.ok(await page.isHidden("#further-section"));
  assert.ok(!loaded.some((path) => path.includes("/further/view") || path === "/v1/towed"), "nothing of it is loaded before it is asked for");
  await page.check("#further");
  await ready(page);

  await assertBlock(page, "towed", await ask("/v1/towed", { ...SYSTEM, normal_load_n: 100 }));
  const estimates = await ask("/v1/resistances", { ...SYSTEM, normal_load_n: 100, slip: 0.2 });
  await assertBlock(page, "resistances", estimates);
  const own = estimates.warnings.map(({ code }) => code);
  const before = await said(page);
  assert.deepEqual(await warned(page, "resistances"), own.filter((code) => !before.includes(code)));
  assert.ok(own.includes("needs_unit_weight"), `${own}`);
  assert.match(await page.innerText('[data-further="resistances"] .warnings'), /bulldozing resistance needs the unit weight/);
  assert.equal((await shown(page, "coupled")).longitudinal_force_n.value, null);
  assert.match(await page.innerText('[data-further="coupled"]'), /Type the measured torque/);

  await box(page, "measured_torque").fill("5");
  await page.waitForURL(/torque_nm=5/);
  await ready(page);
  const { sinkage_m } = await ask("/v1/forces", { ...SYSTEM, slip: 0.2, normal_load_n: 100 });
  const pull = await ask("/v1/coupled", { wheel: WHEEL, slip: 0.2, sinkage_m, normal_load_n: 100, torque_n_m: 5 });
  await assertBlock(page, "coupled", pull);
  assert.ok(pull.longitudinal_force_n !== null);
  await page.reload();
  await ready(page);
  await assertBlock(page, "coupled", pull);
  assert.equal(new URLSearchParams(new URL(page.url()).search).get("further"), "1");
});

check("with a unit weight there is a bulldozing resistance", async (page) => {
  await open(page, "?further=1&by=load&load_n=100");
  await box(page, "soil_unit_weight").fill("15");
  await page.waitForURL(/gamma_soil_kn_m3=15/);
  await ready(page);
  const estimates = await ask("/v1/resistances", { wheel: WHEEL, soil: { ...SOIL, unit_weight_n_m3: 15_000 }, normal_load_n: 100, slip: 0.2 });
  assert.ok(estimates.bulldozing_resistance_n > 0);
  await assertBlock(page, "resistances", estimates);
});

check("a sinkage brings the load, and a contact of its own goes into the pull", async (page) => {
  await open(page, "?further=1&torque_nm=5&rule=wong_reece&c1=0.4&c2=0.1&c3=-0.3&sinkage_mm=25&slip_pct=30");
  const contact = { rule: "wong_reece", c1: 0.4, c2: 0.1, c3: -0.3 };
  const { normal_force_n: load } = await ask("/v1/forces", { ...SYSTEM, contact, slip: 0.3, sinkage_m: 0.025 });
  await assertBlock(page, "towed", await ask("/v1/towed", { ...SYSTEM, contact, normal_load_n: load }));
  const measured = { wheel: WHEEL, slip: 0.3, sinkage_m: 0.025, normal_load_n: load, torque_n_m: 5 };
  const pull = await ask("/v1/coupled", { ...measured, contact });
  await assertBlock(page, "coupled", pull);
  assert.notEqual(pull.longitudinal_force_n, (await ask("/v1/coupled", measured)).longitudinal_force_n, "the contact matters");
  assert.match(await page.innerText("#further-basis"), /the normal force of the operating point/);
});

check("what the service refuses is told in its block, and the rest stands", async (page) => {
  await open(page, "?further=1&torque_nm=1e15");
  assert.match(await page.innerText('[data-further="coupled"] .fault'), /^Measured torque:/);
  assert.ok((await shown(page, "towed")).towing_resistance_n.value > 0);
  await box(page, "measured_torque").fill("4");
  await ready(page);
  assert.ok(await page.isHidden('[data-further="coupled"] .fault'));
}, { refused: true });

await run();
