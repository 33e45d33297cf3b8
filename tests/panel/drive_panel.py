#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Opens the panel over a program with real keys and clicks, and checks what the program and the screen get.

  drive_panel.py --client FILE --glark FILE --system glx|egl|wayland [--keep FOLDER]

Runs within scripts/parts/with_display. On Wayland, weston has a window on this display, so the same keys reach it.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))
from driving import Failed, check, send, wait_for  # noqa: E402


def screen_shot(file: pathlib.Path) -> bytes:
    subprocess.run(["import", "-window", "root", f"ppm:{file}"], check=True)
    return file.read_bytes()


class Program:
    """The client, with glark."""

    def __init__(self, arguments, folder: pathlib.Path, options: list, environment: dict) -> None:
        self.log_file, self.messages = folder / "client.log", folder / "messages"
        self.config = folder / "glark.toml"
        if not self.config.exists():
            self.config.write_text("# of the test\n")
        command = [arguments.glark, "run", "--config", self.config, *options, "--", arguments.client, self.log_file]
        self.process = subprocess.Popen([str(word) for word in command], env={**os.environ, **environment},
                                        stderr=self.messages.open("w"))

    def log(self) -> list:
        return self.log_file.read_text().splitlines() if self.log_file.exists() else []

    def frames(self) -> int:
        return sum(line.startswith("frame ") for line in self.log())

    def wait_frames(self, count: int = 6) -> None:
        wanted = self.frames() + count
        wait_for(lambda: self.frames() >= wanted or self.process.poll() is not None, f"{count} more frames")
        check(self.process.poll() is None, f"the program ended with {self.process.returncode}")

    def lines(self, start: str) -> list:
        return [line for line in self.log() if line.startswith(start)]

    def stop(self) -> None:
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()


def start_weston(folder: pathlib.Path) -> tuple:
    """A compositor in a window of the X server. The program has no window decoration, so it begins at the corner."""
    environment = {"XDG_RUNTIME_DIR": str(folder), "WAYLAND_DISPLAY": "glark-test", "SDL_VIDEODRIVER": "wayland"}
    (folder / "weston.ini").write_text("[core]\nidle-time=0\n[keyboard]\nkeymap_layout=us\n")
    folder.chmod(0o700)
    weston = subprocess.Popen(
        ["weston", "--backend=x11-backend.so", "--shell=kiosk-shell.so", "--use-pixman", "--width=720", "--height=720",
         "--socket=glark-test", f"--config={folder}/weston.ini"],
        env={**os.environ, "XDG_RUNTIME_DIR": str(folder)}, stdout=(folder / "weston.log").open("w"),
        stderr=subprocess.STDOUT)
    wait_for(lambda: (folder / "glark-test").exists() or weston.poll() is not None, "weston's socket")
    return weston, environment


def check_panel(program: Program, folder: pathlib.Path, system: str) -> None:
    program.wait_frames(8)
    send("mousemove", 600, 600)
    program.wait_frames()
    closed = screen_shot(folder / "closed.ppm")
    first_pictures = len(program.lines("picture"))

    send("key", "F10")
    program.wait_frames()
    opened = screen_shot(folder / "opened.ppm")
    check(opened != closed, "F10 does not open the panel")
    if system != "wayland":
        check(not program.lines("key"), "the program got the key of the panel")

    # The first box of the panel switches refinement off; the program's picture changes, its state does not.
    send("mousemove", 28, 44, "click", 1)
    program.wait_frames(10)
    screen_shot(folder / "clicked.ppm")
    check(len(program.lines("picture")) > first_pictures, "a click on the box changes nothing")
    if system != "wayland":
        check(not program.lines("click"), "the program got a click on the panel")
    send("mousemove", 28, 44, "click", 1)
    program.wait_frames(10)

    send("mousemove", 590, 590)  # a pointer that enters the window gives SDL no motion there
    send("mousemove", 600, 600, "click", 1)
    program.wait_frames()
    check(len(program.lines("click 600 600")) == 1, "the program did not get a click beside the panel")
    send("key", "F10")
    program.wait_frames(10)
    check(screen_shot(folder / "closed_again.ppm") == closed, "the closed panel leaves something on the screen")
    check(not program.lines("state changes"), f"state: {program.lines('state changes')[:3]}")
    check(not program.lines("error"), f"errors: {program.lines('error')[:3]}")


def check_keys_and_files(program: Program) -> None:
    """The key works without the panel; a changed file and SIGHUP are followed."""
    pictures = len(program.lines("picture"))
    send("key", "F9")
    program.wait_frames(8)
    check(len(program.lines("picture")) == pictures + 1, "--toggle-key changes nothing")
    send("key", "F9")
    program.wait_frames(8)
    pictures = len(program.lines("picture"))
    program.config.write_text("wireframe = true\n")
    wait_for(lambda: len(program.lines("picture")) > pictures, "the changed configuration file")
    pictures = len(program.lines("picture"))
    program.config.write_text("wireframe = false\n")
    program.process.send_signal(1)
    wait_for(lambda: len(program.lines("picture")) > pictures, "the configuration file after SIGHUP")
    program.wait_frames()


def check_film(arguments, folder: pathlib.Path, environment: dict) -> None:
    """--split leaves the left half as it is, and --record makes a film that lasts as long as the program."""
    film, folder = folder / "film.mp4", folder / "recorded"
    folder.mkdir()
    program = Program(arguments, folder, ["--refine", "pn", "--wait", "--split", "--record", film], environment)
    try:
        program.wait_frames(20)
        begin = time.monotonic()
        program.wait_frames(20)
        took = time.monotonic() - begin
    finally:
        program.stop()
    probe = ["ffprobe", "-v", "error", "-show_entries", "stream=width,height,duration", "-of", "csv=p=0", film]
    width, height, duration = subprocess.run(probe, check=True, capture_output=True, text=True).stdout.split(",")
    check((width, height) == ("720", "720"), f"the film has {width} x {height} pixels")
    check(float(duration) >= took, f"the film lasts {duration} s, the program {took} s")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--client", required=True)
    parser.add_argument("--glark", required=True)
    parser.add_argument("--system", choices=["glx", "egl", "wayland"], required=True)
    parser.add_argument("--keep", type=pathlib.Path, help="keep pictures and logs in this folder")
    arguments = parser.parse_args()
    needed = ["xdotool", "import"] + (["weston"] if arguments.system == "wayland" else [])
    if missing := [name for name in needed if not shutil.which(name)]:
        print(f"drive_panel: {', '.join(missing)} not installed", file=sys.stderr)
        return 1 if os.environ.get("CI") else 77
    with tempfile.TemporaryDirectory() as made:
        folder = arguments.keep or pathlib.Path(made)
        folder.mkdir(parents=True, exist_ok=True)
        environment = {"SDL_VIDEODRIVER": "x11"}
        if arguments.system == "egl":
            environment["SDL_VIDEO_X11_FORCE_EGL"] = "1"
        weston, program = None, None
        try:
            if arguments.system == "wayland":
                weston, environment = start_weston(folder)
            options = ["--overlay", "--toggle-key", "F9", "--refine", "pn", "--wait", "--log", "info"]
            program = Program(arguments, folder, options, environment)
            check_panel(program, folder, arguments.system)
            check_keys_and_files(program)
            if arguments.system == "glx" and shutil.which("ffmpeg"):
                program.stop()
                check_film(arguments, folder, environment)
        except Failed as problem:
            messages = program.messages.read_text() if program else ""
            print(f"drive_panel: {arguments.system}: {problem}\n{messages}", file=sys.stderr)
            return 1
        finally:
            if program:
                program.stop()
            if weston:
                weston.terminate()
                weston.wait()
    return 0


sys.exit(main())
