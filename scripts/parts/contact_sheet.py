# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Contact sheets: one row a program, with its pictures side by side, for someone who looks at them."""
import pathlib

import numpy
from PIL import Image, ImageDraw

WIDTH, HEIGHT = 320, 240  # of one picture
TITLE = 14
ROWS_A_SHEET = 6
COLOURS = {"vanished": (255, 0, 0), "appeared": (0, 255, 0), "stripes": (255, 0, 255), "strays": (255, 255, 0)}


def marked(frame: numpy.ndarray, masks) -> Image.Image:
    """The picture, and below it the broken pixels in strong colours on a dark copy."""
    dark = frame // 4
    for name, colour in COLOURS.items():
        mask = getattr(masks, name)
        dark[mask] = colour
    return Image.fromarray(dark)


def cell(title: str, picture: Image.Image) -> Image.Image:
    picture.thumbnail((WIDTH, HEIGHT))
    result = Image.new("RGB", (WIDTH, HEIGHT + TITLE), "white")
    result.paste(picture, (0, TITLE))
    ImageDraw.Draw(result).text((2, 1), title, fill="black")
    return result


def write_row(path: pathlib.Path, name: str, pictures: list) -> None:
    """Takes (title, frame, masks or None) for each picture. Masks with pixels get a picture of their own."""
    cells = []
    for title, frame, masks in pictures:
        cells.append(cell(f"{name}: {title}" if not cells else title, Image.fromarray(frame.copy())))
        if masks is not None and sum(masks.counts()):
            cells.append(cell("vanished red, appeared green, stripes purple, strays yellow", marked(frame, masks)))
    row = Image.new("RGB", (WIDTH * len(cells), HEIGHT + TITLE), "white")
    for i, one in enumerate(cells):
        row.paste(one, (WIDTH * i, 0))
    row.save(path)


def join(rows: list, folder: pathlib.Path) -> None:
    """Writes folder/sheetN.png from the rows."""
    for old in folder.glob("sheet*.png"):
        old.unlink()
    for number, begin in enumerate(range(0, len(rows), ROWS_A_SHEET), 1):
        pictures = [Image.open(row) for row in rows[begin:begin + ROWS_A_SHEET]]
        sheet = Image.new("RGB", (max(p.width for p in pictures), sum(p.height for p in pictures)), "white")
        top = 0
        for picture in pictures:
            sheet.paste(picture, (0, top))
            top += picture.height
        sheet.save(folder / f"sheet{number}.png")
