#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Tells how sharp the creases of a baked model are: the angles between the normals that it shows and those of the fine mesh.

creases.py MODEL.glb FINE.stl

A place near a crease may show the normal of either side. So the angle is that to the nearest of the normals around it, within one
percent of the diagonal. Needs NumPy, SciPy and Pillow.
"""
import io
import json
import struct
import sys

import numpy
from PIL import Image
from scipy.spatial import cKDTree

WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


def unit(vectors):
    return vectors / numpy.maximum(numpy.linalg.norm(vectors, axis=-1, keepdims=True), 1e-30)


class Model:
    def __init__(self, file):
        with open(file, "rb") as stream:
            data = stream.read()
        length = struct.unpack_from("<I", data, 12)[0]
        self.gltf, self.bytes = json.loads(data[20:20 + length]), data[28 + length:]
        primitive = self.gltf["meshes"][0]["primitives"][0]
        names = ("POSITION", "NORMAL", "TANGENT", "TEXCOORD_0")
        self.position, self.normal, self.tangent, self.texcoord = (
            self.array(primitive["attributes"][name], "<f4").astype(float) for name in names)
        self.position = self.position + self.gltf["nodes"][0].get("translation", [0, 0, 0])
        self.triangles = self.array(primitive["indices"], "<u4").reshape(-1, 3)
        view = self.gltf["bufferViews"][self.gltf["images"][0]["bufferView"]]
        begin = view.get("byteOffset", 0)
        picture = Image.open(io.BytesIO(self.bytes[begin:begin + view["byteLength"]]))
        self.map = numpy.asarray(picture).astype(float) / 127.5 - 1

    def array(self, index, kind):
        accessor = self.gltf["accessors"][index]
        width = WIDTHS[accessor["type"]]
        begin = self.gltf["bufferViews"][accessor["bufferView"]].get("byteOffset", 0)
        return numpy.frombuffer(self.bytes, kind, accessor["count"] * width, begin).reshape(-1, width)

    def seen(self, triangles, weights):
        """The positions, coarse normals and normals of the map at places of triangles."""
        corners = self.triangles[triangles]
        position, normal, tangent, texcoord = (
            numpy.einsum("nk,nkc->nc", weights, values[corners])
            for values in (self.position, self.normal, self.tangent, self.texcoord))
        normal, tangent = unit(normal), unit(tangent[:, :3])
        bitangent = unit(numpy.cross(normal, tangent)) * self.tangent[corners[:, 0], 3][:, None]
        local = self.filtered(texcoord)
        return position, normal, unit(local[:, :1] * tangent + local[:, 1:2] * bitangent + local[:, 2:] * normal)

    def filtered(self, texcoord):
        size = numpy.array(self.map.shape[1::-1])
        at = numpy.clip(texcoord * size - 0.5, 0, size - 1.001)
        x, y = at.astype(int).T
        part = at - numpy.floor(at)
        right, low = part[:, :1], part[:, 1:]
        return ((1 - low) * ((1 - right) * self.map[y, x] + right * self.map[y, x + 1]) +
                low * ((1 - right) * self.map[y + 1, x] + right * self.map[y + 1, x + 1]))


def read_stl(file):
    with open(file, "rb") as stream:
        data = stream.read()
    kind = numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    return numpy.frombuffer(data, kind, struct.unpack_from("<I", data, 80)[0], 84)["corners"].astype(float)


def sample(random, corners, count):
    """Triangles, by their area, and weights of places in them; and the normals of all triangles."""
    cross = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = numpy.linalg.norm(cross, axis=1)
    triangles = random.choice(len(corners), count, p=areas / areas.sum())
    return triangles, random.dirichlet([1, 1, 1], count), unit(cross)


def main():
    model, fine = Model(sys.argv[1]), read_stl(sys.argv[2])
    random = numpy.random.default_rng(1)
    triangles, weights, normals = sample(random, fine, 800000)
    points, normals = numpy.einsum("nk,nkc->nc", weights, fine[triangles]), normals[triangles]
    triangles, weights, _ = sample(random, model.position[model.triangles], 150000)
    positions, coarse, seen = model.seen(triangles, weights)
    diagonal = numpy.linalg.norm(numpy.ptp(model.position, axis=0))
    distances, nearest = cKDTree(points).query(positions, k=24, distance_upper_bound=0.01 * diagonal)
    around = normals[numpy.minimum(nearest, len(normals) - 1)]
    faces = numpy.isfinite(distances) & (numpy.einsum("nc,nkc->nk", coarse, around) > 0)
    cosines = numpy.where(faces, numpy.einsum("nc,nkc->nk", seen, around), -1)[faces[:, 0]]
    angles = numpy.degrees(numpy.arccos(numpy.clip(cosines.max(axis=1), -1, 1)))
    for limit in (10, 25):
        print(f"more than {limit} degrees: {100 * (angles > limit).mean():.2f} % of {len(angles)} places")


if __name__ == "__main__":
    main()
