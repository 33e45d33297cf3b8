# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
from typing import Dict, Optional

import numpy
from numpy.typing import ArrayLike, NDArray

from . import Indices

class Frame:
    counts: NDArray[numpy.int32]
    offsets: NDArray[numpy.uint64]
    points: Indices
    level: int
    indices: int
    strips: int
    visited: int
    out_of_frustum: int
    back_faces: int

class Strips:
    def __init__(self, positions: ArrayLike, normals: Optional[ArrayLike] = None, *, leaf_points: int = ..., delta_a: float = ...,
                 delta_d: float = ..., inflation: float = ..., reach: float = ..., turn_edges: bool = ..., levels: int = 1,
                 threads: int = 0) -> None: ...
    point_count: int
    level_count: int
    indices: Indices
    def nodes(self, level: int = 0) -> NDArray[numpy.void]: ...
    def counts(self, level: int = 0) -> Dict[str, int]: ...
    def select(self, clip_from_object: ArrayLike, width: int, height: int, *, cull_frustum: bool = True,
               cull_back_faces: bool = True, point_pixels: float = 1, level_pixels: float = 1) -> Frame: ...
    def update(self, positions: ArrayLike, normals: Optional[ArrayLike], moved: ArrayLike) -> NDArray[numpy.uint64]: ...
