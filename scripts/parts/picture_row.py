# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Joins PNG pictures side by side, with Python's standard library only: the demo installs no imaging package."""
import pathlib
import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def paeth(left: int, above: int, corner: int) -> int:
    guess = left + above - corner
    distances = abs(guess - left), abs(guess - above), abs(guess - corner)
    if distances[0] <= distances[1] and distances[0] <= distances[2]:
        return left
    return above if distances[1] <= distances[2] else corner


def unfilter(kind: int, row: bytearray, above: bytes, size: int) -> None:
    """Reverses the filter of one row of a PNG (PNG specification, section 9); `size` is the number of bytes of a pixel."""
    for i in range(len(row) if kind else 0):
        left = row[i - size] if i >= size else 0
        if kind == 1:
            row[i] = row[i] + left & 255
        elif kind == 2:
            row[i] = row[i] + above[i] & 255
        elif kind == 3:
            row[i] = row[i] + (left + above[i]) // 2 & 255
        else:
            row[i] = row[i] + paeth(left, above[i], above[i - size] if i >= size else 0) & 255


def read_png(path: pathlib.Path) -> tuple:
    """Width and rows of RGB bytes. Alpha is dropped."""
    data = path.read_bytes()
    width, _, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", data[16:29])
    if not data.startswith(SIGNATURE) or depth != 8 or colour not in (2, 6) or interlaced:
        raise ValueError(f"{path} is no PNG of 8-bit RGB or RGBA")
    packed, at = b"", len(SIGNATURE)
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        packed += data[at + 8:at + 8 + length] if name == b"IDAT" else b""
        at += length + 12
    size = 3 if colour == 2 else 4
    raw, stride, rows = zlib.decompress(packed), 1 + size * width, []
    above = bytes(size * width)
    for start in range(0, len(raw), stride):
        row = bytearray(raw[start + 1:start + stride])
        unfilter(raw[start], row, above, size)
        above = bytes(row)
        rows.append(above if size == 3 else bytes(byte for i, byte in enumerate(above) if i % 4 != 3))
    return width, rows


def write_png(path: pathlib.Path, width: int, rows: list) -> None:
    def chunk(name: bytes, body: bytes) -> bytes:
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))

    header = struct.pack(">IIBBBBB", width, len(rows), 8, 2, 0, 0, 0)
    packed = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    path.write_bytes(SIGNATURE + chunk(b"IHDR", header) + chunk(b"IDAT", packed) + chunk(b"IEND", b""))


def join(paths: list, target: pathlib.Path) -> None:
    """Writes the pictures side by side; they have the same height."""
    pictures = [read_png(path) for path in paths]
    rows = [b"".join(parts) for parts in zip(*(rows for _, rows in pictures), strict=True)]
    write_png(target, sum(width for width, _ in pictures), rows)
