#!/usr/bin/env python3
"""Compares the benchmarks of the working tree with those of another commit, in turns on one machine.

    crates/terramechanics/benches/compare.py COMMIT [FILTER] [ROUNDS]

Both are built apart and run by turns, so that what else the machine does falls on both. A row has the fastest time of each and
their ratio: the fastest time is the least disturbed.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

UNITS = {"ns": 1.0, "µs": 1e3, "ms": 1e6, "s": 1e9}
ROW = re.compile(r"^(?P<branch>[│ ]*)[├╰]─ (?P<name>\S+)(?: +(?P<fastest>[\d.]+) (?P<unit>ns|µs|ms|s) )?")


def built(tree, target):
    """The executable of the benchmarks of a tree."""
    command = ["cargo", "bench", "--package", "terramechanics", "--bench", "forces", "--no-run", "--message-format", "json"]
    lines = subprocess.run(command + ["--target-dir", target], cwd=tree, check=True, stdout=subprocess.PIPE, text=True).stdout
    messages = (json.loads(line) for line in lines.splitlines())
    return [message["executable"] for message in messages if message.get("executable")][-1]


def fastest(executable, selected):
    """The fastest time (ns) of each row of one run."""
    output = subprocess.run([executable, "--bench", *selected], check=True, stdout=subprocess.PIPE, text=True).stdout
    times, group = {}, ""
    for row in filter(None, map(ROW.match, output.splitlines())):
        if not row["branch"]:
            group = row["name"]
        if row["fastest"]:
            name = f"{group}/{row['name']}" if row["branch"] else group
            times[name] = float(row["fastest"]) * UNITS[row["unit"]]
    return times


def main(commit, selected, rounds):
    here = pathlib.Path(__file__).resolve().parents[3]
    with tempfile.TemporaryDirectory() as folder:
        other = f"{folder}/tree"
        subprocess.run(["git", "worktree", "add", "--quiet", "--detach", other, commit], cwd=here, check=True)
        try:
            sides = [built(other, f"{folder}/target"), built(here, here / "target")]
            best = [{}, {}]
            for _ in range(rounds):
                for times, executable in zip(best, sides):
                    for name, time in fastest(executable, selected).items():
                        times[name] = min(time, times.get(name, time))
        finally:
            subprocess.run(["git", "worktree", "remove", "--force", other], cwd=here, check=True)
    print(f"{'row':48} {commit[:12]:>12} {'here':>12} {'ratio':>7}   (ns, fastest of {rounds} rounds)")
    for name, before in best[0].items():
        if name in best[1]:
            print(f"{name:48} {before:12.1f} {best[1][name]:12.1f} {before / best[1][name]:7.2f}")


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:3], int(sys.argv[3]) if len(sys.argv) > 3 else 3)
