# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Contact sheets: one row a program, with its pictures side by side, for someone who looks at them."""
import pathlib

import numpy
from PIL import Image, ImageDraw

WIDTH, HEIGHT = 320, 240  # of one picture
TITLE = 14
VISIBLE = 8  # levels of 255
ROWS_A_SHEET = 6
COLOURS = {"vanished": (255, 0, 0), "appeared": (0, 255, 0), "stripes": (255, 0, 255), "strays": (255, 255, 0), "thin": (0, 255, 255)}


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


def most_changed(plain: numpy.ndarray, refined: numpy.ndarray) -> tuple:
    """The part of half a cell's size that changed most, as (left, top, right, bottom); none if nothing changed visibly."""
    change = numpy.abs(plain.astype(numpy.int16) - refined).max(axis=2)
    height, width = (min(part, size) for part, size in zip((HEIGHT // 2, WIDTH // 2), change.shape))
    total = numpy.pad((change > VISIBLE) * change.astype(numpy.int64), ((1, 0), (1, 0))).cumsum(0).cumsum(1)
    parts = total[height:, width:] - total[:-height, width:] - total[height:, :-width] + total[:-height, :-width]
    top, left = numpy.unravel_index(parts.argmax(), parts.shape)
    return (int(left), int(top), int(left) + width, int(top) + height) if parts.max() else ()


def closer(plain: numpy.ndarray, refined: numpy.ndarray) -> list:
    """Cells with the part that changed most, plain and refined, at twice the size."""
    part = most_changed(plain, refined)
    if not part:
        return []
    pictures = [Image.fromarray(frame.copy()).crop(part) for frame in (plain, refined)]
    return [cell(title, picture.resize((2 * picture.width, 2 * picture.height), Image.NEAREST))
            for title, picture in zip(("most changed: plain", "most changed: refined"), pictures)]


def write_row(path: pathlib.Path, name: str, pictures: list, compared=None) -> None:
    """Takes (title, frame, masks or None) for each picture. Masks with pixels get a picture of their own.

    `compared` is the plain frame of the last picture, if there is one: two more cells show closely where that one changed
    most.
    """
    cells = []
    for title, frame, masks in pictures:
        cells.append(cell(f"{name}: {title}" if not cells else title, Image.fromarray(frame.copy())))
        if masks is not None and sum(masks.counts()):
            cells.append(cell("vanished red, appeared green, stripes purple, strays yellow, thin cyan", marked(frame, masks)))
    if compared is not None:
        cells += closer(compared, pictures[-1][1])
    row = Image.new("RGB", (WIDTH * len(cells), HEIGHT + TITLE), "white")
    for i, one in enumerate(cells):
        row.paste(one, (WIDTH * i, 0))
    row.save(path)


def join(rows: list, folder: pathlib.Path, name: str = "sheet") -> None:
    """Writes folder/NAMEn.png from the rows."""
    for old in folder.glob(f"{name}[0-9]*.png"):
        old.unlink()
    for number, begin in enumerate(range(0, len(rows), ROWS_A_SHEET), 1):
        pictures = [Image.open(row) for row in rows[begin:begin + ROWS_A_SHEET]]
        sheet = Image.new("RGB", (max(p.width for p in pictures), sum(p.height for p in pictures)), "white")
        top = 0
        for picture in pictures:
            sheet.paste(picture, (0, top))
            top += picture.height
        sheet.save(folder / f"{name}{number}.png")
