// Requests as commands of a shell.

/** @param {string} text */
export const quoted = (text) => `'${text.replaceAll("'", "'\\''")}'`;

/**
 * @param {string} path
 * @param {object} body
 */
export const curlCommand = (path, body) => [
  `curl -sS ${quoted(location.origin + path)}`,
  `  -H ${quoted("Content-Type: application/json")}`,
  `  -d ${quoted(JSON.stringify(body))}`,
].join(" \\\n");
