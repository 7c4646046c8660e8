// The equations, errata and warnings are read on the page itself.
import assert from "node:assert/strict";
import { check, run } from "./support/checks.mjs";
import { open, url } from "./support/page.mjs";

const statement = async () => (await fetch(url("v1/model"))).json();

check("the link opens the equations and errata in readable form", async (page) => {
  await open(page);
  await page.click("#open-model");
  await page.waitForSelector("#model[open] #model-references");
  assert.equal(page.url(), url(), "the page stays");
  const model = await statement();
  for (const [part, rows] of [["symbols", model.symbols], ["equations", model.equations], ["methods", model.methods], ["errata", model.errata], ["warnings", model.warnings]]) {
    assert.equal(await page.locator(`#model-${part} tbody tr`).count(), rows.length, `rows of ${part}`);
  }
  for (const [part, items] of [["conventions", model.conventions], ["refusals", model.refusals], ["references", model.references]]) {
    assert.equal(await page.locator(`#model-${part} li`).count(), items.length, `items of ${part}`);
  }
  const text = await page.innerText("#model");
  for (const { code } of model.warnings) assert.ok(text.includes(code), `${code} is explained`);
  for (const { reason } of model.errata.filter((each) => !/[_^\d]/.test(each.reason))) assert.ok(text.includes(reason), reason);
  assert.ok(!text.includes("`") && await page.locator("#model-conventions code").count() > 0, "names of the API stand as code");
  assert.doesNotMatch(text, /undefined|\[object|[{}"]pointer/);
  await page.keyboard.press("Escape");
  assert.ok(await page.isHidden("#model"), "Escape closes it");
});

check("letters have their subscripts and powers", async (page) => {
  await page.goto(url("#model"));
  await page.waitForSelector("#model-references");
  const row = (part, head) => page.locator(`#model-${part} tr`, { has: page.locator("th", { hasText: head }) }).first();
  const markup = (locator) => locator.evaluate((element) => element.innerHTML);
  assert.equal(await markup(row("equations", /^sinkage modulus, bekker$/).locator("td").first()), "K<sub>s</sub> = k<sub>c</sub>/b + k<sub>phi</sub>");
  assert.match(await markup(row("equations", /^normal stress$/).locator("td").first()), /^σ = K<sub>s<\/sub> z\(θ\)<sup>N<\/sup>, N = n<sub>0<\/sub>/);
});

check("an equation leads to the errata that hold for it", async (page) => {
  await page.goto(url("#model"));
  await page.waitForSelector("#model-references");
  const link = page.locator('#model-equations a[href="#erratum-9"]').first();
  await link.click();
  assert.equal(await page.evaluate(() => document.activeElement?.id), "erratum-9");
  assert.match(await page.innerText("#erratum-9"), /N·m/);
});

await run();
