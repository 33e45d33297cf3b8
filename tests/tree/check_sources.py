# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""What every file of the tree has to keep: licence header, length, no path of one machine, explicit
source lists, quiet optional packages, READMEs."""
import posixpath
import re
import textwrap
import unittest

from tracked import text_of, tracked_files, violations

SPDX = ("SPDX-FileCopyrightText: 2026 The glark authors", "SPDX-License-Identifier: MIT")
SOURCE_SUFFIXES = (".c", ".cpp", ".h", ".glsl", ".py", ".cmake", "CMakeLists.txt")
LONGEST = {".c": 450, ".cpp": 450, ".py": 450, ".glsl": 450, ".h": 220}
# Written in pieces so that this file keeps its own rule.
MACHINE_PATH = re.compile("(?<![A-Za-z0-9_.~-])/(?:wo" "rk|fa" "rm|ro" "ot|ho" "me|Us" "ers)/[A-Za-z0-9_.]")
FOLDERS_WITHOUT_README = {"docs"}  # is prose throughout


def is_source(name: str, text: str) -> bool:
    return name.endswith(SOURCE_SUFFIXES) or text.startswith("#!")


def licence_rule(name: str, text: str) -> list:
    if not is_source(name, text):
        return []
    head = "\n".join(text.splitlines()[:5])
    return [] if all(line in head for line in SPDX) else ["lacks the SPDX header of two lines"]


def length_rule(name: str, text: str) -> list:
    limit = next((limit for suffix, limit in LONGEST.items() if name.endswith(suffix)), None)
    lines = text.count("\n")
    if limit is None or lines <= limit:
        return []
    return [f"{lines} lines, over {limit}: does it hold one idea?"]


def machine_path_rule(name: str, text: str) -> list:
    return [f"line {i}: names a path of one machine" for i, line in enumerate(text.splitlines(), 1) if MACHINE_PATH.search(line)]


def source_list_rule(name: str, text: str) -> list:
    if not name.endswith((".cmake", "CMakeLists.txt")):
        return []
    return ["globs its sources; list them"] if re.search(r"\bfile\s*\(\s*GLOB", text, re.IGNORECASE) else []


def find_package_rule(name: str, text: str) -> list:
    """A package that may be absent is told in one line of ours. CMake's own warning has ten lines and looks like an error."""
    if not name.endswith((".cmake", "CMakeLists.txt")):
        return []
    calls = re.findall(r"^ *find_package\(([^)]*)\)", text, re.MULTILINE)
    return [f"find_package({call}) has neither REQUIRED nor QUIET" for call in calls if not {"REQUIRED", "QUIET"} & set(call.split())]


def header_guard_rule(name: str, text: str) -> list:
    if not name.endswith(".h") or name.startswith("include/"):
        return []
    return [] if "#pragma once" in text else ["lacks #pragma once"]


class Sources(unittest.TestCase):
    def test_licence(self):
        self.assertEqual([], violations(licence_rule))

    def test_length(self):
        self.assertEqual([], violations(length_rule))

    def test_examples_have_150_lines_at_most(self):
        for name in tracked_files():
            if name.startswith("examples/") and name.endswith((".c", ".cpp")):
                with self.subTest(file=name):
                    self.assertLessEqual(text_of(name).count("\n"), 150)

    def test_no_machine_paths(self):
        self.assertEqual([], violations(machine_path_rule))

    def test_explicit_source_lists(self):
        self.assertEqual([], violations(source_list_rule))

    def test_optional_packages_are_found_quietly(self):
        self.assertEqual([], violations(find_package_rule))

    def test_header_guards(self):
        self.assertEqual([], violations(header_guard_rule))

    def test_top_folders_have_a_readme(self):
        names = tracked_files()
        folders = {name.split("/")[0] for name in names if "/" in name and not name.startswith(".")} - FOLDERS_WITHOUT_README
        self.assertEqual([], sorted(folder for folder in folders if f"{folder}/README.md" not in names))

    def test_readme_is_short(self):
        text = text_of("README.md")
        self.assertLessEqual(text.count("\n"), 120)
        self.assertLessEqual(len(text.split()), 900)

    def test_readme_shows_the_smallest_program(self):
        shown = re.search(r"```c\n(.*?)```", text_of("README.md"), re.DOTALL).group(1)
        drawn = re.search(r"// \[draw\]\n(.*?) *// \[/draw\]", text_of("examples/ten_lines.c"), re.DOTALL).group(1)
        self.assertEqual(textwrap.dedent(drawn), shown)

    def test_readme_links_lead_somewhere(self):
        names = tracked_files()
        for name in (name for name in names if name.endswith(".md")):
            for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", text_of(name)):
                path = posixpath.normpath(posixpath.join(posixpath.dirname(name), target))
                with self.subTest(file=name, link=target):
                    self.assertTrue(path in names or any(other.startswith(path + "/") for other in names))


class Rejects(unittest.TestCase):
    def test_missing_licence(self):
        self.assertTrue(licence_rule("a.cpp", "int a;\n"))
        self.assertTrue(licence_rule("scripts/run", "#!/bin/sh\n"))

    def test_long_file(self):
        self.assertTrue(length_rule("a.h", "\n" * 221))
        self.assertFalse(length_rule("a.h", "\n" * 220))

    def test_machine_path(self):
        self.assertTrue(machine_path_rule("a", "see /ho" + "me/me/x\n"))
        self.assertFalse(machine_path_rule("a", "frame/ho" + "me/me\n"))

    def test_glob(self):
        self.assertTrue(source_list_rule("CMakeLists.txt", "file( glob SOURCES *.cpp)"))

    def test_loud_optional_package(self):
        self.assertTrue(find_package_rule("CMakeLists.txt", "  find_package(TBB)\n"))
        self.assertFalse(find_package_rule("CMakeLists.txt", "find_package(TBB QUIET)\nfind_package(fmt REQUIRED)\n"))

    def test_header_without_guard(self):
        self.assertTrue(header_guard_rule("shim/a.h", "int a;\n"))


if __name__ == "__main__":
    unittest.main()
