// Draws the operations of the contract, by tag; each is built when it is opened.

import { html } from "../dom/elements.js";
import { byId, find, findAll } from "../dom/find.js";
import { messageOf } from "../api/client.js";
import { sentenceHtml } from "../dom/text.js";
import { operationsOf, resolved, rowsWithin } from "./contract.js";
import { fieldTable, folded, paragraphs } from "./fields.js";
import { trial } from "./trial.js";

/** @import { Contract, Entry } from "./contract.js" */

const app = byId("explorer");
const status = byId("explorer-status");
const list = byId("operations");

/**
 * @param {Contract} contract
 * @param {Entry} entry
 */
function details(contract, entry) {
  const { method, path, operation } = entry;
  const bodies = Object.entries(operation.requestBody?.content ?? {});
  const json = bodies.find(([type]) => type === "application/json")?.[1].schema;
  const answer = operation.responses["200"]?.content?.["application/json"]?.schema;
  const rows = answer ? rowsWithin(contract, answer) : [];
  const failures = Object.entries(operation.responses).filter(([code]) => code !== "200");
  return [
    ...paragraphs(operation.description ?? ""),
    html("h3", {}, "Try it"),
    ...trial(contract, entry),
    ...(json ? [html("h3", {}, "Body"), fieldTable(`Body of ${method} ${path}`, rowsWithin(contract, json))] : []),
    ...(rows.length ? [html("h3", {}, "Answer"), fieldTable(`Fields of the answer of ${method} ${path}`, rows)] : []),
    ...(failures.length ? [html("h3", {}, "Failures")] : []),
    html("ul", { class: "failures" }, ...failures.map(([code, given]) =>
      html("li", {}, html("strong", {}, code), " ", ...sentenceHtml(resolved(contract, given).description ?? "")))),
  ];
}

/**
 * @param {Contract} contract
 * @param {Entry} entry
 */
function operationPart(contract, entry) {
  const { method, path, operation } = entry;
  const summary = [html("span", { class: "method" }, method), html("code", {}, path), html("span", {}, operation.summary ?? "")];
  const attributes = { id: operation.operationId, class: "operation", "data-method": method, "data-path": path };
  return folded(attributes, summary, () => [html("div", { class: "inside" }, ...details(contract, entry))]);
}

/** Opens the operation that the address names. */
function openNamed() {
  const named = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!(named instanceof HTMLDetailsElement)) return;
  named.open = true;
  named.scrollIntoView();
}

/** @param {Contract} contract */
function searchIn(contract) {
  /** The text of each operation, with the names of its fields. */
  const texts = new Map(contract.tags.flatMap(({ name }) => operationsOf(contract, name)).map((entry) => {
    const { operation, path } = entry;
    const parameters = (operation.parameters ?? []).map((each) => resolved(contract, each).name);
    const schemas = [...Object.values(operation.requestBody?.content ?? {}), ...Object.values(operation.responses["200"]?.content ?? {})];
    const fields = schemas.flatMap(({ schema }) => (schema ? rowsWithin(contract, schema).map(({ name }) => name) : []));
    return [operation.operationId, [path, operation.summary, operation.description, ...parameters, ...fields].join(" ").toLowerCase()];
  }));
  const wanted = find(document, "#wanted", HTMLInputElement);
  const search = () => {
    const words = wanted.value.toLowerCase().split(/\s+/).filter(Boolean);
    let count = 0;
    for (const part of findAll(list, ".operation")) {
      part.hidden = !words.every((word) => texts.get(part.id)?.includes(word));
      if (!part.hidden) count += 1;
    }
    for (const section of findAll(list, "section")) section.hidden = !section.querySelector(".operation:not([hidden])");
    status.textContent = words.length ? `${count} of ${texts.size} operations` : "";
  };
  wanted.addEventListener("input", search);
  byId("search").addEventListener("submit", (event) => event.preventDefault());
  byId("search").hidden = false;
}

try {
  const response = await fetch("openapi.json");
  if (!response.ok) throw new Error(`the service answered with status ${response.status}`);
  /** @type {Contract} */
  const contract = await response.json();
  byId("about").textContent = contract.info.description;
  list.append(...contract.tags.map(({ name, description }) => html("section", { "aria-labelledby": `tag-${name}` },
    html("h2", { id: `tag-${name}` }, description),
    ...operationsOf(contract, name).map((entry) => operationPart(contract, entry)))));
  status.textContent = "";
  searchIn(contract);
  addEventListener("hashchange", openNamed);
  openNamed();
  app.dataset.state = "ready";
} catch (error) {
  app.dataset.state = "failed";
  status.textContent = `The contract could not be read: ${messageOf(error)}.`;
}
