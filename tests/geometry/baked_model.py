# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Writes a small model with maps, of the form that `glark bake` writes: OUT.glb and OUT.displacement.png.

  baked_model.py OUT.glb [FREQUENCY]

It is a sphere of radius 1 about the origin with two charts, the half with z > 0 on the left side of the pictures and the
other half on the right side, which is turned and mirrored. The charts meet at the equator, where every vertex is there
twice. Heights and colours are functions of the direction from the centre.
"""
import functools
import json
import math
import pathlib
import struct
import sys
import zlib

SCALE, BIAS = 0.3, -0.1
MARGIN = 0.92  # the part of a picture's half that its chart takes
STEP = 1e-3    # for derivatives


def png(width: int, height: int, texels: bytes, depth: int = 8, colour: int = 2) -> bytes:
    """colour: 0 grey, 2 RGB. The upper row is the first one."""
    def chunk(name: bytes, body: bytes) -> bytes:
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))

    stride = len(texels) // height
    packed = zlib.compress(b"".join(b"\0" + texels[row * stride:(row + 1) * stride] for row in range(height)))
    header = struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")


def add(a: tuple, b: tuple, share: float = 1.0) -> tuple:
    return tuple(x + share * y for x, y in zip(a, b, strict=True))


def dot(a: tuple, b: tuple) -> float:
    return sum(x * y for x, y in zip(a, b, strict=True))


def cross(a: tuple, b: tuple) -> tuple:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def unit(a: tuple) -> tuple:
    length = math.sqrt(dot(a, a)) or 1.0
    return tuple(x / length for x in a)


def direction(chart: int, a: float, b: float) -> tuple:
    """The point of the sphere at the place a b of a chart, each from -1 to 1: right and up in the picture."""
    if chart == 1:
        a, b = b, a  # another layout on this side of the equator
    x, y = a * math.sqrt(1 - b * b / 2), b * math.sqrt(1 - a * a / 2)
    r = min(math.hypot(x, y), 1.0)
    if r == 0:
        return 0.0, 0.0, 1.0 - 2 * chart
    along = math.sin(r * math.pi / 2) / r
    high = math.cos(r * math.pi / 2) if r < 1 - 1e-9 else 0.0
    return x * along, y * along, high if chart == 0 else -high


def frame(chart: int, a: float, b: float) -> tuple:
    """Normal, tangent (right in the picture), and the sign of the bitangent (up in the picture)."""
    a0, b0 = (min(max(x, -1 + STEP), 1 - STEP) for x in (a, b))
    normal = unit(direction(chart, a, b))
    right = add(direction(chart, a0 + STEP, b0), direction(chart, a0 - STEP, b0), -1)
    up = add(direction(chart, a0, b0 + STEP), direction(chart, a0, b0 - STEP), -1)
    tangent = unit(add(right, normal, -dot(right, normal)))
    return normal, tangent, 1.0 if dot(cross(normal, tangent), up) > 0 else -1.0


def bumps(frequency: float):
    """A height from 0 to 1."""
    return lambda d: 0.5 + (math.sin(frequency * d[0]) + math.sin(frequency * d[1]) + math.sin(frequency * d[2])) / 6


def colour_of(d: tuple) -> tuple:
    return tuple(round(255 * (0.55 + 0.35 * x)) for x in d)


def detail_normal(d: tuple, height) -> tuple:
    """The normal of the displaced sphere in this direction."""
    def displaced(e: tuple) -> tuple:
        return add((0, 0, 0), e, 1 + SCALE * height(e) + BIAS)

    u = unit(cross(d, (0, 0, 1) if abs(d[2]) < 0.7 else (1, 0, 0)))
    v = cross(d, u)
    along = [add(displaced(unit(add(d, w, STEP))), displaced(unit(add(d, w, -STEP))), -1) for w in (u, v)]
    return unit(cross(*along))


@functools.lru_cache
def maps(size: int, height, normals=None, steps=(0.0, 0.0)) -> tuple:
    """The texels of the normal map, the colours and the heights, 2 size x size each. steps: added to each chart's heights."""
    normal_map, colours, heights = bytearray(), bytearray(), bytearray()
    for row in range(size):
        b = min(max((1 - 2 * (row + 0.5) / size) / MARGIN, -1), 1)
        for column in range(2 * size):
            chart = column // size
            a = min(max((2 * (column % size + 0.5) / size - 1) / MARGIN, -1), 1)
            normal, tangent, sign = frame(chart, a, b)
            d = unit(direction(chart, a, b))
            wanted = normals(d) if normals else detail_normal(d, height)
            bitangent = add((0, 0, 0), cross(normal, tangent), sign)
            parts = unit((dot(wanted, tangent), dot(wanted, bitangent), dot(wanted, normal)))
            normal_map += bytes(round(127.5 + 127.5 * part) for part in parts)
            colours += bytes(colour_of(d))
            heights += struct.pack(">H", round(65535 * min(max(height(d) + steps[chart], 0), 1)))
    return bytes(normal_map), bytes(colours), bytes(heights)


def mesh(cells: int, kept=lambda centre: True) -> tuple:
    """Attributes by their names, and indices. kept: a function of a quad's centre."""
    values, indices = {"POSITION": [], "NORMAL": [], "TANGENT": [], "TEXCOORD_0": []}, []
    for chart in (0, 1):
        first = len(values["POSITION"])
        for j in range(cells + 1):
            for i in range(cells + 1):
                a, b = 2 * i / cells - 1, 2 * j / cells - 1
                normal, tangent, sign = frame(chart, a, b)
                values["POSITION"].append(direction(chart, a, b))
                values["NORMAL"].append(normal)
                values["TANGENT"].append((*tangent, sign))
                values["TEXCOORD_0"].append((chart / 2 + (1 + a * MARGIN) / 4, (1 - b * MARGIN) / 2))
        for j in range(cells):
            for i in range(cells):
                p = first + j * (cells + 1) + i
                q = p + cells + 1
                # Diagonals from the middle outwards: no triangle has all its corners on the equator.
                if not kept(direction(chart, (2 * i + 1) / cells - 1, (2 * j + 1) / cells - 1)):
                    continue
                quad = [p, p + 1, q + 1, q] if (2 * i < cells) == (2 * j < cells) else [p + 1, q + 1, q, p]
                outwards = dot(cross(*(add(values["POSITION"][quad[k]], values["POSITION"][quad[0]], -1) for k in (1, 2))),
                               values["NORMAL"][p])
                quad = quad if outwards > 0 else [quad[0], quad[3], quad[2], quad[1]]
                indices += [quad[0], quad[1], quad[2], quad[0], quad[2], quad[3]]
    return values, indices


def gltf_of(values: dict, indices: list, pictures: dict) -> tuple:
    """The JSON part of the model and its bytes. pictures: name of the texture: PNG file."""
    views, accessors, body = [], [], b""

    def add_view(data: bytes) -> int:
        nonlocal body
        views.append({"buffer": 0, "byteOffset": len(body), "byteLength": len(data)})
        body += data + bytes(-len(data) % 4)
        return len(views) - 1

    for rows in values.values():
        accessors.append({"bufferView": add_view(b"".join(struct.pack(f"<{len(row)}f", *row) for row in rows)), "count": len(rows),
                          "componentType": 5126, "type": f"VEC{len(rows[0])}"})
    accessors[0]["min"], accessors[0]["max"] = ([f(axis) for axis in zip(*values["POSITION"], strict=True)] for f in (min, max))
    accessors.append({"bufferView": add_view(struct.pack(f"<{len(indices)}I", *indices)), "componentType": 5125,
                      "count": len(indices), "type": "SCALAR"})
    primitive = {"attributes": {name: i for i, name in enumerate(values)}, "indices": len(values), "material": 0, "mode": 4}
    material = {"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.8}}
    for i, name in enumerate(pictures):
        holder = material if name == "normalTexture" else material["pbrMetallicRoughness"]
        holder[name] = {"index": i}
    gltf = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [primitive]}], "materials": [material],
            "textures": [{"source": i} for i in range(len(pictures))],
            "images": [{"bufferView": add_view(data), "mimeType": "image/png"} for data in pictures.values()],
            "accessors": accessors, "bufferViews": views}
    gltf["buffers"] = [{"byteLength": len(body)}]
    return gltf, body


def glb(gltf: dict, body: bytes) -> bytes:
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(body)) + struct.pack("<I4s", len(text), b"JSON") + text +
            struct.pack("<I4s", len(body), b"BIN\0") + body)


def write_model(path: pathlib.Path, height, *, cells: int = 4, size: int = 64, change=None, change_mesh=None, pictures=None,
                normals=None, steps=(0.0, 0.0), kept=lambda centre: True) -> None:
    """change: alters the JSON part. change_mesh: alters the attributes. pictures: PNG files instead of the right ones, by the
    names of the textures, None for no texture. normals: a function of the direction for the normal map; without, those of the
    displaced surface. steps and kept: see maps() and mesh()."""
    normal_map, colours, heights = maps(size, height, normals, steps)
    textures = {"normalTexture": png(2 * size, size, normal_map), "baseColorTexture": png(2 * size, size, colours)}
    textures.update(pictures or {})
    values, indices = mesh(cells, kept)
    if change_mesh:
        change_mesh(values)
    gltf, body = gltf_of(values, indices, {name: picture for name, picture in textures.items() if picture is not None})
    uri = path.stem + ".displacement.png"
    gltf["materials"][0]["extras"] = {"displacement": {"uri": uri, "scale": SCALE, "bias": BIAS}}
    if change:
        change(gltf)
    path.write_bytes(glb(gltf, body))
    (path.parent / uri).write_bytes(png(2 * size, size, heights, 16, 0))


if __name__ == "__main__":
    write_model(pathlib.Path(sys.argv[1]), bumps(float(sys.argv[2]) if len(sys.argv) > 2 else 14.0), cells=10, size=128)
