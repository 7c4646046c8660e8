// From the first input until its answer, nothing on the page passes for the answer to the inputs.
import assert from "node:assert/strict";
import { check, run } from "./support/checks.mjs";
import { assertAnswered, box, open, ready } from "./support/page.mjs";

/** Answers of the service as they come over a slow line (ms). */
const DELAYS = [100, 700];
const PARTS = ["tiles", "scene", "profile", "sweep", "rover"];

/** @param {number} delay */
async function slowed(page, delay) {
  await page.route("**/v1/**", async (route) => {
    await new Promise((resolve) => { setTimeout(resolve, delay); });
    await route.continue().catch(() => {});
  });
}

/** Sets the box as a paste does, where one is named, and reads the page in the same moment. */
const shown = (page, name = "", text = "") => page.evaluate(([input, value]) => {
  const field = document.querySelector(`input[name="${input}"]`);
  if (field instanceof HTMLInputElement) {
    field.value = value;
    field.dispatchEvent(new Event("input", { bubbles: true }));
  }
  return {
    parts: [...document.querySelectorAll("[data-part]")].map((element) => [element.getAttribute("data-part"), element.getAttribute("data-stale")]),
    exports: [...document.querySelectorAll("button[data-gives]")].map((button) => button.hasAttribute("disabled")),
    status: document.querySelector("#status")?.textContent,
    state: document.querySelector("#app")?.getAttribute("data-state"),
    isBusy: document.querySelector("#app")?.getAttribute("data-busy") === "true",
  };
}, [name, text]);

function assertPending({ status, state, parts, exports }, when) {
  assert.doesNotMatch(status, /Results match/, when);
  assert.equal(state, "loading", when);
  assert.deepEqual([...new Set(parts.map(([part]) => part))].sort(), [...PARTS].sort());
  assert.deepEqual([...new Set(parts.map(([, stale]) => stale))], ["true"], when);
  assert.deepEqual([...new Set(exports)], [true], when);
}

for (const delay of DELAYS) {
  check(`results are marked as not yet current for ${delay} ms`, async (page) => {
    await open(page);
    await slowed(page, delay);
    assertPending(await shown(page, "slip", "35"), "right after the input");
    // The answer to 35 % is not the answer to 36 %.
    await page.waitForTimeout(delay / 2);
    assertPending(await shown(page, "slip", "36"), "after a further input");
    const round = await page.getAttribute("#app", "data-round");
    await page.waitForSelector(`#app:not([data-round="${round}"])`);
    const between = await shown(page);
    if (between.isBusy) assertPending(between, "after the first answer");
    await ready(page);
    assert.equal((await assertAnswered(page)).slip, 0.36);
    const { parts, exports } = await shown(page);
    assert.deepEqual([...new Set(parts.map(([, stale]) => stale))], ["false"]);
    assert.deepEqual([...new Set(exports)], [false]);

    await page.check("#rover");
    await ready(page);
    assertPending(await shown(page, "mass", "60"), "with a rover");
    await ready(page);
  });
}

check("a slip angle that is not used is kept and told at its field", async (page) => {
  for (const query of ["?beta_deg=10&method=explicit", "?beta_deg=10&compare=1", "?beta_deg=10&method=linearised"]) {
    await open(page, query);
    assert.equal(await box(page, "slip_angle").inputValue(), "10");
    assert.match(await page.innerText("#slip_angle-note"), /^Not used/, query);
    assert.equal((await assertAnswered(page)).slip_angle_rad, undefined);
    assert.ok(page.url().includes("beta_deg=10"), "the address keeps it");
  }
  await page.selectOption("#method", "quadrature");
  await ready(page);
  assert.ok(Math.abs(((await assertAnswered(page)).slip_angle_rad ?? 0) - Math.PI / 18) < 1e-12);
  assert.ok(await page.isHidden("#slip_angle-note"));
});

await run();
