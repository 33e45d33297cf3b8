# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The manual pages are well formed, and the options in the manual and in docs/reference/options.md are those of the launcher.

check_manual.py GLARK: the launcher that was built.
"""
import os
import re
import shutil
import subprocess
import sys
import unittest

from tracked import ROOT, text_of, tracked_files

PAGE = "docs/man/glark.1"
SCAN_PAGE = "docs/man/glark-scan.1"
MPI_PAGE = "docs/man/glark-mpi.1"
API_PAGES = [name for name in tracked_files() if re.fullmatch(r"docs/man/gl[A-Z]\w*\.3", name)]
GLARK = ""


def plain(text: str) -> str:
    return text.replace("\\-", "-").replace("\\&", "")


def options_of(help_text: str) -> set:
    return set(re.findall(r"^\s+(?:-\w,)?(--[\w-]+)", help_text, re.MULTILINE))


def variables_of(sources: list) -> set:
    return {name for text in sources for name in re.findall(r'"(GLARK_[A-Z_]+)"', text)}


def missing(wanted: set, page: str) -> list:
    return sorted(word for word in wanted if not re.search(rf"(?<![\w-]){re.escape(word)}(?![\w-])", page))


class Manual(unittest.TestCase):
    def setUp(self):
        self.page = plain(re.sub(r'^\.\\".*\n', "", text_of(PAGE), flags=re.MULTILINE))
        self.help = subprocess.run([GLARK, "run", "--help"], check=True, capture_output=True, text=True).stdout

    def test_commands_for_files(self):
        """Every command that was built has its options in the manual page."""
        listed = subprocess.run([GLARK, "--help"], check=True, capture_output=True, text=True).stdout
        page = plain(text_of(SCAN_PAGE))
        for command in ("simplify", "strip", "reconstruct", "sample", "transfer", "edit", "bake", "view"):
            if not re.search(rf"^  {command} ", listed, re.MULTILINE):
                continue
            help_text = subprocess.run([GLARK, command, "--help"], check=True, capture_output=True, text=True).stdout
            self.assertGreater(len(options_of(help_text)), 4)
            again = subprocess.run([GLARK, "help", command], check=True, capture_output=True, text=True).stdout
            self.assertEqual(help_text, again)
            self.assertEqual([], missing(options_of(help_text) | {f"glark {command}"}, page))

    def test_drawings_of_patterns(self):
        help_text = subprocess.run([GLARK, "pattern", "--help"], check=True, capture_output=True, text=True).stdout
        options = set(re.findall(r"--[\w-]+", help_text))
        self.assertGreater(len(options), 2)
        self.assertEqual([], missing(options | {"glark pattern"}, self.page))

    def test_every_option(self):
        options = options_of(self.help)
        self.assertGreater(len(options), 5)
        self.assertEqual([], missing(options, self.page))

    def test_pages_are_those_of_the_table(self):
        done = subprocess.run([ROOT / "scripts" / "parts" / "options", "--check", "--glark", GLARK], capture_output=True, text=True)
        self.assertEqual((0, ""), (done.returncode, done.stderr))

    def test_every_variable(self):
        names = [name for name in tracked_files() if name.startswith(("glark/settings/", "glark/tool/", "shim/"))]
        variables = variables_of([text_of(name) for name in names])
        self.assertGreater(len(variables), 5)
        self.assertEqual([], missing(variables, self.page))

    def test_option_of_the_page_exist(self):
        options = set(re.findall(r"(?<![\w-])--[a-z][\w-]+", self.page)) - {"--version", "--seconds"}
        drawing = subprocess.run([GLARK, "pattern", "--help"], check=True, capture_output=True, text=True).stdout
        self.assertEqual([], sorted(options - options_of(self.help) - set(re.findall(r"--[\w-]+", drawing))))

    def test_well_formed(self):
        if not shutil.which("man"):
            self.assertNotEqual("true", os.environ.get("CI"), "man is not installed; run scripts/install_packages --lint")
            self.skipTest("man is not installed")
        environment = dict(os.environ, MANROFFSEQ="", MANWIDTH="80", LC_ALL="C.UTF-8")
        for page in (PAGE, SCAN_PAGE, MPI_PAGE, *API_PAGES):
            result = subprocess.run(["man", "--warnings", "--encoding=UTF-8", "--troff-device=utf8", "--local-file", str(ROOT / page)],
                                    capture_output=True, text=True, env=environment)
            self.assertEqual(("", 0), (result.stderr, result.returncode))
        name = subprocess.run(["lexgrog", str(ROOT / PAGE)], capture_output=True, text=True)
        self.assertIn("glark - run OpenGL programs", name.stdout)

    def test_every_function_of_the_extension(self):
        functions = set(re.findall(r"<proto>void <name>(\w+)</name>", text_of("glark/gl/glark.xml")))
        self.assertGreater(len(functions), 5)
        named = [re.search(r"\.SH NAME\n(.*) \\- ", text_of(page)).group(1).split(", ") for page in API_PAGES]
        self.assertEqual(sorted(functions), sorted(name for names in named for name in names))

    def test_finds_what_is_missing(self):
        self.assertEqual(["--levels"], missing({"--level", "--levels"}, "--level N"))


if __name__ == "__main__":
    GLARK = sys.argv.pop(1)
    unittest.main()
