# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The journal of what was judged, and the tables made of it."""
import collections
import dataclasses
import hashlib
import json
import pathlib

import run

from .judge import Verdict

MARKERS = ("<!-- generated mutants -->", "<!-- /generated mutants -->")
COLUMNS = ("killed", "survived", "undecided", "not covered", "equivalent", "does not compile")


def identities_of(mutants: list, root: pathlib.Path) -> dict:
    """{number: identity}. It stays the same while the mutant's file stays the same."""
    counts = collections.Counter()
    digests = {name: hashlib.sha256((root / name).read_bytes()).hexdigest()[:12] for name in {mutant.file for mutant in mutants}}
    identities = {}
    for mutant in mutants:
        counts[mutant.key()] += 1
        text = json.dumps([digests[mutant.file], *mutant.key(), counts[mutant.key()]])
        identities[mutant.number] = hashlib.sha256(text.encode()).hexdigest()[:16]
    return identities


class Journal:
    """Verdicts, one a line. A later line of a mutant replaces an earlier one."""

    def __init__(self, path: pathlib.Path, resume: bool):
        self.path = path
        self.verdicts = {}
        path.parent.mkdir(parents=True, exist_ok=True)
        if not resume:
            path.unlink(missing_ok=True)
        for line in path.read_text().splitlines() if path.is_file() else ():
            verdict = Verdict(**json.loads(line))
            self.verdicts[verdict.mutant] = verdict

    def add(self, verdict: Verdict) -> None:
        self.verdicts[verdict.mutant] = verdict
        with self.path.open("a") as file:
            file.write(json.dumps(dataclasses.asdict(verdict)) + "\n")


@dataclasses.dataclass
class Row:
    name: str
    counts: collections.Counter

    def made(self) -> int:
        return sum(self.counts[column] for column in COLUMNS) - self.counts["does not compile"]

    def rate(self, among: int) -> str:
        return f"{100 * self.counts['killed'] / among:.1f} %" if among > 0 else ""

    def line(self) -> str:
        wanted = self.made() - self.counts["equivalent"]
        cells = [self.made(), self.counts["equivalent"], self.counts["not covered"], self.counts["undecided"], self.counts["survived"], self.counts["killed"],
                 self.rate(wanted), self.rate(wanted - self.counts["not covered"])]
        return f"| {self.name} | " + " | ".join(map(str, cells)) + " |"


def rows_of(judged: list, name_of) -> list:
    counts = {}
    for mutant, kind in judged:
        counts.setdefault(name_of(mutant), collections.Counter())[kind] += 1
    return [Row(name, counts[name]) for name in sorted(counts)]


def table_of(judged: list) -> str:
    """`judged`: [(mutant, kind)] with the kinds of COLUMNS."""
    head = ["| | made | equivalent | not reached | undecided | survived | killed | killed of all | killed of those reached |", "|---|---|---|---|---|---|---|---|---|"]
    lines = [*head, *(row.line() for row in rows_of(judged, lambda mutant: mutant.operator + (" in GLSL" if mutant.is_glsl else ""))), *(
        row.line() for row in rows_of(judged, lambda mutant: f"`{mutant.folder()}`")), *(row.line() for row in rows_of(judged, lambda _: "all"))]
    return "\n".join(lines) + "\n"


def survivors_of(judged: list, verdicts: dict, identities: dict, kind: str = "survived") -> str:
    lines = []
    for mutant, found in judged:
        if found == kind:
            verdict = verdicts.get(identities[mutant.number])
            lines.append(f"{mutant.text()}  [reached by {verdict.reached_by if verdict else 0} cases]")
    return "\n".join(sorted(lines)) + ("\n" if lines else "")


def write_table(path: pathlib.Path, text: str) -> None:
    document = path.read_text()
    begin, last = (document.find(marker) for marker in MARKERS)
    if begin < 0 or last < begin:
        raise run.Complaint(f"{path} has no {MARKERS[0]} before a {MARKERS[1]}")
    path.write_text(document[:begin] + MARKERS[0] + "\n" + text + document[last:])
