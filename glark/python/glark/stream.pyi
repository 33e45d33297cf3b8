# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
from os import PathLike
from typing import Iterator, List, Optional, Sequence, Tuple, Union

import numpy
from numpy.typing import NDArray

from . import Floats

Path = Union[str, PathLike[str]]

class Part:
    first: int
    positions: NDArray[numpy.float64]
    normals: Optional[Floats]
    channels: Optional[NDArray[numpy.float64]]

class Reader:
    def __init__(self, file: Path, *, format: str = "", keep_invalid: bool = False) -> None: ...
    count: Optional[int]
    channel_names: List[str]
    def read(self, most: int = 65536) -> Optional[Part]: ...
    def __iter__(self) -> Iterator[Part]: ...
    def __next__(self) -> Part: ...

class SampleReport:
    points: int
    left_out: int
    samples: int
    in_core: bool
    is_shuffled: bool
    cells: NDArray[numpy.void]

class TransferReport:
    points: int
    is_deformed: bool
    channels: List[str]
    points_away: int
    cells_on_disk: int

class RefineReport:
    points_read: int
    points: int
    samples: int

def sample(large: Path, small: Path, *, target: int = 0, error: float = ..., memory: int = ..., threads: int = 0,
           skip_invalid: bool = False, work: Path = "", resume: bool = False) -> SampleReport: ...
def transfer(large: Path, small: Path, edited: Path, output: Path, *, neighbours: int = ..., singular: bool = False,
             threads: int = 0, work: Path = "", resume: bool = False, memory: int = ...) -> TransferReport: ...
def refine(large: Path, small: Path, output: Path, *, edited: Path = "", edited_output: Path = "",
           box: Optional[Tuple[Sequence[float], Sequence[float]]] = None,
           sphere: Optional[Tuple[Sequence[float], float]] = None, channel: str = "", target: int = 0, error: float = ...,
           memory: int = ..., neighbours: int = ..., threads: int = 0) -> RefineReport: ...
