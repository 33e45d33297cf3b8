# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The commands and scripts of docs/tutorial/large-scan.md do what the page says, with fewer points.

tutorial_test.py GLARK_SCAN
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

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/tutorial/large-scan.md"
COUNT, TARGET, MORE = 400000, 20000, 5000


def blocks(kind: str) -> list:
    found = re.findall(r"^```(\w*)\n(.*?)^```$", PAGE.read_text(), re.MULTILINE | re.DOTALL)
    return [text for of_kind, text in found if of_kind == kind]


def read(path: pathlib.Path, normals: bool) -> numpy.ndarray:
    row = [("position", "<f4", 3)] + [("normal", "<f4", 3)] * normals + [("colour", "u1", 3)]
    data = path.read_bytes()
    return numpy.frombuffer(data[data.index(b"end_header\n") + 11:], row)


class Tutorial(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        make, edit = blocks("python")
        assert "20_000_000" in make
        (cls.path / "make_scan.py").write_text(make.replace("20_000_000", str(COUNT)))
        (cls.path / "edit.py").write_text(edit)
        (cls.path / "glark").symlink_to(PROGRAM)
        commands = "".join(blocks("")).replace("python3", sys.executable)
        environment = dict(os.environ, PATH=f"{cls.path}:{os.environ['PATH']}")
        result = subprocess.run(["sh", "-ec", commands], cwd=cls.path, env=environment, capture_output=True, text=True)
        assert result.returncode == 0, result.stdout + result.stderr
        cls.large = read(cls.path / "large.ply", False)
        cls.edited = read(cls.path / "large.edited.ply", False)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_the_scan_is_bent(self):
        wanted = self.large["position"].astype(float)
        wanted[:, 0] += 0.5 * wanted[:, 2] ** 2
        error = numpy.linalg.norm(self.edited["position"] - wanted, axis=1)
        self.assertLess(numpy.sqrt((error ** 2).mean()), 1e-3)

    def test_its_top_is_red(self):
        height = self.large["position"][:, 2]
        top, rest = self.edited["colour"][height > 0.9], self.edited["colour"][height < 0.7]
        self.assertTrue((top == (255, 0, 0)).all())
        self.assertTrue((rest == 200).all())

    def test_the_part_has_more_samples(self):
        small, finer, both = (read(self.path / name, True) for name in ("small.ply", "finer.ply", "finer.edited.ply"))
        self.assertGreater(len(small), 0.98 * TARGET)
        self.assertEqual(len(finer), len(both))
        new = len(finer) - len(small)
        self.assertGreater(new, 0.9 * MORE)
        self.assertLessEqual(new, MORE)
        away = numpy.linalg.norm(both["position"][len(small):] - (0.5, 0, 1), axis=1)
        self.assertLess(away.max(), 0.45)


if __name__ == "__main__":
    if len(sys.argv) != 2 or not shutil.which(sys.argv[1]):
        sys.exit("tutorial_test.py GLARK_SCAN")
    PROGRAM = pathlib.Path(sys.argv[1]).resolve()
    unittest.main(argv=sys.argv[:1])
