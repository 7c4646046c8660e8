// From measurements to a soil: what is to be found, the service's search, and what it found.

import { faultsOfProblem } from "./answers.js";
import { Problem, identify } from "./api.js";
import { MEASURED } from "./columns.js";
import { html, sentenceHtml, symbolHtml } from "./elements.js";
import { FIELDS } from "./fields.js";
import { METHOD_NAMES, quantity, significant, withUnit } from "./format.js";
import { identifyBody } from "./settings.js";
import { worded } from "./wording.js";

const SHOWN_DIGITS = 4;
const NUMBER = String.raw`-?\d+(?:\.\d+)?(?:e[+-]?\d+)?`;

const fieldNamed = (name) => FIELDS.find((field) => field.name === name);

/** What can be found, by the API's name, with the field of the page that has its name and unit. */
const PARAMETERS = {
  friction_angle_rad: { field: fieldNamed("friction_angle"), usual: true },
  cohesion_pa: { field: fieldNamed("cohesion") },
  shear_modulus_m: { field: fieldNamed("shear_modulus"), usual: true },
  k_s: { field: fieldNamed("k_s"), usual: true },
  n0: { field: fieldNamed("n0"), usual: true },
  n1: { field: fieldNamed("n1") },
  k_c: { field: fieldNamed("bekker_k_c") },
  k_phi: { field: fieldNamed("bekker_k_phi") },
  c1: { field: fieldNamed("c1") },
  c2: { field: fieldNamed("c2") },
};

const byId = (id) => document.getElementById(id);
const REECE = { k_c: fieldNamed("reece_k_c"), k_phi: fieldNamed("reece_k_phi") };

/** Under one name, the moduli of two laws have different units. */
const fieldOf = (parameter, law) => (law === "reece" && REECE[parameter]) || PARAMETERS[parameter].field;

function shown({ unit }, value) {
  const text = significant(unit.fromSi(value), SHOWN_DIGITS);
  return unit.text === "°" ? `${text}°` : withUnit(text, unit.text);
}
const labelled = ({ label, symbol }) => [label, " ", html("i", {}, ...symbolHtml(symbol))];

/** The API's names as the page has them. */
const named = (text) => text.replace(/\b[a-z]\w*\b/g, (word) => PARAMETERS[word]?.field.label.toLowerCase() ?? MEASURED[word]?.label.toLowerCase() ?? word);

/** Numbers in these sentences are the parameter's own, in SI; the interval has a column of its own. */
function identifiabilityOf(identifiability, field) {
  const inUnit = (whole, before, number, after) => `${before}${shown(field, Number(number))}${after}`;
  return named(identifiability.replace(/^determined to ± \S+ \(95 %\)$/, "determined")
    .replace(new RegExp(`(± )(${NUMBER})( \\()`), inUnit)
    .replace(new RegExp(`(: )(${NUMBER})( explains)`), inUnit));
}

const AT_BOUND = new RegExp(`^(\\w+)( lies at its \\w+ bound )(${NUMBER})$`);

/** A bound is told as a bare number, in SI. */
function warningText(detail, law) {
  const inUnit = (_, parameter, words, number) => `${parameter}${words}${shown(fieldOf(parameter, law), Number(number))}`;
  return named(worded(detail.replace(AT_BOUND, inUnit)));
}

function estimateRow({ parameter, value, interval_95: interval, identifiability }, law) {
  const field = fieldOf(parameter, law);
  const ends = interval ? interval.map((end) => shown(field, end)).join(" to ") : "–";
  return html("tr", { "data-parameter": parameter },
    html("th", { scope: "row" }, ...labelled(field)),
    html("td", { "data-estimate": parameter, "data-value": value }, shown(field, value)),
    html("td", {}, ends),
    html("td", { class: "words" }, identifiabilityOf(identifiability, field)));
}

const resultTable = ({ estimates, soil }) => html("table", {},
  html("thead", {}, html("tr", {}, ...["Parameter", "Estimate", "95 % interval", "Do the data determine it?"].map((text) => html("th", { scope: "col" }, text)))),
  html("tbody", {}, ...estimates.map((estimate) => estimateRow(estimate, soil.pressure_sinkage.law))));

function summary({ method, converged, identifiable, rmse }, count) {
  const errors = Object.entries(rmse).map(([name, value]) => `${MEASURED[name].label.toLowerCase()} ${quantity(name, value)}`).join(", ");
  return `Fitted to ${count} rows by ${METHOD_NAMES[method].toLowerCase()}. ${converged ? "The search found a minimum" : "The search ended early"}, and the data ${
    identifiable ? "determine" : "do not determine"} every parameter. Errors (rms): ${errors}.`;
}

/** Where a fault of the request lies, as a person has put it. */
function placeOf(pointer, { fit, lines }) {
  const [head, name, index] = pointer.slice(1).split("/");
  if (head === "fit" && name !== undefined) return PARAMETERS[fit[Number(name)]]?.field.label ?? "What to find";
  if (head === "data" && MEASURED[name]) return index === undefined ? MEASURED[name].label : `Line ${lines[Number(index)]} of the file, ${MEASURED[name].label.toLowerCase()}`;
  if (head === "data") return "The measurements";
  if (head === "fit") return "What to find";
  return FIELDS.find((field) => field.pointer === pointer)?.label ?? { wheel: "Wheel", soil: "Soil", contact: "Contact" }[head] ?? null;
}

/** `samples()` are the measurements with the lines they stand in; `onSoil(reply)` takes what was found. */
export function connectIdentification(form, { settings, samples, onSoil }) {
  const status = byId("fit-status");
  let search = null;
  let found = null;

  byId("fit-parameters").append(...Object.entries(PARAMETERS).map(([name, { field, usual }]) =>
    html("label", { class: "tick" }, html("input", { type: "checkbox", "data-fit": name, checked: Boolean(usual) }), html("span", {}, ...labelled(field)))));

  function forget() {
    search?.abort();
    found = null;
    form.dataset.state = "idle";
    status.textContent = "";
    for (const id of ["fit-result", "fit-warnings", "use-soil"]) byId(id).hidden = true;
  }

  function showProgress(isFitting) {
    for (const id of ["cancel-fit", "fit-progress", "fit-elapsed"]) byId(id).hidden = !isFitting;
    byId("fit-soil").disabled = isFitting;
  }

  function showFound(reply, count) {
    found = reply;
    status.textContent = summary(reply, count);
    byId("fit-result").replaceChildren(resultTable(reply));
    byId("fit-warnings").replaceChildren(...reply.warnings.map(({ code, detail }) =>
      html("li", { "data-warning": code }, ...sentenceHtml(warningText(detail, reply.soil.pressure_sinkage.law)))));
    byId("fit-warnings").hidden = !reply.warnings.length;
    for (const id of ["fit-result", "use-soil"]) byId(id).hidden = false;
    form.dataset.state = "fitted";
  }

  function showFailure(error, asked) {
    form.dataset.state = "failed";
    const sentences = error instanceof Problem
      ? faultsOfProblem(error).map(({ pointer, detail }) => [placeOf(pointer, asked), named(worded(detail))].filter(Boolean).join(": "))
      : [error.message];
    status.replaceChildren(...sentences.map((sentence) => html("span", { class: "fault" }, ...sentenceHtml(sentence), " ")));
  }

  async function run() {
    forget();
    const fit = [...form.querySelectorAll("[data-fit]:checked")].map((box) => box.dataset.fit);
    const now = settings();
    if (!fit.length || now.unreadable.length) {
      status.textContent = fit.length ? "First put right the inputs that this page marks." : "Choose at least one parameter to find.";
      form.dataset.state = "failed";
      return;
    }
    const { data, lines } = samples();
    const mine = new AbortController();
    search = mine;
    const started = performance.now();
    const tell = () => { byId("fit-elapsed").textContent = `${Math.round((performance.now() - started) / 1000)} s`; };
    const clock = setInterval(tell, 1000);
    tell();
    status.textContent = `The service looks for ${fit.length} parameters in ${lines.length} rows…`;
    form.dataset.state = "fitting";
    showProgress(true);
    try {
      const reply = await identify(identifyBody(now, fit, data), mine.signal);
      if (!mine.signal.aborted) showFound(reply, lines.length);
    } catch (error) {
      if (!mine.signal.aborted) showFailure(error, { fit, lines });
    } finally {
      clearInterval(clock);
      if (search === mine) {
        search = null;
        showProgress(false);
      }
    }
  }

  form.addEventListener("submit", (event) => {
    event.preventDefault();
    run();
  });
  byId("cancel-fit").addEventListener("click", () => {
    forget();
    status.textContent = "Cancelled.";
    byId("fit-soil").disabled = false;
    byId("fit-soil").focus();
  });
  byId("use-soil").addEventListener("click", () => {
    onSoil(found);
    status.textContent = "The soil that was found is now the soil of this page. The back button takes it back.";
  });

  return {
    /** Measurements that are others than before have not been fitted to. */
    show(isReady) {
      forget();
      form.hidden = !isReady;
    },
  };
}
