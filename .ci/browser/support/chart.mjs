// What a chart shows, read from its drawing alone: positions are turned into numbers by the labelled ticks of its axes.
import assert from "node:assert/strict";

/** Paths are written in hundredths of a pixel. */
const DRAWING_TOLERANCE_PX = 0.02;

export const SLIP_CHARTS = {
  "#longitudinal-force-chart": "longitudinal_force_n",
  "#normal-force-chart": "normal_force_n",
  "#torque-chart": "torque_n_m",
};

const STRESS_CURVES = {
  normal: "normal_stress_pa",
  shear: "shear_stress_pa",
  "normal-linear": "normal_stress_linear_pa",
  "shear-linear": "shear_stress_linear_pa",
};

export const inDegrees = (angle) => (angle * 180) / Math.PI;

const surface = (chart) => `${chart} .plot > svg`;

/** Runs in the browser: the axes as lines from pixels to numbers, and everything drawn, in pixels. */
function measured(svg) {
  const number = (text) => Number(text.replace("\u2212", "-").replaceAll("\u202f", ""));
  const axis = (anchor, side) => {
    const ticks = [...svg.querySelectorAll(`.tick-label[text-anchor="${anchor}"]`)]
      .map((label) => ({ px: Number(label.previousElementSibling.getAttribute(side)), value: number(label.textContent) }));
    const [first, last] = [ticks[0], ticks[ticks.length - 1]];
    return { px: first.px, value: first.value, perPx: (last.value - first.value) / (last.px - first.px) };
  };
  return {
    x: axis("middle", "x1"),
    y: axis("end", "y1"),
    curves: [...svg.querySelectorAll("path.curve")].map((path) => {
      const { width } = path.getBoundingClientRect();
      return { key: path.dataset.style, d: path.getAttribute("d"), stroke: getComputedStyle(path).stroke, width };
    }),
    marks: [...svg.querySelectorAll("line[data-mark]")].map((line) => ({ key: line.dataset.mark, px: Number(line.getAttribute("x1")) })),
  };
}

/** `curves` by key, each a list of points in the units of the axes, and `marks` by key; `pxOf` is where an x stands. */
export async function drawn(page, chart) {
  const { x, y, curves, marks } = await page.$eval(surface(chart), measured);
  const on = (axis, px) => axis.value + (px - axis.px) * axis.perPx;
  const points = (d) => [...d.matchAll(/[ML](-?[\d.]+) (-?[\d.]+)/g)].map(([, px, py]) => [on(x, Number(px)), on(y, Number(py))]);
  return {
    pxOf: (value) => x.px + (value - x.value) / x.perPx,
    tolerance: [x, y].map(({ perPx }) => Math.abs(perPx) * DRAWING_TOLERANCE_PX),
    curves: Object.fromEntries(curves.map((curve) => [curve.key, { ...curve, points: points(curve.d) }])),
    marks: Object.fromEntries(marks.map(({ key, px }) => [key, { px, at: on(x, px) }])),
  };
}

/** The curve stands in the chart, can be seen, and goes through these points, where null has none. */
function assertCurve(chart, key, xs, ys) {
  const curve = chart.curves[key];
  assert.ok(curve, `no curve ${key}, but ${Object.keys(chart.curves)}`);
  assert.notEqual(curve.stroke, "none", `curve ${key} has no colour`);
  assert.ok(curve.width > 100, `curve ${key} is ${curve.width} px wide`);
  assertPoints(chart, key, xs, ys);
}

/** The curve goes through these points, where null has none. */
export function assertPoints({ curves, tolerance }, key, xs, ys) {
  const curve = curves[key];
  assert.ok(curve, `no curve ${key}, but ${Object.keys(curves)}`);
  const expected = xs.map((x, index) => [x, ys[index]]).filter(([, value]) => value !== null);
  assert.equal(curve.points.length, expected.length, `points of curve ${key}`);
  curve.points.forEach((point, index) => {
    const isThere = point.every((value, axis) => Math.abs(value - expected[index][axis]) <= tolerance[axis]);
    assert.ok(isThere, `curve ${key} goes through ${point}, not ${expected[index]}`);
  });
}

/** The stresses are those of the service's columns. */
export async function assertProfile(page, columns) {
  const chart = await drawn(page, "#profile-chart");
  for (const [key, name] of Object.entries(STRESS_CURVES)) {
    assertCurve(chart, key, columns.theta_rad.map(inDegrees), columns[name].map((stress) => stress / 1000));
  }
}

/** The curves over slip of one method are those of the service's columns. */
export async function assertSweep(page, method, columns) {
  const slips = columns.slip.map((slip) => slip * 100);
  for (const [chart, name] of Object.entries(SLIP_CHARTS)) {
    assertCurve(await drawn(page, chart), method, slips, columns[name]);
  }
}

/** Paths of all curves of a chart. */
export const paths = (page, chart) => page.$$eval(`${surface(chart)} path.curve`, (curves) => curves.map((curve) => curve.getAttribute("d")));

/** Puts the mouse at a horizontal position of the drawing. */
export async function pointAt(page, chart, px) {
  await page.locator(`${chart} .plot`).scrollIntoViewIfNeeded();
  const { x, y, height } = await page.locator(surface(chart)).boundingBox();
  await page.mouse.move(x + px, y + height / 2);
}

/** What the legend says of a curve at the cursor. */
export const reading = (page, chart, key) => page.innerText(`${chart} .legend li[data-curve="${key}"] .reading`);
