// The API explorer shows the operations of this service without asking anyone else, sends what its reader edits, and can be used by all.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { check, run } from "./support/checks.mjs";
import { base } from "./support/launch.mjs";

const AXE = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
const RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"];

async function open(page, fragment = "") {
  const response = await page.goto(`${base}/docs${fragment}`);
  assert.equal(response.status(), 200);
  await page.waitForSelector('#explorer[data-state="ready"]');
}

/** What axe finds against the guidelines, as names of its rules. */
async function violations(page) {
  // The policy of the page refuses a script element; the debugger's own evaluation is no part of the page.
  await page.evaluate(await readFile(AXE, "utf8"));
  const { violations: found } = await page.evaluate((values) => globalThis.axe.run(document, { runOnly: { type: "tag", values } }), RULES);
  return found.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(" ")).slice(0, 3).join(", ")}`);
}

check("the explorer lists every operation of the document", async (page) => {
  const { paths } = await (await fetch(`${base}/openapi.json`)).json();
  const expected = Object.entries(paths).flatMap(([path, methods]) => Object.keys(methods).map((method) => `${method.toUpperCase()} ${path}`));
  await open(page);
  const listed = await page.locator(".operation").evaluateAll((all) => all.map(({ dataset }) => `${dataset.method} ${dataset.path}`));
  assert.deepEqual(listed.sort(), expected.sort());
});

check("a request is sent as its reader has edited it", async (page) => {
  await open(page, "#forces");
  const operation = page.locator("#forces");
  const body = operation.locator("textarea");
  await body.fill(JSON.stringify({ ...JSON.parse(await body.inputValue()), sinkage_m: 0.03 }));
  await operation.locator(".send").click();
  await operation.locator('.answer-status[data-status="200"]').waitFor();
  assert.equal(JSON.parse(await operation.locator("pre").textContent()).sinkage_m, 0.03);
  await operation.getByLabel("Type of the answer").selectOption("text/csv");
  await operation.locator(".send").click();
  await operation.locator("pre").filter({ hasText: /^slip,/ }).waitFor();
});

check("a query and a name in a path are sent, too", async (page) => {
  await open(page, "#forces_of_query");
  const asked = page.locator("#forces_of_query");
  await asked.getByLabel("sinkage_m", { exact: true }).fill("0.03");
  await asked.locator(".send").click();
  await asked.locator('.answer-status[data-status="200"]').waitFor();
  assert.equal(JSON.parse(await asked.locator("pre").textContent()).sinkage_m, 0.03);
  await page.locator("#wheel > summary").click();
  await page.locator("#wheel .send").click();
  await page.locator('#wheel .answer-status[data-status="200"]').waitFor();
});

check("a field has its unit and its bounds", async (page) => {
  const { components } = await (await fetch(`${base}/openapi.json`)).json();
  const { minimum, maximum } = components.schemas.Wheel.properties.radius_m;
  await open(page, "#forces");
  const row = page.locator('#forces [aria-label="Body of POST /v1/forces"] tr', { has: page.getByRole("rowheader", { name: "radius_m" }) });
  assert.deepEqual((await row.locator("td").allTextContents()).slice(0, 3), ["number", "m", `≥ ${minimum}, ≤ ${maximum}`]);
});

check("the search finds operations by a field", async (page) => {
  await open(page);
  await page.getByRole("searchbox").fill("gravity_m_s2 slope");
  await page.waitForSelector("#vehicle:visible");
  assert.equal(await page.locator("#healthz:visible").count(), 0);
});

check("what the service refuses is shown", async (page) => {
  await open(page, "#forces");
  const operation = page.locator("#forces");
  await operation.locator("textarea").fill("{}");
  await operation.locator(".send").click();
  await operation.locator('.answer-status[data-status="422"]').waitFor();
  assert.match(await operation.locator("pre").textContent(), /"pointer": "\/wheel"/);
}, { refused: true });

for (const colorScheme of ["light", "dark"]) {
  check(`the explorer keeps to the guidelines for accessibility, ${colorScheme}`, async (page) => {
    await open(page);
    for (const id of ["forces", "forces_of_query", "track"]) await page.locator(`#${id} > summary`).click();
    await page.locator("#forces_of_query .further > summary").click();
    await page.locator("#forces .send").click();
    await page.locator('#forces .answer-status[data-status="200"]').waitFor();
    assert.deepEqual(await violations(page), []);
  }, { context: { colorScheme } });
}

await run();
