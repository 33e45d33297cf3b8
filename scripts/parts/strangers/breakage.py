# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Five numbers that say where a refined picture is broken, without a person who looks at it.

They compare a refined picture with the plain one. docs/reference/strangers.md defines them in words. All are counts of pixels,
and 0 for a healthy program.
"""
import dataclasses

import numpy


@dataclasses.dataclass(frozen=True)
class Allowance:
    """What a refinement may change."""
    reach: int      # pixels that an outline may move
    tolerance: int  # levels of 255 by which a colour may differ from the one that explains it
    light: bool     # whether light may change


CONTOUR = 0.35     # share of a region's contour that must be sharp: colours differ by at least tolerance / 2 levels
ISLAND = 0.55      # share of a region's contour that must be sharp if its colour occurs nearby: nothing old adjoins it
SMALLEST = 24      # pixels of the smallest region that counts as vanished or appeared, and of the fewest stripes
FEWEST = 4         # strays; fewer may be the rounding of an edge
STRAY = 64         # levels by which a stray colour differs from the median around it
WINDOW = 11        # size of the window in which changes along a line are counted
THIN = 7           # size of the window that a thin part does not fill
FAINT = 40         # levels by which a thin part differs from what is around it, at least
CROSSINGS = 4      # changes along each line of that window, beyond which two passes fight


def exact(width: int = 0, height: int = 0) -> Allowance:  # whatever the size
    """Outputs: only the rounding of an edge may differ."""
    return Allowance(reach=1, tolerance=16, light=False)


def curved(width: int, height: int) -> Allowance:
    """Curved triangles: outlines bulge, and shading is evaluated at more points."""
    return Allowance(reach=max(4, round(0.03 * max(width, height))), tolerance=32, light=True)


def difference(first: numpy.ndarray, second: numpy.ndarray) -> numpy.ndarray:
    """The greatest difference of a channel, in levels, for each pixel."""
    return numpy.abs(first.astype(numpy.int16) - second).max(axis=-1)


def offsets(reach: int) -> list:
    """The neighbours in a disc, nearest first. Beyond 4 pixels only every second one: colours of regions do not need all."""
    around = range(-reach, reach + 1)
    found = [(y, x) for y in around for x in around if y * y + x * x <= reach * reach + 1]
    return sorted((o for o in found if max(map(abs, o)) <= 4 or (o[0] + o[1]) % 2 == 0), key=lambda o: o[0] ** 2 + o[1] ** 2)


def unexplained(picture: numpy.ndarray, other: numpy.ndarray, allowance: Allowance) -> numpy.ndarray:
    """Marks the pixels of a picture whose colour occurs nowhere near in the other picture."""
    height, width = picture.shape[:2]
    reach = allowance.reach
    padded = numpy.pad(other, ((reach, reach), (reach, reach), (0, 0)), mode="edge")
    rows, columns = numpy.nonzero(difference(picture, other) > allowance.tolerance)
    for y, x in offsets(reach):
        near = padded[rows + reach + y, columns + reach + x]
        left = difference(picture[rows, columns], near) > allowance.tolerance
        rows, columns = rows[left], columns[left]
        if not len(rows):
            break
    mask = numpy.zeros((height, width), bool)
    mask[rows, columns] = True
    return mask


def grown(mask: numpy.ndarray, by: int) -> numpy.ndarray:
    """The mask and every pixel that is at most so far from it, along each axis."""
    for axis in (0, 1):
        total = mask.copy()
        for distance in range(1, by + 1):
            ahead, behind = [slice(None)] * 2, [slice(None)] * 2
            ahead[axis], behind[axis] = slice(distance, None), slice(None, -distance)
            total[tuple(ahead)] |= mask[tuple(behind)]
            total[tuple(behind)] |= mask[tuple(ahead)]
        mask = total
    return mask


def steps(picture: numpy.ndarray) -> numpy.ndarray:
    """The greatest difference of each pixel to a pixel two away, along rows and columns."""
    result = numpy.zeros(picture.shape[:2], numpy.int16)
    for axis in (0, 1):
        first, second = [slice(None)] * 2, [slice(None)] * 2
        first[axis], second[axis] = slice(2, None), slice(None, -2)
        step = difference(picture[tuple(first)], picture[tuple(second)])
        middle = [slice(None)] * 2
        middle[axis] = slice(1, -1)
        result[tuple(middle)] = numpy.maximum(result[tuple(middle)], step)
    return result


def regions(mask: numpy.ndarray) -> numpy.ndarray:
    """Numbers the connected regions of a mask (8 neighbours), from 1; 0 is outside."""
    labels = numpy.zeros(mask.shape, numpy.int32)
    parents = [0]

    def root(i: int) -> int:
        while parents[i] != i:
            parents[i] = parents[parents[i]]
            i = parents[i]
        return i

    above = []
    for y in range(mask.shape[0]):
        ends = numpy.flatnonzero(numpy.diff(numpy.concatenate(([0], mask[y].view(numpy.int8), [0]))))
        runs = []
        for begin, end in zip(ends[0::2].tolist(), ends[1::2].tolist()):
            touching = {root(label) for b, e, label in above if b <= end and e >= begin}
            label = min(touching, default=len(parents))
            if not touching:
                parents.append(label)
            for other in touching:
                parents[other] = label
            labels[y, begin:end] = label
            runs.append((begin, end, label))
        above = runs
    return numpy.array([root(i) for i in range(len(parents))], numpy.int32)[labels]


def lone_steps(picture: numpy.ndarray, other: numpy.ndarray, allowance: Allowance, least: int = 0) -> numpy.ndarray:
    """Marks the pixels beside a step that the other picture lacks. A texture under another light has its steps in both.

    If light may not change, every pixel counts as such. A step has at least half the tolerance, or `least` levels.
    """
    if not allowance.light:
        return numpy.ones(picture.shape[:2], bool)
    return grown(steps(picture) >= (least or allowance.tolerance // 2), 1) & ~grown(steps(other) >= allowance.tolerance // 4, 1)


def sharp_area(mask: numpy.ndarray, lone: numpy.ndarray, share: float = CONTOUR) -> numpy.ndarray:
    """Marks the regions of a mask that are large and have a sharp contour in one picture only: objects, not shading."""
    closed = grown(mask, 1)  # so that a grid of holes is one region
    labels = regions(closed)
    inside = ~grown(~closed, 1)
    contour = closed & ~inside
    count = int(labels.max()) + 1
    sizes = numpy.bincount(labels[mask], minlength=count)
    around = numpy.bincount(labels[contour], minlength=count)
    cut = numpy.bincount(labels[contour & lone], minlength=count)
    broken = (sizes >= SMALLEST) & (cut > share * around)
    broken[0] = False
    return mask & broken[labels]


def islands(picture: numpy.ndarray, other: numpy.ndarray, allowance: Allowance) -> numpy.ndarray:
    """Marks what lies in the midst of something else with a contour of strong steps, which the other picture lacks."""
    near = dataclasses.replace(allowance, reach=min(2, allowance.reach))
    return sharp_area(unexplained(picture, other, near), lone_steps(picture, other, allowance, STRAY), ISLAND)


def poking(plain: numpy.ndarray, refined: numpy.ndarray, allowance: Allowance) -> numpy.ndarray:
    """Marks what came in a colour that occurs nearby: a surface behind pokes through.

    A part of a texture that moved leaves such an island in the plain picture, and does not count.
    """
    return islands(refined, plain, allowance) & ~grown(islands(plain, refined, allowance), allowance.reach)


def window_sum(values: numpy.ndarray, size: int) -> numpy.ndarray:
    """The sum over a square window around each pixel."""
    half = size // 2
    total = numpy.pad(values.astype(numpy.int32), ((half + 1, half), (half + 1, half))).cumsum(0).cumsum(1)
    return total[size:, size:] - total[:-size, size:] - total[size:, :-size] + total[:-size, :-size]


def fighting(mask: numpy.ndarray) -> numpy.ndarray:
    """Marks the pixels around which the mask changes often along rows, or along columns: stripes, checks, noise."""
    result = numpy.zeros(mask.shape, bool)
    for axis in (0, 1):
        changes = numpy.zeros(mask.shape, bool)
        behind, ahead = [slice(None)] * 2, [slice(None)] * 2
        behind[axis], ahead[axis] = slice(None, -1), slice(1, None)
        changes[tuple(ahead)] = mask[tuple(ahead)] != mask[tuple(behind)]
        result |= window_sum(changes, WINDOW) >= CROSSINGS * WINDOW
    return mask & result


def outliers(picture: numpy.ndarray, where: numpy.ndarray) -> numpy.ndarray:
    """Marks the pixels of a mask whose colour is far from the median of the 5 by 5 pixels around them."""
    rows, columns = numpy.nonzero(where)
    padded = numpy.pad(picture, ((2, 2), (2, 2), (0, 0)), mode="edge")
    around = [padded[rows + y, columns + x] for y in range(5) for x in range(5)]
    far = difference(picture[rows, columns], numpy.median(around, axis=0)) > STRAY
    mask = numpy.zeros(where.shape, bool)
    mask[rows[far], columns[far]] = True
    return mask


def extreme(values: numpy.ndarray, choose, size: int) -> numpy.ndarray:
    """The least or the greatest value in a square window around each pixel."""
    half = size // 2
    for axis in (0, 1):
        borders = [(0, 0)] * values.ndim
        borders[axis] = (half, half)
        padded = numpy.pad(values, borders, mode="edge")
        views = numpy.lib.stride_tricks.sliding_window_view(padded, size, axis=axis)
        values = choose(views, axis=-1)
    return values


def thin_parts(picture: numpy.ndarray, size: int, least: int) -> numpy.ndarray:
    """Marks wires, small balls and gaps: what an opening or a closing of the picture removes (the top-hat transforms)."""
    values = picture.astype(numpy.int16)
    opened = extreme(extreme(values, numpy.min, size), numpy.max, size)
    closed = extreme(extreme(values, numpy.max, size), numpy.min, size)
    return numpy.maximum(values - opened, closed - values).max(axis=-1) > least


def lost_thin_parts(plain: numpy.ndarray, refined: numpy.ndarray, allowance: Allowance) -> numpy.ndarray:
    """Marks thin parts around which the refined picture has less than half as many pixels of thin parts.

    There, parts count that are thicker and fainter, too: some have moved by a part of a pixel.
    """
    size = 2 * max(allowance.reach, THIN) + 1
    parts = thin_parts(plain, THIN, FAINT)
    before, after = window_sum(parts, size), window_sum(thin_parts(refined, THIN + 4, FAINT // 2), size)
    lost = parts & (before >= SMALLEST) & (2 * after < before)
    return lost & (lost.sum() >= SMALLEST)


@dataclasses.dataclass
class Breakage:
    """Masks of the pixels that each number counts."""
    vanished: numpy.ndarray
    appeared: numpy.ndarray
    stripes: numpy.ndarray
    strays: numpy.ndarray
    thin: numpy.ndarray

    def counts(self) -> tuple:
        return tuple(int(getattr(self, field.name).sum()) for field in dataclasses.fields(self))


def breakage(plain: numpy.ndarray, refined: numpy.ndarray, allowance: Allowance) -> Breakage:
    """Compares two pictures of shape (height, width, 3)."""
    lost = unexplained(plain, refined, allowance)
    new = unexplained(refined, plain, allowance)
    is_explained = not lost.any() and not new.any()
    if is_explained and not allowance.light:
        return Breakage(lost, lost, lost, lost, lost)
    lone_plain, lone_refined = lone_steps(plain, refined, allowance), lone_steps(refined, plain, allowance)
    near = dataclasses.replace(allowance, reach=min(2, allowance.reach))
    stripes = fighting(unexplained(refined, plain, near) | unexplained(plain, refined, near)) & lone_refined
    stripes &= stripes.sum() >= SMALLEST and not is_explained
    strays = outliers(refined, new & ~stripes)
    around = max(allowance.reach, 3)
    strays &= ~grown(outliers(plain, grown(strays, around)), around)  # the plain picture sparkles, too
    strays &= strays.sum() >= FEWEST
    vanished, appeared = sharp_area(lost, lone_plain), sharp_area(new, lone_refined)
    if allowance.light:
        appeared |= poking(plain, refined, allowance)
    return Breakage(vanished, appeared, stripes, strays, lost_thin_parts(plain, refined, allowance))
