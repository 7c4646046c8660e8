// What a person would find in the browser's console and network list.
import { base } from "./launch.mjs";

const OWN_SCHEMES = ["data:", "blob:"];
const REFUSAL = /^Failed to load resource: .* status of 422 /;

const isOwn = (url) => OWN_SCHEMES.includes(url.protocol) || url.origin === base;

/** `faults` fills with errors, `refusals` with the paths whose 422 the browser noted, which is no error of the page. */
export async function watch(context) {
  const faults = [];
  const refusals = [];
  await context.addInitScript(() => {
    document.addEventListener("securitypolicyviolation", ({ effectiveDirective, blockedURI }) => {
      console.error(`against the content security policy: ${effectiveDirective} ${blockedURI}`);
    });
  });
  context.on("console", (message) => {
    if (!["error", "warning", "assert"].includes(message.type())) return;
    const { url } = message.location();
    if (REFUSAL.test(message.text()) && url.startsWith(`${base}/v1/`)) refusals.push(new URL(url).pathname);
    else faults.push(`${message.type()} in the console: ${message.text()} ${url}`);
  });
  context.on("weberror", (error) => faults.push(`uncaught: ${error.error().stack}`));
  context.on("request", (request) => {
    if (!isOwn(new URL(request.url()))) faults.push(`asked another host: ${request.url()}`);
  });
  context.on("requestfailed", (request) => {
    const { errorText } = request.failure();
    // The page aborts a round whose answer it no longer needs, and the browser the icon of a page that it leaves.
    const mayBeGivenUp = request.url().startsWith(`${base}/v1/`) || request.url() === `${base}/static/icon.svg`;
    const isGivenUp = errorText === "net::ERR_ABORTED" && mayBeGivenUp;
    if (!isGivenUp) faults.push(`no answer: ${request.url()} ${errorText}`);
  });
  return { faults, refusals };
}
