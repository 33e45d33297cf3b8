# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""A coarse ball as a list of triangles: positions and normals, for the scenes of toolkits."""
import math


def point(i: int, j: int, rings: int, sectors: int) -> tuple:
    theta, phi = math.pi * i / rings, 2 * math.pi * j / sectors
    return math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)


def ball(rings: int = 6, sectors: int = 9) -> list:
    """Corners of triangles on the unit ball, three a triangle. A corner is its own normal."""
    corners = []
    for i in range(rings):
        for j in range(sectors):
            a, b, c, d = (point(i + k, j + l, rings, sectors) for k, l in ((0, 0), (0, 1), (1, 0), (1, 1)))
            corners += [a, c, d] if i == 0 else [a, c, b] if i == rings - 1 else [a, c, d, a, d, b]
    return corners
