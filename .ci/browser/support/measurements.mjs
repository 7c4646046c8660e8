// The section of a person's own measurements.

/** Drops a file on the section as a person does with the mouse, and waits until it is read. */
export async function dropFile(page, text) {
  const transfer = await page.evaluateHandle((content) => {
    const carried = new DataTransfer();
    carried.items.add(new File([content], "test.csv", { type: "text/csv" }));
    return carried;
  }, text);
  await page.dispatchEvent("#measurements-drop", "drop", { dataTransfer: transfer });
  await page.waitForFunction(() => ["ready", "refused"].includes(document.querySelector("#measurements")?.getAttribute("data-state") ?? ""));
}

/** How many points a chart shows: each begins its circle with a move. */
export const pointsIn = (page, chart) => page.$$eval(`${chart} path.point[data-style="measured"]`, (found) => found.reduce((sum, path) => sum + path.getAttribute("d").split("M").length - 1, 0));

export const faults = (page) => page.$$eval("#measurements-faults li", (items) => items.map(({ textContent }) => textContent));
export const chosen = (page) => page.$$eval("#measurements [data-column]", (selects) => selects.map(({ value }) => value));
export const state = (page) => page.getAttribute("#measurements", "data-state");
