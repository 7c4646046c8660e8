// Chromium as the checks use it, and the server they look at.
import { chromium } from "playwright-core";

/** Address of the server, without a slash at its end: the argument of a check run by hand, else BASE_URL. */
export const base = new URL(process.argv[2] ?? process.env.BASE_URL).origin;

/** Starts the browser; the caller closes it. */
export function launch() {
  // CI runs as root, where the sandbox cannot start; the rest keeps Chromium from asking anything of the internet.
  const args = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
  return chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args });
}
