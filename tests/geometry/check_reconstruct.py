# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Runs glark reconstruct as a process, and checks what it writes, reports and warns of.

check_reconstruct.py GLARK: the launcher that was built.
"""
import json
import random
import unittest

from command_case import CommandCase, sphere


class Reconstruct(CommandCase):
    def test_reconstruct_carries_colours(self):
        self.needs("reconstruct")
        points, _ = sphere(60)
        header = ["ply", "format ascii 1.0", f"element vertex {len(points)}"]
        header += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
        header += [f"property uchar {name}" for name in ("red", "green", "blue")] + ["end_header", ""]
        rows = [" ".join(map(str, point + point)) + (" 200 10 30\n" if point[0] > 0 else " 20 90 250\n") for point in points]
        (self.path / "painted.ply").write_text("\n".join(header) + "".join(rows))
        result = self.glark("reconstruct", "painted.ply", "-o", "a.obj")
        self.assertNotIn("colour", result.stderr)
        vertices = [list(map(float, line.split()[1:])) for line in (self.path / "a.obj").read_text().splitlines() if line.startswith("v ")]
        self.assertGreater(len(vertices), 1000)
        for vertex in vertices:
            if abs(vertex[0]) < 0.2:
                continue
            wanted = (200, 10, 30) if vertex[0] > 0 else (20, 90, 250)
            for channel, value in zip(vertex[3:6], wanted, strict=True):
                self.assertAlmostEqual(value / 255, channel, delta=0.005)
        self.glark("reconstruct", self.sphere, "-o", "plain.obj")
        self.assertEqual(3, len((self.path / "plain.obj").read_text().split("v ", 1)[1].splitlines()[0].split()))

    def test_reconstruct_keeps_both_plates(self):
        """Two squares, some distances of points apart."""
        self.needs("reconstruct")
        for distance in (0.5, 0.75, 1, 1.5, 2):
            with self.subTest(distance=distance):
                (self.path / "plates.xyz").write_text("".join(
                    f"{x / 99} {y / 99} {side / 99 * distance} 0 0 {2 * side - 1}\n"
                    for side in range(2) for x in range(100) for y in range(100)))
                result = self.glark("reconstruct", "plates.xyz", "-o", "a.ply", "--json")
                self.assertEqual("", result.stderr)
                self.assertLessEqual(json.loads(result.stdout)["output"]["triangles"], 2 * 20000)
                topology = self.report("info", "a.ply")["topology"]
                self.assertEqual((2, 0), (topology["components"], topology["non_manifold_edges"]))
                self.assertLess(self.report("info", "a.ply", "--measure", "plates.xyz")["quality"]["rms_percent"], 0.3)

    def test_reconstruct_with_a_number_of_triangles(self):
        self.needs("reconstruct")
        whole = self.report("reconstruct", self.sphere, "-o", "a.ply")
        few = self.report("reconstruct", self.sphere, "-o", "b.ply", "--triangles", "3000", "--measure", self.sphere)
        self.assertGreater(whole["output"]["triangles"], 3000)
        self.assertTrue(2800 <= few["output"]["triangles"] <= 3000, few["output"])
        self.assertGreater(few["simplification_seconds"], 0)
        self.assertLess(few["quality"]["rms_percent"], 0.2)
        self.assertLessEqual(whole["output"]["triangles"], 2 * whole["input"]["points"])
        more = self.report("reconstruct", self.sphere, "-o", "c.ply", "--triangles", "9999999999999999999999")
        self.assertGreater(more["output"]["triangles"], whole["output"]["triangles"])
        self.assertIn("is not a whole number", self.glark("reconstruct", self.sphere, "-o", "d.ply", "--triangles", "0",
                                                                status=2).stderr)

    def test_reconstruct_takes_the_normals_of_triangles(self):
        """The mesh faces outwards, although the topmost point is on a side that faces inwards."""
        self.needs("reconstruct")
        points, triangles = sphere(40)
        inner = [tuple(0.5 * c for c in point) for point in points]
        rows = ["v %.7g %.7g %.7g\n" % point for point in points + inner]
        rows += ["f %d %d %d\n" % tuple(i + 1 for i in triangle) for triangle in triangles]
        rows += ["f %d %d %d\n" % tuple(len(points) + i + 1 for i in reversed(triangle)) for triangle in triangles]
        (self.path / "shell.obj").write_text("".join(rows))
        result = self.glark("reconstruct", "shell.obj", "-o", "a.ply", "--json", "--measure", "shell.obj")
        self.assertIn("those of its triangles are used", result.stderr)
        self.assertNotIn("normals_seconds", json.loads(result.stdout))
        self.assertLess(json.loads(result.stdout)["quality"]["normals_rms_degrees"], 10)

    def test_reconstruct_tells_what_it_leaves_out(self):
        self.needs("reconstruct")
        result = self.glark("reconstruct", self.sphere, "-o", "a.ply", "--json")
        self.assertNotIn("left out", result.stderr)
        self.assertEqual(0, json.loads(result.stdout)["points_left_out"])
        points, _ = sphere(60)
        rows = [" ".join(map(str, point + point)) + "\n" for point in points]
        rows += [" ".join(map(str, [0.08 * x + 3 * (k == 0) for k, x in enumerate(point)] + list(point))) + "\n" for point in sphere(20)[0]]
        (self.path / "two.xyz").write_text("".join(rows))
        result = self.glark("reconstruct", "two.xyz", "-o", "a.ply", "--json")
        report = json.loads(result.stdout)
        self.assertEqual(1, report["parts_left_out"])
        self.assertAlmostEqual(0.6, report["area_left_out_percent"], delta=0.1)
        self.assertRegex(result.stderr, r"of the area are left out: 1, with 0\.[567]\d* % of the area together; --least-part 0 keeps them")
        self.assertEqual(762, report["points_left_out"])
        self.assertIn(f"762 of {len(rows)} points are left out", result.stderr)
        self.assertNotIn("left out", self.glark("reconstruct", "two.xyz", "-o", "a.ply", "--least-part", "0").stderr)

    def test_reconstruct_measures_the_loss(self):
        """Fins nearer to each other than their points: most of them are lost, which is an error. A part of a cloud is a warning."""
        self.needs("reconstruct")
        for seed in (1, 2):
            number = random.Random(seed)
            rows = ["%.6g %.6g %.6g 0 %d 0\n" % (number.random(), 0.01 * (fin + 0.2 * side), 0.3 * number.random(), side)
                    for fin in range(20) for side in (-1, 1) for _ in range(3000)]
            (self.path / "fins.xyz").write_text("".join(rows))
            (self.path / "a.ply").unlink(missing_ok=True)
            error = self.glark("reconstruct", "fins.xyz", "-o", "a.ply", status=1).stderr
            self.assertRegex(error, r"the mesh does not represent about \d+ % of the points \(estimated from 20000 of them\), so nothing is written")
            self.assertFalse((self.path / "a.ply").exists())
        report = self.report("reconstruct", self.sphere, "-o", "a.ply")
        self.assertEqual((0, 0, 0, 0), tuple(report[name] for name in ("points_left_out", "boundary_edges", "boundary_length", "non_manifold_edges")))
        self.assertGreater(report["points_measured"], 1000)

    def test_reconstruct_samples_large_triangles(self):
        """Two blocks on one another, of 24 triangles."""
        self.needs("reconstruct")
        rows, faces = [], []
        for k, size in enumerate((1, 0.4)):
            rows += ["v %g %g %g\n" % (size * (i % 2 * 2 - 1), size * (i // 2 % 2 * 2 - 1), size * (i // 4 * 2 - 1) + 3 * k) for i in range(8)]
            for a, b, c, d in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
                faces += ["f %d %d %d\n" % tuple(8 * k + i + 1 for i in face) for face in ((a, b, c), (a, c, d))]
        (self.path / "blocks.obj").write_text("".join(rows + faces))
        result = self.glark("reconstruct", "blocks.obj", "-o", "a.ply", "--json", "--measure", "blocks.obj")
        report = json.loads(result.stdout)
        self.assertIn("large triangles, whose corners do not show the surface; 100000 points on them are used", result.stderr)
        self.assertEqual((8 * 2, 24), (report["input"]["points"], report["input"]["triangles"]))
        self.assertEqual(2, report["topology"]["components"])
        self.assertLess(report["quality"]["rms_percent"], 0.1)
        self.assertEqual(0, report["non_manifold_edges"])
        self.assertNotIn("large triangles", self.glark("reconstruct", self.sphere, "-o", "a.ply").stderr)


if __name__ == "__main__":
    unittest.main()
