# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Plots the figures that scripts/reproduce measured, and writes docs/reference/reproduction.md."""
import argparse
import csv
import json
import pathlib
import subprocess

import matplotlib
import reproduce_maps

matplotlib.use("Agg")
import matplotlib.pyplot as plot  # noqa: E402

GALLERY = ["knot", "asteroid", "blocks", "goblet"]
EXAMPLES = {
    "qas_surface": "QAS on a mesh that bends (9.5)",
    "scalar_tags": "scalar-tagged PN triangles (7.8, 8)",
    "displacement": "displacement by a height map (7.9, 7.11)",
    "noise_terrain": "procedural displacement (7.10)",
    "waves": "an animated surface whose depths follow it (7.12)",
    "genus_4": "a deformable shape of genus 4 (7.7)",
}


class Figures:
    def __init__(self, folder: pathlib.Path) -> None:
        self.folder = folder
        self.machine = ""

    def rows(self, figure: str) -> list:
        """Returns (name without the figure's name, measured, detail) for each row of a run of glark-bench."""
        report = json.loads((self.folder / f"{figure}.json").read_text())
        self.machine = report["machine"]
        if report["errors"]:
            raise SystemExit(f"reproduce: {figure}: {report['errors']}")
        return [(row["measure"].removeprefix(figure + "/"), row["measured"], row.get("detail", {})) for row in report["rows"]]

    def errors_of_qas(self) -> list:
        with (self.folder / "qas.csv").open() as file:
            return list(csv.DictReader(file))


def table(heads: list, rows: list) -> str:
    lines = ["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def save(axes, path: pathlib.Path) -> None:
    axes.figure.tight_layout()
    axes.figure.savefig(path, dpi=90)
    plot.close(axes.figure)


def new_axes(width: float = 7, height: float = 3.6):
    return plot.subplots(figsize=(width, height))[1]


def adaptive_figure(figures: Figures, images: pathlib.Path) -> str:
    rows = figures.rows("fig7.13")
    axes = new_axes(8, 4)
    for offset, key, label in ((-0.2, "uniform_ms", "uniform (URP)"), (0.2, "adaptive_ms", "adaptive (ARP)")):
        axes.bar([i + offset for i in range(len(rows))], [1000 / detail[key] for _, _, detail in rows], 0.4, label=label)
    axes.set_xticks(range(len(rows)), [name for name, _, _ in rows], rotation=60, ha="right", fontsize=7)
    axes.set_ylabel("frames a second")
    axes.set_yscale("log")
    axes.legend()
    save(axes, images / "fig7_13.png")
    return table(["model, uniform level", "coarse", "uniform triangles", "adaptive triangles", "uniform ms", "adaptive ms", "adaptive is faster by"],
                 [[name, f"{d['coarse_triangles']:.0f}", f"{d['uniform_triangles']:.0f}", f"{d['adaptive_triangles']:.0f}",
                   f"{d['uniform_ms']:.2f}", f"{d['adaptive_ms']:.2f}", f"{measured:.2f}"] for name, measured, d in rows])


def line_figure(figures: Figures, images: pathlib.Path, figure: str, file: str, heads: dict) -> str:
    """heads: the titles of the columns of the detail."""
    rows = figures.rows(figure)
    axes = new_axes()
    axes.plot([d["depth"] for _, _, d in rows], [measured for _, measured, _ in rows], "o-")
    axes.set_xlabel("depth")
    axes.set_ylabel("million refined triangles a second")
    axes.set_ylim(bottom=0)
    axes.grid(alpha=0.3)
    save(axes, images / file)
    return table(["depth", *heads.values(), "M triangles/s"],
                 [[f"{d['depth']:.0f}", *(f"{d[key]:.6g}" for key in heads), f"{measured:.1f}"] for _, measured, d in rows])


def qas_figure(figures: Figures, images: pathlib.Path) -> str:
    rows = figures.errors_of_qas()
    methods = list(dict.fromkeys(row["method"] for row in rows))
    meshes = list(dict.fromkeys(row["mesh"] for row in rows))
    axes = new_axes()
    width = 0.8 / len(methods)
    for i, method in enumerate(methods):
        values = [float(row["position_rms_percent"]) for row in rows if row["method"] == method]
        axes.bar([j + width * (i - (len(methods) - 1) / 2) for j in range(len(values))], values, width, label=method)
    axes.set_xticks(range(len(meshes)), meshes)
    axes.set_yscale("log")
    axes.set_ylabel("RMS, % of the diagonal")
    axes.set_ylim(bottom=1e-4)
    axes.legend(ncol=len(methods), loc="lower center", bbox_to_anchor=(0.5, 1))
    save(axes, images / "qas_errors.png")
    keys = ["position_rms_percent", "position_max_percent", "surface_rms_percent", "normal_rms_degrees", "normal_max_degrees"]
    return table(["mesh", "triangles", "method", "position RMS %", "max %", "distance RMS %", "normal RMS °", "max °"],
                 [[row["mesh"], row["triangles"], row["method"], *(f"{float(row[key]):.4f}" for key in keys)] for row in rows])


def copy_pictures(figures: Figures, images: pathlib.Path) -> tuple:
    """Copies the pictures as JPEG, because nobody compares them byte by byte."""
    def convert(name: str) -> str:
        subprocess.run(["convert", str(figures.folder / f"{name}.png"), "-background", "white", "-flatten", "-resize", "1200x>",
                        "-quality", "88", str(images / f"{name}.jpg")], check=True)
        return f"../images/reproduction/{name}.jpg"

    gallery = "\n".join(f"![{mesh}]({convert('qas_' + mesh)})" for mesh in GALLERY)
    examples = "\n".join(f"`{name}`: {what}\n\n![{name}]({convert(name)})\n" for name, what in EXAMPLES.items())
    return gallery, examples


PAGE = """<!-- SPDX-FileCopyrightText: 2026 The glark authors -->
<!-- SPDX-License-Identifier: MIT -->
<!-- Written by scripts/reproduce; text is in scripts/parts/reproduce.py. -->
# The figures of the thesis, on this machine

```
scripts/reproduce                # measures, draws, plots, and writes this page
```
Figures of Boubekeur 2007. Machine: {machine}. The thesis had a GeForce 8800 GTX; llvmpipe is some hundred times slower, so ratios count.

{maps}
## 7.13: uniform against adaptive refinement
PN triangles; the tags are those at which no segment is longer on the screen than the longest of the uniform level. The thesis found 2.5 to 4.6 times
the frame rate.

![adaptive](../images/reproduction/fig7_13.png)

{adaptive}
## 7.14: a million triangles from coarse meshes of different sizes
Depth 0 is a mesh of a million triangles that is drawn as it is; deeper, the input shrinks to a quarter with each level. *Changes*: the coarse mesh is
captured again in every frame, as an animated mesh is.

![input size](../images/reproduction/fig7_14.png)

{input_size}
## Every depth
Four coarse triangles, to 2048 segments an edge.

![sweep](../images/reproduction/sweep.png)

{sweep}
## 9.4: QAS against curved PN triangles, and Loop's limit surface
Coarse mesh; curved PN triangles; QAS; the limit surface itself. PN and QAS are refined inside OpenGL, to depth 5.

{gallery}

Distances from Loop's limit surface, in percent of the bounding box's diagonal: at equal parameters (position), and to the nearest point (distance).
*Splits 1* is QAS after one more step of the scheme.

![errors](../images/reproduction/qas_errors.png)

{qas}
## Pictures of the examples
{examples}"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--figures", type=pathlib.Path, required=True)
    parser.add_argument("--images", type=pathlib.Path, required=True)
    parser.add_argument("--page", type=pathlib.Path, required=True)
    parser.add_argument("--only-maps", action="store_true", help="writes the section of chapter 6, and leaves the others")
    options = parser.parse_args()
    maps = reproduce_maps.section(options.figures, options.images)
    if options.only_maps:
        options.page.write_text(reproduce_maps.replaced(options.page.read_text(), maps))
        return
    figures = Figures(options.figures)
    adaptive = adaptive_figure(figures, options.images)
    input_size = line_figure(figures, options.images, "fig7.14", "fig7_14.png",
                             {"coarse_triangles": "coarse triangles", "coarse_bytes": "input bytes", "ms": "ms",
                              "ms_of_a_mesh_that_changes": "ms, changes"})
    sweep = line_figure(figures, options.images, "sweep", "sweep.png", {"refined_triangles": "triangles", "ms": "ms"})
    gallery, examples = copy_pictures(figures, options.images)
    options.page.write_text(PAGE.format(machine=figures.machine, adaptive=adaptive, input_size=input_size, sweep=sweep, gallery=gallery,
                                        maps=maps, qas=qas_figure(figures, options.images), examples=examples))
    print(f"{options.page} and {options.images}")


if __name__ == "__main__":
    main()
