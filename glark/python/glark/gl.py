# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The functions and tokens of GL_ARK_adaptive_refinement, for PyOpenGL, moderngl and others.

libGLARK must stand before the GL library, so this module starts the program:

    python3 -m glark.gl program.py ARGUMENTS

In the program, with a current context:

    from OpenGL import GL
    from glark import gl as ark

    ark.glARKinit(4)
    GL.glEnable(ark.GL_ARK)
    ark.glDepthTag1i(3)

A function raises RuntimeError if libGLARK is not there. glGetError tells the extension's errors, as usual. A pointer is a
NumPy array, a number (an offset in the bound buffer), or None. The program must keep an array of glDepthTagPointerARK.
"""
import ctypes
import os
import pathlib
import sys

from . import _registry
from ._registry import *  # noqa: F403: the tokens

_TYPES = {"GLuint": ctypes.c_uint, "GLint": ctypes.c_int, "GLenum": ctypes.c_uint, "GLsizei": ctypes.c_int,
          "GLfloat": ctypes.c_float, "pointer": ctypes.c_void_p}
_LIBRARY = "libGLARK.so.0"
_process = ctypes.CDLL(None)


def preloaded() -> bool:
    """Returns whether libGLARK stands before the GL library in this process."""
    return hasattr(_process, "glARKinit")


def _call(name: str, *arguments) -> None:
    if not preloaded():
        raise RuntimeError(f"{name}: libGLARK does not stand before the GL library; "
                           f"start the program by: python3 -m glark.gl {sys.argv[0]}")
    function = getattr(_process, name)
    function.argtypes, function.restype = [_TYPES[kind] for kind in _registry.COMMANDS[name]], None
    function(*arguments)


def _function(name: str):
    def function(*arguments):
        _call(name, *map(_address, arguments))

    function.__name__ = function.__qualname__ = name
    function.__doc__ = f"{name}({', '.join(_registry.COMMANDS[name])})"
    return function


def _address(argument):
    return argument.ctypes.data if hasattr(argument, "ctypes") else argument


for _name in ("glARKinit", "glARKParameteriARK", "glARKParameterfARK", "glDepthTag1i", "glDepthTagPointerARK", "glDrawARP",
              "glDrawARPElementsARK"):
    globals()[_name] = _function(_name)


def glRefinementShaderSourceARK(program: int, text: str) -> None:
    """Gives the program a refinement shader, which its next glLinkProgram uses."""
    encoded = ctypes.c_char_p(text.encode())
    _call("glRefinementShaderSourceARK", program, 1, ctypes.addressof(ctypes.pointer(encoded).contents), None)


def glGetRefinementivARK(program: int, pname: int) -> int:
    """Returns the value, for example of GL_REFINEMENT_STATUS_ARK."""
    value = ctypes.c_int()
    _call("glGetRefinementivARK", program, pname, ctypes.addressof(value))
    return value.value


def glGetRefinementInfoLogARK(program: int) -> str:
    """Returns the log of the refinement shader."""
    size = glGetRefinementivARK(program, _registry.GL_REFINEMENT_LOG_LENGTH_ARK)
    log = ctypes.create_string_buffer(max(size, 1))
    _call("glGetRefinementInfoLogARK", program, len(log), None, ctypes.addressof(log))
    return log.value.decode()


def _find_library() -> str:
    """The library that GLARK_LIBRARY names, that of the same installation or build, or the system's."""
    own = pathlib.Path(__file__).resolve()
    places = [os.environ.get("GLARK_LIBRARY", "")] + [str(folder / _LIBRARY) for folder in own.parents[1:5]]
    return next((place for place in places if place and os.path.exists(place)), _LIBRARY)


def _main() -> None:
    if len(sys.argv) < 2:
        sys.exit("usage: python3 -m glark.gl PROGRAM.py [ARGUMENT ...]")
    library = _find_library()
    try:
        ctypes.CDLL(library)
    except OSError as error:
        sys.exit(f"glark.gl: {library} cannot be loaded: {error}; install libglark0, or set GLARK_LIBRARY to the file")
    preloads = [library] + os.environ.get("LD_PRELOAD", "").split()
    os.environ["LD_PRELOAD"] = " ".join(preloads)
    os.execv(sys.executable, [sys.executable, *sys.argv[1:]])


if __name__ == "__main__":
    _main()
