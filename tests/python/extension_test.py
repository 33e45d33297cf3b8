# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""glark.gl in a program of PyOpenGL, started by `python3 -m glark.gl` and without it."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = """
import ctypes
import numpy
from OpenGL import GL, osmesa
from glark import gl as ark

pixels = numpy.zeros((64, 64, 4), numpy.uint8)
context = osmesa.OSMesaCreateContextExt(osmesa.OSMESA_RGBA, 24, 0, 0, None)
assert osmesa.OSMesaMakeCurrent(context, pixels, GL.GL_UNSIGNED_BYTE, 64, 64)
ark.glARKinit(4)
GL.glEnable(ark.GL_ARK)
ark.glARKParameteriARK(ark.GL_REFINEMENT_ARK, ark.GL_CURVED_PN_ARK)
tags = numpy.full(3, 3, numpy.uint32)
corners = numpy.array([[-1, -1, 0], [1, -1, 0], [0, 1, 0]], numpy.float32)
GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
GL.glVertexPointer(3, GL.GL_FLOAT, 0, corners)
ark.glDepthTagPointerARK(GL.GL_UNSIGNED_INT, 0, tags)
GL.glEnableClientState(ark.GL_DEPTH_TAG_ARRAY_ARK)
ark.glDrawARP(GL.GL_TRIANGLES, 0, 3)
GL.glFinish()
level = ctypes.c_int()  # PyOpenGL does not know how many numbers this state has
GL.glGetIntegerv(ark.GL_POOL_LEVEL_ARK, level)
print(level.value, GL.glGetError(), int((pixels[..., 0] > 0).sum()) > 1000)
program = GL.glCreateProgram()
ark.glRefinementShaderSourceARK(program, "this is no GLSL")
vertex = GL.glCreateShader(GL.GL_VERTEX_SHADER)
GL.glShaderSource(vertex, "#version 130\\nin vec3 p; void main() { gl_Position = vec4(p, 1); }")
GL.glCompileShader(vertex)
GL.glAttachShader(program, vertex)
GL.glLinkProgram(program)
print(ark.glGetRefinementivARK(program, ark.GL_REFINEMENT_STATUS_ARK), "error" in ark.glGetRefinementInfoLogARK(program).lower())
"""


class Extension(unittest.TestCase):
    def run_program(self, *words):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "program.py"
            program.write_text(PROGRAM)
            environment = {name: value for name, value in os.environ.items() if name != "LD_PRELOAD"}
            return subprocess.run([sys.executable, *words, program], capture_output=True, text=True,
                                  env=environment | {"PYOPENGL_PLATFORM": "osmesa"})

    def test_program_is_refined(self):
        done = self.run_program("-m", "glark.gl")
        self.assertEqual("4 0 True\n0 True\n", done.stdout, done.stderr)

    def test_without_the_library_the_remedy_is_told(self):
        done = self.run_program()
        self.assertIn("glARKinit: libGLARK does not stand before the GL library; start the program by: python3 -m glark.gl",
                      done.stderr)


if __name__ == "__main__":
    unittest.main()
