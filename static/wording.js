// What the API says, in the units of the page.

import { FIELDS } from "./fields.js";
import { degrees, fixed } from "./format.js";

const SHOWN_DIGITS = 6;
const NUMBER = String.raw`(?<![\p{L}\p{N}_.^])[-−]?\d+(?:\.\d+)?(?:e[+-]?\d+)?`;
const BARE_NUMBER = new RegExp(`${NUMBER}(?![\\p{L}\\p{N}_])`, "gu");

/** The units in which the API's sentences speak and the page does not. */
const UNITS = {
  rad: { text: "°", fromSi: degrees },
  "Pa/m^N": { text: "kPa/mᴺ", fromSi: (value) => value / 1000 },
  Pa: { text: "kPa", fromSi: (value) => value / 1000 },
  m: { text: "mm", fromSi: (value) => value * 1000 },
};
const WITH_UNIT = new RegExp(`(${NUMBER}) (rad|Pa/m\\^N|Pa|m)(?![\\p{L}\\p{N}/^·])`, "gu");

function inUnit(number, { text, fromSi }) {
  const shown = String(Number(fromSi(Number(number.replace("−", "-"))).toPrecision(SHOWN_DIGITS)));
  return text === "°" ? `${shown}°` : `${shown}\u00a0${text}`;
}

/** Rewrites what stands outside backticks: names are quoted as they are. */
const outsideQuotes = (text, rewrite) => text.split(/(`[^`]*`)/).map((part) => (part.startsWith("`") ? part : rewrite(part))).join("");

export function worded(detail) {
  return outsideQuotes(detail, (part) => part.replace(WITH_UNIT, (_, number, unit) => inUnit(number, UNITS[unit])));
}

const RANGE = new RegExp(`^must be from (${NUMBER}) to (${NUMBER}), not (${NUMBER})$`, "u");

/** Metres typed where millimetres are asked for. */
function metresHint(detail, unit) {
  const [from, to, typed] = (RANGE.exec(detail) ?? []).slice(1).map(Number);
  const metres = unit.fromSi(typed);
  return unit.text === "mm" && metres >= from && metres <= to ? `; ${metres}\u00a0m are ${inUnit(String(metres), unit)}` : "";
}

/**
 * A fault at a field: numbers without a unit are the field's own, so a bound is told in the unit the field shows. What the API
 * advises after it is about its own unit, which the field does not show.
 */
export function wordedFault(told, field) {
  const unit = field?.unit;
  if (!unit?.si) return worded(told);
  const detail = /^must\b/.test(told) ? told.split("; ")[0] : told;
  const text = worded(detail);
  if (text !== detail) return text;
  if (/\bmust\b/.test(detail)) {
    return outsideQuotes(detail, (part) => part.replace(BARE_NUMBER, (number) => inUnit(number, unit))) + metresHint(detail, unit);
  }
  let hasNumber = false;
  outsideQuotes(detail, (part) => {
    hasNumber ||= part.search(BARE_NUMBER) >= 0;
    return part;
  });
  return hasNumber ? `${detail} (${unit.si})` : detail;
}

/** A fault with what it is about before it: some begin with the verb. */
export const faultOf = (subject, text) => (subject ? `${subject}${/^(is|are|must|has|have|needs?|does|cannot|lies) /.test(text) ? "" : ":"} ${text}` : text);

/** A warning about points of a sweep: they are told by their slips, as the charts have no rows, and fields by their labels. */
export function wordedWarning(detail, slips) {
  const percent = (slip) => `${fixed(slip * 100, 0)}\u00a0%`;
  const label = (pointer) => FIELDS.find((field) => field.pointer === pointer)?.label.toLowerCase() ?? pointer;
  return worded(detail)
    .replace(/at ind(?:ex|ices) ([\d–, ]+)/, (whole, rows) =>
      (slips ? `at slip ${rows.replace(/\d+/g, (row) => percent(slips[row])).replaceAll("–", " to ")}` : whole))
    .replace(/at slip (-?\d+\.\d+), field (\/[\w/]+):/, (_, slip, pointer) => `at ${percent(Number(slip))}, ${label(pointer)}:`);
}
