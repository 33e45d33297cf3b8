# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
from os import PathLike
from typing import Optional, Tuple, Union

import numpy
from numpy.typing import ArrayLike, NDArray

from . import depth as depth, maps as maps, pn as pn, qas as qas, stream as stream, surfel as surfel, vstree as vstree

Floats = NDArray[numpy.float32]
Indices = NDArray[numpy.uint32]
Bytes = NDArray[numpy.uint8]
__version__: str

class ArgumentError(ValueError): ...
class FileError(OSError): ...

class Geometry:
    positions: Floats
    normals: Optional[Floats]
    colours: Optional[Bytes]
    texcoords: Optional[Floats]
    triangles: Optional[Indices]
    origin: Tuple[float, float, float]

class Reconstructed:
    positions: Floats
    normals: Floats
    colours: Optional[Bytes]
    triangles: Indices
    base_vertices: int
    base_triangles: int
    levels: int
    node_side: float
    noise: float
    left_out: int
    area_left_out: float
    outliers: int

def read(file: Union[str, PathLike[str]], *, skip_invalid: bool = False, format: str = "") -> Geometry: ...
def write(file: Union[str, PathLike[str]], positions: ArrayLike, normals: Optional[ArrayLike] = None, colours: Optional[ArrayLike] = None,
          texcoords: Optional[ArrayLike] = None, triangles: Optional[ArrayLike] = None, *,
          origin: Tuple[float, float, float] = (0, 0, 0), text: bool = False) -> None: ...
def reconstruct(positions: ArrayLike, normals: Optional[ArrayLike] = None, colours: Optional[ArrayLike] = None, *,
                threshold: float = ..., error: float = ..., levels: int = ..., node_samples: float = ..., delta_a: float = ...,
                delta_d: float = ..., least_part: float = ..., gap_edges: int = ..., threads: int = 0) -> Reconstructed: ...
