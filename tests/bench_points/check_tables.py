# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Runs glark-bench-points on a few samples of a small mesh, and checks the tables in a file, the same tables as JSON, and its errors.

check_tables.py GLARK_BENCH_POINTS
"""
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""


def write_sphere(path: pathlib.Path, rows: int):
    points, triangles = [], []
    for row in range(rows + 1):
        for column in range(2 * rows):
            high, turn = math.pi * (row + 0.5) / (rows + 1), math.pi * column / rows
            points.append((math.sin(high) * math.cos(turn), math.sin(high) * math.sin(turn), math.cos(high)))
            if row < rows:
                a, b = row * 2 * rows + column, row * 2 * rows + (column + 1) % (2 * rows)
                triangles += [(a, a + 2 * rows, b), (b, a + 2 * rows, b + 2 * rows)]
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}"]
    header += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
    header += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header", ""]
    body = b"".join(struct.pack("<6f", *point, *point) for point in points)
    path.write_bytes("\n".join(header).encode() + body + b"".join(struct.pack("<B3i", 3, *t) for t in triangles))


class Tables(unittest.TestCase):
    def test_help(self):
        result = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True)
        self.assertEqual((0, ""), (result.returncode, result.stderr))
        for word in ("--only", "--data", "--samples", "--rounds", "--json", "--update", "simplification"):
            self.assertIn(word, result.stdout)

    def test_tables(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            write_sphere(path / "igea.ply", 30)
            text = path / "text.md"
            text.write_text("before\n<!-- glark-bench-points -->\nold\n<!-- end of glark-bench-points -->\nafter\n")
            run = lambda *words: subprocess.run([PROGRAM, "--data", path, "--only", "partition", *words],
                                                capture_output=True, text=True)
            result = run("--samples", "3000,6000", "--rounds", "1", "--json", path / "a.json", "--update", text)
            self.assertEqual(0, result.returncode, result.stderr)
            lines = text.read_text()
            self.assertTrue(lines.startswith("before\n") and lines.endswith("-->\nafter\n") and "old" not in lines)
            self.assertIn("Table 3.1 of the thesis", lines)
            tables = json.loads((path / "a.json").read_text())
            self.assertEqual(2, len(tables))
            for table in tables:
                self.assertIn(table["title"], lines)
                ours = table["rows"][0]
                self.assertEqual("volume-surface tree", ours["name"])
                self.assertGreater(ours["CPU s"], 0)
                self.assertGreater(ours["leaves"], 1)
                peer = next(row for row in table["rows"] if row["name"].startswith("kd-tree"))
                self.assertIsNone(peer["leaves"])
                self.assertEqual(1, peer["of the peer's"])
            text.write_text("no marks")
            self.assertIn("does not have the two lines", run("--samples", "1000", "--rounds", "1", "--update", text).stderr)
            self.assertEqual("no marks", text.read_text())
        for words, says in [(["--only", "nothing"], "no such group"), (["--fast", "1"], "is no option"),
                            (["--data", "/nowhere"], "/nowhere/igea.ply")]:
            result = subprocess.run([PROGRAM, *words], capture_output=True, text=True)
            self.assertEqual(1, result.returncode)
            self.assertIn(says, result.stderr)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop()
    unittest.main()
