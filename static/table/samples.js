// What a table gives the service: points over slip that a fit can take, and a track over time.

import { MEASURED } from "../quantities/measured.js";

/** @import { FitData, TrackColumns } from "../api/types.js" */
/** @import { Cell } from "../numbers/columns.js" */
/** @import { Mapping, Mapped } from "./columns.js" */
/** @import { Table, WrongCell } from "./parse.js" */

/** @typedef {Record<string, Cell[]>} MeasuredColumns in SI, by the API's names of measured quantities */
/** @typedef {Mapped & { column: number }} UsedColumn */

/**
 * Rows with a number in every chosen column.
 * @typedef {object} SlipPoints
 * @property {FitData} data
 * @property {number[]} lines of the file
 * @property {number} left rows that are left out
 */

/**
 * @typedef {object} Samples
 * @property {SlipPoints | null} points null where there are none, or too many
 * @property {boolean} isTooLong there are too many points
 * @property {TrackColumns | null} track null where the table is no telemetry
 * @property {MeasuredColumns} columns all that were chosen
 * @property {WrongCell[]} odd cells of telemetry that are not numbers, and count as empty
 * @property {string[]} faults that stand in the way of both
 */

/** What the service takes in one search. */
export const MOST_POINTS = 10_001;
const VELOCITIES = ["forward_velocity_m_s", "angular_velocity_rad_s"];
const POINT_QUANTITIES = ["slip", "sinkage_m", "longitudinal_force_n", "normal_force_n", "torque_n_m"];
/**
 * The measured quantities of a track by the API's names. The measured normal force is the load of the track.
 * @type {Record<string, keyof TrackColumns>}
 */
const TRACK_NAMES = {
  time_s: "time_s", slip: "slip", forward_velocity_m_s: "forward_velocity_m_s", angular_velocity_rad_s: "angular_velocity_rad_s",
  sinkage_m: "sinkage_m", torque_n_m: "torque_n_m", normal_force_n: "normal_load_n",
};

/**
 * @param {Table} table
 * @param {UsedColumn[]} used
 * @returns {MeasuredColumns}
 */
const columnsOf = (table, used) => Object.fromEntries(used.map(({ quantity, unit, column }) =>
  [quantity, table.columns[column].texts.map((text) => (text === null ? null : unit.toSi(text)))]));

/**
 * @param {MeasuredColumns} columns
 * @returns {TrackColumns | null}
 */
function trackOf(columns) {
  const hasSlip = Boolean(columns.slip);
  if (!columns.time_s || !(hasSlip || VELOCITIES.every((name) => columns[name]))) return null;
  const sent = Object.keys(TRACK_NAMES).filter((name) => columns[name] && !(hasSlip && VELOCITIES.includes(name)));
  return Object.fromEntries(sent.map((name) => [TRACK_NAMES[name], columns[name]]));
}

/**
 * @param {Table} table
 * @param {MeasuredColumns} columns
 * @returns {SlipPoints | null}
 */
function pointsOf({ lines }, columns) {
  if (!columns.slip || !POINT_QUANTITIES.some((name) => name !== "slip" && columns[name])) return null;
  const names = POINT_QUANTITIES.filter((name) => columns[name]);
  const rows = lines.map((_, row) => row).filter((row) => names.every((name) => columns[name][row] !== null));
  const data = Object.fromEntries(names.map((name) => [name, rows.map((row) => columns[name][row])]));
  return { data: /** @type {FitData} */ (data), lines: rows.map((row) => lines[row]), left: lines.length - rows.length };
}

/** @param {UsedColumn[]} used */
const repeated = (used) => Object.entries(MEASURED).flatMap(([name, { label }]) => {
  const count = used.filter(({ quantity }) => quantity === name).length;
  return count > 1 ? [`${label} is chosen for ${count} columns: ignore all but one.`] : [];
});

/** @param {MeasuredColumns} columns */
function missingSlip(columns) {
  if (!["time_s", ...VELOCITIES].some((name) => columns[name])) return "Choose the column that is the slip.";
  const missing = ["time_s", ...VELOCITIES].filter((name) => !columns[name]).map((name) => MEASURED[name].label.toLowerCase());
  return `Choose the column that is the slip; for telemetry choose ${missing.join(" and ")}.`;
}

/**
 * Why neither points nor a track can be had; empty where one of them can.
 * @param {SlipPoints | null} points
 * @param {TrackColumns | null} track
 * @param {MeasuredColumns} columns
 */
function uselessness(points, track, columns) {
  if (track) return [];
  if (!columns.slip) return [missingSlip(columns)];
  if (!points) return ["Choose a measured column beside the slip."];
  if (!points.lines.length) return ["No row has a number in every chosen column."];
  if (points.lines.length > MOST_POINTS) return [`Line ${points.lines[MOST_POINTS]}: the service takes ${MOST_POINTS} rows at most.`];
  return [];
}

/**
 * @param {Table} table
 * @param {Mapping} mapping
 * @param {Cell[] | null} slips of the rows of a track, as the service has found them
 * @returns {Samples}
 */
export function samplesOf(table, mapping, slips = null) {
  const used = mapping.flatMap((mapped, column) => (mapped ? [{ ...mapped, column }] : []));
  const own = columnsOf(table, used);
  const track = trackOf(own);
  const wrong = table.faults.filter(({ column }) => mapping[column]);
  const odd = track ? wrong.filter(({ isOdd }) => isOdd).sort((a, b) => a.line - b.line) : [];
  const columns = slips && !own.slip ? { ...own, slip: slips } : own;
  const points = pointsOf(table, columns);
  const isTooLong = points !== null && points.lines.length > MOST_POINTS;
  return {
    points: points?.lines.length && !isTooLong ? points : null,
    isTooLong,
    track,
    columns,
    odd,
    faults: [...wrong.filter((cell) => !odd.includes(cell)).map(({ text }) => text), ...repeated(used), ...uselessness(points, track, columns)],
  };
}

/**
 * Whether there are velocities beside a slip, which are not sent.
 * @param {Mapping} mapping
 */
export const hasSpareVelocities = (mapping) =>
  mapping.some((mapped) => mapped?.quantity === "slip") && mapping.some((mapped) => mapped && VELOCITIES.includes(mapped.quantity));
