# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""compare.py must notice what breaks programs, and nothing else. Each case plants one change in a copy of the descriptions."""
import pathlib
import shutil
import sys
import tempfile
import unittest

import compare

DESCRIPTIONS = pathlib.Path(__file__).resolve().parent / "descriptions"
NAME = "libglark-depth"


class Notices(unittest.TestCase):
    def complaints(self, find="", change="", symbols=lambda names: names):
        with tempfile.TemporaryDirectory() as temporary:
            new = pathlib.Path(temporary) / f"{NAME}.abi"
            text = (DESCRIPTIONS / f"{NAME}.abi").read_text()
            self.assertIn(find, text, "the change cannot be planted")
            new.write_text(text.replace(find, change) if find else text)
            names = (DESCRIPTIONS / f"{NAME}.symbols").read_text().splitlines()
            new.with_suffix(".symbols").write_text("\n".join(symbols(names)))
            return compare.complaints_about(DESCRIPTIONS / f"{NAME}.abi", new)

    def test_the_same(self):
        self.assertEqual([], self.complaints())

    def test_a_function_of_c_is_gone(self):
        self.assertTrue(self.complaints(symbols=lambda names: [name for name in names if name != "glark_depth_keep_budget"]))

    def test_a_function_of_cpp_has_another_parameter(self):
        self.assertTrue(self.complaints(symbols=lambda names: [name.replace("Tagger11keep_budget", "Tagger12keep_budgets") for name in names]))

    def test_an_added_function(self):
        self.assertEqual([], self.complaints(symbols=lambda names: [*names, "glark_depth_more"]))

    def test_a_member_has_moved(self):
        self.assertTrue(self.complaints("layout-offset-in-bits='192'", "layout-offset-in-bits='256'"))

    def test_an_enumerator_has_another_value(self):
        self.assertTrue(self.complaints("name='GLARK_DEPTH_GEOMORPH' value='1'", "name='GLARK_DEPTH_GEOMORPH' value='2'"))

    def test_another_soname(self):
        self.assertEqual([], self.complaints("soname='libglark-depth.so.0'", "soname='libglark-depth.so.1'", lambda names: []))

    def test_a_name_that_a_library_does_not_export(self):
        self.assertTrue(compare.missing("libGLARK", {"glARKinit"}, {"glBegin"}))


if __name__ == "__main__":
    if not shutil.which("abidiff"):
        print("check_compare: skipped: abidiff is not installed; run scripts/install_packages")
        sys.exit(77)
    unittest.main()
