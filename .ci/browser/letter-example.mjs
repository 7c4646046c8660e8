// The page starts on the letter's example, with its numbers and all its curves.
import assert from "node:assert/strict";
import { LETTER, ask, overSlip } from "./support/api.mjs";
import { SLIP_CHARTS, assertProfile, assertSweep, drawn, inDegrees, pointAt, reading } from "./support/chart.mjs";
import { check, run } from "./support/checks.mjs";
import { assertAnswered, box, open, ready, results, url } from "./support/page.mjs";

/** From an integration of the letter's equations that shares no code with the service, half a unit of the last digit apart. */
const INTEGRATED = {
  longitudinal_force_n: [16.906, 0.0005],
  normal_force_n: [89.716, 0.0005],
  torque_n_m: [7.3396, 0.00005],
};

check("before the first answer the page shows its parts and says that it waits", async (page) => {
  /** @type {(value?: unknown) => void} */
  let release = () => {};
  const released = new Promise((resolve) => { release = resolve; });
  await page.route("**/v1/**", async (route) => {
    // The fields are made from this.
    if (!route.request().url().endsWith("/v1/model")) await released;
    await route.continue();
  });
  await page.goto(url());
  assert.equal(await box(page, "slip").inputValue(), "20");
  assert.equal(await page.innerText("#status"), "Asking the service…");
  for (const part of ["#tiles", "#controls", "#scene .placeholder", "#profile-chart .placeholder", "#fourth-chart .placeholder",
    ...Object.keys(SLIP_CHARTS).map((chart) => `${chart} .placeholder`)]) {
    assert.ok(await page.isVisible(part), `${part} is visible`);
    assert.notEqual((await page.innerText(part)).trim(), "", `${part} says something`);
  }
  assert.doesNotMatch(await page.innerText("body"), /NaN|undefined|null|Infinity/);
  release();
  await ready(page);
  assert.equal(await page.locator(".placeholder").count(), 0, "placeholders left");
});

check("it starts on the letter's example and its forces", async (page) => {
  await open(page);
  assert.equal(await page.inputValue("#wheel"), "letter");
  assert.equal(await page.inputValue("#soil"), "letter-sand");
  assert.equal(await page.inputValue("#method"), "quadrature");
  assert.ok(await page.isChecked("#by-sinkage"), "the sinkage is given");
  assert.equal(await box(page, "slip").inputValue(), "20");
  assert.equal(await box(page, "sinkage").inputValue(), "20");
  const shown = await results(page);
  for (const [name, [expected, tolerance]] of Object.entries(INTEGRATED)) {
    assert.ok(Math.abs(shown[name].value - expected) <= tolerance, `${name} is ${shown[name].value}, not ${expected}`);
  }
  assert.deepEqual(await assertAnswered(page), { ...LETTER, method: "quadrature" });
});

check("the stresses are drawn as the service gives them, with their angles", async (page) => {
  await open(page);
  const { angles, columns } = await ask("/v1/stress-profile", { ...LETTER, points: 201 });
  await assertProfile(page, columns);
  const { marks } = await drawn(page, "#profile-chart");
  for (const [mark, angle] of [["exit", angles.exit_rad], ["maximum", angles.maximum_stress_rad], ["entry", angles.entry_rad]]) {
    assert.ok(Math.abs(marks[mark].at - inDegrees(angle)) < 0.01, `${mark} is marked at ${marks[mark].at}°`);
    assert.equal(await page.locator(`#scene line[data-mark="${mark}"]`).count(), 1, `${mark} is marked in the scene`);
  }
});

check("the cursor reads the peak of the normal stress at its angle", async (page) => {
  await open(page);
  const { peak, angles } = await ask("/v1/stress-profile", { ...LETTER, points: 201 });
  const { marks } = await drawn(page, "#profile-chart");
  const readAt = async (px) => {
    await pointAt(page, "#profile-chart", px);
    return (await reading(page, "#profile-chart", "normal")).replace("\u00a0", " ");
  };
  const aside = await readAt((marks.exit.px + marks.maximum.px) / 2);
  assert.ok(parseFloat(aside) < 15, `half-way to the exit the cursor reads ${aside}`);
  assert.equal(await readAt(marks.maximum.px), "16.3 kPa");
  assert.equal((peak.normal_stress_pa / 1000).toFixed(1), "16.3");
  assert.equal(await page.innerText("#profile-chart .legend .position"), `θ ${inDegrees(angles.maximum_stress_rad).toFixed(1)}°`);
});

check("the forces over slip are drawn as the service gives them", async (page) => {
  await open(page);
  const { columns } = await ask("/v1/slip-sweep", overSlip(LETTER));
  await assertSweep(page, "quadrature", columns);
  for (const chart of Object.keys(SLIP_CHARTS)) {
    const { marks } = await drawn(page, chart);
    assert.ok(Math.abs(marks.slip.at - 20) < 0.01, `${chart} marks the slip ${marks.slip.at} %`);
  }
});

await run();
