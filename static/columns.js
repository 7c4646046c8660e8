// What the columns of a table are, guessed by name and unit.

import { power } from "./fields.js";

/** The columns the service takes, with the units in which tables have them; the first one is what a table without a unit has. */
export const MEASURED = {
  slip: { label: "Slip", units: [power("–", 0), power("%", -2)], names: ["s", "i", "slip", "slip_ratio", "slipratio", "wheel_slip", "schlupf"] },
  sinkage_m: { label: "Sinkage", units: [power("m", 0), power("cm", -2), power("mm", -3)],
    names: ["z", "h", "sinkage", "wheel_sinkage", "depth", "einsinkung", "einsinktiefe"] },
  longitudinal_force_n: { label: "Drawbar pull", units: [power("N", 0), power("kN", 3)],
    names: ["fx", "f_x", "dp", "drawbar", "drawbar_pull", "longitudinal_force", "pull", "force_x", "zugkraft"] },
  normal_force_n: { label: "Normal force", units: [power("N", 0), power("kN", 3)],
    names: ["fz", "f_z", "w", "load", "normal_force", "normal_load", "vertical_force", "vertical_load", "force_z", "normalkraft", "last", "radlast"] },
  torque_n_m: { label: "Torque", units: [power("N·m", 0), power("N·mm", -3), power("kN·m", 3)],
    names: ["t", "m", "my", "m_y", "torque", "wheel_torque", "driving_torque", "moment", "drehmoment"] },
};

/** Beyond these, a number without a unit is no ratio and no sinkage in metres of a rover's wheel. */
const LARGEST_RATIO = 1.5;
const LARGEST_SINKAGE_M = 1;

const UNIT_WORDS = { "1": "–", "-": "–", "": "", nm: "N·m", "n*m": "N·m", "n.m": "N·m", "n m": "N·m", "n-m": "N·m", nmm: "N·mm", knm: "kN·m", percent: "%", pct: "%" };

function unitWord(text) {
  const word = text.replace(/[[\](){}]/g, "").trim().toLowerCase();
  return UNIT_WORDS[word] ?? word;
}

/** "Fx [N]", "z (mm)", "slip / %" and "sinkage_mm" as a name and a unit. */
function split(heading, unitOfRow) {
  const [, name, bracketed] = /^(.*?)\s*[[({]([^\])}]*)[\])}]\s*$/.exec(heading) ?? [];
  if (name) return { name, unit: unitWord(bracketed) };
  const [, before, after] = /^(.*?)\s*\/\s*(\S+)$/.exec(heading) ?? [];
  if (before) return { name: before, unit: unitWord(after) };
  return { name: heading, unit: unitWord(unitOfRow) };
}

const normal = (name) => name.trim().toLowerCase().replace(/[\s.-]+/g, "_");
const UNIT_SUFFIX = /^(.+?)_(m|cm|mm|n|kn|n_m|nm|n_mm|pct|percent)$/;

function guess({ heading, unit: unitOfRow, texts }) {
  let { name, unit } = split(heading, unitOfRow);
  name = normal(name);
  const quantityOf = (word) => Object.keys(MEASURED).find((key) => MEASURED[key].names.includes(word));
  let quantity = quantityOf(name);
  const [, stem, suffix] = UNIT_SUFFIX.exec(name) ?? [];
  if (!quantity && stem) {
    quantity = quantityOf(stem);
    unit ||= unitWord(suffix.replace("_", ""));
  }
  if (!quantity) return null;
  const { units } = MEASURED[quantity];
  const largest = texts.reduce((most, text) => Math.max(most, Math.abs(Number(text))), 0);
  const known = units.find(({ text }) => text.toLowerCase() === unit.toLowerCase());
  if (known) return { quantity, unit: known };
  // A unit that the quantity cannot have makes it another quantity.
  if (unit) return null;
  if (quantity === "slip" && largest > LARGEST_RATIO) return { quantity, unit: units[1] };
  if (quantity === "sinkage_m" && largest > LARGEST_SINKAGE_M) return { quantity, unit: units[2] };
  return { quantity, unit: units[0] };
}

/** For each column its quantity and unit, or null; a quantity goes to the first column that may be it. */
export function guessColumns(columns) {
  const taken = new Set();
  return columns.map((column) => {
    const found = guess(column);
    if (!found || taken.has(found.quantity)) return null;
    taken.add(found.quantity);
    return found;
  });
}

export const choiceOf = (mapped) => (mapped ? `${mapped.quantity} ${mapped.unit.text}` : "");

export function choiceFrom(value) {
  const [quantity, text] = value.split(" ");
  return quantity ? { quantity, unit: MEASURED[quantity].units.find((unit) => unit.text === text) } : null;
}

/**
 * The measurements in SI by the service's names, with the line of each row; rows with an empty cell in a chosen column are left
 * out and counted. `faults` are those that stand in the way.
 */
export function samplesOf(table, mapping) {
  const used = mapping.map((mapped, column) => ({ ...mapped, column })).filter(({ quantity }) => quantity);
  const faults = table.faults.filter(({ column }) => mapping[column]).map(({ text }) => text);
  for (const quantity of Object.keys(MEASURED)) {
    const holders = used.filter((each) => each.quantity === quantity);
    if (holders.length > 1) faults.push(`${MEASURED[quantity].label} is chosen for ${holders.length} columns: ignore all but one.`);
  }
  const has = (quantity) => used.some((each) => each.quantity === quantity);
  if (!has("slip")) faults.push("Choose the column that is the slip.");
  if (!used.some(({ quantity }) => quantity !== "slip")) faults.push("Choose a measured column beside the slip.");
  const rows = table.lines.map((_, row) => row).filter((row) => used.every(({ column }) => table.columns[column].texts[row] !== null));
  if (!rows.length) faults.push("No row has a number in every chosen column.");
  const data = Object.fromEntries(used.map(({ quantity, unit, column }) => [quantity, rows.map((row) => unit.toSi(table.columns[column].texts[row]))]));
  return { data, lines: rows.map((row) => table.lines[row]), left: table.lines.length - rows.length, faults };
}
