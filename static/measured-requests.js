// The requests that carry measurements, with what is on the page beside them.

import { options } from "./settings.js";

/**
 * `data` are measurements; what is on the page is what is known beside them, and where the search begins. The service lets the
 * direct law stand in for a preset's where K_s is to be found; for a law that is spelt out this is done here.
 */
export function identifyBody(settings, fit, data) {
  const { soil, ...common } = settings.common;
  const { k_c, k_phi, k, m, unit_weight_n_m3, ...exponents } = soil.pressure_sinkage ?? {};
  const isReplaced = fit.includes("k_s") && soil.pressure_sinkage && exponents.law !== "direct";
  const wanted = isReplaced ? { ...soil, pressure_sinkage: { ...exponents, law: "direct" } } : soil;
  return { ...common, soil: wanted, method: settings.method, ...options(settings, settings.method), fit, data };
}

const SINKAGE_OF = { sinkage_m: "page", normal_load_n: "load", static_sinkage_m: "static" };

/**
 * A track: `settings` for its query, its columns, and whence the sinkage comes: `measured`, `measured_load`, or, as set on the page,
 * `load`, `static` or `page`. What was measured goes before what is set.
 */
export function trackRequest(settings, track) {
  const shared = { ...settings.common, ...settings.brakingLaw, method: settings.method, ...options(settings, settings.method) };
  const { sinkage_m: sinkage, ...given } = settings.given;
  if (track.sinkage_m) {
    // With a measured torque the load still has a use of its own.
    const load = settings.givenName === "normal_load_n" && !track.normal_load_n ? given : {};
    return { settings: { ...shared, ...load }, columns: track, sinkageFrom: "measured" };
  }
  if (track.normal_load_n) return { settings: shared, columns: track, sinkageFrom: "measured_load" };
  const columns = sinkage === undefined ? track : { ...track, sinkage_m: track.time_s.map(() => sinkage) };
  return { settings: { ...shared, ...given }, columns, sinkageFrom: SINKAGE_OF[settings.givenName] };
}
