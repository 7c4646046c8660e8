// The API explorer shows the operations of this service without asking anyone else.
import assert from "node:assert/strict";
import { check, run } from "./support/checks.mjs";
import { base } from "./support/launch.mjs";

check("the explorer lists every operation of the document", async (page) => {
  const { paths } = await (await fetch(`${base}/openapi.json`)).json();
  const operations = Object.values(paths).flatMap((methods) => Object.keys(methods)).length;
  const response = await page.goto(`${base}/docs`);
  assert.equal(response.status(), 200);
  await page.waitForSelector(".swagger-ui .opblock");
  await page.waitForLoadState("networkidle");
  assert.equal(await page.locator(".swagger-ui .opblock").count(), operations);
});

check("the explorer sends a request and shows the answer", async (page) => {
  await page.goto(`${base}/docs`);
  const operation = page.locator(".opblock.opblock-post", { has: page.locator('[data-path="/v1/forces"]') });
  await operation.locator(".opblock-summary").click();
  await operation.locator(".execute").click();
  await operation.locator(".live-responses-table .response-col_status").filter({ hasText: "200" }).waitFor();
});

await run();
