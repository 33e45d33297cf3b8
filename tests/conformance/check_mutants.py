# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Tests the run of the mutants: its complaints about mutants that cannot be made, and that no mutant is ever installed."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "conformance/mutants"))
import run  # noqa: E402


def mutant(**changes):
    edits = [{"file": "a.cpp", "old": "right", "new": "wrong"}]
    return run.Mutant(**{"name": "a.b", "clause": "name-1", "what": "It is wrong", "edits": edits, **changes})


class Edits(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = Path(self.scratch.name)
        self.file = self.folder / "a.cpp"

    def test_made_and_unmade(self):
        self.file.write_text("all right\n")
        with run.made(mutant(), self.folder):
            self.assertEqual("all wrong\n", self.file.read_text())
        self.assertEqual("all right\n", self.file.read_text())

    def test_two_edits_of_a_file(self):
        self.file.write_text("left right\n")
        edits = [{"file": "a.cpp", "old": "left", "new": "up"}, {"file": "a.cpp", "old": "right", "new": "down"}]
        self.assertEqual({self.file: "up down\n"}, run.mutated(mutant(edits=edits), self.folder))

    def test_what_cannot_be_made(self):
        for text, words in [("right, right\n", "occurs 2 times"), ("nothing\n", "occurs 0 times"), (None, "there is no a.cpp")]:
            self.file.write_text(text) if text else self.file.unlink()
            with self.assertRaisesRegex(run.Complaint, words):
                run.mutated(mutant(), self.folder)

    def test_names_sentences_and_apis(self):
        edits = [{"file": "LICENSE", "old": "MIT License", "new": "Licence"}]
        bad = [mutant(edits=edits), mutant(edits=edits, clause="name-99", api="vulkan")]
        with self.assertRaisesRegex(run.Complaint, "two mutants.*\n.*no sentence name-99\n.*no API vulkan"):
            run.check(bad)


class Table(unittest.TestCase):
    def test_between_the_markers(self):
        outcomes = [run.Outcome(mutant(name="a.b"), ["ark.x", "ark.y"], True, 1),
                    run.Outcome(mutant(name="a.c"), ["ark.z"], False, 1), run.Outcome(mutant(name="a.d"), [], False, 1)]
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "a.md"
            path.write_text("before\n<!-- mutants -->\nold\n<!-- /mutants -->\nafter\n")
            run.write_table(path, outcomes, ["a.b", "a.c", "a.d"])
            lines = path.read_text().splitlines()
            self.assertEqual(("before", "after", "<!-- /mutants -->"), (lines[0], lines[-1], lines[-2]))
            self.assertEqual("2 of 3 mutants are caught.", lines[2])
            self.assertEqual("| `a.b` | name-1 | It is wrong | ark.x | 2 |", lines[6])
            self.assertIn("| ark.z (of another sentence) | 1 |", lines[7])
            self.assertIn("| NOT CAUGHT | 0 |", lines[8])
            path.write_text("nothing\n")
            with self.assertRaisesRegex(run.Complaint, "has no <!-- mutants -->"):
                run.write_table(path, outcomes, ["a.b"])

    def test_only_what_was_tried(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "a.md"
            path.write_text("<!-- mutants -->\n| `gone` | x | y | z | 1 |\n| `a.b` | x | y | NOT CAUGHT | 0 |\n"
                            "| `a.c` | x | kept | z | 1 |\n<!-- /mutants -->\n")
            run.write_table(path, [run.Outcome(mutant(name="a.b"), ["ark.x"], True, 1)], ["a.c", "a.b"])
            lines = path.read_text().splitlines()
            self.assertEqual("2 of 2 mutants are caught.", lines[1])
            self.assertEqual(["| `a.c` | x | kept | z | 1 |", "| `a.b` | name-1 | It is wrong | ark.x | 1 |"], lines[5:7])

    def test_counts_of_all_cases_stay_where_only_the_first_was_looked_for(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "a.md"
            path.write_text("<!-- mutants -->\n| `a.b` | x | y | ark.x | 7 |\n| `a.c` | x | y | NOT CAUGHT | 0 |\n| `a.d` | x | y | ark.z | 2 |\n"
                            "<!-- /mutants -->\n")
            outcomes = [run.Outcome(mutant(name=name), failed, True, 1) for name, failed in [("a.b", ["ark.x"]), ("a.c", ["ark.y"]), ("a.d", [])]]
            run.write_table(path, outcomes, ["a.b", "a.c", "a.d"], first=True)
            lines = path.read_text().splitlines()
            self.assertEqual("| `a.b` | x | y | ark.x | 7 |", lines[5])
            self.assertEqual(["| ark.y | 1 |", "| NOT CAUGHT | 0 |"], [line.split("It is wrong ")[1] for line in lines[6:8]])

    def test_says_which_case_caught_a_mutant(self):
        table = "| mutant | a | b | caught by | failed |\n| `a.b` | s-1 | what | ark.x | 7 |\n| `a.c` | s-1 | what | ark.y (of another sentence) | 1 |\n"
        self.assertEqual({"a.b": "ark.x"}, run.catchers_in(table + "| `a.d` | s-1 | what | NOT CAUGHT | 0 |\n"))


class Installation(unittest.TestCase):
    def test_a_mutant_is_never_installed(self):
        lines = [line.strip() for line in (ROOT / "CMakeLists.txt").read_text().splitlines()]
        refusal = lines[lines.index(next(line for line in lines if line.startswith("if(GLARK_MUTANT)"))) + 1]
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / "source"
            source.mkdir()
            (source / "a").write_text("")
            (source / "CMakeLists.txt").write_text(
                f"cmake_minimum_required(VERSION 3.25)\nproject(p NONE)\nif(GLARK_MUTANT)\n{refusal}\nendif()\ninstall(FILES a DESTINATION .)\n")
            for option, fails in [("ON", True), ("OFF", False)]:
                build = Path(folder) / option
                subprocess.run(["cmake", "-S", source, "-B", build, f"-DGLARK_MUTANT={option}"], check=True, capture_output=True)
                done = subprocess.run(["cmake", "--install", build, "--prefix", build / "to"], capture_output=True, text=True)
                self.assertEqual((fails, not fails), (done.returncode != 0, (build / "to/a").exists()))
                self.assertEqual(fails, "broken on purpose" in done.stderr)

    def test_no_other_rule_comes_first(self):
        text = (ROOT / "CMakeLists.txt").read_text()
        for rules in ("include(cmake/install.cmake)", "add_subdirectory"):
            self.assertLess(text.index("if(GLARK_MUTANT)"), text.index(rules))


if __name__ == "__main__":
    unittest.main()
