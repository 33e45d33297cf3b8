# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The pictures of docs/images/maps: each row shows one data set, from afar or close, by glark view."""
import pathlib
import subprocess
import tempfile
import typing

import baking
import numpy
from PIL import Image

SIDE = 420  # pixels of a tile
QUALITY = 85
LINE_PIXELS = 9  # length of the segments of the refined triangles that are drawn as lines
TILES = {
    "coarse mesh": ["--maps", "plain"],
    "normal map": ["--maps", "normal"],
    "displaced": ["--maps", "displaced", "--edge-pixels", "3"],
    "its triangles": ["--maps", "displaced", "--edge-pixels", str(LINE_PIXELS), "--lines"],
}


class Row(typing.NamedTuple):
    data_set: str
    yaw: float
    pitch: float
    far: float  # zooms
    close: float


ROWS = [
    Row("igea", 30, 10, 1.4, 3),
    Row("happy_stand_scans", 0, 10, 1.2, 5),
    Row("armadillo", 160, 10, 1.3, 4),
    Row("lion_takanawa", 20, 15, 1.6, 5),
]


def tile(models: baking.Models, row: Row, zoom: float, file: pathlib.Path, words: list) -> Image.Image:
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "tile.png"
        subprocess.run([str(models.glark), "view", str(file), *words, "--offscreen", str(out), "--up", models.data_set.up,
                        "--yaw", str(row.yaw), "--pitch", str(row.pitch), "--zoom", str(zoom), "--width", str(2 * SIDE),
                        "--height", str(2 * SIDE)], check=True, capture_output=True)
        return Image.open(out).convert("RGB").resize((SIDE, SIDE), Image.Resampling.BOX)


def write_rows(models: baking.Models, images: pathlib.Path) -> list:
    """Returns the files: NAME_far.jpg and NAME_close.jpg."""
    row = next(one for one in ROWS if one.data_set == models.data_set.name)
    images.mkdir(parents=True, exist_ok=True)
    files = []
    for distance, zoom in (("far", row.far), ("close", row.close)):
        tiles = [tile(models, row, zoom, models.file("model"), words) for words in TILES.values()]
        tiles.append(tile(models, row, zoom, models.input, []))
        files.append(images / f"{row.data_set}_{distance}.jpg")
        Image.fromarray(numpy.hstack([numpy.asarray(one) for one in tiles])).save(files[-1], quality=QUALITY)
    return files
