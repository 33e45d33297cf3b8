# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Writes what scripts/maps measured into docs/reference/maps.md."""
import json
import pathlib

MARKS = ("<!-- viewers: written by scripts/maps --write -->", "<!-- end of viewers -->")
CANDIDATES = {  # the models that three.js draws: file, and words in the table
    "coarse": "coarse mesh",
    "model": "normal map",
    "displaced": "normal map, displaced",
    "from_fine": "normal map of the fine mesh",
    "from_fine_displaced": "the same, displaced",
}


def table(heads: list, rows: list) -> str:
    lines = ["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def decibels(value: dict) -> list:
    return [f"{value['object']:.1f}", f"{value['inside']:.1f}"]


def best_of_blender(result: dict) -> dict:
    """The bake whose pictures are best, with its decibels as `figures`; {} without any."""
    three = result["three"]["figures"]["reference"]
    bakes = [{**one, "figures": three[one["file"]]} for one in result["reports"].get("blender", [])]
    return max(bakes, key=lambda one: one["figures"]["object"], default={})


def three_table(results: dict) -> str:
    rows = []
    for name, result in results.items():
        for reference, models in result["three"]["figures"].items():
            against = "" if reference == "reference" else ", normals of the points"
            rows += [[name + against, label, *decibels(models[model])]
                     for model, label in CANDIDATES.items() if model in models]
    return table(["three.js", "model", "object dB", "inside dB"], rows)


def viewers_table(results: dict) -> str:
    rows = []
    for name, result in results.items():
        rows += [[name, "f3d", label, *decibels(result["f3d"][model])]
                 for model, label in (("coarse", "coarse mesh"), ("model", "normal map"))]
        rows += [[name, "glark view", maps, *decibels(value)] for maps, value in result["view"].items()]
    return table(["data set", "viewer", "model", "object dB", "inside dB"], rows)


def blender_table(results: dict) -> str:
    rows = []
    for name, result in results.items():
        blender = best_of_blender(result)
        if not blender:
            continue
        three, reports = result["three"]["figures"]["reference"], result["reports"]
        kinds = [("same mesh", "glark bake --mesh", "model")]
        if "fine mesh" in reports:
            kinds = [("same mesh", "glark bake --mesh, of the points", "model"),
                     ("fine mesh", "glark bake --mesh, of the fine mesh", "from_fine")]
        rows += [[name, label, f"{reports[kind]['seconds']:.1f}", f"{reports[kind]['processor_seconds']:.1f}",
                  *decibels(three[model])] for kind, label, model in kinds]
        rows.append([name, f"Blender, extrusion {blender['extrusion']:g} of the diagonal", f"{blender['seconds']:.1f}",
                     f"{blender['processor_seconds']:.1f}", *decibels(blender["figures"])])
    return table(["data set", "baked by", "s", "CPU s", "object dB", "inside dB"], rows) if rows else ""


def write(page: pathlib.Path, results: dict) -> None:
    """results: the figures of each data set."""
    text = page.read_text()
    before, rest = text.split(MARKS[0])
    after = rest.split(MARKS[1])[1]
    body = "\n".join(part for part in (three_table(results), viewers_table(results), blender_table(results)) if part)
    page.write_text(f"{before}{MARKS[0]}\n{body}{MARKS[1]}{after}")


def read(folder: pathlib.Path, names: list) -> dict:
    files = {name: folder / name / "figures.json" for name in names}
    return {name: json.loads(file.read_text()) for name, file in files.items() if file.exists()}
