# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Runs the launcher's commands for files as processes, and checks exit status, messages, reports, and that no output is half written.

check_commands.py GLARK: the launcher that was built.
"""
import json
import math
import pathlib
import pty
import os
import random
import shutil
import subprocess
import unittest

from command_case import GLARK, CommandCase, sphere, write_ply


class Commands(CommandCase):
    def test_info(self):
        report = self.report("info", self.sphere)
        self.assertEqual((3122, 6240, True, 1), (report["points"], report["triangles"], report["topology"]["closed"],
                                                 report["topology"]["components"]))
        self.assertIn("closed", self.glark("info", self.sphere).stdout)
        self.assertIn("OSMesa", self.glark("info").stdout)

    def test_standard_input_with_a_format(self):
        with open(self.sphere, "rb") as file:
            done = subprocess.run([GLARK, "info", "-", "--format", "ply", "--json"], stdin=file, capture_output=True, text=True)
        self.assertEqual(3122, json.loads(done.stdout)["points"], done.stderr)
        with open(self.sphere, "rb") as file:
            done = subprocess.run([GLARK, "info", "-"], stdin=file, capture_output=True, text=True)
        self.assertEqual(1, done.returncode)
        self.assertIn("--format", done.stderr)

    def test_a_pipe_of_any_format(self):
        formats = [".ply", ".obj", ".stl", ".glb", ".xyz", ".pts"]
        outputs = ["a" + ending for ending in formats]
        self.needs("simplify")
        for output in outputs:
            self.glark("simplify", self.sphere, "-o", output, "--target", "100000")
        for ending, file in zip(formats, outputs):
            count = self.report("info", file)["points"]
            for command in (("info", "-"), ("simplify", "-", "-o", "b.ply", "--target", "100000"), ("reconstruct", "-", "-o", "b.ply")):
                if command[0] == "reconstruct":
                    self.needs("reconstruct")
                done = subprocess.run([GLARK, *command, "--format", ending[1:], "--json"], input=(self.path / file).read_bytes(),
                                      capture_output=True, cwd=self.path)
                self.assertEqual(0, done.returncode, (command, ending, done.stderr))
                report = json.loads(done.stdout)
                self.assertEqual(count, report.get("input", report)["points"], (command, ending))

    def test_stl_far_from_zero_is_a_warning(self):
        self.needs("simplify")
        points, triangles = sphere(10)
        far = self.path / "far.off"
        far.write_text(f"OFF\n{len(points)} {len(triangles)} 0\n" + "".join(f"{x + 5e6} {y} {z}\n" for x, y, z in points)
                       + "".join(f"3 {a} {b} {c}\n" for a, b, c in triangles))
        for output, is_lossy in (("a.stl", True), ("a.obj", False), ("a.ply", False)):
            done = self.glark("simplify", far, "-o", output, "--target", "100000")
            self.assertEqual(is_lossy, "STL has floats" in done.stderr, (output, done.stderr))

    def test_measure_of_the_same_is_nothing(self):
        quality = self.report("info", self.sphere, "--measure", self.sphere)["quality"]
        self.assertLess(quality["hausdorff_percent"], 1e-6)
        self.assertLess(quality["normals_rms_degrees"], 1e-3)

    def test_measure_knows_a_distance(self):
        points, triangles = sphere(40)
        larger = write_ply(self.path / "larger.ply", [tuple(1.1 * c for c in point) for point in points], triangles)
        quality = self.report("info", larger, "--measure", self.sphere)["quality"]
        diagonal = 2 * math.sqrt(3)
        self.assertAlmostEqual(0.1 / diagonal * 100, quality["rms_percent"], delta=0.02)
        self.assertAlmostEqual(0.1 / diagonal * 100, quality["hausdorff_percent"], delta=0.03)

    def test_simplify(self):
        self.needs("simplify")
        report = self.report("simplify", self.sphere, "-o", "coarse.ply", "--target", "1000", "--measure", self.sphere)
        self.assertLessEqual(report["output"]["triangles"], 1000)
        self.assertGreater(report["output"]["triangles"], 900)
        self.assertLess(report["quality"]["rms_percent"], 1)
        self.assertEqual(report["output"]["points"], self.report("info", "coarse.ply")["points"])
        self.glark("simplify", self.sphere, "-o", "a.glb", "--error", "0.01", "--clustering", "grid", "--representative", "centroid")

    def test_simplify_chooses_a_method(self):
        self.needs("simplify")
        for words, method in [((), "collapse"), (("--fast",), "cluster"), (("--method", "cluster"), "cluster"),
                              (("--clustering", "grid"), "cluster"), (("--method", "collapse"), "collapse")]:
            report = self.report("simplify", self.sphere, "-o", "a.ply", "--target", "1000", *words)
            self.assertEqual(method, report["method"], words)
            self.assertLessEqual(report["output"]["triangles"], 1000)
        self.assertEqual("cluster", self.report("simplify", self.sphere, "-o", "a.ply", "--error", "0.01")["method"])
        last = 6240
        for most in ("1e-3", "1e-2"):
            report = self.report("simplify", self.sphere, "-o", "a.ply", "--max-error", most, "--measure", self.sphere)
            self.assertLess(report["output"]["triangles"], last)
            self.assertLessEqual(report["measured_error_percent"], 100 * float(most))
            self.assertAlmostEqual(report["measured_error_percent"], report["quality"]["hausdorff_percent"], 6)
            self.assertLess(report["quality"]["rms_percent"], 100 * float(most))
            last = report["output"]["triangles"]
        for words in (("--fast", "--max-error", "1"), ("--fast", "--method", "collapse"), ("--error", "1", "--max-error", "1")):
            self.glark("simplify", self.sphere, "-o", "a.ply", *words, status=2)
        self.assertIn("max_error needs the method collapse", self.glark(
            "simplify", self.sphere, "-o", "a.ply", "--method", "cluster", "--max-error", "1", status=1).stderr)
        self.assertIn("the result is empty; nothing is written", self.glark(
            "simplify", self.sphere, "-o", "a.ply", "--target", "1", "--method", "collapse", status=1).stderr)
        self.assertRegex(self.glark(
            "simplify", self.sphere, "-o", "a.ply", "--target", "1", "--method", "collapse", status=1).stderr,
            "--target 1 is too small for its shape, .* --target [0-9]+ works")
        for rows in (20, 30):  # both sides of a square
            lines = [f"v {x} {y} 0" for x in range(rows) for y in range(rows)]
            for i in (rows * x + y + 1 for x in range(rows - 1) for y in range(rows - 1)):
                a, b, c, d = i, i + rows, i + rows + 1, i + 1
                lines += [f"f {a} {b} {c} {d}", f"f {a} {d} {c} {b}"]
            (self.path / "doubled.obj").write_text("\n".join(lines) + "\n")
            self.assertIn("cancel, and the result is empty; nothing is written; use --method collapse", self.glark(
                "simplify", "doubled.obj", "-o", "a.ply", "--target", str(rows * rows), "--fast", status=1).stderr)
            lines += [f"v {x + 2 * rows} {y} 0" for x in range(rows) for y in range(rows)]  # one side only
            for i in (rows * (rows + x) + y + 1 for x in range(rows - 1) for y in range(rows - 1)):
                lines.append(f"f {i} {i + rows} {i + rows + 1} {i + 1}")
            (self.path / "half.obj").write_text("\n".join(lines) + "\n")
            self.assertRegex(self.glark("simplify", "half.obj", "-o", "a.ply", "--target", str(rows * rows), "--fast").stderr,
                             f"[0-9]+ triangles are left, far fewer than --target {rows * rows}: .*--method collapse")
        cube = self.path / "cube.obj"  # every corner has three texture coordinates
        faces = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))
        lines = [f"v {x} {y} {z}" for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        lines += [f"vt {i / 24} {i % 4 / 4}" for i in range(24)]
        lines += ["f " + " ".join(f"{v}/{4 * i + k + 1}" for k, v in enumerate(face)) for i, face in enumerate(faces)]
        cube.write_text("\n".join(lines) + "\n")
        self.assertIn("no further edge can collapse; 12 triangles are left", self.glark(
            "simplify", cube, "-o", "a.ply", "--target", "3", "--method", "collapse").stderr)

    def test_bake(self):
        self.needs("bake")
        self.glark("simplify", self.sphere, "-o", "coarse.ply", "--target", "300")
        words = ("bake", self.sphere, "--mesh", "coarse.ply", "--texture-memory", "1MB")
        report = self.report(*words, "-o", "a.glb")
        self.assertEqual((0, 0), (report["points_left_out"], report["charts_without_points"]))
        self.assertLessEqual(report["width"] * report["height"] * 5 * 4 / 3, 1 << 20)  # 5 bytes a texel, and the mipmaps
        self.assertEqual(report["triangles"], self.report("info", "a.glb")["triangles"])
        self.assertEqual(self.report("info", "coarse.ply")["triangles"], report["triangles"])
        picture = (self.path / "a.displacement.png").read_bytes()
        self.assertEqual((b"\x89PNG", report["width"], 16), (picture[:4], int.from_bytes(picture[16:20], "big"), picture[24]))
        for threads in ("1", "3"):
            self.glark(*words, "-o", "a.glb", "--threads", threads)
            self.assertEqual(picture, (self.path / "a.displacement.png").read_bytes())
        points, _ = sphere(40)
        (self.path / "points.xyz").write_text("".join("%g %g %g %g %g %g\n" % (*point, *point) for point in points))
        for file in (self.sphere, "points.xyz"):  # without --mesh: fewer triangles, or strips of samples
            coarse = self.report("bake", file, "-o", "b.glb", "--triangles", "500")["triangles"]
            self.assertTrue(300 < coarse <= 500, coarse)
        self.assertIn("--reach takes in points farther away", self.glark(*words, "-o", "a.glb", "--reach", "1e-3").stderr)
        for more, status, text in ((("-o", "a.obj"), 1, "give a name that ends with .glb"),
                                   (("-o", "c.glb", "--reach", "-1"), 2, "--reach"),
                                   (("-o", "c.glb", "--texels-per-point", "65"), 2, "--texels-per-point: \"65\""),
                                   (("-o", "c.glb", "--mesh", "points.xyz"), 1, "it has no triangles")):
            words = ("bake", self.sphere, *(() if "--mesh" in more else ("--mesh", "coarse.ply")))
            self.assertIn(text, self.glark(*words, *more, status=status).stderr)
        self.assertFalse((self.path / "c.glb").exists())

    def test_any_number_of_threads_gives_the_same(self):
        for command in ("simplify", "strip", "reconstruct"):
            if command not in self.has:
                continue
            options = ("--target", "1000") if command == "simplify" else ()
            with self.subTest(command=command):
                for threads in ("1", "3"):
                    self.glark(command, self.sphere, "-o", threads + ".ply", "--threads", threads, *options)
                self.assertEqual((self.path / "1.ply").read_bytes(), (self.path / "3.ply").read_bytes())
                self.assertIn("--threads", self.glark(command, self.sphere, "-o", "a.ply", "--threads", "few", status=2).stderr)

    def test_simplify_says_what_it_cannot_keep(self):
        self.needs("simplify")
        points, triangles = sphere(10)
        vertices = "".join("v %g %g %g\n" % point + "vt %g %g\n" % point[:2] for point in points) + "vt 0.5 0.5\n"
        corners = [[f"{i + 1}/{i + 1}" for i in triangle] for triangle in triangles]
        seam = [[f"1/{len(points) + 1}", *corners[0][1:]], *corners[1:]]
        for name, faces, says in [("seam.obj", seam, True), ("whole.obj", corners, False)]:
            (self.path / name).write_text(vertices + "".join("f " + " ".join(face) + "\n" for face in faces))
            self.assertNotIn("seams", self.glark("simplify", name, "-o", "a.obj", "--target", "200").stderr)
            result = self.glark("simplify", name, "-o", "a.obj", "--target", "200", "--fast")
            self.assertEqual(says, "seams at 1 points" in result.stderr, result.stderr)
            self.assertIn("vt ", (self.path / "a.obj").read_text())
        header = ["ply", "format ascii 1.0", "element vertex 2"]
        header += [f"property float {name}" for name in "xyz"]
        header += [f"property uchar {name}" for name in ("red", "green", "blue", "alpha")] + ["end_header", ""]
        (self.path / "glass.ply").write_text("\n".join(header) + "0 0 0 9 9 9 255\n1 0 0 9 9 9 80\n")
        result = self.glark("simplify", "glass.ply", "-o", "a.ply", "--target", "1")
        self.assertIn("point 1 is not opaque", result.stderr)

    def test_strip(self):
        self.needs("strip")
        report = self.report("strip", self.sphere, "-o", "strips.ply", "--measure", self.sphere)
        self.assertEqual(3122, report["output"]["points"])
        self.assertIn(b"element tristrips", (self.path / "strips.ply").read_bytes())
        self.assertEqual(report["output"]["triangles"], self.report("info", "strips.ply")["triangles"])
        self.assertLess(report["quality"]["rms_percent"], 0.1)
        kept = self.report("strip", self.sphere, "-o", "kept.ply", "--keep-edges")
        self.assertEqual(report["output"]["triangles"], kept["output"]["triangles"])
        self.assertLess(report["indices"], kept["indices"])
        self.assertEqual(0, report["outliers"])

    def test_strips_know_what_a_mesh_tells(self):
        self.needs("strip")
        corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        sides = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]
        text = "".join("v {} {} {}\n".format(*c) for c in corners) + "".join("f {} {} {} {}\n".format(*s) for s in sides)
        (self.path / "box.obj").write_text(text)
        report = self.report("strip", "box.obj", "-o", "box.ply")
        self.assertEqual(report["points_without_triangles"], self.report("info", "box.ply")["topology"]["points_without_triangles"])
        done = self.glark("strip", "box.obj", "-o", "box.ply", status=0 if report["output"]["triangles"] else 1)
        self.assertIn("those of its triangles are used", done.stderr)
        if report["points_without_triangles"]:
            self.assertIn("have no triangle", done.stderr)

    def test_strips_do_not_join_outliers(self):
        self.needs("strip")
        self.needs("reconstruct")
        points, _ = sphere(70)
        for seed in (1, 2, 3):
            chance = random.Random(seed)
            outliers = [tuple(chance.uniform(-1.5, 1.5) for _ in range(3)) for _ in range(len(points) // 50)]
            cloud = write_ply(self.path / "cloud.ply", points + outliers, [])
            report = self.report("strip", cloud, "-o", "strips.ply", "--measure", self.sphere)
            self.assertEqual(len(points) + len(outliers), report["output"]["points"])
            self.assertGreater(report["outliers"], 0.9 * len(outliers))
            self.assertLess(report["outliers"], 1.02 * len(outliers))
            self.assertLess(report["quality"]["hausdorff_percent"], 3)
            self.assertLess(report["quality"]["rms_percent"], 0.3)
            done = self.glark("strip", cloud, "-o", "strips.ply")
            self.assertIn("lie on no surface", done.stderr)

    def test_wrong_words(self):
        for arguments in (["info", "--nonsense"], ["simplify"], ["strip", "a.ply"], ["strip", "a.ply", "-o", "b.ply", "--reach", "-1"]):
            if arguments[0] != "info" and arguments[0] not in self.has:
                continue
            with self.subTest(arguments=arguments):
                self.assertIn("--help", self.glark(*arguments, status=2).stderr)

    def test_words_and_numbers_that_are_not_possible(self):
        """Messages list the possible values in the words of the manual."""
        for command, option, given, said in (
                ("simplify", "--clustering", "foo", '"foo" is not one of vstree, octree, grid'), ("simplify", "--metric", "2", "not one of l2, l21, qef, density"),
                ("simplify", "--target", "0", '"0" is not a whole number above 0'), ("simplify", "--error", "inf", '"inf" is not a number above 0'),
                ("simplify", "--error", "nan", '"nan" is not a number above 0'), ("simplify", "--error", "1e300", '"1e300" is not a number above 0 (1.2e-38 to 1e+18)'),
                ("simplify", "--max-error", "1.1e18", '"1.1e18" is not a number above 0'), ("simplify", "--error", "1e-300", '"1e-300" is not a number above 0'),
                ("simplify", "--error", "-1", '"-1" is not a number above 0'), ("view", "--mode", "foo", "not one of splat, strip, mesh"),
                ("simplify", "--target", "-18446744073709551615", "is not a whole number above 0"), ("simplify", "--target", "nan", '"nan" is not a whole'),
                ("simplify", "--target", "1.5", '"1.5" is not a whole number'), ("simplify", "--target", "1e30", '"1e30" is not a whole number'),
                ("strip", "--reach", "nan", '"nan" is not a number from 1 to 100'), ("reconstruct", "--node-samples", "nan", "is not a number from 2 to 1000"), ("reconstruct", "--error", "1e300", '"1e300" is not a number from 0 to 1'),
                ("view", "--zoom", "nan", '"nan" is not a number from 0.01 to 1000'), ("view", "--yaw", "nan", "is not a number from -360 to 360")):
            if command not in self.has:
                continue
            output = "--offscreen" if command == "view" else "-o"
            with self.subTest(option=option, given=given):
                result = self.glark(command, self.sphere, output, "out.png", option, given, status=2)
                self.assertIn(f"{option}: ", result.stderr)
                self.assertIn(said, result.stderr)
                self.assertNotIn("->", self.glark(command, "--help").stdout)

    def test_simplify_tells_of_other_connections(self):
        """A part that vanishes is told; a sphere keeps its connections."""
        self.needs("simplify")
        same = self.glark("simplify", self.sphere, "-o", "a.ply", "--target", "1000", "--json")
        self.assertEqual("", same.stderr)
        keys = ("parts_before", "parts_after", "non_manifold_edges_added")
        self.assertEqual([1, 1, 0], [json.loads(same.stdout)[key] for key in keys])
        points, triangles = sphere(40)
        tiny, faces = sphere(3)
        two = points + [(2 + 1e-5 * x, 1e-5 * y, 1e-5 * z) for x, y, z in tiny]
        write_ply(self.path / "two.ply", two, triangles + [tuple(len(points) + i for i in face) for face in faces])
        lost = self.glark("simplify", "two.ply", "-o", "a.ply", "--target", "100", "--fast", "--json")
        self.assertIn("glark: a.ply: 2 connected parts became 1\n", lost.stderr)
        self.assertEqual([2, 1, 0], [json.loads(lost.stdout)[key] for key in keys])

    def test_a_link_to_a_missing_file_stays_a_link(self):
        self.needs("simplify")
        (self.path / "d.ply").symlink_to("nowhere.ply")
        self.glark("simplify", self.sphere, "-o", "d.ply", "--target", "90")
        self.assertTrue((self.path / "d.ply").is_symlink())
        self.assertTrue((self.path / "nowhere.ply").is_file())

    def test_a_target_above_what_there_is_gives_the_input(self):
        self.needs("simplify")
        (self.path / "points.xyz").write_text("".join(f"{i} {i * i} 0\n" for i in range(9)))
        for file, has, count in ((self.sphere, "triangles", 6240), ("points.xyz", "points", 9)):
            self.glark("simplify", file, "-o", "whole" + pathlib.Path(file).suffix, "--target", count)
            for target in (count, count + 1, 2**32, 2**63, 2**64 - 1, 2**64, 2**64 + 1, 10**30):
                with self.subTest(file=file, target=target):
                    copy = self.path / ("copy" + pathlib.Path(file).suffix)
                    shutil.copy(self.path / file, copy)
                    result = self.glark("simplify", copy, "-o", copy, "--target", target, "--json")
                    self.assertEqual(count, json.loads(result.stdout)["output"][has])
                    self.assertIn(f"no more {has} than --target allows", result.stderr)
                    self.assertEqual((self.path / ("whole" + copy.suffix)).read_bytes(), copy.read_bytes())
        self.assertEqual(self.sphere.read_bytes()[-6240 * 13:], (self.path / "whole.ply").read_bytes()[-6240 * 13:])
        report = self.report("simplify", self.sphere, "-o", "a.ply", "--target", "01000")  # no octal number
        self.assertGreater(report["output"]["triangles"], 900)

    def test_empty_results_are_errors(self):
        """An empty result is an error with a remedy, and the old output file stays."""
        (self.path / "flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
        (self.path / "line.xyz").write_text("0 0 0\n1 0 0\n2 0 0\n")
        before = set(os.listdir(self.path))
        for command, file, said, remedy in (
                ("simplify", "flat.obj", "the result is empty", "--target"), ("strip", "line.xyz", "no strips", "--reach"),
                ("reconstruct", "line.xyz", "the mesh is empty", "--node-samples")):
            if command not in self.has:
                continue
            (self.path / file).chmod(0o640)
            old = (self.path / file).read_bytes()
            for output in ("a.ply", file):
                with self.subTest(command=command, file=file, output=output):
                    result = self.glark(command, file, "-o", output, "--json", status=1)
                    self.assertIn(said, result.stderr)
                    self.assertIn(remedy, result.stderr)
                    self.assertEqual("", result.stdout)
                    self.assertEqual(old, (self.path / file).read_bytes())
                    self.assertEqual(before, set(os.listdir(self.path)))

    def test_output_keeps_the_mode_and_tells_of_hard_links(self):
        self.needs("simplify")
        output = self.path / "a.ply"
        output.write_text("old")
        output.chmod(0o640)
        self.assertNotIn("hard link", self.glark("simplify", self.sphere, "-o", output, "--target", "99").stderr)
        self.assertEqual(0o640, output.stat().st_mode & 0o7777)
        os.link(output, self.path / "b.ply")
        old = output.read_bytes()
        self.assertIn("other hard links to the old file keep the old contents: 1", self.glark("simplify", self.sphere, "-o", output, "--target", "999").stderr)
        self.assertEqual(old, (self.path / "b.ply").read_bytes())
        self.assertNotEqual(old, output.read_bytes())

    def test_names_that_are_not_utf_8(self):
        name = os.path.join(os.fsencode(self.path), b"b\xff.ply")
        shutil.copy(self.sphere, name)
        result = subprocess.run([GLARK.encode(), b"info", name, b"--json", b"--measure", name], capture_output=True)
        self.assertEqual(0, result.returncode, result.stderr)
        self.assertIn("b\ufffd.ply", json.loads(result.stdout.decode("utf-8"))["file"])

    def test_bad_files_leave_the_output_alone(self):
        (self.path / "out.ply").write_text("precious")
        (self.path / "cut.ply").write_bytes(self.sphere.read_bytes()[:9999])
        (self.path / "empty.ply").write_bytes(b"")
        before = set(os.listdir(self.path))
        for command in self.has & {"simplify", "strip"}:
            for name, said in (("cut.ply", "too short"), ("empty.ply", "empty"), ("missing.ply", "No such file")):
                with self.subTest(command=command, name=name):
                    message = self.glark(command, name, "-o", "out.ply", status=1).stderr
                    self.assertIn(said, message)
                    self.assertIn(name, message)
            self.assertIn("ending", self.glark(command, self.sphere, "-o", "out.doc", status=1).stderr)
            self.assertIn("nowhere", self.glark(command, self.sphere, "-o", "nowhere/out.ply", status=1).stderr)
        self.assertEqual("precious", (self.path / "out.ply").read_text())
        self.assertEqual(before, set(os.listdir(self.path)))

    def test_strange_points(self):
        clouds = {"one": "1 2 3\n", "equal": "1 2 3\n" * 50, "line": "".join(f"{i} 0 0\n" for i in range(50)),
                  "plane": "".join(f"{i % 9} {i // 9} 0\n" for i in range(81)), "duplicates": "0 0 0\n1 0 0\n0 1 0\n0 0 1\n" * 25000,
                  "zero normals": "".join(f"{i % 9} {i // 9} {i % 4} 0 0 0\n" for i in range(81))}
        for name, text in clouds.items():
            (self.path / "a.xyz").write_text(text)
            self.report("info", "a.xyz")
            for command in self.has & {"simplify", "strip"}:
                with self.subTest(command=command, cloud=name):
                    if command == "strip" and name in ("one", "equal", "line", "duplicates"):
                        self.assertIn("no strips", self.glark(command, "a.xyz", "-o", "out.ply", status=1).stderr)
                        continue
                    self.report(command, "a.xyz", "-o", "out.ply")
                    self.assertGreater(self.report("info", "out.ply")["points"], 0)

    def test_progress_on_a_terminal_only(self):
        self.assertEqual("", self.glark("info", self.sphere).stderr)
        parent, child = pty.openpty()
        subprocess.run([GLARK, "info", self.sphere], stdout=subprocess.DEVNULL, stderr=child, check=True)
        os.close(child)
        self.assertIn(b"\r", os.read(parent, 4096))
        os.close(parent)


if __name__ == "__main__":
    unittest.main()
