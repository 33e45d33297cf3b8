# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Runs glark view as a process, without a display and in a window.

check_view.py GLARK: the launcher that was built.
"""
import functools
import os
import shutil
import struct
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "scripts/parts"))
import picture_row  # noqa: E402 (lies in the folder that the line above names)
from command_case import GLARK, CommandCase, sphere, write_ply


class View(CommandCase):
    def setUp(self):
        super().setUp()
        self.needs("view")

    def test_view(self):
        for mode in ("splat", "strip", "mesh", "wireframe", "refined", "patterns"):
            with self.subTest(mode=mode):
                self.glark("view", self.sphere, "--mode", mode, "--offscreen", "a.png", "--width", "90", "--height", "70")
                picture = (self.path / "a.png").read_bytes()
                self.assertEqual((b"\x89PNG\r\n\x1a\n", 90, 70), (picture[:8], *struct.unpack(">2I", picture[16:24])))
                self.assertGreater(len(picture), 1000)  # more than the background
        (self.path / "points.xyz").write_text("".join(
            f"{x / 20} {y / 20} 0 0 0 -1\n{x / 20} {y / 20} 1 0 0 1\n" for x in range(40) for y in range(40)))
        self.assertGreater(self.report("view", "points.xyz", "--mode", "strip", "--offscreen", "a.png")["nodes_turned_away"], 0)
        # A file with strips or triangles shows these, and no other strips of its points.
        self.needs("strip")
        self.glark("strip", "points.xyz", "-o", "strips.ply")
        for file in (self.sphere, "strips.ply"):
            mesh = self.report("view", file, "--mode", "mesh", "--offscreen", "mesh.png")
            strip = self.report("view", file, "--mode", "strip", "--offscreen", "strip.png")
            self.assertEqual(mesh, strip)
            self.assertEqual((self.path / "mesh.png").read_bytes(), (self.path / "strip.png").read_bytes())
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

    def test_zoom_stays_outside(self):
        """A closer view of the middle of a sphere shows no background, and nearly the same colour in the middle."""
        pixels = {}
        for zoom in ("1", "4", "30"):
            self.glark("view", self.sphere, "--mode", "mesh", "--zoom", zoom, "--offscreen", "a.png", "--width", "64", "--height", "64")
            _, rows = picture_row.read_png(self.path / "a.png")
            pixels[zoom] = [bytes(row[3 * x:3 * x + 3]) for row in rows for x in range(64)]
        background, middle = pixels["1"][0], 32 * 64 + 32
        for zoom in ("4", "30"):
            self.assertNotIn(background, pixels[zoom])
            for before, after in zip(pixels["1"][middle], pixels[zoom][middle]):
                self.assertLess(abs(before - after), 12)

    def test_patterns_are_those_that_are_drawn(self):
        """The triangles of all patterns that the viewer names are as many as OpenGL drew."""

        @functools.cache
        def triangles_of(pattern):
            said = subprocess.run([GLARK, "pattern", *pattern.split(), "-o", self.path / "pattern.svg"], capture_output=True, text=True)
            return int(said.stdout.split()[0])

        write_ply(self.path / "coarse.ply", *sphere(8))
        write_ply(self.path / "points.ply", sphere(20)[0], [])
        for options in (("--edge-pixels", "9"), ("--edge-pixels", "3"), ("--level", "3"), ("--level", "0")):
            for mesh in ("coarse.ply", "points.ply"):
                with self.subTest(options=options, mesh=mesh):
                    drawn = self.report("view", mesh, "--mode", "patterns", *options, "--offscreen", "a.png")
                    patterns = drawn["patterns"]
                    self.assertEqual(drawn["indices"], 3 * sum(patterns.values()))
                    self.assertEqual(drawn["refined_triangles"], sum(count * triangles_of(name) for name, count in patterns.items()))
                    self.assertEqual(options[0] == "--edge-pixels", len(patterns) > 1)

    def test_refinements_differ(self):
        write_ply(self.path / "coarse.ply", *sphere(6))
        pictures = {}
        for refinement in ("pn", "phong", "linear"):
            self.glark("view", "coarse.ply", "--mode", "refined", "--refine", refinement, "--level", 3, "--offscreen", "a.png")
            pictures[refinement] = (self.path / "a.png").read_bytes()
        self.assertEqual(3, len(set(pictures.values())))
        self.glark("view", "coarse.ply", "--mode", "mesh", "--offscreen", "a.png")
        self.assertNotEqual(pictures["pn"], (self.path / "a.png").read_bytes())
        self.assertEqual("", self.glark("view", "coarse.ply", "--mode", "refined", "--offscreen", "a.png").stderr)

    def test_window(self):
        """Keys choose the mode, write a screenshot and quit."""
        if not shutil.which("xvfb-run") or not shutil.which("xdotool"):
            self.assertNotEqual("true", os.environ.get("CI"), "xvfb or xdotool is not installed; run scripts/install_packages")
            self.skipTest("xvfb or xdotool is not installed")
        script = f"""
            "{GLARK}" view sphere.ply --mode strip --width 200 --height 150 & program=$!
            window=$(xdotool search --sync --onlyvisible --name "glark sphere" | head -1)
            until xdotool getwindowname "$window" | grep -q "indices"; do sleep 0.1; done
            xdotool windowfocus --sync "$window"
            for key in 5 plus u c 6 s q; do xdotool key --window "$window" "$key"; sleep 0.5; done
            wait $program"""
        result = subprocess.run(["xvfb-run", "-a", "timeout", "60", "bash", "-c", script], capture_output=True, text=True, cwd=self.path)
        self.assertEqual(0, result.returncode, result.stdout + result.stderr)
        self.assertIn("glark-1.png", result.stdout)
        self.assertEqual(b"\x89PNG", (self.path / "glark-1.png").read_bytes()[:4])

    def test_pictures_of_a_line(self):
        (self.path / "line.xyz").write_text("0 0 0\n1 0 0\n2 0 0\n")
        self.assertIn("--mode splat", self.glark("view", "line.xyz", "--offscreen", "a.png").stderr)
        self.assertNotIn("--mode", self.glark("view", "line.xyz", "--mode", "splat", "--offscreen", "a.png").stderr)

    def test_pictures_are_png(self):
        self.assertIn("call it OUT.png", self.glark("view", self.sphere, "--offscreen", "a.jpg", status=1).stderr)
        self.assertFalse((self.path / "a.jpg").exists())


if __name__ == "__main__":
    unittest.main()
