# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Runs one program with and without the library and judges the results.

  passthrough  without the library, and with it but off: the pictures have the same bytes
  refined      without the library, and refined to level 2 by linear outputs: triangles were refined, the picture stays
  linear       the same, refined by linear inputs
  curved       the same, refined by curved PN triangles: for programs without a surface
  alive        refined only, for programs whose picture moves: triangles were refined, a frame of the screen was captured
  plain        without the library only: the picture is not empty

A program whose executable is missing is skipped (status 77), and fails where CI is set.
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import judge

WITH_DISPLAY = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "parts" / "with_display"
FRAMES = 3
CAPTURED_FRAME = 10
LEVEL = 2
SECONDS = 60  # the longest run of a program that does not end by itself
LIMIT = 120
REFINEMENTS = {"linear": "linear", "curved": "pn"}  # other modes refine by outputs
SKIPPED = 77


class Failure(Exception):
    pass


class Runner:
    def __init__(self, arguments: argparse.Namespace, folder: pathlib.Path) -> None:
        self.arguments_, self.folder_ = arguments, folder

    def picture(self, name: str, library: dict) -> tuple:
        """Runs the program until it ends or its screen settles. Returns the picture and, with the library, the statistics."""
        file = self.folder_ / f"{name}.ppm"
        if self.arguments_.screen:
            display = ["--settled", "--seconds", str(SECONDS), "--screenshot", str(file)]
            statistics = self.run_(name, display, [], library)
        else:
            statistics = self.run_(name, [], [str(FRAMES), str(file)], library)
        if not file.exists():
            raise Failure(f"{name}: the program wrote no picture")
        return judge.read_ppm(file), statistics

    def statistics(self, library: dict) -> dict:
        """Runs the program until it ends or the library has captured a frame. Returns the statistics."""
        if not self.arguments_.screen:
            return self.run_("refined", [], [], library)
        file = self.folder_ / "refined.png"
        library = dict(library, GLARK_CAPTURE=f"{CAPTURED_FRAME}:{file}")
        statistics = self.run_("refined", ["--seconds", str(SECONDS), "--until", str(file)], [], library)
        if not file.exists():
            raise Failure(f"frame {CAPTURED_FRAME} was not captured")
        return statistics

    def run_(self, name: str, display: list, more: list, library: dict) -> dict:
        statistics = self.folder_ / f"{name}.json"
        settings = [f"{key}={value}" for key, value in library.items()]
        if library:
            preloaded = [*self.arguments_.runtime, str(self.arguments_.library)]
            settings += [f"LD_PRELOAD={':'.join(preloaded)}", f"GLARK_STATS={statistics}"]
        command = ["env", *settings, *self.arguments_.program, *more]
        if self.arguments_.screen or self.arguments_.display:
            command = [str(WITH_DISPLAY), "--screen", "400x400x24", *display, "--", *command]
        log = self.folder_ / f"{name}.log"
        with open(log, "w") as sink:
            status = subprocess.run(command, env=environment(), stdin=subprocess.DEVNULL, stdout=sink, stderr=sink,
                                    timeout=LIMIT).returncode
        said = log.read_text(errors="replace")
        if status != 0:
            raise Failure(f"{name}: status {status}\n{said}")
        if self.arguments_.expect and self.arguments_.expect not in said:
            raise Failure(f"{name}: did not print '{self.arguments_.expect}'\n{said}")
        if self.arguments_.forbid and self.arguments_.forbid in said:
            raise Failure(f"{name}: printed '{self.arguments_.forbid}'\n{said}")
        if not library:
            return {}
        if not statistics.exists():
            raise Failure(f"{name}: no statistics; the library was not loaded, or the program did not leave by exit()\n{said}")
        return json.loads(statistics.read_text())


def environment() -> dict:
    """Returns our environment without settings of glark: Mesa's software renderer unless it says otherwise, full speed, OpenSceneGraph in one small window."""
    kept = {key: value for key, value in os.environ.items() if not key.startswith("GLARK_") and key != "LD_PRELOAD"}
    kept.setdefault("LIBGL_ALWAYS_SOFTWARE", "1")  # "0": scripts/drivers judges the graphics card
    return dict(kept, GLARK_CONFIG="/dev/null", vblank_mode="0", OSG_WINDOW="0 0 400 400", OSG_THREADING="SingleThreaded")


def complaints_about(mode: str, runner: Runner) -> list:
    refinement = {"GLARK_ENABLE": "1", "GLARK_WAIT": "1", "GLARK_EVERYTHING": "1", "GLARK_LEVEL": str(LEVEL), "GLARK_REFINE": "outputs"}
    if mode == "alive":
        return judge.life_complaints(runner.statistics(refinement), LEVEL)
    plain, _ = runner.picture("plain", {})
    complaints = judge.picture_complaints(plain)
    if mode == "passthrough":
        passed, statistics = runner.picture("passthrough", {"GLARK_LEVEL": str(LEVEL)})
        complaints += judge.identity_complaints(plain, passed) + judge.off_complaints(statistics)
    elif mode == "measured":
        settings = {"GLARK_ENABLE": "1", "GLARK_WAIT": "1", "GLARK_EDGE_PIXELS": "8", "GLARK_REFINE": "outputs"}
        refined, statistics = runner.picture("measured", settings)
        complaints += judge.likeness_complaints(plain, refined) + judge.measured_complaints(statistics)
    elif mode in ["refined", *REFINEMENTS]:
        refined, statistics = runner.picture("refined", dict(refinement, GLARK_REFINE=REFINEMENTS.get(mode, "outputs")))
        complaints += judge.likeness_complaints(plain, refined) + judge.life_complaints(statistics, LEVEL)
    return complaints


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--mode", choices=["passthrough", "refined", *REFINEMENTS, "measured", "alive", "plain"], required=True)
    parser.add_argument("--library", type=pathlib.Path, help="libGLARK.so")
    parser.add_argument("--runtime", action="append", default=[], help="library to preload before it, of a sanitizer")
    parser.add_argument("--display", action="store_true", help="the program needs an X server, and ends by itself")
    parser.add_argument("--screen", action="store_true", help="the program needs one and is ended; its picture is the screen")
    parser.add_argument("--expect", help="text that the program has to print")
    parser.add_argument("--forbid", help="text that it may not print")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for pictures, statistics and logs")
    parser.add_argument("program", nargs=argparse.REMAINDER, metavar="-- PROGRAM")
    arguments = parser.parse_args()
    arguments.program = arguments.program[1:] if arguments.program[:1] == ["--"] else arguments.program
    if not arguments.program or (arguments.mode != "plain" and not arguments.library):
        parser.error("a program and, but for plain, a --library are needed")

    tools = [arguments.program[0]] + (["Xvfb"] if arguments.screen or arguments.display else [])
    missing = [tool for tool in tools if not shutil.which(tool)]
    if missing:
        print(f"run_client: skipped: {' and '.join(missing)} not installed; run scripts/install_packages", file=sys.stderr)
        return 1 if os.environ.get("CI") else SKIPPED

    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        try:
            complaints = complaints_about(arguments.mode, Runner(arguments, folder))
        except (Failure, ValueError, subprocess.TimeoutExpired) as failure:
            complaints = [str(failure)]
    for complaint in complaints:
        print(f"run_client: {complaint}", file=sys.stderr)
    return 1 if complaints else 0


sys.exit(main())
