// Requests as commands of a shell.

import { beneath } from "./client.js";

/** @param {string} text */
export const quoted = (text) => `'${text.replaceAll("'", "'\\''")}'`;

/**
 * @param {string} path
 * @param {object} body
 */
export const curlCommand = (path, body) => [
  `curl -sS ${quoted(new URL(beneath(path), document.baseURI).href)}`,
  `  -H ${quoted("Content-Type: application/json")}`,
  `  -d ${quoted(JSON.stringify(body))}`,
].join(" \\\n");
