// The wheel when it is towed, Bekker's estimates for it, and the pull that follows from a measured torque: a table each, with what the
// service says of it.

import { html } from "../dom/elements.js";
import { find } from "../dom/find.js";
import { rowHead } from "../dom/tables.js";
import { symbolHtml } from "../dom/text.js";
import { fieldAt } from "../quantities/fields.js";
import { QUANTITIES, quantity } from "../quantities/results.js";
import { showWarnings } from "../results/warnings.js";
import { faultSentence } from "../wording/faults.js";
import { furtherWarning } from "../wording/further.js";

/** @import { Warning } from "../api/types.js" */
/** @import { FurtherOutcome } from "../rounds/further.js" */
/** @import { Outcome } from "../rounds/outcome.js" */
/** @import { Settings } from "../state/settings.js" */

/** @typedef {ReturnType<typeof createFurtherView>} FurtherView */

/** @typedef {{ name: string, symbol: string, label?: string }} Row */

/**
 * @typedef {object} Block
 * @property {"towed" | "resistances" | "coupled"} key
 * @property {string} caption
 * @property {Row[]} rows
 */

/** @type {Block[]} */
const BLOCKS = [
  { key: "towed", caption: "Towed, rolling freely", rows: [
    { name: "towing_resistance_n", symbol: "−F_x" }, { name: "slip", symbol: "s", label: "Slip (skid)" }, { name: "sinkage_m", symbol: "z" }] },
  { key: "resistances", caption: "Bekker’s estimates", rows: [
    { name: "rigid_wheel_sinkage_m", symbol: "z" }, { name: "compaction_resistance_n", symbol: "R_c" },
    { name: "bulldozing_resistance_n", symbol: "R_b" }, { name: "thrust_n", symbol: "H" }] },
  { key: "coupled", caption: "From the measured torque", rows: [{ name: "longitudinal_force_n", symbol: "F_x" }, { name: "torque_n_m", symbol: "T" }] },
];
/** What the page says with its reasons among what the results rest on. */
const SAID = ["assumed_values"];

/** @param {Block} block */
const blockElement = ({ key, caption, rows }) => html("div", { class: "further-block", "data-further": key },
  html("div", { class: "comparison" },
    html("table", {}, html("caption", {}, caption), html("tbody", {}, ...rows.map(({ name, symbol, label }) => html("tr", {},
      rowHead(label ?? QUANTITIES[name].name, " ", html("i", {}, ...symbolHtml(symbol))),
      html("td", { "data-further-result": name }, "–")))))),
  html("p", { class: "figure-note", hidden: true }),
  html("p", { class: "fault", hidden: true }),
  html("ul", { class: "warnings", "aria-label": `Warnings: ${caption.toLowerCase()}`, hidden: true }));

/**
 * @param {HTMLElement} element
 * @param {string} text
 */
function tell(element, text) {
  element.textContent = text;
  element.hidden = !text;
}

/**
 * Under which load, and where it and the sinkage come from.
 * @param {Settings} settings
 * @param {FurtherOutcome} outcome
 */
function basisText({ given }, { load, sinkage }) {
  const from = given.normal_load_n === undefined ? "the normal force of the operating point" : "the load of the operating point";
  return `Under ${quantity("normal_load_n", load)}, ${from}. The torque goes with its slip and its sinkage of ${quantity("sinkage_m", sinkage)}.`;
}

/** @param {Settings} settings @returns {Record<Block["key"], string>} */
const notesOf = ({ method, further }) => ({
  towed: method === "resistive_force" ? "By resistive force." : "By quadrature, its shear in two zones.",
  resistances: "",
  coupled: further?.torque === undefined ? "Type the measured torque at the operating point. The pull then needs no soil." : "Needs no soil.",
});

/** @param {HTMLElement} section */
export function createFurtherView(section) {
  section.replaceChildren(
    html("div", { class: "section-heading" }, html("h2", { id: "further-heading" }, "Towing, resistances, pull from torque"), html("p", { id: "further-basis" })),
    html("div", { class: "further-blocks" }, ...BLOCKS.map(blockElement)));

  /**
   * @param {Block} block
   * @param {Outcome<object> | null} outcome null where it was not asked for
   * @param {{ note: string, said: string[] }} words
   */
  function showBlock({ key, rows }, outcome, { note, said }) {
    const element = find(section, `[data-further="${key}"]`);
    const values = /** @type {Record<string, any>} */ (outcome?.answer ?? {});
    for (const { name } of rows) {
      const cell = find(element, `[data-further-result="${name}"]`);
      cell.textContent = quantity(name, values[name]);
      cell.dataset.value = String(values[name] ?? "");
    }
    tell(find(element, ".figure-note"), note);
    tell(find(element, ".fault"), (outcome?.problem?.faults ?? []).map((fault) => faultSentence(fault, fieldAt(fault.pointer)?.label ?? null)).join(" "));
    const warnings = /** @type {Warning[]} */ (values.warnings ?? []);
    showWarnings(find(element, ".warnings"), warnings.filter(({ code }) => ![...said, ...SAID].includes(code)).map(furtherWarning));
  }

  return {
    /**
     * @param {Settings} settings
     * @param {FurtherOutcome} outcome
     * @param {string[]} said codes of the warnings about the operating point
     */
    show(settings, outcome, said) {
      find(section, "#further-basis").textContent = basisText(settings, outcome);
      const notes = notesOf(settings);
      for (const block of BLOCKS) showBlock(block, outcome[block.key], { note: notes[block.key], said });
    },
  };
}
