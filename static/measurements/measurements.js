// Measurements of one's own: read from a file in the browser, drawn over the curves, and sent only to be fitted to or followed.

import { html } from "../dom/elements.js";
import { byId, find } from "../dom/find.js";
import { connectIdentification } from "../fit/identification.js";
import { guessColumns } from "../table/columns.js";
import { mappingTable, markWrong } from "../table/mapping.js";
import { TableFault, parseTable } from "../table/parse.js";
import { samplesOf } from "../table/samples.js";
import { connectTelemetry } from "../telemetry/telemetry.js";
import { distanceTable } from "./distance-table.js";
import { useOf } from "./use.js";

/** @import { SweepSeries } from "../figures/over-slip.js" */
/** @import { Found } from "../state/found-soil.js" */
/** @import { Settings } from "../state/settings.js" */
/** @import { Mapping } from "../table/columns.js" */
/** @import { Table } from "../table/parse.js" */
/** @import { Samples } from "../table/samples.js" */

/** A table that was read, with what its columns are and what that gives. @typedef {{ table: Table, mapping: Mapping, samples: Samples }} Read */

/** @typedef {ReturnType<typeof createMeasurements>} Measurements */

/**
 * @typedef {object} MeasurementEvents
 * @property {() => Settings} settings what is on the page
 * @property {() => void} onData called when the points over slip are others
 * @property {() => void} onLoadKnown gives the static sinkage and the load on the page
 * @property {(circle: string) => void} onCircle sets the circle on which a slip is counted
 * @property {(found: Found) => void} onSoil takes a soil that was found
 */

const MOST_FAULTS = 10;
/** Far beyond the rows that the service takes: a larger file is something else. */
const MOST_BYTES = 20_000_000;

/** @param {File} file */
async function tableIn(file) {
  if (file.size > MOST_BYTES) throw new TableFault(null, `The file has ${Math.round(file.size / 1e6)} MB; ${MOST_BYTES / 1e6} MB are taken at most.`);
  return parseTable(await file.text());
}

/** @param {string[]} faults */
function tellFaults(faults) {
  const list = byId("measurements-faults");
  const told = faults.slice(0, MOST_FAULTS);
  if (faults.length > told.length) told.push(`And ${faults.length - told.length} more.`);
  list.replaceChildren(...told.map((text) => html("li", {}, text)));
  list.hidden = !told.length;
}

/**
 * @param {HTMLElement} section
 * @param {MeasurementEvents} events
 */
export function createMeasurements(section, { settings, onData, onSoil, onLoadKnown, onCircle }) {
  const input = find(section, "#measurements-file", HTMLInputElement);
  const preview = byId("measurements-preview");
  const remove = byId("measurements-clear");
  const distances = byId("measurements-residuals");
  const status = byId("measurements-status");
  /** @type {Read | null} */
  let read = null;
  /** @type {SweepSeries[] | null} */
  let series = null;
  /** A file that is still being read when the next one comes is not shown any more. */
  let latest = 0;

  const usable = () => (read && !read.samples.faults.length ? read.samples : null);
  const points = () => usable()?.points ?? null;
  const data = () => points()?.data ?? null;

  const identification = connectIdentification(byId("identification"), { settings, points, onSoil });
  const telemetry = connectTelemetry(byId("telemetry"), {
    settings,
    onLoadKnown,
    track() {
      const track = usable()?.track;
      return read && track ? { track, columns: read.samples.columns, lines: read.table.lines } : null;
    },
    onSlips(slips) {
      if (!read) return;
      read.samples = samplesOf(read.table, read.mapping, slips);
      showPoints(read);
    },
  });

  const circle = find(section, "#measured-slip-radius", HTMLSelectElement);
  circle.append(...[...find(document, "#slip-radius", HTMLSelectElement).options].map((option) => option.cloneNode(true)));
  circle.addEventListener("change", () => onCircle(circle.value));

  /** Lugs have three circles, and a slip says nothing until it is known on which of them it was counted. */
  function tellCircle() {
    const { drawing: { lugHeight }, circles } = settings();
    byId("measured-circle").hidden = !read || !(lugHeight > 0);
    circle.value = circles.slip_radius ?? "rim";
  }

  /** @param {SweepSeries[]} shown the curves that are drawn */
  function compare(shown) {
    series = shown;
    telemetry.tell();
    const measured = data();
    distances.hidden = measured === null;
    if (measured === null) return;
    const outside = measured.slip.filter((slip) => slip < shown[0].columns.slip[0]).length;
    const advice = outside ? ` Points at negative slip (${outside}) lie left of the curves: include braking to see them.` : "";
    distances.replaceChildren(distanceTable(measured, shown), html("p", { class: "figure-note" },
      `The curves are those of the one sinkage or load set on this page. A fit uses each row’s own, and gives the residual of each row.${advice}`));
  }

  /**
   * What depends on the points over slip.
   * @param {Read} shown
   */
  function showPoints({ table, mapping, samples }) {
    const use = usable() ? useOf(samples, mapping) : "This table cannot be used yet.";
    status.textContent = `${use} The separator is a ${table.separator}, the decimal sign a ${table.decimal}.`;
    identification.show(data() !== null);
    distances.hidden = data() === null;
    onData();
    if (series) compare(series);
  }

  /**
   * @param {Table} table
   * @param {Mapping} mapping
   */
  function take(table, mapping) {
    read = { table, mapping, samples: samplesOf(table, mapping) };
    section.dataset.state = usable() ? "ready" : "refused";
    tellFaults(read.samples.faults);
    tellCircle();
    markWrong(preview, table, mapping);
    telemetry.show(Boolean(usable()?.track));
    showPoints(read);
  }

  function clear() {
    latest += 1;
    read = null;
    section.dataset.state = "empty";
    tellCircle();
    for (const element of [preview, distances, remove]) element.hidden = true;
    status.textContent = "";
    tellFaults([]);
    identification.show(false);
    telemetry.show(false);
    onData();
  }

  /** @param {Table} table */
  function show(table) {
    const mapping = guessColumns(table.columns);
    preview.replaceChildren(mappingTable(table, mapping, (column, mapped) => {
      mapping[column] = mapped;
      take(table, mapping);
    }));
    for (const element of [preview, remove]) element.hidden = false;
    take(table, mapping);
  }

  /**
   * @param {string} name of the file
   * @param {unknown} error
   */
  function refuse(name, error) {
    status.textContent = `${name} could not be read.`;
    section.dataset.state = "refused";
    remove.hidden = false;
    tellFaults([error instanceof TableFault ? error.message : "The browser cannot read this file."]);
  }

  /** @param {File} file */
  async function load(file) {
    clear();
    const mine = latest;
    status.textContent = `Reading ${file.name}…`;
    /** @type {Table} */
    let table;
    try {
      table = await tableIn(file);
    } catch (error) {
      if (mine === latest) refuse(file.name, error);
      return;
    }
    if (mine === latest) show(table);
  }

  remove.addEventListener("click", () => {
    input.value = "";
    clear();
    input.focus();
  });

  return {
    load,
    data,
    compare,
    /** Tells what holds of the table under the inputs as they are now. */
    tell() {
      tellCircle();
      telemetry.tell();
    },
  };
}
