// What can be said of the contact: its end, what lies between a bare rim and the soil, and the circles of a wheel with lugs.
import assert from "node:assert/strict";
import { ask } from "./support/api.mjs";
import { check, run } from "./support/checks.mjs";
import { dropFile } from "./support/measurements.mjs";
import { assertAnswered, box, open, openGroups, ready } from "./support/page.mjs";

const LUGGED = "tohoku-2005-b";

check("the exit is by c3 down to −1.2, or by the ratio of the sinkages", async (page) => {
  await open(page);
  await openGroups(page);
  assert.equal(await page.getAttribute('input[data-slider="c3"]', "min"), "-1.2");
  await box(page, "c3").fill("-1.2");
  await ready(page);
  assert.equal((await assertAnswered(page)).contact.c3, -1.2);
  await page.selectOption("#exit", "sinkage_ratio");
  await ready(page);
  assert.ok(await box(page, "c3").isHidden(), "the ratio takes the place of c3");
  await box(page, "exit_ratio").fill("0.9");
  await ready(page);
  const { contact } = await assertAnswered(page);
  assert.deepEqual(contact, { rule: "midpoint", exit: { ratio: 0.9 } });
  await page.waitForURL(/exit=sinkage_ratio.*exit_ratio=0.9|exit_ratio=0.9.*exit=sinkage_ratio/);
  await page.reload();
  await ready(page);
  assert.deepEqual((await assertAnswered(page)).contact, contact);
});

check("a bare rim has an interface", async (page) => {
  await open(page, "?c_kpa=1&delta_deg=20&adhesion_kpa=0.1&ki_mm=5");
  const { contact } = await assertAnswered(page);
  assert.deepEqual([contact.interface.adhesion_pa, contact.interface.shear_modulus_m], [100, 0.005]);
  assert.ok(Math.abs(contact.interface.friction_angle_rad - Math.PI / 9) < 1e-12);
  await openGroups(page);
  assert.ok(await box(page, "interface_friction").isVisible());
  await box(page, "lug_height").fill("10");
  await ready(page);
  assert.ok(await box(page, "interface_friction").isHidden(), "lugs shear the soil in itself");
  assert.equal((await assertAnswered(page)).contact, undefined);
});

check("a wheel with lugs has two choices of a circle, in the address, the results and the legend", async (page) => {
  await open(page);
  await openGroups(page);
  assert.ok(await page.isHidden("#slip-radius"), "without lugs all circles are one");
  await box(page, "lug_height").fill("10");
  await ready(page);
  await page.selectOption("#slip-radius", "lug_tip");
  await page.selectOption("#shear-displacement-radius", "rim");
  await ready(page);
  const body = await assertAnswered(page);
  assert.deepEqual([body.slip_radius, body.shear_displacement_radius], ["lug_tip", "rim"]);
  const answer = await ask("/v1/forces", body);
  assert.deepEqual([answer.slip_radius, answer.shear_displacement_radius], ["lug_tip", "rim"]);
  assert.match(await page.innerText('#basis [data-basis="circles"]'), /tips of the lugs.*the rim/);
  for (const chart of ["#torque-chart", "#profile-chart"]) assert.match(await page.innerText(`${chart} .legend`), /slip at the tips of the lugs/);
  const query = new URL(page.url()).searchParams;
  assert.deepEqual([query.get("slip_radius"), query.get("shear_displacement_radius")], ["lug_tip", "rim"]);
  await page.emulateMedia({ media: "print" });
  assert.ok(await page.isVisible("#basis") && await page.isVisible("#slip-radius"), "the print has them");
});

check("a file says on which circle its slip was counted", async (page) => {
  await open(page, "?lug_mm=10");
  await dropFile(page, "slip,torque N·m\n0.1,4\n0.2,5");
  assert.ok(await page.isVisible("#measured-slip-radius"));
  await page.selectOption("#measured-slip-radius", "shearing");
  await ready(page);
  assert.equal((await assertAnswered(page)).slip_radius, "shearing");
  assert.equal(await page.inputValue("#slip-radius"), "shearing");
});

check("a wheel whose lugs are not published says that it is computed as smooth", async (page) => {
  await open(page, `?wheel=${LUGGED}`);
  await openGroups(page);
  assert.match(await page.innerText("#lug_height-substitute"), /^Assumed/);
  assert.match(await page.innerText('#basis [data-basis="assumed"]'), /Lug height 0\smm/);
});

await run();
