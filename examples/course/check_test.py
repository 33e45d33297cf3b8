# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The checker of lessons finds what is wrong with a lesson. The lessons here are shell scripts."""
import pathlib
import tempfile
import unittest

from PIL import Image

import check

PAGE = """<!-- snippet: a.cpp draw -->
```cpp
one();
```
```console
$ ./a expected/a.txt
4 triangles
$ ./exercise_1
solved
```
"""
SOURCE = "  // [draw]\n  one();\n  // [/draw]\n"


class Checker(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.addCleanup(self.place.cleanup)
        root = pathlib.Path(self.place.name)
        self.folder, self.build = root / "01_a", root / "build"
        (self.folder / "expected").mkdir(parents=True)
        (self.build / "course" / "01_a").mkdir(parents=True)
        (self.folder / "a.cpp").write_text(SOURCE)
        (self.folder / "expected" / "a.txt").write_text("drawing\n")
        self.program("a", "echo 4 triangles; echo drawing > $1")
        self.program("exercise_1", "echo not yet")
        self.program("solution_1", "echo solved")

    def program(self, name, text):
        path = self.build / "course" / "01_a" / name
        path.write_text("#!/bin/sh\n" + text + "\n")
        path.chmod(0o755)

    def lesson(self, page=PAGE):
        (self.folder / "README.md").write_text(page)
        return check.Lesson(self.folder, self.build)

    def problems(self, page=PAGE):
        lesson = self.lesson(page)
        return lesson.check_names() + lesson.check_snippets() + lesson.check_commands()

    def test_accepts_a_lesson_as_its_page_says(self):
        self.assertEqual([], self.problems())

    def test_finds_another_snippet(self):
        self.assertIn("snippet", self.problems(PAGE.replace("one();", "two();"))[0])

    def test_finds_a_command_of_another_lesson(self):
        for line in ("scripts/build demo lesson_02", "examples/course/check.py 02 --exercise 1", "cd build/demo/course/02_b"):
            self.assertIn("another lesson", self.problems(PAGE + "```\n" + line + "\n```\n")[0])
        self.assertEqual([], self.problems(PAGE + "```\nscripts/build demo lesson_01\ncd build/demo/course/01_a\n```\n"))

    def test_finds_a_missing_snippet(self):
        self.assertIn("snippet", self.problems(PAGE.replace("a.cpp draw", "a.cpp count"))[0])

    def test_finds_other_printed_lines(self):
        self.assertIn("5 triangles", self.problems(PAGE.replace("4 triangles", "5 triangles"))[0])

    def test_finds_another_file(self):
        self.program("a", "echo 4 triangles; echo else > $1")
        self.assertIn("a.txt differs", self.problems()[0])

    def test_finds_a_file_that_no_command_makes(self):
        (self.folder / "expected" / "b.txt").write_text("")
        self.assertIn("b.txt", self.problems()[0])

    def test_finds_a_command_that_writes_nothing(self):
        self.program("a", "echo 4 triangles")
        self.assertIn("does not write a.txt", self.problems()[0])

    def test_finds_a_picture_that_is_missing(self):
        self.assertIn("b.png", self.problems(PAGE + "![b](expected/b.png)\n")[0])

    def test_finds_a_wrong_solution(self):
        self.program("solution_1", "echo wrong")
        self.assertIn("solution_1", self.problems()[0])

    def test_finds_a_starter_that_is_solved(self):
        self.program("exercise_1", "echo solved")
        self.assertIn("before it is solved", self.problems()[0])

    def test_finds_a_crash(self):
        self.program("a", "echo 4 triangles; echo drawing > $1; kill -SEGV $$")
        self.program("solution_1", "kill -SEGV $$")
        problems = " ".join(self.problems(PAGE.replace("solved\n", "")))
        self.assertIn("./a expected/a.txt: it ends", problems)
        self.assertIn("./solution_1: it ends", problems)

    def test_an_exercise_may_run_under_another_program(self):
        (self.build / "bin").mkdir()
        (self.build / "bin" / "glark").symlink_to("/usr/bin/env")
        self.assertEqual([], self.problems(PAGE.replace("./exercise_1", "glark ./exercise_1")))

    def test_checks_an_exercise(self):
        self.assertIn("not yet", self.lesson().check_exercise("1")[0])
        self.program("exercise_1", "echo solved")
        self.assertEqual([], self.lesson().check_exercise("1"))
        self.assertIn("no exercise 2", self.lesson().check_exercise("2")[0])

    def test_update_mends_the_page(self):
        self.lesson(PAGE.replace("one();", "two();").replace("4 triangles", "5 triangles")).update()
        self.assertEqual(PAGE, (self.folder / "README.md").read_text())


class Pictures(unittest.TestCase):
    def test_difference(self):
        with tempfile.TemporaryDirectory() as place:
            one, other = pathlib.Path(place) / "1.png", pathlib.Path(place) / "2.png"
            Image.new("RGB", (100, 100), (200, 100, 100)).save(one)
            Image.new("RGB", (100, 100), (200, 110, 100)).save(other)
            self.assertEqual(0, check.visible_difference(one, other))
            Image.new("RGB", (100, 100), (200, 160, 100)).save(other)
            self.assertEqual(1, check.visible_difference(one, other))
            Image.new("RGB", (100, 90), (200, 100, 100)).save(other)
            self.assertEqual(1, check.visible_difference(one, other))
            picture = Image.open(one)
            picture.paste((0, 0, 0), (0, 0, 10, 20))
            picture.save(other)
            self.assertAlmostEqual(0.02, check.visible_difference(one, other))


if __name__ == "__main__":
    unittest.main()
