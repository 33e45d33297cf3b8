# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Runs conformance cases with the library that holds all mutants: first to see which mutants each reaches, then to judge."""
import base64
import dataclasses
import json
import os
import pathlib
import signal
import subprocess
import threading
import zlib

import run

PLATFORMS = {"gl-compat": "osmesa", "gl-core": "osmesa", "gles": "egl"}
JUDGING = {"Pass", "QualityWarning"}  # what the true implementation's case must give, so that it judges mutants
BAD = {"Fail", "InternalError", "Crash", "Timeout", "Missing"}
MOST_MEMORY = 12 << 20  # in KiB of addresses
SILENCE = 60  # seconds in which a process that computes nothing counts as one that waits for ever


@dataclasses.dataclass
class CaseRun:
    """What a process with some cases has given."""
    verdicts: list  # [(case, verdict)]
    cpu: float  # seconds
    failed: str = ""  # the first case that failed
    how: str = ""  # its verdict, or how the process ended


@dataclasses.dataclass
class Reach:
    """One case of one API with the true implementation."""
    api: str
    case: str
    verdict: str
    cpu: float
    mutants: frozenset

    def line(self) -> str:
        bits = bytearray(1 + max(self.mutants, default=0) // 8)
        for number in self.mutants:
            bits[number // 8] |= 1 << number % 8
        return json.dumps({"api": self.api, "case": self.case, "verdict": self.verdict, "cpu": round(self.cpu, 3),
                           "mutants": base64.b64encode(zlib.compress(bytes(bits))).decode()})


def reach_of(line: str) -> Reach:
    fields = json.loads(line)
    bits = zlib.decompress(base64.b64decode(fields["mutants"]))
    numbers = frozenset(8 * i + bit for i, byte in enumerate(bits) if byte for bit in range(8) if byte >> bit & 1)
    return Reach(fields["api"], fields["case"], fields["verdict"], fields["cpu"], numbers)


class Watch:
    """Ends a process that neither computes nor ends."""

    def __init__(self, process: subprocess.Popen):
        self.process = process
        self.hangs = False
        self.over = threading.Event()
        self.thread = threading.Thread(target=self.watch, daemon=True)
        self.thread.start()

    def watch(self) -> None:
        before = -1.0
        while not self.over.wait(SILENCE):
            used = cpu_of(self.process.pid)
            if used - before < 0.05:
                self.hangs = True
                end(self.process)
                return
            before = used


def cpu_of(pid: int) -> float:
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    except OSError:
        return 0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def end(process: subprocess.Popen) -> None:
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


class Laboratory:
    def __init__(self, suite: pathlib.Path, library: pathlib.Path, folder: pathlib.Path):
        self.suite = suite
        self.library = library
        self.folder = folder
        if not suite.is_file():
            raise run.Complaint(f"{suite} is missing: build the target glark-conformance first")

        done = subprocess.run([self.suite, "--list", "--json"], capture_output=True, text=True, check=True)
        self.listed = [case for case in json.loads(done.stdout)["cases"] if case["written"]]
        self.optional = {case["name"] for case in self.listed if case["optional"]}

    def cases(self, api: str) -> list:
        return [case["name"] for case in self.listed if api in case["apis"]]

    def run(self, api: str, names: list, mutant: int = -1, reached: pathlib.Path | None = None, most_cpu: float = 60) -> CaseRun:
        """Runs the cases in one process until one fails. `mutant` -1 is the true implementation."""
        limits = f'ulimit -t {max(1, round(most_cpu))} -v {MOST_MEMORY}; LD_PRELOAD="$1"; export LD_PRELOAD; shift; exec "$@" 3>&1 1>&2'
        command = ["/bin/sh", "-c", limits, "sh", self.library, self.suite, "worker", "run", "--platform", PLATFORMS[api], "--api", api,
                   "--implementation", self.library, *names]
        environment = {name: value for name, value in os.environ.items() if not name.startswith("GLARK")}
        environment |= {"GLARK_MUTANT": str(mutant)} | ({"GLARK_MUTANT_REACHED": str(reached)} if reached else {})
        process = subprocess.Popen([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                   env=environment, start_new_session=True)
        watch = Watch(process)
        result = CaseRun([], 0)
        for line in process.stdout:
            self.read(line, result)
            if result.failed:
                end(process)
                break
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = status
        process.stdout.close()
        watch.over.set()
        if os.WIFEXITED(status) and os.WEXITSTATUS(status) in (126, 127):
            raise run.Complaint(f"{self.suite} cannot be started")
        result.cpu = usage.ru_utime + usage.ru_stime
        left = [name for name in names if name not in {case for case, _ in result.verdicts}]
        if left and not result.failed:
            result.failed = left[0]
            result.how = "Timeout" if watch.hangs or status & 127 == signal.SIGXCPU or result.cpu >= most_cpu else "Crash"
        return result

    def read(self, line: bytes, result: CaseRun) -> None:
        """NotSupported is no answer of a case that the true implementation passes, unless what it asks for is optional."""
        try:
            message = json.loads(line)
        except ValueError:
            return
        if "end" not in message:
            return
        result.verdicts.append((message["end"], message["verdict"]))
        bad = message["verdict"] in BAD or (message["verdict"] == "NotSupported" and message["end"] not in self.optional)
        if bad and not result.failed:
            result.failed, result.how = message["end"], message["verdict"]

    def reach(self, api: str, cases: list) -> list:
        """Runs cases in one process with the true implementation, and notes which mutants they reach together."""
        path = self.folder / f"reached-{os.getpid()}-{threading.get_ident()}"
        path.unlink(missing_ok=True)
        done = self.run(api, cases, reached=path, most_cpu=600)
        numbers = frozenset(i for i, byte in enumerate(path.read_bytes()) if byte) if path.is_file() else frozenset()
        path.unlink(missing_ok=True)
        if done.failed and len(cases) > 1:
            return [reach for case in cases for reach in self.reach(api, [case])]
        verdicts = dict(done.verdicts)
        return [Reach(api, case, verdicts.get(case, done.how or "Missing"), done.cpu / len(cases), numbers) for case in cases]


def area_of(case: str) -> str:
    return case.split(".")[1] if "." in case else case


@dataclasses.dataclass
class Verdict:
    mutant: str  # identity
    verdict: str  # killed, survived, undecided (not tried by all cases that reach it), not covered, does not compile
    by: str = ""  # the API and the case that failed, and how
    tried: int = 0  # number of cases
    reached_by: int = 0
    cpu: float = 0


class Judge:
    """Judges one mutant after the other, each by the cases that reach it."""

    def __init__(self, laboratory: Laboratory, reaches: list, most_cases: int = 0):
        self.laboratory = laboratory
        self.reaches = [reach for reach in reaches if reach.verdict in JUDGING]
        self.most_cases = most_cases
        self.killers = {}  # {function or file: [(api, case)], the last ones first}
        self.by_mutant = {}
        for reach in self.reaches:
            for number in reach.mutants:
                self.by_mutant.setdefault(number, []).append(reach)

    def order(self, mutant) -> list:
        """Cases that caught a mutant of the same function or file come first. Then each area of the suite gives a case in turn, quick
        ones that reach little else first: much of the code is reached by most cases, and only those of one area look at it."""
        near = self.killers.get((mutant.file, mutant.function), []) + self.killers.get(mutant.file, [])
        place = {key: i for i, key in reversed(list(enumerate(near)))}
        turns = {}
        keys = []
        for reach in sorted(self.by_mutant.get(mutant.number, ()), key=lambda reach: reach.cpu * len(reach.mutants)):
            area = area_of(reach.case)
            turns[area] = turns.get(area, 0) + 1
            keys.append((place.get((reach.api, reach.case), len(near)), turns[area], len(keys), reach))
        return [key[3] for key in sorted(keys, key=lambda key: key[:3])]

    def judge(self, mutant, identity: str) -> Verdict:
        cases = self.order(mutant)
        result = Verdict(identity, "survived" if cases else "not covered", reached_by=len(cases))
        if self.most_cases:
            cases = cases[:self.most_cases]
        at, batch = 0, 1
        while at < len(cases):
            group = [reach for reach in cases[at:at + batch] if reach.api == cases[at].api]
            at += len(group)
            batch = min(2 * batch, 32)
            done = self.try_group(mutant, group)
            result.tried = at
            result.cpu += done.cpu
            if done.how == "does not compile":
                result.verdict = done.how
                return result
            if done.failed:
                result.verdict, result.by = "killed", f"{group[0].api} {done.failed} {done.how}"
                self.remember(mutant, group[0].api, done.failed)
                return result
        if result.tried < result.reached_by:
            result.verdict = "undecided"
        return result

    def try_group(self, mutant, group: list) -> CaseRun:
        path = self.laboratory.folder / f"state-{mutant.number}-{threading.get_ident()}" if mutant.is_glsl else None
        done = self.laboratory.run(group[0].api, [reach.case for reach in group], mutant.number, path,
                                   most_cpu=10 + 10 * sum(reach.cpu for reach in group))
        if path and path.is_file():
            if path.read_bytes()[mutant.number:mutant.number + 1] == b"\2":
                done.how = "does not compile"
            path.unlink()
        return done

    def remember(self, mutant, api: str, case: str) -> None:
        for key in ((mutant.file, mutant.function), mutant.file):
            known = self.killers.setdefault(key, [])
            if (api, case) not in known:
                known.insert(0, (api, case))
            del known[8:]
