// What the contract says of fields, in words: one row for each, with its unit, its bounds and its meaning.

/**
 * @typedef {object} Schema
 * @property {string} [$ref]
 * @property {string | string[]} [type]
 * @property {string} [description]
 * @property {Record<string, Schema>} [properties]
 * @property {string[]} [required]
 * @property {Schema} [items]
 * @property {Schema | boolean} [additionalProperties]
 * @property {Schema[]} [oneOf]
 * @property {unknown[]} [enum]
 * @property {unknown} [default]
 * @property {number} [minimum]
 * @property {number} [maximum]
 * @property {number} [exclusiveMinimum]
 * @property {number} [exclusiveMaximum]
 * @property {number} [minItems]
 * @property {number} [maxItems]
 * @property {string} [x-unit]
 */
/** @typedef {{ $ref?: string, name: string, in: "path" | "query", description?: string, required?: boolean, schema: Schema, example?: unknown }} Parameter */
/** @typedef {Record<string, { schema?: Schema, example?: unknown }>} Content */
/** @typedef {{ $ref?: string, description?: string, content?: Content }} Answer */
/** @typedef {{ tags: string[], summary?: string, description?: string, operationId: string, parameters?: Parameter[], requestBody?: { content: Content }, responses: Record<string, Answer> }} Operation */
/** @typedef {{ method: string, path: string, operation: Operation }} Entry */
/** @typedef {{ info: { description: string, version: string }, tags: { name: string, description: string }[], paths: Record<string, Record<string, Operation>>, components: object }} Contract */

/** @typedef {{ name: string, kind: string, unit: string, bounds: string, meaning: string, depth: number, required: boolean }} Row */

/** Objects within objects that are shown. */
const DEEPEST = 6;
/** Words of a choice that are listed; there are presets by the dozen. */
const MOST_WORDS = 12;

/**
 * What a reference stands for; anything else stands for itself.
 * @template {{ $ref?: string }} Part
 * @param {Contract} contract
 * @param {Part} part
 * @returns {Part}
 */
export function resolved(contract, part) {
  if (!part.$ref) return part;
  const names = part.$ref.slice("#/".length).split("/");
  const found = names.reduce((/** @type {any} */ inner, name) => inner?.[name], contract);
  return { ...found, ...part, $ref: undefined };
}

/**
 * The operations in the order of the tags.
 * @param {Contract} contract
 * @param {string} tag
 * @returns {Entry[]}
 */
export const operationsOf = (contract, tag) => Object.entries(contract.paths).flatMap(([path, methods]) =>
  Object.entries(methods)
    .filter(([, operation]) => operation.tags.includes(tag))
    .map(([method, operation]) => ({ method: method.toUpperCase(), path, operation })));

/** @param {Schema} schema */
const typesOf = (schema) => [schema.type ?? []].flat();

/**
 * @param {Contract} contract
 * @param {Schema} given
 * @returns {string}
 */
function kindOf(contract, given) {
  const schema = resolved(contract, given);
  if (schema.oneOf) return [...new Set(schema.oneOf.map((each) => kindOf(contract, each)))].join(" or ");
  if (schema.items) return `list of ${kindOf(contract, schema.items)}s`;
  return typesOf(schema).map((type) => (type === "string" && schema.enum ? "word" : type)).join(" or ");
}

/** @param {Schema} schema */
function rangeOf(schema) {
  const { minimum, maximum, exclusiveMinimum, exclusiveMaximum, minItems, maxItems } = schema;
  const lower = exclusiveMinimum !== undefined ? `> ${exclusiveMinimum}` : minimum !== undefined ? `≥ ${minimum}` : null;
  const upper = exclusiveMaximum !== undefined ? `< ${exclusiveMaximum}` : maximum !== undefined ? `≤ ${maximum}` : null;
  const count = maxItems !== undefined ? `${minItems ?? 0} to ${maxItems} values` : null;
  return [count, [lower, upper].filter(Boolean).join(", ")].filter(Boolean).join("; ");
}

/**
 * @param {Contract} contract
 * @param {Schema} given
 * @returns {string}
 */
function boundsOf(contract, given) {
  const schema = resolved(contract, given);
  const words = schema.enum?.map(String) ?? [];
  const choice = words.length > MOST_WORDS ? `${words.slice(0, MOST_WORDS).join(", ")} and ${words.length - MOST_WORDS} more` : words.join(", ");
  const inner = schema.items ? boundsOf(contract, schema.items) : "";
  const otherwise = schema.default !== undefined ? `default ${JSON.stringify(schema.default)}` : "";
  return [rangeOf(schema), choice, inner && `each ${inner}`, otherwise].filter(Boolean).join("; ");
}

/**
 * @param {Contract} contract
 * @param {Schema} given
 * @returns {string}
 */
function unitOf(contract, given) {
  const schema = resolved(contract, given);
  const unit = schema["x-unit"] ?? (schema.items && unitOf(contract, schema.items));
  // A unit in braces is one that the code of units has no name for.
  return unit === "1" ? "–" : unit?.replace(/^\{(.*)\}$/, "$1") ?? "";
}

/**
 * A row for a field, and one for each field in it.
 * @param {Contract} contract
 * @param {string} name
 * @param {Schema} given
 * @param {{ depth: number, required: boolean }} place
 * @returns {Row[]}
 */
export function rowsOfField(contract, name, given, { depth, required }) {
  const schema = resolved(contract, given);
  const row = {
    name,
    depth,
    required,
    kind: kindOf(contract, schema),
    unit: unitOf(contract, schema),
    bounds: boundsOf(contract, schema),
    meaning: schema.description ?? "",
  };
  return [row, ...rowsWithin(contract, schema, depth + 1)];
}

/**
 * The rows of all fields in an object, in each kind of it, or in the objects of a list.
 * @param {Contract} contract
 * @param {Schema} given
 * @param {number} depth
 * @returns {Row[]}
 */
export function rowsWithin(contract, given, depth = 0) {
  if (depth > DEEPEST) return [];
  const schema = resolved(contract, given);
  if (schema.items) return rowsWithin(contract, schema.items, depth);
  const own = Object.entries(schema.properties ?? {}).flatMap(([name, field]) =>
    rowsOfField(contract, name, field, { depth, required: schema.required?.includes(name) ?? false }));
  return [...own, ...(schema.oneOf ?? []).flatMap((each) => rowsWithin(contract, each, depth))];
}
