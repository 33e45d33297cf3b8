# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The displaced surface of a model of glark bake as plain triangles, for viewers that have no displacement mapping."""
import io
import pathlib

import glb
import numpy
from PIL import Image

DIVISIONS = 8  # of each edge


def pattern(divisions: int) -> tuple:
    """Barycentric coordinates [vertices, 3] and triangles [divisions * divisions, 3] of one divided triangle."""
    place, weights = {}, []
    for row in range(divisions + 1):
        for column in range(divisions + 1 - row):
            place[row, column] = len(weights)
            weights.append((divisions - row - column, column, row))
    triangles = []
    for row, column in place:
        if row + column < divisions:
            triangles.append((place[row, column], place[row, column + 1], place[row + 1, column]))
        if row + column + 1 < divisions:
            triangles.append((place[row, column + 1], place[row + 1, column + 1], place[row + 1, column]))
    return numpy.array(weights, numpy.float64) / divisions, numpy.array(triangles, numpy.uint32)


def bilinear(heights: numpy.ndarray, places: numpy.ndarray) -> numpy.ndarray:
    """Values of a map, [rows, columns], at texture coordinates, [n, 2], as OpenGL filters its first level."""
    size = numpy.array([heights.shape[1], heights.shape[0]])
    texel = places * size - 0.5
    low = numpy.floor(texel).astype(int)
    part = texel - low
    columns = [numpy.clip(low[:, 0] + i, 0, size[0] - 1) for i in (0, 1)]
    rows = [numpy.clip(low[:, 1] + i, 0, size[1] - 1) for i in (0, 1)]
    upper = heights[rows[0], columns[0]] * (1 - part[:, 0]) + heights[rows[0], columns[1]] * part[:, 0]
    lower = heights[rows[1], columns[0]] * (1 - part[:, 0]) + heights[rows[1], columns[1]] * part[:, 0]
    return upper * (1 - part[:, 1]) + lower * part[:, 1]


def unit(vectors: numpy.ndarray) -> numpy.ndarray:
    return vectors / numpy.maximum(numpy.linalg.norm(vectors, axis=1, keepdims=True), 1e-20)


def displace(model: glb.Glb, heights: numpy.ndarray, divisions: int = DIVISIONS) -> dict:
    """Attributes and triangles. heights: 0 to 1. Normals and tangents stay those of the coarse mesh, because the normal
    map is relative to them."""
    weights, parts = pattern(divisions)
    corners = model.triangles()

    def refined(attribute: str) -> numpy.ndarray:
        values = model.array(attribute).astype(numpy.float64)[corners]
        return numpy.einsum("vk,tkc->tvc", weights, values).reshape(-1, values.shape[2])

    arrays = {name: refined(name) for name in ("POSITION", "NORMAL", "TANGENT", "TEXCOORD_0")}
    to_height = model.material["extras"]["displacement"]
    height = to_height["scale"] * bilinear(heights, arrays["TEXCOORD_0"]) + to_height["bias"]
    arrays["NORMAL"] = unit(arrays["NORMAL"])
    arrays["TANGENT"][:, :3] = unit(arrays["TANGENT"][:, :3])
    arrays["POSITION"] += height[:, None] * arrays["NORMAL"]
    first = numpy.arange(len(corners), dtype=numpy.uint32)[:, None, None] * numpy.uint32(len(weights))
    return {**arrays, "triangles": (parts[None] + first).reshape(-1, 3)}


def with_geometry(model: glb.Glb, arrays: dict) -> glb.Glb:
    """The model with other attributes and triangles. Its pictures and material stay."""
    for name in model.primitive["attributes"]:
        model = model.with_new_array(name, arrays[name])
    return model.with_triangles(arrays["triangles"])


def read_heights(file: pathlib.Path) -> numpy.ndarray:
    return numpy.asarray(Image.open(io.BytesIO(file.read_bytes()))).astype(numpy.float64) / 65535


def write_displaced(file: pathlib.Path, out: pathlib.Path, divisions: int = DIVISIONS) -> None:
    model = glb.read(file)
    heights = read_heights(file.parent / model.material["extras"]["displacement"]["uri"])
    with_geometry(model, displace(model, heights, divisions)).write(out)
