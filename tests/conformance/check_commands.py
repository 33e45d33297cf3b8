# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Checks that every command of OpenGL has a change or a reason for having none, and tests the checker itself."""
import json
import os
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "conformance/changes"))
import commands  # noqa: E402

REASONS = commands.read_reasons("# comment\nGet* Is*: only tells\nFinish: waits  # really\n")


class Checker(unittest.TestCase):
    def test_everything_has_its_place(self):
        self.assertEqual([], commands.complaints({"GetError", "IsEnabled", "Finish", "BufferData"}, {"BufferData"}, REASONS))

    def test_a_new_command_is_noticed(self):
        wrong = commands.complaints({"GetError", "IsEnabled", "Finish", "BufferNews"}, set(), REASONS)
        self.assertEqual(["BufferNews has neither a change nor a reason"], wrong)

    def test_a_case_names_commands_of_opengl(self):
        wrong = commands.complaints({"GetError", "IsEnabled", "Finish"}, {"glFinish"}, REASONS)
        self.assertEqual(["glFinish is no command of OpenGL"], wrong)

    def test_a_reason_matches_something(self):
        wrong = commands.complaints({"GetError", "Finish"}, set(), REASONS)
        self.assertEqual(["reasons.txt: nothing is left for Is*"], wrong)


    def test_a_reason_that_names_cases_is_kept(self):
        reasons = commands.read_reasons("Rect* Get*: ark.rectangles.*\nFinish: waits\n")
        missing = commands.uncalled({"Rectf", "Recti", "Finish", "BufferData"}, {"Rectf"}, reasons)
        self.assertEqual({"ark.rectangles.*": ["Recti"], "has a change of its own": ["BufferData"]}, missing)


class TheSuite(unittest.TestCase):
    def test_every_command_has_a_change_or_a_reason(self):
        listed = subprocess.run([os.environ["SUITE"], "--list", "--json"], capture_output=True, text=True, check=True)
        tested = {name for case in json.loads(listed.stdout)["cases"] for name in case["commands"]}
        reasons = commands.read_reasons(commands.REASONS.read_text())
        self.assertGreater(len(tested), 150)
        self.assertEqual([], commands.complaints(commands.commands_of(os.environ["GL_XML"]), tested, reasons))


if __name__ == "__main__":
    unittest.main()
