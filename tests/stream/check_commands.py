# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Runs glark info, sample and transfer as processes: the memory that they take, kills, and a full disk.

check_commands.py GLARK_SCAN [--kills N]: N kills of each command (2).
"""
import argparse
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

try:
    import numpy
except ImportError:
    if os.environ.get("CI"):
        raise
    print("numpy is missing: skipped")
    sys.exit(0)

from scans import bumpy_sphere, write_las, write_ply  # noqa: E402

PROGRAM, KILLS = "", 2
MIB = 1 << 20


def write_scan(path: pathlib.Path, count: int, shuffled: bool = False) -> pathlib.Path:
    """Points of a sphere with bumps, in rings from below."""
    points = bumpy_sphere(count, shuffled)
    points.astype("<f4").tofile(path)
    return path


def write_grid(path: pathlib.Path, side: int, first: tuple = (0, 0, 0)) -> pathlib.Path:
    """A mesh of side x side points with normals and colours; a point and its triangles are not finite."""
    vertices = numpy.zeros(side * side, [("position", "<f8", 3), ("normal", "<f4", 3), ("colour", "u1", 3)])
    row, column = numpy.divmod(numpy.arange(side * side), side)
    vertices["position"] = numpy.stack([row, column, numpy.sin(row)], axis=1) + first
    vertices["position"][side + 1] = numpy.nan
    vertices["normal"][:, 2] = 1
    begin = (row * side + column).reshape(side, side)[:-1, :-1].ravel()
    faces = numpy.zeros(len(begin), [("count", "u1"), ("corners", "<u4", 4)])  # quads
    faces["count"] = 4
    faces["corners"] = numpy.stack([begin, begin + 1, begin + side + 1, begin + side], axis=1)
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {side * side}"]
    header += [f"property double {name}" for name in "xyz"] + [f"property float n{name}" for name in "xyz"]
    header += [f"property uchar {name}" for name in ("red", "green", "blue")]
    header += [f"element face {len(begin)}", "property list uchar uint vertex_indices", "end_header", ""]
    path.write_bytes("\n".join(header).encode() + vertices.tobytes() + faces.tobytes())
    return path


def lift(small: pathlib.Path, edited: pathlib.Path) -> None:
    """Moves a sampling by its height."""
    data = small.read_bytes()
    begin = data.index(b"end_header\n") + 11
    points = numpy.frombuffer(data[begin:], dtype="<f4").reshape(-1, 6).copy()
    points[:, 0] += points[:, 2]
    edited.write_bytes(data[:begin] + points.tobytes())


def write_torus(path: pathlib.Path, rows: int, columns: int) -> pathlib.Path:
    """A closed mesh about the z axis, of radii 3 and 1: PLY with normals, or STL."""
    row, column = numpy.divmod(numpy.arange(rows * columns), columns)
    u, v = 2 * numpy.pi * row / rows, 2 * numpy.pi * column / columns
    normal = numpy.stack([numpy.cos(u) * numpy.cos(v), numpy.sin(u) * numpy.cos(v), numpy.sin(v)], axis=1)
    position = normal + 3 * numpy.stack([numpy.cos(u), numpy.sin(u), 0 * u], axis=1)
    below, right = (row + 1) % rows * columns, (column + 1) % columns
    quads = numpy.stack([row * columns + column, below + column, below + right, row * columns + right], axis=1)
    if path.suffix == ".stl":
        triangles = numpy.zeros(2 * len(quads), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
        triangles["corners"] = position[numpy.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])]
        path.write_bytes(bytes(80) + len(triangles).to_bytes(4, "little") + triangles.tobytes())
        return path
    vertices = numpy.concatenate([position, normal], axis=1).astype("<f4")
    faces = numpy.zeros(len(quads), [("count", "u1"), ("corners", "<u4", 4)])
    faces["count"], faces["corners"] = 4, quads
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}"]
    header += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
    header += [f"element face {len(faces)}", "property list uchar uint vertex_indices", "end_header", ""]
    path.write_bytes("\n".join(header).encode() + vertices.tobytes() + faces.tobytes())
    return path


class Commands(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def run_it(self, *arguments, status: int = 0) -> subprocess.CompletedProcess:
        result = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, status, result.stderr)
        return result

    def peak(self, *arguments) -> int:
        """Returns the resident set of a process at its peak, as it reports it, and compares this with what the system says meanwhile."""
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        seen = 0
        while process.poll() is None:
            lines = pathlib.Path(f"/proc/{process.pid}/status").read_text().splitlines()
            seen = max([seen, *(1024 * int(line.split()[1]) for line in lines if line.startswith("VmHWM:"))])
            time.sleep(0.005)
        said = json.loads(process.stdout.read())["peak_memory_bytes"]
        process.stdout.close()
        self.assertEqual(process.returncode, 0)
        self.assertGreaterEqual(said + MIB, seen)
        self.assertGreater(seen, said / 2)
        return said

    def killed(self, output: pathlib.Path, *arguments) -> int:
        """Kills a command several times, continues it to its end, and returns how often it was killed."""
        resume, kills = [], 0
        moments = random.Random(7)
        while kills < KILLS:
            process = subprocess.Popen([PROGRAM, *map(str, arguments), *resume], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
            time.sleep(moments.uniform(0.03, 0.3))
            if process.poll() is not None:
                self.assertEqual(process.returncode, 0)
                resume = []
                break
            process.kill()
            process.wait()
            kills += 1
            resume = ["--resume"]
            self.assertEqual(output.read_text(), "old")
        if resume:
            self.run_it(*arguments, *resume)
        self.assertEqual([file.name for file in self.path.iterdir() if "partial" in file.name or file.name[0] == "."], [])
        return kills

    def test_memory_is_bounded(self):
        peaks = []
        for count in (300000, 2000000):
            large = write_scan(self.path / f"{count}.raw", count)
            peaks.append(self.peak("sample", large, "-o", self.path / "small.ply", "--target", 20000, "--memory", "40MiB",
                                   "--json"))
        self.assertLess(max(peaks), 40 * MIB)
        self.assertLess(peaks[1], peaks[0] + 6 * MIB)

    def info(self, *arguments) -> dict:
        return json.loads(self.run_it("info", "--json", *arguments).stdout)

    def test_info_in_parts_says_the_same(self):
        mesh = write_grid(self.path / "mesh.ply", 520, (4.5e6, 5e5, 100))
        text = self.path / "scan.xyz"
        numpy.savetxt(text, numpy.random.default_rng(1).random((300000, 6)) * [9, 9, 9, 255, 255, 255], "%.4f")
        cloud = self.path / "scan.pcd"
        points = numpy.random.default_rng(2).random((800000, 3), numpy.float32)
        cloud.write_bytes(b"VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 800000\nHEIGHT 1\nPOINTS 800000\n"
                          b"DATA binary\n" + points.tobytes())
        for file in (mesh, text, cloud):
            whole, parts = self.info(file, "--skip-invalid"), self.info(file, "--skip-invalid", "--memory", "32MB")
            self.assertIn("topology", whole)
            del whole["topology"]
            self.assertLess(parts.pop("peak_memory_bytes"), 32 * MIB)
            self.assertEqual(whole, parts)
        said = self.run_it("info", mesh, "--memory", "32MB", status=1).stderr
        self.assertEqual(said, self.run_it("info", mesh, status=1).stderr)
        self.assertIn("vertex 521 has a coordinate that is NaN", said)

    def test_info_reads_records_and_pipes(self):
        report = self.info(write_scan(self.path / "large.raw", 3000))
        self.assertEqual((3000, 0, []), (report["points"], report["triangles"], report["attributes"]))
        write_scan(self.path / "scan.raw", 3000).rename(self.path / "scan")
        self.assertEqual(3000, self.info(self.path / "scan", "--format", "raw")["points"])
        triangles = numpy.zeros(200000, [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
        triangles["corners"] = numpy.random.default_rng(3).random((200000, 3, 3))
        triangles["corners"][7, 1, 0] = numpy.nan
        stl = self.path / "part.stl"
        stl.write_bytes(bytes(80) + (200000).to_bytes(4, "little") + triangles.tobytes())
        report = self.info(stl, "--skip-invalid", "--memory", "32MB")
        self.assertEqual((599999, 199999), (report["corners"], report["triangles"]))
        mesh = write_grid(self.path / "mesh.ply", 100)
        pipe = subprocess.run(f"cat {mesh} | {PROGRAM} info - --format ply --skip-invalid --memory 32MB --json", shell=True,
                              capture_output=True, text=True, check=True)
        self.assertEqual(9999, json.loads(pipe.stdout)["points"])

    def test_info_says_what_needs_the_whole_file(self):
        mesh = write_grid(self.path / "mesh.ply", 520)
        said = self.run_it("info", mesh, "--skip-invalid", "--memory", "32MB", "--measure", mesh, status=1).stderr
        self.assertIn("--measure keeps the whole file", said)
        (self.path / "a.obj").write_text("v 0 0 0\n" * 1000000)
        said = self.run_it("info", self.path / "a.obj", "--memory", "32MB", status=1).stderr
        self.assertIn("can only be read as a whole", said)
        self.assertIn("less than 32MB", self.run_it("info", mesh, "--memory", "3MB", status=2).stderr)

    def check_simplified_torus(self, large: pathlib.Path, target: int) -> None:
        small = self.path / "small.ply"
        report = json.loads(self.run_it("simplify", large, "-o", small, "--target", target, "--memory", "128MB",
                                        "--json").stdout)
        self.assertLess(report["peak_memory_bytes"], 128 * MIB)
        self.assertTrue(0.9 * target <= report["output"]["triangles"] <= target, report["output"])
        topology = self.info(small)["topology"]
        self.assertEqual((0, 0), (topology["boundary_edges"], topology["non_manifold_edges"]), topology)
        points = numpy.frombuffer(small.read_bytes().split(b"end_header\n", 1)[1], "<f4",
                                  6 * report["output"]["points"]).reshape(-1, 6)[:, :3]
        distance = numpy.hypot(numpy.hypot(points[:, 0], points[:, 1]) - 3, points[:, 2]) - 1
        self.assertLess(numpy.abs(distance).max(), 0.01)

    def test_simplify_reads_large_meshes_in_parts(self):
        large = write_torus(self.path / "torus.ply", 1600, 600)
        for target in (3000, 10000, 20000):
            self.check_simplified_torus(large, target)
        self.check_simplified_torus(write_torus(self.path / "torus.stl", 600, 300), 5000)

    def test_simplify_reads_large_clouds_in_parts(self):
        large = write_scan(self.path / "large.raw", 400000)
        report = json.loads(self.run_it("simplify", large, "-o", self.path / "small.ply", "--target", 3000, "--json").stdout)
        self.assertTrue(2970 <= report["output"]["points"] <= 3000, report)

    def test_strip_samples_large_clouds(self):
        large = write_scan(self.path / "large.raw", 300000)
        command = self.run_it("strip", large, "-o", self.path / "strips.ply", "--memory", "128MB", "--json")
        report = json.loads(command.stdout)
        self.assertIn("samples of its 300000 points", command.stderr)
        self.assertLess(report["peak_memory_bytes"], 128 * MIB)
        self.assertGreater(report["output"]["points"], 50000)
        self.assertGreater(report["output"]["triangles"], 1.8 * report["output"]["points"])

    def test_simplify_says_what_memory_it_needs(self):
        large = write_torus(self.path / "torus.ply", 1600, 600)
        said = self.run_it("simplify", large, "-o", self.path / "small.ply", "--target", 900000, "--memory", "128MB",
                           status=1).stderr
        self.assertIn("--target 900000 needs about", said)
        self.assertFalse((self.path / "small.ply").exists())

    def test_shuffled_points_keep_the_bound(self):
        large = write_scan(self.path / "large.raw", 1000000, shuffled=True)
        self.assertLess(self.peak("sample", large, "-o", self.path / "small.ply", "--target", 50000, "--memory",
                                  "40MiB", "--json"), 40 * MIB)

    def test_points_that_fill_a_volume_keep_the_bound(self):
        points = numpy.random.default_rng(1).random((1000000, 3), numpy.float32)
        points[:, 2] *= 0.3
        strips = points[numpy.lexsort((points[:, 1], numpy.floor(20 * points[:, 0])))]
        noise = numpy.concatenate([points[:500000] - 0.5, 0.3 * numpy.random.default_rng(2).normal(size=(500000, 3))])
        noise[:500000] /= numpy.linalg.norm(noise[:500000], axis=1, keepdims=True)
        large, small = self.path / "large.raw", self.path / "small.ply"
        for cloud, target in ((points, 5000), (strips, 5000), (strips, 100000), (noise, 5000), (points[:60000], 5000)):
            cloud.astype("<f4").tofile(large)
            for memory in (40, 64):
                peak = self.peak("sample", large, "-o", small, "--target", target, "--memory", f"{memory}MiB", "--json")
                self.assertLess(peak, memory * MIB)
                samples = int(small.read_bytes().partition(b"element vertex ")[2].split()[0])
                self.assertLessEqual(samples, target)
                self.assertGreaterEqual(samples, 0.99 * target)

    def test_points_in_memory_keep_the_bound(self):
        large, small = self.path / "large.raw", self.path / "small.ply"
        numpy.random.default_rng(1).random((300000, 3), numpy.float32).tofile(large)
        self.assertLess(self.peak("sample", large, "-o", small, "--target", 5000, "--memory", "100MiB", "--json"), 100 * MIB)

    def test_a_killed_run_continues(self):
        for shuffled in (False, True):
            large = write_scan(self.path / "large.raw", 1400000, shuffled)
            small, again = self.path / "small.ply", self.path / "again.ply"
            options = ["sample", large, "--target", 3000, "--memory", "40MiB", "-o"]
            self.run_it(*options, small)
            again.write_text("old")
            self.assertGreater(self.killed(again, *options, again), 0)
            self.assertEqual(small.read_bytes(), again.read_bytes())
        lift(small, self.path / "edited.ply")
        options = ["transfer", large, "--from", small, "--to", self.path / "edited.ply", "-o"]
        self.run_it(*options, self.path / "out.raw")
        (self.path / "again.raw").write_text("old")
        self.assertGreater(self.killed(self.path / "again.raw", *options, self.path / "again.raw"), 0)
        self.assertEqual((self.path / "out.raw").read_bytes(), (self.path / "again.raw").read_bytes())

    def test_an_interrupt_leaves_the_old_output(self):
        """Ctrl-C at any moment of commands that have the whole file in memory: the output is the old or the whole new one."""
        mesh = write_grid(self.path / "mesh.ply", 300)
        moments = random.Random(5)
        interrupted = 0
        for command in (["simplify", "--target", 2000], ["reconstruct"], ["strip"], ["info"]):
            output = self.path / "out.ply"
            arguments = [*command, mesh, "--skip-invalid", *(["-o", output] if command[0] != "info" else [])]
            output.write_text("old")
            begin = time.monotonic()
            self.run_it(*arguments)
            seconds = time.monotonic() - begin
            whole = output.read_bytes()  # the signal can come when the output is in its place
            output.write_text("old")
            for _ in range(3):
                process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.DEVNULL,
                                           stderr=subprocess.DEVNULL)
                time.sleep(seconds * moments.uniform(0.05, 0.9))
                process.send_signal(signal.SIGINT)
                status = process.wait()
                interrupted += status == -signal.SIGINT
                self.assertIn(status, (0, -signal.SIGINT), command)  # a shell shows the latter as 130
                self.assertIn(output.read_bytes(), (b"old", whole))
                self.assertEqual(sorted(file.name for file in self.path.iterdir()), ["mesh.ply", "out.ply"])
                output.write_text("old")
        self.assertGreater(interrupted, 0)

    def test_waveforms_in_a_file_of_their_own_are_told(self):
        large, small = write_las(self.path / "large.las", bumpy_sphere(20000)), self.path / "small.ply"
        self.run_it("sample", large, "-o", small, "--target", 500)
        arguments = ["transfer", large, "--from", small, "--to", small, "-o", self.path / "out.las"]
        self.assertNotIn("waveforms", self.run_it(*arguments).stderr)
        (self.path / "large.wdp").write_bytes(b"waves")
        self.assertIn("out.wdp", self.run_it(*arguments).stderr)
        (self.path / "out.wdp").write_bytes(b"waves")
        self.assertNotIn("waveforms", self.run_it(*arguments).stderr)

    def test_a_sampling_of_another_scan_is_told(self):
        large, small = write_scan(self.path / "large.raw", 20000), self.path / "small.ply"
        other = self.path / "other.raw"
        (numpy.fromfile(large, "<f4") + numpy.float32(7)).tofile(other)
        self.run_it("sample", large, "-o", small, "--target", 3000)
        for scan, is_told in ((large, False), (other, True)):
            done = self.run_it("transfer", scan, "--from", small, "--to", small, "-o", self.path / "out.raw")
            self.assertEqual("is it a sampling of this scan?" in done.stderr, is_told, done.stderr)

    def test_a_sampling_larger_than_the_memory_lies_on_the_disk(self):
        """The limit is kept, the bytes are the same, and nothing is left of the temporary files."""
        large, small = write_scan(self.path / "large.raw", 300000), self.path / "small.ply"
        points = numpy.fromfile(write_scan(self.path / "small.raw", 400000), "<f4").reshape(-1, 3)
        rows = numpy.hstack([points, points]).astype("<f4")  # the normals of a sphere, nearly
        header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(rows)}\n"
        header += "".join(f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz")) + "end_header\n"
        small.write_bytes(header.encode() + rows.tobytes())
        rows[:, 0] += rows[:, 2] * rows[:, 2]
        edited = self.path / "edited.ply"
        edited.write_bytes(header.encode() + rows.tobytes())
        options = ["transfer", large, "--from", small, "--to", edited, "--json", "-o"]
        whole = json.loads(self.run_it(*options, self.path / "whole.raw", "--memory", "1GB").stdout)
        before = sorted(self.path.iterdir())
        done = self.run_it(*options, self.path / "parts.raw", "--memory", "48MiB", "--threads", 2)
        self.assertEqual(sorted(self.path.iterdir()), sorted([*before, self.path / "parts.raw"]))
        report = json.loads(done.stdout)
        self.assertEqual(whole["cells_on_disk"], 0)
        self.assertGreater(report["cells_on_disk"], 50)
        self.assertIn("does not fit into the memory", done.stderr)
        self.assertLess(report["peak_memory_bytes"], 48 * MIB)
        self.assertGreater(whole["peak_memory_bytes"], 48 * MIB)
        self.assertEqual((self.path / "whole.raw").read_bytes(), (self.path / "parts.raw").read_bytes())

    def test_a_full_disk_is_said_and_the_run_continues(self):
        large = write_scan(self.path / "large.raw", 1400000)
        small = self.path / "small.ply"
        self.run_it("sample", large, "-o", small, "--target", 3000, "--memory", "40MiB")
        lift(small, self.path / "edited.ply")
        disk = self.path / "disk"
        disk.mkdir()
        command = f"{PROGRAM} transfer {large} --from {small} --to {self.path}/edited.ply"
        script = f"""mount -t tmpfs -o size=14m none {disk} || exit 77
            echo old > {disk}/out.raw
            {command} -o {disk}/out.raw && exit 1
            grep -q old {disk}/out.raw || exit 2
            mount -o remount,size=99m {disk} || exit 77
            {command} -o {disk}/out.raw --resume || exit 3
            test ! -e {disk}/out.raw.partial || exit 4
            {command} -o {self.path}/wanted.raw && cmp {disk}/out.raw {self.path}/wanted.raw"""
        if shutil.which("unshare") is None:
            self.skipTest("unshare is missing")
        result = subprocess.run(["unshare", "--user", "--map-root-user", "--mount", "sh", "-c", script],
                                capture_output=True, text=True, check=False)
        if result.returncode == 77 or "unshare failed" in result.stderr or "Operation not permitted" in result.stderr:
            self.skipTest("the system lets no user mount a file system: " + result.stderr.strip())
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("make room on the disk", result.stderr)

    def test_a_full_disk_for_the_cells_is_said(self):
        large = write_ply(self.path / "large.ply", bumpy_sphere(30000))
        small = write_ply(self.path / "small.ply", bumpy_sphere(400000))
        disk = self.path / "disk"
        disk.mkdir()
        command = f"{PROGRAM} transfer {large} --from {small} --to {small} --memory 48MiB --threads 2 -o {disk}/out.ply"
        script = f"""mount -t tmpfs -o size=9m none {disk} || exit 77
            echo old > {disk}/out.ply
            {command} && exit 1
            grep -q old {disk}/out.ply || exit 2
            test "$(ls -A {disk})" = out.ply || exit 3
            mount -o remount,size=99m {disk} || exit 77
            {command} || exit 4"""
        if shutil.which("unshare") is None:
            self.skipTest("unshare is missing")
        result = subprocess.run(["unshare", "--user", "--map-root-user", "--mount", "sh", "-c", script],
                                capture_output=True, text=True, check=False)
        if result.returncode == 77 or "unshare failed" in result.stderr or "Operation not permitted" in result.stderr:
            self.skipTest("the system lets no user mount a file system: " + result.stderr.strip())
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("a temporary file cannot be written", result.stderr)
        self.assertIn("make room on the disk", result.stderr)

    def test_regions_are_explained(self):
        large = write_scan(self.path / "large.raw", 20000)
        small = self.path / "small.ply"
        self.run_it("sample", large, "-o", small, "--target", 500)
        out = ["-o", self.path / "fine.ply"]
        for region, said in (("blob:1", "is no kind of region"), ("box:1,2", "it has 2 numbers, not 6"),
                             ("sphere:0,0,0,-1", "not above 0"), ("box:0,0,0,1,1,x", "is no number"),
                             ("sphere:9,9,9,1", "no sample lies in the region")):
            result = self.run_it("sample", large, "--refine", region, "--from", small, *out, status=1)
            self.assertIn(said, result.stderr)
        self.assertIn("needs --from", self.run_it("sample", large, "--refine", "sphere:0,0,1,1", *out, status=1).stderr)
        self.assertIn("belong to --refine", self.run_it("sample", large, "--from", small, *out, status=1).stderr)
        report = json.loads(self.run_it("sample", large, "--refine", "sphere:0,0,1,0.5", "--from", small, "--target", 300,
                                        *out, "--json").stdout)
        self.assertGreater(report["new_samples"], 280)
        self.assertTrue((self.path / "fine.ply.cells").exists())


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--kills", type=int, default=KILLS)
    parsed = parser.parse_args()
    PROGRAM, KILLS = parsed.program, parsed.kills
    unittest.main(argv=sys.argv[:1])
