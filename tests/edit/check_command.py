# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Runs glark edit as a process: scripts, mistakes, kills, and the bunny.

check_command.py GLARK_SCAN
"""
import json
import os
import pathlib
import random
import shutil
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

DATA = pathlib.Path(__file__).resolve().parents[3] / "shared/data"
PROGRAM = ""


def write_raw(path: pathlib.Path, count: int) -> None:
    """Points of a unit sphere."""
    z, turn = 1 - (2 * numpy.arange(count) + 1) / count, 2.399963229728653 * numpy.arange(count)
    radius = numpy.sqrt(1 - z * z)
    numpy.stack([radius * numpy.cos(turn), radius * numpy.sin(turn), z], axis=1).astype("<f4").tofile(path)


def read_raw(path: pathlib.Path) -> numpy.ndarray:
    return numpy.fromfile(path, "<f4").reshape(-1, 3).astype(float)


class Command(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.scan = self.path / "scan.raw"
        write_raw(self.scan, 20000)

    def edit(self, *arguments, status: int = 0, typed: str = "") -> subprocess.CompletedProcess:
        result = subprocess.run([PROGRAM, "edit", *map(str, arguments)], capture_output=True, text=True, input=typed, check=False)
        self.assertEqual(status, result.returncode, result.stderr)
        return result

    def script(self, *lines) -> pathlib.Path:
        file = self.path / "script.txt"
        file.write_text("".join(line + "\n" for line in lines))
        return file

    def report(self, *arguments, typed: str = "") -> dict:
        return json.loads(self.edit(*arguments, "--json", typed=typed).stdout)

    def test_a_script_and_a_result(self):
        script = self.script("# a comment", "", "move 0 0 0 9 1 0 0", "undo", "twist 0 0 -1 0 0 1 90")
        report = self.report(self.scan, "--script", script, "-o", self.path / "out.raw", "--target", 2000)
        self.assertEqual((3, 0, 20000, True, False),
                         tuple(report[key] for key in ("operations", "replayed", "points", "deformed", "painted")))
        before, after = read_raw(self.scan), read_raw(self.path / "out.raw")
        turn = (before[:, 2] + 1) * numpy.pi / 4
        wanted = numpy.stack([before[:, 0] * numpy.cos(turn) - before[:, 1] * numpy.sin(turn),
                              before[:, 0] * numpy.sin(turn) + before[:, 1] * numpy.cos(turn), before[:, 2]], axis=1)
        self.assertLess(numpy.sqrt(((after - wanted) ** 2).sum(axis=1).mean()), 2e-3)

    def test_a_bad_line_stops_before_the_first_one(self):
        script = self.script("inflate 0 0 1 0.5 0.1", "# a comment", "inflate 0 0 1")
        result = self.edit(self.scan, "--script", script, status=1)
        self.assertEqual(f"glark: {script}: line 3: inflate: RADIUS is missing; write: inflate X Y Z RADIUS AMOUNT\n", result.stderr)
        self.assertFalse((self.path / "scan.edit").exists())

    def test_a_line_that_cannot_be_applied_changes_nothing(self):
        script = self.script("inflate 0 0 1 0.5 0.1", "inflate 5 0 1 0.5 0.1", "inflate 0 0 1 0.5 0.1")
        result = self.edit(self.scan, "--script", script, "-o", self.path / "out.raw", "--target", 2000, status=1)
        self.assertIn(f"{script}: line 2: no sample is within 0.5 of 5 0 1", result.stderr)
        self.assertFalse((self.path / "out.raw").exists())
        self.assertEqual(1, self.report(self.scan, "--script", os.devnull)["operations"])

    def test_typed_lines(self):
        report = self.report(self.scan, "--target", 2000, typed=f"inflate 0 0 1 0.5 0.1\n\nsave {self.path}/a b.raw\nquit\nnonsense\n")
        self.assertEqual(1, report["operations"])
        self.assertGreater(read_raw(self.path / "a b.raw")[:, 2].max(), 1.05)
        self.assertIn("paint X Y Z", self.edit(self.scan, typed="help\n").stdout)
        result = self.edit(self.scan, typed="undo\nredo 2\n", status=1)
        self.assertIn('standard input: line 2: redo: "2" is one word too many', result.stderr)
        self.assertEqual(2, self.report(self.scan)["replayed"])

    def test_bad_files(self):
        self.assertIn("cannot be read", self.edit(self.scan, "--script", self.path / "none", status=1).stderr)
        self.assertIn("none.ply", self.edit(self.path / "none.ply", status=1).stderr)
        (self.path / "mine").mkdir()
        (self.path / "mine/thesis.txt").write_text("all my work")
        self.assertIn("--session", self.edit(self.scan, "--session", self.path / "mine", status=1).stderr)
        self.assertEqual(["thesis.txt"], os.listdir(self.path / "mine"))
        self.assertIn("the scan itself", self.edit(self.scan, "--target", 2000, "-o", self.scan, status=1).stderr)
        self.assertEqual(240000, self.scan.stat().st_size)

    def test_kills_lose_no_operation_of_the_script(self):
        """A process that is killed while it samples, edits or saves is continued by the rest of its script."""
        lines = [f"move {numpy.cos(k)} {numpy.sin(k)} 0 0.5 0 0 0.01" for k in range(300)]
        moments = random.Random(3)
        done = 0
        for _ in range(8):
            script = self.script(*lines[done:])
            process = subprocess.Popen([PROGRAM, "edit", str(self.scan), "--script", str(script), "--target", "2000"],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(moments.uniform(0.01, 0.25))
            process.kill()
            process.wait()
            log = self.path / "scan.edit/log"
            done = max(0, log.read_text().count("\n") - 1) if log.exists() else 0
        whole = self.report(self.scan, "--script", self.script(*lines[done:]), "-o", self.path / "killed.raw", "--target", 2000)
        self.assertEqual(300, whole["operations"])
        self.edit(self.scan, "--script", self.script(*lines), "-o", self.path / "straight.raw", "--target", 2000,
                  "--session", self.path / "straight.edit")
        self.assertEqual((self.path / "straight.raw").read_bytes(), (self.path / "killed.raw").read_bytes())

    def test_bunny(self):
        """Most points of the bunny follow the same edit of the bunny itself; what is frozen stays."""
        if not (DATA / "bunny.ply.zst").exists() or not shutil.which("zstd"):
            self.skipTest("../shared/data/bunny.ply.zst or zstd is missing")
        subprocess.run(["zstd", "-dqf", DATA / "bunny.ply.zst", "-o", self.path / "whole.ply"], check=True)
        subprocess.run([PROGRAM, "simplify", self.path / "whole.ply", "--target", "100000000", "-o", self.path / "bunny.ply"],
                       check=True, capture_output=True)
        info = json.loads(subprocess.run([PROGRAM, "info", self.path / "bunny.ply", "--json"], check=True,
                                         capture_output=True, text=True).stdout)
        low, high = (numpy.array(info["bounding_box"][key]) for key in ("low", "high"))
        size, middle = (high - low).max(), (low + high) / 2
        foot, top = [middle[0], low[1], middle[2]], [middle[0], high[1], middle[2]]
        words = " ".join(repr(float(number)) for number in [*foot, *top])
        script = self.script(f"twist {words} 60")
        report = self.report(self.path / "bunny.ply", "--script", script, "-o", self.path / "out.ply", "--target", 5000)
        self.assertLessEqual(report["samples"], 5000)
        before, after = (self.points(self.path / name) for name in ("bunny.ply", "out.ply"))
        turn = numpy.radians(60) * numpy.clip((before[:, 1] - low[1]) / (high[1] - low[1]), 0, 1)
        d = before - foot
        wanted = foot + numpy.stack([d[:, 0] * numpy.cos(turn) + d[:, 2] * numpy.sin(turn), d[:, 1],
                                     -d[:, 0] * numpy.sin(turn) + d[:, 2] * numpy.cos(turn)], axis=1)
        error = numpy.linalg.norm(after - wanted, axis=1)
        self.assertLess(numpy.sqrt((error ** 2).mean()), 2e-3 * size)

    def points(self, file: pathlib.Path) -> numpy.ndarray:
        data = file.read_bytes()
        begin = data.index(b"end_header\n") + 11
        header = data[:begin].decode().splitlines()
        count = next(int(line.split()[2]) for line in header if line.startswith("element vertex"))
        after_vertex = header[header.index(f"element vertex {count}") + 1:]
        row = []
        for line in after_vertex:
            if not line.startswith("property"):
                break
            row.append((line.split()[2], {"float": "<f4", "uchar": "u1", "double": "<f8"}[line.split()[1]]))
        vertices = numpy.frombuffer(data, row, count, begin)
        return numpy.stack([vertices[name] for name in "xyz"], axis=1).astype(float)


if __name__ == "__main__":
    if len(sys.argv) != 2 or not shutil.which(sys.argv[1]):
        sys.exit("check_command.py GLARK_SCAN")
    PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
    unittest.main(argv=sys.argv[:1])
