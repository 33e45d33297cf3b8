# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Chapter 6 of docs/reference/reproduction.md: table 6.5 and figures 6.7 and 6.8."""
import json
import pathlib
import subprocess

HEAD = "## 6.5: "
NEXT = "## 7.13: "

# Table 6.5: seconds, counts and megabytes of 2007, on a Pentium IV of 3.2 GHz with a Quadro FX 4400.
THESIS = {
    "Omphalos": {"points": 11664466, "simplification": 5, "stripping": 2, "maps": 80, "total": 100, "charts": 1602,
                 "triangles": 45504, "texture_megabytes": 68, "frames": "> 200"},
    "Column": {"points": 22877845, "simplification": 10, "stripping": 4, "maps": 186, "total": 201, "charts": 1721,
               "triangles": 51012, "texture_megabytes": 71, "frames": "> 200"},
}
COLUMNS = {"points": "points", "simplification": "simplification s", "stripping": "surfel stripping s",
           "maps": "normal streaming and reconstruction s", "total": "total s", "charts": "strips, or charts",
           "triangles": "triangles", "texture_megabytes": "textures MB", "frames": "frames/s"}


def of_glark(row: dict) -> dict:
    return {**row, "maps": row["total"] - row["simplification"] - row["stripping"], "frames": "no GPU"}


def shown(value) -> str:
    if isinstance(value, float):
        return f"{value:.1f}" if value < 100 else f"{value:.0f}"
    return str(value)


def table(measured: dict) -> str:
    lines = ["| | " + " | ".join(COLUMNS.values()) + " |", "|---" * (len(COLUMNS) + 1) + "|"]
    for name, row in measured.items():
        for who, values in ((f"{name}, thesis", THESIS[name]), ("as many points, glark", of_glark(row))):
            lines.append(f"| {who} | " + " | ".join(shown(values[key]) for key in COLUMNS) + " |")
    return "\n".join(lines) + "\n"


def pair(figures: pathlib.Path, images: pathlib.Path, name: str) -> None:
    """The coarse mesh and the model with its normal map, side by side, as one JPEG."""
    subprocess.run(["convert", str(figures / f"{name}_plain.png"), str(figures / f"{name}_normal.png"), "+append",
                    "-quality", "85", str(images / f"{name}.jpg")], check=True)


TEXT = """## 6.5: scans as coarse meshes with normal maps
The thesis's models are not public. Here is a generated ball with bumps, of as many points with normals, baked with as many
triangles from a file, in 256 MB of memory. The thesis had a Pentium IV of 3.2 GHz; ours are two cores of the machine above,
which other programs used, too. *Simplification* is `glark sample` with five samples for each triangle, and *surfel stripping*
is `glark strip` of these; both ran on their own. *Normal streaming and reconstruction* is the rest of `glark bake`: it also
simplifies the strips and makes the displacement map.

```
scripts/reproduce --maps         # measures this section only
```

{table}
Our charts are joined strips, so there are fewer. Textures are normal maps without compression, with mipmap levels. They are
as large as `--texture-memory` allows.

## 6.7: without and with the normal map
The happy Buddha's 1.1 million raw scan points, on a reconstruction of 20 000 triangles: {scan_seconds:.1f} s.

![the coarse mesh and the normal map](../images/reproduction/fig6_7.jpg)

## 6.8: surfel strips, and normal surfel strips
The same scan without a reconstruction, as in the thesis: {strip_triangles} triangles of surfel strips through samples.

![surfel strips without and with a normal map](../images/reproduction/fig6_8.jpg)

"""


def section(figures: pathlib.Path, images: pathlib.Path) -> str:
    if not (figures / "maps.json").exists():
        return ""
    measured = json.loads((figures / "maps.json").read_text())
    reports = {name: json.loads((figures / f"{name}.json").read_text()) for name in ("fig6_7", "fig6_8")}
    for name in reports:
        pair(figures, images, name)
    return TEXT.format(table=table(measured), scan_seconds=reports["fig6_7"]["seconds"],
                       strip_triangles=reports["fig6_8"]["triangles"])


def replaced(page: str, maps: str) -> str:
    """The page with another section of chapter 6. The other sections stay as they are."""
    start = page.index(HEAD) if HEAD in page else page.index(NEXT)
    return page[:start] + maps + page[page.index(NEXT):]
