// A person's own measurements: read from a file in the browser, drawn over the curves, and sent only to be fitted to or followed.

import { guessColumns } from "./columns.js";
import { html } from "./elements.js";
import { connectIdentification } from "./identification.js";
import { mappingTable, markWrong } from "./mapping.js";
import { residualTable } from "./residual-table.js";
import { MOST_POINTS, hasSpareVelocities, samplesOf } from "./samples.js";
import { TableFault, parseTable } from "./table.js";
import { connectTelemetry } from "./telemetry.js";

const MOST_FAULTS = 10;
/** Far beyond the rows that the service takes; a larger file is something else. */
const MOST_BYTES = 20_000_000;

const byId = (id) => document.getElementById(id);

/** What becomes of the rows, in words. */
function useOf({ points, track, isTooLong, odd }, mapping) {
  const rows = (count) => `${count} ${count === 1 ? "row" : "rows"}`;
  const sentences = [];
  if (points) {
    const left = points.left ? `; ${points.left} without a number in every chosen column are left out` : "";
    sentences.push(`${rows(points.lines.length)} to be used for the curves over slip and a fit${left}.`);
  }
  if (isTooLong) sentences.push(`More than the ${MOST_POINTS} rows that a fit takes, so that only the track is there.`);
  if (track && !points && !isTooLong) sentences.push("Telemetry: follow the track; points over slip need a slip, which the track brings, and a measured column beside it.");
  if (odd.length) sentences.push(`${odd.length === 1 ? "1 cell is no number and counts as empty" : `${odd.length} cells are no numbers and count as empty, the first`}: ${odd[0].text}`);
  if (track && hasSpareVelocities(mapping)) sentences.push("The velocities are not sent, since there is a slip: ignore its column to have it from them.");
  return sentences.join(" ");
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

  const identification = connectIdentification(byId("identification"), { settings, samples: () => samples.points, onSoil });
  const telemetry = connectTelemetry(byId("telemetry"), {
    settings,
    track: () => ({ track: samples.track, columns: samples.columns, lines: table.lines }),
    onSlips(slips) {
      samples = samplesOf(table, mapping, slips);
      showPoints();
    },
  });
  const isReady = () => samples !== null && !samples.faults.length;
  const data = () => (isReady() && samples.points ? samples.points.data : null);

  function tellFaults(faults) {
    const list = byId("measurements-faults");
    const told = faults.slice(0, MOST_FAULTS);
    if (faults.length > told.length) told.push(`And ${faults.length - told.length} more.`);
    list.replaceChildren(...told.map((text) => html("li", {}, text)));
    list.hidden = !told.length;
  }

  function compare(shown) {
    series = shown;
    telemetry.tell();
    const residuals = byId("measurements-residuals");
    const measured = data();
    residuals.hidden = measured === null;
    if (residuals.hidden) return;
    const outside = measured.slip.filter((slip) => slip < shown[0].columns.slip[0]).length;
    residuals.replaceChildren(residualTable(measured, shown), html("p", { class: "figure-note" },
      "The curves belong to the one sinkage or load that is set on this page; the fit takes each row’s own, and tells the residuals of the rows.",
      outside ? ` ${outside} points at negative slip are left of the curves: include braking to see them.` : ""));
  }

  /** What depends on the points over slip. */
  function showPoints() {
    const use = isReady() ? useOf(samples, mapping) : "This table cannot be used yet.";
    status.textContent = `${use} Cells are parted by ${table.separator}, decimals by ${table.decimal}.`;
    identification.show(data() !== null);
    byId("measurements-residuals").hidden = data() === null;
    onData();
    if (series) compare(series);
  }

  function take() {
    samples = samplesOf(table, mapping);
    section.dataset.state = isReady() ? "ready" : "refused";
    tellFaults(samples.faults);
    markWrong(byId("measurements-preview"), table, mapping);
    telemetry.show(isReady() && samples.track !== null);
    showPoints();
  }

  function clear() {
    [table, samples, mapping] = [null, null, []];
    section.dataset.state = "empty";
    for (const id of ["measurements-preview", "measurements-residuals", "measurements-clear"]) byId(id).hidden = true;
    status.textContent = "";
    tellFaults([]);
    identification.show(false);
    telemetry.show(false);
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
    byId("measurements-preview").replaceChildren(mappingTable(table, mapping, (column, mapped) => {
      mapping[column] = mapped;
      take();
    }));
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
