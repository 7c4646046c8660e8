// Telemetry: its columns are recognised, it is followed by the service on demand, and drawn over time.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { LETTER, ask } from "./support/api.mjs";
import { assertPoints, drawn } from "./support/chart.mjs";
import { check, run } from "./support/checks.mjs";
import { chosen, dropFile, faults, pointsIn, state } from "./support/measurements.mjs";
import { box, open, ready } from "./support/page.mjs";

const RADIUS_M = 0.2;
const RPM = 3;
const SAMPLE_S = 0.5;
/** Slips of a wheel that gets stuck for six seconds, at the same speed of rotation. */
const SLIPS = [...Array(10).fill(0.2), ...Array(13).fill(0.9), ...Array(7).fill(0.3)];
const STUCK = { from: 10 * SAMPLE_S, to: 22 * SAMPLE_S };
const LOST_ROW = 4;
const omega = (RPM * 2 * Math.PI) / 60;

/** Velocities in mm/s and rpm, a measured torque, and one sample without a velocity. */
function telemetry() {
  const rows = SLIPS.map((slip, row) => [row * SAMPLE_S, row === LOST_ROW ? "" : RADIUS_M * omega * (1 - slip) * 1000, RPM, 5 + row / 10]);
  return ["t,v mm/s,omega [rpm],T", ...rows.map((cells) => cells.join(","))].join("\n");
}

async function followed(page) {
  await page.click("#follow-track");
  await page.waitForSelector('#telemetry[data-state="followed"], #telemetry[data-state="failed"]');
  assert.equal(await page.getAttribute("#telemetry", "data-state"), "followed", await page.innerText("#track-status"));
}

const columnsOf = () => ({
  time_s: SLIPS.map((_, row) => row * SAMPLE_S),
  forward_velocity_m_s: SLIPS.map((slip, row) => (row === LOST_ROW ? null : RADIUS_M * omega * (1 - slip))),
  angular_velocity_rad_s: SLIPS.map(() => omega),
  torque_n_m: SLIPS.map((_, row) => 5 + row / 10),
});

check("a track with velocities is followed on demand, drawn over time, and gives its slip to the points", async (page) => {
  await open(page, "?by=load");
  const asked = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await dropFile(page, telemetry());
  assert.deepEqual(await chosen(page), ["time_s s", "forward_velocity_m_s mm/s", "angular_velocity_rad_s rpm", "torque_n_m N·m"]);
  assert.equal(await state(page), "ready", `${await faults(page)}`);
  assert.deepEqual(asked.filter((path) => path.startsWith("/v1/") && path !== "/v1/validation"), [], "nothing is asked of the service before the button");
  assert.ok((await page.innerText("#track-terms")).replaceAll("\u00a0", " ").includes("load of 90.0 N"), await page.innerText("#track-terms"));
  assert.equal(await pointsIn(page, "#torque-chart"), 0, "there is no slip yet");
  assert.ok(await page.isHidden("#identification"));

  await followed(page);
  const { sinkage_m, slip, ...rest } = LETTER;
  const { columns, events, warnings } = await ask("/v1/track", { ...rest, normal_load_n: 90, columns: columnsOf() });
  /** @type {Record<string, [string, number]>} */
  const bands = { "#track-slip-chart": ["slip", 100], "#track-sinkage-chart": ["sinkage_m", 1000], "#track-force-chart": ["longitudinal_force_n", 1], "#track-torque-chart": ["torque_n_m", 1] };
  for (const [chart, [name, factor]] of Object.entries(bands)) {
    assertPoints(await drawn(page, chart), "quadrature", columns.time_s, columns[name].map((value) => (value === null ? null : value * factor)));
    assert.equal(await page.locator(`${chart} .band[data-band="stall"]`).count(), 1, `the stall is marked in ${chart}`);
  }
  const torques = await drawn(page, "#track-torque-chart");
  assertPoints(torques, "recorded", columns.time_s, columnsOf().torque_n_m);
  assertPoints(await drawn(page, "#track-force-chart"), "coupled", columns.time_s, columns.longitudinal_force_coupled_n);

  assert.equal(events.length, 1);
  const shown = await page.$$eval("[data-event]", (rows) => rows.map(({ dataset }) => ({ code: dataset.event, from: Number(dataset.from), to: Number(dataset.to) })));
  assert.deepEqual(shown, [{ code: "stall", ...STUCK }]);
  const { x, width } = await page.$eval('#track-torque-chart .band', (band) => ({ x: Number(band.getAttribute("x")), width: Number(band.getAttribute("width")) }));
  assert.ok(Math.abs(x - torques.pxOf(STUCK.from)) < 0.5 && Math.abs(x + width - torques.pxOf(STUCK.to)) < 0.5, `the band is from ${x} for ${width} px`);

  const counts = await page.$$eval("[data-status]", (items) => Object.fromEntries(items.map(({ dataset }) => [dataset.status, Number(dataset.count)])));
  assert.deepEqual(counts, { ok: SLIPS.length - 1, missing_value: 1 });
  assert.deepEqual(await page.$$eval("#track-warnings [data-warning]", (items) => items.map(({ dataset }) => dataset.warning)), warnings.map(({ code }) => code));
  assert.match(await page.innerText("#track-warnings"), new RegExp(`At line ${LOST_ROW + 2} of the file: no result`));

  assert.equal(await pointsIn(page, "#torque-chart"), SLIPS.length - 1, "the points have the slip of the track");
  assert.ok(await page.isVisible("#identification"));
});

check("the file of a track holds what the service gives", async (page) => {
  await open(page);
  await dropFile(page, telemetry());
  await followed(page);
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#track-csv")]);
  assert.equal(download.suggestedFilename(), "track_letter_letter-sand.csv");
  const lines = (await readFile(await download.path(), "utf8")).trimEnd().split(/\r?\n/);
  const { slip, ...rest } = LETTER;
  const { columns } = await ask("/v1/track", { wheel: rest.wheel, soil: rest.soil, columns: { ...columnsOf(), sinkage_m: SLIPS.map(() => LETTER.sinkage_m) } });
  const names = lines[0].split(",");
  const place = names.indexOf("torque_n_m");
  const rows = lines.slice(1).filter((line) => !line.startsWith("#"));
  assert.equal(rows.length, SLIPS.length);
  rows.forEach((line, row) => {
    const cell = line.split(",")[place];
    const expected = columns.torque_n_m[row];
    assert.equal(cell === "", expected === null);
    if (expected !== null) assert.ok(Math.abs(Number(cell) - expected) <= 1e-9 * Math.abs(expected), `line ${row + 2}: ${cell}, not ${expected}`);
  });
  assert.equal(lines.at(-1), `#end,${SLIPS.length}`);
});

check("a track of former inputs is marked as such", async (page) => {
  await open(page, "?by=load");
  await dropFile(page, telemetry());
  await followed(page);
  assert.ok(await page.isHidden("#track-note"));
  await box(page, "normal_load").fill("70");
  await ready(page);
  assert.ok(await page.isVisible("#track-note"), "the track is that of another load");
  await followed(page);
  assert.ok(await page.isHidden("#track-note"));
});

check("a name of one letter is meant as it is written, and units need no brackets", async (page) => {
  await open(page);
  /** @type {[string, string[]][]} */
  const tables = [
    ["t,slip,T", ["time_s s", "slip –", "torque_n_m N·m"]],
    ["Slip %,Fx N,z mm,Torque N m", ["slip %", "longitudinal_force_n N", "sinkage_m mm", "torque_n_m N·m"]],
    ["Time / ms,v [cm/s],w rad/s,W", ["time_s ms", "forward_velocity_m_s cm/s", "angular_velocity_rad_s rad/s", "normal_force_n N"]],
    ["time_s,forward_velocity_m_s,angular_velocity_rad_s,torque_n_m,sinkage_m", ["time_s s", "forward_velocity_m_s m/s", "angular_velocity_rad_s rad/s", "torque_n_m N·m", "sinkage_m m"]],
    ["Zeit (min),Schlupf (%),Drehzahl,I,V", ["time_s min", "slip %", "angular_velocity_rad_s rpm", "", ""]],
  ];
  for (const [heading, expected] of tables) {
    const count = heading.split(",").length;
    await dropFile(page, `${heading}\n${Array(count).fill("0.1").join(",")}\n${Array(count).fill("0.2").join(",")}\n`);
    assert.deepEqual(await chosen(page), expected, heading);
  }
});

check("a cell of telemetry that is not a number counts as empty, and is told", async (page) => {
  await open(page);
  await dropFile(page, "time_s,slip,torque_n_m\n0,0.1,5\n1,#N/A,5\n#N/A,0.1,5\n3,0.1,ERR\n");
  assert.equal(await state(page), "ready", `${await faults(page)}`);
  const told = await page.innerText("#measurements-status");
  assert.ok(told.includes("3 cells are not numbers and count as empty, the first: Line 3, column 2"), told);
  await followed(page);
  await dropFile(page, "time_s,slip,torque_n_m\n0,ERR,5\n1,0.1,5\n");
  assert.deepEqual(await faults(page), ["Line 2, column 2 (slip): “ERR” is not a number."]);
});

check("what telemetry lacks is said", async (page) => {
  await open(page);
  await dropFile(page, "time_s,angular_velocity_rad_s,torque_n_m\n0,0.3,5\n1,0.3,6\n");
  assert.deepEqual(await faults(page), ["Choose the column that is the slip; for telemetry choose forward velocity."]);
  assert.ok(await page.isHidden("#telemetry"));
});

check("telemetry fits on a narrow screen", async (page) => {
  await open(page);
  await dropFile(page, telemetry());
  await followed(page);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
}, { context: { viewport: { width: 390, height: 844 } } });

check("slip, static sinkage and load lead to pull and torque", async (page) => {
  const slips = [0.1, 0.2, 0.3, 0.4];
  const loads = [100, 110, 120, 130];
  const own = { time_s: slips.map((_, row) => row), slip: slips };
  for (const { name, sent, columns } of [
    { name: "load of the page", sent: { normal_load_n: 120 }, columns: own },
    { name: "load of a column", sent: {}, columns: { ...own, normal_load_n: loads } },
  ]) {
    // The modulus of this soil was not published.
    await open(page, "?soil=wong-reece-loose-sand&method=linearised&load_known=1&load_n=120&static_mm=12");
    const isColumn = "normal_load_n" in columns;
    const rows = slips.map((slip, row) => [row, slip, ...(isColumn ? [loads[row]] : [])].join(","));
    await dropFile(page, [isColumn ? "t,s,W [N]" : "t,s", ...rows].join("\n"));
    await page.click("#track-use-load");
    await ready(page);
    assert.equal(await page.isChecked("#by-static"), true, name);
    assert.ok(await page.isHidden("#track-lead"), "what leads is taken");
    assert.match(await page.innerText("#track-terms"), /takes the place of the sinkage modulus/);
    await followed(page);
    const answer = await ask("/v1/track", {
      wheel: { preset: "letter" }, soil: { preset: "wong-reece-loose-sand" }, method: "linearised", static_sinkage_m: 0.012, ...sent, columns,
    });
    for (const [chart, quantity] of [["#track-force-chart", "longitudinal_force_n"], ["#track-torque-chart", "torque_n_m"]]) {
      assert.ok(answer.columns[quantity].every((value) => typeof value === "number"), quantity);
      assertPoints(await drawn(page, chart), "linearised", own.time_s, answer.columns[quantity]);
    }
  }
});

await run();
