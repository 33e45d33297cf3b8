# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The full surface that pictures of baked models are compared with."""
import pathlib

import glb
import numpy
from scipy.spatial import cKDTree

NEIGHBOURS = 8
FIELDS = {"float": "<f4", "float32": "<f4", "double": "<f8", "uchar": "u1", "uint8": "u1"}


def read_points(file: pathlib.Path) -> numpy.ndarray:
    """The vertices of a binary PLY file, as a structured array with the names of its properties."""
    data = file.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    count, fields, is_vertex = 0, [], False
    for line in data[:end].decode().splitlines():
        words = line.split()
        if words[0] == "element":
            is_vertex = words[1] == "vertex"
            count = int(words[2]) if is_vertex else count
        elif words[0] == "property" and is_vertex:
            fields.append((words[2], FIELDS[words[1]]))
    return numpy.frombuffer(data, numpy.dtype(fields), count, end)


def columns(points: numpy.ndarray, names: str) -> numpy.ndarray:
    return numpy.column_stack([points[name] for name in names.split()])


def linear(shown: numpy.ndarray) -> numpy.ndarray:
    """Colours of vertices, which glTF stores linearly, of colours as they are shown (sRGB), 0 to 1."""
    return numpy.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)


def means_of_points(mesh: glb.Glb, points: numpy.ndarray, values: numpy.ndarray) -> numpy.ndarray:
    """At each vertex of the mesh: the mean of the nearest points' values. The nearer a point is, the more it counts."""
    distances, nearest = cKDTree(columns(points, "x y z")).query(mesh.array("POSITION"), NEIGHBOURS, workers=-1)
    width = 1.5 * numpy.median(distances[:, NEIGHBOURS // 2])
    weights = numpy.exp(-(distances / width) ** 2) + 1e-9
    return (values[nearest] * weights[..., None]).sum(axis=1) / weights.sum(axis=1)[:, None]


def with_colours_of(mesh: glb.Glb, points: numpy.ndarray) -> glb.Glb:
    shown = means_of_points(mesh, points, columns(points, "red green blue") / 255.0)
    return mesh.with_new_array("COLOR_0", linear(shown))


def with_normals_of(mesh: glb.Glb, points: numpy.ndarray) -> glb.Glb:
    normals = means_of_points(mesh, points, columns(points, "nx ny nz").astype(float))
    lengths = numpy.linalg.norm(normals, axis=1, keepdims=True)
    own = mesh.array("NORMAL")
    return mesh.with_array("NORMAL", numpy.where(lengths > 1e-6, normals / numpy.maximum(lengths, 1e-6), own))
