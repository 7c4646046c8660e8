#!/usr/bin/env python3
"""Runs the programs of docs/recipes.md against the server at BASE_URL, and compares what they print with the page.

A program is a block of Python; the block of text that follows is what it prints.
"""

import difflib
import os
import pathlib
import re
import subprocess
import sys

PAGE = pathlib.Path(__file__).parent.parent / "docs" / "recipes.md"
DEFAULT = "http://127.0.0.1:8080"


def recipes(text):
    """The programs with their headings and what they print."""
    heading, program = None, None
    for match in re.finditer(r"^## ([^\n]+)$|^```(python|text)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        if match[1]:
            heading = match[1]
        elif match[2] == "python":
            assert program is None, f"{heading}: nothing is printed"
            program = match[3]
        else:
            assert program is not None, f"{heading}: nothing prints this"
            yield heading, program, match[3]
            program = None
    assert program is None, f"{heading}: nothing is printed"


def main():
    server = os.environ["BASE_URL"]
    found = list(recipes(PAGE.read_text()))
    assert len(found) >= 5, "the page has lost its programs"
    failed = []
    for heading, program, shown in found:
        assert DEFAULT in program, f"{heading}: asks no server"
        run = subprocess.run(
            [sys.executable, "-c", program.replace(DEFAULT, server)], capture_output=True, text=True, timeout=120
        )
        print(f"--> {heading}")
        if run.returncode != 0 or run.stdout != shown:
            failed.append(heading)
            print(run.stderr)
            print("\n".join(difflib.unified_diff(shown.splitlines(), run.stdout.splitlines(), "shown", "printed", lineterm="")))
    if failed:
        sys.exit(f"failed: {', '.join(failed)}")
    print(f"{len(found)} recipes passed")


main()
