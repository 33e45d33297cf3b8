# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Runs an example and checks that it refined triangles and wrote its picture: check_example.py PICTURE PROGRAM ..."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

picture, command = pathlib.Path(sys.argv[1]), sys.argv[2:]
picture.unlink(missing_ok=True)
with tempfile.TemporaryDirectory() as folder:
    statistics = pathlib.Path(folder) / "statistics.json"
    subprocess.run(command, check=True, timeout=120, env=dict(os.environ, GLARK_STATS=str(statistics)))
    counts = json.loads(statistics.read_text())
if not picture.exists() or not picture.read_bytes().startswith(b"\x89PNG"):
    sys.exit(f"check_example: {command[0]} wrote no picture")
if counts["refined_triangles"] <= counts["coarse_triangles"]:
    sys.exit(f"check_example: {command[0]} refined nothing: {counts['draws']}")
print(f"{counts['coarse_triangles']} coarse triangles became {counts['refined_triangles']}")
