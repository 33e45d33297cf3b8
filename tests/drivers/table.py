# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Makes the table of drivers of what run.py has left."""
import json
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
BEGIN, END = "<!-- drivers -->", "<!-- end of drivers -->"
CELLS = [f"{platform}-{api}" for platform, apis in (("egl", ("gl-compat", "gl-core", "gles")), ("glx", ("gl-compat", "gl-core", "gles")),
                                                    ("osmesa", ("gl-compat", "gl-core"))) for api in apis]
UNKNOWN = "not explained"
SYSTEM = "system"  # the driver that programs get here: that of the graphics card, if there is one
GOOD = ("Pass", "NotSupported", "QualityWarning", "Unimplemented")


def version_of(text: str) -> str:
    return re.sub(r".*((?:Mesa|ANGLE|NVIDIA) [0-9.]+).*", r"\1", text)


class Row:
    """The results of one driver in one folder."""

    def __init__(self, folder: pathlib.Path) -> None:
        self.name = folder.name
        lines = (folder / "faults.txt").read_text().splitlines() if (folder / "faults.txt").exists() else []
        said = dict(line.split(": ", 1) for line in lines)
        self.obstacle = said.pop("cannot run", "")
        self.version = version_of(said.pop("version", ""))
        self.renderer = said.pop("renderer", "")
        self.faults = {name: text.split(": ", 1)[1] for name, text in said.items() if text.startswith("yes")}
        self.cells = {cell: json.loads(file.read_text()) for cell in CELLS
                      if (file := folder / cell / "results.json").exists()}
        for results in self.cells.values():
            self.version = self.version or version_of(results["environment"]["version"])
        self.clients = json.loads((folder / "clients.json").read_text()) if (folder / "clients.json").exists() else {}
        self.piglit = self.piglit_of(folder / "piglit.txt")

    @property
    def title(self) -> str:
        # The system's driver has the name of its graphics card.
        name = re.split("[/(]", self.renderer)[0].strip() if self.name == SYSTEM and self.renderer else self.name
        return f"{name}, {self.version}" if self.version else name

    @staticmethod
    def piglit_of(file: pathlib.Path) -> dict:
        """Mode -> (unchanged tests, tests)."""
        rows = re.findall(r"^\| (off|outputs-2) \| (\d+) \| (\d+) ", file.read_text(), re.M) if file.exists() else []
        return {mode: (int(same), int(tests)) for mode, same, tests in rows}

    def bad(self) -> dict:
        """Case -> (cells in which it is bad, its first message)."""
        found = {}
        for cell, results in self.cells.items():
            for result in results["results"]:
                if result["verdict"] not in GOOD:
                    said = (result["messages"] or result["output"].splitlines()[-1:] or [result["verdict"]])[0]
                    found.setdefault(result["name"], ([], said))[0].append(cell)
        return found


def reasons() -> list:
    lines = (HERE / "failures.txt").read_text().splitlines()
    return [tuple(part.strip() for part in line.split(" | ", 2)) for line in lines if line and not line.startswith("#")]


def reason_of(row: Row, case: str) -> str:
    for driver, pattern, reason in reasons():
        if re.fullmatch(driver, row.title) and re.fullmatch(pattern, case):
            return reason
    return UNKNOWN


def cell_text(row: Row, cell: str, all_cases: int) -> str:
    if cell not in row.cells:
        return "-"
    results = [result["verdict"] for result in row.cells[cell]["results"]]
    bad = sum(verdict not in GOOD for verdict in results)
    passed = sum(verdict == "Pass" for verdict in results)
    parts = round(all_cases / max(1, len(results)))
    part = f" (1 in {parts})" if parts > 1 else ""
    return f"{passed}{part}, **{bad} fail**" if bad else f"{passed}{part}"


def clients_text(row: Row) -> str:
    return f"{sum(not said for said in row.clients.values())} of {len(row.clients)}" if row.clients else "-"


def piglit_text(row: Row) -> str:
    return ", ".join(f"{mode} {same} of {tests}" for mode, (same, tests) in row.piglit.items()) or "-"


def failures_of(row: Row) -> list:
    """A line for each reason, and for each case without one."""
    groups = {}
    for case, (cells, said) in sorted(row.bad().items()):
        reason = reason_of(row, case)
        reason = f"{reason}: {said}" if reason == UNKNOWN else reason
        cases, where = groups.setdefault(reason, ([], set()))
        cases.append(f"`{case}`")
        where.update(cells)
    for client, said in row.clients.items():
        if said:
            reason = reason_of(row, "client " + client)
            groups.setdefault(f"{reason}: {said}", ([], set()))[0].append(f"client {client}")
    return [f"| {row.title} | {', '.join(cases)} | {', '.join(sorted(where))} | {reason} |" for reason, (cases, where) in groups.items()]


def kept_lines(document: str, rows: list) -> tuple:
    """The lines of the document's three tables about drivers that have no results here: they ran on other machines."""
    here = {row.title for row in rows}
    drivers, failures, faults = [], [], {}
    parts = re.split("^### ", document, flags=re.M)
    for number, part in enumerate(parts[:3]):
        for line in re.findall(r"^\| (?!driver |fault ).*\|$", part, re.M):
            cells = [cell.strip() for cell in line.strip("|").split(" | ")]
            if number == 2:
                faults[tuple(cells[:2])] = [title for title in cells[2].split("; ") if title not in here]
            elif cells[0] not in here:
                (failures if number else drivers).append(line)
    return drivers, failures, faults


def lines_of(rows: list, document: str = "") -> list:
    other_drivers, other_failures, faults = kept_lines(document, rows)
    lines = ["| driver | " + " | ".join(CELLS) + " | clients | piglit |", "|---" * (len(CELLS) + 3) + "|"]
    all_cases = max((len(results["results"]) for row in rows for results in row.cells.values()), default=0)
    for row in rows:
        cells = [cell_text(row, cell, all_cases) for cell in CELLS] if not row.obstacle else [f"cannot run: {row.obstacle}"]
        lines.append(f"| {row.title} | " + " | ".join(cells) + f" | {clients_text(row)} | {piglit_text(row)} |")
    lines += [*other_drivers, "", "### What fails", "", "| driver | cases | where | why |", "|---|---|---|---|"]
    for row in rows:
        lines += failures_of(row)
    lines += other_failures
    for row in rows:
        for name, said in row.faults.items():
            faults.setdefault((f"`{name}`", said), []).append(row.title)
    lines += ["", "### Faults without glark", "", "| fault | what the driver does | drivers |", "|---|---|---|"]
    lines += [f"| {name} | {said} | {'; '.join(titles)} |" for (name, said), titles in sorted(faults.items()) if titles]
    return lines


def make(folders: list, document: pathlib.Path, write: bool) -> int:
    rows = [Row(folder) for parent in folders for folder in sorted(parent.iterdir()) if folder.is_dir()]
    before, found, rest = document.read_text().partition(BEGIN)
    text = "\n".join(lines_of(rows, rest.partition(END)[0]))
    if not write:
        print(text)
        return 0
    if not found or END not in rest:
        sys.exit(f"drivers: {document} lacks {BEGIN} or {END}")
    document.write_text(f"{before}{BEGIN}\n{text}\n{END}{rest.partition(END)[2]}")
    return 0
