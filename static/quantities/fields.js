// The numbers that can be set: the place of each in a request, its unit on the page, and its value while it is untouched.

import { roundStep, roundedUp } from "../numbers/steps.js";
import { asField, noteAt } from "./declared.js";
import { LAW_FIELDS } from "./law-fields.js";
import { ROVER_FIELDS } from "./rover-fields.js";
import { DEGREE, MILLIMETRE, NEWTON, ONE, PERCENT } from "./units.js";

/** @import { CatalogueLaw, CatalogueSoil, CatalogueSubstitute, CatalogueWheel } from "../api/types.js" */
/** @import { Dress } from "./declared.js" */
/** @import { Unit } from "./units.js" */

/** @typedef {{ min: number, max: number, step: number }} SliderRange */

/** @typedef {ReadonlyMap<string, CatalogueSubstitute>} Substitutes for values that were never published, by their pointers */

/**
 * What untouched fields follow: the chosen entries of the catalogue, and their laws as far as the laws on the page can use them.
 * @typedef {object} Preset
 * @property {CatalogueWheel} [wheel]
 * @property {CatalogueSoil} [soil]
 * @property {CatalogueLaw} pressureSinkage
 * @property {CatalogueLaw} contact
 * @property {CatalogueLaw} shear
 * @property {boolean} braking
 * @property {Substitutes} assumed those in force
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
 * @property {(substitutes: Substitutes) => CatalogueSubstitute | undefined} [substitute] the one among them that is its own
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

/**
 * @param {string} name
 * @param {Dress & { key: string, name: string }} dress
 */
const ofWheel = (name, dress) => asField(noteAt(`/wheel/${name}`), "wheel", dress, ({ wheel }) => wheel?.wheel[name]);

/**
 * @param {string} name
 * @param {Dress & { key: string, name: string }} dress
 */
const ofSoil = (name, dress, group = "strength") => asField(noteAt(`/soil/${name}`), group, dress,
  ({ soil }) => /** @type {number | undefined} */ (soil?.soil[name]));

/**
 * Between a bare rim and the soil. The catalogue has none.
 * @param {string} name
 * @param {Dress & { key: string, name: string }} dress
 */
const ofInterface = (name, dress) => asField(noteAt(`/contact/interface/${name}`), "interface", dress, () => undefined);

/** @type {Field[]} */
const OPERATION = [
  { group: "slip", key: "slip_pct", name: "slip", pointer: "/slip", label: "Slip", symbol: "s", unit: PERCENT, signed: true,
    base: () => 0.2, slider: ({ braking }) => ({ min: braking ? -100 : 0, max: 100, step: 1 }) },
  { group: "sinkage", key: "sinkage_mm", name: "sinkage", pointer: "/sinkage_m", label: "Sinkage", symbol: "z", unit: MILLIMETRE,
    base: () => 0.02, slider: sinkageRange },
  { group: "load", key: "load_n", name: "normal_load", pointer: "/normal_load_n", label: "Normal load", symbol: "W", unit: NEWTON,
    base: nominalLoad, slider: loadRange },
  { group: "static", key: "static_mm", name: "static_sinkage", pointer: "/static_sinkage_m",
    label: "Static sinkage", symbol: "z_0", unit: MILLIMETRE,
    base: () => 0.01, slider: sinkageRange },
  { group: "slip_angle", key: "beta_deg", name: "slip_angle", pointer: "/slip_angle_rad", label: "Slip angle", symbol: "β", unit: DEGREE, signed: true,
    base: () => 0, slider: range(-45, 45, 0.5) },
];

/**
 * The numbers of the wheel and those of the soil that are no law's.
 * @type {Field[]}
 */
const PARAMETERS = [
  ofWheel("radius_m", { key: "radius_mm", name: "radius", slider: [20, 600, 1] }),
  ofWheel("width_m", { key: "width_mm", name: "width", slider: [10, 500, 1] }),
  ofWheel("lug_height_m", { key: "lug_mm", name: "lug_height", slider: [0, 50, 0.5] }),
  ofWheel("lug_coefficient", { key: "lug_coef", name: "lug_coefficient", slider: [0, 1, 0.05] }),
  ofInterface("friction_angle_rad", { key: "delta_deg", name: "interface_friction", blank: "the soil’s" }),
  ofInterface("adhesion_pa", { key: "adhesion_kpa", name: "interface_adhesion", blank: "the soil’s" }),
  ofInterface("shear_modulus_m", { key: "ki_mm", name: "interface_modulus", blank: "the soil’s" }),
  ofSoil("cohesion_pa", { key: "c_kpa", name: "cohesion", slider: [0, 10, 0.05] }),
  ofSoil("friction_angle_rad", { key: "phi_deg", name: "friction_angle", slider: [0, 60, 0.5] }),
  ofSoil("bulk_density_kg_m3", { key: "rho_kg_m3", name: "bulk_density", slider: [800, 2200, 5] }, "grains"),
  ofSoil("gravity_m_s2", { key: "g_m_s2", name: "gravity", slider: [0.1, 10, 0.01], blank: "9.80665" }, "grains"),
  ofSoil("granular_stiffness_n_m3", { key: "xi_kn_m3", name: "granular_stiffness", blank: "from ρ" }, "grains"),
];

/** @type {Field[]} */
const EXPLICIT = [
  { group: "explicit", key: "lambda_a", name: "lambda_a", pointer: "/lambda_a",
    label: "Fitting constant of A", symbol: "λ_A", unit: ONE, signed: true, word: "exact",
    base: () => 0 },
  { group: "explicit", key: "lambda_b", name: "lambda_b", pointer: "/lambda_b",
    label: "Fitting constant of B", symbol: "λ_B", unit: ONE, signed: true, word: "exact",
    base: () => 0 },
];

export const FIELDS = [...OPERATION, ...PARAMETERS, ...LAW_FIELDS, ...EXPLICIT, ...ROVER_FIELDS];

/** @param {string} name */
export function fieldNamed(name) {
  const field = FIELDS.find((each) => each.name === name);
  if (!field) throw new Error(`there is no field ${name}`);
  return field;
}

/** @param {string} pointer */
export const fieldAt = (pointer) => FIELDS.find((field) => field.pointer === pointer);
