#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""commands.py --check GL_XML CASES: which commands of OpenGL and OpenGL ES have a change (cases "ark.change.*").
commands.py --called GL_XML RESULTS [RESULTS ...]: which commands no case calls.

GL_XML is Khronos' registry, CASES what glark-conformance --list --json prints. Every command of either API needs a case
that names it, or a line of reasons.txt that matches it. So a command that a new version of OpenGL adds is noticed.

RESULTS are files results.json of runs with --commands, by any platform and API. A command that has a change, or whose reason
names cases (ark....), has to be called in one of the runs. Exit status: 1 if one is not.
"""
import fnmatch
import json
import sys
import xml.etree.ElementTree
from pathlib import Path

REASONS = Path(__file__).resolve().parent / "reasons.txt"


def commands_of(registry):
    """The names without "gl" of all commands of OpenGL (with compatibility profile) and OpenGL ES 2 to 3.2."""
    features = [each for each in xml.etree.ElementTree.parse(registry).getroot().iter("feature")
                if each.get("api") in ("gl", "gles2")]
    return {command.get("name")[2:] for feature in features for required in feature.iter("require")
            for command in required.iter("command")}


def read_reasons(text):
    """[(glob, reason)]; a line is GLOB [GLOB ...]: REASON, and # begins a comment."""
    pairs = []
    for line in text.splitlines():
        globs, colon, reason = line.partition("#")[0].partition(":")
        if globs.strip():
            if not colon or not reason.strip():
                sys.exit(f"reasons.txt: no reason: {line}")
            pairs += [(glob, reason.strip()) for glob in globs.split()]
    return pairs


def complaints(commands, tested, reasons):
    """What is wrong: commands with neither case nor reason, unknown commands, reasons that match nothing."""
    wrong = [f"{name} is no command of OpenGL" for name in sorted(tested - commands)]
    used = set()
    for name in sorted(commands - tested):
        matches = [glob for glob, _ in reasons if fnmatch.fnmatchcase(name, glob)]
        used.update(matches)
        if not matches:
            wrong.append(f"{name} has neither a change nor a reason")
    return wrong + [f"reasons.txt: nothing is left for {glob}" for glob, _ in reasons if glob not in used]


def uncalled(commands, called, reasons):
    """{reason: names of commands that no case calls, although the reason says that cases do}"""
    missing = {}
    for name in sorted(commands - called):
        told = [reason for glob, reason in reasons if fnmatch.fnmatchcase(name, glob)]
        if not told or any("ark." in reason for reason in told):
            missing.setdefault(told[0] if told else "has a change of its own", []).append(name)
    return missing


def check_called(registry, files):
    called = {command for path in files for record in json.loads(Path(path).read_text())["results"]
              for command in record.get("commands", [])}
    missing = uncalled(commands_of(registry), called, read_reasons(REASONS.read_text()))
    for reason, names in missing.items():
        print(f"{reason}\n    " + " ".join(names))
    print(f"{len(called)} commands are called, {sum(map(len, missing.values()))} are not")
    return 1 if missing else 0


def main():
    if len(sys.argv) > 3 and sys.argv[1] == "--called":
        sys.exit(check_called(sys.argv[2], sys.argv[3:]))
    if len(sys.argv) != 4 or sys.argv[1] != "--check":
        sys.exit(__doc__)
    cases = json.loads(Path(sys.argv[3]).read_text())["cases"]
    commands = commands_of(sys.argv[2])
    tested = {name for case in cases for name in case["commands"]}
    wrong = complaints(commands, tested, read_reasons(REASONS.read_text()))
    print("\n".join(wrong) if wrong else f"{len(commands)} commands: {len(tested)} with a change, the others with a reason")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
