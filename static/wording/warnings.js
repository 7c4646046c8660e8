// The words for warnings of the API. What holds where is told from the data, in the units and names of the page, and by the API's own
// sentence where there are no data. What to do is the API's sentence, unless it is done by a control of the page.

import { capitalised, percent } from "../numbers/format.js";
import { fieldAt } from "../quantities/fields.js";
import { MEASURED } from "../quantities/measured.js";
import { PARAMETERS, fieldOf, valueText } from "../quantities/parameters.js";
import { quantity } from "../quantities/results.js";
import { PERCENT, pageUnit } from "../quantities/units.js";
import { GAPS } from "./estimates.js";
import { atLines, atSlips } from "./places.js";
import { inUnit, nameOf, namesOf } from "./values.js";

/** @import { Method, Warning } from "../api/types.js" */
/** @import { Unit } from "../quantities/units.js" */

/**
 * A warning in words. `gist` is the same for warnings that say the same of a point and of a curve.
 * @typedef {object} WarningWords
 * @property {string} code
 * @property {string} text
 * @property {string} gist
 * @property {Method[]} methods those it names
 */

/**
 * A number with its range, in the units of the page; a bound that is not there is null.
 * @typedef {{ value: string, lower: string | null, upper: string | null, isBelow: boolean, isAbove: boolean }} Shown
 */

const SHOWN_DIGITS = 4;

/** @param {{ quantity?: string, unit?: string }} figure */
const unitOf = ({ quantity: name, unit }) => (unit === undefined ? undefined : name === "slip" ? PERCENT : pageUnit(unit));

/**
 * @param {number} value (SI)
 * @param {Unit} unit
 */
const shown = (value, unit) => inUnit(value, unit, SHOWN_DIGITS).replace("-", "\u2212");

/**
 * The value that a warning is about; null where it has none with a unit.
 * @param {Warning} warning
 * @returns {Shown | null}
 */
function measured(warning) {
  const { value, range } = warning;
  const unit = unitOf(warning);
  if (value === undefined || !range || !unit) return null;
  const { lower, upper } = range;
  /** @param {number | null | undefined} bound */
  const text = (bound) => (typeof bound === "number" ? shown(bound, unit) : null);
  return {
    value: shown(value, unit), lower: text(lower), upper: text(upper),
    isBelow: typeof lower === "number" && value < lower, isAbove: typeof upper === "number" && value > upper,
  };
}

/**
 * A value of the wheel or the soil that the catalogue does not come near, or one out of the range that a law was tested in.
 * @param {Warning} warning
 */
function rangeFinding(warning) {
  const { code, quantity: name = "", varies, range, finding } = warning;
  const said = measured(warning);
  const end = said?.isBelow ? said.lower : said?.upper;
  if (!said || !(said.isBelow || said.isAbove)) return finding;
  const is = `${PARAMETERS[name] ? nameOf(name) : name} is ${said.value}`;
  if (code === "outside_catalogue") return `${is}, far ${said.isBelow ? "below the smallest" : "above the largest"} value of the catalogue, ${end}.`;
  return `${is}${varies ? " at worst" : ""}, ${said.isBelow ? "below" : "above"} ${end} (${range?.source}).`;
}

/** @param {Shown} said */
function demandIn({ lower, upper }) {
  if (lower !== null && upper !== null) return `has to be between ${lower} and ${upper}`;
  return upper !== null ? `may be at most ${upper}` : `has to be above ${lower}`;
}

/**
 * Why the model has no answer; null where that is no number out of its range.
 * @param {Warning} warning
 */
function reasonIn(warning) {
  const said = measured(warning);
  if (!said || (said.lower === null && said.upper === null)) return null;
  const further = (warning.figures ?? []).flatMap((figure) => {
    const unit = unitOf(figure);
    return unit ? [`, at a ${figure.quantity} of ${shown(figure.value, unit)}`] : [];
  });
  return `the ${warning.quantity} is ${said.value} and ${demandIn(said)}${further.join("")}`;
}

/**
 * Why points have no solution.
 * @param {Warning} warning
 */
function unsolvedText(warning) {
  const { pointer = "", count = 1, finding, advice } = warning;
  const reason = reasonIn(warning);
  const label = fieldAt(pointer)?.label;
  const [first, points] = count > 1 ? [". The first has none", "these points"] : [",", "this point"];
  const said = reason ? `no solution${first} because ${reason}.` : finding;
  return `${said} ${label ? `Change “${label}”, or leave ${points} out.` : advice}`;
}

/**
 * What a warning about operating points says.
 * @param {Warning} warning
 */
const pointText = (warning) => (warning.code === "no_solution" ? unsolvedText(warning) : `${rangeFinding(warning)} ${warning.advice}`);

/**
 * @param {string} place
 * @param {string} text
 */
const placed = (place, text) => capitalised(place ? `${place}: ${text}` : text);

/**
 * @param {Warning} warning
 * @param {string} [place]
 * @returns {WarningWords}
 */
function worded(warning, place = "") {
  const { code, series = [] } = warning;
  const text = pointText(warning);
  return { code, text: placed(place, text), gist: `${code} ${capitalised(text)}`, methods: /** @type {Method[]} */ (series) };
}

/**
 * A warning about a single result.
 * @param {Warning} warning
 */
export const resultWarning = (warning) => worded(warning);

/**
 * A warning about points of a sweep.
 * @param {Warning} warning
 * @param {readonly number[]} slips of the rows
 */
export const sweepWarning = (warning, slips) => worded(warning, atSlips(warning, slips));

/**
 * A warning about predictions, with the names that the charts give the series.
 * @param {Warning} warning
 * @param {Record<string, string>} names of the series
 * @param {readonly number[]} slips of the rows
 */
export function predictionWarning(warning, names, slips) {
  const series = (warning.series ?? []).map((name) => names[name] ?? name).join("; ");
  return placed([series, atSlips(warning, slips)].filter(Boolean).join(", "), pointText(warning));
}

/**
 * Values of a track that the API does not take.
 * @param {Warning} warning
 */
function refusedText(warning) {
  const { code, quantity: name = "", finding, advice } = warning;
  const said = measured(warning);
  if (said === null || said.lower === null) return `${finding} ${advice}`;
  const least = code === "out_of_range" ? `greater than ${said.lower}` : `${said.lower} or more`;
  const most = said.upper === null ? "" : ` and at most ${said.upper}`;
  return `no result, because the ${nameOf(name)} has to be ${least}${most}; the first is ${said.value}. Check the unit of its column.`;
}

/**
 * Samples of a track without a pull by the coupled form.
 * @param {Warning} warning
 */
function notCoupledText(warning) {
  const reason = reasonIn(warning);
  const said = reason ? `no pull by the coupled form, because ${reason}.` : warning.finding;
  return `${said} ${warning.pointer === "/normal_load_n" ? "Choose “Normal load” at the operating point." : warning.advice}`;
}

/**
 * @param {Warning} warning
 * @param {string} lacking
 */
const missingText = ({ names = [], finding, advice }, lacking) =>
  `${names.length ? `${lacking}, because ${namesOf(names)} ${names.length > 1 ? "are" : "is"} missing.` : finding} ${advice}`;

/** @param {Warning} warning */
function trackText(warning) {
  switch (warning.code) {
    case "out_of_range":
    case "slip_out_of_range": return refusedText(warning);
    case "missing_value": return missingText(warning, "no result");
    case "missing_torque":
    case "missing_load": return missingText(warning, "no pull by the coupled form");
    case "not_coupled": return notCoupledText(warning);
    default: return pointText(warning);
  }
}

/**
 * A warning about samples of a track.
 * @param {Warning} warning
 * @param {readonly number[]} lines of the rows
 */
export const trackWarning = (warning, lines) => placed(atLines(warning, lines), trackText(warning));

/**
 * An estimate that no soil comes near.
 * @param {Warning} warning
 * @param {string} law of pressure and sinkage
 */
function implausibleText({ quantity: name = "", value = 0, range }, law) {
  const field = fieldOf(name, law);
  const is = `${field.label} is ${valueText(field, value)}`;
  if (typeof range?.lower !== "number") return `${is}, which no soil has. Check the units of the columns.`;
  const most = typeof range.upper === "number" ? `to ${valueText(field, range.upper)} in size` : "or more";
  return `${is}, where soils of the catalogue have ${valueText(field, range.lower)} ${most}. Check the units of the columns.`;
}

/**
 * What holds of an estimate or a fitted column; null where the data do not tell.
 * @param {Warning} warning
 * @param {string} law of pressure and sinkage
 */
function fitFinding({ code, quantity: name = "", value, end, figures = [], names = [] }, law) {
  if (GAPS[code] && names.length) return `${GAPS[code]}, so only the assumed shape of the stresses determines ${namesOf(names)}.`;
  if (value === undefined) return null;
  if (code === "at_bound" && PARAMETERS[name] && end) {
    const field = fieldOf(name, law);
    return `${field.label} lies at its ${end} bound ${valueText(field, value)}, which decides its value.`;
  }
  if (code === "column_missed" && MEASURED[name]) {
    const [share] = figures;
    return `${MEASURED[name].label} is off by ${quantity(name, value)} (rms)${share ? `, ${percent(100 * share.value)} of its size` : ""}.`;
  }
  return null;
}

/**
 * @param {Warning} warning
 * @param {string} law of pressure and sinkage
 */
function fitText(warning, law) {
  const { code, quantity: name = "", value, names = [] } = warning;
  if (code === "implausible_estimate" && PARAMETERS[name] && value !== undefined) return implausibleText(warning, law);
  if (code === "may_be_the_interface" && names.length) {
    return `the wheel has no lugs, so that ${namesOf(names)} may belong to the interface of rim and soil. The soil by itself is stronger and shears over a longer way. Use the values for wheels like this one.`;
  }
  if (code === "not_identifiable" && names.length) {
    return `the data do not determine ${namesOf(names)}. Hold ${names.length > 1 ? "one of them" : "it"} fixed or measure under other conditions; the table says why.`;
  }
  if (code === "law_replaced") {
    return `the ${nameOf("k_s")} is fitted, so the direct law replaces that of the preset and keeps its exponents. Tick ${namesOf(["k_c", "k_phi"])} instead to keep Bekker's law.`;
  }
  return `${fitFinding(warning, law) ?? rangeFinding(warning)} ${warning.advice}`;
}

/**
 * A warning about a fit.
 * @param {Warning} warning
 * @param {string} law of pressure and sinkage
 */
export const fitWarning = (warning, law) => capitalised(fitText(warning, law));
