// What the columns of a table are, guessed by name and unit.

import { power } from "./fields.js";

const factor = (text, toOne) => ({ text, toSi: (plain) => Number(plain) * toOne, fromSi: (value) => value / toOne });
const LENGTHS = [power("m", 0), power("cm", -2), power("mm", -3)];
const FORCES = [power("N", 0), power("kN", 3)];

/**
 * The columns the service takes, with the units in which tables have them; the first one is what a table without a unit has.
 * A name of one letter is meant as it is written: t is a time, T a torque.
 */
export const MEASURED = {
  time_s: { label: "Time", units: [power("s", 0), power("ms", -3), factor("min", 60)], names: ["t", "time", "elapsed", "elapsed_time", "timestamp", "zeit"] },
  slip: { label: "Slip", units: [power("–", 0), power("%", -2)], names: ["s", "S", "i", "slip", "slip_ratio", "slipratio", "wheel_slip", "schlupf"] },
  forward_velocity_m_s: { label: "Forward velocity", units: [power("m/s", 0), power("cm/s", -2), power("mm/s", -3)],
    names: ["v", "v_x", "vx", "velocity", "speed", "forward_velocity", "forward_speed", "travel_speed", "travel_velocity", "geschwindigkeit", "fahrgeschwindigkeit"] },
  angular_velocity_rad_s: { label: "Angular velocity", units: [power("rad/s", 0), factor("rpm", Math.PI / 30), factor("°/s", Math.PI / 180)],
    names: ["ω", "w", "omega", "angular_velocity", "angular_speed", "wheel_speed", "rotational_speed", "winkelgeschwindigkeit", "drehzahl", "rpm"] },
  sinkage_m: { label: "Sinkage", units: LENGTHS, names: ["z", "Z", "h", "sinkage", "wheel_sinkage", "depth", "einsinkung", "einsinktiefe"] },
  longitudinal_force_n: { label: "Drawbar pull", units: FORCES,
    names: ["fx", "f_x", "dp", "drawbar", "drawbar_pull", "longitudinal_force", "pull", "force_x", "zugkraft"] },
  normal_force_n: { label: "Normal force", units: FORCES,
    names: ["W", "w", "fz", "f_z", "load", "normal_force", "normal_load", "vertical_force", "vertical_load", "force_z", "normalkraft", "last", "radlast"] },
  torque_n_m: { label: "Torque", units: [power("N·m", 0), power("N·mm", -3), power("kN·m", 3)],
    names: ["T", "M", "m", "my", "m_y", "torque", "wheel_torque", "driving_torque", "moment", "drehmoment"] },
};

/** Beyond these, a number without a unit is no ratio and no sinkage in metres of a rover's wheel. */
const LARGEST_RATIO = 1.5;
const LARGEST_SINKAGE_M = 1;

/** Units that a name brings along. */
const UNIT_OF_NAME = { rpm: "rpm", drehzahl: "rpm" };

/** How else units are written, in lower case. */
const UNIT_WORDS = {
  "1": "–", "-": "–", percent: "%", pct: "%", nm: "N·m", n_m: "N·m", "n*m": "N·m", "n.m": "N·m", "n m": "N·m", "n-m": "N·m", nmm: "N·mm", n_mm: "N·mm", knm: "kN·m",
  m_s: "m/s", cm_s: "cm/s", mm_s: "mm/s", "m s-1": "m/s", rad_s: "rad/s", "rad s-1": "rad/s", "1/min": "rpm", "u/min": "rpm", "deg/s": "°/s", deg_s: "°/s",
  sec: "s", seconds: "s", minutes: "min",
};
const UNITS = new Map(Object.values(MEASURED).flatMap(({ units }) => units.map(({ text }) => [text.toLowerCase(), text])));

function unitWord(text) {
  const word = text.replace(/[[\](){}]/g, "").trim().toLowerCase();
  return UNIT_WORDS[word] ?? UNITS.get(word) ?? word;
}
const isUnit = (text) => [...UNITS.values()].includes(unitWord(text));

/** "Fx [N]", "z (mm)", "slip / %", "Slip %" and "v m/s" as a name and a unit. */
function split(heading, unitOfRow) {
  const [, name, bracketed] = /^(.*?)[\s/_]*[[({]([^\])}]*)[\])}]$/.exec(heading) ?? [];
  if (name) return { name, unit: unitWord(bracketed) };
  for (const { index, 0: gap } of heading.matchAll(/[\s/]+/g)) {
    const rest = heading.slice(index + gap.length);
    if (index && isUnit(rest)) return { name: heading.slice(0, index), unit: unitWord(rest) };
  }
  return { name: heading, unit: unitWord(unitOfRow) };
}

const UNIT_SUFFIX = /^(.+?)_(m|cm|mm|n|kn|n_m|nm|n_mm|nmm|pct|percent|%|s|ms|min|sec|m_s|cm_s|mm_s|rad_s|deg_s|rpm)$/i;

/** A word of a heading as the names have it. */
function normal(text) {
  const word = text.trim().replace(/[\s.-]+/g, "_");
  return word.length === 1 ? word : word.toLowerCase();
}
const quantitiesOf = (word) => Object.keys(MEASURED).filter((key) => MEASURED[key].names.includes(word));

function usualUnit(quantity, name, texts) {
  const { units } = MEASURED[quantity];
  const largest = texts.reduce((most, text) => Math.max(most, Math.abs(Number(text))), 0);
  if (quantity === "slip" && largest > LARGEST_RATIO) return units[1];
  if (quantity === "sinkage_m" && largest > LARGEST_SINKAGE_M) return units[2];
  return units.find(({ text }) => text === UNIT_OF_NAME[name]) ?? units[0];
}

function guess({ heading, unit: unitOfRow, texts }) {
  let { name, unit } = split(heading.trim(), unitOfRow);
  name = normal(name);
  let quantities = quantitiesOf(name);
  const [, stem, suffix] = UNIT_SUFFIX.exec(heading.trim().replace(/[\s.-]+/g, "_")) ?? [];
  if (!quantities.length && stem) {
    quantities = quantitiesOf(normal(stem));
    unit ||= unitWord(suffix);
  }
  // A unit that the quantity cannot have makes it another quantity; a name that two quantities have says nothing without one.
  const unitOf = (quantity) => MEASURED[quantity].units.find(({ text }) => text === unit);
  const possible = unit ? quantities.filter(unitOf) : quantities;
  if (possible.length !== 1) return null;
  const [quantity] = possible;
  return { quantity, unit: unit ? unitOf(quantity) : usualUnit(quantity, name, texts) };
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
