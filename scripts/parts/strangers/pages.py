# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Pages with WebGL for scripts/strangers: a script of scenes each, with a library of npm, in one file without the network."""
import pathlib
import subprocess

SOURCES = pathlib.Path(__file__).resolve().parent / "pages"
LIBRARIES = ("esbuild", "three", "babylonjs", "playcanvas", "ogl", "plotly.js-gl3d-dist-min", "@kitware/vtk.js", "3dmol", "ngl",
             "@deck.gl/core", "@deck.gl/layers", "@deck.gl/mesh-layers", "x3dom", "p5", "globe.gl", "twgl.js", "regl",
             "bunny", "teapot", "angle-normals", "hilo3d", "pixi.js@5", "pixi3d", "@xeokit/xeokit-sdk")
BUNDLES = ("aframe", "@google/model-viewer")  # they bring what they need
HEAD = '<!doctype html><meta charset="utf-8"><style>body { margin: 0; background: #fff }</style><body>'


def names() -> list:
    return sorted(path.stem for path in SOURCES.glob("*.js") if not path.stem.endswith("_stage"))


def install(npm: pathlib.Path) -> None:
    """Packages of npm that the pages need; no package runs a script of its own."""
    npm.mkdir(parents=True, exist_ok=True)
    subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--ignore-scripts", "--legacy-peer-deps", *LIBRARIES], cwd=npm, check=True)
    for name in BUNDLES:
        packed = subprocess.run(["npm", "pack", "--silent", name], cwd=npm, check=True, stdout=subprocess.PIPE, text=True).stdout.split()[-1]
        target = npm / "node_modules" / name
        target.mkdir(parents=True, exist_ok=True)
        subprocess.run(["tar", "-xzf", str(npm / packed), "--strip-components=1", "-C", str(target)], check=True)


def write_pages(npm: pathlib.Path, folder: pathlib.Path) -> None:
    """Writes folder/NAME.html for each page that is missing or older than its script, if npm has the libraries."""
    tool = npm / "node_modules" / ".bin" / "esbuild"
    folder.mkdir(parents=True, exist_ok=True)
    for name in names() if tool.exists() else ():
        source, page, script = SOURCES / f"{name}.js", folder / f"{name}.html", folder / f"{name}.js"
        if page.exists() and page.stat().st_mtime > source.stat().st_mtime:
            continue
        done = subprocess.run([str(tool), "--bundle", "--format=iife", f"--outfile={script}", "--log-level=error", "--external:fs", "--external:path",
                               "--define:process.env.NODE_ENV='production'", "--define:global=window", str(source)],
                              env={"NODE_PATH": str(npm / "node_modules"), "PATH": "/usr/bin:/bin"}, check=False)
        if done.returncode == 0:
            page.write_text(f'{HEAD}<script src="{name}.js"></script>\n')
