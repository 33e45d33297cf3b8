# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The camera and the light of `glark view`, for other viewers: glark/tool/view/draw/camera.cpp and draw_settings.h."""
import math
import typing

import numpy

HALF_OPENING = math.radians(20)
LIGHT_RIGHT, LIGHT_ABOVE = math.radians(16.7), math.radians(25.6)
COLOUR = (0.78, 0.76, 0.72)  # of models without colours, as shown
WIDTH, HEIGHT = 1024, 768


class Camera(typing.NamedTuple):
    position: tuple
    target: tuple
    distance: float
    radius: float

    @property
    def near(self) -> float:
        return max(self.distance - self.radius, (self.distance + self.radius) * 1e-3)

    @property
    def far(self) -> float:
        return self.distance + self.radius


def camera_of(points: numpy.ndarray, yaw: float, pitch: float, zoom: float = 1, target=None) -> Camera:
    """Circles around the middle of the points, or the target; degrees. The y axis points up."""
    low, high = points.min(axis=0).astype(float), points.max(axis=0).astype(float)
    middle = (low + high) / 2 if target is None else numpy.array(target, float)
    radius = float(numpy.linalg.norm(high - low)) / 2
    distance = radius / math.sin(HALF_OPENING) / zoom
    yaw, pitch = math.radians(yaw), math.radians(pitch)
    back = numpy.array([math.cos(pitch) * math.sin(yaw), math.sin(pitch), math.cos(pitch) * math.cos(yaw)])
    return Camera(tuple(middle + distance * back), tuple(middle), distance, radius)


def direction_to_light() -> tuple:
    """In the eye's space: x to the right, y up, z towards the viewer."""
    return (math.sin(LIGHT_RIGHT) * math.cos(LIGHT_ABOVE), math.sin(LIGHT_ABOVE),
            math.cos(LIGHT_RIGHT) * math.cos(LIGHT_ABOVE))
