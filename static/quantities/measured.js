// The quantities that a table of measurements may have, with the units and names that tables give them.

import { factor, power } from "./units.js";

/** @import { Unit } from "./units.js" */

/**
 * @typedef {object} MeasuredQuantity
 * @property {string} label
 * @property {Unit[]} units the first one is taken where a table names none
 * @property {string[]} names
 */

const LENGTHS = [power("m", 0), power("cm", -2), power("mm", -3)];
const FORCES = [power("N", 0), power("kN", 3)];

/**
 * By the names of the API. Names of one letter keep their case: t is a time, T a torque.
 * @type {Record<string, MeasuredQuantity>}
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
