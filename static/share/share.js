// What leaves the page: text to the clipboard, files to the disk.

import { messageOf } from "../api/client.js";
import { postForCsv } from "../api/endpoints.js";
import { html } from "../dom/elements.js";
import { byId } from "../dom/find.js";

const NOTICE_MS = 2500;
/** The download reads its address after the click has returned. */
const DOWNLOAD_MS = 60_000;

/**
 * The clipboard API exists on https and localhost only. Elsewhere a selected text area does the same.
 * @param {string} text
 */
async function copyText(text) {
  if (navigator.clipboard) {
    await navigator.clipboard.writeText(text);
    return;
  }
  const area = html("textarea", { class: "visually-hidden" });
  area.value = text;
  document.body.append(area);
  area.select();
  const isCopied = document.execCommand("copy");
  area.remove();
  if (!isCopied) throw new Error("The browser does not allow copying here.");
}

/**
 * @param {string} name
 * @param {string} text
 * @param {string} type
 */
function saveFile(name, text, type) {
  const address = URL.createObjectURL(new Blob([text], { type }));
  html("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), DOWNLOAD_MS);
}

/**
 * Runs `action` on a click and tells on the button itself how it went.
 * @param {HTMLButtonElement} button
 * @param {string} done
 * @param {() => Promise<void>} action
 */
function onClick(button, done, action) {
  const usual = button.textContent;
  const announcement = byId("announcement");
  button.addEventListener("click", async () => {
    let told = done;
    try {
      await action();
    } catch (error) {
      told = "Failed";
      button.title = messageOf(error);
    }
    button.textContent = told;
    announcement.textContent = told;
    setTimeout(() => { button.textContent = usual; }, NOTICE_MS);
  });
}

/**
 * @param {HTMLButtonElement} button
 * @param {() => string} text
 */
export function connectCopy(button, text) {
  onClick(button, "Copied", () => copyText(text()));
}

/**
 * A file to be saved: what it is, of which wheel and soil, and its text.
 * @typedef {{ what: string, wheel: { preset?: string }, soil?: { preset?: string }, text: () => Promise<string> }} SavedFile
 */

/**
 * @param {HTMLButtonElement} button
 * @param {() => SavedFile} file
 */
export function connectFile(button, file) {
  onClick(button, "Saved", async () => {
    const { what, wheel, soil, text } = file();
    saveFile(`${[what, wheel.preset, soil?.preset].join("_")}.csv`, await text(), "text/csv");
  });
}

/**
 * The file of an answer that is on the page, so that it holds what is shown.
 * @param {HTMLButtonElement} button
 * @param {() => { path: string, body: any } | null} request
 */
export function connectCsv(button, request) {
  connectFile(button, () => {
    const asked = request();
    if (!asked) throw new Error("There is nothing to save yet.");
    const { path, body } = asked;
    return { what: path.slice(path.lastIndexOf("/") + 1), wheel: body.wheel, soil: body.soil, text: () => postForCsv(path, body) };
  });
}
