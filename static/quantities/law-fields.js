// The parameters of the laws as fields of the page, made from the tables that the service states. The page adds the names of inputs and
// of the address, sliders, and where a value begins that neither the catalogue nor the table has.

import { model } from "../api/model.js";
import { asField } from "./declared.js";

/** @import { CatalogueLaw, ParameterNote } from "../api/types.js" */
/** @import { Dress } from "./declared.js" */
/** @import { Field, Preset } from "./fields.js" */

/** @typedef {Field & { family: string, laws: string[], fittable: boolean, api: string }} LawField */

export const PRESSURE_SINKAGE = "/soil/pressure_sinkage";
export const SHEAR = "/soil/shear";
export const CONTACT = "/contact";
export const EXIT = "/contact/exit";
export const SLIP_SINKAGE = "/slip_sinkage";

/**
 * The catalogue's values for a family. Those that stand in the soil itself are not among them.
 * @type {Record<string, (preset: Preset) => CatalogueLaw>}
 */
const KNOWN = {
  [PRESSURE_SINKAGE]: ({ pressureSinkage }) => pressureSinkage,
  [SHEAR]: ({ shear }) => shear,
  [CONTACT]: ({ contact }) => contact,
};

/**
 * By the law that has the parameter alone, or by the family where several laws share it.
 * @type {Record<string, Dress>}
 */
const DRESSES = {
  "janosi_hanamoto.shear_modulus_m": { key: "k_mm", name: "shear_modulus", slider: [0.5, 50, 0.5] },
  "wong_residual.residual_ratio": { key: "kr", name: "residual_ratio", start: 0.66, slider: [0.05, 1, 0.01] },
  "/soil/shear.peak_displacement_m": { key: "kw_mm", name: "peak_displacement", start: 0.02, slider: [0.5, 100, 0.5] },
  "bekker.k_c": { key: "kc" },
  "bekker.k_phi": { key: "kphi" },
  "direct.k_s": { key: "ks", name: "k_s" },
  "reece.k_c": { key: "kc_reece" },
  "reece.k_phi": { key: "kphi_reece" },
  "reece.unit_weight_n_m3": { key: "gamma_kn_m3", name: "unit_weight" },
  "diameter.k": { key: "k_diameter" },
  "diameter.m": { key: "m_diameter" },
  "/soil/pressure_sinkage.n0": { key: "n0", name: "n0", slider: [0.05, 2, 0.01] },
  "/soil/pressure_sinkage.n1": { key: "n1", name: "n1", slider: [-0.5, 1.5, 0.01] },
  "/soil/pressure_sinkage.n2": { key: "n2", name: "n2", blank: "as n₁" },
  "wong_reece.c1": { key: "c1", name: "c1", start: 0.4, slider: [0, 1, 0.01] },
  "wong_reece.c2": { key: "c2", name: "c2", start: 0.1, slider: [-0.5, 0.5, 0.01] },
  "/contact.c3": { key: "c3", name: "c3", slider: [-1.2, 0, 0.01] },
  "sinkage_ratio.ratio": { key: "exit_ratio", name: "exit_ratio", start: 1, slider: [0, 1.2, 0.01] },
  "linear.gain": { key: "ss_gain", name: "slip_sinkage_gain", start: 1, slider: [0, 5, 0.05] },
};

/** @param {string} pointer */
const placeOf = (pointer) => pointer.slice(0, pointer.lastIndexOf("/"));

/**
 * @param {string} family
 * @param {ParameterNote} note
 * @param {string[]} laws
 * @returns {LawField}
 */
function lawField(family, note, laws) {
  const place = placeOf(note.pointer);
  const law = laws.length === 1 ? laws[0] : family;
  /** @param {Preset} preset */
  const known = (preset) => (place === "/soil" ? preset.soil?.soil[note.name] : KNOWN[family]?.(preset)[note.name]);
  const dress = { key: `${laws[0]}_${note.name}`, name: `${laws[0]}_${note.name}`, ...DRESSES[`${law}.${note.name}`] };
  const group = `${place}:${laws.join(" ")}`;
  return { ...asField(note, group, dress, (preset) => /** @type {number | undefined} */ (known(preset))), family, laws, fittable: note.fittable, api: note.name };
}

/**
 * The fields of a family. What laws share is one field; a name that has another unit in another law is another field.
 * @param {string} family
 * @param {{ name: string, parameters: ParameterNote[] }[]} laws
 */
function fieldsOf(family, laws) {
  /** @type {Map<string, { note: ParameterNote, laws: string[] }>} */
  const found = new Map();
  for (const { name, parameters } of laws) {
    for (const note of parameters) {
      const known = `${note.name} ${note.symbol} ${note.unit}`;
      found.set(known, { note, laws: [...(found.get(known)?.laws ?? []), name] });
    }
  }
  // What a law has alone stands before what it shares.
  const own = [...found.values()].sort((a, b) => a.laws.length - b.laws.length);
  return own.map(({ note, laws: having }) => lawField(family, note, having));
}

/** The families that the page has a place for. */
const SHOWN = [PRESSURE_SINKAGE, SHEAR, CONTACT, EXIT, SLIP_SINKAGE];

export const FAMILIES = model().laws.filter(({ pointer }) => SHOWN.includes(pointer));

/** @type {LawField[]} */
export const LAW_FIELDS = FAMILIES.flatMap(({ pointer, laws }) => fieldsOf(pointer, laws));

/** @param {string} family */
export const lawsOf = (family) => FAMILIES.find(({ pointer }) => pointer === family)?.laws ?? [];

/**
 * The groups of the fields that stand at a place of the request, each once.
 * @param {string} place
 */
export const groupsAt = (place) => [...new Set(LAW_FIELDS.filter(({ pointer }) => placeOf(pointer) === place).map(({ group }) => group))];

/**
 * The groups of the fields of a family, each once.
 * @param {string} family
 */
export const groupsOf = (family) => [...new Set(LAW_FIELDS.filter((field) => field.family === family).map(({ group }) => group))];

/**
 * The groups of a law.
 * @param {string} family
 * @param {string} law
 */
export const groupsOfLaw = (family, law) => LAW_FIELDS.filter((field) => field.family === family && field.laws.includes(law)).map(({ group }) => group);

/**
 * The names of the parameters that every law of a family has.
 * @param {string} family
 */
export const sharedNames = (family) =>
  LAW_FIELDS.filter((field) => field.family === family && field.laws.length === lawsOf(family).length).map(({ api }) => api);

/**
 * The groups of the parameters that every law of a family has.
 * @param {string} family
 */
export const sharedGroups = (family) =>
  [...new Set(LAW_FIELDS.filter((field) => field.family === family && field.laws.length === lawsOf(family).length).map(({ group }) => group))];
