# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Compares pictures of one object by one renderer: the peak signal-to-noise ratio over the object's pixels."""
import math
import typing

import numpy

PEAK = 255
OUTLINE = 3  # pixels
BACKGROUND = (41, 43, 48)  # of glark view


class Errors(typing.NamedTuple):
    """Squared differences of a picture from its reference, summed over pixels and channels."""
    outline: float  # of pixels within OUTLINE of the background in either picture
    inside: float  # of the other pixels of the object
    count_outline: int  # values, three for each pixel
    count_inside: int

    def __add__(self, other: "Errors") -> "Errors":
        return Errors(*(a + b for a, b in zip(self, other, strict=True)))


NO_ERRORS = Errors(0, 0, 0, 0)


def psnr(squares: float, count: int) -> float:
    """Decibels. Infinite for equal pictures."""
    if count == 0:
        raise ValueError("there are no pixels of the object")
    return math.inf if squares == 0 else 10 * math.log10(PEAK * PEAK * count / squares)


def psnr_of_object(errors: Errors) -> float:
    """Over the pixels that either picture covers."""
    return psnr(errors.outline + errors.inside, errors.count_outline + errors.count_inside)


def psnr_inside(errors: Errors) -> float:
    """Without the outlines of the object, which a coarse mesh cannot have."""
    return psnr(errors.inside, errors.count_inside)


def shown(picture: numpy.ndarray) -> numpy.ndarray:
    """[rows, columns, 3]: a picture with alpha, [rows, columns, 4], over the background."""
    alpha = picture[..., 3:].astype(numpy.float64) / PEAK
    over = picture[..., :3] * alpha + numpy.array(BACKGROUND) * (1 - alpha)
    return numpy.rint(over).astype(numpy.int64)


def with_alpha(picture: numpy.ndarray) -> numpy.ndarray:
    """A picture, [rows, columns, 3], whose background becomes transparent."""
    covered = (picture != numpy.array(BACKGROUND, numpy.uint8)).any(axis=2)
    return numpy.dstack([picture, numpy.where(covered, PEAK, 0).astype(numpy.uint8)])


def shrunk(covered: numpy.ndarray, times: int) -> numpy.ndarray:
    """Without the pixels that have one of four neighbours outside, as often as told."""
    for _ in range(times):
        around = numpy.pad(covered, 1)
        covered = covered & around[2:, 1:-1] & around[:-2, 1:-1] & around[1:-1, 2:] & around[1:-1, :-2]
    return covered


def errors_of(reference: numpy.ndarray, candidate: numpy.ndarray) -> Errors:
    """Both are [rows, columns, 4] of bytes. Pixels of the object are those that are not wholly transparent."""
    if reference.shape != candidate.shape:
        raise ValueError(f"the pictures have the shapes {reference.shape} and {candidate.shape}")
    difference = shown(reference) - shown(candidate)
    squares = (difference * difference).sum(axis=2)
    either = (reference[..., 3] > 0) | (candidate[..., 3] > 0)
    inside = shrunk((reference[..., 3] == PEAK) & (candidate[..., 3] == PEAK), OUTLINE)
    outline = either & ~inside
    return Errors(float(squares[outline].sum()), float(squares[inside].sum()), 3 * int(outline.sum()), 3 * int(inside.sum()))


def picture_of_errors(reference: numpy.ndarray, candidate: numpy.ndarray, gain: int = 4) -> numpy.ndarray:
    """Grey: white is a difference of 255 / gain of the channel that differs most."""
    difference = numpy.abs(shown(reference) - shown(candidate)).max(axis=2)
    return numpy.minimum(difference * gain, PEAK).astype(numpy.uint8)
