# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The work of scripts/traces: records real programs, replays them without glark, with glark off, and refined by linear outputs.

Off, every byte of every frame must be that of the replay without glark. Refined, at most 0.05 % of the pixels may differ by more
than one of 255 levels, and draws must have been refined. GL errors must be the same in all three.
"""
import argparse
import dataclasses
import json
import pathlib
import re
import shutil
import subprocess
import sys

import numpy

from recording import ROOT, Failure, on_display, read_frames, run
from trace_programs import PROGRAMS, Program

FRAMES = 30
LEVEL = 2
LIMIT = 300             # seconds for one replay
TOLERATED = 0.05 / 100  # share of the pixels
REFINED = {"GLARK_ENABLE": "1", "GLARK_WAIT": "1", "GLARK_LEVEL": str(LEVEL), "GLARK_REFINE": "outputs", "GLARK_EVERYTHING": "1"}
CURVED = {"GLARK_ENABLE": "1", "GLARK_WAIT": "1", "GLARK_LEVEL": "3", "GLARK_REFINE": "pn"}
MARKS = ("<!-- {}: written by scripts/traces --write -->", "<!-- end of {} -->")


def file_of(program: Program, folder: pathlib.Path, suffix: str) -> pathlib.Path:
    return folder / (re.sub(r"[^\w-]", "_", program.name) + suffix)


def record(program: Program, folder: pathlib.Path) -> None:
    """Writes the first frames to NAME.trace. An existing recording is kept, so that replays stay comparable."""
    trace, whole = file_of(program, folder, ".trace"), file_of(program, folder, ".whole")
    if trace.exists():
        return
    command = ["apitrace", "trace", "--api", "egl" if program.egl else "gl", "-o", str(whole), *program.command]
    home = folder / "home"
    home.mkdir(exist_ok=True)
    log = file_of(program, folder, ".record.log")
    run(on_display(command, "--seconds", str(program.seconds)), {"HOME": str(home), **program.environment}, log, LIMIT,
        stdout=subprocess.DEVNULL)
    if not whole.exists():
        raise Failure(f"nothing was recorded; see {log}")
    last = program.first + FRAMES - 1
    aside = trace.with_suffix(".trimmed")
    trimmed = run(["apitrace", "trim", f"--frames=0-{last}", "-o", str(aside), str(whole)], {}, log, LIMIT, stdout=subprocess.DEVNULL)
    whole.unlink()
    if trimmed.returncode != 0:
        raise Failure(f"the recording cannot be trimmed; see {log}")
    aside.rename(trace)


@dataclasses.dataclass
class Replay:
    frames: list
    errors: int  # GL errors
    statistics: dict


def replay(program: Program, folder: pathlib.Path, variant: str, library: dict) -> Replay:
    statistics = file_of(program, folder, f".{variant}.json")
    statistics.unlink(missing_ok=True)
    log, pictures = file_of(program, folder, f".{variant}.log"), file_of(program, folder, f".{variant}.pnm")
    settings = [f"{key}={value}" for key, value in library.items()] + ([f"GLARK_STATS={statistics}"] if library else [])
    command = ["env", *settings, "eglretrace" if program.egl else "glretrace", "--headless", "--singlethread", "-s", "-",
               "--snapshot-format=PNM", str(file_of(program, folder, ".trace"))]
    try:
        with open(pictures, "wb") as sink:
            result = run(on_display(command), {}, log, LIMIT, stdout=sink)
        with open(pictures, "rb") as stream:
            frames = read_frames(stream)[program.first:]
    finally:
        pictures.unlink(missing_ok=True)
    said = log.read_text(errors="replace")
    if result.returncode != 0:
        raise Failure(f"{variant}: status {result.returncode}; see {log}")
    if library and not statistics.exists():
        raise Failure(f"{variant}: no statistics: the library saw no context")
    return Replay(frames, said.count("glGetError("), json.loads(statistics.read_text()) if library else {})


def differing(first: list, second: list, levels: int) -> tuple:
    """Counts the pixels of all frames with a channel that differs by more, and finds the frame with most of them."""
    if [frame.shape for frame in first] != [frame.shape for frame in second]:
        raise Failure("the frames have other numbers or sizes")
    counts = [int((numpy.abs(a.astype(numpy.int16) - b) > levels).any(axis=2).sum()) for a, b in zip(first, second)]
    return sum(counts), int(numpy.argmax(counts)) if counts else 0


def write_ppm(path: pathlib.Path, frame: numpy.ndarray) -> None:
    frame = numpy.repeat(frame, 3, axis=2) if frame.shape[2] == 1 else frame
    path.write_bytes(b"P6\n%d %d\n255\n" % (frame.shape[1], frame.shape[0]) + frame.tobytes())


def write_difference(program: Program, folder: pathlib.Path, plain: numpy.ndarray, other: numpy.ndarray) -> None:
    """Writes three pictures side by side: without glark, with it, and the differences in white."""
    where = (numpy.abs(plain.astype(numpy.int16) - other) > 1).any(axis=2, keepdims=True)
    mask = numpy.repeat(where.astype(numpy.uint8) * 255, plain.shape[2], axis=2)
    write_ppm(file_of(program, folder, ".ppm"), numpy.concatenate([plain, other, mask], axis=1))


def compare(program: Program, folder: pathlib.Path, library: pathlib.Path) -> tuple:
    """Returns a row of the table, and the complaints."""
    preload = {"LD_PRELOAD": str(library)}
    plain = replay(program, folder, "plain", {})
    off = replay(program, folder, "off", preload)
    refined = replay(program, folder, "refined", {**preload, **REFINED})
    if not plain.frames:
        raise Failure("the recording has no frame")
    off_pixels, off_frame = differing(plain.frames, off.frames, 0)
    pixels, frame = differing(plain.frames, refined.frames, 1)
    if off_pixels or pixels:
        worst = (off.frames, off_frame) if off_pixels else (refined.frames, frame)
        write_difference(program, folder, plain.frames[worst[1]], worst[0][worst[1]])
    share = pixels / sum(a.shape[0] * a.shape[1] for a in plain.frames)
    draws = refined.statistics["draws"]
    complaints = []
    if off_pixels:
        complaints.append(f"{off_pixels} pixels differ with glark off, most in frame {off_frame}")
    if share > TOLERATED:
        complaints.append(f"{share:.3%} of the pixels differ refined, most in frame {frame}")
    if not plain.errors == off.errors == refined.errors:
        complaints.append(f"GL errors: {plain.errors}, off {off.errors}, refined {refined.errors}")
    if draws["refined"] == 0:
        complaints.append("no draw was refined")
    causes = ", ".join(f"{count} `{cause}`" for cause, count in draws["passed_through"].items()) or "-"
    row = (program.name, len(plain.frames), draws["seen"], draws["refined"], refined.statistics["coarse_triangles"], causes,
           off_pixels, f"{100 * share:.4f} %")
    return row, complaints


def table(head: tuple, rows: list) -> str:
    lines = ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head), *lines])


def compare_recordings(programs: list, folder: pathlib.Path, library: pathlib.Path) -> tuple:
    head = ("recording", "frames", "draws", "refined", "coarse triangles", "left alone", "off: pixels", "refined: pixels")
    complaints = []
    for program in programs:
        missing = [tool for tool in (program.command[0], "apitrace", "glretrace") if not shutil.which(tool)]
        try:
            if missing:
                raise Failure(f"{missing[0]} is not installed; run scripts/traces --install")
            record(program, folder)
            row, found = compare(program, folder, library)
            file_of(program, folder, ".row").write_text(json.dumps(row))
            print(*row, sep=" | ", flush=True)
        except (Failure, subprocess.TimeoutExpired) as failure:
            found = [str(failure)]
        complaints += [f"{program.name}: {complaint}" for complaint in found]
        for complaint in found:
            print(f"  {complaint}", flush=True)
    rows = [file_of(program, folder, ".row") for program in PROGRAMS]  # earlier runs count, too
    return table(head, [json.loads(row.read_text()) for row in rows if row.exists()]), complaints


def validate_glmark2(folder: pathlib.Path, library: pathlib.Path) -> tuple:
    """Runs every scene with glmark2's own check of its picture."""
    results = {}
    statistics = folder / "glmark2.json"
    variants = {"plain": {}, "off": {"LD_PRELOAD": str(library)}, "refined": {"LD_PRELOAD": str(library), **REFINED}}
    for name, settings in variants.items():
        command = ["env", *(f"{key}={value}" for key, value in settings.items()), f"GLARK_STATS={statistics}", "glmark2", "--validate"]
        said = run(on_display(command), {}, folder / f"glmark2.{name}.log", LIMIT, stdout=subprocess.PIPE).stdout.decode()
        results[name] = re.findall(r"\[(\w+)\] (\S+): *Validation: (\w+)", said)
    rows, complaints = [], []
    for i, (scene, options, verdict) in enumerate(results["plain"]):
        others = [results[name][i][2] if i < len(results[name]) else "-" for name in ("off", "refined")]
        rows.append((scene, f"`{options}`", verdict, *others))
        if any(other != verdict for other in others):
            complaints.append(f"glmark2 {scene} {options}: {verdict}, off {others[0]}, refined {others[1]}")
    if not rows or json.loads(statistics.read_text())["draws"]["refined"] == 0:
        complaints.append("glmark2: no scene was validated, or no draw refined")
    return table(("scene", "options", "without", "off", "refined"), rows), complaints


def write_pictures(programs: list, folder: pathlib.Path, library: pathlib.Path) -> None:
    """Writes folder/programs.png: the last frame of each recording, unrefined and as curved triangles."""
    pairs = []
    for program in programs:
        if not file_of(program, folder, ".trace").exists():
            continue
        plain = replay(program, folder, "plain", {})
        curved = replay(program, folder, "curved", {"LD_PRELOAD": str(library), **CURVED})
        pairs.append(file_of(program, folder, ".pair.ppm"))
        write_ppm(pairs[-1], numpy.concatenate([plain.frames[-1], curved.frames[-1]], axis=1))
    subprocess.run(["montage", *(str(pair) for pair in pairs), "-tile", "4x", "-geometry", "390x150+4+2", "-background", "white",
                    "-colors", "200", str(folder / "programs.png")], check=True)


def write_table(name: str, text: str) -> None:
    page = ROOT / "docs" / "reference" / "traces.md"
    begin, end = (mark.format(name) for mark in MARKS)
    before, _, rest = page.read_text().partition(begin)
    after = rest.partition(end)[2]
    if not after:
        sys.exit(f"traces: {page} has no place for the table {name}")
    page.write_text(f"{before}{begin}\n{text}\n{end}{after}")


def main() -> int:
    parser = argparse.ArgumentParser(prog="scripts/traces", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--library", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--folder", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--only", action="append", default=[], metavar="NAME", help="this program (may be given several times)")
    parser.add_argument("--record", action="store_true", help="make the missing recordings, replay nothing")
    parser.add_argument("--glmark2", action="store_true", help="only glmark2 --validate")
    parser.add_argument("--pictures", action="store_true", help="only write a contact sheet of the recordings, unrefined and refined")
    parser.add_argument("--write", action="store_true", help="put the tables into docs/reference/traces.md")
    arguments = parser.parse_args()
    folder, library = arguments.folder.resolve(), arguments.library.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    programs = [program for program in PROGRAMS if not arguments.only or program.name in arguments.only]
    if not programs:
        parser.error("no such program; the names are: " + ", ".join(program.name for program in PROGRAMS))
    if arguments.record:
        for program in programs:
            try:
                record(program, folder)
            except (Failure, FileNotFoundError, subprocess.TimeoutExpired) as failure:
                print(f"{program.name}: {failure}", file=sys.stderr)
        return 0
    if arguments.pictures:
        write_pictures(programs, folder, library)
        return 0
    complaints = []
    parts = [] if arguments.glmark2 else [("recordings", compare_recordings(programs, folder, library))]
    if arguments.glmark2 or not arguments.only:
        parts.append(("validation", validate_glmark2(folder, library)))
    for name, (text, found) in parts:
        print(f"\n{text}")
        complaints += found
        if arguments.write:
            write_table(name, text)
    for complaint in complaints:
        print(f"traces: {complaint}", file=sys.stderr)
    return 1 if complaints else 0


sys.exit(main())
