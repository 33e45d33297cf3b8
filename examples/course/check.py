#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Checks a lesson: its page, its commands, its pictures and its exercises.

  examples/course/check.py 01                 checks all that the page of lesson 01 says
  examples/course/check.py 01 --exercise 2    checks your exercise_2
  examples/course/check.py 01 --update        rewrites snippets, printed lines and expected pictures

The page (README.md) is the list of checks:
- `<!-- snippet: FILE NAME -->`: the code block below is what FILE has between `// [NAME]` and `// [/NAME]`.
- A `console` block: every line `$ COMMAND` is run, and prints the lines below it. What a command writes to expected/ is
  compared with the lesson's own file there, pictures with a tolerance. They have 320 x 240 pixels.
- A command that runs `./exercise_N` is the check of exercise N: solution_N passes it, exercise_N fails it.
"""
import argparse
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

COURSE = pathlib.Path(__file__).resolve().parent
ROOT = COURSE.parent.parent
SIZE = "320x240"
FENCE = "```"
VISIBLE = 40         # of 255: a smaller difference of a pixel does not count
MOST_VISIBLE = 0.01  # of the pixels: drivers draw the ends of lines and triangles differently


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
    """[(command, the lines that it prints)] of a console block."""
    commands = []
    for line in lines:
        if line.startswith("$ "):
            commands.append((line[2:], []))
        elif commands:
            commands[-1][1].append(line)
    return commands


def exercise_of(command: str) -> str:
    match = re.search(r"(?:^| )\./exercise_(\d+)", command)
    return match.group(1) if match else ""


def visible_difference(one: pathlib.Path, other: pathlib.Path) -> float:
    """The share of pixels that differ visibly. Halved pictures are compared: the steps of slanted lines do not count."""
    from PIL import Image, ImageChops
    pictures = [Image.open(path).convert("RGB") for path in (one, other)]
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
        share = visible_difference(made, expected)
        return f"{100 * share:.1f} % of the pixels differ from {expected.name}" if share > MOST_VISIBLE else ""
    return "" if made.read_bytes() == expected.read_bytes() else f"{expected.name} differs"


class Lesson:
    def __init__(self, folder: pathlib.Path, build: pathlib.Path) -> None:
        self.folder = folder
        self.programs = build / "course" / folder.name
        self.build = build
        self.page = (folder / "README.md").read_text().splitlines()

    def run(self, command: str, place: pathlib.Path) -> tuple:
        """(printed lines, files in expected/, exit status) of a command."""
        words = shlex.split(command)
        if "--png" in words and "--size" not in words:
            words += ["--size", SIZE]
        if not words[0].startswith("./"):
            words[0] = str(self.build / "bin" / words[0])
        words = [str(self.programs / word) if word.startswith("./") else word for word in words]
        shutil.rmtree(place / "expected", ignore_errors=True)
        (place / "expected").mkdir()
        done = subprocess.run(words, cwd=place, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)
        printed = done.stdout.replace(f"{self.programs}/", "./").splitlines()
        return printed, sorted((place / "expected").iterdir()), done.returncode

    def problem_of(self, command: str, wanted: list, place: pathlib.Path) -> str:
        """What is wrong with a command, or an empty text."""
        printed, files, status = self.run(command, place)
        if printed != wanted:
            return "it prints\n    " + "\n    ".join(printed or ["nothing"]) + "\n  instead of\n    " + "\n    ".join(wanted or ["nothing"])
        if status < 0 or (status > 0 and not wanted):
            return f"it ends with status {status}"
        missing = set(re.findall(r"expected/(\S+)", command)) - {file.name for file in files}
        if missing and status == 0:
            return f"it does not write {', '.join(sorted(missing))}"
        return "; ".join(filter(None, (difference_of_files(file, self.folder / "expected" / file.name) for file in files)))

    def check_commands(self) -> list:
        problems, made = [], set()
        with tempfile.TemporaryDirectory() as temporary:
            for begin, end, language, _ in blocks_of(self.page):
                for command, wanted in commands_of(self.page[begin:end]) if language == "console" else []:
                    made.update(re.findall(r"expected/(\S+)", command))
                    number = exercise_of(command)
                    solved = command.replace("./exercise_", "./solution_", 1) if number else command
                    problem = self.problem_of(solved, wanted, pathlib.Path(temporary))
                    problems += [f"{solved}: {problem}"] if problem else []
                    if number and not self.problem_of(command, wanted, pathlib.Path(temporary)):
                        problems.append(f"{command}: exercise_{number} passes its check before it is solved")
        unused = {file.name for file in (self.folder / "expected").glob("*")} - made
        pictures = re.findall(r"!\[[^\]]*\]\((expected/[^)]+)\)", "\n".join(self.page))
        problems += [f"README.md shows {name}, which is missing" for name in pictures if not (self.folder / name).is_file()]
        return problems + [f"expected/{name}: no command of the page makes it" for name in sorted(unused)]

    def check_snippets(self) -> list:
        problems = []
        for begin, end, _, before in blocks_of(self.page):
            match = re.match(r"<!-- snippet: (\S+) (\w+) -->", before)
            if match and snippet_of((self.folder / match.group(1)).read_text(), match.group(2)) != self.page[begin:end]:
                problems.append(f"README.md: the snippet {match.group(2)} is not what {match.group(1)} has; --update rewrites it")
        return problems

    def check_names(self) -> list:
        """The commands that are not run, in blocks without a language, are those of this lesson."""
        number, problems = self.folder.name[:2], []
        rules = ((r"\blesson_(\d\d)\b", number), (r"\bcheck\.py (\d\d)\b", number), (r"build/demo/course/(\w+)", self.folder.name))
        for begin, end, language, _ in blocks_of(self.page):
            for pattern, wanted in rules if not language else ():
                problems += [f"README.md: {found} is another lesson" for line in self.page[begin:end]
                             for found in re.findall(pattern, line) if found != wanted]
        return problems

    def check_exercise(self, number: str) -> list:
        place = self.programs / "mine"
        place.mkdir(exist_ok=True)
        commands = [pair for begin, end, language, _ in blocks_of(self.page) if language == "console"
                    for pair in commands_of(self.page[begin:end]) if exercise_of(pair[0]) == number]
        if not commands:
            return [f"lesson {self.folder.name} has no exercise {number}"]
        problems = [(command, self.problem_of(command, wanted, place)) for command, wanted in commands]
        return [f"{command}: {problem}\n  your picture is in {place}/expected" for command, problem in problems if problem]

    def update(self) -> None:
        from PIL import Image
        for begin, end, language, before in reversed(blocks_of(self.page)):
            match = re.match(r"<!-- snippet: (\S+) (\w+) -->", before)
            if match:
                self.page[begin:end] = snippet_of((self.folder / match.group(1)).read_text(), match.group(2))
            if language != "console":
                continue
            new = []
            for command, _ in commands_of(self.page[begin:end]):
                with tempfile.TemporaryDirectory() as temporary:
                    printed, files, _ = self.run(command.replace("./exercise_", "./solution_", 1), pathlib.Path(temporary))
                    new += ["$ " + command] + printed
                    for file in files:
                        (self.folder / "expected").mkdir(exist_ok=True)
                        kept = self.folder / "expected" / file.name
                        if kept.exists() and not difference_of_files(file, kept):
                            continue
                        if file.suffix == ".png":
                            Image.open(file).convert("RGB").quantize(256, dither=Image.Dither.NONE).save(kept, optimize=True)
                        else:
                            shutil.copy(file, kept)
            self.page[begin:end] = new
        (self.folder / "README.md").write_text("\n".join(self.page) + "\n")


def find_build(folder: str) -> pathlib.Path:
    builds = [path for path in (ROOT / "build").glob("*") if (path / "course" / folder).is_dir()]
    if not builds:
        sys.exit(f"check: the lesson is not built; run: scripts/build demo lesson_{folder[:2]}")
    return max(builds, key=lambda path: (path / "course" / folder).stat().st_mtime)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lesson", help="a folder of the course, or how its name begins")
    parser.add_argument("--exercise", metavar="N", help="check your exercise_N")
    parser.add_argument("--build", type=pathlib.Path, help="the build folder (default: the newest one below build/)")
    parser.add_argument("--update", action="store_true", help="rewrite the page and the expected pictures")
    arguments = parser.parse_args()
    folders = [path for path in sorted(COURSE.iterdir()) if path.is_dir() and path.name.startswith(arguments.lesson)]
    if not folders:
        sys.exit(f"check: there is no lesson {arguments.lesson}")
    lesson = Lesson(folders[0], (arguments.build or find_build(folders[0].name)).resolve())
    if arguments.update:
        lesson.update()
    problems = (lesson.check_exercise(arguments.exercise) if arguments.exercise
                else lesson.check_names() + lesson.check_snippets() + lesson.check_commands())
    for problem in problems:
        print(f"{folders[0].name}: {problem}", file=sys.stderr)
    if not problems:
        print(f"exercise {arguments.exercise} is solved" if arguments.exercise else f"{folders[0].name} is as its page says")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
