#!/usr/bin/env python3
"""circles.py FOLDER...: the files of each crate, given by its folder of sources, use one another in one direction.

A name counts for the file that defines it, not for the one that passes it on. A part of a module may use what the module around
it defines, as a law uses the trait of all laws. Tests are left out. Fails on a circle.
"""

import re
import sys
from pathlib import Path

# Comments, strings and characters.
NOISE = re.compile(
    r'//[^\n]*|/\*.*?\*/|b?r(?P<hashes>#*)".*?"(?P=hashes)|b?"(?:\\.|[^"\\])*"|b?\'(?:\\.[^\']*|[^\'\\])\'', re.DOTALL
)
# What is compiled for tests or fuzzing alone.
TEST = re.compile(r"#\[cfg\((?:test|any\(test, fuzzing\)|fuzzing)\)\]\s*(?:pub(?:\([^)]*\))?\s+)?(?:mod|use|fn)\s+[^;{]*(?P<end>[;{])")
USE = re.compile(r"\buse\s+([^;]+);")
MODULE = re.compile(r"\bmod\s+(\w+)\s*;")
ITEM = re.compile(r"\b(?:fn|struct|enum|trait|type|const|static|union|macro_rules!)\s+(?:mut\s+)?(\w+)")
PATH = re.compile(r"(?<![\w:])(?:\w+\s*::\s*)+\w+")


def without_noise(text):
    """The code without what may only look like code, and without tests."""
    text = NOISE.sub(lambda found: '""' if '"' in found[0] else "", text)
    while found := TEST.search(text):
        end = found.end()
        depth = 1 if found["end"] == "{" else 0
        while depth:
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        text = text[: found.start()] + text[end:]
    return text


def paths_of(tree):
    """The paths of a use tree with the names that they bring: `a::{b, c as d}` gives (a, b) as b and (a, c) as d."""
    head, brace, rest = tree.strip().partition("{")
    prefix = [part for part in re.split(r"\s*::\s*", head.strip()) if part]
    if not brace:
        words = prefix[-1].split()
        path, name = [*prefix[:-1], words[0]], words[-1]
        if words[0] == "self" and len(path) > 1:
            path = path[:-1]
            name = name if name != "self" else path[-1]
        yield path, name
        return
    depth, branch = 0, ""
    for character in rest[: rest.rindex("}")] + ",":
        depth += {"{": 1, "}": -1}.get(character, 0)
        if character == "," and not depth:
            if branch.strip():
                yield from ((prefix + path, name) for path, name in paths_of_branch(branch, prefix))
            branch = ""
        else:
            branch += character


def paths_of_branch(branch, prefix):
    """Those of one branch between the braces behind `prefix`, which `self` stands for."""
    for path, name in paths_of(branch):
        yield ([], prefix[-1] if name == "self" else name) if path == ["self"] else (path, name)


class Module:
    """A file with what it brings into scope, passes on and defines."""

    def __init__(self, name, file):
        self.name, self.file = name, file
        text = without_noise(file.read_text(encoding="utf-8"))
        self.uses = [(path, name) for found in USE.finditer(text) for path, name in paths_of(found[1])]
        self.body = USE.sub("", text)
        self.children = set(MODULE.findall(text))
        self.items = set(ITEM.findall(self.body))
        self.words = set(re.findall(r"\w+", self.body))


class Crate:
    """The modules of a crate by their path from its root."""

    def __init__(self, root):
        self.root = root
        self.modules = {}
        self.load((), root / "lib.rs")

    def load(self, name, file):
        module = self.modules[name] = Module(name, file)
        folder = self.root.joinpath(*name)
        for child in module.children:
            candidates = [folder / f"{child}.rs", folder / child / "mod.rs"]
            self.load((*name, child), next(each for each in candidates if each.exists()))

    def resolved(self, module, path, seen=()):
        """The module that defines what `path` names in `module`, and whether the path names a module; none of what is foreign."""
        if (module.name, tuple(path)) in seen:
            return None
        seen = (*seen, (module.name, tuple(path)))
        at, rest = module, list(path)
        if rest[0] == "crate":
            at, rest = self.modules[()], rest[1:]
        elif rest[0] == "self":
            rest = rest[1:]
        else:
            while rest and rest[0] == "super":
                at, rest = self.modules[at.name[:-1]], rest[1:]
        while rest:
            name = rest[0]
            if name in at.children:
                at, rest = self.modules[(*at.name, name)], rest[1:]
                continue
            for used, brought in at.uses:
                if brought == name and (found := self.resolved(at, used, seen)):
                    target, is_module = found
                    return self.resolved(target, ["self", *rest[1:]], seen) if is_module and rest[1:] else found
            if name in at.items:
                return at, False
            for used in (path[:-1] for path, brought in at.uses if brought == "*"):
                if (found := self.resolved(at, used, seen)) and found[1]:
                    if inner := self.resolved(found[0], ["self", *rest], seen):
                        return inner
            # What a macro defines has no word before it that says so.
            if name in at.words:
                return at, False
            return None
        return at, True

    def uses(self, module):
        """The files that a module uses."""
        paths = [path for path, name in module.uses]
        paths += [re.split(r"\s*::\s*", path) for path in PATH.findall(module.body)]
        for path in paths:
            found = self.resolved(module, path)
            # A module that is brought into scope is used where one of its names is.
            if found and not found[1] and not self.is_around(found[0], module):
                yield found[0].name

    @staticmethod
    def is_around(other, module):
        """Whether `other` is the module itself or one that it is a part of."""
        return module.name[: len(other.name)] == other.name


def circle_in(graph):
    """The names along the shortest circle; none where there is none."""
    shortest = None
    for start in graph:
        ways, seen = [[start]], {start}
        while ways:
            way = ways.pop(0)
            for following in graph[way[-1]]:
                if following == start and (shortest is None or len(way) < len(shortest)):
                    shortest = way
                if following not in seen:
                    seen.add(following)
                    ways.append([*way, following])
    return shortest


def main(folders):
    faults, count, files = [], 0, 0
    for folder in folders:
        crate = Crate(Path(folder))
        graph = {name: sorted(set(crate.uses(module))) for name, module in crate.modules.items()}
        count += sum(map(len, graph.values()))
        files += len(graph)
        if circle := circle_in(graph):
            faults.append("files use one another: " + " -> ".join(str(crate.modules[name].file) for name in [*circle, circle[0]]))
    if not count:
        faults.append("there are no uses among files")
    for fault in faults:
        print(fault, file=sys.stderr)
    if faults:
        sys.exit(1)
    print(f"{count} uses among {files} files go one way")


if __name__ == "__main__":
    main(sys.argv[1:])
