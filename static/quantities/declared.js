// A parameter of the service's tables as a field of the page: label, symbol, unit, bounds and default come from the table.

import { model } from "../api/model.js";
import { pageUnit } from "./units.js";

/** @import { ParameterNote } from "../api/types.js" */
/** @import { Field, Preset, SliderRange, Substitutes } from "./fields.js" */

/**
 * What the page adds to a parameter.
 * @typedef {object} Dress
 * @property {string} [key] in the address
 * @property {string} [name] of the input
 * @property {[number, number, number]} [slider] least, most and step in the unit of the page
 * @property {number} [start] the value (SI) that neither the catalogue nor the table has
 * @property {string} [blank] what an empty box means
 */

/** The first words of a meaning, up to what it adds. @param {string} meaning */
const labelOf = (meaning) => meaning.split(/[;:,.](?:\s|$)/)[0].replaceAll("'", "’");

/** A letter with a number is a letter with a subscript. @param {string} symbol */
const symbolOf = (symbol) => symbol.replace(/^(\p{L})(\d)$/u, "$1_$2").replaceAll("'", "′");

/**
 * The usual values, as far as the bounds allow them.
 * @param {ParameterNote} note
 * @param {[number, number, number]} usual
 * @returns {SliderRange}
 */
function sliderOf({ unit, minimum, maximum, exclusive_maximum: limit }, [min, max, step]) {
  const { fromSi } = pageUnit(unit);
  return { min: Math.max(min, fromSi(minimum)), max: Math.min(max, fromSi(maximum ?? limit ?? Infinity)), step };
}

/**
 * @param {ParameterNote} note
 * @param {string} group
 * @param {Dress & { key: string, name: string }} dress
 * @param {(preset: Preset) => number | null | undefined} known the catalogue's value
 * @returns {Field}
 */
export function asField(note, group, { key, name, slider, start, blank }, known) {
  const { pointer, symbol, unit, meaning, minimum, required, default: usual } = note;
  const range = slider && sliderOf(note, slider);
  /** Moduli of another law have the same place but other units. @param {Substitutes} substitutes */
  const substitute = (substitutes) => {
    const found = substitutes.get(pointer);
    return found?.unit === unit ? found : undefined;
  };
  return {
    group,
    key,
    name,
    pointer,
    label: labelOf(meaning),
    symbol: symbolOf(symbol),
    unit: pageUnit(unit),
    substitute,
    base: (preset) => known(preset) ?? substitute(preset.assumed)?.value ?? usual ?? start,
    signed: minimum < 0,
    ...(range && { slider: () => range }),
    ...(!required && usual === undefined && { blank: blank ?? "not given" }),
  };
}

/**
 * A parameter that is no law's.
 * @param {string} pointer
 */
export function noteAt(pointer) {
  const note = model().parameters.find((each) => each.pointer === pointer);
  if (!note) throw new Error(`the model has no parameter ${pointer}`);
  return note;
}
