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
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

GLARK = ""


def sphere(rows: int) -> tuple:
    """Points with normals and the triangles of a closed sphere."""
    points, triangles = [(0.0, 0.0, 1.0)], []
    for row in range(1, rows):
        for column in range(2 * rows):
            high, turn = math.pi * row / rows, math.pi * column / rows
            points.append((math.sin(high) * math.cos(turn), math.sin(high) * math.sin(turn), math.cos(high)))
    points.append((0.0, 0.0, -1.0))
    around, last = 2 * rows, len(points) - 1
    for column in range(around):
        beside = (column + 1) % around
        triangles.append((0, 1 + column, 1 + beside))
        triangles.append((last, last - around + beside, last - around + column))
        for row in range(rows - 2):
            a, b = 1 + row * around + column, 1 + row * around + beside
            triangles += [(a, a + around, b), (b, a + around, b + around)]
    return points, triangles


def write_ply(path: pathlib.Path, points: list, triangles: list) -> pathlib.Path:
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}"]
    header += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
    header += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header", ""]
    body = b"".join(struct.pack("<6f", *point, *point) for point in points)
    body += b"".join(struct.pack("<B3i", 3, *triangle) for triangle in triangles)
    path.write_bytes("\n".join(header).encode() + body)
    return path


def commands_of(help_text: str) -> list:
    listed = help_text[help_text.index("Subcommands:"):]
    return [line.split()[0] for line in listed.splitlines()[1:] if line.strip() and not line.startswith("    ")]


class Commands(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)
        self.sphere = write_ply(self.path / "sphere.ply", *sphere(40))
        self.has = set(commands_of(subprocess.run([GLARK, "--help"], capture_output=True, text=True).stdout))

    def tearDown(self):
        self.folder.cleanup()

    def glark(self, *arguments, status=0) -> subprocess.CompletedProcess:
        result = subprocess.run([GLARK, *map(str, arguments)], capture_output=True, text=True, cwd=self.path)
        self.assertEqual(status, result.returncode, result.stdout + result.stderr)
        return result

    def report(self, *arguments) -> dict:
        return json.loads(self.glark(*arguments, "--json").stdout)

    def needs(self, command: str):
        if command not in self.has:
            self.skipTest(f"glark {command} was not built")

    def test_info(self):
        report = self.report("info", self.sphere)
        self.assertEqual((3122, 6240, True, 1), (report["points"], report["triangles"], report["topology"]["closed"],
                                                 report["topology"]["components"]))
        self.assertIn("closed", self.glark("info", self.sphere).stdout)
        self.assertIn("OSMesa", self.glark("info").stdout)

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
        square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
        for name, rest, says in [
            ("seam.obj", "vt 0 0\nvt 0.5 0\nvt 0.5 1\nvt 1 0.5\nf 1/1 2/2 3/3\nf 1/1 3/4 4/2\n", True),
            ("whole.obj", "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n", False),
        ]:
            (self.path / name).write_text(square + rest)
            result = self.glark("simplify", name, "-o", "a.obj", "--target", "10")
            self.assertEqual(says, "seams at 1 points" in result.stderr, result.stderr)
            self.assertIn("vt ", (self.path / "a.obj").read_text())
        header = ["ply", "format ascii 1.0", "element vertex 2"]
        header += [f"property float {name}" for name in "xyz"]
        header += [f"property uchar {name}" for name in ("red", "green", "blue", "alpha")] + ["end_header", ""]
        (self.path / "glass.ply").write_text("\n".join(header) + "0 0 0 9 9 9 255\n1 0 0 9 9 9 80\n")
        result = self.glark("simplify", "glass.ply", "-o", "a.ply", "--target", "10")
        self.assertIn("point 1 is not opaque", result.stderr)

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

    def test_view(self):
        self.needs("view")
        for mode in ("splat", "strip", "mesh", "wireframe", "refined"):
            with self.subTest(mode=mode):
                self.glark("view", self.sphere, "--mode", mode, "--offscreen", "a.png", "--width", "90", "--height", "70")
                picture = (self.path / "a.png").read_bytes()
                self.assertEqual((b"\x89PNG\r\n\x1a\n", 90, 70), (picture[:8], *struct.unpack(">2I", picture[16:24])))
                self.assertGreater(len(picture), 1000)  # more than the background
        self.assertGreater(self.report("view", self.sphere, "--mode", "strip", "--offscreen", "a.png")["nodes_turned_away"], 0)
        # Without an EGL driver, OSMesa draws the same picture.
        pictures = []
        for environment in ({}, {"__EGL_VENDOR_LIBRARY_DIRS": "/nowhere", "LIBGL_DRIVERS_PATH": "/nowhere"}):
            result = subprocess.run([GLARK, "view", self.sphere, "--mode", "refined", "--offscreen", "b.png"], cwd=self.path,
                                    capture_output=True, text=True, env={**os.environ, **environment})
            self.assertEqual(0, result.returncode, result.stderr)
            pictures.append((self.path / "b.png").read_bytes())
        self.assertEqual(pictures[0], pictures[1])
        display = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
        result = subprocess.run([GLARK, "view", self.sphere], capture_output=True, text=True, env=display)
        self.assertEqual(1, result.returncode)
        self.assertIn("--offscreen", result.stderr)

    def test_window(self):
        """Keys choose the mode, write a screenshot and quit."""
        self.needs("view")
        if not shutil.which("xvfb-run") or not shutil.which("xdotool"):
            self.assertNotEqual("true", os.environ.get("CI"), "xvfb or xdotool is not installed; run scripts/install_packages")
            self.skipTest("xvfb or xdotool is not installed")
        script = f"""
            "{GLARK}" view sphere.ply --mode strip --width 200 --height 150 & program=$!
            window=$(xdotool search --sync --onlyvisible --name "glark sphere" | head -1)
            until xdotool getwindowname "$window" | grep -q "turned away"; do sleep 0.1; done
            xdotool windowfocus --sync "$window"
            for key in 5 plus u c s q; do xdotool key --window "$window" "$key"; sleep 0.5; done
            wait $program"""
        result = subprocess.run(["xvfb-run", "-a", "timeout", "60", "bash", "-c", script], capture_output=True, text=True, cwd=self.path)
        self.assertEqual(0, result.returncode, result.stdout + result.stderr)
        self.assertIn("glark-1.png", result.stdout)
        self.assertEqual(b"\x89PNG", (self.path / "glark-1.png").read_bytes()[:4])

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
                ("simplify", "--target", "0", '"0" is not a number above 0'), ("simplify", "--error", "inf", '"inf" is not a number above 0'),
                ("simplify", "--error", "nan", '"nan" is not a number above 0'), ("view", "--mode", "foo", "not one of splat, strip, mesh")):
            if command not in self.has:
                continue
            output = "--offscreen" if command == "view" else "-o"
            with self.subTest(option=option, given=given):
                result = self.glark(command, self.sphere, output, "out.png", option, given, status=2)
                self.assertIn(f"{option}: ", result.stderr)
                self.assertIn(said, result.stderr)
                self.assertNotIn("->", self.glark(command, "--help").stdout)

    def test_results_of_nothing_are_told(self):
        (self.path / "flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
        (self.path / "line.xyz").write_text("0 0 0\n1 0 0\n2 0 0\n")
        for command, file, said in (("simplify", "flat.obj", "the result is empty"), ("strip", "line.xyz", "no strips")):
            if command not in self.has:
                continue
            with self.subTest(command=command):
                result = self.glark(command, file, "-o", "a.ply", "--json", "--measure", file)
                self.assertIn(said, result.stderr)
                self.assertIn("quality", json.loads(result.stdout))
                self.assertNotIn("null", result.stdout)
        if "view" in self.has:
            self.assertIn("--mode splat", self.glark("view", "line.xyz", "--offscreen", "a.png").stderr)
            self.assertNotIn("--mode", self.glark("view", "line.xyz", "--mode", "splat", "--offscreen", "a.png").stderr)

    def test_pictures_are_png(self):
        if "view" in self.has:
            self.assertIn("call it OUT.png", self.glark("view", self.sphere, "--offscreen", "a.jpg", status=1).stderr)
            self.assertFalse((self.path / "a.jpg").exists())

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
    GLARK = os.path.abspath(sys.argv.pop(1))
    unittest.main()
