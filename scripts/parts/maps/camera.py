# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The camera and the light of `glark view`, for other viewers: glark/tool/view/draw/camera.cpp and draw_settings.h."""
import math
import typing

import numpy

OPENING_DEGREES = 40
HALF_OPENING = math.radians(OPENING_DEGREES / 2)
LIGHT_RIGHT, LIGHT_ABOVE = math.radians(16.7), math.radians(25.6)
WIDTH, HEIGHT = 1024, 768
YAWS, PITCH = range(30, 390, 45), 20  # of the eight views, in degrees


class Camera(typing.NamedTuple):
    position: tuple
    target: tuple
    up: tuple
    distance: float
    radius: float

    @property
    def near(self) -> float:
        return max(self.distance - self.radius, (self.distance + self.radius) * 1e-3)

    @property
    def far(self) -> float:
        return self.distance + self.radius


def camera_of(points: numpy.ndarray, yaw: float, pitch: float, up: str = "y") -> Camera:
    """Circles around the middle of the points; degrees. The upright axis is y or z."""
    low, high = points.min(axis=0).astype(float), points.max(axis=0).astype(float)
    middle = (low + high) / 2
    radius = float(numpy.linalg.norm(high - low)) / 2
    distance = radius / math.sin(HALF_OPENING)
    yaw, pitch = math.radians(yaw), math.radians(pitch)
    back = numpy.array([math.cos(pitch) * math.sin(yaw), math.sin(pitch), math.cos(pitch) * math.cos(yaw)])
    if up == "z":
        back = numpy.array([back[0], -back[2], back[1]])
    return Camera(tuple(middle + distance * back), tuple(middle), (0, 0, 1) if up == "z" else (0, 1, 0), distance, radius)


def direction_to_light() -> tuple:
    """In the eye's space: x to the right, y up, z towards the viewer."""
    return (math.sin(LIGHT_RIGHT) * math.cos(LIGHT_ABOVE), math.sin(LIGHT_ABOVE),
            math.cos(LIGHT_RIGHT) * math.cos(LIGHT_ABOVE))
