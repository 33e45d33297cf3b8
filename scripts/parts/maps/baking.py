# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Bakes the data sets with glark and with Blender, and writes the models that viewers are given."""
import json
import os
import pathlib
import re
import subprocess
import typing

import displaced
import glb
import numpy
import references

HERE = pathlib.Path(__file__).resolve().parent
GUTTER = 4  # texels, of glark bake: Blender extends its charts as far
EXTRUSIONS = [0.002, 0.005]  # of the bounding box's diagonal


class DataSet(typing.NamedTuple):
    name: str  # NAME.ply.zst
    triangles: int  # of the coarse mesh
    up: str = "y"


DATA_SETS = [
    DataSet("igea", 20000),
    DataSet("happy_stand_scans", 20000),
    DataSet("armadillo", 5000),
    DataSet("lion_takanawa", 20000, "z"),
]


def run(command: list) -> dict:
    """Returns the report on standard output."""
    process = subprocess.Popen([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    out, errors = process.communicate()
    if process.returncode:
        raise RuntimeError(f"{' '.join(map(str, command))}: {errors}")
    return json.loads(out) if out.startswith("{") else {}


def timed(command: list) -> dict:
    """The report, with the processor seconds of the whole program and its threads."""
    before = os.times()
    report = run(command)
    after = os.times()
    used = after.children_user + after.children_system - before.children_user - before.children_system
    return {**report, "processor_seconds": used}


class Models:
    """The models of one data set, in a folder of its own."""

    def __init__(self, data_set: DataSet, glark: pathlib.Path, data: pathlib.Path, folder: pathlib.Path) -> None:
        self.data_set, self.glark = data_set, glark
        self.folder = folder / data_set.name
        self.folder.mkdir(parents=True, exist_ok=True)
        self.input = self.folder / "input.ply"
        if not self.input.exists():
            subprocess.run(["zstd", "-q", "-d", str(data / f"{data_set.name}.ply.zst"), "-o", str(self.input)], check=True)
        self.points = references.read_points(self.input)

    def file(self, name: str) -> pathlib.Path:
        return self.folder / f"{name}.glb"

    def bake(self) -> dict:
        """Writes model, coarse, displaced and reference. Returns the reports of glark bake."""
        report = timed([self.glark, "bake", self.input, "-o", self.file("model"), "--triangles", self.data_set.triangles,
                        "--json"])
        glb.read(self.file("model")).without_maps().write(self.file("coarse"))
        displaced.write_displaced(self.file("model"), self.file("displaced"))
        self.write_reference("red" in self.points.dtype.names)
        again = timed([self.glark, "bake", self.input, "--mesh", self.file("coarse"), "-o", self.file("same_mesh"), "--json"])
        reports = {"model": report, "same mesh": again}
        if self.has_fine_of_its_own:
            reports["fine mesh"] = timed([self.glark, "bake", self.fine, "--mesh", self.file("coarse"), "-o",
                                          self.file("from_fine"), "--json"])
            displaced.write_displaced(self.file("from_fine"), self.file("from_fine_displaced"))
        return reports

    @property
    def has_fine_of_its_own(self) -> bool:
        return self.fine != self.input

    def write_reference(self, has_colours: bool) -> None:
        """The fine mesh: the input, or its reconstruction; with the material of the model."""
        self.fine = self.input
        if b"element face" not in self.input.read_bytes()[:2000]:
            self.fine = self.folder / "fine.ply"
            run([self.glark, "reconstruct", self.input, "-o", self.fine, "--json"])
        run([self.glark, "simplify", self.fine, "-o", self.file("reference"), "--target", 10**9, "--json"])
        mesh = glb.read(self.file("reference")).with_own_material()
        if has_colours:
            mesh = references.with_colours_of(mesh, self.points)
        mesh.write(self.file("reference"))
        if self.has_fine_of_its_own:
            references.with_normals_of(mesh, self.points).write(self.file("reference_normals_of_points"))

    def bake_by_blender(self, threads: int) -> list:
        """Returns [{extrusion, seconds, processor_seconds, file}]. The extrusion is a part of the diagonal."""
        positions = glb.read(self.file("reference")).array("POSITION")
        diagonal = float(numpy.linalg.norm(positions.max(axis=0) - positions.min(axis=0)))
        report = json.loads((self.folder / "reports.json").read_text())["same mesh"]
        outputs = [self.file(f"blender_{number}") for number in range(len(EXTRUSIONS))]
        pairs = [word for part, out in zip(EXTRUSIONS, outputs, strict=True) for word in (part * diagonal, out)]
        done = subprocess.run(
            ["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python", HERE / "blender_bake.py",
             "--", *map(str, [self.file("coarse"), self.file("reference"), report["width"], report["height"], GUTTER,
                              threads, *pairs])], capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(f"blender: {done.stdout[-2000:]}{done.stderr[-2000:]}")
        bakes = [json.loads(line) for line in re.findall(r"^glark: (.*)$", done.stdout, re.MULTILINE)]
        return [{**bake, "extrusion": part, "file": out.stem}
                for bake, part, out in zip(bakes, EXTRUSIONS, outputs, strict=True)]


def validate(node_modules: pathlib.Path, files: list) -> list:
    out = subprocess.run(["node", str(HERE / "validate.mjs"), str(node_modules / "gltf-validator"), *map(str, files)],
                         check=True, capture_output=True, text=True).stdout
    return [json.loads(line) for line in out.splitlines()]
