// The section of a person's own measurements until there are any: what reads, draws and fits them is loaded with the first file.

import { messageOf, needed } from "../api/client.js";
import { byId, find } from "../dom/find.js";
import { connectChoice, connectDrop } from "./drop-zone.js";

/** @import { SweepSeries } from "../figures/over-slip.js" */
/** @import { MeasurementEvents, Measurements } from "./measurements.js" */

/**
 * @param {HTMLElement} section
 * @param {MeasurementEvents} events
 */
export function connectMeasurements(section, events) {
  /** @type {Promise<Measurements> | null} */
  let loading = null;
  /** @type {Measurements | null} */
  let loaded = null;
  /** @type {SweepSeries[] | null} */
  let series = null;

  async function start() {
    const { createMeasurements } = await needed(() => import("./measurements.js"));
    loaded = createMeasurements(section, events);
    if (series) loaded.compare(series);
    return loaded;
  }

  /** @param {File} file */
  async function load(file) {
    byId("measurements-status").textContent = `Reading ${file.name}…`;
    loading ??= start();
    try {
      (await loading).load(file);
    } catch (error) {
      loading = null;
      byId("measurements-status").textContent = `${file.name} was not read: ${messageOf(error)}`;
    }
  }

  connectChoice(find(section, "#measurements-file", HTMLInputElement), load);
  connectDrop(byId("measurements-drop"), (file) => {
    section.scrollIntoView({ block: "nearest" });
    load(file);
  });

  return {
    /** The points over slip, if there are any. */
    data: () => loaded?.data() ?? null,
    /** @param {SweepSeries[]} shown the curves that are drawn */
    compare(shown) {
      series = shown;
      loaded?.compare(shown);
    },
    /** Tells what holds of the table under the inputs as they are now. */
    tell: () => loaded?.tell(),
  };
}
