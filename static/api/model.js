// What the service states of its model: asked for once, before the rest of the page.

import { modelStatement } from "./endpoints.js";

/** @import { Model } from "./types.js" */

/** @type {Model | null} */
let stated = null;

export async function loadModel() {
  stated ??= await modelStatement();
}

/** @returns {Model} */
export function model() {
  if (!stated) throw new Error("the model is not loaded yet");
  return stated;
}
