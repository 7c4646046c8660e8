// imports.mjs FOLDER: the modules of the page import one another in one direction. Fails on a cycle among its files or among its folders,
// and on an import of a file that is not there. Types, which are imported in comments, may refer to one another.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { dirname, join, relative, resolve } from "node:path";

const root = resolve(process.argv[2]);
const modules = readdirSync(root, { recursive: true }).map(String).filter((name) => name.endsWith(".js")).sort();

/** Import and export statements, and not those within comments, which are indented or begin with a slash. */
const FROM = /^(?:import|export)\s(?:[^;"]*?\sfrom\s)?"(\.[^"]+)"/gm;

const importsOf = (name) => [...readFileSync(join(root, name), "utf8").matchAll(FROM)]
  .map(([, path]) => relative(root, resolve(root, dirname(name), path)));

/** The names along a cycle, or null. */
function cycleIn(graph) {
  const done = new Set();
  const visit = (name, path) => {
    if (path.includes(name)) return [...path.slice(path.indexOf(name)), name];
    if (done.has(name)) return null;
    for (const next of graph.get(name) ?? []) {
      const cycle = visit(next, [...path, name]);
      if (cycle) return cycle;
    }
    done.add(name);
    return null;
  };
  for (const name of graph.keys()) {
    const cycle = visit(name, []);
    if (cycle) return cycle;
  }
  return null;
}

const files = new Map(modules.map((name) => [name, importsOf(name)]));
const folders = new Map();
for (const [name, imports] of files) {
  const own = dirname(name);
  const others = imports.map((each) => dirname(each)).filter((folder) => folder !== own);
  folders.set(own, [...new Set([...(folders.get(own) ?? []), ...others])]);
}

const faults = [...files].flatMap(([name, imports]) =>
  imports.filter((each) => !existsSync(join(root, each))).map((each) => `${name} imports ${each}, which is not there`));
for (const [what, graph] of [["files", files], ["folders", folders]]) {
  const cycle = cycleIn(graph);
  if (cycle) faults.push(`${what} import one another: ${cycle.join(" -> ")}`);
}
const count = [...files.values()].flat().length;
if (!modules.length || !count) faults.push(`there are no modules in ${root}`);
for (const fault of faults) console.error(fault);
if (faults.length) process.exitCode = 1;
else console.log(`${count} imports among ${files.size} modules go one way`);
