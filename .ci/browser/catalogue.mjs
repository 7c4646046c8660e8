// The lists of wheels and soils hold the whole catalogue, by kind, and say what an entry lacks before it is chosen.
import assert from "node:assert/strict";
import { check, run } from "./support/checks.mjs";
import { assertAnswered, box, faulty, open, openGroups, ready, url } from "./support/page.mjs";

const catalogue = async (name) => (await (await fetch(url(`v1/${name}`))).json())[name];

const optionsOf = (page, select) => page.$$eval(`${select} option`, (options) =>
  options.map(({ value, textContent, parentElement: { tagName, label } }) => ({ value, text: textContent, group: tagName === "OPTGROUP" ? label : null })));

check("every entry is offered in the group of its kind", async (page) => {
  await open(page);
  for (const [select, name] of [["#wheel", "wheels"], ["#soil", "soils"]]) {
    const entries = await catalogue(name);
    const options = await optionsOf(page, select);
    assert.deepEqual(options.map(({ value }) => value).sort(), entries.map(({ id }) => id).sort());
    const kindOf = Object.fromEntries(entries.map(({ id, kind }) => [id, kind]));
    const pairs = new Set(options.map(({ value, group }) => `${kindOf[value]} in ${group}`));
    assert.equal(pairs.size, new Set(Object.values(kindOf)).size, `one group for each kind: ${[...pairs]}`);
    for (const { id, name: title, missing } of entries) {
      const { text } = options.find(({ value }) => value === id);
      assert.ok(text.startsWith(title), text);
      assert.equal(/\(lacks .+\)$/.test(text), missing.length > 0, text);
    }
  }
});

check("entries without a kind stand on their own", async (page) => {
  await page.route("**/v1/wheels", async (route) => {
    const response = await route.fetch();
    const { wheels, ...rest } = await response.json();
    const { kind, ...bare } = wheels[1];
    await route.fulfill({ response, json: { ...rest, wheels: [wheels[0], bare, ...wheels.slice(2)] } });
  });
  await open(page);
  const options = await optionsOf(page, "#wheel");
  assert.deepEqual(options.filter(({ group }) => group === null).length, 1);
  assert.ok(options.every(({ group }) => group !== "undefined" && group !== "Undefined"), JSON.stringify(options));
});

check("the load that was published for a wheel is offered where loads are given", async (page) => {
  const wheel = (await catalogue("wheels")).find(({ id }) => id === "zhurong");
  const nominal = wheel.values.nominal_load_n.value;
  await open(page, "?wheel=zhurong");
  assert.ok((await page.innerText("#nominal-load")).includes(`${nominal}\u00a0N`), await page.innerText("#nominal-load"));
  await page.click("#nominal-load button");
  await ready(page);
  assert.equal((await assertAnswered(page)).normal_load_n, nominal);
  assert.ok(await page.isHidden("#nominal-load"), "it is set already");
  await box(page, "normal_load").fill("100");
  await ready(page);
  await page.click("#nominal-load button");
  await ready(page);
  assert.equal(await box(page, "normal_load").inputValue(), String(nominal));
  await open(page, "?wheel=letter&by=load");
  assert.ok(await page.isHidden("#nominal-load"), "nothing is published for the letter's wheel");
});

check("a soil without its moduli asks for each at its field", async (page) => {
  // As if the catalogue had the law of this soil, but not its moduli.
  await page.route("**/v1/soils", async (route) => {
    const response = await route.fetch();
    const { soils, ...rest } = await response.json();
    const known = soils.find(({ id }) => id === "wong-dry-sand");
    known.soil.pressure_sinkage = { law: "bekker", n0: known.soil.pressure_sinkage.n0 };
    known.missing = ["pressure_sinkage"];
    await route.fulfill({ response, json: { ...rest, soils } });
  });
  await page.goto(url("?soil=wong-dry-sand"));
  await faulty(page);
  for (const [name, pointer] of [["bekker_k_c", "/soil/pressure_sinkage/k_c"], ["bekker_k_phi", "/soil/pressure_sinkage/k_phi"]]) {
    const fault = box(page, name).locator("xpath=ancestor::div[@data-field]").locator(`[data-fault="${pointer}"]`);
    assert.ok(await fault.isVisible(), `the fault at ${pointer} is visible`);
  }
  assert.match(await page.innerText("#soil-grade"), /Not in the catalogue: pressure–sinkage moduli/);
  await openGroups(page);
  await box(page, "bekker_k_c").fill("1");
  await box(page, "bekker_k_phi").fill("1500");
  await ready(page);
  const { soil } = await assertAnswered(page);
  assert.deepEqual([soil.pressure_sinkage.k_c, soil.pressure_sinkage.k_phi], [1000, 1500000]);
}, { refused: true });

await run();
