# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
from os import PathLike
from typing import List, Literal, Optional, Sequence, Tuple, Union

import numpy
from numpy.typing import ArrayLike, NDArray

from . import Bytes, Floats, Indices

Path = Union[str, PathLike[str]]

class Jump:
    greatest: float
    root_mean_square: float

class SeamJumps:
    colour: Jump
    normal: Jump
    displacement: Jump
    edges: int

class FineMesh:
    def __init__(self, positions: ArrayLike, triangles: Optional[ArrayLike] = None, *, normals: Optional[ArrayLike] = None,
                 colours: Optional[ArrayLike] = None, origin: Sequence[float] = (0, 0, 0), spacing: float = ...) -> None: ...
    positions: Floats
    triangles: Indices
    spacing: float

class Baked:
    positions: Floats
    normals: Floats
    tangents: Floats
    texcoords: Floats
    triangles: Indices
    normal_map: Bytes
    colour_map: Optional[Bytes]
    displacement_map: NDArray[numpy.uint16]
    origin: List[float]
    width: int
    height: int
    scale: float
    bias: float
    points: int
    left_out: int
    invalid: int
    has_own_texcoords: bool
    texcoords_fault: str
    charts: int
    empty_charts: int
    hard_edges: int
    texels: int
    filled: int
    reach: float
    seams: SeamJumps
    mip_seams: list[SeamJumps]

def bake(positions: ArrayLike, triangles: ArrayLike, source: Union[Path, FineMesh], *, normals: Optional[ArrayLike] = None,
         origin: Sequence[float] = (0, 0, 0), format: str = "", texture_memory: int = ..., most_side: int = ...,
         noise: float = 0, texels_per_point: float = ..., reach: float = 0, skip_invalid: bool = False, threads: int = 0,
         texcoords: Optional[ArrayLike] = None, texture_coordinates: Literal["auto", "own", "charts"] = "auto",
         size: Tuple[int, int] = (0, 0), work: Path = "", resume: bool = False) -> Baked: ...
def write_model(file: Path, model: Baked) -> None: ...
def write_ply(file: Path, model: Baked, *, strips: bool = False) -> None: ...
