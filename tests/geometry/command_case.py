# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""A sphere in a folder, and the launcher as a process: what the tests of its commands for files share."""
import json
import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

GLARK = os.path.abspath(sys.argv.pop(1))


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


class CommandCase(unittest.TestCase):
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
