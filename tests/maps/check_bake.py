#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Runs `glark bake` as a process: models of meshes and points, messages, and that no output is half written.

check_bake.py GLARK
"""
import json
import math
import pathlib
import random
import struct
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "geometry"))
from command_case import CommandCase, sphere, write_ply  # noqa: E402


def gltf_of(file):
    data = pathlib.Path(file).read_bytes()
    length = struct.unpack("<I", data[12:16])[0]
    return json.loads(data[20:20 + length])


class Bake(CommandCase):
    def bumpy(self, name="bumpy.ply", points_only=False):
        points, triangles = sphere(80)
        bumps = [tuple(c * (1 + 0.03 * math.sin(9 * p[0]) * math.cos(8 * p[1])) for c in p) for p in points]
        return write_ply(self.path / name, bumps, [] if points_only else triangles)

    def assert_nothing_written(self, name="out.glb"):
        stem = name.rsplit(".", 1)[0]
        self.assertEqual([], [file.name for file in self.path.iterdir() if file.name.startswith(stem)])

    def test_mesh(self):
        report = self.report("bake", self.bumpy(), "-o", "model.glb", "--triangles", "500")
        self.assertLessEqual(report["triangles"], 500)
        self.assertGreater(report["triangles"], 400)
        self.assertEqual(0, report["points_left_out"])
        self.assertGreater(report["highest_displacement"], 0.003)
        self.assertLess(report["largest_seam_normal_degrees"], 1.5)
        for level in (1, 2):
            self.assertIn(f"root_mean_square_seam_normal_degrees_level_{level}", report)
        gltf = gltf_of(self.path / "model.glb")
        self.assertEqual({"POSITION", "NORMAL", "TANGENT", "TEXCOORD_0"}, set(gltf["meshes"][0]["primitives"][0]["attributes"]))
        material = gltf["materials"][0]
        self.assertIn("normalTexture", material)
        self.assertIn("baseColorTexture", material["pbrMetallicRoughness"])  # f3d ignores a normal map without it
        self.assertEqual("model.displacement.png", material["extras"]["displacement"]["uri"])
        header = (self.path / "model.displacement.png").read_bytes()[:26]
        self.assertEqual((report["width"], report["height"], 16, 0), struct.unpack(">IIBB", header[16:26]))

    def test_points(self):
        report = self.report("bake", self.bumpy(points_only=True), "-o", "model.glb", "--triangles", "600")
        self.assertLessEqual(report["triangles"], 620)
        self.assertGreater(report["triangles"], 300)
        self.assertLess(report["points_left_out"], 0.01 * report["points"])

    def test_points_of_a_file_that_is_read_in_parts(self):
        generator = random.Random(1)
        with open(self.path / "cloud.xyz", "w") as file:
            for _ in range(30000):
                point = [generator.gauss(0, 1) for _ in range(3)]
                length = math.hypot(*point)
                file.write(" ".join(f"{c / length:.6f}" for c in point) + "\n")
        self.glark("sample", "cloud.xyz", "-o", "cloud.las", "--target", "20000")
        self.glark("simplify", self.bumpy(), "-o", "coarse.ply", "--target", "500")
        report = self.report("bake", "cloud.las", "-o", "model.glb", "--mesh", "coarse.ply")
        self.assertGreater(report["points"], 19000)
        self.assertLess(report["charts_without_points"], report["charts"])

    def test_a_given_mesh_keeps_its_triangles(self):
        points, triangles = sphere(10)
        coarse = write_ply(self.path / "coarse.ply", points, triangles)
        report = self.report("bake", self.bumpy(), "-o", "model.glb", "--mesh", coarse)
        self.assertEqual(len(triangles), report["triangles"])

    def test_texture_memory_bounds_the_maps(self):
        report = self.report("bake", self.bumpy(), "-o", "model.glb", "--texture-memory", "1MB", "--texels-per-point", "64")
        self.assertLessEqual(report["width"] * report["height"] * 5 * 4 / 3, 1 << 20)

    def test_bad_input(self):
        cases = [
            (1, ("bake", self.bumpy(), "-o", "out.ply"), ".glb"),
            (1, ("bake", "missing.ply", "-o", "out.glb"), "missing.ply"),
            (1, ("bake", self.bumpy(), "-o", "no/folder/out.glb"), "no/folder"),
            (1, ("bake", self.bumpy(), "-o", "out.glb", "--mesh", self.bumpy("p.ply", points_only=True)), "no triangles"),
            (1, ("bake", self.bumpy(), "-o", "out.glb", "--texture-memory", "1KB"), "texture-memory"),
            (1, ("bake", self.bumpy(), "-o", "out.glb", "--texels-per-point", "100"), "texels-per-point"),
            (1, ("bake", write_ply(self.path / "empty.ply", [], []), "-o", "out.glb"), "no points"),
        ]
        for status, arguments, word in cases:
            done = self.glark(*arguments, status=status)
            self.assertIn(word, done.stderr, arguments)
            self.assert_nothing_written()

    def test_mesh_elsewhere(self):
        points, triangles = sphere(10)
        far = write_ply(self.path / "far.ply", [tuple(c + 50 for c in p) for p in points], triangles)
        done = self.glark("bake", self.bumpy(), "-o", "out.glb", "--mesh", far, status=1)
        self.assertIn("no point", done.stderr)
        self.assert_nothing_written()


if __name__ == "__main__":
    unittest.main()
