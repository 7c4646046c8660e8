// What a mapped table gives the service: points to be fitted to, and a track over time.

import { MEASURED } from "./columns.js";

/** What the service takes in one search. */
export const MOST_POINTS = 10_001;
const VELOCITIES = ["forward_velocity_m_s", "angular_velocity_rad_s"];
const POINT_QUANTITIES = ["slip", "sinkage_m", "longitudinal_force_n", "normal_force_n", "torque_n_m"];
/** The measured normal force is the load that the track is under. */
const TRACK_NAMES = { time_s: "time_s", slip: "slip", forward_velocity_m_s: "forward_velocity_m_s", angular_velocity_rad_s: "angular_velocity_rad_s",
  sinkage_m: "sinkage_m", torque_n_m: "torque_n_m", normal_force_n: "normal_load_n" };

/** The columns in SI by the page's names, each with a null where its cell is empty. */
function columnsOf(table, used) {
  return Object.fromEntries(used.map(({ quantity, unit, column }) =>
    [quantity, table.columns[column].texts.map((text) => (text === null ? null : unit.toSi(text)))]));
}

/** Its columns by the service's names, in the order of the table's rows, or null where the table is no telemetry. */
function trackOf(columns) {
  const hasSlip = Boolean(columns.slip);
  if (!columns.time_s || !(hasSlip || VELOCITIES.every((name) => columns[name]))) return null;
  const sent = Object.keys(TRACK_NAMES).filter((name) => columns[name] && !(hasSlip && VELOCITIES.includes(name)));
  return Object.fromEntries(sent.map((name) => [TRACK_NAMES[name], columns[name]]));
}

/** Rows with a number in every column; the others are left out and counted. */
function pointsOf(table, columns) {
  const names = POINT_QUANTITIES.filter((name) => columns[name]);
  const rows = table.lines.map((_, row) => row).filter((row) => names.every((name) => columns[name][row] !== null));
  return {
    data: Object.fromEntries(names.map((name) => [name, rows.map((row) => columns[name][row])])),
    lines: rows.map((row) => table.lines[row]),
    left: table.lines.length - rows.length,
  };
}

function faultsOfMapping(cells, used) {
  const faults = cells.map(({ text }) => text);
  for (const [name, { label }] of Object.entries(MEASURED)) {
    const count = used.filter(({ quantity }) => quantity === name).length;
    if (count > 1) faults.push(`${label} is chosen for ${count} columns: ignore all but one.`);
  }
  return faults;
}

function wantingSlip(columns) {
  const given = VELOCITIES.filter((name) => columns[name]);
  if (columns.time_s || given.length) {
    const wanting = ["time_s", ...VELOCITIES].filter((name) => !columns[name]).map((name) => MEASURED[name].label.toLowerCase());
    return `Choose the column that is the slip; for telemetry choose ${wanting.join(" and ")}.`;
  }
  return "Choose the column that is the slip.";
}

/**
 * `points` { data, lines, left } for curves and fit, null where there are none or too many; `track` columns for the service, null
 * where the table is no telemetry; `columns` all that were chosen; `faults` are those that stand in the way of both. `slips` are
 * those that the service has found for the rows of a track. A telemetry's cells that are no numbers count as empty: `odd`.
 */
export function samplesOf(table, mapping, slips = null) {
  const used = mapping.map((mapped, column) => ({ ...mapped, column })).filter(({ quantity }) => quantity);
  const own = columnsOf(table, used);
  const track = trackOf(own);
  const wrong = table.faults.filter(({ column }) => mapping[column]);
  const odd = track ? wrong.filter(({ isOdd }) => isOdd).sort((a, b) => a.line - b.line) : [];
  const faults = faultsOfMapping(wrong.filter((cell) => !odd.includes(cell)), used);
  const columns = slips && !own.slip ? { ...own, slip: slips } : own;
  const points = columns.slip && POINT_QUANTITIES.some((name) => name !== "slip" && columns[name]) ? pointsOf(table, columns) : null;
  if (!columns.slip && !track) faults.push(wantingSlip(own));
  else if (!points && !track) faults.push("Choose a measured column beside the slip.");
  if (points && !points.lines.length && !track) faults.push("No row has a number in every chosen column.");
  const isTooLong = points?.lines.length > MOST_POINTS;
  if (isTooLong && !track) faults.push(`Line ${points.lines[MOST_POINTS]}: the service takes ${MOST_POINTS} rows at most.`);
  return { points: points?.lines.length && !isTooLong ? points : null, isTooLong, track, columns, odd, faults };
}

/** Velocities beside a slip, which are not sent. */
export const hasSpareVelocities = (mapping) =>
  mapping.some((mapped) => mapped?.quantity === "slip") && mapping.some((mapped) => VELOCITIES.includes(mapped?.quantity));
