# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Small scans in the formats that glark reads by ranges: their points, meshes and edits."""
import pathlib

import numpy


def bumpy_sphere(count: int, shuffled: bool = False) -> numpy.ndarray:
    """Points [count, 3] of a sphere with bumps, in rings from below."""
    height = (2 * numpy.arange(count, dtype=numpy.float64) + 1) / count - 1
    turn = 2.399963229728653 * numpy.arange(count)
    radius = numpy.sqrt(1 - height * height)
    points = numpy.stack([radius * numpy.cos(turn), radius * numpy.sin(turn), height], axis=1)
    points *= 1 + 0.01 * numpy.sin(20 * points).prod(axis=1, keepdims=True)
    if shuffled:
        numpy.random.default_rng(1).shuffle(points)
    return points


def colours_of(points: numpy.ndarray) -> numpy.ndarray:
    return (127.5 + 127 * numpy.sin(9 * points)).astype("u1")


def write_raw(path: pathlib.Path, points: numpy.ndarray) -> pathlib.Path:
    points.astype("<f4").tofile(path)
    return path


def write_ply(path: pathlib.Path, points: numpy.ndarray, normals: bool = True, faces: bool = False) -> pathlib.Path:
    """Points with colours, and triangles of points that follow each other."""
    row = [("position", "<f8", 3)] + [("normal", "<f4", 3)] * normals + [("colour", "u1", 3)]
    vertices = numpy.zeros(len(points), row)
    vertices["position"] = points + (4.5e6, 5e5, 100)
    if normals:
        vertices["normal"] = points
    vertices["colour"] = colours_of(points)
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}"]
    header += [f"property double {name}" for name in "xyz"] + [f"property float n{name}" for name in "xyz"] * normals
    header += [f"property uchar {name}" for name in ("red", "green", "blue")]
    triangles = numpy.zeros(len(points) - 2 if faces else 0, [("count", "u1"), ("corners", "<u4", 3)])
    if faces:
        triangles["count"] = 3
        triangles["corners"] = numpy.arange(len(triangles))[:, None] + numpy.arange(3)
        header += [f"element face {len(triangles)}", "property list uchar uint vertex_indices"]
    path.write_bytes("\n".join([*header, "end_header", ""]).encode() + vertices.tobytes() + triangles.tobytes())
    return path


def grid(side: int) -> tuple:
    """A bumpy square: its points [side * side, 3], and the corners [2 (side - 1)^2, 3] of its triangles."""
    row, column = numpy.divmod(numpy.arange(side * side), side)
    x, y = row / side, column / side
    points = numpy.stack([x, y, 0.05 * numpy.sin(20 * x) * numpy.cos(17 * y)], axis=1)
    begin = (row * side + column).reshape(side, side)[:-1, :-1].ravel()
    first = numpy.stack([begin, begin + side, begin + 1], axis=1)
    second = numpy.stack([begin + 1, begin + side, begin + side + 1], axis=1)
    return points, numpy.concatenate([first, second], axis=1).reshape(-1, 3)


def write_wide_mesh(path: pathlib.Path, side: int, polygon: int = 0) -> pathlib.Path:
    """A grid whose triangles have ten more numbers each, so that the file is large. polygon: more corners of the last face."""
    points, corners = grid(side)
    faces = numpy.zeros(len(corners), [("id", "<u4"), ("count", "u1"), ("corners", "<u4", 3), ("more", "<f8", 10)])
    faces["count"], faces["corners"] = 3, corners
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}"]
    header += [f"property float {name}" for name in "xyz"]
    header += [f"element face {len(faces) + (polygon > 0)}", "property uint id", "property list uchar uint vertex_indices"]
    header += [f"property double more{k}" for k in range(10)] + ["end_header", ""]
    last = bytes(4) + bytes([polygon]) + numpy.arange(polygon, dtype="<u4").tobytes() + bytes(80)
    path.write_bytes("\n".join(header).encode() + points.astype("<f4").tobytes() + faces.tobytes() + last * (polygon > 0))
    return path


def write_stl(path: pathlib.Path, side: int) -> pathlib.Path:
    points, corners = grid(side)
    triangles = numpy.zeros(len(corners), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
    triangles["normal"], triangles["corners"] = (0, 0, 1), points[corners]
    path.write_bytes(bytes(80) + numpy.uint32(len(triangles)).tobytes() + triangles.tobytes())
    return path


def write_las(path: pathlib.Path, points: numpy.ndarray, step: float = 1e-6) -> pathlib.Path:
    """LAS 1.2 with records of format 2: colours of 16 bits."""
    row = [("position", "<i4", 3), ("intensity", "<u2"), ("rest", "u1", 6), ("colour", "<u2", 3)]
    records = numpy.zeros(len(points), row)
    records["position"] = numpy.round(points / step)
    records["colour"] = 257 * colours_of(points).astype("<u2")
    header = numpy.zeros(1, [("start", "S4"), ("ids", "u1", 20), ("version", "u1", 2), ("names", "u1", 68),
                             ("size", "<u2"), ("begin", "<u4"), ("more", "<u4"), ("format", "u1"), ("record", "<u2"),
                             ("count", "<u4"), ("returns", "<u4", 5), ("steps", "<f8", 3), ("origin", "<f8", 3),
                             ("box", "<f8", (3, 2))])
    header["start"], header["version"], header["size"], header["begin"] = b"LASF", (1, 2), 227, 227
    header["format"], header["record"], header["count"] = 2, records.itemsize, len(points)
    header["steps"] = step
    header["box"][0] = numpy.stack([points.max(axis=0), points.min(axis=0)], axis=1)
    path.write_bytes(header.tobytes() + records.tobytes())
    return path


def sampling_of(path: pathlib.Path) -> tuple:
    """The header and the rows of a sampling that glark sample has written."""
    data = path.read_bytes()
    begin = data.index(b"end_header\n") + 11
    kind = "<f8" if b"property double x" in data[:begin] else "<f4"
    row = [("position", kind, 3), ("normal", "<f4", 3)]
    row += [("colour", "u1", 3)] * (b"property uchar red" in data[:begin])
    return data[:begin], numpy.frombuffer(data[begin:], row).copy()


def write_bent(small: pathlib.Path, edited: pathlib.Path, lift: float = 0.3) -> None:
    """Bends a sampling by its height, and paints a part of it if it has colours."""
    header, rows = sampling_of(small)
    height = rows["position"][:, 2] - rows["position"][:, 2].mean()
    rows["position"][:, 0] += lift * height * height
    if "colour" in rows.dtype.names:
        rows["colour"][height > 0.4] = (250, 10, 20)
    edited.write_bytes(header + rows.tobytes())
