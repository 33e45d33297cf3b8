# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Recordings of OpenGL programs: how scripts/traces and scripts/strangers run, replay and read them."""
import contextlib
import os
import pathlib
import signal
import subprocess

import numpy

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


class Failure(Exception):
    pass


def environment(more: dict) -> dict:
    """Our environment without settings of glark: Mesa's software renderer, full speed, OpenSceneGraph in one small window.

    glretrace shows what no call has drawn yet in its first frame: memory is filled, so that it is the same in all replays.
    """
    kept = {key: value for key, value in os.environ.items() if not key.startswith("GLARK_") and key != "LD_PRELOAD"}
    return dict(kept, LIBGL_ALWAYS_SOFTWARE="1", vblank_mode="0", OSG_WINDOW="0 0 400 300", OSG_THREADING="SingleThreaded",
                SDL_AUDIODRIVER="dummy", MALLOC_PERTURB_="85", **more)


def on_display(command: list, *options: str) -> list:
    return [str(ROOT / "scripts" / "parts" / "with_display"), "--screen", "640x480x24", *options, "--", *command]


def run(command: list, more: dict, log: pathlib.Path, limit: float, **options) -> subprocess.CompletedProcess:
    """Runs a command for at most so many seconds, and ends what it started. Its messages go to the log."""
    with open(log, "wb") as sink:
        process = subprocess.Popen(command, env=environment(more), stdin=subprocess.DEVNULL, stderr=sink, start_new_session=True,
                                   **options)
        try:
            output, _ = process.communicate(timeout=limit)
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    return subprocess.CompletedProcess(command, process.returncode, output)


def read_frames(stream) -> list:
    """Reads the PNM pictures of glretrace -s -."""
    frames = []
    while magic := stream.readline():
        size = stream.readline()
        while size.startswith(b"#"):
            size = stream.readline()
        width, height = (int(word) for word in size.split())
        stream.readline()
        channels = {b"P5\n": 1, b"P6\n": 3}[magic]
        frames.append(numpy.frombuffer(stream.read(width * height * channels), numpy.uint8).reshape(height, width, channels))
    return frames
