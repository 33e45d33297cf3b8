# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Opens the window of lesson 1 on an X server of its own, and presses keys: check_window.py PROGRAM."""
import pathlib
import subprocess
import sys
import time

WITH_DISPLAY = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "parts" / "with_display"
TITLE = "Lesson 1"
SECONDS = 60


def xdotool(*words) -> str:
    return subprocess.run(["xdotool", *words], capture_output=True, text=True).stdout.strip()


def wait_for(what: str, found) -> str:
    end = time.monotonic() + SECONDS
    while time.monotonic() < end:
        if result := found():
            return result
        time.sleep(0.1)
    sys.exit(f"check_window: waited in vain for {what}")


def press_keys(program: str) -> int:
    """Runs on the display."""
    refused = subprocess.run([program, "--press", "~"], capture_output=True, text=True, timeout=SECONDS)
    if refused.returncode != 1 or "there is no key ~" not in refused.stderr:
        sys.exit(f"check_window: a key that the lesson does not have is not told: {refused.stderr}")
    lesson = subprocess.Popen([program], stdout=subprocess.DEVNULL)
    try:
        window = wait_for("a window", lambda: xdotool("search", "--name", TITLE).partition("\n")[0])
        wait_for("the first frame", lambda: xdotool("getwindowname", window).endswith("depth 0: 1 triangle"))
        xdotool("windowfocus", "--sync", window)
        for key, title in (("d", "depth 1: 4 triangles"), ("d", "depth 2: 16 triangles"),
                           ("s", "depth 1: 4 triangles")):
            xdotool("key", key)
            wait_for(title, lambda: title in xdotool("getwindowname", window))
        xdotool("key", "q")
        return lesson.wait(SECONDS)
    finally:
        lesson.kill()


if sys.argv[1] == "--here":
    sys.exit(press_keys(sys.argv[2]))
again = [sys.executable, __file__, "--here", sys.argv[1]]
sys.exit(subprocess.run([sys.executable, WITH_DISPLAY, "--", *again]).returncode)
