#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Makes mutants of the implementation by rules, all in one library, and judges them by the conformance cases that reach them.

    conformance/mutants/generated.py --sample 200 --seed 1      # builds, looks which case reaches what, judges 200 mutants
    conformance/mutants/generated.py --resume --survivors       # judges those again that survived, after cases were added
    conformance/mutants/generated.py --show 'glark/core/keep/*' # prints mutants; --check checks schemata/equivalents.toml

The library is built once. The environment variable GLARK_MUTANT chooses the mutant when a program starts. Everything lies in
BUILD/mutants/generated: the copy of the sources, the journal, table.md, survivors.txt and uncovered.txt. Exit status: 0 if no
mutant survived, 1 if some did, 2 for options or files that make no sense.
"""
import argparse
import concurrent.futures
import fnmatch
import hashlib
import os
import pathlib
import random
import sys
import threading

import run
from schemata import build, equivalents, table
from schemata.judge import PLATFORMS, Judge, Laboratory, reach_of

ROOT = run.ROOT


def say(text: str) -> None:
    print(text, flush=True)


def check() -> int:
    mutants = build.all_mutants(ROOT)
    listed, outside = equivalents.read()
    complaints = equivalents.complaints(listed, outside, mutants)
    if complaints:
        raise run.Complaint("equivalents.toml: " + "\n".join(complaints))
    say(f"{len(mutants)} mutants can be made; {len(listed)} entries say which are equivalent, {len(outside)} which are outside")
    return 0


def matching(mutants: list, globs: list) -> list:
    chosen = [mutant for mutant in mutants
              if any(fnmatch.fnmatchcase(f"{mutant.file}:{mutant.function}:{mutant.operator}", glob) or fnmatch.fnmatchcase(mutant.file, glob)
                     for glob in globs)]
    if not chosen:
        raise run.Complaint("no mutant matches " + " ".join(globs))
    return chosen


def read_reaches(path: pathlib.Path, digest: str) -> list:
    """What an earlier run of this library and suite has found out. The first line says which they were."""
    lines = path.read_text().splitlines() if path.is_file() else []
    if not lines or lines[0] != digest:
        path.write_text(digest + "\n")
        return []
    return [reach_of(line) for line in lines[1:]]


def digest_of(*paths: pathlib.Path) -> str:
    return hashlib.sha256(b"".join(path.read_bytes() for path in paths)).hexdigest()


def groups_of(pairs: list, size: int) -> list:
    """[(API, cases)] with at most so many cases each."""
    groups = []
    for api, case in pairs:
        if not groups or groups[-1][0] != api or len(groups[-1][1]) == size:
            groups.append((api, []))
        groups[-1][1].append(case)
    return groups


def reach_all(laboratory: Laboratory, apis: list, jobs: int, size: int) -> list:
    """Runs each case once with the true implementation, unless the file of reaches has it already."""
    path = laboratory.folder / "reached.jsonl"
    reaches = read_reaches(path, digest_of(laboratory.library, laboratory.suite))
    known = {(reach.api, reach.case) for reach in reaches}
    missing = [(api, case) for api in apis for case in laboratory.cases(api) if (api, case) not in known]
    say(f"{len(known)} cases: it is known which mutants they reach; {len(missing)} cases to run")
    with path.open("a") as file, concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for found in pool.map(lambda group: laboratory.reach(*group), groups_of(missing, size)):
            reaches += found
            file.write("".join(reach.line() + "\n" for reach in found))
            file.flush()
    written = {(api, case) for api in apis for case in laboratory.cases(api)}
    failed = [reach for reach in reaches if reach.verdict not in ("Pass", "QualityWarning", "NotSupported", "Unimplemented")]
    for reach in failed:
        say(f"    the true implementation fails {reach.api} {reach.case}: {reach.verdict}")
    return [reach for reach in reaches if (reach.api, reach.case) in written]


class Campaign:
    """One run: which mutants, their verdicts, the tables."""

    def __init__(self, arguments: argparse.Namespace):
        self.arguments = arguments
        self.folder = pathlib.Path(arguments.build).resolve() / "mutants/generated"
        self.mutants = build.all_mutants(ROOT, arguments.files)
        if not self.mutants:
            raise run.Complaint("no file matches " + " ".join(arguments.files))
        listed, outside = equivalents.read()
        self.sorter = equivalents.Sorter(listed, outside)
        self.library = build.Library(self.folder, ROOT, self.mutants, arguments.jobs, say)
        self.identities = table.identities_of(self.mutants, ROOT)

    def prepare(self) -> None:
        self.library.make()
        compiled = [mutant for mutant in self.mutants if mutant.number not in self.library.left_out]
        say(f"{len(self.mutants)} mutants; {len(compiled)} of them compile, in one library: {self.library.path}")
        laboratory = Laboratory(pathlib.Path(self.arguments.build).resolve() / "bin/glark-conformance", self.library.path, self.folder)
        self.judge = Judge(laboratory, reach_all(laboratory, self.arguments.api, self.arguments.jobs, self.arguments.group), self.arguments.most_cases)
        self.compiled = [mutant for mutant in compiled if self.sorter.sort(mutant) != "outside"]
        reached = [mutant for mutant in self.compiled if mutant.number in self.judge.by_mutant]
        say(f"{len(compiled) - len(self.compiled)} are outside the specification; {len(reached)} of the other {len(self.compiled)} are "
            f"reached by a case")
        (self.folder / "uncovered.txt").write_text("".join(
            f"{mutant.text()}\n" for mutant in self.compiled if mutant.number not in self.judge.by_mutant))
        self.chosen = self.sample(matching(reached if self.arguments.covered else self.compiled, self.arguments.filter or ["*"]))

    def sample(self, mutants: list) -> list:
        count = self.arguments.sample
        if not count or count >= len(mutants):
            return mutants
        return random.Random(self.arguments.seed).sample(mutants, count)

    def run(self) -> int:
        self.prepare()
        journal = table.Journal(self.folder / "journal.jsonl", self.arguments.resume)
        left = [mutant for mutant in self.chosen if self.is_left(mutant, journal)]
        say(f"{len(self.chosen)} mutants are chosen; {len(left)} of them are to be judged")
        lock = threading.Lock()

        def one(mutant) -> None:
            verdict = self.judge.judge(mutant, self.identities[mutant.number])
            with lock:
                journal.add(verdict)
            say(f"{verdict.verdict:12} {verdict.tried:4} of {verdict.reached_by:4} cases {verdict.cpu:6.1f} s  {mutant.text()}"
                f"{'  by ' + verdict.by if verdict.by else ''}")

        with concurrent.futures.ThreadPoolExecutor(self.arguments.jobs) as pool:
            list(pool.map(one, left))
        return self.report(journal)

    def is_left(self, mutant, journal: table.Journal) -> bool:
        known = journal.verdicts.get(self.identities[mutant.number])
        if self.sorter.sort(mutant):
            return False
        return known is None or (self.arguments.survivors and known.verdict in ("survived", "undecided"))

    def kind(self, mutant, journal: table.Journal) -> str:
        return self.sorter.sort(mutant) or journal.verdicts[self.identities[mutant.number]].verdict

    def report(self, journal: table.Journal) -> int:
        judged = [(mutant, self.kind(mutant, journal)) for mutant in self.chosen]
        text = table.table_of(judged)
        survivors = "".join(table.survivors_of(judged, journal.verdicts, self.identities, kind) for kind in ("survived", "undecided"))
        (self.folder / "table.md").write_text(text)
        (self.folder / "survivors.txt").write_text(survivors)
        say("\n" + text + "\nsurvived:\n" + survivors)
        if self.arguments.table:
            table.write_table(pathlib.Path(self.arguments.table), text)
        return 1 if survivors else 0


def options() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--build", default=str(ROOT / "build/release"), help="directory with a built glark-conformance")
    parser.add_argument("--check", action="store_true", help="only check that each entry of schemata/equivalents.toml is a mutant")
    parser.add_argument("--show", metavar="GLOB", help="print the mutants of such files, and stop")
    parser.add_argument("--files", action="append", metavar="GLOB",
                        help="a library with mutants of these files only, which is built sooner; may be repeated")
    parser.add_argument("--filter", action="append", metavar="GLOB", help="only such mutants: of FILE or FILE:FUNCTION:OPERATOR; may be repeated")
    parser.add_argument("--sample", type=int, default=0, metavar="N", help="judge N mutants, drawn at random")
    parser.add_argument("--seed", type=int, default=1, help="seed of the sample")
    parser.add_argument("--covered", action="store_true", help="draw the sample from mutants that a case reaches")
    parser.add_argument("--api", action="append", choices=sorted(PLATFORMS), help="judge by the cases of this API; may be repeated (default: all)")
    parser.add_argument("--group", type=int, default=1, metavar="N",
                        help="N cases share a process when it is noted what they reach: quicker, but less exact")
    parser.add_argument("--most-cases", type=int, default=0, metavar="N", help="judge a mutant by at most N cases; one that passes them is undecided")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="number of parallel processes")
    parser.add_argument("--resume", action="store_true", help="keep the verdicts of the journal, and judge the rest")
    parser.add_argument("--survivors", action="store_true", help="with --resume: judge again what survived or is undecided")
    parser.add_argument("--table", metavar="FILE", help="write the table between the markers of this document")
    return parser


def main() -> int:
    arguments = options().parse_args()
    arguments.api = arguments.api or list(PLATFORMS)
    try:
        if arguments.check:
            return check()
        if arguments.show:
            for mutant in matching(build.all_mutants(ROOT), [arguments.show]):
                print(mutant.text())
            return 0
        return Campaign(arguments).run()
    except run.Complaint as complaint:
        print(f"generated.py: {complaint}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
