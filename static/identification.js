// From measurements to a soil: what is to be found, and the service's search for it.

import { faultsOfProblem } from "./answers.js";
import { Problem, identify } from "./api.js";
import { MEASURED } from "./columns.js";
import { html, sentenceHtml } from "./elements.js";
import { FIELDS } from "./fields.js";
import { showFit } from "./fit-result.js";
import { identifyBody } from "./measured-requests.js";
import { PARAMETERS, labelled, mismatch, named } from "./parameters.js";
import { createSearch } from "./search.js";
import { faultOf, worded } from "./wording.js";

const byId = (id) => document.getElementById(id);

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
  const search = createSearch({ start: "fit-soil", cancel: "cancel-fit", progress: "fit-progress", elapsed: "fit-elapsed" });
  let found = null;

  byId("fit-parameters").append(...Object.entries(PARAMETERS).map(([name, { field, usual }]) =>
    html("label", { class: "tick" }, html("input", { type: "checkbox", "data-fit": name, checked: Boolean(usual) }), html("span", {}, ...labelled(field)))));

  function forget() {
    search.cancel();
    found = null;
    form.dataset.state = "idle";
    status.textContent = "";
    for (const id of ["fit-result", "fit-residuals", "fit-warnings", "use-soil"]) byId(id).hidden = true;
  }

  function tellFailure(sentences) {
    form.dataset.state = "failed";
    status.replaceChildren(...sentences.map((sentence) => html("span", { class: "fault" }, ...sentenceHtml(sentence), " ")));
  }

  function run() {
    forget();
    const fit = [...form.querySelectorAll("[data-fit]:checked")].map((box) => box.dataset.fit);
    const now = settings();
    const wrong = (!fit.length && "Choose at least one parameter to find.")
      || (now.unreadable.length && "First put right the inputs that this page marks.")
      || mismatch(fit, now.law);
    if (wrong) {
      tellFailure([wrong]);
      return;
    }
    const { data, lines } = samples();
    status.textContent = `The service looks for ${fit.length} parameters in ${lines.length} rows…`;
    form.dataset.state = "fitting";
    search.run((signal) => identify(identifyBody(now, fit, data), signal), {
      onAnswer(reply) {
        found = reply;
        showFit(reply, { fit, lines, law: now.law });
        byId("use-soil").hidden = false;
        form.dataset.state = "fitted";
      },
      onError: (error) => tellFailure(error instanceof Problem
        ? faultsOfProblem(error).map(({ pointer, detail }) => faultOf(placeOf(pointer, { fit, lines }), named(worded(detail)))) : [error.message]),
    });
  }

  form.addEventListener("submit", (event) => {
    event.preventDefault();
    run();
  });
  byId("cancel-fit").addEventListener("click", () => {
    forget();
    status.textContent = "Cancelled.";
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
