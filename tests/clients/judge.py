# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Judges a run: takes pictures and statistics, returns complaints."""
import pathlib

VISIBLE_LEVELS = 2          # a channel that differs by more has changed
CHANGED_PIXELS = 0.5 / 100  # of all pixels: where edges of refined triangles round differently


def read_ppm(path: pathlib.Path) -> tuple:
    """Width, height and RGB bytes."""
    head, _, pixels = path.read_bytes().partition(b"\n255\n")
    magic, width, height = head.split()
    if magic != b"P6" or len(pixels) != 3 * int(width) * int(height):
        raise ValueError(f"{path} is no whole PPM")
    return int(width), int(height), pixels


def changed_pixels(first: tuple, second: tuple) -> int:
    """Counts the pixels with a channel that differs by more than VISIBLE_LEVELS."""
    a, b = first[2], second[2]
    return sum(1 for i in range(0, len(a), 3)
               if a[i:i + 3] != b[i:i + 3] and max(abs(a[i + k] - b[i + k]) for k in range(3)) > VISIBLE_LEVELS)


def picture_complaints(picture: tuple) -> list:
    """A program that drew nothing would pass every comparison."""
    pixels = picture[2]
    background = pixels[:3]
    drawn = sum(1 for i in range(0, len(pixels), 3) if pixels[i:i + 3] != background)
    return [] if drawn * 100 > len(pixels) // 3 else ["the picture without the library is empty: the test proves nothing"]


def identity_complaints(plain: tuple, passed: tuple) -> list:
    if plain[:2] != passed[:2]:
        return [f"the picture is {passed[0]}x{passed[1]} with the library, {plain[0]}x{plain[1]} without"]
    differing = sum(1 for i in range(0, len(plain[2]), 3) if plain[2][i:i + 3] != passed[2][i:i + 3])
    return [f"{differing} pixels differ with the library loaded but off"] if differing else []


def likeness_complaints(plain: tuple, refined: tuple) -> list:
    if plain[:2] != refined[:2]:
        return [f"the picture is {refined[0]}x{refined[1]} refined, {plain[0]}x{plain[1]} without"]
    changed = changed_pixels(plain, refined)
    limit = CHANGED_PIXELS * plain[0] * plain[1]
    return [f"{changed} pixels changed by refinement, over {limit:.0f}"] if changed > limit else []


def off_complaints(statistics: dict) -> list:
    count = statistics["refined_triangles"]
    return [f"{count} triangles were refined although refinement is off"] if count else []


def life_complaints(statistics: dict, level: int) -> list:
    """A library that sees no call passes every comparison, too."""
    coarse, refined = statistics["coarse_triangles"], statistics["refined_triangles"]
    if refined == 0:
        return [f"nothing was refined; draws: {statistics['draws']}"]
    if refined != coarse * 4**level:
        return [f"{refined} refined triangles of {coarse} coarse ones are not those of level {level}"]
    return []


def measured_complaints(statistics: dict) -> list:
    """Measured depths must give more triangles than the coarse ones."""
    coarse, refined = statistics["coarse_triangles"], statistics["refined_triangles"]
    if coarse == 0 or refined <= coarse:
        return [f"{refined} refined triangles of {coarse} coarse ones; draws: {statistics['draws']}"]
    return []
