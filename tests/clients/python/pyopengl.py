# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Reaches GL through PyOpenGL: ctypes, so dlopen and dlsym by name; a compatibility context on an EGL pbuffer.

usage: pyopengl.py FRAMES OUT.ppm
"""
import ctypes
import math
import os
import sys

os.environ["PYOPENGL_PLATFORM"] = "egl"
os.environ["EGL_PLATFORM"] = "surfaceless"
from OpenGL import EGL as egl  # noqa: E402 (reads the variables above)
from OpenGL import GL as gl  # noqa: E402

SIZE = 256


def make_context() -> None:
    display = egl.eglGetDisplay(egl.EGL_DEFAULT_DISPLAY)
    major, minor, count = egl.EGLint(), egl.EGLint(), egl.EGLint()
    egl.eglInitialize(display, major, minor)
    wanted = (egl.EGLint * 9)(egl.EGL_SURFACE_TYPE, egl.EGL_PBUFFER_BIT, egl.EGL_RENDERABLE_TYPE, egl.EGL_OPENGL_BIT,
                              egl.EGL_RED_SIZE, 8, egl.EGL_DEPTH_SIZE, 24, egl.EGL_NONE)
    configs = (egl.EGLConfig * 1)()
    egl.eglChooseConfig(display, wanted, configs, 1, count)
    egl.eglBindAPI(egl.EGL_OPENGL_API)
    size = (egl.EGLint * 5)(egl.EGL_WIDTH, SIZE, egl.EGL_HEIGHT, SIZE, egl.EGL_NONE)
    surface = egl.eglCreatePbufferSurface(display, configs[0], size)
    context = egl.eglCreateContext(display, configs[0], egl.EGL_NO_CONTEXT, None)
    if not egl.eglMakeCurrent(display, surface, surface, context):
        sys.exit("client: no context")


def draw() -> None:
    """A bowl of triangles about a centre, lit; in immediate mode and from an array."""
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    gl.glBegin(gl.GL_TRIANGLE_FAN)
    gl.glNormal3f(0, 0, 1)
    gl.glColor3f(1, 1, 1)
    gl.glVertex3f(0, 0.2, 0)
    for i in range(9):
        turn = 2 * math.pi * i / 8
        gl.glNormal3f(math.cos(turn), math.sin(turn), 0.5)
        gl.glColor3f(0.5 + 0.5 * math.cos(turn), 0.6, 0.3)
        gl.glVertex3f(0.7 * math.cos(turn), 0.2 + 0.7 * math.sin(turn), -0.3)
    gl.glEnd()
    corners = (ctypes.c_float * 9)(-0.9, -0.9, 0.2, 0.9, -0.9, 0.2, 0, -0.4, -0.4)
    gl.glNormal3f(0, 0.5, 1)
    gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
    gl.glVertexPointer(3, gl.GL_FLOAT, 0, corners)
    gl.glDrawArrays(gl.GL_TRIANGLES, 0, 3)
    gl.glDisableClientState(gl.GL_VERTEX_ARRAY)


def main() -> None:
    frames, path = int(sys.argv[1]), sys.argv[2]
    make_context()
    gl.glViewport(0, 0, SIZE, SIZE)
    gl.glClearColor(0.1, 0.2, 0.3, 1)
    for capability in (gl.GL_DEPTH_TEST, gl.GL_LIGHTING, gl.GL_LIGHT0, gl.GL_COLOR_MATERIAL):
        gl.glEnable(capability)
    for _ in range(frames):
        draw()
    gl.glPixelStorei(gl.GL_PACK_ALIGNMENT, 1)
    pixels = gl.glReadPixels(0, 0, SIZE, SIZE, gl.GL_RGB, gl.GL_UNSIGNED_BYTE, outputType=bytes)
    rows = [pixels[3 * SIZE * y:3 * SIZE * (y + 1)] for y in reversed(range(SIZE))]
    with open(path, "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (SIZE, SIZE) + b"".join(rows))


main()
