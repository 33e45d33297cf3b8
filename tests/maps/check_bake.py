#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Runs `glark bake` as a process: models of meshes and points, messages, and that no output is half written.

check_bake.py GLARK
"""
import json
import math
import os
import pathlib
import random
import shutil
import signal
import struct
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "geometry"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "stream"))
from command_case import GLARK, CommandCase, sphere, write_ply  # noqa: E402
from scans import bumpy_sphere, write_raw  # noqa: E402

KILLS = 40  # at most


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
            (1, ("bake", self.bumpy(), "-o", "out.obj"), ".glb or .ply"),
            (1, ("bake", self.bumpy(), "-o", "out.glb", "--strips"), "--strips is for PLY"),
            (1, ("bake", self.bumpy(), "-o", "out\n.ply"), "line break"),
            (1, ("bake", "missing.ply", "-o", "out.glb"), "missing.ply"),
            (1, ("bake", self.bumpy(), "-o", "no/folder/out.glb"), "no/folder"),
            (1, ("bake", self.bumpy(), "-o", "out.glb", "--mesh", self.bumpy("p.ply", points_only=True)), "no triangles"),
            (2, ("bake", self.bumpy(), "-o", "out.glb", "--texture-memory", "1KB"), "is less than 1048576 bytes"),
            (2, ("bake", self.bumpy(), "-o", "out.glb", "--texels-per-point", "100"), "texels-per-point"),
            (2, ("bake", self.bumpy(), "-o", "out.glb", "--mesh", "a.ply", "--triangles", "9"), "--mesh excludes --triangles"),
            (2, ("bake", self.bumpy(), "-o", "out.glb", "--noise", "-1"), "is not a number from 0"),
            (2, ("view", self.bumpy(), "--offscreen", "a.png", "--turntable", "b.gif"), " excludes --"),
            (1, ("bake", write_ply(self.path / "empty.ply", [], []), "-o", "out.glb"), "no points"),
            (1, ("bake", self.bumpy(), "-o", "out.glb", "--mesh", "-"), "standard input is for the points"),
            (2, ("bake", self.bumpy(), "-o", "out.glb", "--texture-memory", "-1"), "is not a size above 0"),
            (2, ("bake", self.bumpy(), "-o", "out.glb", "--memory", "-5MB"), "is not a size above 0"),
            (2, ("bake", self.bumpy(), "-o", "out.glb", "--memory", "1.5 apples"), "is not a size above 0"),
            (1, ("bake", self.bumpy(), "-o", "out.glb", "--triangles", "1"), "more --triangles"),
        ]
        for status, arguments, word in cases:
            done = self.glark(*arguments, status=status)
            self.assertIn(word, done.stderr, arguments)
            self.assert_nothing_written()

    def killed(self, output, seconds, *arguments):
        """Kills a bake, which takes some seconds, at random moments, continues it to its end, and returns how often it was killed."""
        moments = random.Random(7)
        for kills in range(KILLS):
            process = subprocess.Popen([GLARK, "bake", *map(str, arguments), *["--resume"] * (kills > 0)], cwd=self.path,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(seconds * moments.uniform(0.02, 0.3))
            if process.poll() is not None:
                self.assertEqual(0, process.returncode)
                return kills
            process.send_signal(moments.choice([signal.SIGKILL, signal.SIGTERM]))
            process.wait()
            self.assertFalse(kills == 0 and output.exists())
        self.glark("bake", *arguments, "--resume")
        return KILLS

    def test_killed_runs_continue(self):
        """A scan that is read in parts: the sampling, the coarse mesh and the maps are continued."""
        large = write_raw(self.path / "large.raw", bumpy_sphere(3000000))
        options = (large, "--triangles", 1000, "--size", 512, "--memory", "128MB")  # the sampling is streamed
        (self.path / "wanted").mkdir()
        begin = time.monotonic()
        self.glark("bake", *options, "-o", "wanted/out.glb")
        seconds = time.monotonic() - begin
        kills = self.killed(self.path / "out.glb", seconds, *options, "-o", "out.glb", "--threads", "1")
        self.assertGreater(kills, 2)
        for name in ("out.glb", "out.displacement.png"):
            self.assertEqual((self.path / "wanted" / name).read_bytes(), (self.path / name).read_bytes(), name)
        self.assertEqual([], [file.name for file in self.path.iterdir() if "partial" in file.name or file.name[0] == "."])

    def test_a_full_disk_is_said_and_the_run_continues(self):
        large = write_raw(self.path / "large.raw", bumpy_sphere(3000000))
        disk = self.path / "disk"
        disk.mkdir()
        command = f"{GLARK} bake {large} --size 256 --triangles 1000 --memory 128MB"
        script = f"""mount -t tmpfs -o size=1m none {disk} || exit 77
            echo old > {disk}/out.glb
            {command} -o {disk}/out.glb && exit 1
            grep -q old {disk}/out.glb || exit 2
            mount -o remount,size=99m {disk} || exit 77
            {command} -o {disk}/out.glb --resume || exit 3
            test ! -e {disk}/out.glb.partial || exit 4
            mkdir {disk}/wanted && {command} -o {disk}/wanted/out.glb && cmp {disk}/out.glb {disk}/wanted/out.glb"""
        if shutil.which("unshare") is None:
            self.skipTest("unshare is missing")
        done = subprocess.run(["unshare", "--user", "--map-root-user", "--mount", "sh", "-c", script], capture_output=True,
                              text=True)
        if done.returncode == 77 or "unshare failed" in done.stderr or "Operation not permitted" in done.stderr:
            self.skipTest("the system lets no user mount a file system: " + done.stderr.strip())
        self.assertEqual(0, done.returncode, done.stderr)
        self.assertIn("make room on the disk, then resume", done.stderr)

    def test_other_work_is_not_resumed(self):
        large = write_raw(self.path / "large.raw", bumpy_sphere(1500000))
        options = ["bake", large, "-o", "out.glb", "--size", "256", "--triangles"]
        while not (self.path / "out.glb.partial" / "glark-mesh").exists():
            process = subprocess.Popen([GLARK, *map(str, options), "900"], cwd=self.path, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            while process.poll() is None and not (self.path / "out.glb.partial" / "glark-mesh").exists():
                time.sleep(0.001)
            process.kill()
            process.wait()
        before = sorted(self.path.rglob("*"))
        done = self.glark(*options, "800", "--resume", status=1)
        self.assertRegex(done.stderr, 'out.glb.partial: is the work of a run that differs: it has "--triangles 900", and '
                                      'this run "--triangles 800"; resume with the same')
        with open(large, "ab") as file:
            file.write(bytes(12))
        self.assertIn("the input", self.glark(*options, "900", "--resume", status=1).stderr)
        self.assertEqual(before, sorted(self.path.rglob("*")))
        self.glark(*options, "900")
        self.assertFalse((self.path / "out.glb.partial").exists())

    def test_a_mirrored_node_is_baked(self):
        """A sphere of glTF whose node mirrors it has its triangles and normals outside."""
        self.glark("simplify", self.bumpy(), "-o", "sphere.glb", "--target", "100000")
        data = (self.path / "sphere.glb").read_bytes()
        length = struct.unpack_from("<I", data, 12)[0]
        gltf = gltf_of(self.path / "sphere.glb")
        gltf["nodes"][0]["scale"] = [-1, 1, 1]
        text = json.dumps(gltf).encode()
        text += b" " * (-len(text) % 4)
        rest = data[20 + length:]
        (self.path / "mirrored.glb").write_bytes(b"glTF" + struct.pack("<IIII", 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A) + text + rest)
        report = self.report("bake", "mirrored.glb", "-o", "model.glb", "--triangles", "500")
        self.assertEqual(0, report["points_left_out"])

    def test_ply(self):
        """The model as faces and as strips: the same triangles with the same texture coordinates, and the maps beside."""
        points, triangles = sphere(40)
        scan = self.path / "scan.ply"
        colours = [[int(127 + 100 * c) for c in point] for point in points]
        header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}", *(f"property float {n}" for n in (
            "x", "y", "z", "nx", "ny", "nz")), *(f"property uchar {n}" for n in ("red", "green", "blue")),
            f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header", ""]
        scan.write_bytes("\n".join(header).encode() + b"".join(struct.pack("<6f3B", *p, *p, *c) for p, c in zip(points, colours))
                         + b"".join(struct.pack("<B3i", 3, *t) for t in triangles))
        report = self.report("bake", scan, "-o", "model.ply", "--triangles", "500")
        self.report("bake", scan, "-o", "strips.ply", "--triangles", "500", "--strips")
        self.assertEqual({f"{stem}{ending}" for stem in ("model", "strips") for ending in (
            ".ply", ".normals.png", ".colours.png", ".displacement.png")} | {"scan.ply", "sphere.ply"},
            {file.name for file in self.path.iterdir()})
        head, body = (self.path / "model.ply").read_bytes().split(b"end_header\n", 1)
        self.assertIn(b"comment TextureFile model.colours.png\n", head)
        self.assertIn(b"comment Displacement scale ", head)
        vertices = list(struct.iter_unpack("<6f3B2f", body[:report["vertices"] * 35]))
        faces = list(struct.iter_unpack("<B3iB6f", body[report["vertices"] * 35:]))
        self.assertEqual(report["triangles"], len(faces))
        for face in faces:
            self.assertEqual((3, 6), (face[0], face[4]))
            self.assertEqual(face[5:], tuple(c for v in face[1:4] for c in vertices[v][9:11]))
        for vertex in vertices:  # the coarse sphere is inside the fine one
            for k in range(3):
                self.assertAlmostEqual(127 + 100 * vertex[k] / math.hypot(*vertex[:3]), vertex[6 + k], delta=12)
        strip_head, strip_body = (self.path / "strips.ply").read_bytes().split(b"end_header\n", 1)
        self.assertEqual(body[:report["vertices"] * 35], strip_body[:report["vertices"] * 35])
        numbers = [n for n, in struct.iter_unpack("<i", strip_body[report["vertices"] * 35:])]
        seen, at = [], 0
        while at < len(numbers):
            strip = numbers[at + 1:at + 1 + numbers[at]]
            at += 1 + numbers[at]
            seen += [(strip[i + i % 2], strip[i + 1 - i % 2], strip[i + 2]) for i in range(len(strip) - 2)]
        turned = lambda t: min(t[i:] + t[:i] for i in range(3))  # noqa: E731
        self.assertEqual(sorted(turned(face[1:4]) for face in faces), sorted(map(turned, seen)))
        self.assertLess(len(numbers), 2 * len(faces))
        for name in ("model.ply", "strips.ply"):
            self.assertEqual(report["triangles"], self.report("info", name)["triangles"])

    def test_inverted_normals_keep_the_old_model(self):
        points, triangles = sphere(60)
        inverted = self.path / "inverted.ply"
        data = write_ply(inverted, points, triangles).read_bytes()
        begin = data.index(b"end_header\n") + 11
        numbers = list(struct.unpack_from(f"<{6 * len(points)}f", data, begin))
        numbers = [-x if i % 6 > 2 else x for i, x in enumerate(numbers)]
        body = struct.pack(f"<{len(numbers)}f", *numbers)
        inverted.write_bytes(data[:begin] + body + data[begin + len(body):])
        (self.path / "out.glb").write_text("old")
        done = self.glark("bake", inverted, "-o", "out.glb", "--triangles", "500", status=1)
        self.assertRegex(done.stderr, "normals must point to the outside")
        self.assertEqual("old", (self.path / "out.glb").read_text())

    def test_what_is_lost_is_said(self):
        points, triangles = sphere(20)
        lines = [f"v {x} {y} {z}" for x, y, z in points] + [f"vt {x} {y}" for x, y, _ in points]
        lines += ["f " + " ".join(f"{i + 1}/{i + 1}" for i in triangle) for triangle in triangles]
        (self.path / "coarse.obj").write_text("\n".join(lines))
        done = self.glark("bake", self.bumpy(), "-o", "out.glb", "--mesh", "coarse.obj", "--texture-memory", "1MB",
                          "--texels-per-point", "64")
        self.assertIn("coarse.obj: new texture coordinates replace its own, because its texture coordinates go from -1 to 1, "
                      "beyond 0 to 1", done.stderr)
        self.assertRegex(done.stderr, "the maps have 0.* of the texels")

    def box(self, name, overlap=False):
        """A sphere of six faces in OBJ. Each face is an island, three beside each other in two rows."""
        parts, places, corners, faces = 6, [], [], []
        for face in range(6):
            first = len(places) + 1
            for row in range(parts + 1):
                for column in range(parts + 1):
                    u, v = column / parts, row / parts
                    p = [0.0] * 3
                    p[face % 3] = 1 if face < 3 else -1
                    p[(face + 1) % 3] = 2 * (u if face < 3 else v) - 1
                    p[(face + 2) % 3] = 2 * (v if face < 3 else u) - 1
                    length = math.hypot(*sorted(map(abs, p)))
                    places.append("v " + " ".join(f"{c / length:.7f}" for c in p))
                    cell = 0 if overlap else face
                    corners.append(f"vt {(cell % 3 + 0.05 + 0.9 * u) / 3:.7f} {(cell // 3 + 0.05 + 0.9 * v) / 2:.7f}")
            for row in range(parts):
                for column in range(parts):
                    a = first + row * (parts + 1) + column
                    square = (a, a + 1, a + parts + 2, a + parts + 1)
                    faces.append("f " + " ".join(f"{i}/{i}" for i in square))
        (self.path / name).write_text("\n".join(places + corners + faces) + "\n")
        return name

    def test_texture_coordinates_of_the_mesh_are_kept(self):
        done = self.glark("bake", self.bumpy(), "-o", "model.glb", "--mesh", self.box("box.obj"), "--json", "--size", "256")
        self.assertEqual("", done.stderr)
        report = json.loads(done.stdout)
        self.assertTrue(report["own_texture_coordinates"])
        self.assertEqual([256, 256, 6], [report[name] for name in ("width", "height", "charts")])
        self.assertLess(report["largest_seam_normal_degrees"], 1.5)
        self.glark("simplify", "model.glb", "-o", "back.obj", "--target", "100000")
        wanted = {line for line in (self.path / "box.obj").read_text().split("\n") if line.startswith("vt")}
        kept = [tuple(map(float, line.split()[1:])) for line in (self.path / "back.obj").read_text().split("\n")
                if line.startswith("vt")]
        wanted = {tuple(map(float, line.split()[1:])) for line in wanted}
        self.assertTrue(all(any(abs(s - x) + abs(t - y) < 1e-5 for x, y in wanted) for s, t in kept))
        report = self.report("bake", self.bumpy(), "-o", "charts.glb", "--mesh", "box.obj", "--texture-coordinates", "charts",
                             "--size", "512x256")
        self.assertFalse(report["own_texture_coordinates"])
        self.assertEqual([512, 256], [report[name] for name in ("width", "height")])

    def test_texture_coordinates_that_cannot_be_kept(self):
        keep = ("--texture-coordinates", "own")
        shared = self.box("shared.obj", overlap=True)
        points, triangles = sphere(10)
        cases = [
            (1, ("--mesh", shared, *keep), "cannot keep its texture coordinates: 83.3 % of the area"),
            (1, ("--mesh", write_ply(self.path / "plain.ply", points, triangles), *keep), "it has no texture coordinates"),
            (2, keep, "--texture-coordinates requires --mesh"),
            (2, ("--mesh", shared, "--texture-coordinates", "mine"), '"mine" is not one of auto, own, charts'),
            (2, ("--size", "1000"), '"1000" is not a power of two from 64 to 16384'),
            (2, ("--size", "512x"), "is not a power of two"),
            (2, ("--size", "32768"), "is not a power of two"),
            (2, ("--size", "512", "--texture-memory", "8MB"), "excludes --"),
        ]
        for status, arguments, words in cases:
            done = self.glark("bake", self.bumpy(), "-o", "out.glb", *arguments, status=status)
            self.assertIn(words, done.stderr, arguments)
            self.assertEqual(1, len(done.stderr.strip().split("\n")), done.stderr)
            self.assert_nothing_written()
        done = self.glark("bake", self.bumpy(), "-o", "model.glb", "--mesh", shared)
        self.assertRegex(done.stderr, "shared.obj: new texture coordinates replace its own, because 83.3 %")

    def test_the_displacement_of_another_model_is_not_taken(self):
        for name, height in (("a", 1.0), ("b", 1.5)):
            points, triangles = sphere(60)
            bumps = [tuple(c * (1 + height * 0.03 * math.sin(9 * p[0])) for c in p) for p in points]
            write_ply(self.path / f"{name}.ply", bumps, triangles)
            self.glark("bake", f"{name}.ply", "-o", f"{name}.glb", "--mesh", write_ply(self.path / "coarse.ply", *sphere(10)))
        self.needs("view")
        view = ("view", "a.glb", "--offscreen", "a.png")
        self.assertEqual("", self.glark(*view).stderr)
        (self.path / "b.displacement.png").replace(self.path / "a.displacement.png")
        self.assertIn("not the file that was baked with this model", self.glark(*view).stderr)

    def test_seams_that_differ_by_rounding_are_closed(self):
        """A torus whose first and last rows and columns are equal but for rounding, as sines give them."""
        columns, rows, lines = 90, 60, []
        for i in range(columns + 1):
            for k in range(rows + 1):
                turn, roll = 2 * math.pi * i / columns, 2 * math.pi * k / rows
                away = 1 + 0.4 * math.cos(roll)
                lines.append(f"v {away * math.cos(turn)} {away * math.sin(turn)} {0.4 * math.sin(roll)}")
        for i in range(columns):
            for k in range(rows):
                a = i * (rows + 1) + k + 1
                b = a + rows + 1
                lines += [f"f {a} {b} {b + 1}", f"f {a} {b + 1} {a + 1}"]
        (self.path / "torus.obj").write_text("\n".join(lines))
        self.assertFalse(self.report("info", "torus.obj")["topology"]["closed"])
        self.glark("bake", "torus.obj", "-o", "torus.glb", "--triangles", "800")
        self.assertTrue(self.report("info", "torus.glb")["topology"]["closed"])

    def test_maps_as_pictures(self):
        self.glark("bake", self.bumpy(), "-o", "model.glb", "--triangles", "500", "--png")
        gltf = gltf_of(self.path / "model.glb")
        data = (self.path / "model.glb").read_bytes()
        view = gltf["bufferViews"][gltf["images"][0]["bufferView"]]
        begin = 28 + struct.unpack_from("<I", data, 12)[0] + view.get("byteOffset", 0)
        self.assertEqual(data[begin:begin + view["byteLength"]], (self.path / "model.normals.png").read_bytes())
        self.assertFalse((self.path / "model.colours.png").exists())  # the mesh has no colours
        self.assertFalse((self.path / "model.object_normals.png").exists())
        self.glark("bake", self.bumpy(), "-o", "model.glb", "--triangles", "500", "--object-normals")
        pictures = [(self.path / f"model.{name}.png").read_bytes() for name in ("normals", "object_normals")]
        self.assertEqual(pictures[0][:26], pictures[1][:26])  # the signature, the size and the format
        self.assertNotEqual(pictures[0], pictures[1])

    def test_a_name_that_is_no_utf8_is_refused_at_once(self):
        command = [GLARK, "bake", str(self.bumpy()), "-o", os.fsdecode(b"out\xff.glb")]
        done = subprocess.run(command, capture_output=True, cwd=self.path)
        self.assertEqual(1, done.returncode)
        self.assertIn(b"no UTF-8", done.stderr)
        self.assert_nothing_written()

    def test_mesh_elsewhere(self):
        points, triangles = sphere(10)
        far = write_ply(self.path / "far.ply", [tuple(c + 50 for c in p) for p in points], triangles)
        done = self.glark("bake", self.bumpy(), "-o", "out.glb", "--mesh", far, status=1)
        self.assertRegex(done.stderr, "^glark: no point")  # without the names of libraries
        self.assert_nothing_written()


if __name__ == "__main__":
    unittest.main()
