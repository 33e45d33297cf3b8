# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Small models for the modellers and molecule viewers of scripts/strangers."""
import math
import pathlib

RINGS, SECTORS = 8, 12
ATOMS = [("C", 1.40, 0, 0), ("C", 0.70, 1.21, 0), ("C", -0.70, 1.21, 0), ("C", -1.40, 0, 0), ("C", -0.70, -1.21, 0),
         ("C", 0.70, -1.21, 0), ("H", 2.48, 0, 0), ("H", 1.24, 2.15, 0), ("H", -1.24, 2.15, 0), ("H", -2.48, 0, 0),
         ("O", -1.36, -2.36, 0), ("N", 1.36, -2.36, 0)]
FIREFOX = {  # WebGL although Firefox mistrusts the driver, in the process that apitrace records; no pages of greeting
    "webgl.force-enabled": "true", "webgl.out-of-process": "false", "layers.gpu-process.enabled": "false",
    "gfx.x11-egl.force-enabled": "true", "gfx.webrender.all": "true", "gfx.webrender.software": "false",
    "browser.shell.checkDefaultBrowser": "false", "browser.aboutwelcome.enabled": "false",
    "datareporting.policy.dataSubmissionEnabled": "false", "toolkit.telemetry.reportingpolicy.firstRun": "false",
    "browser.sessionstore.resume_from_crash": "false", "dom.ipc.processCount": "1", "security.sandbox.content.level": "0"}


def ball() -> tuple:
    """A coarse ball of radius 10: points, and triangles of point numbers."""
    points = [(10 * math.sin(math.pi * i / RINGS) * math.cos(2 * math.pi * j / SECTORS),
               10 * math.sin(math.pi * i / RINGS) * math.sin(2 * math.pi * j / SECTORS), 10 * math.cos(math.pi * i / RINGS))
              for i in range(RINGS + 1) for j in range(SECTORS)]
    triangles = []
    for i in range(RINGS):
        for j in range(SECTORS):
            a, b = i * SECTORS + j, i * SECTORS + (j + 1) % SECTORS
            c, d = a + SECTORS, b + SECTORS
            triangles += [(a, c, d)] if i == 0 else [(a, c, b)] if i == RINGS - 1 else [(a, c, d), (a, d, b)]
    return points, triangles


def write_models(folder: pathlib.Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    points, triangles = ball()
    lines = [f"v {x:.4f} {y:.4f} {z:.4f}\nvn {x / 10:.4f} {y / 10:.4f} {z / 10:.4f}" for x, y, z in points]
    lines += ["f " + " ".join(f"{i + 1}//{i + 1}" for i in triangle) for triangle in triangles]
    (folder / "ball.obj").write_text("\n".join(lines) + "\n")
    facets = []
    for triangle in triangles:
        corners = "\n".join("vertex {:.4f} {:.4f} {:.4f}".format(*points[i]) for i in triangle)
        facets.append(f"facet normal 0 0 0\nouter loop\n{corners}\nendloop\nendfacet")
    (folder / "ball.stl").write_text("solid ball\n" + "\n".join(facets) + "\nendsolid ball\n")
    (folder / "ball.wrl").write_text("#VRML V2.0 utf8\nTransform { translation -2 0 0 children Shape { appearance Appearance { "
                                     "material Material { diffuseColor 1 .5 .2 } } geometry Sphere { radius 1.5 } } }\n"
                                     "Transform { translation 2 0 0 children Shape { appearance Appearance { "
                                     "material Material { diffuseColor .2 .5 1 } } geometry Cone { } } }\n")
    (folder / "world").mkdir(exist_ok=True)  # of Minetest
    (folder / "world" / "world.mt").write_text("gameid = minetest_game\nbackend = sqlite3\n")
    (folder / "molecule.xyz").write_text(f"{len(ATOMS)}\nstrangers\n" + "".join(f"{e} {x} {y} {z}\n" for e, x, y, z in ATOMS))
    (folder / "molecule.pdb").write_text("".join(
        f"ATOM  {i:5d}  {e:<3s} MOL A   1    {x:8.3f}{y:8.3f}{z:8.3f}  1.00  0.00           {e}\n"
        for i, (e, x, y, z) in enumerate(ATOMS, 1)) + "TER\n")
    (folder / "history.log").write_text("".join(
        f"{1600000000 + 3600 * i}|author {i % 5}|{'AM'[i % 2]}|folder{i % 7}/part{i % 3}/file{i % 40}.c\n" for i in range(600)))
    (folder / "firefox").mkdir(exist_ok=True)
    (folder / "firefox" / "user.js").write_text("".join(f'user_pref("{key}", {value});\n' for key, value in FIREFOX.items()))
