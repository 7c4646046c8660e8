// The words for warnings of the API. Where it holds and how far a value leaves its range are told from the data, in the units of the
// page; what that means and what to do is the API's sentence.

import { capitalised } from "../numbers/format.js";
import { fieldAt } from "../quantities/fields.js";
import { MEASURED } from "../quantities/measured.js";
import { PARAMETERS, fieldOf, valueText } from "../quantities/parameters.js";
import { quantity } from "../quantities/results.js";
import { PERCENT, beforeUnit, pageUnit } from "../quantities/units.js";
import { atLines, atSlips, withoutPlace } from "./places.js";
import { inPageUnits } from "./sentences.js";

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

const SHOWN_DIGITS = 4;

/** @param {Warning} warning */
const unitOf = ({ quantity: name, unit }) => (unit === undefined ? undefined : name === "slip" ? PERCENT : pageUnit(unit));

/**
 * @param {number} value (SI)
 * @param {Unit} unit
 */
const shown = (value, unit) => beforeUnit(String(Number(unit.fromSi(value).toPrecision(SHOWN_DIGITS))).replace("-", "\u2212"), unit);

/**
 * The text from `mark` on behind other words; as it comes where the mark is not there.
 * @param {string} text
 * @param {string} mark
 * @param {string} words
 */
function behind(text, mark, words) {
  const at = text.indexOf(mark);
  return at < 0 ? text : words + text.slice(at);
}

/**
 * Names of the API that are none of a parameter or of a quantity in the table of measurements.
 * @type {Record<string, string>}
 */
const OTHER_NAMES = { normal_load_n: "normal force", identifiability: "the table" };

/**
 * The sentence with the names that it quotes as the page has them. Names that the page does not have stay as they are.
 * @param {string} text
 */
const named = (text) => text.replace(/`([^`]*)`/g, (quoted, name) =>
  PARAMETERS[name]?.field.label.toLowerCase() ?? MEASURED[name]?.label.toLowerCase() ?? OTHER_NAMES[name] ?? quoted);

/**
 * A value of the wheel or the soil that the catalogue does not come near, or one out of the range that a law was tested in.
 * @param {Warning} warning
 */
function rangeText(warning) {
  const said = withoutPlace(warning);
  const { code, quantity: name = "", value, range } = warning;
  const unit = unitOf(warning);
  if (value === undefined || !range || !unit) return said;
  const { lower, upper, source } = range;
  const isBelow = typeof lower === "number" && value < lower;
  const end = isBelow ? lower : upper;
  if (typeof end !== "number") return said;
  const is = `${PARAMETERS[name]?.field.label.toLowerCase() ?? name} is ${shown(value, unit)}`;
  if (code === "outside_catalogue") {
    return `${is}, far ${isBelow ? "below the smallest" : "above the largest"} value of the catalogue, ${shown(end, unit)}. Check its unit.`;
  }
  // Whether the value is one of several that differ is no data of its own.
  const worst = said.includes(" at worst, ") ? " at worst" : "";
  return behind(said, ` (${source})`, `${is}${worst}, ${isBelow ? "below" : "above"} ${shown(end, unit)}`);
}

/**
 * Why points have no solution. The reason is the sentence of the fault that a single point would have: it says more than the data, such
 * as the sinkage at which the soil carries most.
 * @param {Warning} warning
 */
function unsolvedText(warning) {
  const { pointer = "" } = warning;
  const label = fieldAt(pointer)?.label;
  const said = inPageUnits(withoutPlace(warning));
  return label ? said.replaceAll(`\`${pointer}\``, `“${label}”`) : said;
}

/**
 * What a warning about operating points says.
 * @param {Warning} warning
 */
const pointText = (warning) => (warning.code === "no_solution" ? unsolvedText(warning) : rangeText(warning));

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
  const { quantity: name = "", value, range } = warning;
  const unit = unitOf(warning);
  const lower = range?.lower;
  if (value === undefined || typeof lower !== "number" || !unit) return withoutPlace(warning);
  const least = warning.code === "out_of_range" ? `greater than ${shown(lower, unit)}` : `${shown(lower, unit)} or more`;
  const most = typeof range?.upper === "number" ? ` and at most ${shown(range.upper, unit)}` : "";
  return `no result, because the ${named(`\`${name}\``)} has to be ${least}${most}; the first is ${shown(value, unit)}. Check the unit of its column.`;
}

/** @param {Warning} warning */
function trackText(warning) {
  switch (warning.code) {
    case "out_of_range":
    case "slip_out_of_range": return refusedText(warning);
    case "not_coupled":
      if (warning.pointer !== "/normal_load_n") return unsolvedText(warning);
      return "no pull by the coupled form, because a torque is measured but no load is known. Choose “Normal load” at the operating point.";
    default: return pointText(warning);
  }
}

/**
 * A warning about samples of a track.
 * @param {Warning} warning
 * @param {readonly number[]} lines of the rows
 */
export const trackWarning = (warning, lines) => named(placed(atLines(warning, lines), trackText(warning)));

/**
 * @param {Warning} warning
 * @param {string} law of pressure and sinkage
 */
function fitText(warning, law) {
  const { code, detail, quantity: name = "", value, range } = warning;
  if (value === undefined) return detail;
  if (code === "column_missed" && MEASURED[name]) return behind(detail, " (rms)", `${MEASURED[name].label} is off by ${quantity(name, value)}`);
  if (code === "outside_catalogue" || !PARAMETERS[name]) return rangeText(warning);
  const field = fieldOf(name, law);
  const is = `${field.label} is ${valueText(field, value)}`;
  switch (code) {
    case "at_bound": return behind(detail, ", which", `${field.label} lies at its bound ${valueText(field, value)}`);
    case "implausible_estimate":
      if (typeof range?.lower !== "number") return behind(detail, ", ", is);
      return `${is}, where soils of the catalogue have ${valueText(field, range.lower)} ${
        typeof range.upper === "number" ? `to ${valueText(field, range.upper)} in size` : "or more"}. Check the units of the columns.`;
    default: return detail;
  }
}

/**
 * A warning about a fit.
 * @param {Warning} warning
 * @param {string} law of pressure and sinkage
 */
export const fitWarning = (warning, law) => capitalised(named(fitText(warning, law)));
