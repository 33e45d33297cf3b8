# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The programs that scripts/traces records: programs of Debian, and small programs for libraries that have none."""
import dataclasses
import pathlib

CLIENTS = pathlib.Path(__file__).resolve().parents[2] / "tests" / "clients"
HACKS = "/usr/libexec/xscreensaver/"
QT = "/usr/lib/x86_64-linux-gnu/qt5/examples/opengl/"
PYTHON = "/usr/bin/python3"


@dataclasses.dataclass
class Program:
    name: str
    command: list
    egl: bool = False      # reaches OpenGL by EGL
    seconds: float = 4     # length of the recording; the first frames are kept
    first: int = 0         # first frame of the recording that is compared
    environment: dict = dataclasses.field(default_factory=dict)


def hack(name: str, *options: str) -> Program:
    return Program(f"xscreensaver {name}", [HACKS + name, "--window", "--geometry", "400x300", *options], egl=True)


def glmark2(scene: str) -> Program:
    return Program(f"glmark2 {scene.split(':')[0]}", ["glmark2", "-s", "400x300", "-b", f"{scene}:duration=4"], seconds=8)


def osg(name: str, *arguments: str, seconds: float = 5) -> Program:
    return Program(name, [name, *arguments], seconds=seconds)


def qt(path: str) -> Program:
    return Program(f"Qt {path.split('/')[-1]}", [QT + path])


PROGRAMS = [
    Program("glxgears", ["glxgears"]),
    Program("glxheads", ["glxheads"]),
    Program("es2gears", ["es2gears_x11"], egl=True),
    *(glmark2(scene) for scene in ("build:use-vbo=true", "texture", "shading:shading=phong", "bump:bump-render=normals",
                                   "effect2d", "pulsar", "desktop:windows=4", "buffer", "ideas", "jellyfish", "conditionals",
                                   "loop", "shadow", "refract")),
    osg("osgviewer", str(CLIENTS / "gable.obj")),
    *(osg(name) for name in ("osgteapot", "osgtessellate", "osggeometry", "osgshape", "osgtext", "osgtext3D", "osghangglide",
                             "osganimationskinning", "osgdrawinstanced", "osgshadow")),
    *(hack(name) for name in ("gears", "superquadrics", "boing", "dangerball", "pipes", "menger", "molecule", "polyhedra",
                              "atlantis", "glplanet", "bouncingcow", "cubenetic")),
    Program("neverball", ["/usr/games/neverball"], seconds=10),
    Program("neverputt", ["/usr/games/neverputt"], seconds=10),
    Program("extremetuxracer", ["/usr/games/etr"], seconds=10),
    Program("chromium-bsu", ["/usr/games/chromium-bsu", "-w", "--vidmode", "0"], seconds=8),
    Program("trackballs", ["/usr/games/trackballs", "-w"], seconds=10),
    Program("billard-gl", ["/usr/games/billard-gl"], seconds=8),
    Program("crack-attack", ["/usr/games/crack-attack", "--solo"], seconds=8),
    Program("gltron", ["/usr/games/gltron", "-w"], seconds=8),
    Program("briquolo", ["/usr/games/briquolo"], seconds=8),
    Program("mm3d", ["mm3d", str(CLIENTS / "gable.obj")], seconds=8),
    Program("f3d", ["f3d", str(CLIENTS / "gable.obj")], seconds=6),
    Program("PyOpenGL GLUT", [PYTHON, str(CLIENTS / "python" / "glut_teapot.py"), "30"], seconds=15),
    qt("hellogl2/hellogl2"), qt("cube/cube"), qt("hellogles3/hellogles3"),
    qt("qopenglwidget/qopenglwidget"),
]
