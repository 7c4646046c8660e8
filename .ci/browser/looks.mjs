// The page can be read on a telephone and in either colour scheme.
import assert from "node:assert/strict";
import { check, run } from "./support/checks.mjs";
import { box, faulty, open, openGroups, url } from "./support/page.mjs";

const NARROW = { viewport: { width: 390, height: 844 } };
/** The contrasts that WCAG 2 asks of text and of graphics. */
const TEXT_CONTRAST = 4.5;
const GRAPHICS_CONTRAST = 3;

/** Runs in the browser: the page's own width, and what sticks out of it without being scrolled or clipped inside it. */
function overflow() {
  const isClipped = (element) => {
    for (let above = element.parentElement; above && above !== document.body; above = above.parentElement) {
      if (getComputedStyle(above).overflowX !== "visible") return true;
    }
    return false;
  };
  const sticksOut = (element) => {
    const { left, right, width } = element.getBoundingClientRect();
    return width > 0 && (right > innerWidth + 0.5 || left < -0.5) && !isClipped(element);
  };
  const name = ({ tagName, id, className }) => `${tagName.toLowerCase()}${id && `#${id}`}.${className.baseVal ?? className}`;
  return {
    width: document.documentElement.scrollWidth,
    outside: [...document.body.querySelectorAll("*")].filter(sticksOut).map(name),
  };
}

const assertFits = async (page) => assert.deepEqual(await page.evaluate(overflow), { width: NARROW.viewport.width, outside: [] });

check("nothing scrolls sideways on a narrow screen", async (page) => {
  await open(page);
  await assertFits(page);
  await openGroups(page);
  await assertFits(page);
  await open(page, "?soil=soil-direct-90-smooth&method=explicit&compare=1&braking=1&by=load&load_n=150&rule=wong_reece&law=reece&shear=wong_residual&fourth=unknown"
    + "&kc_reece=1000&kphi_reece=1000&gamma_kn_m3=15&lug_mm=12&slip_pct=-20");
  await openGroups(page);
  await assertFits(page);
}, { context: NARROW });

check("the equations fit on a narrow screen", async (page) => {
  await page.goto(url("#model"));
  await page.waitForSelector("#model-references");
  await assertFits(page);
  const cut = await page.$$eval("#model *", (all) => all.filter(({ scrollWidth, clientWidth }) => clientWidth && scrollWidth > clientWidth + 1)
    .map(({ tagName, className }) => `${tagName}.${className}`));
  assert.deepEqual(cut, [], "parts that have to be scrolled sideways");
}, { context: NARROW });

check("a fault fits on a narrow screen and opens its group", async (page) => {
  await open(page);
  assert.ok(await box(page, "radius").isHidden(), "groups start closed");
  await page.goto(url("?radius_mm=-123456789.123456789&c_kpa=-1"));
  await faulty(page);
  assert.ok(await box(page, "radius").isVisible(), "the group of the fault is open");
  await assertFits(page);
}, { context: NARROW, refused: true });

/** Runs in the browser: contrasts to the background they stand on. */
function contrasts() {
  const canvas = Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d", { willReadFrequently: true });
  if (!canvas) throw new Error("there is no canvas to draw colours on");
  const luminance = (colour) => {
    canvas.clearRect(0, 0, 1, 1);
    canvas.fillStyle = colour;
    canvas.fillRect(0, 0, 1, 1);
    const [red, green, blue] = [...canvas.getImageData(0, 0, 1, 1).data].map((part) => part / 255)
      .map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  };
  const isClear = (colour) => colour === "transparent" || /, 0\)$|\/ 0\)$/.test(colour);
  const behind = (element) => {
    const colours = [];
    for (let each = element; each; each = each.parentElement) colours.push(getComputedStyle(each).backgroundColor);
    return luminance(colours.find((colour) => !isClear(colour)));
  };
  const of = (selector, property) => [...document.querySelectorAll(selector)].map((element) => {
    const [low, high] = [luminance(getComputedStyle(element)[property]), behind(element)].sort((a, b) => a - b);
    return { what: `${selector} ${element.dataset.style ?? element.id}`.trim(), contrast: (high + 0.05) / (low + 0.05) };
  });
  return {
    background: behind(document.body),
    texts: [...of("h1", "color"), ...of("[data-result]", "color"), ...of("label", "color"), ...of("#status", "color"), ...of("#model :is(a, th, td, li)", "color"), ...of("#gap-table :is(th, td, .share)", "color"),
       ...of("#curl", "color"),
      ...of(".tick-label", "fill"), ...of(".scene-label", "fill")],
    graphics: [...of(".plot path.curve", "stroke"), ...of("#scene line.ray", "stroke")],
  };
}

async function assertReadable(page) {
  const { background, texts, graphics } = await page.evaluate(contrasts);
  assert.ok(texts.length > 0 && graphics.length > 0, "there is something to read");
  assert.deepEqual(texts.filter(({ contrast }) => contrast < TEXT_CONTRAST), []);
  assert.deepEqual(graphics.filter(({ contrast }) => contrast < GRAPHICS_CONTRAST), []);
  return background;
}

check("the dark scheme is dark and readable", async (page) => {
  await open(page, "?compare=1#model");
  await page.waitForSelector("#model-references");
  const background = await assertReadable(page);
  assert.ok(background < 0.1, `luminance of the background ${background}`);
}, { context: { colorScheme: "dark" } });

check("the light scheme is light and readable", async (page) => {
  await open(page, "?compare=1#model");
  await page.waitForSelector("#model-references");
  const background = await assertReadable(page);
  assert.ok(background > 0.8, `luminance of the background ${background}`);
}, { context: { colorScheme: "light" } });

await run();
