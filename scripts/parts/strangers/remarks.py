# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""What a person saw on the contact sheet of each stranger: plain, off, outputs and smooth side by side, and where smooth changed most."""

SAME = "all four look the same"
FLAT = "widgets and pictures, " + SAME
MENU = "a menu, " + SAME
LINES = "lines, " + SAME
ROUNDER = "outlines are rounder"
FINE = "fine already; hardly visible changes"
POLYGONS = "flat shaded on purpose; stays so"

REMARKS = {
    **{name: SAME for name in ("blinkbox", "blocktube", "boxed", "bubble3d", "cage", "circuit", "cityflow", "cubestack", "cubestorm", "cubetwist",
                               "deepstars", "flipflop", "flyingtoasters", "glblur", "hexstrut", "hextrail", "hypnowheel", "klein",
                               "lockward", "nakagin", "noof", "polytopes", "quasicrystal", "razzledazzle", "rubikblocks", "sproingies",
                               "tangram", "timetunnel", "unicrud", "voronoi", "Qt 3D shadow-map-qml", "GTK 4 gears")},
    **{name: LINES for name in ("cubicgrid", "gibson", "gravitywell", "projectiveplane", "starwars", "surfaces", "unknownpleasures")},
    "antmaze": "ants are rounder", "atunnel": "quads that leave the view: outputs is cut along the other diagonal",
    "crackberg": POLYGONS, "extrusion": "light on big twisted quads shows fully", "geodesic": ROUNDER, "glcells": ROUNDER,
    "hilbert": "tubes are rounder; their highlights show fully", "morph3d": FINE, "providence": SAME, "spheremonics": "the ball is round",
    "sonar": "bent rings whose normals lean; stay so", "Qt 3D basicshapes-cpp": "highlights are smaller and brighter",
    "covid19": ROUNDER, "discoball": SAME, "vispy": "the ball and its highlight are round",
    "dymaxionmap": "a map of single triangles, " + SAME, "etruscanvenus": LINES, "kaleidocycle": POLYGONS, "moebius": "ants are rounder",
    "splitflap": SAME, "stairs": "the ball is round", "stonerview": "single squares, " + SAME, "OSG viewer": "the ball is round",
    "pipewalker": FLAT,
    "glknots": "tubes are rounder; highlights on them show fully", "raverhoop": SAME, "squirtorus": SAME, "romanboy": SAME, "tronbit": POLYGONS,
    "sierpinski3d": SAME, "hypertorus": SAME, "antinspect": LINES, "maze3d": SAME,
    "enemylines3": "bodies of single polygons, " + SAME, "enemylines7": "bodies of single polygons, " + SAME,
    "marsshooter": MENU, "briquolo": SAME, "blockout2": SAME, "fracplanet": "the coast is as before, the outline rounder",
    "stormbaancoureur": "tyres are rounder, and so are their shadows", "sdl-ball": SAME, "g3dviewer": "redraws seldom, so smooth waits; " + SAME,
    "pong2": "the ball is rounder", "CalculiX": POLYGONS,
    "GTK 4 widgets": FLAT, "kitty": "an empty window: its text is not in the recording", "kivy": FLAT,
    "Qt bars": SAME, "Qt scatter": SAME, "Qt surface": SAME, "Qt customitems": SAME, "Qt volumetric": SAME,
    "Qt qmlsurface": SAME, "Qt qmlbars": SAME, "Qt threadedqopenglwidget": SAME, "Qt hellowindow": POLYGONS,
    "Qt textures": "textured boxes, " + SAME,
    "pyglet": "the ball is round", "wx": "the ball is round", "vtk": "the torus and the ball are round",
    "Perl planets": "correct: the horizon of a near, coarse planet rises by more than the reach",
    "Perl glxgears": SAME, "GLUT shapes": "balls and tori are round; a rounded ball pokes through the flat wall of the tube around it",
    "Mayavi": "balls and tube are round", "Open3D": POLYGONS,
    "Wine": "the ball is round",
    "OpenSCAD": SAME, "OpenSCAD logo": SAME, "fstl": "makes its normals from screen derivatives; " + SAME,
    "Gmsh": LINES, "Goxel": SAME, "SolveSpace": LINES, "Avogadro": "balls of fragment shaders, " + SAME,
    "PyMOL sticks": "sticks of fragment shaders, " + SAME, "PyMOL spheres": "balls of fragment shaders, " + SAME,
    "GDIS": FINE, "V_Sim": f"redraws seldom, so smooth waits; {SAME}", "gource": FLAT, "Chromium WebGL": "a lit ball without normals; " + SAME, "openMSX": FLAT,
    "Inventor noodle": "an edge of the swept floor rises by a pixel",
    "Inventor ivview": "an empty window: a single frame",
    "Blender": "balls are rounder",
    "FreeCAD": "its widget is drawn by a context without a window; " + SAME,
    "CloudCompare": "a lit ball that is drawn once; " + SAME, "RepSnapper": "a slice through a ball; " + SAME,
    "view3dscene": FINE, "OpenCSG": "a body of three cylinders; light is smoother, one dark pixel in a hole",
    "OpenUniverse": "the planet's outline is rounder",
    "Critical Mass": MENU, "BZFlag": "hills in the dark; " + SAME, "Lugaru": MENU, "Search and Rescue": MENU,
    "OpenArena": "in play; " + SAME, "OpenArena GL2": "in play; figures are rounder",
    "armagetronad": "its greeting; " + SAME, "zaz": MENU, "brutalchess": "edges of towers catch light, as rounded edges do",
    "dreamchess": MENU, "Freedoom in dsda-doom": "in play; " + SAME, "supertux": "its title; " + SAME,
    "minetest": "in play; " + SAME, "crrcsim": "in play; " + SAME, "transcend": SAME, "cultivation": SAME,
    "extremetuxracer in play": MENU, "torcs": "in play; tyres are round",
    "kubrick": f"faces with a tilted normal stay flat; {SAME}",
    "endgame": SAME, "jigglypuff": FINE, "lament": SAME, "sballs": "balls are round", "pinion": SAME, "engine": "tubes are rounder",
    "cube21": SAME, "peepers": FINE, "headroom": POLYGONS, "handsy": "a grid of lines; " + SAME,
    "lavalite": "highlights on the glass and on the metal cone, as it should be", "juggler3d": "limbs are rounder",
    "glschool": "fish are rounder", "glsnake": SAME, "moebiusgears": SAME, "splodesic": SAME, "topblock": ROUNDER,
    "winduprobot": ROUNDER, "rubik": SAME, "companioncube": ROUNDER, "skytentacles": "arms are rounder, with a thin highlight that counts as strays",
    "hydrostat": ROUNDER,
    "geodesicgears": "a highlight in a hole shows fully", "glhanoi": ROUNDER, "queens": ROUNDER, "sphereeversion": FINE, "vigilance": ROUNDER,
    "torus-trooper": LINES, "tumiki-fighters": SAME, "gunroar": SAME, "titanion": SAME,
    "mu-cade": SAME, "parsec47": LINES, "rrootage": LINES,
    "a7xpg": LINES, "val-and-rick": SAME, "ii-esu": LINES, "projectl": SAME,
}
