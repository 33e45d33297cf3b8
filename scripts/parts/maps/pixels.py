# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Compares pictures of one object by one renderer: the peak signal-to-noise ratio over the object's pixels."""
import math
import typing

import numpy

PEAK = 255
BACKGROUND = (41, 43, 48)  # of glark view


class Errors(typing.NamedTuple):
    """Squared differences of a picture from its reference, summed over pixels and channels."""
    outside: float  # of pixels that one picture covers and the other does not: the silhouettes differ
    inside: float  # of pixels that both cover
    count_outside: int  # values, three for each pixel
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
    return psnr(errors.outside + errors.inside, errors.count_outside + errors.count_inside)


def psnr_inside(errors: Errors) -> float:
    """Over the pixels that both pictures cover: without the silhouette."""
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


def errors_of(reference: numpy.ndarray, candidate: numpy.ndarray) -> Errors:
    """Both are [rows, columns, 4] of bytes. Pixels of the object are those that are not wholly transparent."""
    if reference.shape != candidate.shape:
        raise ValueError(f"the pictures have the shapes {reference.shape} and {candidate.shape}")
    difference = shown(reference) - shown(candidate)
    squares = (difference * difference).sum(axis=2)
    covered = [picture[..., 3] > 0 for picture in (reference, candidate)]
    both, one = covered[0] & covered[1], covered[0] ^ covered[1]
    return Errors(float(squares[one].sum()), float(squares[both].sum()), 3 * int(one.sum()), 3 * int(both.sum()))


def picture_of_errors(reference: numpy.ndarray, candidate: numpy.ndarray, gain: int = 4) -> numpy.ndarray:
    """Grey: white is a difference of 255 / gain of the channel that differs most."""
    difference = numpy.abs(shown(reference) - shown(candidate)).max(axis=2)
    return numpy.minimum(difference * gain, PEAK).astype(numpy.uint8)
