# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Fails on an include that goes up in the layers of cmake/layers.txt.

check_layers.py ROOT [GENERATED]: the source tree, and the folder of generated sources if there is one.
"""
import os
import pathlib
import re
import sys
from dataclasses import dataclass, field

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"\n]+)"|<([^>\n]+)>)', re.MULTILINE)
SUFFIXES = (".c", ".cpp", ".h", ".glsl", ".inc")
FOLDERS = ("conformance", "examples", "glark", "include", "shim", "tests")


@dataclass
class Layers:
    lines: dict = field(default_factory=dict)    # path -> number of its line
    groups: dict = field(default_factory=dict)   # path -> name of its group
    uses: dict = field(default_factory=dict)     # group -> groups that it uses
    never: list = field(default_factory=list)    # (folder, prefixes)


def read_layers(text: str) -> Layers:
    layers, group = Layers(), ""
    for number, line in enumerate(text.splitlines()):
        line = line.partition("#")[0].strip()
        if match := re.fullmatch(r"\[(\w+):(.*)\]", line):
            group = match.group(1)
            layers.uses[group] = match.group(2).split()
        elif match := re.fullmatch(r"never (\S+):(.*)", line):
            layers.never.append((match.group(1), tuple(match.group(2).split())))
        else:
            for path in filter(None, map(str.strip, line.split("|"))):
                layers.lines[path], layers.groups[path] = number, group
    return layers


def layer_of(layers: Layers, name: str) -> str:
    """The longest listed path that matches the file; empty for a file of no layer."""
    if name in layers.lines:
        return name
    stem = name.partition(".")[0]
    while stem and stem not in layers.lines:
        stem = stem.rpartition("/")[0]
    return stem


def complaint_about(layers: Layers, name: str, included: str) -> str:
    """Why the file may not include this; empty if it may."""
    for folder, prefixes in layers.never:
        if name.startswith(folder + "/") and included.startswith(prefixes):
            return f"{folder} never includes {included}"
    if included.startswith("generated/") or "../" in included:
        return "write paths from the root of the repository or of the generated files"
    mine, theirs = layer_of(layers, name), layer_of(layers, included)
    if not theirs or mine == theirs:
        return ""
    if layers.groups[mine] != layers.groups[theirs]:
        if layers.groups[theirs] in layers.uses[layers.groups[mine]]:
            return ""
        return f"group {layers.groups[mine]} does not use group {layers.groups[theirs]}"
    if layers.lines[mine] == layers.lines[theirs]:
        return f"{mine} and {theirs} are siblings"
    return "" if layers.lines[mine] > layers.lines[theirs] else f"{mine} is below {theirs}"


def complaints_in(layers: Layers, name: str, text: str) -> list:
    if not layer_of(layers, name):
        return [f"{name} is in no layer; give it a line"]
    found = []
    for match in INCLUDE.finditer(text):
        included = match.group(1) or match.group(2)
        if complaint := complaint_about(layers, name, as_path(included)):
            found.append(f"{name} includes {included}: {complaint}")
    return found


def as_path(included: str) -> str:
    """Public headers are found under include/."""
    public = re.fullmatch(r"glark/\w+\.h|GL/glark\.h", included)
    return f"include/{included}" if public else included


def files_of(root: pathlib.Path) -> list:
    found = []
    for top in FOLDERS:
        for folder, _, names in os.walk(root / top):
            found += [os.path.join(folder, name) for name in names if name.endswith(SUFFIXES)]
    return sorted(found)


def main() -> int:
    root = pathlib.Path(sys.argv[1])
    layers = read_layers((root / "cmake" / "layers.txt").read_text())
    complaints = []
    for base in map(pathlib.Path, sys.argv[1:]):
        for file in files_of(base):
            with open(file, errors="replace") as source:
                complaints += complaints_in(layers, os.path.relpath(file, base), source.read())
    for complaint in complaints:
        print(f"cmake/layers.txt: {complaint}", file=sys.stderr)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
