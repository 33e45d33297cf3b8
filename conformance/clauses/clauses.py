#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Gives ids to the sentences of the extension's text, and checks that every sentence has a case.

clauses.txt holds every sentence once, in order, as "ID sentence". An indented line "no case: REASON" may follow. An id is the
section and a number, which no other sentence ever gets. A reason below a section's heading applies to the whole section.

  clauses.py --update          rewrites clauses.txt after the text changed; unchanged sentences keep their ids
  clauses.py --embed OUT       writes a C++ initializer of {"ID", "sentence"} pairs, which the suite quotes
  clauses.py --check CASES     checks the output of `glark-conformance --list --json`; - reads standard input
"""
import argparse
import json
import re
import sys
from pathlib import Path

from sentences import specification

HERE = Path(__file__).resolve().parent
TEXT = HERE.parents[1] / "docs/spec/GL_ARK_adaptive_refinement.txt"
FILE = HERE / "clauses.txt"
SECTION = re.compile(r"\[(\S+)\] (.*)$")
CLAUSE = re.compile(r"(\S+) (.*)$")
REASON = "    no case: "
HEAD = """# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
#
# Every sentence of docs/spec/GL_ARK_adaptive_refinement.txt with its id. clauses.py --update writes all but the reasons.
"""


class Clause:
    def __init__(self, name: str, section: str, text: str, reason: str = ""):
        self.name, self.section, self.text, self.reason = name, section, text, reason


def load(lines: list) -> tuple:
    """(clauses in order, {section: reason})"""
    clauses, reasons, section = [], {}, ""
    for number, line in enumerate(lines, 1):
        if not line.strip() or line.startswith("#"):
            continue
        heading, clause = SECTION.match(line), CLAUSE.match(line)
        if heading:
            section = heading.group(1)
        elif line.startswith(REASON):
            reason = line[len(REASON):].strip()
            if clauses and clauses[-1].section == section:
                clauses[-1].reason = reason
            else:
                reasons[section] = reason
        elif clause and clause.group(1).startswith(section + "-"):
            clauses.append(Clause(clause.group(1), section, clause.group(2)))
        else:
            raise ValueError(f"clauses.txt:{number}: neither a section, a clause of it nor a reason: {line!r}")
    return clauses, reasons


def number_of(clause: Clause) -> int:
    return int(clause.name.rpartition("-")[2])


def updated(text: str, old: list, reasons: dict) -> str:
    """Returns clauses.txt for this text. A sentence that is not in `old` gets the next number of its section."""
    known = {}
    last = {}
    for clause in old:
        known.setdefault((clause.section, clause.text), []).append(clause)
        last[clause.section] = max(last.get(clause.section, 0), number_of(clause))
    out = [HEAD]
    for section, heading, sentences in specification(text):
        out.append(f"[{section}] {heading}")
        if section in reasons:
            out.append(REASON + reasons[section])
        for sentence in sentences:
            same = known.get((section, sentence))
            if same:
                clause = same.pop(0)
            else:
                last[section] = last.get(section, 0) + 1
                clause = Clause(f"{section}-{last[section]}", section, sentence)
            out.append(f"{clause.name} {sentence}")
            if clause.reason:
                out.append(REASON + clause.reason)
        out.append("")
    return "\n".join(out)


def complaints(text: str, clauses: list, reasons: dict, cases: list) -> list:
    found = []
    wanted = [(section, sentence) for section, _, sentences in specification(text) for sentence in sentences]
    have = [(clause.section, clause.text) for clause in clauses]
    found += [f"{section}: no id (clauses.py --update): {sentence}" for section, sentence in wanted
              if (section, sentence) not in have]
    found += [f"{clause.name}: no longer in the text: {clause.text}" for clause in clauses
              if (clause.section, clause.text) not in wanted]
    if not found and have != wanted:
        found.append("the order of clauses.txt is not that of the text (clauses.py --update)")
    names = [clause.name for clause in clauses]
    found += [f"{name}: given twice" for name in sorted(set(names)) if names.count(name) > 1]
    cited = cited_clauses(cases)
    found += [f"{name}: cited by {cited[name][0]}, but no such clause" for name in sorted(set(cited) - set(names))]
    for clause in clauses:
        if clause.name in cited and clause.reason:
            found.append(f"{clause.name}: has a case ({cited[clause.name][0]}) and a reason for having none")
        elif clause.name not in cited and not clause.reason and clause.section not in reasons:
            found.append(f"{clause.name}: neither a case nor a reason: {clause.text}")
    return found


def cited_clauses(cases: list) -> dict:
    """{clause: [written case, ...]}"""
    cited = {}
    for case in cases:
        for name in case["clauses"]:
            cited.setdefault(name, []).append(case["name"])
    return cited


def coverage(clauses: list, reasons: dict, cases: list) -> str:
    cited = cited_clauses([case for case in cases if case["written"]])
    sections = list(dict.fromkeys(clause.section for clause in clauses))
    lines = [f"{'section':<14}{'sentences':>10}{'with a case':>13}{'with a reason':>15}"]
    totals = [0, 0, 0]
    for section in sections:
        mine = [clause for clause in clauses if clause.section == section]
        tested = sum(clause.name in cited for clause in mine)
        explained = sum(clause.name not in cited and bool(clause.reason or section in reasons) for clause in mine)
        lines.append(f"{section:<14}{len(mine):>10}{tested:>13}{explained:>15}")
        totals = [total + count for total, count in zip(totals, (len(mine), tested, explained))]
    lines.append(f"{'all':<14}{totals[0]:>10}{totals[1]:>13}{totals[2]:>15}")
    return "\n".join(lines)


def embedded(clauses: list) -> str:
    return "".join(f"{{{json.dumps(clause.name)}, {json.dumps(clause.text)}}},\n" for clause in clauses)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--embed", type=Path, metavar="OUT")
    parser.add_argument("--check", metavar="CASES")
    options = parser.parse_args()
    text = TEXT.read_text()
    clauses, reasons = load(FILE.read_text().splitlines() if FILE.exists() else [])
    if options.update:
        FILE.write_text(updated(text, clauses, reasons))
    if options.embed:
        options.embed.write_text(embedded(clauses))
    if options.check:
        cases = json.load(sys.stdin if options.check == "-" else open(options.check))["cases"]
        print(coverage(clauses, reasons, cases))
        found = complaints(text, clauses, reasons, cases)
        print("\n".join(found), file=sys.stderr)
        return 1 if found else 0
    return 0


if __name__ == "__main__":
    sys.exit(main())
