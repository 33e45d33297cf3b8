# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Commands of several processes write the same bytes as those of one, and end together.

check_mpi.py GLARK_SCAN GLARK_MPI
"""
import json
import os
import pathlib
import re
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
    sys.exit(77)

import scans

PROGRAM, MPI_PROGRAM = "", ""
POINTS, LARGE, TARGET = 70000, 160000, 1500  # LARGE: more points than 40 MiB have room for
OF_MPI = 14 << 20  # bytes of memory
RANKS = (1, 2, 3, 4)
# Containers often forbid the fast way between processes of one machine, and mpirun would say so. It also looks for
# graphics cards through X, whose server may end meanwhile.
ENVIRONMENT = dict(os.environ, OMPI_MCA_btl_vader_single_copy_mechanism="none", HWLOC_COMPONENTS="-gl")
LIMIT = 200  # seconds
MPIRUN = ("mpirun", "--allow-run-as-root", "--oversubscribe")


def with_ranks(ranks: int, *arguments) -> list:
    return [*MPIRUN, "-n", str(ranks), MPI_PROGRAM, *map(str, arguments)]


def complaints(said: str) -> list:
    return [line for line in said.splitlines() if line.startswith("glark:")]


class Ranks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def run_it(self, command: list, status: int = 0) -> subprocess.CompletedProcess:
        done = subprocess.run(command, capture_output=True, text=True, env=ENVIRONMENT, timeout=LIMIT, check=False)
        self.assertEqual(status, done.returncode, done.stderr)
        return done

    def one(self, *arguments) -> subprocess.CompletedProcess:
        return self.run_it([PROGRAM, *map(str, arguments)])

    def all(self, ranks: int, *arguments, status: int = 0) -> subprocess.CompletedProcess:
        return self.run_it(with_ranks(ranks, *arguments), status)

    def require_nothing_left(self):
        self.assertEqual([], [file.name for file in self.path.iterdir() if "partial" in file.name or file.name[0] == "."])

    def edited(self, scan: pathlib.Path) -> list:
        """Returns the arguments of a transfer of an edit."""
        small, edited = self.path / "small.ply", self.path / "edited.ply"
        self.one("sample", scan, "-o", small, "--target", TARGET)
        scans.write_bent(small, edited)
        return ["transfer", scan, "--from", small, "--to", edited]

    def check_transfer(self, scan: pathlib.Path):
        arguments = self.edited(scan)
        wanted = self.path / f"wanted{scan.suffix}"
        said = json.loads(self.one(*arguments, "-o", wanted, "--json").stdout)
        for ranks in RANKS:
            with self.subTest(scan=scan.name, ranks=ranks):
                output = self.path / f"{ranks}{scan.suffix}"
                report = json.loads(self.all(ranks, *arguments, "-o", output, "--json").stdout)
                self.assertTrue(output.read_bytes() == wanted.read_bytes())
                self.assertEqual(ranks, report["ranks"])
                self.assertEqual(ranks > 1, report["messages_sent"] > 0)
                for name in ("points", "points_away", "deformed", "channels"):
                    self.assertEqual(said[name], report[name])
        self.require_nothing_left()

    def test_transfer_to_points(self):
        self.check_transfer(scans.write_raw(self.path / "rings.raw", scans.bumpy_sphere(POINTS)))
        self.check_transfer(scans.write_raw(self.path / "shuffled.raw", scans.bumpy_sphere(POINTS, shuffled=True)))

    def test_transfer_to_meshes(self):
        self.check_transfer(scans.write_ply(self.path / "mesh.ply", scans.bumpy_sphere(POINTS), faces=True))
        self.check_transfer(scans.write_ply(self.path / "few.ply", scans.bumpy_sphere(POINTS, shuffled=True)[:5], faces=True))

    def test_transfer_to_las(self):
        self.check_transfer(scans.write_las(self.path / "scan.las", scans.bumpy_sphere(POINTS)))

    def test_transfer_with_a_sampling_on_the_disk(self):
        scan = scans.write_ply(self.path / "scan.ply", scans.bumpy_sphere(POINTS))
        small, edited = scans.write_ply(self.path / "small.ply", scans.bumpy_sphere(200000)), self.path / "edited.ply"
        scans.write_bent(small, edited)
        arguments = ["transfer", scan, "--from", small, "--to", edited, "--json", "-o"]
        self.one(*arguments, self.path / "wanted.ply")
        more = [self.path / "out.ply", "--memory", "48MiB", "--threads", 1, "--temporary", self.path]
        report = json.loads(self.all(2, *arguments, *more).stdout)
        self.assertGreater(report["cells_on_disk"], 40)
        self.assertLess(report["peak_memory_bytes"], (48 << 20) + OF_MPI)
        self.assertTrue((self.path / "out.ply").read_bytes() == (self.path / "wanted.ply").read_bytes())
        self.require_nothing_left()

    def check_sample(self, scan: pathlib.Path, *more, in_core: bool = False, shuffled: bool = False):
        arguments = ["sample", scan, "--memory", "40MiB", "--json", *more]
        wanted = self.path / "wanted.ply"
        said = json.loads(self.one(*arguments, "-o", wanted).stdout)
        self.assertEqual((in_core, shuffled), (said["in_core"], said["shuffled"]), scan)
        for ranks in RANKS:
            with self.subTest(scan=scan.name, ranks=ranks):
                output = self.path / f"{ranks}.ply"
                report = json.loads(self.all(ranks, *arguments, "-o", output).stdout)
                self.assertTrue(output.read_bytes() == wanted.read_bytes())
                self.assertEqual(pathlib.Path(f"{wanted}.cells").read_text(), pathlib.Path(f"{output}.cells").read_text())
                for name in ("points", "samples", "cells", "in_core", "shuffled"):
                    self.assertEqual(said[name], report[name])
                self.assertLess(report["peak_memory_bytes"], said["peak_memory_bytes"] + OF_MPI)
        self.require_nothing_left()

    def test_sample_of_points(self):
        rings = scans.write_raw(self.path / "rings.raw", scans.bumpy_sphere(LARGE))
        self.check_sample(rings, "--target", TARGET)
        self.check_sample(rings, "--error", "1e-3")
        shuffled = scans.write_raw(self.path / "shuffled.raw", scans.bumpy_sphere(LARGE, shuffled=True))
        self.check_sample(shuffled, "--target", TARGET, shuffled=True)

    def test_sample_of_meshes(self):
        self.check_sample(scans.write_ply(self.path / "mesh.ply", scans.bumpy_sphere(LARGE), faces=True), "--target", TARGET)
        self.check_sample(scans.write_ply(self.path / "few.ply", scans.bumpy_sphere(5), faces=True), "--target", 3, in_core=True)

    def test_sample_of_las(self):
        self.check_sample(scans.write_las(self.path / "scan.las", scans.bumpy_sphere(LARGE)), "--target", TARGET)

    def test_sample_of_text(self):
        text = self.path / "scan.xyz"
        numpy.savetxt(text, scans.bumpy_sphere(POINTS), "%.6f")
        self.check_sample(text, "--target", TARGET)

    def check_simplify(self, scan: pathlib.Path, *more, in_parts: bool = True, ranks_of_test: tuple = (1, 2, 3)):
        arguments = ["simplify", scan, "--json", *more]
        wanted = self.path / "wanted.ply"
        said = json.loads(self.one(*arguments, "-o", wanted).stdout)
        for ranks in ranks_of_test:
            with self.subTest(scan=scan.name, ranks=ranks):
                output = self.path / f"{ranks}.ply"
                done = self.all(ranks, *arguments, "-o", output)
                report = json.loads(done.stdout)
                self.assertTrue(output.read_bytes() == wanted.read_bytes())
                self.assertEqual(int(in_parts), done.stderr.count("read in parts, for"), done.stderr)
                for name in ("input", "output", "method"):
                    self.assertEqual(said[name], report[name])
                self.assertEqual(ranks, report["ranks"])
        self.require_nothing_left()

    def test_simplify_of_meshes(self):
        small = ["--target", 2000, "--memory", "128MiB"]
        self.check_simplify(scans.write_wide_mesh(self.path / "mesh.ply", 440), *small)
        self.check_simplify(scans.write_wide_mesh(self.path / "polygon.ply", 440, polygon=5), *small, ranks_of_test=(2,))
        self.check_simplify(scans.write_stl(self.path / "mesh.stl", 600), *small)
        self.check_simplify(scans.write_wide_mesh(self.path / "whole.ply", 40), *small, in_parts=False)

    def test_simplify_of_points(self):
        raw = scans.write_raw(self.path / "rings.raw", scans.bumpy_sphere(LARGE))
        self.check_simplify(raw, "--target", TARGET, "--memory", "128MiB")
        self.check_simplify(scans.write_las(self.path / "scan.las", scans.bumpy_sphere(POINTS)), "--memory", "128MiB")

    def test_errors_of_simplify_leave_the_old_output(self):
        mesh, output = scans.write_wide_mesh(self.path / "mesh.ply", 440), self.path / "out.ply"
        arguments = ["simplify", mesh, "-o", output, "--memory", "128MiB", "--target"]
        output.write_text("old")
        said = self.all(2, *arguments, 10**7, status=1).stderr
        self.assertEqual(1, said.count("give so much with --memory, or a smaller target (rank 0 of 2)"), said)
        self.assertNotEqual(0, self.kill_a_rank(with_ranks(3, *arguments, 2000)))
        self.assertEqual("old", output.read_text())
        self.all(2, *arguments, 2000)
        self.assertNotEqual("old", output.read_bytes()[:3].decode())
        with open(mesh, "r+b") as file:
            file.truncate(mesh.stat().st_size - 1000)
        before = output.read_bytes()
        self.assertEqual(1, self.all(2, *arguments, 2000, status=1).stderr.count("(rank "))
        self.assertEqual(before, output.read_bytes())

    def test_the_manual_has_every_option(self):
        page = (pathlib.Path(__file__).parents[2] / "docs/man/glark-mpi.1").read_text().replace("\\-", "-")
        for command in ("sample", "transfer", "simplify"):
            said = self.all(2, command, "--help").stdout
            options = re.findall(r"^\s+(?:-\w,)?(--[\w-]+)", said, re.MULTILINE)
            self.assertGreater(len(options), 6)
            self.assertEqual(len(options), len(set(options)), "only one rank explains")
            self.assertEqual([], [name for name in options if name not in page and name != "--help"])

    def check_complaint(self, said: str, *words: str):
        self.assertEqual(1, len(complaints(said)), said)
        for word in words:
            self.assertIn(word, said)
        self.require_nothing_left()

    def test_errors_of_all_ranks_are_said_once(self):
        scan = scans.write_ply(self.path / "scan.ply", scans.bumpy_sphere(POINTS))
        arguments, output = self.edited(scan), self.path / "out.ply"
        output.write_text("old")
        with open(scan, "r+b") as file:
            file.truncate(scan.stat().st_size - 1000)
        self.check_complaint(self.all(3, *arguments, "-o", output, status=1).stderr, "scan.ply", "(rank 0 of 3)")
        self.assertEqual("old", output.read_text())
        self.check_complaint(self.all(2, "sample", scan, "-o", output, "--target", 9, status=1).stderr, "scan.ply")
        self.assertEqual("old", output.read_text())
        self.check_complaint(self.all(2, *arguments[:4], status=2).stderr, "--to is required")

    def test_an_error_of_one_rank_ends_all(self):
        scan = scans.write_las(self.path / "scan.las", scans.bumpy_sphere(POINTS))
        arguments, output = self.edited(scan), self.path / "out.las"
        output.write_text("old")
        header, rows = scans.sampling_of(self.path / "small.ply")
        rows["position"][rows["position"][:, 2] > 0.97] *= 1e6  # the last points only
        (self.path / "edited.ply").write_bytes(header + rows.tobytes())
        self.check_complaint(self.all(4, *arguments, "-o", output, status=1).stderr, "(rank 3 of 4)")
        self.assertEqual("old", output.read_text())

    def test_a_folder_that_cannot_be_written(self):
        arguments = self.edited(scans.write_raw(self.path / "scan.raw", scans.bumpy_sphere(POINTS)))
        (self.path / "file").write_text("no folder")
        said = self.all(2, *arguments, "-o", self.path / "file" / "out.raw", status=1).stderr
        self.check_complaint(said, "out.raw", "(rank 0 of 2)")
        (self.path / "out.raw.partial").mkdir()
        (self.path / "out.raw.partial" / "mine").write_text("kept")
        said = self.all(2, *arguments, "-o", self.path / "out.raw", status=1).stderr
        self.assertEqual(1, len(complaints(said)), said)
        self.assertEqual("kept", (self.path / "out.raw.partial" / "mine").read_text())

    def ranks_of(self, launcher: subprocess.Popen) -> list:
        children = pathlib.Path(f"/proc/{launcher.pid}/task/{launcher.pid}/children")
        return [int(word) for word in children.read_text().split()]

    def has_begun(self, rank: int) -> bool:
        """Whether a rank has files open in the folder of the test: the scan, at least."""
        try:
            return any(os.readlink(file).startswith(str(self.path)) for file in pathlib.Path(f"/proc/{rank}/fd").iterdir())
        except OSError:  # files come and go
            return False

    def kill_a_rank(self, command: list) -> int:
        """Kills the last rank when its work has begun. Returns the status of mpirun."""
        launcher = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=ENVIRONMENT)
        until = time.monotonic() + LIMIT
        while launcher.poll() is None and time.monotonic() < until:
            if ranks := self.ranks_of(launcher):
                if self.has_begun(ranks[-1]):
                    time.sleep(0.1)  # into the work
                    os.kill(ranks[-1], signal.SIGKILL)
                    break
            time.sleep(0.002)
        return launcher.wait(timeout=LIMIT)

    def test_a_killed_rank_leaves_the_old_output(self):
        scan = scans.write_raw(self.path / "scan.raw", scans.bumpy_sphere(20 * POINTS, shuffled=True))
        arguments, output = self.edited(scan), self.path / "out.raw"
        output.write_text("old")
        self.assertNotEqual(0, self.kill_a_rank(with_ranks(3, *arguments, "-o", output)))
        self.assertEqual("old", output.read_text())
        self.all(3, *arguments, "-o", output, "--resume")
        self.one(*arguments, "-o", self.path / "wanted.raw")
        self.assertTrue(output.read_bytes() == (self.path / "wanted.raw").read_bytes())
        small = self.path / "small.ply"
        small.write_text("old")
        self.assertNotEqual(0, self.kill_a_rank(with_ranks(3, "sample", scan, "-o", small, "--target", TARGET)))
        self.assertEqual("old", small.read_text())
        self.require_nothing_left()


if __name__ == "__main__":
    PROGRAM, *more = sys.argv[1:]
    if not more or not shutil.which("mpirun"):
        print("glark-mpi or mpirun is missing: skipped; scripts/install_packages --cluster installs MPI")
        sys.exit(1 if os.environ.get("CI") else 77)
    MPI_PROGRAM = more[0]
    start = subprocess.run([*MPIRUN, "-n", "2", "true"], capture_output=True, text=True, env=ENVIRONMENT, timeout=LIMIT)
    if start.returncode != 0:  # without a network interface, for example
        print("mpirun starts no processes here: skipped\n" + start.stderr)
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
