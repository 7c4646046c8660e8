// What is wrong with an input is told at that input, in the service's words and the input's unit, until it is put right.
import assert from "node:assert/strict";
import { LETTER, faultOf } from "./support/api.mjs";
import { check, run } from "./support/checks.mjs";
import { assertAnswered, box, curlBody, faulty, open, ready, results } from "./support/page.mjs";

const NUMBER = /(?<![\w.])-?\d+(?:\.\d+)?(?:e-?\d+)?/g;
/** Six digits are shown. */
const SHOWN_PRECISION = 1e-5;

/** The service's sentence with its numbers in another unit, each with the unit beside it; what it advises on its own unit is left out. */
function assertConverted(shown, { detail: sentence, unit, perSi }) {
  const [detail] = sentence.split("; ");
  const plain = shown.replaceAll("\u00a0", " ");
  const numbers = [...plain.matchAll(NUMBER)];
  const expected = detail.match(NUMBER).map((number) => Number(number) * perSi);
  assert.equal(numbers.length, expected.length, `numbers in "${plain}"`);
  numbers.forEach((match, index) => {
    const [number] = match;
    assert.ok(Math.abs(number - expected[index]) <= SHOWN_PRECISION * Math.abs(expected[index]), `${number} in "${plain}" is not ${expected[index]}`);
    assert.ok(plain.slice(match.index + number.length).trimStart().startsWith(unit), `${number} in "${plain}" has not the unit ${unit}`);
  });
  const words = (text) => text.replace(NUMBER, "").replaceAll(unit, "").replace(/\s+/g, "");
  assert.equal(words(plain), words(detail));
}

/**
 * `told` is in the fault as it stands; `converted` is the service's sentence, with the unit it is to be shown in.
 * @param {import("playwright-core").Page} page
 * @param {{ name: string, pointer: string, told?: string, converted?: { detail: string, unit: string, perSi: number } }} expected
 */
async function assertFault(page, { name, pointer, told, converted }) {
  await faulty(page);
  const fault = page.locator(`[data-fault="${pointer}"]`);
  assert.ok(await fault.isVisible(), `the fault at ${pointer} is visible`);
  const shown = await fault.innerText();
  if (converted) assertConverted(shown, converted);
  told ??= shown;
  assert.ok(shown.includes(told), `"${shown}" is not "${told}"`);
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
    const detail = await faultOf({ ...LETTER, wheel: { preset: "letter", radius_m } }, "/wheel/radius_m");
    await box(page, "radius").fill(text);
    await assertFault(page, { name: "radius", pointer: "/wheel/radius_m", converted: { detail, unit: "mm", perSi: 1000 } });
  }
  assert.deepEqual(await results(page), before);
  await box(page, "radius").fill("200");
  await assertHealed(page, { name: "radius", pointer: "/wheel/radius_m" });
  assert.deepEqual(await results(page), before);
}, { refused: true });

check("a negative cohesion", async (page) => {
  await open(page);
  const detail = await faultOf({ ...LETTER, soil: { preset: "letter-sand", cohesion_pa: -1000 } }, "/soil/cohesion_pa");
  await box(page, "cohesion").fill("-1");
  await assertFault(page, { name: "cohesion", pointer: "/soil/cohesion_pa", converted: { detail, unit: "kPa", perSi: 1e-3 } });
  await page.click('[data-reset="cohesion"]');
  await assertHealed(page, { name: "cohesion", pointer: "/soil/cohesion_pa" });
}, { refused: true });

check("a friction angle beyond the upright is told in degrees", async (page) => {
  await open(page);
  const detail = await faultOf({ ...LETTER, soil: { preset: "letter-sand", friction_angle_rad: 2 } }, "/soil/friction_angle_rad");
  await box(page, "friction_angle").fill(String(360 / Math.PI));
  await assertFault(page, { name: "friction_angle", pointer: "/soil/friction_angle_rad", converted: { detail, unit: "°", perSi: 180 / Math.PI } });
  assert.ok((await page.innerText("#status")).includes("90°"), await page.innerText("#status"));
}, { refused: true });

check("a slip beyond spinning is told in per cent", async (page) => {
  await open(page);
  const detail = await faultOf({ ...LETTER, slip: 1.5 }, "/slip");
  await box(page, "slip").fill("150");
  await assertFault(page, { name: "slip", pointer: "/slip", converted: { detail, unit: "%", perSi: 100 } });
}, { refused: true });

check("a bound that another input sets is told in millimetres, with that input", async (page) => {
  await open(page);
  await box(page, "sinkage").fill("300");
  await assertFault(page, { name: "sinkage", pointer: "/sinkage_m", told: "must be from 0.000001\u00a0mm to 200\u00a0mm (“Rim radius”), not 300\u00a0mm" });
}, { refused: true });

check("a comma is not guessed at", async (page) => {
  await open(page);
  const before = await results(page);
  for (const [text, told] of [["1,000", "type 1000 or 1.000"], ["1,000.5", "commas between thousands: 1000.5"], ["1,000,000", "commas between thousands: 1000000"], ["1.000,5", "with one decimal sign and nothing between thousands"]]) {
    await box(page, "width").fill(text);
    await assertFault(page, { name: "width", pointer: "/wheel/width_m", told });
    assert.deepEqual(await results(page), before);
    await page.click("#copy-link");
    assert.equal(new URL(page.url()).search, "", "what is no number does not get into the address");
  }
  await box(page, "width").fill("100");
  await assertHealed(page, { name: "width", pointer: "/wheel/width_m" });
});

check("a comma may part the decimals", async (page) => {
  await open(page);
  for (const [text, pascals, address] of [["1,04", 1040, "1.04"], ["0,125", 125, "0.125"], [",5", 500, ".5"]]) {
    await box(page, "cohesion").fill(text);
    await ready(page);
    assert.equal((await curlBody(page)).soil.cohesion_pa, pascals);
    assert.equal(await box(page, "cohesion").inputValue(), text, "the text stays as it was typed");
    await page.click("#copy-link");
    assert.equal(new URL(page.url()).searchParams.get("c_kpa"), address);
  }
  await box(page, "slip").fill("12,5");
  await ready(page);
  assert.equal(await page.inputValue('[data-slider="slip"]'), "13", "the slider has steps of one per cent");
  await box(page, "slip").press("ArrowUp");
  await ready(page);
  assert.equal((await curlBody(page)).slip, 0.135);
}, { context: { permissions: ["clipboard-write"] } });

/** What the page says of a value out of its range: the range in the unit of the box, and no other advice. */
const OUT_OF_RANGE = [
  ["slip", "/slip", "200", "must be from -100 % to 100 %, not 200 %"],
  ["friction_angle", "/soil/friction_angle_rad", "95", "must be at least 0° and less than 90°, not 95°"],
  ["radius", "/wheel/radius_m", "0.125", "must be from 1 mm to 100000 mm, not 0.125 mm; 0.125 m are 125 mm"],
  ["radius", "/wheel/radius_m", "0.0000125", "must be from 1 mm to 100000 mm, not 0.0000125 mm"],
];

check("a value out of its range is told the range", async (page) => {
  await open(page);
  for (const [name, pointer, text, expected] of OUT_OF_RANGE) {
    await box(page, name).fill(text);
    await faulty(page);
    const told = await page.innerText(`[data-fault="${pointer}"]`);
    assert.equal(told.replaceAll("\u00a0", " ").replace("1.25e-5", "0.0000125"), expected);
    await page.click("#reset-all");
    await ready(page);
  }
}, { refused: true });

check("a range that comes as data is told in the unit of the box", async (page) => {
  await open(page);
  const fault = { pointer: "/wheel/radius_m", detail: "must be from 1 to 2, not 3", value: 0.0005, minimum: 0.001, maximum: 100 };
  const json = { type: "about:blank", title: "refused", status: 422, detail: "refused", errors: [fault] };
  await page.route(/\/v1\/(forces|slip-sweep|stress-profile)$/, (route) => route.fulfill({ status: 422, json }));
  await box(page, "radius").fill("0.5");
  await faulty(page);
  const told = await page.innerText(`[data-fault="${fault.pointer}"]`);
  assert.equal(told.replaceAll("\u00a0", " "), "must be from 1 mm to 100000 mm, not 0.5 mm; 0.5 m are 500 mm");
}, { refused: true });

check("a slip that brakes and the tick for braking go together", async (page) => {
  await open(page);
  await box(page, "slip").fill("-20");
  await ready(page);
  assert.ok(await page.isChecked("#braking"));
  assert.equal(await page.inputValue('[data-slider="slip"]'), "-20");
  await page.uncheck("#braking");
  await ready(page);
  assert.equal((await curlBody(page)).slip, 0);
  await open(page, "?slip_pct=-20");
  assert.ok(await page.isChecked("#braking"), "from an address as well");
});

check("the request of former inputs cannot be taken for that of these", async (page) => {
  await open(page);
  const gives = ["#copy-curl", "#profile-csv", "#sweep-csv"];
  const assertGives = async (isGiven) => {
    for (const button of gives) assert.equal(await page.isEnabled(button), isGiven, `${button} can be used`);
    assert.equal(await page.isHidden("#curl-note"), isGiven, "a note tells what the command is of");
    const { opacity, userSelect } = await page.$eval("#curl", (curl) => {
      const style = getComputedStyle(curl);
      return { opacity: style.opacity, userSelect: style.userSelect };
    });
    assert.deepEqual([Number(opacity) === 1, userSelect !== "none"], [isGiven, isGiven]);
  };
  await assertGives(true);
  await page.selectOption("#soil", "robomech2020-sand");
  await faulty(page);
  // The dimming takes a moment.
  await page.waitForTimeout(200);
  await assertGives(false);
  await box(page, "shear_modulus").fill("10");
  await ready(page);
  await page.waitForTimeout(200);
  await assertGives(true);
  assert.equal((await curlBody(page)).soil.preset, "robomech2020-sand");
  await box(page, "shear_modulus").fill("ten");
  await faulty(page);
  await page.waitForTimeout(200);
  await assertGives(false);
}, { refused: true });

check("two faults at once are both told", async (page) => {
  await open(page);
  await box(page, "radius").fill("-5");
  await box(page, "cohesion").fill("-1");
  await faulty(page);
  for (const pointer of ["/wheel/radius_m", "/soil/cohesion_pa"]) {
    assert.ok(await page.locator(`[data-fault="${pointer}"]`).isVisible(), `the fault at ${pointer} is visible`);
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
  const refused = [];
  page.on("response", (response) => { if (response.status() === 422) refused.push(response.url()); });
  await page.selectOption("#soil", soil.preset);
  await assertFault(page, { name: "shear_modulus", pointer: "/soil/shear_modulus_m", told: told.replaceAll("`", "") });
  assert.match(await page.innerText("#status"), /^Shear deformation modulus K: is required: /);
  const quoted = [...told.matchAll(/`([^`]+)`/g)].map((found) => found[1]);
  assert.ok(quoted.length > 0 && quoted[0] === soil.preset, told);
  assert.deepEqual(await page.locator("#status code").allInnerTexts(), quoted, "the quoted names stand as code");
  assert.deepEqual(refused.map((url) => new URL(url).pathname), ["/v1/forces"], "a missing value is asked for once");
  await box(page, "shear_modulus").fill("10");
  await assertHealed(page, { name: "shear_modulus", pointer: "/soil/shear_modulus_m" });
  assert.deepEqual((await curlBody(page)).soil, { ...soil, shear_modulus_m: 0.01 });
}, { refused: true });

await run();
