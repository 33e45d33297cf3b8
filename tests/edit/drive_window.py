#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Edits a sphere in the editor's window with a real pointer and real keys, and checks the session and the screen.

  drive_window.py GLARK_VIEW [--keep FOLDER]

Runs within scripts/parts/with_display, on a screen of 640 x 480.
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

try:
    import numpy
except ImportError:
    numpy = None

WIDTH, HEIGHT = 640, 480
MIDDLE = (WIDTH // 2, HEIGHT // 2)
DARK = 48  # the background's brightest channel


def screen_shot(file: pathlib.Path) -> "numpy.ndarray":
    subprocess.run(["import", "-window", "root", "-depth", "8", f"rgb:{file}"], check=True)
    return numpy.frombuffer(file.read_bytes(), numpy.uint8).reshape(HEIGHT, WIDTH, 3)


def object_pixels(picture: "numpy.ndarray") -> int:
    return int((picture.max(axis=2) > DARK + 10).sum())


def write_sphere(file: pathlib.Path, count: int) -> None:
    """Points of a unit sphere with normals, in rings from below."""
    height = (2 * numpy.arange(count) + 1) / count - 1
    turn = 2.399963229728653 * numpy.arange(count)
    radius = numpy.sqrt(1 - height * height)
    points = numpy.stack([radius * numpy.cos(turn), radius * numpy.sin(turn), height], axis=1)
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {count}"]
    header += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")] + ["end_header", ""]
    file.write_bytes("\n".join(header).encode() + numpy.hstack([points, points]).astype("<f4").tobytes())


class Editor:
    def __init__(self, view: str, folder: pathlib.Path) -> None:
        self.session, self.messages = folder / "scan.edit", folder / "messages"
        self.process = subprocess.Popen(
            [view, "edit", str(folder / "scan.ply"), "-o", str(folder / "out.ply"), "--target", "6000", "--width", str(WIDTH),
             "--height", str(HEIGHT)], stdout=subprocess.DEVNULL, stderr=self.messages.open("a"))
        found = lambda: subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "glark edit"],
                                       capture_output=True, text=True).stdout.split()
        window = wait_for(lambda: found() or self.process.poll() is not None, "the window")
        check(self.process.poll() is None, f"the editor ended with {self.process.returncode}")
        send("windowfocus", "--sync", window[0])

    def operations(self) -> list:
        """The lines of the log, without their checksums."""
        log = self.session / "log"
        lines = log.read_text().splitlines()[1:] if log.exists() else []
        return [line.split(" ", 1)[1] for line in lines]

    def wait_operations(self, count: int, what: str) -> list:
        wait_for(lambda: len(self.operations()) >= count or self.process.poll() is not None, what)
        check(self.process.poll() is None, f"{what}: the editor ended with {self.process.returncode}")
        return self.operations()

    def stop(self) -> None:
        self.process.kill()
        self.process.wait()


def check_brushes(editor: Editor, folder: pathlib.Path) -> None:
    send("mousemove", 600, 470, "key", "p")  # away from the sphere, and without the panel
    first = wait_until_drawn(folder / "first.rgb")
    send("mousemove", *MIDDLE, "click", 1)
    line = editor.wait_operations(1, "a click with the first brush")[0].split()
    check(line[0] == "inflate", f"the first brush wrote {line}")
    distance = sum(float(value)**2 for value in line[1:4])**0.5
    check(0.9 < distance < 1.1, f"the brush touched a place at {distance} from the centre, not on the sphere")
    send("key", "1", "mousemove", *MIDDLE, "click", 1)
    check(editor.wait_operations(2, "a click with paint")[1].startswith("paint"), "key 1 is not the paint brush")
    wait_for(lambda: is_red(screen_shot(folder / "painted.rgb")), "paint on the screen")

    # A stroke along the sphere is several operations.
    send("mousemove", MIDDLE[0] - 90, MIDDLE[1], "mousedown", 1)
    for step in range(-80, 100, 10):
        send("mousemove", MIDDLE[0] + step, MIDDLE[1])
        time.sleep(0.05)
    send("mouseup", 1)
    count = len(editor.wait_operations(5, "a stroke"))

    send("key", "4", "mousemove", *MIDDLE, "mousedown", 1)
    time.sleep(0.3)
    send("mousemove", MIDDLE[0], MIDDLE[1] - 60)
    time.sleep(0.3)
    send("mouseup", 1)
    moved = editor.wait_operations(count + 1, "a drag with move")[-1]
    check(moved.startswith("move"), f"dragging with move wrote {moved}")
    grabbed = [float(value) for value in moved.split()[1:4]]
    check(all(abs(grabbed[k] - float(line[1 + k])) < 0.2 for k in range(3)), f"move grabbed {grabbed}, not the middle")
    send("key", "p")
    check((first != screen_shot(folder / "moved.rgb")).any(), "the picture is the first one")


def is_red(picture: "numpy.ndarray") -> bool:
    red, green, _ = (int(value) for value in picture[MIDDLE[1] + 4, MIDDLE[0]])
    return red > green + 40


def wait_until_drawn(file: pathlib.Path) -> "numpy.ndarray":
    wait_for(lambda: object_pixels(screen_shot(file)) > 10000, "the sphere on the screen")
    return screen_shot(file)


def check_steps_and_files(editor: Editor, folder: pathlib.Path) -> None:
    count = len(editor.operations())
    send("mousemove", 600, 470, "key", "p", "key", "z")
    check(editor.wait_operations(count + 1, "undo")[-1] == "undo", "key Z does not undo")
    send("key", "y")
    check(editor.wait_operations(count + 2, "redo")[-1] == "redo", "key Y does not redo")
    send("key", "x")
    check(editor.wait_operations(count + 3, "mirror")[-1].startswith("symmetric on"), "key X does not mirror")
    send("key", "ctrl+s")
    wait_for(lambda: (folder / "out.ply").exists(), "Ctrl+S")
    check((folder / "out.ply").stat().st_size >= (folder / "scan.ply").stat().st_size, "the saved scan is too small")
    check((folder / "out.ply").read_bytes()[-24000:] != (folder / "scan.ply").read_bytes()[-24000:], "nothing is edited")


def check_crash(arguments, editor: Editor, folder: pathlib.Path) -> Editor:
    """A killed editor begins where it was."""
    before = editor.operations()
    editor.stop()
    editor = Editor(arguments.view, folder)
    wait_until_drawn(folder / "again.rgb")
    check(editor.operations()[:len(before)] == before, "the log changed at the start")
    send("mousemove", 600, 470, "key", "q")
    check(wait_for(lambda: editor.process.poll() is not None, "the end by Q") and editor.process.returncode == 0,
          f"the editor ended with {editor.process.returncode}")
    return editor


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("view")
    parser.add_argument("--keep", type=pathlib.Path, help="keep pictures and logs in this folder")
    arguments = parser.parse_args()
    missing = [name for name in ("xdotool", "import") if not shutil.which(name)] + ([] if numpy else ["numpy"])
    if missing:
        print(f"drive_window: {', '.join(missing)} not installed", file=sys.stderr)
        return 1 if os.environ.get("CI") else 77
    with tempfile.TemporaryDirectory() as made:
        folder = arguments.keep or pathlib.Path(made)
        folder.mkdir(parents=True, exist_ok=True)
        write_sphere(folder / "scan.ply", 30000)
        editor = None
        try:
            editor = Editor(arguments.view, folder)
            check_brushes(editor, folder)
            check_steps_and_files(editor, folder)
            editor = check_crash(arguments, editor, folder)
        except Failed as problem:
            print(f"drive_window: {problem}\n{editor.messages.read_text() if editor else ''}", file=sys.stderr)
            return 1
        finally:
            if editor:
                editor.stop()
    return 0


if __name__ == "__main__":
    sys.exit(main())
