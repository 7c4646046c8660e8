// The section of published measurements: they, and what draws them, are loaded when it comes near the window.

import { messageOf, needed } from "../api/client.js";
import { find } from "../dom/find.js";

const NEARBY = "300px";

/** @param {HTMLElement} section */
export function connectValidation(section) {
  const observer = new IntersectionObserver(async (entries) => {
    if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
    observer.disconnect();
    try {
      const { showValidation } = await needed(() => import("./validation.js"));
      showValidation(section);
    } catch (error) {
      section.dataset.state = "failed";
      find(section, "#validation-status").textContent = messageOf(error);
    }
  }, { rootMargin: NEARBY });
  observer.observe(section);
}
