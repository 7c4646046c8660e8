// A person's measurements: read in the browser, drawn over the curves, fitted to by the service only when asked.
import assert from "node:assert/strict";
import { LETTER, ask } from "./support/api.mjs";
import { paths } from "./support/chart.mjs";
import { check, run } from "./support/checks.mjs";
import { chosen, dropFile, faults, pointsIn, state } from "./support/measurements.mjs";
import { curlBody, open, ready } from "./support/page.mjs";

const FRICTION_RAD = 0.55;
/** The points are sent in five digits, from which no more than this can be told. */
const FRICTION_TOLERANCE_RAD = 1e-3;
const SLIPS = [0.05, 0.1, 0.2, 0.4, 0.6, 0.8];

const german = (value) => value.toPrecision(7).replace(".", ",");

/** Points of a soil that is not the page's, as a German spreadsheet writes them. */
async function germanTable() {
  const lines = ["Schlupf;Einsinkung;Fx;Fz;Drehmoment;Bemerkung", "%;mm;N;N;N m;–"];
  for (const sinkage_m of [0.01, 0.02, 0.03]) {
    const { columns } = await ask("/v1/slip-sweep", { ...LETTER, soil: { preset: "letter-sand", friction_angle_rad: FRICTION_RAD }, sinkage_m, slip: SLIPS });
    SLIPS.forEach((slip, row) => {
      const cells = [slip * 100, sinkage_m * 1000, columns.longitudinal_force_n[row], columns.normal_force_n[row], columns.torque_n_m[row]];
      lines.push([...cells.map(german), "gut"].join(";"));
    });
  }
  return `\uFEFF${lines.join("\r\n")}\r\n`;
}

check("a dropped table is fitted on demand, and its soil becomes the page's", async (page) => {
  const table = await germanTable();
  await open(page);
  await page.locator("#measurements").scrollIntoViewIfNeeded();
  await page.waitForSelector('#validation[data-state="ready"], #validation[data-state="waiting"]');
  const asked = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));

  await dropFile(page, table);
  assert.equal(await state(page), "ready", `${await faults(page)}`);
  assert.deepEqual(await chosen(page), ["slip %", "sinkage_m mm", "longitudinal_force_n N", "normal_force_n N", "torque_n_m N·m", ""]);
  for (const chart of ["#longitudinal-force-chart", "#normal-force-chart", "#torque-chart"]) {
    assert.equal(await pointsIn(page, chart), 3 * SLIPS.length, chart);
    assert.ok((await page.innerText(`${chart} [data-curve="measured"]`)).includes("rms"), chart);
  }
  assert.ok(Number(await page.getAttribute('[data-rms="torque_n_m"]', "data-value")) > 0);
  assert.deepEqual(asked.filter((path) => path.startsWith("/v1/") && path !== "/v1/validation"), [], "nothing is asked of the service before the button");

  const before = await paths(page, "#longitudinal-force-chart");
  await page.click("#fit-soil");
  await page.waitForSelector('#identification[data-state="fitted"]');
  assert.deepEqual(asked.filter((path) => path.startsWith("/v1/") && path !== "/v1/validation"), ["/v1/identify"]);
  const found = Number(await page.getAttribute('[data-estimate="friction_angle_rad"]', "data-value"));
  assert.ok(Math.abs(found - FRICTION_RAD) < FRICTION_TOLERANCE_RAD, `finds ${found} rad`);
  assert.ok((await page.innerText("#fit-result")).includes("31.5"), "the angle is told in degrees");

  const held = await page.$$eval("[data-held]", (items) => Object.fromEntries(items.map(({ dataset }) => [dataset.held, Number(dataset.value)])));
  assert.deepEqual(held, { cohesion: 0, n1: 0, c3: 0 }, "what the search held is listed");
  for (const chart of ["#residual-longitudinal-force-n-chart", "#residual-normal-force-n-chart", "#residual-torque-n-m-chart"]) {
    assert.equal(await pointsIn(page, chart), 3 * SLIPS.length, chart);
  }
  await page.click("#residual-rows summary");
  await page.waitForSelector("#residual-rows table");
  const torques = await page.$$eval('[data-residual="torque_n_m"]', (cells) => cells.map((cell) => [cell.previousElementSibling, cell].map(({ dataset }) => Number(dataset.value))));
  assert.equal(torques.length, 3 * SLIPS.length);
  for (const [predicted, residual] of torques) assert.ok(Math.abs(residual) < 1e-3 * predicted, `${residual} N·m of ${predicted} N·m is left by the soil that made the points`);

  await page.click("#use-soil");
  await ready(page);
  assert.notDeepEqual(await paths(page, "#longitudinal-force-chart"), before, "the curves are those of the soil that was found");
  const { soil } = await curlBody(page);
  assert.ok(Math.abs(soil.friction_angle_rad - FRICTION_RAD) < FRICTION_TOLERANCE_RAD, JSON.stringify(soil));
  assert.equal(soil.pressure_sinkage.law, "direct");
  assert.equal(soil.cohesion_pa, undefined, "what was not fitted stays the preset's");
  await page.goBack();
  await ready(page);
  assert.deepEqual((await curlBody(page)).soil, { preset: "letter-sand" });
});

check("a column can be changed, and the page says what is missing", async (page) => {
  await open(page);
  await dropFile(page, "s,a,b\n0.1,20,3\n0.2,21,4\n");
  assert.deepEqual(await chosen(page), ["slip –", "", ""]);
  assert.ok((await faults(page)).some((text) => text.includes("beside the slip")), `${await faults(page)}`);
  await page.selectOption('[data-column="1"]', "sinkage_m mm");
  await page.selectOption('[data-column="2"]', "longitudinal_force_n N");
  assert.equal(await state(page), "ready", `${await faults(page)}`);
  assert.equal(await pointsIn(page, "#longitudinal-force-chart"), 2);
  await page.selectOption('[data-column="1"]', "longitudinal_force_n kN");
  assert.equal(await state(page), "refused");
  assert.equal(await pointsIn(page, "#longitudinal-force-chart"), 0);
  await page.click("#measurements-clear");
  assert.equal(await state(page), "empty");
});

check("a malformed table tells line and column", async (page) => {
  await open(page);
  await dropFile(page, "slip,Fx [N],Fz [N]\n0.1,3,90\n0.2,four,90\n");
  assert.equal(await state(page), "refused");
  assert.deepEqual(await faults(page), ["Line 3, column 2 (Fx [N]): “four” is not a number."]);
  await dropFile(page, "slip;Fx\n0,1;3\n0,2;3;4\n");
  assert.ok((await faults(page))[0].startsWith("Line 3: 3 cells"), `${await faults(page)}`);
  await dropFile(page, `slip,Fx\n${"0.1,3\n".repeat(10_002)}`);
  assert.deepEqual(await faults(page), ["Line 10003: the service takes 10001 rows at most."]);
  await dropFile(page, "slip,Fx\n0.1,3\n\"0,2\",4.5\n");
  assert.ok((await faults(page))[0].startsWith("Line 3, column 1 (slip): “0,2” has a decimal comma"), `${await faults(page)}`);
  await dropFile(page, "");
  assert.deepEqual(await faults(page), ["The table is empty."]);
});

check("what the service refuses is told at the line of the file", async (page) => {
  await open(page);
  await dropFile(page, "# rig 2\nslip,z (mm),Fx [N],T\n0.1,20,3,1\n0.2,900,4,2\n0.3,20,5,3\n");
  await page.click("#fit-soil");
  await page.waitForSelector('#identification[data-state="failed"]');
  assert.match(await page.innerText("#fit-status"), /^Line 4 of the file, sinkage:/);
}, { refused: true });

check("own values of Bekker's law give way to the direct law as a preset's do, and this is said", async (page) => {
  await open(page, "?kc=0.99&kphi=1528.43&n0=1.1&radius_mm=125");
  const { columns } = await ask("/v1/slip-sweep", { ...LETTER, wheel: { preset: "letter", radius_m: 0.125 }, slip: SLIPS });
  await dropFile(page, ["slip,z mm,Fx N,Fz N,T", ...SLIPS.map((slip, row) =>
    [slip, 20, columns.longitudinal_force_n[row], columns.normal_force_n[row], columns.torque_n_m[row]].join(","))].join("\n"));
  assert.deepEqual(await chosen(page), ["slip –", "sinkage_m mm", "longitudinal_force_n N", "normal_force_n N", "torque_n_m N·m"]);
  await page.click("#fit-soil");
  await page.waitForSelector('#identification[data-state="fitted"], #identification[data-state="failed"]');
  assert.equal(await page.getAttribute("#identification", "data-state"), "fitted", await page.innerText("#fit-status"));
  assert.equal(await page.locator('#fit-warnings [data-warning="law_replaced"]').count(), 1, await page.innerText("#fit-warnings"));
  assert.ok(!(await page.innerText("#identification")).includes("`"));
  await page.check('[data-fit="k_c"]');
  await page.click("#fit-soil");
  assert.match(await page.innerText("#fit-status"), /^Untick the sinkage modulus K_s, or the cohesive modulus/);
});

check("what a fit leaves open is told in the names and units of the page", async (page) => {
  await open(page);
  const { columns } = await ask("/v1/slip-sweep", { ...LETTER, slip: SLIPS });
  const thousandfold = SLIPS.map((slip, row) => [slip, 20, ...["longitudinal_force_n", "normal_force_n", "torque_n_m"].map((name) => 3000 * columns[name][row])]);
  await dropFile(page, ["slip,z mm,Fx N,Fz N,T", ...thousandfold.map((cells) => cells.join(","))].join("\n"));
  for (const name of ["friction_angle_rad", "n0"]) await page.uncheck(`[data-fit="${name}"]`);
  await page.check('[data-fit="cohesion_pa"]');
  const [response] = await Promise.all([page.waitForResponse("**/v1/identify"), page.click("#fit-soil")]);
  const { warnings, estimates } = await response.json();
  await page.waitForSelector('#identification[data-state="fitted"]');
  const told = (code) => page.$$eval(`#fit-warnings [data-warning="${code}"]`, (items) => items.map(({ textContent }) => (textContent ?? "").replaceAll("\u00a0", " ").replaceAll("\u202f", "")));
  const bound = warnings.find(({ code, quantity }) => code === "at_bound" && quantity === "cohesion_pa");
  assert.deepEqual([bound.value, bound.end], [0, "lower"]);
  assert.equal((await told("at_bound"))[0], `Cohesion lies at its lower bound 0 kPa, which decides its value. ${bound.advice}`);
  const { value, range } = warnings.find(({ code, quantity }) => code === "implausible_estimate" && quantity === "k_s");
  const [implausible] = await told("implausible_estimate");
  assert.ok(value > range.upper && implausible.startsWith("Sinkage modulus is "), implausible);
  assert.ok(implausible.includes(` to ${range.upper / 1000} kPa/mᴺ in size.`), implausible);
  const shown = await page.innerText("#identification");
  for (const { parameter } of estimates) assert.ok(!shown.includes(parameter), `${parameter} is a name of the API`);
});

check("a search can be cancelled", async (page) => {
  await open(page);
  await page.route("**/v1/identify", () => {});
  await dropFile(page, await germanTable());
  await page.click("#fit-soil");
  assert.ok(await page.isVisible("#fit-progress"), "progress is shown");
  await page.click("#cancel-fit");
  assert.equal(await page.getAttribute("#identification", "data-state"), "idle");
  assert.ok(await page.isHidden("#fit-progress"));
  assert.ok(await page.isEnabled("#fit-soil"));
});

check("the section fits on a narrow screen", async (page) => {
  await open(page);
  await dropFile(page, await germanTable());
  await page.click("#fit-soil");
  await page.waitForSelector('#identification[data-state="fitted"]');
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  const { scrollWidth, clientWidth } = await page.$eval("#fit-result", ({ scrollWidth, clientWidth }) => ({ scrollWidth, clientWidth }));
  assert.ok(scrollWidth <= clientWidth, `the estimates are ${scrollWidth} px wide in ${clientWidth} px`);
  assert.ok((await page.innerText("#fit-result")).includes("Do the data determine it?") === false, "the headings give way to those of the cells");
}, { context: { viewport: { width: 390, height: 844 } } });

await run();
