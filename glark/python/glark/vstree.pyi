# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
from typing import Optional, Sequence

import numpy
from numpy.typing import ArrayLike, NDArray

from . import Bytes, Floats, Indices

class Tree:
    def __init__(self, positions: ArrayLike, normals: Optional[ArrayLike] = None, *, surface: bool = True, metric: str = "l2",
                 threshold: float = ..., delta_a: float = 0, delta_d: float = 0.25, least_samples: int = 1,
                 most_leaves: int = 0, threads: int = 0) -> None: ...
    nodes: NDArray[numpy.void]
    frames: NDArray[numpy.void]
    order: Indices
    leaf_count: int
    bytes: int
    diagonal: float
    def leaf_of(self, position: Sequence[float]) -> Optional[int]: ...

class Simplified:
    positions: Floats
    normals: Floats
    colours: Optional[Bytes]
    texcoords: Optional[Floats]
    triangles: Optional[Indices]
    representatives: Indices
    method: str
    error: float

def estimate_normals(positions: ArrayLike, normals: Optional[ArrayLike] = None, *, neighbours: int = 16,
                     scanner: Optional[Sequence[float]] = None, threads: int = 0) -> Floats: ...
def simplify(positions: ArrayLike, triangles: Optional[ArrayLike] = None, normals: Optional[ArrayLike] = None,
             colours: Optional[ArrayLike] = None, texcoords: Optional[ArrayLike] = None, *, target: int = 0,
             clustering: str = "vstree", representative: str = "qef", metric: str = "l2", threshold: float = ...,
             delta_a: float = 0, delta_d: float = 0.25, cut: bool = True, threads: int = 0, method: str = "cluster",
             max_error: float = 0) -> Simplified: ...
