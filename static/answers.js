// One round of requests: the forces, the stresses along the contact, and the sweep over slip, for one or all methods.

import { Problem, post } from "./api.js";
import { METHOD_NAMES } from "./format.js";
import { forcesBody, profileBody, sweepBody } from "./settings.js";

/** A problem is an outcome like an answer; only a missing answer ends the round. */
async function outcomeOf(path, body, signal) {
  try {
    return { body, answer: await post(path, body, signal) };
  } catch (error) {
    if (error instanceof Problem) return { body, problem: error };
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

/**
 * `forces`, `sweep` and `profile` are the outcomes for the chosen method, each with its request's body and either an
 * answer or a problem; `byMethod` lists the forces and sweeps of all methods asked for.
 */
export async function askAll(settings, signal) {
  const asked = settings.methods.map((method) => ({
    method,
    forces: outcomeOf("/v1/forces", forcesBody(settings, method), signal),
    sweep: outcomeOf("/v1/slip-sweep", sweepBody(settings, method), signal),
  }));
  const chosen = asked.find(({ method }) => method === settings.method);
  const [profile, ...byMethod] = await Promise.all([
    profileOutcome(settings, chosen.forces, signal),
    ...asked.map(async ({ method, forces, sweep }) => {
      const [forcesDone, sweepDone] = await Promise.all([forces, sweep]);
      return { method, forces: forcesDone, sweep: sweepDone };
    }),
  ]);
  const { forces, sweep } = byMethod.find(({ method }) => method === settings.method);
  return { forces, sweep, profile, byMethod };
}

export const faultsOfProblem = (problem) => (problem.errors.length ? problem.errors : [{ pointer: "", detail: problem.message }]);

/** The faults of the chosen method's outcomes, each once, though several requests may have it. */
export function faultsOf({ forces, sweep, profile }) {
  const faults = [forces, sweep, profile].flatMap(({ problem }) => (problem ? faultsOfProblem(problem) : []));
  return [...new Map(faults.map((fault) => [`${fault.pointer} ${fault.detail}`, fault])).values()];
}

/** Each warning once, with the answers it came with. */
export function warningsOf({ profile, byMethod }) {
  const named = (method, what) => (byMethod.length > 1 ? `${METHOD_NAMES[method]}, ${what}` : what);
  const sources = [
    ...byMethod.flatMap(({ method, forces, sweep }) => [
      { about: named(method, "at this slip"), outcome: forces },
      { about: named(method, "over slip"), outcome: sweep },
    ]),
    { about: "stress profile", outcome: profile },
  ];
  const warnings = new Map();
  for (const { about, outcome } of sources) {
    for (const { code, detail } of outcome.answer?.warnings ?? []) {
      const key = `${code} ${detail}`;
      warnings.set(key, { code, detail, abouts: [...(warnings.get(key)?.abouts ?? []), about] });
    }
  }
  return [...warnings.values()];
}
