# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Measures table 6.5 of the thesis with generated scans of as many points: table_6_5.py GLARK FOLDER OUT.json

A scan has six floats for each point, as the thesis has them: a ball with bumps.
"""
import json
import pathlib
import subprocess
import sys
import time

import numpy

SCANS = {"Omphalos": (11664466, 45504), "Column": (22877845, 51012)}  # points, and triangles at most
PART = 1000000
GOLDEN_ANGLE = 2.399963229728653
SAMPLES_A_TRIANGLE = 5  # as glark bake takes


def height(direction: numpy.ndarray) -> numpy.ndarray:
    x, y, z = direction.T
    return 1 + 0.02 * numpy.sin(9 * x) * numpy.sin(8 * y) * numpy.cos(7 * z) + 0.002 * numpy.sin(60 * x + 50 * z)


def gradient(direction: numpy.ndarray) -> numpy.ndarray:
    """Of the height, in space."""
    x, y, z = direction.T
    fine = 0.002 * numpy.cos(60 * x + 50 * z)
    return numpy.column_stack([
        0.18 * numpy.cos(9 * x) * numpy.sin(8 * y) * numpy.cos(7 * z) + 60 * fine,
        0.16 * numpy.sin(9 * x) * numpy.cos(8 * y) * numpy.cos(7 * z),
        -0.14 * numpy.sin(9 * x) * numpy.sin(8 * y) * numpy.sin(7 * z) + 50 * fine,
    ])


def part_of_scan(first: int, last: int, count: int) -> numpy.ndarray:
    """[points, 6]: positions and normals of a spiral over the ball."""
    i = numpy.arange(first, last)
    z, turn = 1 - (2 * i + 1) / count, GOLDEN_ANGLE * i
    ring = numpy.sqrt(1 - z * z)
    direction = numpy.column_stack([ring * numpy.cos(turn), ring * numpy.sin(turn), z])
    radius, slope = height(direction)[:, None], gradient(direction)
    along = slope - (slope * direction).sum(axis=1, keepdims=True) * direction
    normal = direction - along / radius
    normal /= numpy.linalg.norm(normal, axis=1, keepdims=True)
    return numpy.hstack([direction * radius, normal]).astype("<f4")


def write_scan(file: pathlib.Path, count: int) -> None:
    properties = "".join(f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz"))
    with file.open("wb") as out:
        out.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {count}\n{properties}end_header\n".encode())
        for first in range(0, count, PART):
            out.write(part_of_scan(first, min(first + PART, count), count).tobytes())


def run(*command: object) -> dict:
    start = time.perf_counter()
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{' '.join(map(str, command))}: {done.stderr}")
    report = json.loads(done.stdout) if done.stdout.startswith("{") else {}
    return {**report, "wall": time.perf_counter() - start}


def measure(glark: pathlib.Path, folder: pathlib.Path, points: int, triangles: int) -> dict:
    scan, samples, strips, model = (folder / name for name in ("scan.ply", "samples.ply", "strips.ply", "model.glb"))
    write_scan(scan, points)
    memory = ["--memory", "256MB", "--json"]
    sampling = run(glark, "sample", scan, "-o", samples, "--target", SAMPLES_A_TRIANGLE * triangles, *memory)
    stripping = run(glark, "strip", samples, "-o", strips, "--json")
    baking = run(glark, "bake", scan, "-o", model, "--triangles", triangles, *memory)
    scan.unlink()
    texels = baking["width"] * baking["height"]
    return {"points": points, "simplification": sampling["wall"], "stripping": stripping["wall"], "total": baking["wall"],
            "charts": baking["charts"], "triangles": baking["triangles"], "texture_megabytes": texels * 3 * 4 / 3 / 1e6,
            "peak_megabytes": baking["peak_memory_bytes"] / 1e6}


def main() -> None:
    glark, folder, out = (pathlib.Path(word) for word in sys.argv[1:])
    folder.mkdir(parents=True, exist_ok=True)
    out.write_text(json.dumps({name: measure(glark, folder, *scan) for name, scan in SCANS.items()}, indent=1))


if __name__ == "__main__":
    main()
