// Typed requests with openapi-fetch, from node or a page: node fetch.mjs [SERVER]
//
// openapi-typescript http://127.0.0.1:8080/openapi.json --default-non-nullable=false --output terramechanics.d.ts

import assert from "node:assert/strict";
import process from "node:process";

import createClient from "openapi-fetch";

const server = process.argv[2] ?? "http://127.0.0.1:8080";

/** @typedef {import("./terramechanics.d.ts").paths} Paths */

/** Answers as JSON: without it, the type of `data` also has the table of `Accept: text/csv`.
 *  @typedef {"application/json" | "application/problem+json"} Media */

/** @type {ReturnType<typeof createClient<Paths, Media>>} */
const client = createClient({ baseUrl: server });
const { data, error } = await client.POST("/v1/forces", {
  body: { wheel: { preset: "letter" }, soil: { preset: "letter-sand" }, slip: 0.2, sinkage_m: 0.02 },
});
if (error) throw new Error(error.detail);
console.log(data.longitudinal_force_n, data.normal_force_n, data.torque_n_m);

// From here on the example is checked. An independent integration of the stresses over 401 000 points, rounded to the
// digits given.
assert(Math.abs(data.longitudinal_force_n - 16.906) < 5e-4);
assert(Math.abs(data.normal_force_n - 89.716) < 5e-4);
assert(Math.abs(data.torque_n_m - 7.3396) < 5e-5);

// The same by a query, whose parameters are components of the contract.
const asked = await client.GET("/v1/forces", {
  params: { query: { "wheel.preset": "letter", "soil.preset": "letter-sand", slip: 0.2, sinkage_m: 0.02 } },
});
assert.deepEqual(asked.data, data);

// A refusal names every fault.
const refused = await client.POST("/v1/forces", {
  body: { wheel: { preset: "letter" }, soil: { preset: "letter-sand" }, slip: 20, sinkage_m: -1 },
});
assert.equal(refused.data, undefined);
assert.equal(refused.response.status, 422);
assert.deepEqual(refused.error?.errors?.map((fault) => fault.pointer).sort(), ["/sinkage_m", "/slip"]);

// One entry of the catalogue, by the name in its path.
const wheel = await client.GET("/v1/wheels/{id}", { params: { path: { id: "letter" } } });
assert.equal(wheel.data?.id, "letter");

// The types refuse what the service would.
await client.POST("/v1/forces", {
  // @ts-expect-error: a misspelt field
  body: { wheel: { preset: "letter" }, soil: { preset: "letter-sand" }, slp: 0.2, sinkage_m: 0.02 },
});
