# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Runs glark view on models with maps, without a display and in a window.

check_maps.py GLARK: the launcher that was built.
"""
import math
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

from baked_model import BIAS, SCALE, bumps, png, unit, write_model
from command_case import GLARK, CommandCase

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts" / "parts"))
import picture_row  # noqa: E402 (lies in the folder that the line above names)

SIDE = 300  # of the pictures, in pixels
BACKGROUND = (41, 43, 48)
FROM_Z = ("--yaw", 0, "--pitch", 0)   # the chart of z > 0 is in front
FROM_X = ("--yaw", 90, "--pitch", 0)  # the charts meet in the middle of the picture
SOME = bumps(9.0)


def is_background(pixel: tuple) -> bool:
    return all(abs(a - b) <= 1 for a, b in zip(pixel, BACKGROUND, strict=True))


def diameter_of(radius: float) -> float:
    """The diameter in pixels of a sphere about the origin: the camera fits the box and the greatest displacement."""
    opening = math.radians(20)
    distance = (math.sqrt(3) + max(abs(BIAS), abs(SCALE + BIAS))) / math.sin(opening)
    return SIDE / math.tan(opening) * math.tan(math.asin(radius / distance))


class Maps(CommandCase):
    def setUp(self):
        super().setUp()
        self.needs("view")

    def model(self, height=SOME, **how) -> pathlib.Path:
        write_model(self.path / "model.glb", height, **how)
        return self.path / "model.glb"

    def draw(self, *options, file="model.glb", warning="") -> list:
        """The rows of pixels. The only warning is the given one."""
        result = self.glark("view", file, *options, "--offscreen", "a.png", "--width", SIDE, "--height", SIDE)
        self.assertIn(warning, result.stderr)
        self.assertEqual(1 if warning else 0, result.stderr.count("\n"), result.stderr)
        self.refined = "refined triangles" in result.stdout
        width, rows = picture_row.read_png(self.path / "a.png")
        return [[tuple(row[3 * x:3 * x + 3]) for x in range(width)] for row in rows]

    def test_each_shows_more(self):
        self.model()
        pictures = {maps: self.draw("--maps", maps) for maps in ("plain", "normal", "displaced")}
        self.assertNotEqual(pictures["plain"], pictures["normal"])
        self.assertNotEqual(pictures["normal"], pictures["displaced"])
        inside = {maps: sum(not is_background(pixel) for row in picture for pixel in row) for maps, picture in pictures.items()}
        self.assertEqual(inside["plain"], inside["normal"])  # a normal map moves nothing
        self.assertGreater(inside["displaced"], inside["plain"])
        self.assertEqual(pictures["displaced"], self.draw())
        self.assertNotEqual(pictures["displaced"], self.draw("--lines"))
        self.assertEqual(pictures["plain"], self.draw("--mode", "mesh"))
        self.assertEqual(pictures["plain"], self.draw("--maps", "plain", "--mode", "mesh"))

    def test_silhouettes_move_by_heights(self):
        for height in (0.1, 0.8):
            self.model(lambda d, height=height: height, cells=16, size=16)
            for maps, radius in (("plain", 1.0), ("normal", 1.0), ("displaced", 1 + SCALE * height + BIAS)):
                with self.subTest(height=height, maps=maps):
                    row = self.draw("--maps", maps, *FROM_Z)[SIDE // 2]
                    self.assertAlmostEqual(diameter_of(radius), sum(not is_background(pixel) for pixel in row), delta=1.6)

    def gaps(self) -> int:
        """Dark pixels about x = 1, where the charts meet: through a crack, the dark inside of the far chart shows, or the
        background. The view is from the side of the chart of z > 0."""
        yaw = 50
        picture = self.draw("--yaw", yaw, "--pitch", 0)
        border = round(SIDE / 2 + math.cos(math.radians(yaw)) * diameter_of(1) / 2)
        return sum(max(picture[y][x]) < 70 for y in range(SIDE // 2 - 15, SIDE // 2 + 15) for x in range(border - 15, border + 15))

    def test_charts_meet_without_cracks(self):
        """Even where the heights of the two charts differ by a step."""
        for height in (SOME, lambda d: 0.5):
            half = {"steps": (0.0, 0.3), "kept": lambda centre: centre[0] > 0, "normals": lambda d: d}
            self.model(height, **half)
            self.assertEqual(0, self.gaps())

        def part(values):  # the same vertices are not in the same place, so OpenGL cannot know that they belong together
            second = len(values["POSITION"]) // 2
            values["POSITION"][second:] = [(x, y, z - 1e-6) for x, y, z in values["POSITION"][second:]]

        self.model(lambda d: 0.5, **half, change_mesh=part)
        self.assertGreater(self.gaps(), 50)

    def test_normal_map_turns_normals(self):
        """A map of one direction lights the whole surface alike, whatever the charts' frames are."""
        flat = {"cells": 16, "pictures": {"baseColorTexture": None}}
        for direction in ((0.2, 0.3, 0.9), (0.9, 0.1, 0.4), (0.3, 0.9, 0.3)):
            self.model(lambda d: 1 / 3, normals=lambda d, direction=direction: unit(direction), **flat)
            for view in (FROM_Z, FROM_X):
                picture = self.draw("--maps", "normal", *view)
                disc = [picture[y][x] for y in range(SIDE) for x in range(SIDE)
                        if math.hypot(x - SIDE / 2, y - SIDE / 2) < 0.46 * diameter_of(1)]
                usual = sorted(disc)[len(disc) // 2]
                others = sum(max(abs(a - b) for a, b in zip(pixel, usual, strict=True)) > 12 for pixel in disc)
                with self.subTest(direction=direction, view=view):
                    self.assertLess(others, 0.02 * len(disc))

    def test_one_white_texel_is_no_colour_map(self):
        pictures = []
        for colours in (None, png(1, 1, b"\xff\xff\xff"), png(1, 1, b"\xff\x00\x00")):
            self.model(pictures={"baseColorTexture": colours})
            pictures.append(self.draw("--maps", "normal", *FROM_Z))
        self.assertEqual(pictures[0], pictures[1])
        self.assertNotEqual(pictures[0], pictures[2])

    def test_shading_differs_where_the_map_says_so(self):
        def turned(d):
            return unit((d[0], d[1] + 0.6, d[2])) if d[0] > 0 else d

        self.model(normals=lambda d: d)
        smooth = self.draw("--maps", "normal", *FROM_Z)
        self.model(normals=turned)
        half_turned = self.draw("--maps", "normal", *FROM_Z)
        differ = [x for a, b in zip(smooth, half_turned, strict=True) for x, (p, q) in enumerate(zip(a, b, strict=True))
                  if max(abs(m - n) for m, n in zip(p, q, strict=True)) > 8]
        self.assertGreater(len(differ), 1000)
        self.assertGreater(min(differ), SIDE // 2 - 5)  # a texel or two across the border

    def test_depth(self):
        """Depths are measured, unless a level is given. A budget bounds the triangles."""
        self.model()

        def refined(*options):
            return self.report("view", "model.glb", *options, "--offscreen", "a.png")["refined_triangles"]

        self.assertEqual(refined(), refined("--edge-pixels", 4))
        self.assertGreater(refined(), refined("--edge-pixels", 16))
        coarse = 2 * 2 * 4 * 4
        self.assertEqual(coarse * 4**3, refined("--level", 3))
        self.assertGreater(refined(), 5000)
        self.assertLessEqual(refined("--budget", 5000), 5000)
        self.assertGreaterEqual(refined("--budget", 5000), 5000 / 4)

    def test_translation_is_an_origin(self):
        """Far from zero there is the same picture, and a second model is shown where it is."""
        far = [500000, 5000000, 100]
        self.model()
        near = self.draw()
        self.model(change=lambda gltf: gltf["nodes"][0].update(translation=far))
        self.assertEqual(near, self.draw())
        (self.path / "far.xyz").write_text("".join(f"{x + far[0]} {y + far[1]} {z + far[2]}\n" for x, y, z in
                                                   [(i / 10, j / 10, 0) for i in range(-5, 6) for j in range(-5, 6)]))
        beside = self.draw("far.xyz", *FROM_Z)
        self.assertFalse(is_background(beside[SIDE // 2][3 * SIDE // 4]))

    def test_faults_are_told(self):
        def material(gltf):
            return gltf["materials"][0]

        def without(attribute):
            return lambda gltf: gltf["meshes"][0]["primitives"][0]["attributes"].pop(attribute)

        def displacement(**values):
            return lambda gltf: material(gltf)["extras"]["displacement"].update(values)

        grey = bytes(2 * 64 * 64)
        faults = [  # how the model changes, the displacement file instead, the message, what is left
            ({"change": without("TANGENT")}, None, "normalTexture: it needs a TANGENT of four finite floats", "displaced"),
            ({"change": without("NORMAL")}, None, "it has maps and no NORMAL", "plain"),
            ({"change": without("TEXCOORD_0")}, None, "it has maps and no TEXCOORD_0", "plain"),
            ({"pictures": {"normalTexture": b"no picture"}}, None, "normalTexture: it cannot be decoded", "displaced"),
            ({"pictures": {"baseColorTexture": b"no picture"}}, None, "baseColorTexture: it cannot be decoded", "displaced"),
            ({"change": displacement(uri="other.png")}, None, "other.png: there is no such file", "normal"),
            ({"change": displacement(uri=3)}, None, "extras.displacement: uri is no text", "normal"),
            ({"change": displacement(scale="high")}, None, "extras.displacement: scale is no number", "normal"),
            ({"change": displacement(bias=[1])}, None, "extras.displacement: bias is no number", "normal"),
            ({"change": displacement(scale=1e300)}, None, "extras.displacement: scale is no number that a float can hold", "normal"),
            ({"change": lambda gltf: material(gltf).update(extras={"displacement": 1})}, None, "extras.displacement: uri is no text", "normal"),
            ({"change": lambda gltf: gltf["nodes"][0].update(scale=[1, 2, 1])}, None, "its nodes turn, scale", "plain"),
            ({"change": lambda gltf: gltf["nodes"].append({"mesh": 0})}, None, "2 nodes show its mesh", "plain"),
            ({"change": lambda gltf: gltf["meshes"].append(gltf["meshes"][0])}, None, "it has maps and 2 primitives", "plain"),
            ({}, png(128, 64, grey[:128 * 64], 8, 0), "model.displacement.png: it has 1 channel of 8 bits", "normal"),
            ({}, png(128, 64, grey * 3, 16, 2), "model.displacement.png: it has 3 channels of 16 bits", "normal"),
            ({}, png(64, 64, grey, 16, 0), "model.displacement.png: it has 64 x 64 texels and the normal map 128 x 64", "normal"),
            ({}, b"no picture", "model.displacement.png: it cannot be decoded", "normal"),
            ({}, b"", "model.displacement.png: it is empty", "normal")]
        self.model(change=lambda gltf: material(gltf).pop("extras"))
        normal = self.draw()
        for how, file, message, left in faults:
            with self.subTest(message=message):
                self.model(**how)
                if file is not None:
                    (self.path / "model.displacement.png").write_bytes(file)
                drawn = self.draw(warning=f"model.glb: {message}")
                self.assertEqual(left == "displaced", self.refined)
                self.assertEqual(left == "normal", normal == drawn)
                self.assertFalse(all(is_background(pixel) for pixel in drawn[SIDE // 2]))

    def test_maps_need_maps(self):
        self.assertIn("it has no maps", self.glark("view", self.sphere, "--maps", "normal", "--offscreen", "a.png").stderr)
        self.model(change=lambda gltf: gltf["materials"][0].pop("extras"))
        self.assertIn("it has no displacement map", self.glark("view", "model.glb", "--maps", "displaced", "--offscreen", "a.png").stderr)
        self.assertIn("leave it out with --maps", self.glark("view", "model.glb", "--maps", "normal", "--mode", "mesh", status=2).stderr)
        self.assertIn("not one of plain, normal, displaced", self.glark("view", "model.glb", "--maps", "most", status=2).stderr)

    def test_film(self):
        if not shutil.which("ffmpeg"):
            self.skipTest("ffmpeg is not installed")
        self.model()
        report = self.report("view", "model.glb", "--turntable", "a.gif", "--frames", 3, "--width", 64, "--height", 64)
        self.assertGreater(report["refined_triangles"], 64)
        self.assertEqual(b"GIF8", (self.path / "a.gif").read_bytes()[:4])

    def test_window(self):
        """The key M goes round plain, normal map, displaced; 3 is a plain mesh."""
        if not shutil.which("xvfb-run") or not shutil.which("xdotool"):
            self.assertNotEqual("true", os.environ.get("CI"), "xvfb or xdotool is not installed; run scripts/install_packages")
            self.skipTest("xvfb or xdotool is not installed")
        self.model()
        script = f"""
            "{GLARK}" view model.glb --width 200 --height 150 & program=$!
            window=$(xdotool search --sync --onlyvisible --name "glark model" | head -1)
            until xdotool getwindowname "$window" | grep -q "indices"; do sleep 0.1; done
            xdotool windowfocus --sync "$window"
            for key in p s m s m s m s 3 s q; do xdotool key --window "$window" "$key"; sleep 0.5; done
            wait $program"""
        result = subprocess.run(["xvfb-run", "-a", "timeout", "60", "bash", "-c", script], capture_output=True, text=True, cwd=self.path)
        self.assertEqual(0, result.returncode, result.stdout + result.stderr)
        shots = [(self.path / f"glark-{i}.png").read_bytes() for i in range(1, 6)]
        self.assertEqual(3, len(set(shots[:3])))  # displaced, plain, normal map
        self.assertEqual(shots[0], shots[3])
        self.assertEqual(shots[1], shots[4])


if __name__ == "__main__":
    unittest.main()
