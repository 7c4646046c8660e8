// Named checks, each in a browser context of its own that must end without an error of any kind.
import assert from "node:assert/strict";
import { launch } from "./launch.mjs";
import { watch } from "./watch.mjs";

const PATIENCE_MS = 30_000;
const VIEWPORT = { width: 1280, height: 900 };

const checks = [];

/**
 * `body(page)` is the check. With `refused: true` the service is to refuse requests of the page with 422, and only then may
 * it; `context` holds options of the browser context.
 */
export function check(name, body, { refused = false, context = {} } = {}) {
  checks.push({ name, body, refused, context });
}

async function passes(browser, { name, body, refused, context: options }) {
  const context = await browser.newContext({ viewport: VIEWPORT, ...options });
  context.setDefaultTimeout(PATIENCE_MS);
  const { faults, refusals } = await watch(context);
  try {
    const page = await context.newPage();
    await body(page);
    // Whatever the browser has to report has come once it answers again.
    for (const open of context.pages()) await open.evaluate(() => {});
    assert.equal(faults.length, 0, "number of errors in the browser");
    assert.equal(refusals.length > 0, refused, `refused requests: ${refusals.join(", ") || "none"}`);
    console.log(`ok ${name}`);
    return true;
  } catch (error) {
    console.log([`FAILED ${name}`, error instanceof Error ? error.stack : error, ...faults].join("\n"));
    return false;
  } finally {
    await context.close();
  }
}

/** Runs the checks in turn; the process fails where one of them does. */
export async function run() {
  const browser = await launch();
  let failed = 0;
  try {
    for (const each of checks) {
      if (!(await passes(browser, each))) failed += 1;
    }
  } finally {
    await browser.close();
  }
  console.log(`${checks.length - failed} passed, ${failed} failed`);
  if (failed) process.exitCode = 1;
}
