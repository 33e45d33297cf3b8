# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The work of scripts/maps: draws baked models in three.js, f3d and glark view, and compares them with the full surface."""
import argparse
import json
import os
import pathlib
import sys

import baking
import camera
import chromium
import gallery
import glb
import pixels
import tables
import viewers
from PIL import Image

PAGE = pathlib.Path("docs/reference/maps.md")
IMAGES = pathlib.Path("docs/images/maps")
LEAST_GAIN = 2  # decibels by which the maps must bring a picture nearer to the full surface, in every viewer


def figures_of(pairs: list) -> dict:
    """pairs: (reference, candidate) of each view."""
    errors = sum((pixels.errors_of(*pair) for pair in pairs), pixels.NO_ERRORS)
    return {"object": pixels.psnr_of_object(errors), "inside": pixels.psnr_inside(errors)}


class Judge:
    def __init__(self, options: argparse.Namespace) -> None:
        self.options = options
        self.faults: list = []

    def models(self) -> list:
        chosen = [one for one in baking.DATA_SETS if not self.options.only or one.name in self.options.only]
        return [baking.Models(one, self.options.glark, self.options.data, self.options.folder) for one in chosen]

    def views(self, models: baking.Models) -> list:
        points = glb.read(models.file("reference")).array("POSITION")
        return [camera.camera_of(points, yaw, camera.PITCH, models.data_set.up) for yaw in camera.YAWS]

    def by_three(self, models: baking.Models, names: list) -> dict:
        """Decibels of each model against each reference. Pictures stay in the folder."""
        files = {name: models.file(name) for name in names if models.file(name).exists()}
        pictures, renderer = chromium.draw(self.options.node_modules / "three", files, self.views(models))
        for (name, number), picture in pictures.items():
            Image.fromarray(picture).save(models.folder / f"three_{name}_{number}.png")
        figures = {}
        for reference in (name for name in files if name.startswith("reference")):
            figures[reference] = {
                name: figures_of([(pictures[reference, i], pictures[name, i]) for i in range(len(camera.YAWS))])
                for name in files if name != reference}
        return {"renderer": renderer, "figures": figures}

    def by_f3d(self, models: baking.Models) -> dict:
        pictures = {name: [viewers.f3d(models.file(name), view) for view in self.views(models)]
                    for name in ("reference", "coarse", "model")}
        return {name: figures_of(list(zip(pictures["reference"], pictures[name], strict=True)))
                for name in ("coarse", "model")}

    def by_glark(self, models: baking.Models) -> dict:
        return {maps: figures_of([viewers.glark_view(self.options.glark, models.file("reference"), models.file("model"),
                                                     maps, yaw, models.data_set.up) for yaw in camera.YAWS])
                for maps in ("plain", "normal", "displaced")}

    def expect_gain(self, viewer: str, coarse: dict, mapped: dict) -> None:
        gain = mapped["object"] - coarse["object"]
        if gain < LEAST_GAIN:
            self.faults.append(f"{viewer}: the maps bring {gain:.2f} dB, expected {LEAST_GAIN} or more")

    def judge(self, models: baking.Models) -> dict:
        name = models.data_set.name
        reports = models.bake()
        (models.folder / "reports.json").write_text(json.dumps(reports))
        if self.options.blender:
            reports["blender"] = models.bake_by_blender(os.cpu_count() or 1)
        result = {"triangles": len(glb.read(models.file("reference")).triangles()), "reports": reports}
        validations = baking.validate(self.options.node_modules, [models.file("model"), models.file("reference")])
        for one in validations:
            if one["errors"]:
                self.faults.append(f"gltf-validator: {one['file']}: {one['messages']}")
        names = ["reference", "reference_normals_of_points", "coarse", "model", "displaced", "from_fine",
                 "from_fine_displaced", *(one["file"] for one in reports.get("blender", []))]
        result["three"] = self.by_three(models, names)
        three = result["three"]["figures"]["reference"]
        self.expect_gain(f"{name}: three.js", three["coarse"], three["model"])
        result["f3d"] = self.by_f3d(models)
        self.expect_gain(f"{name}: f3d", result["f3d"]["coarse"], result["f3d"]["model"])
        result["view"] = self.by_glark(models)
        self.expect_gain(f"{name}: glark view", result["view"]["plain"], result["view"]["normal"])
        return result


def print_figures(name: str, result: dict) -> None:
    print(f"{name}: {result['triangles']} triangles of the full surface; {result['three']['renderer']}")
    rows = {f"three.js, {reference}, {model}": value for reference, models in result["three"]["figures"].items()
            for model, value in models.items()}
    rows |= {f"{viewer}, {model}": value for viewer in ("f3d", "view") for model, value in result[viewer].items()}
    for row, value in rows.items():
        print(f"  {row:60} {value['object']:6.2f} dB, inside {value['inside']:6.2f} dB")
    for kind, report in result["reports"].items():
        for one in report if isinstance(report, list) else [report]:
            print(f"  {kind}: {one['seconds']:.2f} s, {one['processor_seconds']:.2f} s of processors, {one.get('extrusion', '')}")


def main() -> None:
    parser = argparse.ArgumentParser(prog="scripts/maps", description=__doc__)
    parser.add_argument("--glark", type=pathlib.Path, required=True, help="the program")
    parser.add_argument("--node-modules", type=pathlib.Path, required=True, help="has three and gltf-validator")
    parser.add_argument("--data", type=pathlib.Path, default="../shared/data", help="has NAME.ply.zst; default: %(default)s")
    parser.add_argument("--folder", type=pathlib.Path, required=True, help="for models, pictures and figures")
    parser.add_argument("--only", action="append", metavar="NAME", help="this data set; may be given several times")
    parser.add_argument("--install", action="store_true", help="installs what is missing first")
    parser.add_argument("--blender", action="store_true", help="bakes the normal maps with Blender, too")
    parser.add_argument("--gallery", action="store_true", help=f"writes the pictures of {IMAGES}, and no figures")
    parser.add_argument("--write", action="store_true", help=f"writes all figures of the folder into {PAGE}, too")
    options = parser.parse_args()
    judge = Judge(options)
    for models in judge.models():
        if options.gallery:
            models.bake()
            gallery.write_rows(models, IMAGES)
            continue
        result = judge.judge(models)
        (models.folder / "figures.json").write_text(json.dumps(result, indent=1))
        print_figures(models.data_set.name, result)
    if options.write:
        tables.write(PAGE, tables.read(options.folder, [one.name for one in baking.DATA_SETS]))
    for fault in judge.faults:
        print(f"maps: {fault}", file=sys.stderr)
    sys.exit(1 if judge.faults else 0)


if __name__ == "__main__":
    main()
