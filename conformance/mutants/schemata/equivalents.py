# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Mutants that nobody can tell from the true implementation, each with its reason: equivalents.toml."""
import dataclasses
import fnmatch
import pathlib
import tomllib

import run

from .operators import OPERATORS

PATH = pathlib.Path(__file__).parent / "equivalents.toml"


@dataclasses.dataclass
class Equivalent:
    """One mutant, or with `all` every one that matches. Text is compared without regard to white space."""
    file: str
    operator: str
    old: str
    reason: str
    function: str
    new: str | None = None  # only if several mutants have the same old text
    all: bool = False

    def matches(self, mutant) -> bool:
        return (mutant.file == self.file and mutant.function == self.function and mutant.operator == self.operator
                and plain(mutant.old) == plain(self.old) and (self.new is None or plain(mutant.new) == plain(self.new)))

    def name(self) -> str:
        return f"{self.file} {self.function}: {self.operator}: {plain(self.old)}"


@dataclasses.dataclass
class Outside:
    """Mutants that no sentence of the specification is about, as those of a log. Globs."""
    reason: str
    file: str = "*"
    old: str = "*"
    operator: str = "*"
    function: str = "*"

    def matches(self, mutant) -> bool:
        return all(fnmatch.fnmatchcase(plain(getattr(mutant, field)), getattr(self, field)) for field in ("file", "old", "operator", "function"))

    def name(self) -> str:
        return f"{self.file} {self.function}: {self.operator}: {self.old}"


def plain(text: str) -> str:
    return " ".join(text.split())


def read(path: pathlib.Path = PATH) -> tuple:
    """Returns the equivalents and what is outside."""
    try:
        table = tomllib.loads(path.read_text())
        return [Equivalent(**entry) for entry in table.get("equivalent", ())], [Outside(**entry) for entry in table.get("outside", ())]
    except (tomllib.TOMLDecodeError, TypeError) as error:
        raise run.Complaint(f"{path.name}: {error}") from error


def complaints(equivalents: list, outside: list, mutants: list) -> list:
    found = []
    for entry in equivalents:
        count = sum(1 for mutant in mutants if mutant.file == entry.file and entry.matches(mutant))
        if count == 0:
            found.append(f"no mutant is {entry.name()}")
        elif count > 1 and not entry.all:
            found.append(f"{count} mutants are {entry.name()}: give `new`, or `all = true`")
        if entry.operator not in OPERATORS:
            found.append(f"there is no operator {entry.operator}")
    for entry in outside:
        if not any(entry.matches(mutant) for mutant in mutants):
            found.append(f"no mutant is outside by {entry.name()}")
    found += [f"no reason is given for {entry.name()}" for entry in [*equivalents, *outside] if len(entry.reason.split()) < 3]
    return found


class Sorter:
    """Tells which mutants are not to be judged."""

    def __init__(self, equivalents: list, outside: list):
        self.by_file = {}
        for entry in equivalents:
            self.by_file.setdefault(entry.file, []).append(entry)
        self.outside = outside

    def sort(self, mutant) -> str:
        """equivalent, outside, or an empty text."""
        if any(entry.matches(mutant) for entry in self.by_file.get(mutant.file, ())):
            return "equivalent"
        return "outside" if any(entry.matches(mutant) for entry in self.outside) else ""
