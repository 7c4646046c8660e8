// The requests with measurements. The settings of the page complete them.

import { PRESSURE_SINKAGE, sharedNames } from "../quantities/law-fields.js";
import { options } from "./bodies.js";

/** @import { TrackAsked } from "../api/endpoints.js" */
/** @import { FitData, FitParameter, IdentifyRequest, Soil, TrackColumns } from "../api/types.js" */
/** @import { GivenName, Settings } from "./settings.js" */

/**
 * To fit K_s, the service replaces a preset's law by the direct one. For a law that is spelt out, the page does so.
 * @param {Soil} soil
 * @param {FitParameter[]} fit
 * @returns {Soil}
 */
function withFittedLaw(soil, fit) {
  const own = soil.pressure_sinkage;
  if (!own || own.law === "direct" || !fit.includes("k_s")) return soil;
  const shared = sharedNames(PRESSURE_SINKAGE);
  const exponents = Object.fromEntries(Object.entries(own).filter(([name]) => shared.includes(name)));
  return { ...soil, pressure_sinkage: /** @type {Soil["pressure_sinkage"]} */ ({ ...exponents, law: "direct" }) };
}

/**
 * The values on the page are taken as known, and the search starts from them.
 * @param {Settings} settings
 * @param {FitParameter[]} fit
 * @param {FitData} data
 * @returns {IdentifyRequest}
 */
export function identifyBody(settings, fit, data) {
  const { soil, ...common } = settings.common;
  // A method without what is fitted is refused by the API, which says why.
  const method = /** @type {IdentifyRequest["method"]} */ (settings.method);
  return { ...common, soil: withFittedLaw(soil, fit), method, ...options(settings, settings.method), fit, data };
}

/** @typedef {"measured" | "measured_load" | "load" | "static" | "page"} SinkageSource the last three are set on the page */
/** @typedef {"column" | "page" | null} LoadSource of a load that is known beside a sinkage; null where none is */

/** @type {Record<GivenName, SinkageSource>} */
const SOURCES = { sinkage_m: "page", normal_load_n: "load", static_sinkage_m: "static" };

/**
 * A track with the settings of the page. Measured values take precedence. Slip, static sinkage and load are enough for pull and torque.
 * @param {Settings} settings
 * @param {TrackColumns} track
 * @returns {TrackAsked & { sinkageFrom: SinkageSource, loadFrom: LoadSource }}
 */
export function trackRequest(settings, track) {
  const shared = { ...settings.common, ...settings.brakingLaw, method: settings.method, ...options(settings, settings.method) };
  const { sinkage_m: sinkage, normal_load_n: load, ...fixed } = settings.given;
  const own = load === undefined || track.normal_load_n ? {} : { normal_load_n: load };
  /** @type {LoadSource} */
  const loadFrom = track.normal_load_n ? "column" : load === undefined ? null : "page";
  if (track.sinkage_m) return { settings: { ...shared, ...own }, columns: track, sinkageFrom: "measured", loadFrom };
  if (settings.givenName === "static_sinkage_m") return { settings: { ...shared, ...fixed, ...own }, columns: track, sinkageFrom: "static", loadFrom };
  if (track.normal_load_n) return { settings: shared, columns: track, sinkageFrom: "measured_load", loadFrom: null };
  const columns = sinkage === undefined ? track : { ...track, sinkage_m: (track.time_s ?? []).map(() => sinkage) };
  return { settings: { ...shared, ...own }, columns, sinkageFrom: SOURCES[settings.givenName], loadFrom: sinkage === undefined ? null : loadFrom };
}
