# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Runs the programs of scripts/demo unrefined, refined and as wireframe."""
import argparse
import dataclasses
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys

import picture_row

ROOT = pathlib.Path(__file__).resolve().parents[2]
LEVEL = 3      # every triangle becomes 64
SECONDS = 90   # the longest run of a program that waits for its user
FRAMES = 12    # of a program that ends by itself; the first ones compile shaders, so there must be more for a median
LIMIT = 120    # seconds after which a program counts as hanging


@dataclasses.dataclass
class Program:
    name: str
    command: list
    environment: dict = dataclasses.field(default_factory=dict)
    needs_display: bool = True
    refine: str = "linear"
    frame: int = 30            # the captured frame; programs that move by the clock are captured at their start
    ends: bool = False         # ends by itself; the others are closed when their picture is written
    knows_glark: bool = False  # calls the API, writes its picture itself


def write_knot(path: pathlib.Path, along: int = 24, around: int = 6, thickness: float = 0.8) -> None:
    """Writes a trefoil knot of 288 triangles with smooth normals; curved refinement makes it round."""
    def centre(t: float) -> tuple:
        return math.sin(t) + 2 * math.sin(2 * t), math.cos(t) - 2 * math.cos(2 * t), -math.sin(3 * t)

    def direction(a: tuple) -> tuple:
        length = math.sqrt(sum(x * x for x in a))
        return tuple(x / length for x in a)

    def cross(a: tuple, b: tuple) -> tuple:
        return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]

    lines = ["mtllib knot.mtl", "usemtl knot"]
    for i in range(along):
        t = 2 * math.pi * i / along
        here, ahead = centre(t), centre(t + 0.01)
        tangent = direction(tuple(a - h for a, h in zip(ahead, here)))
        side = direction(cross(tangent, (0, 0, 1)))
        up = cross(side, tangent)
        for j in range(around):
            angle = 2 * math.pi * j / around
            normal = tuple(math.cos(angle) * s + math.sin(angle) * u for s, u in zip(side, up))
            x, y, z = (h + thickness * n for h, n in zip(here, normal))
            lines += [f"v {x:.5f} {y:.5f} {z:.5f}", "vn {:.5f} {:.5f} {:.5f}".format(*normal)]
    corner = [[1 + i % along * around + j % around for j in range(around + 1)] for i in range(along + 1)]
    for i in range(along):
        for j in range(around):
            a, b, c, d = corner[i][j], corner[i][j + 1], corner[i + 1][j + 1], corner[i + 1][j]
            lines += [f"f {a}//{a} {c}//{c} {b}//{b}", f"f {a}//{a} {d}//{d} {c}//{c}"]  # seen from outside: counterclockwise
    path.write_text("\n".join(lines) + "\n")
    path.with_suffix(".mtl").write_text("newmtl knot\nKa 0.2 0.15 0.1\nKd 0.9 0.6 0.3\nKs 0.5 0.5 0.5\nNs 30\n")


def write_models(out: pathlib.Path) -> None:
    """Writes the knot, and a folder of data for glmark2 that has the knot among the models."""
    write_knot(out / "knot.obj")
    models = out / "glmark2" / "models"
    models.mkdir(parents=True, exist_ok=True)
    installed = pathlib.Path("/usr/share/glmark2")
    links = {models / "knot.obj": out / "knot.obj", models / "horse.3ds": installed / "models" / "horse.3ds"}
    links.update({out / "glmark2" / name: installed / name for name in ("shaders", "textures")})
    for link, target in links.items():
        link.unlink(missing_ok=True)
        link.symlink_to(target)


def antialiasing(glmark2: list) -> list:
    """Returns the options for a multisampled window. The X server of Debian 13 has none; then pictures have jagged outlines."""
    options = ["--visual-config", "samples=4"]
    with_display = [str(ROOT / "scripts" / "parts" / "with_display"), "--seconds", str(SECONDS), "--"]
    tried = subprocess.run([*with_display, *glmark2, *options, "--benchmark", f"build:duration={LIMIT}:nframes=1"], stdin=subprocess.DEVNULL,
                           env={**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1"}, capture_output=True, text=True, timeout=LIMIT)
    return [] if "FB config" in tried.stdout + tried.stderr else options


def programs(build: pathlib.Path, out: pathlib.Path) -> list:
    """Returns the programs to show. OpenSceneGraph needs a hundred packages, so its programs are shown only if it is installed."""
    osg = {"OSG_WINDOW": "0 0 640 480", "OSG_THREADING": "SingleThreaded", "OSG_NOTIFY_LEVEL": "ALWAYS"}
    glmark2 = ["glmark2", "--data-path", str(out / "glmark2"), "--size", "520x520"]
    glmark2 += [*antialiasing(glmark2), "--benchmark"]
    ending = f"duration={LIMIT}:nframes={FRAMES}"
    found = [
        Program("glxgears", ["glxgears"], {"vblank_mode": "0"}),
        Program("horse", [*glmark2, f"build:model=horse:{ending}"], {"vblank_mode": "0"}, frame=1, ends=True),
        Program("knot", [*glmark2, f"shading:shading=phong:num-lights=8:model=knot:{ending}"], {"vblank_mode": "0"}, refine="pn",
                frame=1, ends=True),
        Program("osgshape", ["osgshape"], osg),
        Program("osgviewer", ["osgviewer", str(out / "knot.obj")], osg, refine="pn"),
        Program("ten_lines", [str(build / "bin" / "ten_lines")], needs_display=False, knows_glark=True),
    ]
    return [program for program in found if not program.name.startswith("osg") or shutil.which(program.name)]


def run_variant(program: Program, variant: str, build: pathlib.Path, out: pathlib.Path) -> dict:
    """Runs a program as one variant: off, refined or wireframe. Writes out/NAME-VARIANT.png and .json, returns the statistics."""
    picture, statistics = (out / f"{program.name}-{variant}{suffix}" for suffix in (".png", ".json"))
    for file in (picture, statistics):
        file.unlink(missing_ok=True)
    environment = {key: value for key, value in os.environ.items() if not key.startswith("GLARK_")}
    environment.update(program.environment, LIBGL_ALWAYS_SOFTWARE="1")
    command = list(program.command)
    if program.knows_glark:
        # Linked to the library, so nothing is preloaded. It takes the path of its picture and the depth of its tags (0: unrefined).
        command += [str(picture), "0" if variant == "off" else str(LEVEL)]
        command += ["wireframe"] if variant == "wireframe" else []
        environment["GLARK_STATS"] = str(statistics)
    elif variant == "off":
        # The library passes every call through, but captures and times the frames as it does when it refines.
        command = ["env", f"LD_PRELOAD={build / 'lib' / 'libGLARK.so'}", f"GLARK_CAPTURE={program.frame}:{picture}",
                   f"GLARK_STATS={statistics}", *command]
    else:
        wireframe = ["--wireframe"] if variant == "wireframe" else []
        command = [str(build / "bin" / "glark"), "run", "--level", str(LEVEL), "--refine", program.refine,
                   "--capture", f"{program.frame}:{picture}", "--stats", str(statistics), *wireframe, "--", *command]
    if program.needs_display:
        until = [] if program.ends else ["--until", str(picture)]
        command = [str(ROOT / "scripts" / "parts" / "with_display"), "--seconds", str(SECONDS), *until, "--", *command]

    log = out / f"{program.name}-{variant}.log"
    with open(log, "w") as sink:
        try:
            status = subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, stdout=sink, stderr=sink,
                                    timeout=LIMIT).returncode
        except subprocess.TimeoutExpired:
            sys.exit(f"demo: {program.name} ({variant}) did not end within {LIMIT} s; see {log}")
    if status != 0:
        sys.exit(f"demo: {program.name} ({variant}) ended with status {status}; see {log}:\n{log.read_text()[-2000:]}")
    for file in (picture, statistics):
        if not file.exists() or file.stat().st_size == 0:
            sys.exit(f"demo: {program.name} ({variant}) wrote no {file.name}; see {log}:\n{log.read_text()[-2000:]}")
    return json.loads(statistics.read_text())


def per_frame(statistics: dict, key: str) -> str:
    return f"{round(statistics[key] / max(1, statistics['frames']))}"


def frame_time(statistics: dict) -> str:
    """The first frames compile shaders, so a program of few frames has no time."""
    median = (statistics.get("frame_ms") or {}).get("median") if statistics["frames"] > 4 else None
    return f"{median:.2f} ms" if median else "-"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="folder of the built preset")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out"))
    parser.add_argument("--only", action="append", help="name of a program to show; may be repeated; without it, all are shown")
    arguments = parser.parse_args()
    build, out = arguments.build.resolve(), arguments.out.resolve()
    out.mkdir(parents=True, exist_ok=True)

    write_models(out)
    rows = [("program", "coarse triangles", "refined triangles", "frame time off", "frame time refined")]
    for program in programs(build, out):
        if arguments.only and program.name not in arguments.only:
            continue
        off, refined, wireframe = (run_variant(program, variant, build, out) for variant in ("off", "refined", "wireframe"))
        for statistics in (refined, wireframe):
            if statistics["refined_triangles"] == 0:
                sys.exit(f"demo: {program.name} was not refined: {json.dumps(statistics['draws'])}")
        picture_row.join([out / f"{program.name}-{variant}.png" for variant in ("off", "refined", "wireframe")],
                         out / f"{program.name}.png")
        rows.append((program.name, per_frame(refined, "coarse_triangles"), per_frame(refined, "refined_triangles"),
                     frame_time(off), frame_time(refined)))
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    print(f"\nLevel {LEVEL}, triangles per frame, median frame times. Pictures and statistics are in {arguments.out}/: NAME.png shows\n"
          "a program unrefined, refined and as wireframe.\n")
    for row in rows:
        print("  " + "  ".join(cell.ljust(width) if i == 0 else cell.rjust(width)
                               for i, (cell, width) in enumerate(zip(row, widths))))


main()
