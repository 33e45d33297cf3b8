#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""update.py GLARK-CONFORMANCE: writes the must-pass list, which is every written case except those of excluded.txt.

A line of excluded.txt is the name of a case or a glob, "#" and a reason. A changed list is a new version: raise
must_pass_version in submission/submission.h.
"""
import fnmatch
import json
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
HEAD = """# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
#
# The cases that an implementation has to pass, version 1; update.py writes this file. Behind its name, a case has the
# APIs in which NotSupported is no answer.
"""


def excluded() -> dict:
    """{glob: reason}"""
    file = HERE / "excluded.txt"
    lines = file.read_text().splitlines() if file.exists() else []
    pairs = [line.partition("#") for line in lines if line.strip() and not line.startswith("#")]
    for name, _, reason in pairs:
        if not reason.strip():
            sys.exit(f"excluded.txt: {name.strip()} has no reason")
    return {name.strip(): reason.strip() for name, _, reason in pairs}


def main() -> None:
    listed = subprocess.run([sys.argv[1], "--list", "--json"], capture_output=True, text=True, check=True).stdout
    out = excluded()
    cases = [case for case in json.loads(listed)["cases"]
             if case["written"] and not any(fnmatch.fnmatchcase(case["name"], glob) for glob in out)]
    lines = [" ".join([case["name"]] + ([] if case["optional"] else case["apis"])) for case in cases]
    (HERE / "1.txt").write_text(HEAD + "\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
