# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
import numpy

OCTAHEDRON = numpy.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], numpy.float32)
TRIANGLES = numpy.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]], numpy.uint32)


def sphere(count: int) -> numpy.ndarray:
    """Points that lie evenly on the unit sphere: (count, 3). Each is its own normal."""
    i = numpy.arange(count)
    z = 1 - (2 * i + 1) / count
    radius, turn = numpy.sqrt(1 - z * z), 2.39996323 * i
    return numpy.stack([radius * numpy.cos(turn), radius * numpy.sin(turn), z], axis=1).astype(numpy.float32)
