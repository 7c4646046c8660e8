// Numbers and units as people read them. Everything inside the page stays in the API's SI units; only text is converted.

const MINUS = "\u2212";
const THIN = "\u202f";
const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** How each result of the API is shown: `factor` takes SI to the shown unit. */
export const QUANTITIES = {
  longitudinal_force_n: { name: "Drawbar pull", unit: "N", factor: 1 },
  normal_force_n: { name: "Normal force", unit: "N", factor: 1 },
  torque_n_m: { name: "Torque", unit: "N·m", factor: 1 },
  sinkage_m: { name: "Sinkage", unit: "mm", factor: 1e3 },
  slip: { name: "Slip", unit: "%", factor: 100 },
  drawbar_coefficient: { name: "Drawbar coefficient", unit: "", factor: 1 },
  tractive_efficiency: { name: "Tractive efficiency", unit: "%", factor: 100 },
  traction_n: { name: "Traction", unit: "N", factor: 1 },
  resistance_n: { name: "Resistance", unit: "N", factor: 1 },
  normal_support_n: { name: "Normal support", unit: "N", factor: 1 },
  shear_support_n: { name: "Shear support", unit: "N", factor: 1 },
  lateral_force_n: { name: "Lateral force", unit: "N", factor: 1 },
  lateral_coefficient: { name: "Lateral coefficient", unit: "", factor: 1 },
  overturning_moment_n_m: { name: "Overturning moment", unit: "N·m", factor: 1 },
  aligning_moment_n_m: { name: "Aligning moment", unit: "N·m", factor: 1 },
  sinkage_modulus: { name: "Sinkage modulus", unit: "kPa/mᴺ", factor: 1e-3 },
  sinkage_exponent: { name: "Sinkage exponent", unit: "", factor: 1 },
  shearing_radius_m: { name: "Shearing radius", unit: "mm", factor: 1e3 },
};

export const METHOD_NAMES = { quadrature: "Quadrature", linearised: "Linearised", explicit: "Explicit" };

export const degrees = (radians) => (radians * 180) / Math.PI;

/** A decimal with a true minus sign and, from five digits on, thin spaces between thousands. */
function typeset(plain) {
  const [, sign, whole, fraction = ""] = /^(-?)(\d+)(\.\d+)?$/.exec(plain);
  const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, THIN) : whole;
  const isZero = !/[1-9]/.test(plain);
  return (sign && !isZero ? MINUS : "") + grouped + fraction;
}

export function fixed(value, decimals) {
  return typeset(value.toFixed(decimals));
}

/** At least `digits` significant digits; whole numbers keep all of theirs, extremes go to powers of ten. */
export function significant(value, digits = 3) {
  if (value === 0) return "0";
  const magnitude = Math.floor(Math.log10(Math.abs(value)));
  if (magnitude < -4 || magnitude > 5) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    const raised = String(Math.abs(exponent)).replace(/\d/g, (digit) => SUPERSCRIPTS[digit]);
    return `${typeset(mantissa)}×10${exponent < 0 ? "⁻" : ""}${raised}`;
  }
  return fixed(value, Math.max(0, digits - 1 - magnitude));
}

export function withUnit(text, unit) {
  return unit ? `${text}\u00a0${unit}` : text;
}

/** A result of the API as text, or a dash where it has none. */
export function quantity(name, value) {
  if (value === null || value === undefined) return "–";
  const { unit, factor } = QUANTITIES[name];
  return withUnit(significant(value * factor), unit);
}

/** Splits "F_x" into its letter and its subscript, for HTML and SVG alike. */
export function notation(text) {
  return text.split(/(_[\p{L}\p{N}])/u).filter(Boolean)
    .map((part) => (part.startsWith("_") ? { text: part.slice(1), subscript: true } : { text: part, subscript: false }));
}
