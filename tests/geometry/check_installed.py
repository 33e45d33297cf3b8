# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Installs the launcher's commands for files under another prefix, where each program must find the others and its libraries.

check_installed.py CMAKE BUILD: what was built.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

CMAKE = BUILD = ""


class Installed(unittest.TestCase):
    def test_commands(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            subprocess.run([CMAKE, "--install", BUILD, "--prefix", path / "prefix"], check=True, capture_output=True)
            rows = [f"{x / 9} {y / 9} {x * y / 90} 0 0 1" for x in range(10) for y in range(10)]
            (path / "points.xyz").write_text("\n".join(rows))
            plain = {key: value for key, value in os.environ.items() if key != "LD_LIBRARY_PATH"}
            commands = subprocess.run([path / "prefix/bin/glark", "--help"], capture_output=True, text=True).stdout
            for line in ("info points.xyz", "simplify points.xyz -o out.ply --target 20", "strip points.xyz -o out.ply", "bake points.xyz -o out.glb",
                         "view points.xyz --offscreen out.png"):
                if f"  {line.split()[0]} " not in commands:
                    continue
                with self.subTest(line=line):
                    result = subprocess.run([path / "prefix/bin/glark", *line.split()], cwd=path, env=plain,
                                            capture_output=True, text=True)
                    self.assertEqual(0, result.returncode, result.stdout + result.stderr)


if __name__ == "__main__":
    BUILD = sys.argv.pop()
    CMAKE = sys.argv.pop()
    unittest.main()
