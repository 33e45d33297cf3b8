#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Judges the library by piglit: a test that passes on the plain driver must pass with the library off, and refined linearly.

Every mode's outcomes are kept, a line of JSON a test, in RESULTS/MODE.jsonl; a test that is there is not run again.
"""
import argparse
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import threading

import suite

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
PLAIN_LIMIT = 30  # seconds; a test that is slower on the plain driver is left out
LIMIT = 120       # seconds with the library; a slower test hangs

# Mode -> further environment. No draw is exempt, because an exempt draw proves nothing.
REFINED = {"GLARK_ENABLE": "1", "GLARK_EVERYTHING": "1", "GLARK_WAIT": "1"}
MODES = {
    "plain": None,
    "again": None,  # the second run on the plain driver: a test that changes is not stable
    "off": {},
    "outputs-2": {**REFINED, "GLARK_REFINE": "outputs", "GLARK_LEVEL": "2"},
    "outputs-3": {**REFINED, "GLARK_REFINE": "outputs", "GLARK_LEVEL": "3"},
    "edge-8": {**REFINED, "GLARK_REFINE": "outputs", "GLARK_EDGE_PIXELS": "8"},
    "inputs-2": {**REFINED, "GLARK_REFINE": "linear", "GLARK_LEVEL": "2"},
    "smooth-2": {**REFINED, "GLARK_REFINE": "smooth", "GLARK_LEVEL": "2"},
    "pn-2": {**REFINED, "GLARK_REFINE": "pn", "GLARK_LEVEL": "2"},
}
JUDGED = [mode for mode in MODES if mode not in ("plain", "again")]
USUAL = [mode for mode in JUDGED if mode != "pn-2"]  # curved triangles change what tests draw; only a slice was looked at
TARGET = {"off": 1.0, "outputs-2": 0.999, "outputs-3": 0.999, "edge-8": 0.999, "inputs-2": 0.99, "smooth-2": 0.999,
          "pn-2": 0.99}


class Displays:
    """An X server for each worker, so that windows of parallel tests do not cover each other."""

    def __init__(self, count: int) -> None:
        self.servers_, self.local_, self.lock_ = [], threading.local(), threading.Lock()
        self.count_ = count

    def mine(self) -> str:
        if not hasattr(self.local_, "display"):
            reader, writer = os.pipe()
            server = subprocess.Popen(
                ["Xvfb", "-displayfd", str(writer), "-screen", "0", "1024x1024x24", "-noreset", "-nolisten", "tcp"],
                pass_fds=[writer], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            os.close(writer)
            with os.fdopen(reader) as answer:
                self.local_.display = ":" + answer.readline().strip()
            with self.lock_:
                self.servers_.append(server)
        return self.local_.display

    def close(self) -> None:
        for server in self.servers_:
            server.terminate()
            server.wait()


class Runner:
    def __init__(self, build: pathlib.Path, results: pathlib.Path, jobs: int) -> None:
        self.library_ = build / "lib" / "libGLARK.so"
        self.results_, self.jobs_ = results, jobs
        results.mkdir(parents=True, exist_ok=True)
        if not self.library_.exists():
            sys.exit(f"piglit: {self.library_} is missing; run scripts/build release")

    def environment(self, mode: str, statistics: pathlib.Path) -> dict:
        environment = {name: value for name, value in os.environ.items() if not name.startswith("GLARK_")}
        environment |= {"PIGLIT_PLATFORM": "glx", "PIGLIT_SOURCE_DIR": str(suite.PIGLIT), "LIBGL_ALWAYS_SOFTWARE": "1",
                        "LP_NUM_THREADS": "1", "PIGLIT_NO_FAST_SKIP": "1"}
        if MODES[mode] is not None:
            environment |= {"LD_PRELOAD": str(self.library_), "GLARK_STATS": str(statistics)}
            environment |= {"GLARK_CONFIG": "/dev/null"} | MODES[mode]
        return environment

    def kept(self, mode: str) -> dict:
        file = self.results_ / f"{mode}.jsonl"
        if not file.exists():
            return {}
        lines = (json.loads(line) for line in file.read_text().splitlines())
        return {line.pop("name"): suite.Outcome(**line) for line in lines}

    def run(self, mode: str, tests: list) -> dict:
        outcomes = self.kept(mode)
        todo = [test for test in tests if test.name not in outcomes]
        if not todo:
            return outcomes
        limit = PLAIN_LIMIT if MODES[mode] is None else LIMIT
        displays, lock = Displays(self.jobs_), threading.Lock()

        def one(test: suite.Test) -> None:
            statistics = self.results_ / f"{mode}-{threading.get_ident()}.json"
            environment = self.environment(mode, statistics) | {"DISPLAY": displays.mine()}
            outcome = suite.run(test, environment, statistics, limit)
            with lock, (self.results_ / f"{mode}.jsonl").open("a") as file:
                outcomes[test.name] = outcome
                file.write(json.dumps({"name": test.name} | dataclasses.asdict(outcome)) + "\n")
                done = sum(test.name in outcomes for test in tests)
                if done % 100 == 0:
                    print(f"{mode}: {done} of {len(tests)}", flush=True)

        try:
            with concurrent.futures.ThreadPoolExecutor(self.jobs_) as pool:
                for done in [pool.submit(one, test) for test in todo]:
                    done.result()
        finally:
            displays.close()
            for leftover in self.results_.glob(f"{mode}-*.json"):
                leftover.unlink()
        return outcomes


def known_differences() -> list:
    """(mode pattern, test pattern, reason) of each line of differences.txt."""
    known = []
    for line in (HERE / "differences.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            modes, test, reason = (part.strip() for part in line.split(" | ", 2))
            known.append((re.compile(modes), re.compile(test), reason))
    return known


def reason_of(known: list, mode: str, name: str) -> str:
    for modes, test, reason in known:
        if modes.fullmatch(mode) and test.fullmatch(name):
            return reason
    return ""


def describe(plain: suite.Outcome, other: suite.Outcome) -> str:
    changed = [f"{name}: {plain.subtests.get(name)} -> {other.subtests.get(name)}"
               for name in sorted(plain.subtests.keys() | other.subtests.keys())
               if plain.subtests.get(name) != other.subtests.get(name)]
    return ", ".join([f"{plain.result} -> {other.result}"] * (plain.result != other.result) + changed[:4])


def refined_draws(outcome: suite.Outcome) -> int:
    return outcome.statistics.get("draws", {}).get("refined", 0)


def judge(outcomes: dict, modes: list, names: list) -> bool:
    """Prints the table and the changes. Returns whether every target is met and every difference is known."""
    plain, known, good, lines = outcomes["plain"], known_differences(), True, []
    print(f"\n{len(names)} tests pass stably on the plain driver\n")
    print("| mode | same | of | % | target % | crashes | hangs | contexts seen | tests that refine | refined draws |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for mode in modes:
        ours = {name: outcomes[mode][name] for name in names}
        changed = [name for name in names if not ours[name].same_as(plain[name])]
        share = 1 - len(changed) / max(1, len(names))
        refined = [refined_draws(outcome) for outcome in ours.values()]
        seen = sum(bool(outcome.statistics) for outcome in ours.values())  # written where a context was made
        count = {kind: sum(outcome.result == kind for outcome in ours.values()) for kind in ("crash", "timeout")}
        print(f"| {mode} | {len(names) - len(changed)} | {len(names)} | {100 * share:.2f} | {100 * TARGET[mode]:g} | "
              f"{count['crash']} | {count['timeout']} | {seen} | {sum(r > 0 for r in refined)} | {sum(refined)} |")
        # Most tests draw once, and smooth curves a mesh from its third frame on.
        alive = 10 * seen > 9 * len(names) and (mode in ("off", "smooth-2") or sum(refined) > len(names))
        if not alive:
            lines.append(f"{mode}: too few contexts were seen or draws refined: this proves nothing")
        good &= share >= TARGET[mode] and alive
        for name in changed:
            reason = reason_of(known, mode, name)
            good &= bool(reason)
            lines.append(f"{mode}: {name}: {describe(plain[name], ours[name])}: {reason or 'NOT EXPLAINED'}")
    print()
    print("\n".join(lines) if lines else "No test changed.")
    return good


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="a build folder, with lib/libGLARK.so")
    parser.add_argument("--results", type=pathlib.Path, required=True, help="folder in which outcomes are kept")
    parser.add_argument("--variants", type=int, default=1, help="so many tests of each family (default: 1)")
    parser.add_argument("--tests", default="", metavar="REGEX", help="only tests whose names match")
    parser.add_argument("--list", type=pathlib.Path, metavar="FILE", help="only the tests that FILE names, a line each")
    parser.add_argument("--part", default="1/1", metavar="I/N", help="the I-th of N parts, each a mixture of all kinds")
    parser.add_argument("--modes", default=",".join(USUAL), help="comma separated, of: " + ", ".join(JUDGED))
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--fresh", action="store_true", help="forget what the judged modes gave before")
    arguments = parser.parse_args()
    for program in ("piglit", "Xvfb"):
        if not shutil.which(program):
            sys.exit(f"piglit: {program} is not installed; run scripts/install_packages")
    modes = arguments.modes.split(",")
    if unknown := [mode for mode in modes if mode not in JUDGED]:
        parser.error(f"no mode {unknown[0]}; there are {', '.join(JUDGED)}")

    chosen = suite.tests(10**9 if arguments.list else arguments.variants)
    if arguments.list:
        wanted = set(arguments.list.read_text().splitlines())
        chosen = [test for test in chosen if test.name in wanted]
        if missing := wanted - {test.name for test in chosen} - {""}:
            print(f"piglit: this version has no test {sorted(missing)[0]} ({len(missing)} such)", file=sys.stderr)
    chosen = [test for test in chosen if re.search(arguments.tests, test.name)]
    part, parts = (int(number) for number in arguments.part.split("/"))
    chosen = chosen[part - 1::parts]
    runner = Runner(arguments.build.resolve(), arguments.results.resolve(), arguments.jobs)
    if arguments.fresh:
        for mode in modes:
            (runner.results_ / f"{mode}.jsonl").unlink(missing_ok=True)
    outcomes = {"plain": runner.run("plain", chosen)}
    passing = [test for test in chosen if outcomes["plain"][test.name].result == "pass"]
    outcomes["again"] = runner.run("again", passing)
    stable = [test for test in passing if outcomes["again"][test.name].same_as(outcomes["plain"][test.name])]
    for mode in modes:
        outcomes[mode] = runner.run(mode, stable)
    return 0 if judge(outcomes, modes, [test.name for test in stable]) else 1


sys.exit(main())
