// What the service warns of stands at the part of the page that it is about.
import assert from "node:assert/strict";
import { LETTER, ask, overSlip } from "./support/api.mjs";
import { check, run } from "./support/checks.mjs";
import { curlBody, open, ready } from "./support/page.mjs";

const codesIn = (page, list) => page.$$eval(`${list} [data-warning]`, (items) => items.map(({ dataset }) => dataset.warning));

check("no warning is shown where there is none", async (page) => {
  await open(page, "?radius_mm=250");
  for (const list of ["#warnings", "#profile-warnings", "#sweep-warnings"]) assert.ok(await page.isHidden(list), `${list} is empty`);
});

check("a warning about braking slips alone stands at the curves alone", async (page) => {
  await open(page, "?by=static&braking=1&radius_mm=250");
  const { warnings } = await ask("/v1/slip-sweep", overSlip(await curlBody(page), -1));
  assert.deepEqual(await codesIn(page, "#sweep-warnings"), warnings.map(({ code }) => code));
  assert.ok(warnings.length > 0, "there is something to say");
  const { warnings: driving } = await ask("/v1/forces", await curlBody(page));
  assert.deepEqual(await codesIn(page, "#warnings"), driving.map(({ code }) => code));
  assert.ok(!driving.some(({ code }) => code.endsWith("_extrapolated")), "a driving wheel has none of a braking one");
  await page.fill('input[name="slip"]', "-20");
  await ready(page);
  const { warnings: atSlip } = await ask("/v1/forces", await curlBody(page));
  assert.ok(atSlip.length > 0, "there is something to say");
  assert.deepEqual(await codesIn(page, "#warnings"), atSlip.map(({ code }) => code));
  assert.deepEqual(await codesIn(page, "#profile-warnings"), []);
});

check("a warning stands once, with the names that it quotes as code", async (page) => {
  // So narrow a wheel that a negative k_c takes away half of k_phi, which leads to another law.
  await open(page, "?width_mm=1.5");
  const { warnings } = await ask("/v1/forces", await curlBody(page));
  // The most urgent one comes first on the page.
  assert.deepEqual((await codesIn(page, "#warnings")).toSorted(), warnings.map(({ code }) => code).toSorted());
  for (const list of ["#profile-warnings", "#sweep-warnings"]) assert.ok(await page.isHidden(list), `${list} says it again`);
  const quoted = warnings.flatMap(({ detail }) => [...detail.matchAll(/`([^`]*)`/g)].map(([, name]) => name));
  assert.deepEqual(await page.$$eval("#warnings code", (names) => names.map(({ textContent }) => textContent).toSorted()), quoted.toSorted());
  assert.ok(quoted.length > 0, "the warning quotes something");
  assert.ok(!(await page.innerText("#warnings")).includes("`"));
});

check("a value out of its range is told in the unit of the page, with what the service says of it", async (page) => {
  await open(page);
  const { warnings } = await ask("/v1/forces", LETTER);
  const { value, unit, range, advice } = warnings.find(({ code }) => code === "small_wheel");
  assert.equal(unit, "m");
  const told = (await page.innerText('#warnings [data-warning="small_wheel"]')).replaceAll("\u00a0", " ");
  assert.equal(told, `Diameter is ${value * 1000} mm, below ${range.lower * 1000} mm (${range.source}). ${advice.replaceAll("`", "")}`);
});

check("on a narrow screen the results lead to their warnings, and the most urgent one comes first", async (page) => {
  const told = { code: "outside_catalogue", detail: "A warning of the check.", finding: "a warning", advice: "Of the check." };
  await page.route("**/v1/forces", async (route) => {
    const response = await route.fetch();
    const answer = await response.json();
    await route.fulfill({ response, json: { ...answer, warnings: [...answer.warnings, told] } });
  });
  await open(page);
  const { warnings } = await ask("/v1/forces", LETTER);
  assert.deepEqual(await codesIn(page, "#warnings"), [told.code, ...warnings.map(({ code }) => code)]);
  assert.equal(await page.innerText("#warnings-link"), `${warnings.length + 1} warnings about these results`);
  await page.click("#warnings-link");
  const { top, bottom } = await page.$eval("#warnings", (list) => list.getBoundingClientRect());
  assert.ok(top >= 0 && bottom <= 844, `the warnings are at ${top} px`);
}, { context: { viewport: { width: 390, height: 844 } } });

check("slips without a solution are told as slips, with the methods", async (page) => {
  const load = 850;
  await open(page, `?by=load&load_n=${load}&compare=1&braking=1`);
  const { sinkage_m, ...rest } = LETTER;
  const { slip, series } = await ask("/v1/compare", overSlip({ ...rest, normal_load_n: load }, -1));
  const without = series.filter(({ columns }) => columns.sinkage_m.includes(null));
  assert.ok(without.length > 0, "there is something to say");
  const told = await page.$$eval("#sweep-warnings li", (items) => items.map(({ innerText }) => innerText.replaceAll("\u00a0", " ")));
  const unsolved = told.filter((text) => text.includes(": no solution"));
  assert.equal(unsolved.length, without.length);
  for (const [index, { method, columns }] of without.entries()) {
    assert.ok(unsolved[index].toLowerCase().includes(`(${method})`), unsolved[index]);
    assert.ok(!/\brows?\b/.test(unsolved[index]) && !unsolved[index].includes("/normal_load_n"), unsolved[index]);
    const first = (100 * slip[columns.sinkage_m.indexOf(null)]).toFixed(0).replace("-", "\u2212");
    assert.ok(unsolved[index].startsWith(`At slip ${first} %`), unsolved[index]);
    assert.ok(/a sinkage of [\d.]+ mm/.test(unsolved[index]), unsolved[index]);
  }
});

await run();
