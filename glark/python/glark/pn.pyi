# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
from typing import Optional

from numpy.typing import ArrayLike

from . import Floats, Indices

class TaggedMesh:
    positions: Floats
    normals: Floats
    discontinuities: Floats
    tags: Floats
    triangles: Indices
    sources: Indices
    triangle_sources: Indices
    crease_vertices: int
    corners: int

def derive_tags(positions: ArrayLike, triangles: ArrayLike, normals: Optional[ArrayLike] = None,
                creases: Optional[ArrayLike] = None, *, crease_degrees: float = ..., sharpness: float = ...,
                tension: float = ..., bias: float = ..., split: bool = ...) -> TaggedMesh: ...
