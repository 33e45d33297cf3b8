# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Draws GLB files with three.js in headless Chromium, with its software renderer (SwiftShader)."""
import functools
import http.server
import json
import math
import os
import pathlib
import subprocess
import tempfile
import threading

import camera
import numpy

HERE = pathlib.Path(__file__).resolve().parent
SAMPLES = 2  # along each side of a pixel
FLAGS = ["--headless=new", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist",
         "--no-first-run", "--disable-extensions", "--disable-background-networking", "--disable-dev-shm-usage"]
# three.js divides by pi, as glTF's reflectance does. The sum of both lights stays below the brightest colour.
LIGHT, AMBIENT = 0.7 * math.pi, 0.12 * math.pi
TYPES = {".js": "text/javascript", ".html": "text/html", ".glb": "model/gltf-binary"}


def average(pixels: bytes, width: int, height: int) -> numpy.ndarray:
    """[height, width, 4], the first row at the top, of samples whose first row is at the bottom."""
    samples = numpy.frombuffer(pixels, numpy.uint8).reshape(height, SAMPLES, width, SAMPLES, 4)[::-1]
    alpha = samples[..., 3:].astype(numpy.float64)
    weight = alpha.sum(axis=(1, 3))
    colours = (samples[..., :3] * alpha).sum(axis=(1, 3)) / numpy.maximum(weight, 1)
    return numpy.rint(numpy.dstack([colours, weight / SAMPLES**2])).astype(numpy.uint8)


class Session:
    """Serves the page, three.js and the models on this machine, and keeps what the page sends back."""

    def __init__(self, three: pathlib.Path, models: dict, job: dict) -> None:
        self.three, self.models, self.job = three, models, job
        self.pictures: dict = {}
        self.renderer = self.failure = ""
        self.is_over = threading.Event()

    def file_of(self, path: str) -> pathlib.Path:
        if path == "/":
            return HERE / "page.html"
        if path.startswith("/models/"):
            return self.models[path.removeprefix("/models/")]
        return self.three / pathlib.PurePosixPath(path.removeprefix("/three/"))

    def receive(self, path: str, body: bytes) -> None:
        if path.startswith("/picture/"):
            _, _, model, number = path.split("/")
            self.pictures[model, int(number)] = average(body, camera.WIDTH, camera.HEIGHT)
            return
        if path == "/done":
            self.renderer = body.decode()
        else:
            self.failure = body.decode()
        self.is_over.set()


class Handler(http.server.BaseHTTPRequestHandler):
    def __init__(self, session: Session, *arguments) -> None:
        self.session = session
        super().__init__(*arguments)

    def answer(self, body: bytes, kind: str = "text/plain") -> None:
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def do_GET(self) -> None:
        if self.path == "/job":
            return self.answer(json.dumps(self.session.job).encode(), "application/json")
        try:
            file = self.session.file_of(self.path)
            return self.answer(file.read_bytes(), TYPES.get(file.suffix, "application/octet-stream"))
        except (KeyError, OSError):
            return self.send_error(404)

    def do_POST(self) -> None:
        self.session.receive(self.path, self.rfile.read(int(self.headers["Content-Length"])))
        self.answer(b"")

    def log_message(self, *_) -> None:
        pass


def job_of(models: dict, views: list) -> dict:
    return {
        "models": list(models), "width": SAMPLES * camera.WIDTH, "height": SAMPLES * camera.HEIGHT,
        "light": LIGHT, "ambient": AMBIENT, "direction_to_light": camera.direction_to_light(),
        "views": [{"position": view.position, "target": view.target, "up": view.up, "near": view.near,
                   "far": view.far, "opening": camera.OPENING_DEGREES} for view in views],
    }


def draw(three: pathlib.Path, models: dict, views: list, seconds: float = 900) -> tuple:
    """Returns {(model, number of the view): [rows, columns, 4]}, and the renderer's name. models: name -> file."""
    session = Session(three, models, job_of(models, views))
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Handler, session))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    sandbox = ["--no-sandbox"] if os.geteuid() == 0 else []
    with tempfile.TemporaryDirectory() as profile:
        browser = subprocess.Popen(
            ["chromium", *FLAGS, *sandbox, f"--user-data-dir={profile}", f"http://127.0.0.1:{server.server_port}/"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={**os.environ, "HOME": profile})
        try:
            in_time = session.is_over.wait(seconds)
        finally:
            browser.terminate()
            browser.wait()
            server.shutdown()
    if session.failure or not in_time:
        raise RuntimeError(f"three.js: {session.failure or f'no answer for {seconds} s'}")
    return session.pictures, session.renderer
