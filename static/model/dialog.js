// The dialog with the model: its text is set when it is first opened.

import { messageOf, needed } from "../api/client.js";
import { find } from "../dom/find.js";

/**
 * @param {HTMLDialogElement} dialog
 * @param {HTMLElement} link
 */
export function connectModel(dialog, link) {
  const body = find(dialog, "[data-model]");
  let isFilled = false;

  async function open() {
    if (!dialog.open) dialog.showModal();
    if (isFilled) return;
    try {
      const { statement } = await needed(() => import("./statement.js"));
      body.replaceChildren(...statement());
      isFilled = true;
    } catch (error) {
      body.textContent = messageOf(error);
    }
  }

  link.addEventListener("click", (event) => {
    event.preventDefault();
    event.stopPropagation();
    open();
  });
  find(dialog, "[data-close]").addEventListener("click", () => dialog.close());
  // A click on the backdrop comes as one on the dialog itself.
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  if (location.hash === "#model") open();
}
