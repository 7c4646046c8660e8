// A request to be edited and sent, and its answer.

import { html } from "../dom/elements.js";
import { beneath, messageOf } from "../api/client.js";
import { quoted } from "../api/curl.js";
import { resolved, rowsOfField } from "./contract.js";
import { fieldTable, folded, scrolled } from "./fields.js";

/** @import { Contract, Entry, Parameter } from "./contract.js" */

/** Characters of an answer that are shown. */
const MOST_SHOWN = 200_000;

/**
 * @param {Contract} contract
 * @param {Entry} entry
 * @param {Parameter} parameter
 */
function parameterInput(contract, { operation }, parameter) {
  const id = `${operation.operationId}-${parameter.name}`;
  const words = resolved(contract, parameter.schema).enum?.map(String);
  const example = parameter.example === undefined ? "" : String(parameter.example);
  const input = words
    ? html("select", { id }, html("option", { value: "" }, "–"), ...words.map((word) => html("option", { value: word, selected: word === example }, word)))
    : html("input", { id, type: "text", value: example, autocomplete: "off", spellcheck: "false" });
  const label = html("label", { for: id }, html("code", {}, parameter.name));
  return { parameter, input, node: html("div", { class: "parameter" }, label, input) };
}

/**
 * @param {string} label
 * @param {string} id
 * @param {string[]} types
 */
function mediaChoice(label, id, types) {
  const select = html("select", { id }, ...types.map((type) => html("option", { value: type }, type)));
  return { select, node: html("div", { class: "parameter" }, html("label", { for: id }, label), select) };
}

/** @param {unknown} example */
const bodyText = (example) => (example === undefined ? "" : typeof example === "string" ? example : JSON.stringify(example, null, 2));

/**
 * The text of an answer as people read it.
 * @param {string} type
 * @param {string} text
 */
function shownText(type, text) {
  let shown = text;
  if (/^application\/(problem\+)?json/.test(type)) {
    try {
      shown = JSON.stringify(JSON.parse(text), null, 2);
    } catch {
      // It is shown as it came.
    }
  }
  return shown.length > MOST_SHOWN ? `${shown.slice(0, MOST_SHOWN)}\n… ${shown.length - MOST_SHOWN} more characters` : shown;
}

/**
 * @param {string} url
 * @param {RequestInit & { headers: Record<string, string> }} request
 */
function curlCommand(url, { method, headers, body }) {
  const named = Object.entries(headers).map(([name, value]) => `  -H ${quoted(`${name}: ${value}`)}`);
  const data = typeof body === "string" ? [`  --data-binary ${quoted(body)}`] : [];
  return [`curl -sS -X ${method} ${quoted(new URL(url, document.baseURI).href)}`, ...named, ...data].join(" \\\n");
}

/**
 * @param {Contract} contract
 * @param {Entry} entry
 */
export function trial(contract, entry) {
  const { method, path, operation } = entry;
  const id = operation.operationId;
  const parameters = (operation.parameters ?? []).map((parameter) => resolved(contract, parameter));
  const inputs = parameters.map((parameter) => parameterInput(contract, entry, parameter));
  const [given, further] = [inputs.filter(({ input }) => input.value), inputs.filter(({ input }) => !input.value)];

  const bodies = operation.requestBody?.content ?? {};
  const sent = mediaChoice("Type of the body", `${id}-type`, Object.keys(bodies));
  const body = html("textarea", { id: `${id}-body`, rows: 12, spellcheck: "false", autocomplete: "off" });
  const fill = () => { body.value = bodyText(bodies[sent.select.value]?.example); };
  fill();
  sent.select.addEventListener("change", fill);

  const answers = Object.keys(operation.responses["200"]?.content ?? {});
  const wanted = mediaChoice("Type of the answer", `${id}-accept`, answers);

  const request = () => {
    /** @param {"path" | "query"} place */
    const filled = (place) => inputs.filter(({ parameter, input }) => parameter.in === place && input.value);
    const query = new URLSearchParams(filled("query").map(({ parameter, input }) => [parameter.name, input.value])).toString();
    const named = filled("path").reduce((all, { parameter, input }) => all.replace(`{${parameter.name}}`, encodeURIComponent(input.value)), path);
    /** @type {Record<string, string>} */
    const headers = answers.length ? { Accept: wanted.select.value } : {};
    if (operation.requestBody) headers["Content-Type"] = sent.select.value;
    return { url: beneath(query ? `${named}?${query}` : named), init: { method, headers, ...(operation.requestBody ? { body: body.value } : {}) } };
  };

  const status = html("p", { role: "status", class: "answer-status" });
  const answer = html("pre", {});
  const shown = scrolled(`Answer of ${method} ${path}`, answer);
  shown.hidden = true;
  const show = (/** @type {string} */ line, /** @type {string} */ text) => {
    status.textContent = line;
    answer.textContent = text;
    shown.hidden = !text;
  };

  const send = html("button", { type: "submit", class: "send" }, "Send");
  const curl = html("button", { type: "button" }, "As a command");
  curl.addEventListener("click", () => {
    const { url, init } = request();
    show("The same for a shell:", curlCommand(url, init));
  });
  const form = html("form", { class: "trial" },
    ...given.map(({ node }) => node),
    ...(further.length ? [folded({ class: "further" }, [`${given.length ? "Further parameters" : "Parameters"} (${further.length})`], () => further.map(({ node }) => node))] : []),
    ...(operation.requestBody ? [sent.node, html("label", { for: body.id }, "Body"), body] : []),
    ...(answers.length > 1 ? [wanted.node] : []),
    html("p", { class: "actions" }, send, curl));
  form.addEventListener("submit", async (event) => {
    event.preventDefault();
    const { url, init } = request();
    send.disabled = true;
    show("Sent …", "");
    const start = performance.now();
    try {
      const response = await fetch(url, init);
      const text = await response.text();
      const type = response.headers.get("Content-Type") ?? "";
      show(`${response.status}, ${text.length} characters of ${type || "no type"} after ${Math.round(performance.now() - start)} ms`, shownText(type, text));
      status.dataset.status = String(response.status);
    } catch (error) {
      show(`No answer: ${messageOf(error)}`, "");
    } finally {
      send.disabled = false;
    }
  });
  const meanings = parameters.flatMap(({ name, schema, description, required }) =>
    rowsOfField(contract, name, { description, ...resolved(contract, schema) }, { depth: 0, required: required ?? false }).slice(0, 1));
  return [form, status, shown, ...(meanings.length ? [html("h3", {}, "Parameters"), fieldTable(`Parameters of ${method} ${path}`, meanings)] : [])];
}
