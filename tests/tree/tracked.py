# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The files of the tree that the checks read: what git tracks or would track."""
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]


def tracked_files() -> list:
    """Paths relative to the root, with slashes, as text."""
    listing = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                             cwd=ROOT, check=True, capture_output=True, text=True).stdout
    names = sorted({name for name in listing.split("\0") if name and (ROOT / name).is_file()})
    assert names, "git lists no files: are the tests run outside a clone?"
    return names


def text_of(name: str) -> str:
    return (ROOT / name).read_text(errors="replace")


def violations(rule, names=None) -> list:
    """What `rule(name, text)`, which returns a list of complaints, says of each file."""
    return [f"{name}: {complaint}" for name in (names or tracked_files()) for complaint in rule(name, text_of(name))]
