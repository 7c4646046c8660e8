// Where a file is dropped or chosen.

/**
 * A file may be dropped anywhere on the page: elsewhere the browser would leave the page for it.
 * @param {HTMLElement} zone shows that a file is over the page
 * @param {(file: File) => void} onFile
 */
export function connectDrop(zone, onFile) {
  for (const kind of /** @type {const} */ (["dragenter", "dragover"])) {
    document.addEventListener(kind, (event) => {
      if (!event.dataTransfer?.types.includes("Files")) return;
      event.preventDefault();
      zone.classList.add("over");
    });
  }
  document.addEventListener("dragleave", () => zone.classList.remove("over"));
  document.addEventListener("drop", (event) => {
    zone.classList.remove("over");
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    event.preventDefault();
    onFile(file);
  });
}

/**
 * @param {HTMLInputElement} input
 * @param {(file: File) => void} onFile
 */
export function connectChoice(input, onFile) {
  // Otherwise a file that was edited and is chosen again would be no change.
  input.addEventListener("click", () => { input.value = ""; });
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    if (file) onFile(file);
  });
}
