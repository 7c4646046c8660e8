#!/usr/bin/env python3
"""Compares the benchmarks of the working tree with those of another commit, in turns on one machine.

    crates/terramechanics/benches/compare.py COMMIT [--filter FILTER] [--rounds ROUNDS] [--lanes avx2|sse2]...

Both are built apart and run by turns, so that what else the machine does falls on both. A row has the fastest time of each and
their ratio: the fastest time is the least disturbed. With `--lanes` the working tree is measured once more with lanes held to these.
"""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

UNITS = {"ns": 1.0, "µs": 1e3, "ms": 1e6, "s": 1e9}
ROW = re.compile(r"^(?P<branch>[│ ]*)[├╰]─ (?P<name>\S+)(?: +(?P<fastest>[\d.]+) (?P<unit>ns|µs|ms|s) )?")


def built(tree, target, lanes=None):
    """The executable of the benchmarks of a tree, perhaps with lanes held to a level."""
    command = ["cargo", "bench", "--package", "terramechanics", "--bench", "forces", "--no-run", "--message-format", "json"]
    command += ["--target-dir", target]
    environment = os.environ | ({"RUSTFLAGS": f'--cfg lanes="{lanes}"'} if lanes else {})
    lines = subprocess.run(command, cwd=tree, check=True, stdout=subprocess.PIPE, text=True, env=environment).stdout
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


def main(commit, selected, rounds, lanes):
    here = pathlib.Path(__file__).resolve().parents[3]
    with tempfile.TemporaryDirectory() as folder:
        other = f"{folder}/tree"
        subprocess.run(["git", "worktree", "add", "--quiet", "--detach", other, commit], cwd=here, check=True)
        try:
            sides = {commit[:12]: built(other, f"{folder}/target"), "here": built(here, here / "target")}
            sides |= {level: built(here, here / "target" / level, level) for level in lanes}
            best = {side: {} for side in sides}
            for _ in range(rounds):
                for side, executable in sides.items():
                    for name, time in fastest(executable, selected).items():
                        best[side][name] = min(time, best[side].get(name, time))
        finally:
            subprocess.run(["git", "worktree", "remove", "--force", other], cwd=here, check=True)
    print_table(best, rounds)


def print_table(best, rounds):
    """Each row's fastest times, and how many times as fast as the first side the others are."""
    (first, before), *others = best.items()
    print(f"{'row':48} {first:>12}" + "".join(f"{side:>13} {'ratio':>6}" for side, _ in others))
    for name, time in before.items():
        columns = [times[name] for _, times in others if name in times]
        if len(columns) == len(others):
            print(f"{name:48} {time:12.1f}" + "".join(f"{column:13.1f} {time / column:6.2f}" for column in columns))
    print(f"ns, fastest of {rounds} rounds")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("commit")
    parser.add_argument("--filter", help="rows whose name matches")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--lanes", action="append", choices=["avx2", "sse2"], default=[])
    given = parser.parse_args()
    main(given.commit, [given.filter] if given.filter else [], given.rounds, given.lanes)
