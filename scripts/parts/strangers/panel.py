# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""scripts/strangers --panel: does the panel of glark run --overlay break a program? It is open from the first frame on.

Two answers a program. Its recording is replayed refined, with the panel closed and open: the frames must have the same
pixels. And the program itself runs with the panel: it must live as long as it was recorded, and show the panel.
"""
import pathlib
import subprocess

import numpy

from recording import on_display, read_frames, run

CLOSED = {"GLARK_OVERLAY": "1", "GLARK_LOG": "info", "GLARK_CONFIG": "/dev/null"}
OPEN = {**CLOSED, "GLARK_OVERLAY_OPEN": "1"}
LEFT, TOP, WIDTH = 10, 10, 390  # where the panel opens; it may be as high as the window
TITLE = (41, 74, 122)           # the colour of its title
TITLE_PIXELS = 1000
PROBLEMS = ("error", "the panel is closed", "the panel cannot be shown", "gives no keys")


def different(closed: list, opened: list) -> tuple:
    """How many pixels of the worst frame differ beside the place of the panel, and in it."""
    beside = within = 0
    for first, second in zip(closed, opened, strict=True):
        changed = (first != second).any(axis=2)
        place = changed[TOP:, LEFT:LEFT + WIDTH]
        within = max(within, int(place.sum()))
        beside = max(beside, int(changed.sum() - place.sum()))
    return beside, within


def shows_panel(picture: numpy.ndarray) -> bool:
    return int((picture == TITLE).all(axis=2).sum()) >= TITLE_PIXELS


def problems_of(log: pathlib.Path) -> list:
    """Lines of glark's that tell of trouble with the panel."""
    lines = log.read_text(errors="replace").splitlines()
    return [line for line in lines if line.startswith("glark:") and any(word in line for word in PROBLEMS)]


def opened(log: pathlib.Path) -> bool:
    return "the panel is open" in log.read_text(errors="replace")


def run_live(command: list, environment: dict, files: tuple, seconds: float) -> str:
    """Runs the program on a display of its own. Returns why it failed, or nothing."""
    screen, log = files
    try:
        result = run(on_display(command, "--seconds", str(seconds), "--screenshot", str(screen)), environment, log, seconds + 120,
                     stdout=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        return "did not end"
    return f"status {result.returncode}; see {log}" if result.returncode != 0 else ""


def run_with_panel(command: list, environment: dict, settings: dict, files: tuple, seconds: float) -> dict:
    """Runs the program with the panel, and says what it showed at the end. `files`: a picture and a log.

    A program that fails without glark, too, is left out.
    """
    screen, log = files
    words = ["env", *(f"{key}={value}" for key, value in {**settings, **OPEN}.items()), *command]
    if failure := run_live(words, environment, files, seconds):
        alone = run_live(command, environment, (screen, log.with_suffix(".alone.log")), seconds)
        return {"left_out": "fails without glark, too"} if alone else {"failure": failure}
    with open(screen, "rb") as stream:
        picture = read_frames(stream)[0]
    return {"picture": picture, "shown": shows_panel(picture), "opened": opened(log), "problems": problems_of(log)}


def is_healthy(result: dict) -> bool:
    return (not result.get("failure") and result["replayed"] and result["beside"] == 0 and result["shown"]
            and not result["problems"])


def summary(results: list) -> str:
    """One sentence, and one line for each program that is not healthy."""
    left_out = [result["name"] for result in results if "left_out" in result]
    results = [result for result in results if "left_out" not in result]
    healthy = [result for result in results if is_healthy(result)]
    same = sum(result.get("within") == 0 for result in healthy)
    lines = [f"panel: {len(healthy)} of {len(results)} programs run with the panel open and draw the same pixels beside it; "
             f"{same} draw the same pixels under it, too."]
    if left_out:
        lines.append(f"  left out, because they fail without glark, too: {', '.join(left_out)}")
    for result in results:
        if not is_healthy(result):
            lines.append(f"  {result['name']}: " + (result.get("failure") or "; ".join(
                [f"{result['beside']} pixels beside the panel differ"] * (result["beside"] > 0)
                + ["the panel was not open in the replay"] * (not result["replayed"])
                + ["the panel is not on the screen"] * (not result["shown"]) + result["problems"])))
    return "\n".join(lines)
