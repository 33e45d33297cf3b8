#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Checks a lesson: its page, its commands, its pictures and its exercises.

  examples/course/check.py 01 --exercise 2    checks your exercise_2
  examples/course/check.py 01                 for authors: checks the page of lesson 01, not your exercises
  examples/course/check.py 01 --update        rewrites snippets, printed lines and expected pictures

The page (README.md) is the list of checks:
- `<!-- snippet: FILE NAME -->`: the code block below is what FILE has between `// [NAME]` and `// [/NAME]`.
- A `console` block: every line `$ COMMAND` is run, and prints the lines below it. What a command writes to expected/ is
  compared with the lesson's own file there, pictures with a tolerance. They have 320 x 240 pixels.
- A command that runs `./exercise_N` is the check of exercise N: solution_N passes it, exercise_N fails it.
"""
import argparse
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import threading

try:
    from PIL import Image, ImageChops
except ImportError:
    print(f"check: {sys.executable} has no package python3-pil: scripts/install_packages --course installs it "
          "for /usr/bin/python3", file=sys.stderr)
    sys.exit(2)

COURSE = pathlib.Path(__file__).resolve().parent
ROOT = COURSE.parent.parent
SIZE = "320x240"
FENCE = "```"
SNIPPET = r"<!-- snippet: (\S+) (\w+) -->"
VISIBLE = 40         # of 255: a smaller difference of a pixel does not count
MOST_VISIBLE = 0.01  # of the pixels: drivers draw the ends of lines and triangles differently
SECONDS = 120        # for one command
MOST_PRINTED = 1000000  # bytes: an endless loop may print
MOST_SHOWN = 20         # printed lines


class Unable(Exception):
    """A part of the lesson cannot be checked. The text says why."""


def snippet_of(source: str, name: str) -> list:
    """The lines between the marks, without common indentation and without inner marks."""
    match = re.search(rf"^ *// \[{name}\]\n(.*?)^ *// \[/{name}\]$", source, re.MULTILINE | re.DOTALL)
    if not match:
        return []
    lines = [line for line in match.group(1).splitlines() if not re.match(r" *// \[/?\w+\]$", line)]
    indent = min((len(line) - len(line.lstrip()) for line in lines if line.strip()), default=0)
    return [line[indent:] for line in lines]


def blocks_of(lines: list) -> list:
    """(first, last, language, text of the line before the fence) of each code block, without its fences."""
    fences = [i for i, line in enumerate(lines) if line.startswith(FENCE)]
    return [(begin + 1, end, lines[begin][3:].strip(), lines[begin - 1] if begin else "")
            for begin, end in zip(fences[::2], fences[1::2])]


def commands_of(lines: list) -> list:
    """[(its line in the block, command, the lines that it prints)] of a console block."""
    commands = []
    for i, line in enumerate(lines):
        if line.startswith("$ "):
            commands.append((i, line[2:], []))
        elif commands:
            commands[-1][2].append(line)
    return commands


def exercise_of(command: str) -> str:
    match = re.search(r"(?:^| )\./exercise_(\d+)", command)
    return match.group(1) if match else ""


def name_of(command: str) -> str:
    """The lesson's program in a command, or its first word."""
    match = re.search(r"(?:^| )\./(\S+)", command)
    return match.group(1) if match else command.split(" ")[0]


def picture_of(path: pathlib.Path) -> Image.Image:
    try:
        with Image.open(path) as picture:
            return picture.convert("RGB")
    except Exception as error:  # PIL raises many kinds for damaged files
        raise Unable(f"{path.parent.name}/{path.name} is no picture that can be read") from error


def visible_difference(one: pathlib.Path, other: pathlib.Path) -> float:
    """The share of pixels that differ visibly. Compares halved pictures: the steps of slanted lines do not count."""
    pictures = [picture_of(path) for path in (one, other)]
    if pictures[0].size != pictures[1].size:
        return 1.0
    half = [picture.resize((picture.width // 2, picture.height // 2), Image.Resampling.BOX) for picture in pictures]
    bands = ImageChops.difference(*half).split()
    worst = ImageChops.lighter(ImageChops.lighter(bands[0], bands[1]), bands[2])
    return sum(worst.histogram()[VISIBLE:]) / (worst.width * worst.height)


def difference_of_files(made: pathlib.Path, expected: pathlib.Path) -> str:
    """What is wrong, or an empty text."""
    if not expected.exists():
        return f"{expected.name} is not in expected/; --update adds it"
    if made.suffix == ".png":
        try:
            share = visible_difference(made, expected)
        except Unable as error:
            return str(error)
        if share <= MOST_VISIBLE:
            return ""
        return f"{100 * share:.1f} % of the pixels of {expected.name} differ"
    return "" if made.read_bytes() == expected.read_bytes() else f"{expected.name} differs"


def shown(lines: list) -> str:
    more = len(lines) - MOST_SHOWN
    lines = lines[:MOST_SHOWN] + ([f"... and {more} more lines"] if more > 0 else [])
    return "\n    ".join(lines or ["nothing"])


def outcome_of(words: list, place: pathlib.Path, name: str) -> tuple:
    """(printed text, exit status) of a command. It and the programs that it starts end after SECONDS at the latest."""
    late = []

    def end(reason: str) -> None:
        late.append(reason)
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass

    try:
        process = subprocess.Popen(words, cwd=place, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, start_new_session=True)
    except OSError as error:
        raise Unable(f"{name} cannot be run: {error.strerror}") from error
    timer = threading.Timer(SECONDS, end, [f"{name} did not end within {SECONDS} seconds"])
    timer.start()
    try:
        with process:
            text = process.stdout.read(MOST_PRINTED)
            if len(text) == MOST_PRINTED:
                end(f"{name} prints without end")
    except KeyboardInterrupt:
        end("")
        raise
    finally:
        timer.cancel()
    if late:
        raise Unable(late[0])
    return text.decode(errors="replace"), process.returncode


def crash_of(status: int) -> str:
    return {number.value: number.name for number in signal.Signals}.get(-status, f"signal {-status}")


def shown_path(path: pathlib.Path) -> str:
    return str(path.relative_to(ROOT) if path.is_relative_to(ROOT) else path)


def building(build: pathlib.Path, folder: str) -> str:
    """The command that builds a lesson into a build folder."""
    known = build.parent == ROOT / "build" and f'"{build.name}"' in (ROOT / "CMakePresets.json").read_text()
    return f"scripts/build {build.name if known else 'demo'} lesson_{folder[:2]}"


class Lesson:
    def __init__(self, folder: pathlib.Path, build: pathlib.Path) -> None:
        self.folder = folder
        self.programs = build / "course" / folder.name
        self.build = build
        self.page = (folder / "README.md").read_text().splitlines()

    def commands(self) -> list:
        """(command, the lines that it prints, where it stands) of all console blocks."""
        return [(command, wanted, f"README.md:{begin + 1 + offset}: {command}")
                for begin, end, language, _ in blocks_of(self.page) if language == "console"
                for offset, command, wanted in commands_of(self.page[begin:end])]

    def program_of(self, word: str) -> str:
        """The file of a program of the lesson (./NAME), of glark (../../bin/glark), or of the system."""
        path = self.programs / word if word.startswith(("./", "../")) else self.build / "bin" / word
        if path.is_file():
            return str(path)
        name = path.name
        if word == "../../bin/glark" or word == f"./{name}" and (self.folder / f"{name}.cpp").is_file():
            raise Unable(f"{name} is not built in {shown_path(self.build)}: {building(self.build, self.folder.name)}")
        raise Unable(f"there is no program {word}")

    def words_of(self, command: str) -> list:
        try:
            words = shlex.split(command)
        except ValueError as error:
            raise Unable("a quotation mark is missing") from error
        if not words:
            raise Unable("there is no command")
        if "--png" in words and "--size" not in words:
            words += ["--size", SIZE]
        return [self.program_of(word) if i == 0 or word.startswith("./") else word for i, word in enumerate(words)]

    def run(self, command: str, place: pathlib.Path) -> tuple:
        """(printed lines, files in expected/, exit status) of a command."""
        shutil.rmtree(place / "expected", ignore_errors=True)
        (place / "expected").mkdir()
        text, status = outcome_of(self.words_of(command), place, name_of(command))
        printed = text.replace(f"{self.programs}/", "./").splitlines()
        return printed, sorted((place / "expected").iterdir()), status

    def problem_of(self, command: str, wanted: list, place: pathlib.Path) -> str:
        """What is wrong with a command, or an empty text."""
        printed, files, status = self.run(command, place)
        if status < 0:
            return f"{name_of(command)} crashed: {crash_of(status)}"
        if printed != wanted:
            return f"it prints\n    {shown(printed)}\n  instead of\n    {shown(wanted)}"
        if status > 0 and not wanted:
            return f"it ends with status {status}"
        missing = set(re.findall(r"expected/(\S+)", command)) - {file.name for file in files}
        if missing and status == 0:
            return f"it does not write {', '.join(sorted(missing))}"
        differences = [difference_of_files(file, self.folder / "expected" / file.name) for file in files]
        return "; ".join(filter(None, differences))

    def check_command(self, command: str, wanted: list, place: pathlib.Path) -> list:
        """What is wrong with a command of the page. An exercise is checked twice, by its solution and as it is."""
        number = exercise_of(command)
        solved = command.replace("./exercise_", "./solution_", 1) if number else command
        name = f"{solved}: " if number else ""
        try:
            problem = self.problem_of(solved, wanted, place)
            problems = [name + problem] if problem else []
            if number and not self.problem_of(command, wanted, place):
                yours = f"check.py {self.folder.name[:2]} --exercise {number}"
                problems.append(f"exercise_{number} passes its check before it is solved "
                                f"(this is the check for authors; for yours: {yours})")
            return problems
        except Unable as error:
            return [str(error)]

    def check_commands(self) -> list:
        problems, made = [], set()
        with tempfile.TemporaryDirectory() as temporary:
            for command, wanted, where in self.commands():
                made.update(re.findall(r"expected/(\S+)", command))
                found = self.check_command(command, wanted, pathlib.Path(temporary))
                problems += [f"{where}: {problem}" for problem in found]
        unused = {file.name for file in (self.folder / "expected").glob("*")} - made
        pictures = re.findall(r"!\[[^\]]*\]\((expected/[^)]+)\)", "\n".join(self.page))
        problems += [f"README.md shows {name}, which is missing" for name in pictures
                     if not (self.folder / name).is_file()]
        return problems + [f"expected/{name}: no command of the page makes it" for name in sorted(unused)]

    def snippet(self, file: str, name: str) -> list:
        try:
            lines = snippet_of((self.folder / file).read_text(), name)
        except (OSError, UnicodeError) as error:
            raise Unable(f"the snippet {name}: {file} cannot be read") from error
        if not lines:
            raise Unable(f"the snippet {name}: {file} has no lines between // [{name}] and // [/{name}]")
        return lines

    def check_snippets(self) -> list:
        problems = []
        for begin, end, _, before in blocks_of(self.page):
            match = re.match(SNIPPET, before)
            try:
                if match and self.snippet(*match.groups()) != self.page[begin:end]:
                    file, name = match.groups()
                    problems.append(f"README.md:{begin}: the snippet {name} is not what {file} has; "
                                    "--update rewrites it")
            except Unable as error:
                problems.append(f"README.md:{begin - 1}: {error}")
        return problems

    def check_names(self) -> list:
        """The commands that are not run, in blocks without a language, are those of this lesson."""
        number, problems = self.folder.name[:2], []
        rules = ((r"\blesson_(\d\d)\b", number), (r"\bcheck\.py (\d\d)\b", number),
                 (r"build/demo/course/(\w+)", self.folder.name))
        for begin, end, language, _ in blocks_of(self.page):
            for pattern, wanted in rules if not language else ():
                problems += [f"README.md:{i + 1}: {found} is another lesson" for i in range(begin, end)
                             for found in re.findall(pattern, self.page[i]) if found != wanted]
        return problems

    def check_lists(self) -> list:
        """A number and a full stop at the beginning of a line in a list make another list."""
        blocks = blocks_of(self.page)
        return [f"README.md:{i + 1}: '{line.split()[0]}' at the beginning of a line begins a list"
                for i, line in enumerate(self.page) if re.match(r" +\d+\.( |$)", line)
                and not any(begin <= i < end for begin, end, _, _ in blocks)]

    def check_page(self) -> list:
        return self.check_names() + self.check_lists() + self.check_snippets() + self.check_commands()

    def newer_than_program(self, name: str) -> str:
        """A source of a program that was changed after the program was built, or an empty text."""
        source, program = self.folder / f"{name}.cpp", self.programs / name
        if not source.is_file() or not program.is_file():
            return ""
        text = source.read_text(errors="replace")
        files = [source] + [header for header in sorted(self.folder.glob("*.h")) if header.name in text]
        return next((file.name for file in files if file.stat().st_mtime > program.stat().st_mtime), "")

    def check_exercise(self, number: str) -> list:
        """Ends at the first problem, so that its picture is kept."""
        commands = [found for found in self.commands() if exercise_of(found[0]) == number]
        if not commands:
            return [f"the lesson has no exercise {number}"]
        newer = self.newer_than_program(f"exercise_{number}")
        if newer:
            return [f"{newer} is newer than its program: build it again: {building(self.build, self.folder.name)}"]
        place = self.programs / "mine"
        place.mkdir(exist_ok=True)
        for command, wanted, where in commands:
            try:
                problem = self.problem_of(command, wanted, place)
            except Unable as error:
                problem = str(error)
            if problem:
                made = [line for file in sorted((place / "expected").iterdir()) for line in self.pair(file)]
                return ["\n  ".join([f"{where}: {problem}"] + made)]
        return []

    def pair(self, file: pathlib.Path) -> list:
        """Where a student's picture is, and the one that it should look like."""
        expected = self.folder / "expected" / file.name
        lines = [f"your picture is {shown_path(file)}"]
        return lines + ([f"it should look like {shown_path(expected)}"] if expected.is_file() else [])

    def answer(self, exercise: str) -> str:
        """What to say if there is no problem."""
        if exercise is not None:
            return f"exercise {exercise} is solved"
        numbers = sorted({exercise_of(command) for command, _, _ in self.commands()} - {""})
        check = f"examples/course/check.py {self.folder.name[:2]} --exercise"
        yours = "".join(f"\n  {check} {number}" for number in numbers)
        return (f"{self.folder.name}: the page is right. This is the authors' check: it says nothing about your "
                "exercises." + (f" To check yours:{yours}" if yours else ""))

    def keep(self, file: pathlib.Path) -> None:
        """Copies a file that a command made into expected/, unless it looks the same."""
        kept = self.folder / "expected" / file.name
        kept.parent.mkdir(exist_ok=True)
        if kept.exists() and not difference_of_files(file, kept):
            return
        if file.suffix == ".png":
            picture_of(file).quantize(256, dither=Image.Dither.NONE).save(kept, optimize=True)
        else:
            shutil.copy(file, kept)

    def updated(self, command: str, printed: list) -> list:
        """The lines that a command prints now. They stay as they are if it cannot be run."""
        with tempfile.TemporaryDirectory() as temporary:
            try:
                printed, files, _ = self.run(command.replace("./exercise_", "./solution_", 1), pathlib.Path(temporary))
                for file in files:
                    self.keep(file)
            except Unable:
                pass  # the checks afterwards say why
        return printed

    def update(self) -> None:
        for begin, end, language, before in reversed(blocks_of(self.page)):
            match = re.match(SNIPPET, before)
            if match:
                try:
                    self.page[begin:end] = self.snippet(*match.groups())
                except Unable:
                    pass  # the checks afterwards say why
            if language == "console":
                self.page[begin:end] = [line for _, command, printed in commands_of(self.page[begin:end])
                                        for line in ["$ " + command] + self.updated(command, printed)]
        (self.folder / "README.md").write_text("\n".join(self.page) + "\n")


def time_built(programs: pathlib.Path) -> float:
    """When the newest program of a lesson was built; 0 if there is none."""
    files = [file for file in programs.glob("*") if file.is_file() and os.access(file, os.X_OK)]
    return max((file.stat().st_mtime for file in files), default=0)


def find_build(folder: str, asked: pathlib.Path) -> pathlib.Path:
    """The build folder that was asked for, or the one below build/ with the newest programs of the lesson."""
    builds = [asked.resolve()] if asked else sorted((ROOT / "build").glob("*"))
    found = max(builds, key=lambda build: time_built(build / "course" / folder), default=ROOT / "build" / "demo")
    if time_built(found / "course" / folder):
        return found
    wanted = asked.resolve() if asked else ROOT / "build" / "demo"
    sys.exit(f"check: lesson {folder[:2]} is not built in {shown_path(wanted)}: {building(wanted, folder)}")


def find_lesson(asked: str) -> pathlib.Path:
    folders = [path for path in sorted(COURSE.iterdir()) if path.is_dir() and re.match(r"\d\d_", path.name)]
    for path in folders:
        if asked in (path.name, path.name[:2], str(int(path.name[:2]))):
            return path
    sys.exit("\n  ".join([f"check: there is no lesson '{asked}'. The lessons are:"] + [path.name for path in folders]))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lesson", help="the number of a lesson, or its folder's name: 1, 01 or 01_one_triangle")
    parser.add_argument("--exercise", metavar="N", choices=list("123456789"), help="check your exercise_N")
    parser.add_argument("--build", type=pathlib.Path, help="the build folder (default: the newest one below build/)")
    parser.add_argument("--update", action="store_true", help="rewrite the page and the expected pictures")
    arguments = parser.parse_args()
    folder, exercise = find_lesson(arguments.lesson), arguments.exercise
    try:
        lesson = Lesson(folder, find_build(folder.name, arguments.build))
        if arguments.update:
            lesson.update()
        problems = lesson.check_page() if exercise is None else lesson.check_exercise(exercise)
    except (OSError, UnicodeError) as error:
        problems = [str(error)]
    for problem in problems:
        print(f"{folder.name}: {problem}", file=sys.stderr)
    if not problems:
        print(lesson.answer(exercise))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
