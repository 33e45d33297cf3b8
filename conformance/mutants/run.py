#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Builds implementations that are broken on purpose, the mutants of the *.toml files here, and judges each of them.

    conformance/mutants/run.py [--build build/release] [--filter GLOB] [--table docs/reference/conformance.md]

The run copies the sources to BUILD/mutants/source, makes one mutant at a time there, and builds only the library. A mutant is
caught if a case fails that passes with the true implementation. Cases that cite its sentence run first, and all others only if
these pass. Exit status: 0 if every mutant is caught and the true implementation passes the cases that catch them, 1 otherwise,
2 if a mutant cannot be made.
"""
import argparse
import contextlib
import dataclasses
import fnmatch
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
COPIED = ("CMakeLists.txt", "LICENSE", "cmake", "docs/man", "glark", "include", "shim")
PASSING = {"Pass", "NotSupported", "QualityWarning", "Unimplemented"}
BATCH = 25  # cases in one process, where there are many
MARKERS = ("<!-- mutants -->", "<!-- /mutants -->")
TABLE = ROOT / "docs/reference/conformance.md"  # of the last whole run


class Complaint(Exception):
    pass


@dataclasses.dataclass
class Mutant:
    name: str
    clause: str
    what: str
    edits: list
    api: str = ""

    def apis(self) -> list:
        return [self.api] if self.api else ["gl-compat", "gl-core"]


@dataclasses.dataclass
class Outcome:
    mutant: Mutant
    failed: list  # names of cases, in the order in which they failed
    by_clause: bool  # whether these cases cite the mutant's sentence
    seconds: float
    problem: str = ""  # why it could not be built

    def caught_by(self) -> str:
        if self.problem:
            return self.problem
        if not self.failed:
            return "NOT CAUGHT"
        return self.failed[0] + ("" if self.by_clause else " (of another sentence)")


def read_mutants() -> list:
    mutants = []
    for path in sorted(HERE.glob("*.toml")):
        try:
            entries = tomllib.loads(path.read_text())["mutant"]
        except (tomllib.TOMLDecodeError, KeyError) as error:
            raise Complaint(f"{path.name}: {error}") from error
        for entry in entries:
            if "edits" not in entry:
                entry["edits"] = [{key: entry.pop(key, "") for key in ("file", "old", "new")}]
            try:
                mutants.append(Mutant(**entry))
            except TypeError as error:
                raise Complaint(f"{path.name}: {entry.get('name', 'a mutant without a name')}: {error}") from error
    return mutants


def mutated(mutant: Mutant, folder: pathlib.Path) -> dict:
    """The texts of the files that the mutant changes."""
    texts = {}
    for edit in mutant.edits:
        path = folder / edit["file"]
        if not path.is_file():
            raise Complaint(f"{mutant.name}: there is no {edit['file']}")
        text = texts.get(path) or path.read_text()
        found = text.count(edit["old"])
        if not edit["old"] or found != 1 or edit["old"] == edit["new"]:
            raise Complaint(f"{mutant.name}: what it replaces occurs {found} times in {edit['file']}: {edit['old']!r}")
        texts[path] = text.replace(edit["old"], edit["new"])
    return texts


def check(mutants: list) -> None:
    clauses = {line.split(" ", 1)[0] for line in (HERE.parent / "clauses/clauses.txt").read_text().splitlines()}
    complaints = []
    names = [mutant.name for mutant in mutants]
    complaints += [f"{name}: two mutants have this name" for name in sorted({n for n in names if names.count(n) > 1})]
    for mutant in mutants:
        if mutant.clause not in clauses:
            complaints.append(f"{mutant.name}: there is no sentence {mutant.clause}")
        if mutant.api not in ("", "gl-compat", "gl-core", "gles"):
            complaints.append(f"{mutant.name}: there is no API {mutant.api}")
        try:
            mutated(mutant, ROOT)
        except Complaint as complaint:
            complaints.append(str(complaint))
    if complaints:
        raise Complaint("\n".join(complaints))


def copy_sources(source: pathlib.Path) -> None:
    """Copies only files that differ, so that ninja builds only what a mutant changes."""
    listed = subprocess.run(["git", "ls-files", "-z", *COPIED], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    names = {name for name in listed.split("\0") if name and (ROOT / name).is_file()}
    for old in [path for path in source.rglob("*") if path.is_file() and str(path.relative_to(source)) not in names]:
        old.unlink()
    for name in sorted(names):
        path = source / name
        if not path.is_file() or path.read_bytes() != (ROOT / name).read_bytes():
            path.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, path)


@contextlib.contextmanager
def made(mutant: Mutant, source: pathlib.Path):
    texts = mutated(mutant, source)
    before = {path: path.read_text() for path in texts}
    try:
        for path, text in texts.items():
            path.write_text(text)
        yield
    finally:
        for path, text in before.items():
            path.write_text(text)


class Laboratory:
    def __init__(self, arguments: argparse.Namespace):
        build = pathlib.Path(arguments.build).resolve()
        self.jobs = arguments.jobs
        self.quick = arguments.quick
        self.first = ["--fail-fast"] if arguments.first else []
        self.suite = build / "bin/glark-conformance"
        if not self.suite.is_file():
            raise Complaint(f"{self.suite} is missing: build the target glark-conformance first")
        self.folder = build / "mutants"
        self.source = self.folder / "source"
        self.library = self.folder / "build/lib/libGLARK.so"
        self.truth = self.folder / "libGLARK.so"
        self.known = {}  # {API: {case: whether the true implementation passes it}}, of cases that a mutant has failed
        self.catchers = catchers_in(TABLE.read_text()) if arguments.first else {}
        cases = json.loads(self.call("--list", "--json").stdout)["cases"]
        self.cases = {case["name"]: case["clauses"] for case in cases if case["written"]}

    def call(self, *arguments) -> subprocess.CompletedProcess:
        return subprocess.run([self.suite, *map(str, arguments)], capture_output=True, text=True, check=False)

    def configure(self) -> None:
        copy_sources(self.source)
        compiler_cache = []
        if shutil.which("ccache"):
            compiler_cache = ["-DCMAKE_C_COMPILER_LAUNCHER=ccache", "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"]
        command = ["cmake", "-S", self.source, "-B", self.folder / "build", "-G", "Ninja", "-DGLARK_MUTANT=ON", "-DGLARK_TESTS=OFF",
                   "-DGLARK_BENCH=OFF", "-DGLARK_WERROR=OFF", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
                   f"-DPython3_EXECUTABLE={sys.executable}", *compiler_cache]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Complaint(f"the copy cannot be configured:\n{done.stdout}{done.stderr}")

    def make_library(self) -> str:
        """Returns what went wrong, or an empty text."""
        command = ["cmake", "--build", self.folder / "build", "--target", "GLARK", "--parallel", str(self.jobs)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        errors = [line for line in done.stdout.splitlines() if "error" in line]
        return "" if done.returncode == 0 else "DOES NOT BUILD: " + (errors[0] if errors else done.stdout[-300:])

    def judge(self, api: str, names: list, batch: int, *options) -> list:
        """Returns the names of cases that failed, without those that the true implementation fails, in the order of the run."""
        known = self.known.setdefault(api, {})
        while True:
            names = [name for name in names if known.get(name, True)]
            failed = self.judge_library(self.library, api, names, batch, *options)
            new = [name for name in failed if name not in known]
            if new:
                wrong = self.judge_library(self.truth, api, new, 1)
                known |= {name: name not in wrong for name in new}
            caught = [name for name in failed if known[name]]
            if caught or not failed:
                return caught

    def judge_library(self, library: pathlib.Path, api: str, names: list, batch: int, *options) -> list:
        if not names:
            return []
        report = self.folder / "report"
        shutil.rmtree(report, ignore_errors=True)
        case_list = self.folder / "cases"
        case_list.write_text("\n".join(names) + "\n")
        platform = "egl" if api == "gles" else "osmesa"
        done = self.call("--platform", platform, "--api", api, "--implementation", library, "--caselist", case_list, "--jobs",
                         self.jobs, "--batch", batch, "--report", report, *options)
        if not (report / "results.json").is_file():
            raise Complaint(f"glark-conformance has not judged anything:\n{done.stderr}")
        records = json.loads((report / "results.json").read_text())["results"]
        return [record["name"] for record in records if record["verdict"] not in PASSING]

    def make_truth(self) -> None:
        problem = self.make_library()
        if problem:
            raise Complaint(f"the true implementation: {problem}")
        shutil.copyfile(self.library, self.truth)

    def print_wrong(self) -> bool:
        """Prints the cases that the true implementation failed. Returns whether there are any."""
        wrong = [(api, name) for api, known in self.known.items() for name, passes in known.items() if not passes]
        for api, name in wrong:
            print(f"the true implementation fails {name}, {api}")
        return bool(wrong)

    def try_mutant(self, mutant: Mutant) -> Outcome:
        began = time.monotonic()
        outcome = Outcome(mutant, [], True, 0)
        with made(mutant, self.source):
            outcome.problem = self.make_library()
            citing = [name for name, clauses in self.cases.items() if mutant.clause in clauses]
            others = [name for name in self.cases if name not in citing]
            rounds = [(citing, (1, *self.first))] + ([] if self.quick else [(others, (BATCH, "--fail-fast"))])
            if self.catchers.get(mutant.name) in citing:
                rounds.insert(0, ([self.catchers[mutant.name]], (1,)))
            for names, options in [] if outcome.problem else rounds:
                for api in mutant.apis():
                    outcome.failed = outcome.failed or self.judge(api, names, *options)
                if outcome.failed:
                    break
                outcome.by_clause = names is not others
        outcome.seconds = time.monotonic() - began
        return outcome


def catchers_in(table: str) -> dict:
    """The case that caught each mutant, {name: case}, from the rows of a table. Cases of other sentences are left out."""
    cells = [[cell.strip() for cell in line.split(" | ")] for line in table.splitlines() if line.startswith("| `")]
    return {row[0].split("`")[1]: row[3] for row in cells if len(row) == 5 and " " not in row[3]}


def row_of(outcome: Outcome) -> str:
    mutant = outcome.mutant
    return f"| `{mutant.name}` | {mutant.clause} | {mutant.what} | {outcome.caught_by()} | {len(outcome.failed)} |"


def table_of(rows: list) -> str:
    caught = sum(1 for row in rows if not row.endswith("| 0 |"))
    lines = ["| mutant | sentence | what is wrong | caught by | failed |", "|---|---|---|---|---|", *rows]
    return f"{caught} of {len(rows)} mutants are caught.\n\n" + "\n".join(lines) + "\n"


def write_table(path: pathlib.Path, outcomes: list, names: list, first: bool = False) -> None:
    """Writes rows in the order of all mutants. Mutants that were not tried keep their rows, and with `first` also those that
    are still caught: their rows count all cases that failed."""
    text = path.read_text()
    begin, end = (text.find(marker) for marker in MARKERS)
    if begin < 0 or end < begin:
        raise Complaint(f"{path} has no {MARKERS[0]} before a {MARKERS[1]}")
    rows = {line.split("`")[1]: line for line in text[begin:end].splitlines() if line.startswith("| `")}
    was_caught = {name for name, row in rows.items() if not row.endswith("| 0 |")}
    kept = {outcome.mutant.name for outcome in outcomes if first and outcome.failed} & was_caught
    rows |= {outcome.mutant.name: row_of(outcome) for outcome in outcomes if outcome.mutant.name not in kept}
    table = table_of([rows[name] for name in names if name in rows])
    path.write_text(text[:begin] + MARKERS[0] + "\n" + table + text[end:])


def run(arguments: argparse.Namespace, mutants: list) -> int:
    if arguments.table and not pathlib.Path(arguments.table).is_file():
        raise Complaint(f"{arguments.table} is missing")
    laboratory = Laboratory(arguments)
    laboratory.configure()
    laboratory.make_truth()
    outcomes = []
    for mutant in mutants:
        outcome = laboratory.try_mutant(mutant)
        outcomes.append(outcome)
        print(f"{mutant.name:32} {mutant.clause:14} {outcome.seconds:6.1f} s {len(outcome.failed):4}  {outcome.caught_by()}", flush=True)
        if arguments.table:
            write_table(pathlib.Path(arguments.table), outcomes, [mutant.name for mutant in read_mutants()], arguments.first)
    wrong = laboratory.print_wrong()
    missed = [outcome for outcome in outcomes if not outcome.failed]
    print(f"{len(outcomes) - len(missed)} of {len(outcomes)} mutants are caught")
    for outcome in missed:
        print(f"    {outcome.mutant.name}: {outcome.mutant.clause}: {outcome.mutant.what}")
    if any(outcome.problem for outcome in outcomes):
        return 2
    return 1 if missed or wrong else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--build", default=str(ROOT / "build/release"), help="directory with a built glark-conformance")
    parser.add_argument("--filter", action="append", metavar="GLOB", help="only mutants whose names match; may be repeated")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="number of parallel processes")
    parser.add_argument("--quick", action="store_true", help="run only the cases that cite the mutant's sentence")
    parser.add_argument("--first", action="store_true", help="begin with the case that the table names, and stop at the first case that fails")
    parser.add_argument("--list", action="store_true", help="print the mutants")
    parser.add_argument("--check", action="store_true", help="only check that every mutant can be made")
    parser.add_argument("--table", metavar="FILE", help="write the rows of the mutants tried into the table between the markers of this document")
    arguments = parser.parse_args()
    try:
        mutants = read_mutants()
        if arguments.check:
            check(mutants)
            print(f"{len(mutants)} mutants can be made")
            return 0
        globs = arguments.filter or ["*"]
        mutants = [mutant for mutant in mutants if any(fnmatch.fnmatchcase(mutant.name, glob) for glob in globs)]
        if not mutants:
            raise Complaint("no mutant has such a name: " + " ".join(globs))
        if arguments.list:
            for mutant in mutants:
                print(f"{mutant.name:32} {mutant.clause:14} {mutant.what}")
            return 0
        return run(arguments, mutants)
    except Complaint as complaint:
        print(f"run.py: {complaint}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
