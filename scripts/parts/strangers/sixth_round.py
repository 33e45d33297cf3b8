# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The sixth round of scripts/strangers: pages with WebGL and libraries of npm, in Chromium, and Godot."""
import pages
from programs import MODELS, SCENES, Stranger


def page(name: str, seconds: float = 20, frames: int = 80) -> Stranger:
    library, _, what = name.partition("_")
    return Stranger(f"{library}: {what}" if what else library, "page", ("chromium", "npm"),
                    ["/usr/bin/chromium", "--no-sandbox", "--in-process-gpu", "--use-gl=angle", "--use-angle=gl", "--ignore-gpu-blocklist",
                     "--allow-file-access-from-files", "--no-first-run", "--test-type", "--window-size=480,360", f"--user-data-dir={MODELS}/chromium",
                     f"--app=file://{MODELS}/pages/{name}.html"], seconds=seconds, frames=frames)


SLOW = {name: {"seconds": 75, "frames": 40} for name in ("three_physical", "babylon_shadows", "babylon_instances", "3dmol")}
MET_SIXTH = [
    *(page(name, **SLOW.get(name, {})) for name in pages.names()),
    Stranger("Godot", "engine", ("godot3-runner",), ["/usr/bin/godot3-runner", "--audio-driver", "Dummy", "--path", str(SCENES / "godot")], seconds=30, frames=80),
]
