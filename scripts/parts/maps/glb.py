# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Reads and changes binary glTF files that glark wrote."""
import copy
import json
import pathlib
import struct

import numpy

MATERIAL = {"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.8}}  # that of glark bake
COMPONENTS = {5121: numpy.uint8, 5123: numpy.uint16, 5125: numpy.uint32, 5126: numpy.float32}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
JSON_CHUNK, BINARY_CHUNK = b"JSON", b"BIN\0"


class Glb:
    def __init__(self, gltf: dict, binary: bytes) -> None:
        self.gltf = gltf
        self.binary = binary

    @property
    def primitive(self) -> dict:
        return self.gltf["meshes"][0]["primitives"][0]

    @property
    def material(self) -> dict:
        return self.gltf["materials"][self.primitive["material"]]

    def _accessor(self, index: int) -> tuple:
        accessor = self.gltf["accessors"][index]
        view = self.gltf["bufferViews"][accessor["bufferView"]]
        shape = accessor["count"], WIDTHS[accessor["type"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        return start, numpy.dtype(COMPONENTS[accessor["componentType"]]), shape

    def array(self, attribute: str) -> numpy.ndarray:
        start, kind, shape = self._accessor(self.primitive["attributes"][attribute])
        return numpy.frombuffer(self.binary, kind, shape[0] * shape[1], start).reshape(shape)

    def triangles(self) -> numpy.ndarray:
        start, kind, shape = self._accessor(self.primitive["indices"])
        return numpy.frombuffer(self.binary, kind, shape[0], start).reshape(-1, 3)

    def with_array(self, attribute: str, values: numpy.ndarray) -> "Glb":
        """The same model with other values of an attribute."""
        start, kind, shape = self._accessor(self.primitive["attributes"][attribute])
        if values.shape != shape:
            raise ValueError(f"{attribute} has the shape {shape}, not {values.shape}")
        data = numpy.ascontiguousarray(values, kind).tobytes()
        return Glb(self.gltf, self.binary[:start] + data + self.binary[start + len(data):])

    def with_new_array(self, attribute: str, values: numpy.ndarray) -> "Glb":
        """The same model with one more attribute, or another one of this name."""
        gltf, binary = copy.deepcopy(self.gltf), self.binary + bytes(-len(self.binary) % 4)
        values = numpy.ascontiguousarray(values, numpy.float32)
        gltf["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": values.nbytes, "target": 34962})
        accessor = {"bufferView": len(gltf["bufferViews"]) - 1, "componentType": 5126, "count": len(values),
                    "type": f"VEC{values.shape[1]}"}
        if attribute == "POSITION":
            accessor |= {"min": values.min(axis=0).tolist(), "max": values.max(axis=0).tolist()}
        gltf["accessors"].append(accessor)
        gltf["meshes"][0]["primitives"][0]["attributes"][attribute] = len(gltf["accessors"]) - 1
        gltf["buffers"][0]["byteLength"] = len(binary) + values.nbytes
        return Glb(gltf, binary + values.tobytes())

    def with_triangles(self, triangles: numpy.ndarray) -> "Glb":
        gltf, binary = copy.deepcopy(self.gltf), self.binary + bytes(-len(self.binary) % 4)
        indices = numpy.ascontiguousarray(triangles, numpy.uint32)
        gltf["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": indices.nbytes, "target": 34963})
        gltf["accessors"].append({"bufferView": len(gltf["bufferViews"]) - 1, "componentType": 5125, "count": indices.size,
                                  "type": "SCALAR"})
        gltf["meshes"][0]["primitives"][0]["indices"] = len(gltf["accessors"]) - 1
        gltf["buffers"][0]["byteLength"] = len(binary) + indices.nbytes
        return Glb(gltf, binary + indices.tobytes())

    def with_own_material(self) -> "Glb":
        """The same mesh with the material of glark bake, for meshes that have none or one per vertex colour."""
        gltf = copy.deepcopy(self.gltf)
        gltf["materials"] = [MATERIAL]
        gltf["meshes"][0]["primitives"][0]["material"] = 0
        return Glb(gltf, self.binary)

    def without_maps(self) -> "Glb":
        gltf = copy.deepcopy(self.gltf)
        coarse = Glb(gltf, self.binary)
        coarse.material.pop("normalTexture", None)
        coarse.material.get("pbrMetallicRoughness", {}).pop("baseColorTexture", None)
        return coarse

    def image(self, texture: dict) -> bytes:
        """The PNG of a texture, as {"index": 0}."""
        image = self.gltf["images"][self.gltf["textures"][texture["index"]]["source"]]
        view = self.gltf["bufferViews"][image["bufferView"]]
        start = view.get("byteOffset", 0)
        return self.binary[start:start + view["byteLength"]]

    def write(self, path: pathlib.Path) -> None:
        text = json.dumps(self.gltf, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        binary = self.binary + bytes(-len(self.binary) % 4)
        chunks = b"".join(struct.pack("<I", len(body)) + name + body
                          for name, body in ((JSON_CHUNK, text), (BINARY_CHUNK, binary)))
        path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)


def read(path: pathlib.Path) -> Glb:
    data = path.read_bytes()
    if data[:4] != b"glTF":
        raise ValueError(f"{path} is no binary glTF file")
    chunks, at = {}, 12
    while at < len(data):
        length, name = struct.unpack("<I4s", data[at:at + 8])
        chunks[name] = data[at + 8:at + 8 + length]
        at += 8 + length
    return Glb(json.loads(chunks[JSON_CHUNK]), chunks.get(BINARY_CHUNK, b""))
