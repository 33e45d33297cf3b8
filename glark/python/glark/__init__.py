# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""glark for Python: scans and meshes as NumPy arrays, and the OpenGL extension in glark.gl.

    import glark

    scan = glark.read("scan.ply")
    mesh = glark.reconstruct(scan.positions, scan.normals)
    small = glark.vstree.simplify(mesh.positions, mesh.triangles, target=10000)
    glark.write("small.glb", small.positions, small.normals, triangles=small.triangles)

Arrays have one row for each point or triangle. float32, uint32 and uint8 arrays in rows (C order) are read where they lie;
others are converted. Results are not copied: they keep their owner alive, and cannot be written.
"""
import sys

from . import _glark
from ._glark import ArgumentError, FileError, Geometry, Reconstructed, __version__, read, reconstruct, write
from ._glark import depth, maps, pn, qas, stream, surfel, vstree

for _module in (depth, maps, pn, qas, stream, surfel, vstree):
    _module.__name__ = f"glark.{_module.__name__.rpartition('.')[2]}"
    sys.modules[_module.__name__] = _module  # so that `import glark.vstree` works

__all__ = ["ArgumentError", "FileError", "Geometry", "Reconstructed", "read", "reconstruct", "write", "depth", "maps",
           "pn", "qas", "stream", "surfel", "vstree"]
