// The plotting page as a person uses it.
import assert from "node:assert/strict";
import { ask } from "./api.mjs";
import { base } from "./launch.mjs";

export const url = (query = "") => `${base}/${query}`;

async function settled(page, state) {
  await page.waitForSelector('#app[data-busy="false"]:not([data-state="loading"])');
  assert.equal(await page.getAttribute("#app", "data-state"), state, await page.innerText("#status"));
}

/** Waits until the results match the inputs. */
export const ready = (page) => settled(page, "ready");

/** Waits until the page tells what is wrong with the inputs. */
export const faulty = (page) => settled(page, "fault");

export async function open(page, query) {
  await page.goto(url(query));
  await ready(page);
}

export const box = (page, name) => page.locator(`input[name="${name}"]`);

export const slider = (page, name) => page.locator(`input[data-slider="${name}"]`);

/** Opens the collapsed groups of controls. */
export const openGroups = (page) => page.$$eval("details.group", (groups) => groups.forEach((group) => { group.open = true; }));

/** The results on the page by their names in the API: as text, and the number it stands for or null. */
export async function results(page) {
  const read = await page.$$eval("[data-result]", (tiles) =>
    tiles.map(({ dataset, textContent }) => [dataset.result, { text: textContent, value: dataset.value }]));
  return Object.fromEntries(read.map(([name, { text, value }]) => [name, { text, value: value ? Number(value) : null }]));
}

export const FORCES = ["longitudinal_force_n", "normal_force_n", "torque_n_m"];

/** The numbers behind some of the results, by name. */
export async function valuesOf(page, names) {
  const shown = await results(page);
  return Object.fromEntries(names.map((name) => [name, shown[name].value]));
}

export const picked = (answer, names) => Object.fromEntries(names.map((name) => [name, answer[name] ?? null]));

const PER_UNIT = { N: 1, "N·m": 1, mm: 1e3, "%": 100, "kPa/mᴺ": 1e-3, "": 1 };

/** A number as the page sets it, with its unit: half a unit of its last digit is what rounding may cost. */
export function assertReads(text, value, what) {
  const [digits, unit = ""] = text.replaceAll("\u202f", "").replace("\u2212", "-").split("\u00a0");
  assert.match(digits, /^-?\d+(\.\d+)?$/, `${what} reads ${text}`);
  assert.ok(unit in PER_UNIT, `${what} reads ${text}`);
  const half = 0.5 * 10 ** -(digits.split(".")[1] ?? "").length;
  assert.ok(Math.abs(Number(digits) - value * PER_UNIT[unit]) <= half * (1 + 1e-9), `${what} reads ${text}, but is ${value}`);
}

/** The request in the curl command. */
export async function curlBody(page) {
  const command = await page.textContent("#curl");
  const [, quoted] = /-d '(.*)'$/s.exec(command) ?? assert.fail(`no body in: ${command}`);
  return JSON.parse(quoted.replaceAll("'\\''", "'"));
}

/** The numbers and texts are those the service gives for the request in the curl command; returns that request. */
export async function assertAnswered(page) {
  const body = await curlBody(page);
  const answer = await ask("/v1/forces", body);
  const shown = await results(page);
  const names = Object.keys(shown);
  assert.deepEqual(await valuesOf(page, names), picked({ ...answer, ...answer.components }, names));
  for (const [name, { text, value }] of Object.entries(shown)) {
    if (value !== null) assertReads(text, value, name);
  }
  return body;
}
