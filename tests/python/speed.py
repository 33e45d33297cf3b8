#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Compares calls from Python with the same calls of the shared libraries, which have the C++ code: processor time of all
threads, the least of several alternating runs.

  PYTHONPATH=build/release/lib/python tests/python/speed.py build/release/lib [--points N] [--runs N]
"""
import argparse
import ctypes
import gc
import pathlib
import time

import numpy

import glark
import glark.vstree
from sphere import sphere


class Array(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("count", ctypes.c_size_t)]

    @classmethod
    def of(cls, values: numpy.ndarray) -> "Array":
        return cls(values.ctypes.data, values.size)


class PointSet(ctypes.Structure):
    _fields_ = [("positions", Array), ("normals", Array), ("colours", Array), ("texcoords", Array)]


class Mesh(ctypes.Structure):
    _fields_ = [("points", PointSet), ("triangles", Array)]


def waves(count: int) -> tuple:
    """Returns points of a wavy sphere, and the directions from its middle as normals."""
    directions = sphere(count)
    heights = 1 + 0.05 * numpy.sin(4 * numpy.arctan2(directions[:, 1], directions[:, 0])) * (1 - directions[:, 2] ** 2)
    return directions * heights[:, None].astype(numpy.float32), directions


def made_and_freed(make, free, argument) -> None:
    result = ctypes.c_void_p()
    if make(ctypes.byref(argument), None, ctypes.byref(result), None) != 0:
        raise RuntimeError(f"{make.__name__} failed")
    free(result)


def calls(folder: pathlib.Path, positions: numpy.ndarray, normals: numpy.ndarray) -> dict:
    """Name -> (call from Python, call of the library)."""
    vstree = ctypes.CDLL(str(folder / "libglark-vstree.so.0"))
    reconstruct = ctypes.CDLL(str(folder / "libglark-reconstruct.so.0"))
    for free in (vstree.glark_vstree_tree_free, vstree.glark_vstree_simplified_free, reconstruct.glark_reconstruct_mesh_free):
        free.argtypes = [ctypes.c_void_p]
    points = PointSet(Array.of(positions), Array.of(normals), Array(), Array())
    bare = PointSet(Array.of(positions), Array(), Array(), Array())
    mesh = Mesh(points, Array())
    output = numpy.empty_like(positions)

    def normals_of_library() -> None:
        if vstree.glark_vstree_estimate_normals(ctypes.byref(bare), None, Array.of(output), None) != 0:
            raise RuntimeError("glark_vstree_estimate_normals failed")

    return {
        "vstree.Tree": (lambda: glark.vstree.Tree(positions, normals),
                        lambda: made_and_freed(vstree.glark_vstree_tree_create, vstree.glark_vstree_tree_free, points)),
        "vstree.simplify": (lambda: glark.vstree.simplify(positions, None, normals).positions,
                            lambda: made_and_freed(vstree.glark_vstree_simplify, vstree.glark_vstree_simplified_free, mesh)),
        "vstree.estimate_normals": (lambda: glark.vstree.estimate_normals(positions), normals_of_library),
        "reconstruct": (lambda: glark.reconstruct(positions, normals).triangles,
                        lambda: made_and_freed(reconstruct.glark_reconstruct, reconstruct.glark_reconstruct_mesh_free, points)),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("libraries", type=pathlib.Path, help="the folder of libglark-vstree.so.0")
    parser.add_argument("--points", type=int, default=1_000_000)
    parser.add_argument("--runs", type=int, default=5)
    options = parser.parse_args()
    positions, normals = waves(options.points)
    gc.disable()
    print(f"{'':24}{'Python, s':>10}{'library, s':>11}{'ratio':>7}")
    for name, both in calls(options.libraries, positions, normals).items():
        least = [float("inf")] * 2
        for _ in range(options.runs):
            for which, call in enumerate(both):
                begin = time.process_time()
                call()
                least[which] = min(least[which], time.process_time() - begin)
        print(f"{name:24}{least[0]:10.3f}{least[1]:11.3f}{least[0] / least[1]:7.3f}", flush=True)


if __name__ == "__main__":
    main()
