// A rover of the page's wheels on a slope.
import assert from "node:assert/strict";
import { ask } from "./support/api.mjs";
import { assertPoints, drawn } from "./support/chart.mjs";
import { check, run } from "./support/checks.mjs";
import { assertReads, box, faulty, open, ready } from "./support/page.mjs";

const DEGREE = Math.PI / 180;
const ROVER = { soil: { preset: "letter-sand" }, method: "quadrature", mass_kg: 40, hitch_pull_n: 0, slip_limit: 0.6 };
const WHEEL = { preset: "letter" };
/** Those in units that the results of a wheel have as well. */
const PLAIN = ["slip", "needed_pull_n", "torque_n_m"];
const RESULTS = ["slip", "needed_pull_n", "torque_n_m", "energy_per_metre_j_m", "power_w"];

const shown = async (page) => Object.fromEntries(await page.$$eval("[data-rover-result]", (tiles) =>
  tiles.map(({ dataset, textContent }) => [dataset.roverResult, { value: dataset.value === "" ? null : Number(dataset.value), text: textContent }])));

/** The chosen slope and the slopes of the charts are those that the service answers. */
async function assertRover(page, body, slope, [from, to]) {
  const answer = await ask("/v1/vehicle", { ...body, slope_rad: slope * DEGREE });
  const tiles = await shown(page);
  for (const name of RESULTS) {
    assert.equal(tiles[name].value, answer[name], name);
    if (answer[name] !== null && PLAIN.includes(name)) assertReads(tiles[name].text, answer[name], name);
  }
  assert.equal(tiles.largest_slope_rad.value, answer.largest_slope_rad);
  const { columns } = await ask("/v1/vehicle", { ...body, slope_rad: { from: from * DEGREE, to: to * DEGREE, points: 61 } });
  const degrees = columns.slope_rad.map((each) => each / DEGREE);
  for (const [chart, name, factor] of /** @type {[string, string, number][]} */ ([["#rover-slip-chart", "slip", 100], ["#rover-energy-chart", "energy_per_metre_j_m", 1]])) {
    assertPoints(await drawn(page, chart), "quadrature", degrees, columns[name].map((value) => (value === null ? null : value * factor)));
    assert.equal(await page.locator(`${chart} line[data-mark="slope"]`).count(), 1);
  }
  return answer;
}

check("a rover of alike wheels is drawn with slip and energy over the slope", async (page) => {
  await open(page);
  assert.ok(await page.isHidden("#rover-section"));
  await page.check("#rover");
  await ready(page);
  const alike = { ...ROVER, wheels: { count: 4, wheel: WHEEL } };
  const answer = await assertRover(page, alike, 5, [0, 20]);
  assert.ok(answer.climbs);
  assert.match(await page.innerText("#rover-verdict"), /^It climbs 5\.0°/);
  assert.match(await page.innerText("#rover-wheels tbody th"), /Each of 4/);
  assert.equal(await page.locator("#rover-scene circle[data-axle]").count(), 2);

  await box(page, "slope").fill("25");
  await box(page, "rover_velocity").fill("0.1");
  await page.waitForURL(/rover_v_m_s=0.1/);
  await ready(page);
  const steep = await ask("/v1/vehicle", { ...alike, forward_velocity_m_s: 0.1, slope_rad: 25 * DEGREE });
  assert.ok(!steep.climbs, "the service says the same");
  assert.match(await page.innerText("#rover-verdict"), /^It does not climb 25\.0°/);
  await page.reload();
  await ready(page);
  assert.match(await page.innerText("#rover-verdict"), /^It does not climb 25\.0°/);
});

check("a rover with its axles has loads by statics, and ruts", async (page) => {
  await open(page, "?rover=1&axles=400+-400&com_mm=50&com_height_mm=300&rut=1&hitch_n=5&rover_g_m_s2=3.71&slope_deg=4");
  const stations = [0.4, 0.4, -0.4, -0.4].map((x) => ({ x_m: x, wheel: WHEEL }));
  const body = { ...ROVER, hitch_pull_n: 5, gravity_m_s2: 3.71, stations, centre_of_mass: { x_m: 0.05, height_m: 0.3 }, rut: true };
  const answer = await assertRover(page, body, 4, [0, 20]);
  const loads = await page.$$eval('[data-rover-wheel="normal_load_n"]', (cells) => cells.map(({ dataset }) => Number(dataset.value)));
  assert.deepEqual(loads, answer.wheels.map(({ normal_load_n: load }) => load));
  assert.ok(answer.wheels[2].rut_depth_m > 0);
  const lift = await page.locator("#rover-scene").evaluate((element) => element.getElementsByClassName("arrow").length);
  assert.equal(lift, 2, "weight and hitch pull");
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#rover-csv")]);
  assert.equal(download.suggestedFilename(), "vehicle_letter_letter-sand.csv");
});

check("a rover that the service refuses is told at its fields", async (page) => {
  await open(page, "?rover=1");
  await box(page, "mass").fill("-1");
  await faulty(page);
  assert.ok(await page.isVisible('[data-fault="/mass_kg"]'));
  assert.equal(await page.getAttribute("#rover-section", "data-stale"), "true");
  assert.equal(await page.getAttribute("#scene-figure", "data-stale"), "false", "the wheel by itself stands");
  await box(page, "mass").fill("40");
  await page.fill("#axles", "front, rear");
  await faulty(page);
  assert.ok(await page.isVisible("#axles-fault"));
}, { refused: true });

await run();
