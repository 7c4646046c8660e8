// Requests to the service, and the two ways they fail: a problem (the service says what is wrong) or no usable answer.

const PATIENCE_MS = 20_000;
const SEARCH_PATIENCE_MS = 60_000;
const PASSING_STATUSES = [408, 429, 500, 502, 503, 504];

export class Problem extends Error {
  constructor({ title, detail, errors }, status) {
    super(detail ?? title ?? `The service answered with status ${status}.`);
    this.status = status;
    this.errors = Array.isArray(errors) ? errors : [];
  }
}

/** Worth another try: the network is down, the service is starting, or it is busy. */
export class Unavailable extends Error {
  constructor(message, retryAfterSeconds = null) {
    super(message);
    this.retryAfterSeconds = retryAfterSeconds;
  }
}

async function answer(path, request, read, signal, patienceMs = PATIENCE_MS) {
  const patience = new AbortController();
  const giveUp = () => patience.abort();
  const timer = setTimeout(giveUp, patienceMs);
  signal?.addEventListener("abort", giveUp);
  try {
    const response = await fetch(path, { ...request, signal: patience.signal });
    if (PASSING_STATUSES.includes(response.status)) {
      throw new Unavailable(`The service answered with status ${response.status}.`, Number(response.headers.get("Retry-After")) || null);
    }
    if (!response.ok) throw new Problem(await response.json().catch(() => ({})), response.status);
    return await read(response);
  } catch (error) {
    if (signal?.aborted || error instanceof Problem || error instanceof Unavailable) throw error;
    throw new Unavailable(patience.signal.aborted ? "The service takes too long to answer." : "The service gives no answer.");
  } finally {
    clearTimeout(timer);
    signal?.removeEventListener("abort", giveUp);
  }
}

const posted = (body, accept) => ({
  method: "POST",
  headers: { "Content-Type": "application/json", Accept: accept },
  body: JSON.stringify(body),
});

const asJson = (response) => response.json();
const asText = (response) => response.text();

export const post = (path, body, signal) => answer(path, posted(body, "application/json"), asJson, signal);

/** A search may use up what the service allows a computation, so it is waited for longer. */
export const identify = (body, signal) => answer("/v1/identify", posted(body, "application/json"), asJson, signal, SEARCH_PATIENCE_MS);

export const postForCsv = (path, body) => answer(path, posted(body, "text/csv"), asText);

/** Nested fields as a query has them: dotted. */
const dotted = (value, name = "") => (value !== null && typeof value === "object"
  ? Object.entries(value).flatMap(([key, each]) => dotted(each, name ? `${name}.${key}` : key)) : [[name, String(value)]]);

/** A table has no limit to its size where a body of JSON has one, so the columns go as a table. */
function tableOf(columns) {
  const names = Object.keys(columns);
  const rows = columns[names[0]].map((_, row) => names.map((name) => columns[name][row] ?? "").join(","));
  return [names.join(","), ...rows, ""].join("\n");
}

const trackAnswer = (read, accept) => ({ settings, columns }, signal) => answer(`/v1/track?${new URLSearchParams(dotted(settings))}`, {
  method: "POST", headers: { "Content-Type": "text/csv", Accept: accept }, body: tableOf(columns),
}, read, signal, SEARCH_PATIENCE_MS);

export const follow = trackAnswer(asJson, "application/json");
export const followForCsv = trackAnswer(asText, "text/csv");

export const modelStatement = () => answer("/v1/model", {}, asJson);

export async function catalogueOf() {
  const [{ wheels }, { soils }] = await Promise.all([answer("/v1/wheels", {}, asJson), answer("/v1/soils", {}, asJson)]);
  const byId = (entries) => new Map(entries.map((entry) => [entry.id, entry]));
  return { wheels: byId(wheels), soils: byId(soils) };
}

/** Published measurements with what the methods give for them. */
export const validationSets = async () => (await answer("/v1/validation", {}, asJson)).sets;

const quoted = (text) => `'${text.replaceAll("'", "'\\''")}'`;

/** A shell command that sends the same request. */
export function curlCommand(path, body) {
  return [
    `curl -sS ${quoted(location.origin + path)}`,
    `  -H ${quoted("Content-Type: application/json")}`,
    `  -d ${quoted(JSON.stringify(body))}`,
  ].join(" \\\n");
}
