// The numbers that can be set: the place of each in a request, its unit on the page, and its value while it is untouched.

import { roundStep, roundedUp } from "../numbers/steps.js";
import { DEGREE, KILOPASCAL, MILLIMETRE, NEWTON, ONE, PERCENT, power } from "./units.js";

/** @import { CatalogueLaw, CatalogueSoil, CatalogueWheel } from "../api/types.js" */
/** @import { Unit } from "./units.js" */

/** @typedef {{ min: number, max: number, step: number }} SliderRange */

/**
 * What untouched fields follow: the chosen entries of the catalogue, and their laws as far as the laws on the page can use them.
 * @typedef {object} Preset
 * @property {CatalogueWheel} [wheel]
 * @property {CatalogueSoil} [soil]
 * @property {CatalogueLaw} pressureSinkage
 * @property {CatalogueLaw} contact
 * @property {CatalogueLaw} shear
 * @property {boolean} braking
 * @property {number | null} [radius] as set on the page
 */

/**
 * @typedef {object} Field
 * @property {string} group shown and hidden together
 * @property {string} key in the address
 * @property {string} name of the input
 * @property {string} pointer into the request
 * @property {string} label
 * @property {string} symbol
 * @property {Unit} unit
 * @property {(preset: Preset) => number | null | undefined} base the value while untouched (SI); none where the catalogue has none
 * @property {(preset: Preset) => SliderRange} [slider] in the unit of the page
 * @property {boolean} [signed] takes negative numbers
 * @property {string} [blank] what an empty box means, where it is no gap
 * @property {"exact"} [word] taken in place of a number
 */

const SLIDER_STEPS = 200;
const DEFAULT_LOAD_N = 90;

/** @type {(min: number, max: number, step: number) => () => SliderRange} */
const range = (min, max, step) => () => ({ min, max, step });

/** @param {number} max */
function upTo(max) {
  const step = roundStep(max, SLIDER_STEPS);
  return { min: step, max, step };
}

/**
 * Up to half the radius, so that the slider resolves the usual sinkages; deeper ones can be typed.
 * @param {Preset} preset
 */
const sinkageRange = ({ radius }) => upTo(Math.max(1, Math.round((radius ?? 0.2) * 500)));

/** @param {Preset} preset */
const nominalLoad = ({ wheel }) => wheel?.values.nominal_load_n?.value ?? DEFAULT_LOAD_N;

/** @param {Preset} preset */
const loadRange = (preset) => upTo(roundedUp(4 * nominalLoad(preset)));

/** @type {Field[]} */
export const FIELDS = [
  { group: "slip", key: "slip_pct", name: "slip", pointer: "/slip", label: "Slip", symbol: "s", unit: PERCENT, signed: true,
    base: () => 0.2, slider: ({ braking }) => ({ min: braking ? -100 : 0, max: 100, step: 1 }) },
  { group: "sinkage", key: "sinkage_mm", name: "sinkage", pointer: "/sinkage_m", label: "Sinkage", symbol: "z", unit: MILLIMETRE,
    base: () => 0.02, slider: sinkageRange },
  { group: "load", key: "load_n", name: "normal_load", pointer: "/normal_load_n", label: "Normal load", symbol: "W", unit: NEWTON,
    base: nominalLoad, slider: loadRange },
  { group: "static", key: "static_mm", name: "static_sinkage", pointer: "/static_sinkage_m",
    label: "Static sinkage", symbol: "z_0", unit: MILLIMETRE,
    base: () => 0.01, slider: sinkageRange },
  { group: "linear", key: "ss_gain", name: "slip_sinkage_gain", pointer: "/slip_sinkage/gain",
    label: "Gain of the sinkage with slip", symbol: "S", unit: ONE,
    base: () => 1, slider: range(0, 5, 0.05) },

  { group: "slip_angle", key: "beta_deg", name: "slip_angle", pointer: "/slip_angle_rad", label: "Slip angle", symbol: "β", unit: DEGREE, signed: true,
    base: () => 0, slider: range(-45, 45, 0.5) },

  { group: "wheel", key: "radius_mm", name: "radius", pointer: "/wheel/radius_m", label: "Radius", symbol: "r", unit: MILLIMETRE,
    base: ({ wheel }) => wheel?.wheel.radius_m, slider: range(20, 600, 1) },
  { group: "wheel", key: "width_mm", name: "width", pointer: "/wheel/width_m", label: "Width", symbol: "b", unit: MILLIMETRE,
    base: ({ wheel }) => wheel?.wheel.width_m, slider: range(10, 500, 1) },
  { group: "wheel", key: "lug_mm", name: "lug_height", pointer: "/wheel/lug_height_m", label: "Lug height", symbol: "h", unit: MILLIMETRE,
    base: ({ wheel }) => wheel?.wheel.lug_height_m ?? 0, slider: range(0, 50, 0.5) },
  { group: "wheel", key: "lug_coef", name: "lug_coefficient", pointer: "/wheel/lug_coefficient",
    label: "Lug coefficient", symbol: "λ_s", unit: ONE,
    base: ({ wheel }) => wheel?.wheel.lug_coefficient ?? 0.5, slider: range(0, 1, 0.05) },

  { group: "strength", key: "c_kpa", name: "cohesion", pointer: "/soil/cohesion_pa", label: "Cohesion", symbol: "c", unit: KILOPASCAL,
    base: ({ soil }) => soil?.soil.cohesion_pa, slider: range(0, 10, 0.05) },
  { group: "strength", key: "phi_deg", name: "friction_angle", pointer: "/soil/friction_angle_rad",
    label: "Friction angle", symbol: "φ", unit: DEGREE,
    base: ({ soil }) => soil?.soil.friction_angle_rad, slider: range(0, 60, 0.5) },
  { group: "janosi_hanamoto", key: "k_mm", name: "shear_modulus", pointer: "/soil/shear_modulus_m",
    label: "Shear modulus", symbol: "K", unit: MILLIMETRE,
    base: ({ soil }) => soil?.soil.shear_modulus_m, slider: range(0.5, 50, 0.5) },
  { group: "residual", key: "kr", name: "residual_ratio", pointer: "/soil/shear/residual_ratio",
    label: "Residual over largest strength", symbol: "K_r", unit: ONE,
    base: ({ shear }) => shear.residual_ratio ?? 0.66, slider: range(0.05, 1, 0.01) },
  { group: "peak", key: "kw_mm", name: "peak_displacement", pointer: "/soil/shear/peak_displacement_m",
    label: "Displacement at the largest strength", symbol: "K_w", unit: MILLIMETRE,
    base: ({ shear }) => shear.peak_displacement_m ?? 0.02, slider: range(0.5, 100, 0.5) },

  { group: "bekker", key: "kc", name: "bekker_k_c", pointer: "/soil/pressure_sinkage/k_c",
    label: "Cohesive modulus", symbol: "k_c", unit: power("kN/mⁿ⁺¹", 3, "in N/mⁿ⁺¹"), signed: true,
    base: ({ pressureSinkage }) => pressureSinkage.k_c },
  { group: "bekker", key: "kphi", name: "bekker_k_phi", pointer: "/soil/pressure_sinkage/k_phi",
    label: "Frictional modulus", symbol: "k_φ", unit: power("kN/mⁿ⁺²", 3, "in N/mⁿ⁺²"), signed: true,
    base: ({ pressureSinkage }) => pressureSinkage.k_phi },
  { group: "direct", key: "ks", name: "k_s", pointer: "/soil/pressure_sinkage/k_s",
    label: "Sinkage modulus", symbol: "K_s", unit: power("kPa/mⁿ", 3, "in Pa/mⁿ"),
    base: ({ pressureSinkage }) => pressureSinkage.k_s },
  { group: "reece", key: "kc_reece", name: "reece_k_c", pointer: "/soil/pressure_sinkage/k_c",
    label: "Cohesive modulus", symbol: "k_c′", unit: ONE, signed: true,
    base: ({ pressureSinkage }) => pressureSinkage.k_c },
  { group: "reece", key: "kphi_reece", name: "reece_k_phi", pointer: "/soil/pressure_sinkage/k_phi",
    label: "Frictional modulus", symbol: "k_φ′", unit: ONE, signed: true,
    base: ({ pressureSinkage }) => pressureSinkage.k_phi },
  { group: "reece", key: "gamma_kn_m3", name: "unit_weight", pointer: "/soil/pressure_sinkage/unit_weight_n_m3",
    label: "Unit weight", symbol: "γ", unit: power("kN/m³", 3, "in N/m³"),
    base: ({ pressureSinkage }) => pressureSinkage.unit_weight_n_m3 },
  { group: "diameter", key: "k_diameter", name: "diameter_k", pointer: "/soil/pressure_sinkage/k",
    label: "Modulus", symbol: "k", unit: power("kPa/mⁿ⁺ᵐ", 3, "in Pa/mⁿ⁺ᵐ"),
    base: ({ pressureSinkage }) => pressureSinkage.k },
  { group: "diameter", key: "m_diameter", name: "diameter_m", pointer: "/soil/pressure_sinkage/m",
    label: "Diameter exponent", symbol: "m", unit: ONE, signed: true,
    base: ({ pressureSinkage }) => pressureSinkage.m },
  { group: "exponent", key: "n0", name: "n0", pointer: "/soil/pressure_sinkage/n0", label: "Sinkage exponent", symbol: "n_0", unit: ONE,
    base: ({ pressureSinkage }) => pressureSinkage.n0, slider: range(0.05, 2, 0.01) },
  { group: "exponent", key: "n1", name: "n1", pointer: "/soil/pressure_sinkage/n1",
    label: "Exponent’s gain with slip", symbol: "n_1", unit: ONE, signed: true,
    base: ({ pressureSinkage }) => pressureSinkage.n1 ?? 0, slider: range(-0.5, 1.5, 0.01) },
  { group: "exponent", key: "n2", name: "n2", pointer: "/soil/pressure_sinkage/n2",
    label: "Exponent’s gain with skid", symbol: "n_2", unit: ONE, signed: true, blank: "as n₁",
    base: ({ pressureSinkage }) => pressureSinkage.n2 },

  { group: "wong_reece", key: "c1", name: "c1", pointer: "/contact/c1",
    label: "Position of the peak", symbol: "c_1", unit: ONE, signed: true,
    base: ({ contact }) => contact.c1 ?? 0.4, slider: range(0, 1, 0.01) },
  { group: "wong_reece", key: "c2", name: "c2", pointer: "/contact/c2",
    label: "Peak’s gain with slip", symbol: "c_2", unit: ONE, signed: true,
    base: ({ contact }) => contact.c2 ?? 0.1, slider: range(-0.5, 0.5, 0.01) },
  { group: "contact", key: "c3", name: "c3", pointer: "/contact/c3", label: "Exit over entry angle", symbol: "c_3", unit: ONE, signed: true,
    base: ({ contact }) => contact.c3 ?? 0, slider: range(-1, 0, 0.01) },
  { group: "explicit", key: "lambda_a", name: "lambda_a", pointer: "/lambda_a",
    label: "Fitting constant of A", symbol: "λ_A", unit: ONE, signed: true, word: "exact",
    base: () => 0 },
  { group: "explicit", key: "lambda_b", name: "lambda_b", pointer: "/lambda_b",
    label: "Fitting constant of B", symbol: "λ_B", unit: ONE, signed: true, word: "exact",
    base: () => 0 },
];

/** @param {string} name */
export function fieldNamed(name) {
  const field = FIELDS.find((each) => each.name === name);
  if (!field) throw new Error(`there is no field ${name}`);
  return field;
}

/** @param {string} pointer */
export const fieldAt = (pointer) => FIELDS.find((field) => field.pointer === pointer);
