// From measurements to a soil: what is to be found, and the service's search for it.

import { identify } from "../api/endpoints.js";
import { fieldAt } from "../quantities/fields.js";
import { MEASURED } from "../quantities/measured.js";
import { PARAMETERS, mismatch } from "../quantities/parameters.js";
import { UNREADABLE_INPUTS, createSearch, onSubmit } from "../search/search.js";
import { identifyBody } from "../state/measured-bodies.js";
import { fillFitForm } from "./form.js";
import { showFit } from "./result.js";

/** @import { FitData, FitParameter, Identification } from "../api/types.js" */
/** @import { Settings } from "../state/settings.js" */
/** @import { SlipPoints } from "../table/samples.js" */

/**
 * @typedef {object} IdentificationEvents
 * @property {() => Settings} settings what is on the page
 * @property {() => SlipPoints | null} points
 * @property {(found: Identification, data: FitData) => void} onSoil takes what was found, and what it was fitted to
 */

/** @type {Record<string, string>} */
const PARTS = { wheel: "Wheel", soil: "Soil", contact: "Contact", data: "The measurements", fit: "What to find" };

/**
 * What a fault of the request is about: a value of the file by its line, a parameter, or an input.
 * @param {string} pointer
 * @param {FitParameter[]} fit
 * @param {number[]} lines
 */
function subjectOf(pointer, fit, lines) {
  const [head, name, index] = pointer.slice(1).split("/");
  const measured = head === "data" ? MEASURED[name] : undefined;
  if (measured) return index === undefined ? measured.label : `Line ${lines[Number(index)]} of the file, ${measured.label.toLowerCase()}`;
  const parameter = head === "fit" ? PARAMETERS[fit[Number(name)]] : undefined;
  return parameter?.field.label ?? fieldAt(pointer)?.label ?? PARTS[head] ?? null;
}

/**
 * Why a search cannot begin; null where it can.
 * @param {FitParameter[]} fit
 * @param {Settings} settings
 */
function obstacle(fit, { unreadable, law }) {
  if (!fit.length) return "Choose at least one parameter to find.";
  if (unreadable.length) return UNREADABLE_INPUTS;
  return mismatch(fit, law);
}

/**
 * @param {HTMLElement} form
 * @param {IdentificationEvents} events
 */
export function connectIdentification(form, { settings, points, onSoil }) {
  const parts = fillFitForm(form);
  const { boxes, controls, status, result, residuals, warnings, use } = parts;
  const search = createSearch({ form, running: "fitting", done: "fitted", status, results: [result, residuals, warnings, use], controls });
  /** @type {{ answer: Identification, data: FitData } | null} */
  let found = null;

  onSubmit(form, () => {
    search.forget();
    const fit = /** @type {FitParameter[]} */ (boxes.filter(({ checked }) => checked).map(({ dataset }) => dataset.fit));
    const now = settings();
    const wrong = obstacle(fit, now);
    const measured = points();
    if (wrong || !measured) {
      search.fail(wrong ?? "There are no measurements to fit to.");
      return;
    }
    const { data, lines } = measured;
    search.run({
      text: `Fitting ${fit.length} ${fit.length === 1 ? "parameter" : "parameters"} to ${lines.length} rows…`,
      ask: (signal) => identify(identifyBody(now, fit, data), signal),
      onAnswer(answer) {
        found = { answer, data };
        showFit(parts, answer, { fit, lines, law: now.law });
        use.hidden = false;
      },
      subjectOf: ({ pointer }) => subjectOf(pointer, fit, lines),
    });
  });

  use.addEventListener("click", () => {
    if (!found) return;
    onSoil(found.answer, found.data);
    status.textContent = "The page now uses the soil that was found. The back button undoes this.";
  });

  return {
    /**
     * Other measurements than before have not been fitted to.
     * @param {boolean} isReady
     */
    show(isReady) {
      search.forget();
      form.hidden = !isReady;
    },
  };
}
