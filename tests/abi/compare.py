# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Compares binary interfaces: fails if a program that was linked with the old one may not work with the new one.

  compare.py OLD_FOLDER NEW_FOLDER    descriptions as scripts/parts/abi writes them: NAME.abi (abidw's) and NAME.symbols
  compare.py OLD.symbols LIBRARY      only the names that a library exports

A library whose SONAME has changed is another library: programs are linked with it again.
"""
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

ERROR_BITS = 1 | 2   # abidiff failed, or was called wrongly
CHANGE_BITS = 4 | 8  # something changed, which may be, or certainly is, incompatible
REMEDY = "programs that were linked before may not work; keep the interface, or raise GLARK_SOVERSION and run scripts/parts/abi --update"


def soname(description: pathlib.Path) -> str:
    return ElementTree.parse(description).getroot().get("soname", "")


def lines(text: str) -> set:
    return {line for line in text.splitlines() if line and not line.startswith("#")}


def exported(library: pathlib.Path) -> set:
    done = subprocess.run(["nm", "--dynamic", "--defined-only", library], capture_output=True, text=True, check=True)
    return {line.split()[-1] for line in done.stdout.splitlines()}


def missing(name: str, old: set, new: set) -> list:
    gone = sorted(old - new)
    return [f"{name} no longer exports {', '.join(gone)}: {REMEDY}"] if gone else []


def complaints_about(old: pathlib.Path, new: pathlib.Path) -> list:
    """Compares two descriptions, with the lists of names beside them."""
    if not new.exists():
        return [f"{old.stem} is no longer there"]
    if soname(old) != soname(new):
        return []
    names = [file.with_suffix(".symbols").read_text() for file in (old, new)]
    complaints = missing(old.stem, *map(lines, names))
    done = subprocess.run(["abidiff", "--no-added-syms", "--no-show-locs", old, new], capture_output=True, text=True)
    if done.returncode & ERROR_BITS:
        complaints.append(f"abidiff failed for {old.stem}: {done.stderr}")
    elif done.returncode & CHANGE_BITS:
        complaints.append(f"{old.stem}: {REMEDY}\n{done.stdout}")
    return complaints


def main() -> int:
    old, new = (pathlib.Path(name) for name in sys.argv[1:3])
    if old.is_file():
        count, complaints = 1, missing(new.name, lines(old.read_text()), exported(new))
    else:
        descriptions = sorted(old.glob("*.abi"))
        count = len(descriptions)
        complaints = [text for file in descriptions for text in complaints_about(file, new / file.name)]
    for text in complaints:
        print(f"abi: {text}", file=sys.stderr)
    print(f"abi: {count} libraries, {len(complaints)} complaints")
    return 1 if complaints or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
