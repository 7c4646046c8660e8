// Forces with types of the contract, from node or a page: node forces.mjs [SERVER]
//
// openapi-typescript http://127.0.0.1:8080/openapi.json --default-non-nullable=false --output terramechanics.d.ts
//
// Without the option, every field that has a default would have to be sent.

import assert from "node:assert/strict";
import process from "node:process";

/** @typedef {import("./terramechanics.d.ts").components["schemas"]} Schemas */

/** @typedef {import("./terramechanics.d.ts").paths["/v1/slip-sweep"]["get"]["parameters"]["query"]} SweepQuery */

const server = process.argv[2] ?? "http://127.0.0.1:8080";

/** @type {Schemas["ForcesRequest"]} */
const point = { wheel: { preset: "letter" }, soil: { preset: "letter-sand" }, slip: 0.2, sinkage_m: 0.02 };
const headers = { "Content-Type": "application/json" };
const response = await fetch(`${server}/v1/forces`, { method: "POST", headers, body: JSON.stringify(point) });
const forces = /** @type {Schemas["Forces"]} */ (await response.json());
console.log(forces.longitudinal_force_n, forces.normal_force_n, forces.torque_n_m);

// From here on the example is checked. An independent integration of the stresses over 401 000 points, rounded to the
// digits given.
assert(response.ok);
assert(Math.abs(forces.longitudinal_force_n - 16.906) < 5e-4);
assert(Math.abs(forces.normal_force_n - 89.716) < 5e-4);
assert(Math.abs(forces.torque_n_m - 7.3396) < 5e-5);

/**
 * The answer to a sweep, which has to be one.
 * @param {Response} answer
 */
async function sweep(answer) {
  assert(answer.ok);
  return /** @type {Schemas["SlipSweep"]} */ (await answer.json());
}

// A curve by a query has the numbers of the POST, and carries the load.
/** @type {SweepQuery} */
const query = {
  "wheel.preset": "letter", "soil.preset": "letter-sand", "soil.cohesion_pa": 200,
  "slip.from": 0, "slip.to": 1, "slip.points": 101, normal_load_n: 80,
};
/** @type {Schemas["SlipSweepRequest"]} */
const body = {
  wheel: { preset: "letter" }, soil: { preset: "letter-sand", cohesion_pa: 200 },
  slip: { from: 0, to: 1, points: 101 }, normal_load_n: 80,
};
const parameters = new URLSearchParams(Object.entries(query).map(([name, value]) => [name, String(value)]));
const curve = await sweep(await fetch(`${server}/v1/slip-sweep?${parameters}`));
const posted = await sweep(await fetch(`${server}/v1/slip-sweep`, { method: "POST", headers, body: JSON.stringify(body) }));
assert.equal(curve.columns.slip.length, 101);
assert.deepEqual(curve, posted);
assert(curve.columns.normal_force_n.every((force) => force !== null && Math.abs(force - 80) < 1e-6));

// The types refuse what the service would.
/** @type {Schemas["ForcesRequest"][]} */
export const refused = [
  // @ts-expect-error: a misspelt field
  { ...point, slp: 0.2 },
  // @ts-expect-error: no such method
  { ...point, method: "exact" },
  // @ts-expect-error: a field of another law
  { ...point, soil: { pressure_sinkage: { law: "bekker", k_c: 0, k_phi: 1e6, n0: 1, k_s: 1 } } },
];
