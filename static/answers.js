// One round of requests: the forces, the stresses along the contact, and the sweep over slip, for one or all methods.

import { Problem, post } from "./api.js";
import { METHOD_NAMES } from "./format.js";
import { compareBody, forcesBody, profileBody, sweepBody } from "./settings.js";
import { worded, wordedWarning } from "./wording.js";

/** A problem is an outcome like an answer; only a missing answer ends the round. */
async function outcomeOf(path, body, signal) {
  try {
    return { path, body, answer: await post(path, body, signal) };
  } catch (error) {
    if (error instanceof Problem) return { path, body, problem: error };
    throw error;
  }
}

/** With a load given, the profile waits for the sinkage that the chosen method finds, so that both belong together. */
async function profileOutcome(settings, forces, signal) {
  const ask = (sinkage) => outcomeOf("/v1/stress-profile", profileBody(settings, sinkage), signal);
  if (settings.givenName !== "normal_load_n") return ask();
  const { answer, problem } = await forces;
  return problem ? { problem } : ask(answer.sinkage_m);
}

/** The curves of all methods asked for, in one request, so that they and their gaps belong together. */
function sweepOutcome(settings, signal) {
  return settings.methods.length > 1
    ? outcomeOf("/v1/compare", compareBody(settings), signal)
    : outcomeOf("/v1/slip-sweep", sweepBody(settings, settings.method), signal);
}

/** What a sweep's or a comparison's answer says of each method: its columns, and its gap to the integral where there are several. */
function seriesOf({ answer }) {
  if (!answer) return [];
  return answer.series ?? [{ method: answer.method, columns: answer.columns }];
}

/** What the catalogue does not have and nobody has typed is asked for once, not by every part of the page. */
async function refusal(settings, signal) {
  const forces = await outcomeOf("/v1/forces", forcesBody(settings, settings.method), signal);
  return forces.problem ? { forces, sweep: forces, profile: forces, byMethod: [], series: [] } : null;
}

/**
 * `forces`, `sweep` and `profile` are the outcomes for the chosen method, each with its request and either an answer or a
 * problem; `byMethod` lists the forces of all methods asked for, `series` their curves.
 */
export async function askAll(settings, signal) {
  const refused = settings.isLacking ? await refusal(settings, signal) : null;
  if (refused) return refused;
  const asked = settings.methods.map((method) => ({ method, forces: outcomeOf("/v1/forces", forcesBody(settings, method), signal) }));
  const chosen = asked.find(({ method }) => method === settings.method);
  const [profile, sweep, ...byMethod] = await Promise.all([
    profileOutcome(settings, chosen.forces, signal),
    sweepOutcome(settings, signal),
    ...asked.map(async ({ method, forces }) => ({ method, forces: await forces })),
  ]);
  const { forces } = byMethod.find(({ method }) => method === settings.method);
  return { forces, sweep, profile, byMethod, series: seriesOf(sweep) };
}

export const faultsOfProblem = (problem) => (problem.errors.length ? problem.errors : [{ pointer: "", detail: problem.message }]);

/** The faults of the chosen method's outcomes, each once, though several requests may have it. */
export function faultsOf({ forces, sweep, profile }) {
  const faults = [forces, sweep, profile].flatMap(({ problem }) => (problem ? faultsOfProblem(problem) : []));
  return [...new Map(faults.map((fault) => [`${fault.pointer} ${fault.detail}`, fault])).values()];
}

/** What a warning says, wherever in a sweep it says it. */
const saying = ({ code, detail }) => `${code} ${detail.replace(/^at slip [^;]*; furthest out: /, "")}`;

/** Each warning once, with the methods it came with. */
function gathered(sources) {
  const warnings = new Map();
  for (const { method, code, detail } of sources) {
    const key = `${code} ${detail}`;
    warnings.set(key, { code, detail, methods: [...(warnings.get(key)?.methods ?? []), ...(method ? [METHOD_NAMES[method]] : [])] });
  }
  return [...warnings.values()];
}

/** A value that no soil of the catalogue comes near may be a slip of the unit: that is told first. */
const urgentFirst = (warnings) => [...warnings].sort((a, b) => Number(b.code === "outside_catalogue") - Number(a.code === "outside_catalogue"));

/** A comparison names the method at the head of its warnings. */
function withoutMethod({ code, detail }) {
  const method = Object.keys(METHOD_NAMES).find((name) => detail.startsWith(`${name}: `));
  return { method, code, detail: method ? detail.slice(method.length + 2) : detail };
}

/** The warnings by the part of the page that they are about; what is said of the results is not said again of the curves. */
export function warningsOf({ sweep, profile, byMethod, series }) {
  const isCompared = byMethod.length > 1;
  const ofForces = byMethod.flatMap(({ method, forces }) =>
    (forces.answer?.warnings ?? []).map(({ code, detail }) => ({ method: isCompared ? method : null, code, detail: worded(detail) })));
  const ofSweep = (sweep.answer?.warnings ?? []).map(withoutMethod)
    .map((warning) => ({ ...warning, detail: wordedWarning(warning.detail, series[0]?.columns.slip) }));
  const ofProfile = (profile.answer?.warnings ?? []).map(({ code, detail }) => ({ code, detail: worded(detail) }));
  const said = new Set(ofForces.map(saying));
  const further = (warnings) => gathered(warnings.filter((warning) => !said.has(saying(warning))));
  return { forces: urgentFirst(gathered(ofForces)), sweep: further(ofSweep), profile: further(ofProfile) };
}
