// A person's own measurements: read from a file in the browser, drawn over the curves, and sent only to be fitted to.

import { MEASURED, choiceFrom, choiceOf, guessColumns, samplesOf } from "./columns.js";
import { html } from "./elements.js";
import { residualOf } from "./figures.js";
import { METHOD_NAMES, quantity } from "./format.js";
import { connectIdentification } from "./identification.js";
import { TableFault, parseTable } from "./table.js";

const PREVIEW_ROWS = 5;
const MOST_FAULTS = 10;
/** Far beyond the rows that the service takes; a larger file is something else. */
const MOST_BYTES = 5_000_000;

const byId = (id) => document.getElementById(id);

function columnSelect(column, heading, mapped) {
  const options = Object.entries(MEASURED).map(([key, { label, units }]) => html("optgroup", { label },
    ...units.map((unit) => html("option", { value: choiceOf({ quantity: key, unit }) }, `${label}, ${unit.text}`))));
  const select = html("select", { "data-column": column, "aria-label": `What the column ${heading} is` }, html("option", { value: "" }, "Ignore"), ...options);
  select.value = choiceOf(mapped);
  return select;
}

/** Its heading, what it is taken for, and the first cells. */
function previewTable({ columns, lines }, selects) {
  const rows = lines.slice(0, PREVIEW_ROWS).map((line, row) => html("tr", {},
    html("th", { scope: "row" }, `Line ${line}`),
    ...columns.map(({ cells }, column) => html("td", { "data-cell": `${line} ${column}` }, cells[row] || "–"))));
  return html("table", {},
    html("thead", {},
      html("tr", {}, html("td", {}), ...columns.map(({ heading, unit }) => html("th", { scope: "col" }, [heading, unit].filter(Boolean).join(", ")))),
      html("tr", {}, html("td", {}, "is"), ...selects.map((select) => html("td", {}, select)))),
    html("tbody", {}, ...rows));
}

function residualTable(measured, series) {
  const names = Object.keys(MEASURED).filter((name) => name !== "slip" && measured[name]);
  const cell = (name, { method, columns }) => {
    const { rms, count } = residualOf(name, measured, columns);
    const text = rms === null ? "no curve there" : quantity(name, rms);
    const part = rms !== null && count < measured.slip.length ? ` (${count} of ${measured.slip.length} points)` : "";
    return html("td", { "data-rms": name, "data-method": method, "data-value": rms ?? "" }, text + part);
  };
  return html("table", {},
    html("caption", {}, "Root mean square of measured minus shown curve"),
    html("thead", {}, html("tr", {}, html("th", { scope: "col" }, "Quantity"), ...series.map(({ method }) => html("th", { scope: "col" }, METHOD_NAMES[method])))),
    html("tbody", {}, ...names.map((name) => html("tr", {}, html("th", { scope: "row" }, MEASURED[name].label), ...series.map((each) => cell(name, each))))));
}

/** `settings()`: what is on the page; `onData()` tells that the measurements are others; `onSoil` takes a soil that was found. */
export function connectMeasurements(section, { settings, onData, onSoil }) {
  const input = byId("measurements-file");
  const drop = byId("measurements-drop");
  const status = byId("measurements-status");
  let table = null;
  let mapping = [];
  let samples = null;
  let series = null;
  /** A file that is still being read when the next one comes is not shown any more. */
  let latest = 0;

  const identification = connectIdentification(byId("identification"), { settings, samples: () => samples, onSoil });
  const isReady = () => samples !== null && !samples.faults.length;
  const data = () => (isReady() ? samples.data : null);

  function tellFaults(faults) {
    const list = byId("measurements-faults");
    const told = faults.slice(0, MOST_FAULTS);
    if (faults.length > told.length) told.push(`And ${faults.length - told.length} more.`);
    list.replaceChildren(...told.map((text) => html("li", {}, text)));
    list.hidden = !told.length;
  }

  function compare(shown) {
    series = shown;
    const residuals = byId("measurements-residuals");
    residuals.hidden = !isReady() || !Object.keys(samples.data).some((name) => name !== "slip");
    if (residuals.hidden) return;
    const slips = samples.data.slip;
    const outside = slips.filter((slip) => slip < shown[0].columns.slip[0]).length;
    residuals.replaceChildren(residualTable(samples.data, shown), html("p", { class: "figure-note" },
      "The curves belong to the one sinkage or load that is set on this page; the fit takes each row’s own.",
      outside ? ` ${outside} points at negative slip are left of the curves: include braking to see them.` : ""));
  }

  function take() {
    samples = samplesOf(table, mapping);
    section.dataset.state = isReady() ? "ready" : "refused";
    tellFaults(samples.faults);
    const wrong = new Set(table.faults.filter(({ column }) => mapping[column]).map(({ line, column }) => `${line} ${column}`));
    for (const cell of byId("measurements-preview").querySelectorAll("[data-cell]")) cell.classList.toggle("wrong", wrong.has(cell.dataset.cell));
    const left = samples.left ? `; ${samples.left} without a number in every chosen column are left out` : "";
    const count = samples.lines.length;
    const use = isReady() ? `${count} ${count === 1 ? "row" : "rows"} to be used${left}.` : "This table cannot be used yet.";
    status.textContent = `${use} Cells are parted by ${table.separator}, decimals by ${table.decimal}.`;
    identification.show(isReady());
    byId("measurements-residuals").hidden = !isReady();
    onData();
    if (series) compare(series);
  }

  function clear() {
    [table, samples, mapping] = [null, null, []];
    section.dataset.state = "empty";
    for (const id of ["measurements-preview", "measurements-residuals", "measurements-clear"]) byId(id).hidden = true;
    status.textContent = "";
    tellFaults([]);
    identification.show(false);
  }

  async function read(file) {
    latest += 1;
    const mine = latest;
    clear();
    onData();
    status.textContent = `Reading ${file.name}…`;
    try {
      if (file.size > MOST_BYTES) throw new TableFault(null, `The file has ${Math.round(file.size / 1e6)} MB; ${MOST_BYTES / 1e6} MB are taken at most.`);
      const text = await file.text();
      if (mine !== latest) return;
      table = parseTable(text);
    } catch (error) {
      if (mine !== latest) return;
      status.textContent = `${file.name} could not be read.`;
      section.dataset.state = "refused";
      byId("measurements-clear").hidden = false;
      tellFaults([error instanceof TableFault ? error.message : "The browser cannot read this file."]);
      return;
    }
    mapping = guessColumns(table.columns);
    const selects = table.columns.map(({ heading }, column) => columnSelect(column, heading, mapping[column]));
    selects.forEach((select, column) => select.addEventListener("change", () => {
      mapping[column] = choiceFrom(select.value);
      take();
    }));
    byId("measurements-preview").replaceChildren(previewTable(table, selects));
    for (const id of ["measurements-preview", "measurements-clear"]) byId(id).hidden = false;
    take();
  }

  // A file that was edited and is chosen again would else be no change.
  input.addEventListener("click", () => { input.value = ""; });
  input.addEventListener("change", () => input.files.length && read(input.files[0]));
  byId("measurements-clear").addEventListener("click", () => {
    latest += 1;
    input.value = "";
    clear();
    onData();
    input.focus();
  });
  // Elsewhere the browser would leave the page for the file.
  for (const kind of ["dragenter", "dragover"]) {
    document.addEventListener(kind, (event) => {
      if (!event.dataTransfer.types.includes("Files")) return;
      event.preventDefault();
      drop.classList.add("over");
    });
  }
  document.addEventListener("dragleave", () => drop.classList.remove("over"));
  document.addEventListener("drop", (event) => {
    drop.classList.remove("over");
    if (!event.dataTransfer.files.length) return;
    event.preventDefault();
    section.scrollIntoView({ block: "nearest" });
    read(event.dataTransfer.files[0]);
  });

  return { data, compare };
}
