# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The work of scripts/strangers: records programs in use, replays them plain, off and refined, and counts what looks broken.

A program that is installed is recorded once, by apitrace and without glark. Four frames of the second half are compared.
A program that was judged is skipped until the library or the rules of the numbers change, or --only names it.
"""
import argparse
import concurrent.futures
import dataclasses
import functools
import hashlib
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import textwrap
import time

import numpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent))
import breakage
import contact_sheet
import pages
import panel
from recording import Failure, on_display, read_frames, run
from models import write_models
from refined_share import life, percent, share_text
import programs
from programs import MODELS, Stranger
from sixth_round import MET_SIXTH
from remarks import REMARKS

ROOT = HERE.parent.parent.parent
PROGRAMS = [*programs.PROGRAMS, *MET_SIXTH]
LEVEL = 2
NUMBERS = ("vanished", "appeared", "stripes", "strays", "thin")
MARKS = ("<!-- programs: written by scripts/strangers --write -->", "<!-- end of programs -->")


def file_of(program: Stranger, folder: pathlib.Path, suffix: str) -> pathlib.Path:
    return folder / (re.sub(r"[^\w-]", "_", program.name) + suffix)


def with_keys(program: Stranger, command: list) -> list:
    """A shell command that runs the program, and beside it presses keys after so many seconds each."""
    presses = "; ".join(f"sleep {seconds}; xdotool {action}" for seconds, action in program.keys)
    return ["sh", "-c", f"({presses}) >/dev/null 2>&1 & exec {shlex.join(command)}"] if presses else command


def frame_calls(trace: pathlib.Path) -> list:
    """The numbers of the calls that end a frame."""
    dump = subprocess.run(["apitrace", "dump", "--color=never", "--calls=*/frame", str(trace)], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, check=False).stdout.decode(errors="replace")
    return [int(line.split()[0]) for line in dump.splitlines() if re.match(r"\d+ \w+Swap\w*Buffers\w*\(", line)]


def compared(program: Stranger, calls: list) -> list:
    """Four frames of the second half; the last one may be cut short by the end of the recording."""
    kept = calls[:program.frames][:-1] or calls
    return sorted({kept[int(share * (len(kept) - 1))] for share in (0.55, 0.7, 0.85, 1)})


def record(program: Stranger, folder: pathlib.Path, slow: float) -> list:
    """Writes NAME.trace, unless it exists, and returns the calls of the compared frames."""
    trace, whole, calls = (file_of(program, folder, suffix) for suffix in (".trace", ".whole", ".calls"))
    if not trace.exists():
        home = folder / "home"
        home.mkdir(exist_ok=True)
        words = [word.replace(MODELS, str(folder / "models")) for word in program.command]
        missing = [page for page in re.findall(r"file://(\S+)", " ".join(words)) if not pathlib.Path(page).exists()]
        if missing:
            raise Failure(f"no page {missing[0]}; --install makes it")
        command = ["apitrace", "trace", "--api", "egl" if program.egl else "gl", "-o", str(whole), *words]
        log = file_of(program, folder, ".record.log")
        run(on_display(with_keys(program, command), "--seconds", str(program.seconds * slow), "--screenshot",
                       str(file_of(program, folder, ".ppm"))),
            {"HOME": str(home), "PATH": "/usr/games:/usr/bin:/bin", **program.environment}, log, 300, cwd=home, stdout=subprocess.DEVNULL)
        if not whole.exists():
            raise Failure(f"nothing was recorded; see {log}")
        found = frame_calls(whole)
        if not found:
            whole.unlink()
            raise Failure(f"the recording has no frame; see {log}")
        chosen = compared(program, found)
        trimmed = subprocess.run(["apitrace", "trim", f"--calls=0-{chosen[-1]}", "-o", str(trace.with_suffix(".new")), str(whole)],
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        whole.unlink()
        if trimmed.returncode != 0:
            raise Failure("the recording cannot be trimmed")
        calls.write_text(json.dumps(chosen))
        trace.with_suffix(".new").rename(trace)
    return json.loads(calls.read_text())


@dataclasses.dataclass
class Replay:
    frames: list
    statistics: dict


def replay(program: Stranger, folder: pathlib.Path, variant: str, library: dict, limit: float) -> Replay:
    calls = json.loads(file_of(program, folder, ".calls").read_text())
    statistics, log, pictures = (file_of(program, folder, f".{variant}{suffix}") for suffix in (".json", ".log", ".pnm"))
    statistics.unlink(missing_ok=True)
    settings = [f"{key}={value}" for key, value in library.items()] + ([f"GLARK_STATS={statistics}"] if library else [])
    command = ["env", *settings, "eglretrace" if program.egl else "glretrace", "--headless", "--singlethread", "-s", "-",
               "--snapshot-format=PNM", "-S", ",".join(map(str, calls)), str(file_of(program, folder, ".trace"))]
    try:
        with open(pictures, "wb") as sink:
            result = run(on_display(command), {}, log, limit, stdout=sink)
        with open(pictures, "rb") as stream:
            frames = read_frames(stream)
    except subprocess.TimeoutExpired:
        raise Failure(f"{variant}: not done after {limit:.0f} seconds") from None
    finally:
        pictures.unlink(missing_ok=True)
    if result.returncode != 0:
        raise Failure(f"{variant}: status {result.returncode}; see {log}")
    if library and not statistics.exists():
        raise Failure(f"{variant}: no statistics: the library saw no context")
    return Replay([numpy.repeat(frame, 3, axis=2) if frame.shape[2] == 1 else frame for frame in frames],
                  json.loads(statistics.read_text()) if library else {})


def is_blank(frame: numpy.ndarray) -> bool:
    """Whether nearly every pixel has the same colour."""
    _, counts = numpy.unique(frame.reshape(-1, 3), axis=0, return_counts=True)
    return counts.max() > 0.997 * counts.sum()


def off_pixels(plain: list, off: list) -> int:
    return sum(int((first != second).any(axis=2).sum()) for first, second in zip(plain, off))


def judge(plain: list, refined: list, allowance) -> tuple:
    """The numbers, each of its worst frame, the share of changed pixels, and the masks of the worst frame."""
    found = [breakage.breakage(first, second, allowance(*first.shape[1::-1])) for first, second in zip(plain, refined)]
    counts = [one.counts() for one in found]
    worst = max(range(len(found)), key=lambda i: (sum(counts[i]), i))
    changed = max(float((breakage.difference(a, b) > 8).mean()) for a, b in zip(plain, refined))
    return [max(column) for column in zip(*counts)], changed, worst, found[worst]


@functools.cache
def build_of(library: pathlib.Path) -> str:
    """Names what a result depends on: the library, and the rules of the numbers."""
    parts = (library, pathlib.Path(breakage.__file__))
    return hashlib.sha256(b"".join(part.read_bytes() for part in parts)).hexdigest()[:12]


def settings_of(mode: str, library: pathlib.Path) -> dict:
    return {"LD_PRELOAD": str(library), "GLARK_ENABLE": "1", "GLARK_WAIT": "1", "GLARK_LEVEL": str(LEVEL), "GLARK_REFINE": mode}


def examine(program: Stranger, folder: pathlib.Path, arguments: argparse.Namespace) -> dict:
    """Replays the recording of one program, and returns what the table needs. Writes its row of the contact sheet."""
    library = arguments.library
    plain = replay(program, folder, "plain", {}, arguments.limit)
    if not plain.frames:
        raise Failure("the recording has no frame")
    if all(is_blank(frame) for frame in plain.frames):
        raise Failure("the recording shows nothing")
    off = replay(program, folder, "off", {"LD_PRELOAD": str(library)}, arguments.limit)
    result = {"frames": len(plain.frames), "off": off_pixels(plain.frames, off.frames), "modes": {}}
    shown = [("plain", plain.frames[-1], None), ("off", off.frames[-1], None)]
    compared = plain.frames[-1]
    for mode in arguments.modes:
        allowance = breakage.exact if mode in ("linear", "outputs") else breakage.curved
        try:
            refined = replay(program, folder, mode, settings_of(mode, library), arguments.limit)
            numbers, changed, worst, masks = judge(plain.frames, refined.frames, allowance)
        except Failure as failure:
            result["modes"][mode] = {"failure": str(failure)}
            continue
        result["modes"][mode] = {"numbers": numbers, "changed": changed, **life(refined.statistics)}
        if sum(numbers):
            shown.append((f"plain {worst}", plain.frames[worst], None))
        compared = plain.frames[worst if sum(numbers) else -1]
        shown.append((f"{mode} {numbers}", refined.frames[worst if sum(numbers) else -1], masks))
    contact_sheet.write_row(file_of(program, folder, ".png"), program.name, shown, compared)
    return result


def examine_panel(program: Stranger, folder: pathlib.Path, arguments: argparse.Namespace) -> dict:
    """Compares the program's frames with the panel open and closed, and runs the program with the panel."""
    settings = settings_of("smooth", arguments.library)
    frames = {}
    for variant, more in (("closed", panel.CLOSED), ("open", panel.OPEN)):
        frames[variant] = replay(program, folder, variant, {**settings, **more}, arguments.limit).frames
    beside, within = panel.different(frames["closed"], frames["open"])
    home = folder / "home"
    environment = {"HOME": str(home), "PATH": "/usr/games:/usr/bin:/bin", **program.environment}
    command = with_keys(program, [word.replace(MODELS, str(folder / "models")) for word in program.command])
    live = panel.run_with_panel(command, environment, settings,
                                (file_of(program, folder, ".panel.ppm"), file_of(program, folder, ".live.log")),
                                program.seconds * arguments.slow)
    pictures = [("closed", frames["closed"][-1], None), ("open, before the panel", frames["open"][-1], None)]
    if "picture" in live:
        pictures.append(("on the screen", live.pop("picture"), None))
    contact_sheet.write_row(file_of(program, folder, ".panel.png"), program.name, pictures)
    return {"beside": beside, "within": within, "replayed": panel.opened(file_of(program, folder, ".open.log")), **live}


def judge_panel(arguments: argparse.Namespace) -> int:
    """The work of --panel. Results are apart from those of the numbers."""
    chosen = [program for program in PROGRAMS if installed(program) and (not arguments.only or program.name in arguments.only)]
    results = []
    for program in chosen:
        result = {"name": program.name}
        try:
            record(program, arguments.folder, arguments.slow)
            result |= examine_panel(program, arguments.folder, arguments)
        except (Failure, subprocess.TimeoutExpired) as failure:
            result["failure"] = str(failure)
        results.append(result)
        print(result, flush=True)
    rows = [file_of(program, arguments.folder, ".panel.png") for program in chosen]
    contact_sheet.join([row for row in rows if row.exists()], arguments.folder, "panel")
    print(panel.summary(results))
    return 0 if all("left_out" in result or panel.is_healthy(result) for result in results) else 1


def row_of(result: dict) -> list:
    """A row of the table: one program."""
    cells = [result["name"], result["kind"], result.get("off", "-")]
    for mode in result.get("modes", {}).values():
        cells += [mode["failure"]] if "failure" in mode else [" ".join(map(str, mode["numbers"]))]
    lives = [mode for mode in result.get("modes", {}).values() if "draws" in mode]
    if not lives:
        return cells + [result.get("failure", "-")]
    last = lives[-1]
    left = ", ".join(f"{count} `{cause}`" for cause, count in last["causes"].items()) or "-"
    in_half, refined_in_half = last.get("settled", (0, 0))
    half = percent(refined_in_half, in_half) if "settled" in last else "-"
    return cells + [last["draws"], last["objects"], last["refined"], half, left]


def results_of(folder: pathlib.Path) -> list:
    files = [(program, file_of(program, folder, ".result")) for program in PROGRAMS]
    return [{**json.loads(file.read_text()), "kind": program.kind} for program, file in files if file.exists()]


def table(results: list, modes: list) -> str:
    head = ["program", "kind", "off: pixels", *modes, "draws", "of objects", "refined", "last half", "left alone", "remark"]
    rows = [row_of(result) + [REMARKS.get(result["name"], "-")] for result in results]
    lines = ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head), *lines])


def summary(results: list) -> str:
    """How many were judged and are healthy, and the share of draws of objects that the last mode refined."""
    broken = [result["name"] for result in results if is_broken(result)]
    lives = [mode for result in results for mode in list(result["modes"].values())[-1:]]
    builds = len({result.get("build") for result in results})
    return (f"{len(results)} programs judged with {builds} build{'s'[:builds > 1]}, {len(broken)} look broken: "
            f"{', '.join(broken) or '-'}. {share_text(lives)}")


def write_table(text: str) -> None:
    page = ROOT / "docs" / "reference" / "strangers.md"
    before, _, rest = page.read_text().partition(MARKS[0])
    after = rest.partition(MARKS[1])[2]
    page.write_text(f"{before}{MARKS[0]}\n{text}\n{MARKS[1]}{after}")


def install(programs: list) -> None:
    """Installs each program by itself: a package that cannot be had must not keep the others away."""
    for program in programs:
        if not installed(program):
            subprocess.run([str(ROOT / "scripts" / "install_packages"), "--these", *program.packages], check=False)


def installed(program: Stranger) -> bool:
    return all(shutil.which(tool) for tool in (program.command[0], "apitrace", "glretrace")) and all(
        pathlib.Path(word).exists() for word in program.command if word.startswith("/"))


def arguments_of() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="scripts/strangers", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--library", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--folder", type=pathlib.Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--install", action="store_true", help="install the programs first")
    parser.add_argument("--only", action="append", default=[], metavar="NAME", help="this program (may be given several times)")
    parser.add_argument("--modes", default="outputs,smooth", help="refinements, separated by commas (outputs,smooth)")
    parser.add_argument("--record", action="store_true", help="make the missing recordings, replay nothing")
    parser.add_argument("--recorded", action="store_true", help="judge only programs that are recorded")
    parser.add_argument("--fresh", action="store_true", help="record again")
    parser.add_argument("--jobs", type=int, default=1, help="judge so many recordings at the same time (1)")
    parser.add_argument("--again", action="store_true", help="judge programs again that were judged with this build")
    parser.add_argument("--broken", action="store_true", help="judge those again whose numbers are not all 0")
    parser.add_argument("--slow", type=float, default=1, help="record for so many times as long, on a busy machine (1)")
    parser.add_argument("--limit", type=float, default=120, help="seconds for one replay (120)")
    parser.add_argument("--sheet", action="store_true", help="only join the rows of the contact sheet")
    parser.add_argument("--panel", action="store_true", help="judge the panel: open it, and compare with it closed")
    parser.add_argument("--list", action="store_true", help="list the programs, their packages, and whether they are installed")
    parser.add_argument("--write", action="store_true", help="put the table into docs/reference/strangers.md")
    arguments = parser.parse_args()
    arguments.modes = arguments.modes.split(",")
    arguments.folder, arguments.library = arguments.folder.resolve(), arguments.library.resolve()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    unknown = set(arguments.only) - {program.name for program in PROGRAMS}
    if unknown:
        parser.error(f"no program {sorted(unknown)}; --list names them")
    return arguments


def is_broken(result: dict) -> bool:
    return bool(result.get("failure") or result.get("off")) or any(
        "failure" in mode or sum(mode["numbers"]) for mode in result["modes"].values())


def is_due(program: Stranger, arguments: argparse.Namespace) -> bool:
    if arguments.only:
        return program.name in arguments.only
    if arguments.recorded and not file_of(program, arguments.folder, ".trace").exists():
        return False
    file = file_of(program, arguments.folder, ".result")
    if not file.exists() or arguments.again:
        return True
    result = json.loads(file.read_text())
    return is_broken(result) if arguments.broken else result.get("build") != build_of(arguments.library)


def keep(program: Stranger, arguments: argparse.Namespace, result: dict, seconds: float) -> None:
    result = {"name": program.name, "build": build_of(arguments.library), "modes": {}, **result}
    file_of(program, arguments.folder, ".result").write_text(json.dumps(result))
    print(*row_of({**result, "kind": program.kind}), f"{seconds:.0f} s", sep=" | ", flush=True)


def is_recorded(program: Stranger, arguments: argparse.Namespace) -> bool:
    """Records the program unless it is recorded. A failure becomes its result."""
    trace = file_of(program, arguments.folder, ".trace")
    if arguments.fresh:
        trace.unlink(missing_ok=True)
    if trace.exists():
        return True
    try:
        calls = record(program, arguments.folder, arguments.slow)
        print(f"{program.name}: recorded; frames end at the calls {calls}", flush=True)
    except (Failure, subprocess.TimeoutExpired) as failure:
        keep(program, arguments, {"failure": str(failure)}, 0)
        return False
    return True


def work_on(program: Stranger, arguments: argparse.Namespace) -> None:
    started = time.monotonic()
    try:
        result = examine(program, arguments.folder, arguments)
    except (Failure, subprocess.TimeoutExpired) as failure:
        result = {"failure": str(failure)}
    keep(program, arguments, result, time.monotonic() - started)


def work(arguments: argparse.Namespace) -> None:
    """Makes the missing recordings one after the other, because programs need the whole machine. Then judges --jobs at a time."""
    due = [program for program in PROGRAMS if installed(program) and is_due(program, arguments)]
    due = [program for program in due if is_recorded(program, arguments)]
    if not arguments.record:
        with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
            list(pool.map(lambda program: work_on(program, arguments), due))


def main() -> int:
    arguments = arguments_of()
    if arguments.list:
        for program in PROGRAMS:
            print(program.name, " ".join(program.packages), "installed" if installed(program) else "absent", sep=" | ")
        return 0
    if arguments.install:
        chosen = [program for program in PROGRAMS if not arguments.only or program.name in arguments.only]
        install(chosen)
        if any("npm" in program.packages for program in chosen):
            pages.install(arguments.folder / "npm")
    write_models(arguments.folder / "models")
    pages.write_pages(arguments.folder / "npm", arguments.folder / "models" / "pages")
    if arguments.panel:
        return judge_panel(arguments)
    if not arguments.sheet:
        work(arguments)
    results = results_of(arguments.folder)
    rows = [file_of(program, arguments.folder, ".png") for program in PROGRAMS]
    contact_sheet.join([row for row in rows if row.exists()], arguments.folder)
    drawn = [result for result in results if any(mode.get("draws") for mode in result["modes"].values())]
    print(f"strangers: {summary(drawn)}")
    if arguments.write:
        write_table("\n".join(textwrap.wrap(summary(drawn), 120)) + "\n\n" + table(drawn, arguments.modes))
    return 1 if any(is_broken(result) for result in drawn) else 0


sys.exit(main())
