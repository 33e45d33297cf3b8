# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Pictures by f3d and by glark view, from the cameras of camera.py."""
import io
import os
import pathlib
import subprocess
import tempfile

import camera
import numpy
import pixels
from PIL import Image


def read_picture(data: bytes) -> numpy.ndarray:
    """[rows, columns, 4]"""
    return numpy.asarray(Image.open(io.BytesIO(data)).convert("RGBA"))


def f3d(file: pathlib.Path, view: camera.Camera) -> numpy.ndarray:
    """f3d has lights of its own, which stay with the viewer."""
    def words(vector: tuple) -> str:
        return ",".join(f"{value:.9g}" for value in vector)

    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "picture.png"
        subprocess.run(
            ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", "f3d", str(file), "--dry-run", f"--output={out}",
             f"--resolution={camera.WIDTH},{camera.HEIGHT}", "--no-background",
             f"--camera-position={words(view.position)}", f"--camera-focal-point={words(view.target)}",
             f"--camera-view-up={words(view.up)}", f"--camera-view-angle={camera.OPENING_DEGREES}"],
            check=True, capture_output=True)
        return read_picture(out.read_bytes())


def glark_view(glark: pathlib.Path, reference: pathlib.Path, model: pathlib.Path, maps: str, yaw: float,
               up: str) -> tuple:
    """Pictures of the reference and of the model: side by side, so that both have one camera."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "picture.png"
        subprocess.run(
            [str(glark), "view", str(reference), str(model), "--maps", maps, "--offscreen", str(out), "--yaw", str(yaw),
             "--pitch", str(camera.PITCH), "--up", up, "--width", str(2 * camera.WIDTH), "--height", str(camera.HEIGHT)],
            check=True, capture_output=True, env={**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1"})
        both = pixels.with_alpha(read_picture(out.read_bytes())[..., :3])
    return both[:, :camera.WIDTH], both[:, camera.WIDTH:]
