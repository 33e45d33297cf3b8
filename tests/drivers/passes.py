#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Prints how long the depth passes of one or more source trees compile: milliseconds of processor time, the least of several
alternating runs, without a shader cache.

  tests/drivers/passes.py PROGRAM TREE...    PROGRAM: driver_compiling of a build
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

RUNS = 5
NOTHING = {"GLARK_DEPTHS": 12, "GLARK_CURVES": 0, "GLARK_LENGTHS": 0, "GLARK_NORMALS": 0, "GLARK_STRAIGHT": 0, "GLARK_POINTS": 0,
           "GLARK_STEPS": 1}
MEASURES = {"edge_pixels": dict(NOTHING, GLARK_LENGTHS=1),
            "edge_pixels_and_curvature": dict(NOTHING, GLARK_LENGTHS=1, GLARK_NORMALS=1),
            "screen_error_of_cubics": dict(NOTHING, GLARK_CURVES=1, GLARK_POINTS=10),
            "screen_error_of_any_curve": dict(NOTHING, GLARK_CURVES=1, GLARK_POINTS=13)}


def flat(tree: pathlib.Path, name: str, seen: set) -> str:
    """Returns the text of a file with all that it includes."""
    lines = []
    for line in (tree / name).read_text().splitlines():
        included = re.match(r'\s*#include "(.*)"', line)
        if included and included.group(1) not in seen:
            seen.add(included.group(1))
            lines.append(flat(tree, included.group(1), seen))
        elif not included and not line.startswith("#pragma once"):
            lines.append(line)
    return "\n".join(lines)


def passes() -> dict:
    """Returns the file and the definitions of each pass by its name."""
    folder = "glark/core/depth/"
    found = {"limits": (folder + "measure/measure.glsl", dict(NOTHING, GLARK_PASS=0))}
    for bits in (0, 4):
        for number in (0, 1, 2):
            defines = {"GLARK_PASS": number, "GLARK_INTERIOR": 0, "GLARK_STEPS": 1, "GLARK_PACKED_BITS": bits}
            found[f"{('count', 'scan', 'scatter')[number]}.{'measured' if bits else 'tags'}"] = (folder + "bins.glsl", defines)
    small = {"GLARK_GROUP": 32, "GLARK_TRIANGLES": 128, "GLARK_INSTANCES": 4}
    found["small.tags"] = (folder + "ordered.glsl", dict(NOTHING, **small, GLARK_TAGS=1))
    for name, defines in MEASURES.items():
        found[f"small.{name}"] = (folder + "ordered.glsl", dict(defines, **small, GLARK_TAGS=0))
        found[f"measure.{name}"] = (folder + "measure/measure.glsl", dict(defines, GLARK_PASS=1))
        if defines["GLARK_CURVES"]:
            found[f"shown.{name}"] = (folder + "measure/measure.glsl", dict(defines, GLARK_PASS=2))
    return found


def main() -> int:
    if len(sys.argv) < 3:
        print(__doc__)
        return 2
    trees = [pathlib.Path(tree) for tree in sys.argv[2:]]
    least: dict = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, (source, defines) in passes().items():
            for number, tree in enumerate(trees):
                head = "#version 430\n" + "".join(f"#define {key} {value}\n" for key, value in defines.items())
                (pathlib.Path(folder) / f"{name}-{number}").write_text(head + flat(tree, source, set()) + "\n")
        files = sorted(str(file) for file in pathlib.Path(folder).iterdir())
        for _ in range(RUNS):
            environment = dict(os.environ, MESA_SHADER_CACHE_DISABLE="true")
            printed = subprocess.run([sys.argv[1], *files], env=environment, check=True, capture_output=True, text=True).stdout
            for line in printed.splitlines()[1:]:
                file, spent = line.rsplit(" ", 1)
                least[file] = min(float(spent), least.get(file, float(spent)))
    for name in passes():
        print(f"{name:40}", *(f"{least[f'{folder}/{name}-{number}']:8.1f}" for number in range(len(trees))))
    return 0


if __name__ == "__main__":
    sys.exit(main())
