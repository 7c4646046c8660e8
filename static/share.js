// What leaves the page: text to the clipboard, files to the disk.

import { postForCsv } from "./api.js";

const NOTICE_MS = 2500;

/** The clipboard API exists only on https and localhost; elsewhere a selected text area does the same. */
async function copyText(text) {
  if (navigator.clipboard) {
    await navigator.clipboard.writeText(text);
    return;
  }
  const area = document.createElement("textarea");
  area.value = text;
  area.className = "visually-hidden";
  document.body.append(area);
  area.select();
  const copied = document.execCommand("copy");
  area.remove();
  if (!copied) throw new Error("The browser does not allow copying here.");
}

function saveFile(name, text, type) {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const anchor = document.createElement("a");
  anchor.href = address;
  anchor.download = name;
  anchor.click();
  // The download reads the address after the click has returned.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

/** Runs `action` on a click and tells on the button itself how it went. */
function onClick(button, done, action) {
  const usual = button.textContent;
  const announcement = document.getElementById("announcement");
  button.addEventListener("click", async () => {
    let told = done;
    try {
      await action();
    } catch (error) {
      told = "Failed";
      button.title = error.message;
    }
    button.textContent = told;
    announcement.textContent = told;
    setTimeout(() => { button.textContent = usual; }, NOTICE_MS);
  });
}

export function connectCopy(button, text) {
  onClick(button, "Copied", () => copyText(text()));
}

/** `asked()` gives what was asked for, of which wheel and soil, and `text()` the file's content. */
export function connectFile(button, asked) {
  onClick(button, "Saved", async () => {
    const { what, wheel, soil, text } = asked();
    saveFile(`${[what, wheel.preset, soil.preset].join("_")}.csv`, await text(), "text/csv");
  });
}

/** `request()` gives the path and the body whose answer is on the page, so that the file holds what is shown. */
export function connectCsv(button, request) {
  connectFile(button, () => {
    const { path, body } = request();
    return { what: path.split("/").at(-1), ...body, text: () => postForCsv(path, body) };
  });
}
