// The page and the API explorer open without an error in the console, and ask only their own server.
import assert from "node:assert/strict";
import { base, launch } from "./support/launch.mjs";

const browser = await launch();
try {
  for (const path of ["/", "/docs"]) {
    const page = await browser.newPage();
    const faults = [];
    page.on("console", (message) => ["error", "warning"].includes(message.type()) && faults.push(message.text()));
    page.on("pageerror", (error) => faults.push(String(error)));
    page.on("requestfailed", (request) => faults.push(`${request.url()}: ${request.failure()?.errorText}`));
    page.on("request", (request) => {
      const { protocol, origin } = new URL(request.url());
      if (protocol !== "data:" && protocol !== "blob:" && origin !== base) faults.push(`asked for ${request.url()}`);
    });
    const response = await page.goto(base + path, { waitUntil: "networkidle" });
    assert.equal(response.status(), 200, path);
    assert.deepEqual(faults, [], path);
    await page.close();
  }
} finally {
  await browser.close();
}
