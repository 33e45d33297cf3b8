# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Debian's piglit: lists its tests, and runs one in a separate process."""
import collections
import dataclasses
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time

PIGLIT = pathlib.Path("/usr/lib/x86_64-linux-gnu/piglit")
PROFILES = ("quick_gl", "quick_shader")


@dataclasses.dataclass(frozen=True)
class Test:
    name: str
    command: tuple  # the program by its absolute path, then its arguments


@dataclasses.dataclass
class Outcome:
    result: str      # pass, fail, warn, skip, crash or timeout
    subtests: dict   # name -> result
    seconds: float
    statistics: dict  # the library's statistics; empty without the library
    output: str = ""  # the end of the test's output

    def same_as(self, other: "Outcome") -> bool:
        return self.result == other.result and self.subtests == other.subtests


def family(name: str) -> str:
    """Tests that differ only in a type, a format, a count or an operator form one family."""
    *groups, leaf = name.split("@")
    words = re.split(r"[ 0-9(]", leaf)[0]
    words = "-".join(words.split("-")[:2])
    words = "_".join(words.split("_")[:4])
    return "@".join([*groups, words])


def tests(variants: int) -> list:
    """Returns up to `variants` tests of each family of OpenGL and GLSL tests that run something, evenly spread."""
    families = collections.defaultdict(list)
    for profile in PROFILES:
        listing = subprocess.run(["piglit", "print-cmd", profile], check=True, capture_output=True, text=True, cwd="/")
        for line in listing.stdout.splitlines():
            name, separator, command = line.partition(" ::: ")
            words = command.split()
            if not separator or pathlib.Path(words[0]).name == "glslparsertest":
                continue
            program = PIGLIT / "bin" / pathlib.Path(words[0]).name
            if program.exists():  # the list names some that Debian does not build
                families[family(name)].append(Test(name, (str(program), *words[1:])))
    chosen = []
    for members in families.values():
        count = min(variants, len(members))
        chosen += [members[i * len(members) // count] for i in range(count)]
    return chosen


def read_results(output: str) -> tuple:
    """Reads the result and the results of the subtests from a test's output."""
    result, subtests = None, {}
    for line in output.splitlines():
        if not line.startswith("PIGLIT: "):
            continue
        try:
            said = json.loads(line[len("PIGLIT: "):])
        except json.JSONDecodeError:
            continue
        result = said.get("result", result)
        subtests.update(said.get("subtest", {}))
    if result is None and subtests:
        result = max(subtests.values(), key=["skip", "pass", "warn", "fail"].index)
    return result, subtests


def run(test: Test, environment: dict, statistics_file: pathlib.Path, limit: float) -> Outcome:
    """Runs a test on the display of `environment`. Kills its whole process group after `limit` seconds."""
    statistics_file.unlink(missing_ok=True)
    start = time.monotonic()
    process = subprocess.Popen(test.command, cwd=PIGLIT, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True, errors="replace", start_new_session=True)
    try:
        output, _ = process.communicate(timeout=limit)
        timed_out = False
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        output, _ = process.communicate()
        timed_out = True
    result, subtests = read_results(output)
    if timed_out:
        result = "timeout"
    elif process.returncode < 0:
        result = "crash"
    elif result is None:
        result = "fail"
    statistics = {}
    if statistics_file.exists():
        try:
            statistics = json.loads(statistics_file.read_text())
        except json.JSONDecodeError:
            print(f"{test.name}: its statistics cannot be read", file=sys.stderr)
    return Outcome(result, subtests, time.monotonic() - start, statistics, output[-2000:])
