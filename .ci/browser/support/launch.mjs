// Chromium as the checks use it.
import { chromium } from "playwright-core";

/** Address of the server, without a slash at its end. */
export const base = process.env.BASE_URL;

/** Starts the browser; the caller closes it. */
export function launch() {
  // CI runs as root, where the sandbox cannot start; the rest keeps Chromium from asking anything of the internet.
  const args = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
  return chromium.launch({ executablePath: process.env.CHROMIUM, args });
}
