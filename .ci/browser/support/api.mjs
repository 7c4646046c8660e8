// The service, asked without the page.
import assert from "node:assert/strict";
import { base } from "./launch.mjs";

/** The letter's example, as an independent client would put it. */
export const LETTER = { wheel: { preset: "letter" }, soil: { preset: "letter-sand" }, slip: 0.2, sinkage_m: 0.02 };

export const METHODS = ["quadrature", "linearised", "explicit"];

export async function ask(path, body, { status = 200 } = {}) {
  const response = await fetch(base + path, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) });
  const text = await response.text();
  assert.equal(response.status, status, `${path}: ${text}`);
  return JSON.parse(text);
}

/** The sweep that the page draws for a request for forces. */
export const overSlip = (forces, from = 0) => ({ ...forces, slip: { from, to: 1, points: 101 } });

/** What the service has to say about one field of a request it refuses. */
export async function faultOf(body, pointer) {
  const { errors } = await ask("/v1/forces", body, { status: 422 });
  const fault = errors.find((each) => each.pointer === pointer);
  assert.ok(fault, `the service finds no fault at ${pointer}: ${JSON.stringify(errors)}`);
  return fault.detail;
}
