# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The commands of docs/how-to/edit.md do what the page says, and its table has the operations of the command.

how_to_test.py GLARK_SCAN
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy
except ImportError:
    if os.environ.get("CI"):
        raise
    print("numpy is missing: skipped")
    sys.exit(0)

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/how-to/edit.md"
COUNT, MORE = 300000, 5000


def blocks(kind: str) -> list:
    found = re.findall(r"^```(\w*)\n(.*?)^```$", PAGE.read_text(), re.MULTILINE | re.DOTALL)
    return [text for of_kind, text in found if of_kind == kind]


def write_sphere(path: pathlib.Path) -> None:
    """A grey unit sphere in rings from above."""
    points = numpy.zeros(COUNT, [("position", "<f4", 3), ("colour", "u1", 3)])
    z, turn = 1 - (2 * numpy.arange(COUNT) + 1) / COUNT, 2.399963229728653 * numpy.arange(COUNT)
    points["position"] = numpy.stack([numpy.cos(turn), numpy.sin(turn), z], axis=1)
    points["position"][:, :2] *= numpy.sqrt(1 - z * z)[:, None]
    points["colour"] = 128
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {COUNT}\n"
    header += "".join(f"property float {name}\n" for name in "xyz")
    header += "".join(f"property uchar {name}\n" for name in ("red", "green", "blue")) + "end_header\n"
    path.write_bytes(header.encode() + points.tobytes())


def read(path: pathlib.Path) -> numpy.ndarray:
    data = path.read_bytes()
    return numpy.frombuffer(data[data.index(b"end_header\n") + 11:], [("position", "<f4", 3), ("colour", "u1", 3)])


class HowTo(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        write_sphere(cls.path / "scan.ply")
        (cls.path / "glark").symlink_to(PROGRAM)
        script, = blocks("text")
        (cls.path / "edit.txt").write_text(script)
        cls.first, cls.second, cls.third = blocks("")
        cls.before = read(cls.path / "scan.ply")
        cls.run_commands(cls.first)
        cls.edited = read(cls.path / "edited.ply")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def run_commands(cls, commands: str) -> str:
        environment = dict(os.environ, PATH=f"{cls.path}:{os.environ['PATH']}")
        result = subprocess.run(["sh", "-ec", commands], cwd=cls.path, env=environment, capture_output=True, text=True)
        assert result.returncode == 0, result.stdout + result.stderr
        return result.stdout

    def test_the_top_is_red_and_higher(self):
        top, bottom = self.before["position"][:, 2] > 0.99, self.before["position"][:, 2] < -0.5
        self.assertTrue((self.edited["colour"][top] == (255, 0, 0)).all())
        self.assertTrue((self.edited["colour"][bottom] == 128).all())
        self.assertGreater(self.edited["position"][top, 2].max(), 1.08)

    def test_the_ears_are_mirrored(self):
        shift = self.edited["position"][:, 2] - self.before["position"][:, 2]
        for side in (-1, 1):
            ear = numpy.linalg.norm(self.before["position"] - (0.6 * side, 0, 0.8), axis=1) < 0.1
            self.assertGreater(ear.sum(), 100)
            self.assertTrue((abs(shift[ear] - 0.3) < 0.08).all())

    def test_the_waist_turns_by_a_quarter(self):
        """What lies below stays; what lies between the waist and the top turns as a whole."""
        before, after = (points["position"].astype(float) for points in (self.before, self.edited))
        low = before[:, 2] < -0.35
        self.assertLess(abs(after[low] - before[low]).max(), 1e-3)
        band = (before[:, 2] > 0.35) & (before[:, 2] < 0.4) & (abs(before[:, 1]) > 0.7)
        wanted = numpy.stack([-before[band, 1], before[band, 0], before[band, 2]], axis=1)
        self.assertLess(abs(after[band] - wanted).max(), 1e-2)

    def test_z_later_calls_go_on(self):
        bytes_before = (self.path / "edited.ply").read_bytes()
        self.run_commands(self.second)
        self.assertEqual(bytes_before, (self.path / "edited.ply").read_bytes())
        self.run_commands("glark edit scan.ply --script /dev/null -o again.ply")
        self.assertEqual(bytes_before, (self.path / "again.ply").read_bytes())
        said = self.run_commands(self.third)
        samples = int(re.search(r"^samples\s+(\d+)$", said, re.MULTILINE).group(1))
        self.assertGreater(samples, 0.98 * 20000 + 0.9 * MORE)
        colours = read(self.path / "edited.ply")["colour"]
        self.assertGreater((colours == (255, 255, 0)).all(axis=1).sum(), 50)

    def test_the_table_has_all_operations(self):
        shown = subprocess.run([PROGRAM, "edit", "--help"], capture_output=True, text=True, check=True).stdout
        forms = re.findall(r"^  ([a-z]+ ?[A-Z\[].*|[a-z]+|symmetric .*)$", shown.split("one in each line:")[1], re.MULTILINE)
        self.assertGreater(len(forms), 10)
        page = PAGE.read_text().replace("`, `", ", or ")
        for form in forms:
            self.assertIn(form, page)


if __name__ == "__main__":
    if len(sys.argv) != 2 or not shutil.which(sys.argv[1]):
        sys.exit("how_to_test.py GLARK_SCAN")
    PROGRAM = pathlib.Path(sys.argv[1]).resolve()
    unittest.main(argv=sys.argv[:1])
