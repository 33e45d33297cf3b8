# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The programs of scripts/strangers: programs and demos of Debian 12 that glark was not made for, each in use."""
import dataclasses
import pathlib

SCENES = pathlib.Path(__file__).resolve().parent / "scenes"
HACKS = "/usr/libexec/xscreensaver/"
QT = "/usr/lib/x86_64-linux-gnu/qt5/examples/"
PERL = "/usr/share/doc/libopengl-perl/examples/"
PYQTGRAPH = "/usr/lib/python3/dist-packages/pyqtgraph/examples/"
PYTHON = "/usr/bin/python3"
DRAG = ((7, "mousemove 200 220 mousedown 1 sleep .4 mousemove 215 225 sleep .4 mousemove 230 230 sleep .4 mousemove 245 235 "
         "sleep .4 mousemove 260 240 sleep .4 mousemove 275 245 sleep .4 mouseup 1"),)
MODELS = "MODELS"  # stands for the folder with the models that models.py writes


@dataclasses.dataclass
class Stranger:
    name: str
    kind: str
    packages: tuple
    command: list
    egl: bool = False       # reaches OpenGL by EGL
    seconds: float = 8      # length of the recording
    frames: int = 150       # the recording is cut after so many frames; four of the second half are compared
    keys: tuple = ()        # (seconds to wait, what xdotool does then), one after the other
    environment: dict = dataclasses.field(default_factory=dict)


def saver(name: str, *options: str) -> Stranger:
    return Stranger(name, "screen saver", ("xscreensaver-gl", "xscreensaver-gl-extra"),
                    [HACKS + name, "--window", "--geometry", "400x300", *options], egl=True, seconds=5, frames=60)


def shooter(name: str, *options: str, keys: tuple = ((4, "keydown z"), (2, "keydown Left"))) -> Stranger:
    return Stranger(name, "game, demo", (name,), ["/usr/games/" + name, *options], seconds=10, frames=240, keys=keys)


def qt(path: str, **more) -> Stranger:
    package = "qtdatavisualization5-examples" if path.startswith("datavis") else "qtbase5-examples"
    name = path.split("/")[-1]
    if path.startswith("datavis"):  # glretrace cannot destroy their GLX pixel buffers
        more |= {"seconds": 12, "keys": DRAG, "egl": True, "environment": {"QT_XCB_GL_INTEGRATION": "xcb_egl"}}
    return Stranger(f"Qt {name}", "toolkit", (package,), [f"{QT}{path}/{name}"], frames=60, **more)


def perl(name: str) -> Stranger:
    return Stranger(f"Perl {name}", "language", ("libopengl-perl", "libglut3.12"), ["/usr/bin/perl", f"{PERL}{name}.pl"], frames=60)


def pyqtgraph(name: str) -> Stranger:
    return Stranger(f"pyqtgraph {name}", "toolkit", ("python3-pyqtgraph", "python3-pyqt5", "python3-opengl",
                                                   "python3-pyqt5.qtopengl"),
                    [PYTHON, f"{PYQTGRAPH}{name}.py"], frames=40, seconds=13, keys=DRAG)


def scene(toolkit: str, package: str, **more) -> Stranger:
    """A small program of ours for a toolkit whose package ships none."""
    return Stranger(toolkit, "toolkit", (package,), [PYTHON, str(SCENES / f"{toolkit}_scene.py")], frames=40, seconds=10, **more)


def arena(name: str, renderer: str) -> Stranger:
    settings = {"cl_renderer": renderer, "r_fullscreen": "0", "r_mode": "-1",
                "r_customwidth": "320", "r_customheight": "240", "com_maxfps": "8", "s_initsound": "0", "sv_pure": "0",
                "g_spSkill": "1", "r_swapInterval": "0"}
    words = [word for key, value in settings.items() for word in ("+set", key, value)]
    return Stranger(name, "game, in play", ("openarena",),
                    ["/usr/games/openarena", *words, "+devmap", "oa_dm1", "+addbot", "gargoyle"],
                    seconds=25, frames=400)


SHOOTERS = [
    shooter("torus-trooper", "-window", "-res", "320", "240"),
    shooter("tumiki-fighters", "-window", "-res", "320", "240"), shooter("gunroar", "-window", "-res", "320", "240"),
    shooter("titanion", "-window", "-res", "320", "240"), shooter("mu-cade", "-window", "-res", "320", "240"),
    shooter("parsec47", "-window", "-lowres"), shooter("rrootage", "-window", "-lowres"),
    shooter("a7xpg", "-window", "-lowres"), shooter("val-and-rick", "-window", "-res", "320", "240"),
    shooter("ii-esu", "-window"), shooter("projectl", "-window", "-res", "320", "240"),
]

GAMES = [
    arena("OpenArena", "opengl1"), arena("OpenArena GL2", "opengl2"),
    Stranger("armagetronad", "game, in play", ("armagetronad",), ["/usr/games/armagetronad"], seconds=14, frames=400,
             keys=((3, "key Return"), (1, "key Return"), (1, "key Return"), (1, "key Return"))),
    Stranger("zaz", "game, menu", ("zaz",), ["/usr/games/zaz"], seconds=12, keys=((4, "key Return"), (2, "key Return"))),
    Stranger("brutalchess", "game, in play", ("brutalchess",), ["/usr/games/brutalchess"], seconds=10,
             keys=((3, "key Return"), (2, "key Return"))),
    Stranger("dreamchess", "game, menu", ("dreamchess",), ["/usr/games/dreamchess", "--width", "640", "--height", "480"],
             seconds=10, keys=((4, "key Return"), (1, "key Return"))),
    Stranger("Freedoom in dsda-doom", "game, in play", ("dsda-doom", "freedoom"),
             ["/usr/games/dsda-doom", "-iwad", "/usr/share/games/doom/freedoom1.wad", "-vidmode", "gl", "-geom", "320x240w",
              "-nosound", "-warp", "1", "-skill", "3"], frames=300),
    Stranger("supertux", "game, menu", ("supertux",), ["/usr/games/supertux2", "--geometry", "320x240", "--window",
             "/usr/share/games/supertux2/levels/world1/welcome_antarctica.stl"], seconds=10),
    Stranger("minetest", "game, in play", ("minetest", "minetest-data"),
             ["/usr/games/minetest", "--world", f"{MODELS}/world", "--go"], seconds=25, frames=200),
    Stranger("crrcsim", "game, in play", ("crrcsim",), ["/usr/games/crrcsim"], seconds=12, frames=120),
    Stranger("transcend", "game, in play", ("transcend",), ["/usr/games/Transcend"], seconds=8),
    Stranger("cultivation", "game, in play", ("cultivation",), ["/usr/games/Cultivation"], seconds=8),
    Stranger("extremetuxracer in play", "game, in play", ("extremetuxracer",), ["/usr/games/etr"], seconds=20, frames=400,
             keys=((4, "key Return"), (2, "key Return"), (2, "key Return"), (2, "key Return"), (2, "key Return"))),
    Stranger("torcs", "game, in play", ("torcs",), ["/usr/games/torcs"], seconds=40, frames=300,
             keys=((6, "key Return"), (3, "key Return"), (3, "key Return"), (3, "key Return"))),
    Stranger("kubrick", "game", ("kubrick",), ["/usr/games/kubrick"], seconds=10, frames=60),
]

SAVERS = [saver(name) for name in (
    "endgame", "jigglypuff", "lament", "sballs", "pinion", "engine", "cube21", "peepers", "headroom", "handsy",
    "lavalite", "juggler3d", "glschool", "glsnake", "moebiusgears", "splodesic", "topblock", "winduprobot", "rubik",
    "companioncube", "skytentacles", "hydrostat", "geodesicgears", "glhanoi",
    "queens", "sphereeversion", "vigilance")]
GLX = {"GDK_DEBUG": "gl-glx"}  # GTK 4 then does without EGL

TOOLKITS = [
    Stranger("GTK 4 widgets", "toolkit", ("gtk-4-examples",), ["/usr/bin/gtk4-widget-factory"], frames=20, environment=GLX),
    qt("datavisualization/bars"), qt("datavisualization/scatter"), qt("datavisualization/surface"),
    qt("datavisualization/customitems"), qt("datavisualization/volumetric"), qt("datavisualization/qmlsurface"),
    qt("datavisualization/qmlbars"), qt("opengl/threadedqopenglwidget"), qt("opengl/hellowindow"), qt("opengl/textures"),
    pyqtgraph("GLMeshItem"), pyqtgraph("GLSurfacePlot"), pyqtgraph("GLIsosurface"), pyqtgraph("GLVolumeItem"),
    scene("pyglet", "python3-pyglet"), scene("kivy", "python3-kivy"),
    scene("wx", "python3-wxgtk4.0"), scene("vtk", "python3-vtk9"),
    perl("planets"), perl("glxgears"),
]

DESKTOP = [
    Stranger("OpenSCAD", "modeller", ("openscad",), ["/usr/bin/openscad", "/usr/share/openscad/examples/Basics/CSG.scad"],
             seconds=14, keys=DRAG),
    Stranger("OpenSCAD logo", "modeller", ("openscad",), ["/usr/bin/openscad", "/usr/share/openscad/examples/Basics/logo.scad"],
             seconds=14, keys=DRAG),
    Stranger("fstl", "modeller", ("fstl",), ["/usr/bin/fstl", f"{MODELS}/ball.stl"], seconds=14, keys=DRAG),
    Stranger("Gmsh", "modeller", ("gmsh",), ["/usr/bin/gmsh", f"{MODELS}/ball.stl"], seconds=14, keys=DRAG),
    Stranger("Goxel", "modeller", ("goxel",), ["/usr/bin/goxel"], seconds=14, keys=DRAG),
    Stranger("SolveSpace", "modeller", ("solvespace",), ["/usr/bin/solvespace"], seconds=14, keys=DRAG),
    Stranger("Wings 3D", "modeller", ("wings3d",), ["/usr/bin/wings"], seconds=14, keys=DRAG),
    Stranger("Avogadro", "molecules", ("avogadro",), ["/usr/bin/avogadro2", f"{MODELS}/molecule.xyz"], seconds=14, keys=DRAG),
    Stranger("PyMOL sticks", "molecules", ("pymol",),
             ["/usr/bin/pymol", "-q", "-x", f"{MODELS}/molecule.xyz", "-d", "show sticks"],
             seconds=14, keys=DRAG),
    Stranger("PyMOL spheres", "molecules", ("pymol",),
             ["/usr/bin/pymol", "-q", "-x", f"{MODELS}/molecule.xyz", "-d", "show spheres"],
             seconds=14, keys=DRAG),
    Stranger("QuteMol", "molecules", ("qutemol",), ["/usr/bin/qutemol", f"{MODELS}/molecule.pdb"], seconds=14, keys=DRAG),
    Stranger("GDIS", "molecules", ("gdis",), ["/usr/bin/gdis", f"{MODELS}/molecule.xyz"], seconds=14, keys=DRAG),
    Stranger("V_Sim", "molecules", ("v-sim",), ["/usr/bin/v_sim", f"{MODELS}/molecule.xyz"], seconds=14, keys=DRAG),
    Stranger("kitty", "desktop", ("kitty",), ["/usr/bin/kitty", "ls", "-l", "/usr/share"]),
    Stranger("gource", "desktop", ("gource",), ["/usr/bin/gource", "-320x240", "--log-format", "custom", f"{MODELS}/history.log"]),
    Stranger("Chromium WebGL", "browser", ("chromium",),
             ["/usr/bin/chromium", "--no-sandbox", "--in-process-gpu", "--use-gl=angle", "--use-angle=gl",
              "--ignore-gpu-blocklist",
              "--window-size=400,300", "--user-data-dir=MODELS/chromium", str(SCENES / "webgl.html")], seconds=25),
    Stranger("openMSX", "emulator", ("openmsx",), ["/usr/bin/openmsx", "-machine", "C-BIOS_MSX2"], seconds=10, frames=60),
    Stranger("Inventor noodle", "demo", ("inventor-demo",), ["/usr/lib/inventor/noodle"], seconds=14, frames=40, keys=DRAG),
    Stranger("Inventor ivview", "demo", ("inventor-clients",), ["/usr/bin/ivview",
             "/usr/share/doc/inventor-demo/src/apps/examples/data/luxo.iv"]),
]

MORE = [
    Stranger("GLUT shapes", "toolkit", ("python3-opengl", "libglut3.12"), [PYTHON, str(SCENES / "glut_scene.py")], frames=60),
    Stranger("Mayavi", "toolkit", ("mayavi2", "python3-pyqt5"), [PYTHON, str(SCENES / "mayavi_scene.py")], seconds=20, frames=40,
             environment={"ETS_TOOLKIT": "qt", "QT_API": "pyqt5"}),
    Stranger("Open3D", "toolkit", ("python3-open3d",), [PYTHON, str(SCENES / "open3d_scene.py")], seconds=12, frames=40),
    Stranger("Wine", "Windows", ("wine64", "gcc-mingw-w64-x86-64"), [str(SCENES / "wine_scene")], seconds=30, frames=60),
    Stranger("Blender", "modeller", ("blender",), ["/usr/bin/blender", "--factory-startup", "--window-geometry", "0", "0", "400", "300",
             "--python", str(SCENES / "blender_scene.py")], seconds=90, frames=60),
    Stranger("FreeCAD", "modeller", ("freecad",), ["/usr/bin/freecad", str(SCENES / "freecad_scene.py")], seconds=40, frames=60,
             environment={"QTWEBENGINE_DISABLE_SANDBOX": "1"}),
    Stranger("CloudCompare", "modeller", ("cloudcompare",), ["/usr/bin/CloudCompare", f"{MODELS}/ball.obj"], seconds=14, keys=DRAG),
    Stranger("RepSnapper", "modeller", ("repsnapper",), ["/usr/bin/repsnapper", f"{MODELS}/ball.stl"], seconds=14, keys=DRAG),
    Stranger("view3dscene", "viewer", ("view3dscene",), ["/usr/bin/view3dscene", "--geometry", "400x300", f"{MODELS}/ball.wrl"],
             seconds=14, keys=DRAG),
    Stranger("OpenCSG", "demo", ("libopencsg-example",), ["/usr/bin/opencsgexample"], frames=60),
    Stranger("OpenUniverse", "desktop", ("openuniverse",), ["/usr/bin/openuniverse"], seconds=14, frames=100),
    Stranger("Critical Mass", "game, in play", ("criticalmass",), ["/usr/games/critter"], seconds=25, frames=500,
             keys=((5, "mousemove 265 118 click 1"), (2, "mousemove 265 118 click 1"), (2, "key Return"), (2, "key Return"))),
    Stranger("BZFlag", "game, in play", ("bzflag-client", "bzflag-server"),
             ["/bin/sh", "-c", "bzfs -p 15154 >/dev/null 2>&1 & sleep 1; "
              "exec /usr/games/bzflag -window 400x300 -m -nolist -nomotd -solo 3 stranger@localhost:15154"],
             seconds=25, frames=300, keys=((8, "keydown Up"), (3, "key Return"))),
    Stranger("Lugaru", "game, in play", ("lugaru",), ["/usr/games/lugaru", "--windowed", "--nosound", "--nomousegrab"], seconds=35,
             frames=300, keys=((10, "mousemove 320 180 click 1"), (3, "key Return"))),
    Stranger("Search and Rescue", "game, menu", ("searchandrescue",), ["/usr/games/SearchAndRescue"], seconds=15, frames=200,
             keys=((5, "key Return"), (3, "key Return"))),
]

LAST_MET = [
    *(saver(name) for name in ("glknots", "raverhoop", "squirtorus", "romanboy", "tronbit", "sierpinski3d",
                               "hypertorus", "antinspect", "maze3d")),
    Stranger("enemylines3", "game, menu", ("enemylines3",), ["/usr/games/enemylines3"], seconds=10,
             keys=((3, "key Return"), (2, "key Return"))),
    Stranger("enemylines7", "game, in play", ("enemylines7",), ["/usr/games/enemylines7"], seconds=12,
             keys=((3, "key Return"), (2, "key Return"), (2, "key Return"))),
    Stranger("marsshooter", "game, in play", ("marsshooter",), ["/usr/games/marsshooter"], seconds=14,
             keys=((5, "key Return"), (2, "key Return"), (2, "key Return"))),
    Stranger("briquolo", "game, in play", ("briquolo",), ["/usr/games/briquolo", "-r", "400x300"], seconds=12,
             keys=((4, "key Return"), (2, "key Return"), (2, "key Return"))),
    Stranger("blockout2", "game, in play", ("blockout2",), ["/usr/games/blockout2"], seconds=12,
             keys=((4, "key Return"), (2, "key Return"), (2, "key space"))),
    Stranger("fracplanet", "modeller", ("fracplanet",), ["/usr/bin/fracplanet"], seconds=14, keys=DRAG),
    Stranger("stormbaancoureur", "game, in play", ("stormbaancoureur",), ["/usr/games/stormbaancoureur", "-w"], seconds=14, frames=200,
             keys=((4, "key Return"), (2, "keydown Up"))),
    Stranger("sdl-ball", "game, in play", ("sdl-ball",), ["/usr/games/sdl-ball"], seconds=12, keys=((4, "key Return"), (2, "key space"))),
    Stranger("g3dviewer", "viewer", ("g3dviewer",), ["/usr/bin/g3dviewer", f"{MODELS}/ball.obj"], seconds=12, keys=DRAG),
    Stranger("pong2", "game, in play", ("pong2",), ["/usr/games/pong2"], seconds=10, keys=((3, "key s"),)),
    Stranger("CalculiX", "modeller", ("calculix-cgx",), ["/usr/bin/cgx", "-stl", f"{MODELS}/ball.stl"], seconds=12, keys=DRAG),
]

MET_AFTERWARDS = [
    *(saver(name) for name in ("dymaxionmap", "etruscanvenus", "kaleidocycle", "moebius", "splitflap", "stairs", "stonerview")),
    *(dataclasses.replace(saver(name), frames=16) for name in ("covid19", "discoball")),  # 200 000 triangles in a frame
    Stranger("OSG viewer", "viewer", ("openscenegraph",), ["/usr/bin/osgviewer", "--window", "20", "20", "320", "240", f"{MODELS}/ball.obj"],
             seconds=10, frames=100, keys=DRAG),
    Stranger("pink-pony", "game, in play", ("pink-pony",), ["/usr/games/pink-pony"], seconds=50, frames=200,
             keys=((12, "key Return"), (6, "key Return"), (6, "key Return"))),
    Stranger("pipewalker", "game, in play", ("pipewalker",), ["/usr/games/pipewalker"], seconds=8, frames=100),
]


def qt3d(name: str) -> Stranger:
    return Stranger(f"Qt 3D {name}", "toolkit", ("qt3d5-examples",), [f"{QT}qt3d/{name}/{name}"], frames=60, seconds=12, egl=True,
                    keys=DRAG, environment={"QT_XCB_GL_INTEGRATION": "xcb_egl"})


LAST_SAVERS = [saver(name) for name in (
    "antmaze", "antspotlight", "atunnel", "blinkbox", "blocktube", "boxed", "bubble3d", "cage", "chompytower",
    "circuit", "cityflow", "crackberg", "crumbler", "cubestack", "cubestorm", "cubetwist", "cubicgrid", "deepstars",
    "energystream", "esper", "extrusion", "flipflop", "flyingtoasters", "geodesic", "gibson", "glblur",
    "glcells", "gleidescope", "gravitywell", "hexstrut", "hextrail", "hilbert", "hypnowheel", "jigsaw", "klein",
    "lockward", "morph3d", "nakagin", "noof", "polytopes", "projectiveplane", "providence", "quasicrystal",
    "razzledazzle", "rubikblocks", "sonar", "spheremonics", "sproingies", "starwars", "surfaces", "tangram",
    "timetunnel", "unicrud", "unknownpleasures", "voronoi")]

MET_LAST = [
    qt3d("basicshapes-cpp"), qt3d("shadow-map-qml"),
    Stranger("GTK 4 gears", "toolkit", ("gtk-4-examples",), ["/usr/bin/gtk4-demo", "--run=gears"], frames=60, environment=GLX),
    scene("vispy", "python3-vispy"),
]

# Programs of the fifth round that show something without a file from this repository.
MET_FIFTH = [
    *(qt3d(name) for name in ("simple-cpp", "multiviewport", "wireframe", "3d-text", "lights", "phong-cubes", "anaglyph-rendering", "controls",
                              "scene3d", "qardboard")),
    Stranger("evolver", "viewer", ("evolver-ogl", "evolver-doc"), ["/bin/sh", "-c", "(sleep 2; echo s; echo q; while sleep .2; do echo 'g 1'; done) |"
             " exec /usr/bin/evolver-ogl-d /usr/share/doc/evolver/examples/cube.fe"], seconds=12, frames=80, keys=DRAG),
    Stranger("opencity", "game, in play", ("opencity",), ["/usr/games/opencity", "-na", "--generator-map", "1"], seconds=20, frames=80, keys=DRAG),
    Stranger("colobot", "game, in play", ("colobot",), ["/usr/games/colobot", "-runscene", "missions101", "-resolution", "400x300"], seconds=45, frames=80),
    Stranger("shelxle", "viewer", ("shelxle", "drawxtl"), ["/usr/bin/shelxle", "/usr/share/doc/drawxtl/examples/ags4.res"], seconds=12, frames=80, keys=DRAG),
    Stranger("ghemical", "viewer", ("ghemical",), ["/usr/bin/ghemical", "-f", "/usr/share/doc/ghemical/examples/camphor.gpr"], seconds=12, frames=80,
             keys=DRAG),
    Stranger("scorched3d", "game, in play", ("scorched3d",), ["/usr/games/scorched3dc", "-startclient",
             "/usr/share/games/scorched3d/data/singletutorial.xml"], seconds=45, frames=80),
]

PROGRAMS = [*TOOLKITS, *DESKTOP, *MORE, *GAMES, *SAVERS, *SHOOTERS, *LAST_MET, *MET_AFTERWARDS, *LAST_SAVERS, *MET_LAST, *MET_FIFTH]
