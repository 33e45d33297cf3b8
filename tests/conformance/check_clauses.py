# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Checks that every sentence of the specification has a case or a reason, and tests the checker itself."""
import json
import os
import subprocess
import sys
import unittest
from pathlib import Path

CLAUSES = Path(__file__).resolve().parents[2] / "conformance/clauses"
sys.path.insert(0, str(CLAUSES))
import clauses  # noqa: E402
from sentences import specification  # noqa: E402

TEXT = """Overview

    First sentence (see
    11.R.14). Second, by T. Somebody. With

        A = (b + c) . N,

    the third ends. A list:

    * one;

    * two. Really.

Additions to Chapter 10 of the OpenGL 4.6 (Compatibility Profile)
Specification (Vertex Specification)

    10.R.1  Depth Tags

    A table.

        Name     Value
        -------  -----
        ONE      1
                 more
        TWO      2
"""


class Sentences(unittest.TestCase):
    def test_text_is_taken_apart(self):
        found = {name: sentences for name, _, sentences in specification(TEXT)}
        self.assertEqual(["First sentence (see 11.R.14).", "Second, by T. Somebody.",
                          "With A = (b + c) . N, the third ends.", "A list:", "* one;", "* two.", "Really."],
                         found["overview"])
        self.assertEqual(["A table.", "ONE 1 more", "TWO 2"], found["10.R.1"])

    def test_ids_stay_when_the_text_changes(self):
        first, reasons = clauses.load(clauses.updated(TEXT, [], {}).splitlines())
        changed = TEXT.replace("Second, by T. Somebody.", "Something new. Second, by T. Somebody.")
        second, _ = clauses.load(clauses.updated(changed, first, reasons).splitlines())
        ids = {clause.text: clause.name for clause in second}
        self.assertEqual("overview-2", ids["Second, by T. Somebody."])
        self.assertEqual("overview-8", ids["Something new."])


class Checker(unittest.TestCase):
    def complaints(self, cases, edit=lambda lines: lines):
        lines = clauses.updated(TEXT, [], {}).splitlines()
        loaded, reasons = clauses.load(edit(lines))
        return clauses.complaints(TEXT, loaded, reasons, cases)

    def case(self, *names):
        return [{"name": "ark.x", "clauses": list(names), "written": True}]

    def test_complains(self):
        everything = [f"overview-{i}" for i in range(1, 8)] + [f"10.R.1-{i}" for i in range(1, 4)]
        self.assertEqual([], [c for c in self.complaints(self.case(*everything)) if "chapter" not in c])
        self.assertTrue(any(c.startswith("10.R.1-2: neither") for c in self.complaints(self.case("10.R.1-1"))))
        self.assertTrue(any("no such clause" in c for c in self.complaints(self.case("10.R.1-9"))))
        self.assertTrue(any("no longer" in c for c in self.complaints([], lambda lines: [
            line.replace("Second", "Sixth") for line in lines])))


class TheSuite(unittest.TestCase):
    def test_every_sentence_has_a_case_or_a_reason(self):
        done = subprocess.run([os.environ["SUITE"], "--list", "--json"], capture_output=True, text=True, check=True)
        cases = json.loads(done.stdout)["cases"]
        loaded, reasons = clauses.load(clauses.FILE.read_text().splitlines())
        print(clauses.coverage(loaded, reasons, cases))
        self.assertEqual([], clauses.complaints(clauses.TEXT.read_text(), loaded, reasons, cases))


if __name__ == "__main__":
    unittest.main()
