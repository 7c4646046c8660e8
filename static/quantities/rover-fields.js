// The numbers of a rover on a slope, as fields of the page.

import { DEGREE, MILLIMETRE, NEWTON, ONE, PERCENT, power } from "./units.js";

/** @import { Field } from "./fields.js" */

/** @type {(min: number, max: number, step: number) => () => { min: number, max: number, step: number }} */
const range = (min, max, step) => () => ({ min, max, step });

const KILOGRAM = power("kg", 0);
const ACCELERATION = power("m/s²", 0);
const SPEED = power("m/s", 0);
const RADIANS = Math.PI / 180;

/** @type {Field[]} */
export const ROVER_FIELDS = [
  { group: "rover", key: "mass_kg", name: "mass", pointer: "/mass_kg", label: "Mass", symbol: "m", unit: KILOGRAM, base: () => 40, slider: range(1, 1000, 1) },
  { group: "rover_alike", key: "wheels", name: "wheel_count", pointer: "/wheels/count", label: "Number of wheels", symbol: "n", unit: ONE, base: () => 4, slider: range(1, 12, 1) },
  { group: "rover_stations", key: "com_mm", name: "mass_place", pointer: "/centre_of_mass/x_m", label: "Centre of mass", symbol: "x", unit: MILLIMETRE, signed: true,
    base: () => undefined, blank: "equal loads" },
  { group: "rover_stations", key: "com_height_mm", name: "mass_height", pointer: "/centre_of_mass/height_m", label: "Its height", symbol: "h", unit: MILLIMETRE,
    base: () => undefined, blank: "0" },
  { group: "rover", key: "slope_deg", name: "slope", pointer: "/slope_rad", label: "Slope", symbol: "α", unit: DEGREE, signed: true,
    base: () => 5 * RADIANS, slider: range(-30, 40, 0.5) },
  { group: "rover", key: "slope_from_deg", name: "slope_from", pointer: "/slope_rad/from", label: "Charts from slope", symbol: "α", unit: DEGREE, signed: true,
    base: () => 0 },
  { group: "rover", key: "slope_to_deg", name: "slope_to", pointer: "/slope_rad/to", label: "Charts to slope", symbol: "α", unit: DEGREE, signed: true,
    base: () => 20 * RADIANS },
  { group: "rover", key: "rover_g_m_s2", name: "rover_gravity", pointer: "/gravity_m_s2", label: "Gravity", symbol: "g", unit: ACCELERATION,
    base: () => undefined, blank: "the soil’s" },
  { group: "rover", key: "hitch_n", name: "hitch_pull", pointer: "/hitch_pull_n", label: "Hitch pull", symbol: "D", unit: NEWTON, signed: true, base: () => 0 },
  { group: "rover", key: "slip_limit_pct", name: "slip_limit", pointer: "/slip_limit", label: "Slip limit", symbol: "s", unit: PERCENT,
    base: () => 0.6, slider: range(1, 100, 1) },
  { group: "rover", key: "rover_v_m_s", name: "rover_velocity", pointer: "/forward_velocity_m_s", label: "Velocity", symbol: "v", unit: SPEED,
    base: () => undefined, blank: "for power" },
];
