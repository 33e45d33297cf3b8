# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The checker of lessons finds what is wrong with a lesson. The lessons here are shell scripts."""
import contextlib
import io
import os
import pathlib
import subprocess
import tempfile
import time
import unittest
import unittest.mock

import check  # first: it says which package is missing
from PIL import Image

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
        return self.lesson(page).check_page()

    def test_accepts_a_lesson_as_its_page_says(self):
        self.assertEqual([], self.problems())

    def test_finds_another_snippet(self):
        self.assertIn("snippet", self.problems(PAGE.replace("one();", "two();"))[0])

    def test_finds_a_command_of_another_lesson(self):
        for line in ("scripts/build demo lesson_02", "examples/course/check.py 02 --exercise 1",
                     "cd build/demo/course/02_b"):
            self.assertIn("another lesson", self.problems(PAGE + "```\n" + line + "\n```\n")[0])
        page = PAGE + "```\nscripts/build demo lesson_01\ncd build/demo/course/01_a\n```\n"
        self.assertEqual([], self.problems(page))

    def test_finds_a_number_that_begins_a_list(self):
        self.assertIn("'3.' at the beginning", self.problems(PAGE + "- as in lesson\n  3. A tag\n")[0])
        self.assertEqual([], self.problems(PAGE + "3. A tag\n```\n  3. A tag\n```\n"))

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
        self.assertIn("before it is solved (this is the check for authors; for yours: check.py 01 --exercise 1)",
                      self.problems()[0])

    def test_finds_a_crash(self):
        self.program("a", "echo 4 triangles; echo drawing > $1; kill -SEGV $$")
        self.program("solution_1", "kill -SEGV $$")
        problems = " ".join(self.problems(PAGE.replace("solved\n", "")))
        self.assertIn("README.md:6: ./a expected/a.txt: a crashed: SIGSEGV", problems)
        self.assertIn("solution_1 crashed: SIGSEGV", problems)

    def test_an_exercise_may_run_under_another_program(self):
        (self.build / "bin").mkdir()
        (self.build / "bin" / "glark").symlink_to("/usr/bin/env")
        self.assertEqual([], self.problems(PAGE.replace("./exercise_1", "../../bin/glark ./exercise_1")))

    def test_checks_an_exercise(self):
        self.assertIn("not yet", self.lesson().check_exercise("1")[0])
        self.program("exercise_1", "echo solved")
        self.assertEqual([], self.lesson().check_exercise("1"))
        self.assertIn("no exercise 2", self.lesson().check_exercise("2")[0])

    def test_names_the_pictures_to_compare(self):
        page = PAGE.replace("./exercise_1", "./exercise_1 expected/b.txt")
        self.program("exercise_1", "echo > $1; echo not yet")
        yours = self.build / "course" / "01_a" / "mine" / "expected" / "b.txt"
        problem = self.lesson(page).check_exercise("1")[0]
        self.assertTrue(problem.endswith(f"\n  your picture is {yours}"), problem)  # no other one is there to compare
        expected = self.folder / "expected" / "b.txt"
        expected.write_text("")
        problem = self.lesson(page).check_exercise("1")[0]
        self.assertTrue(problem.endswith(f"\n  your picture is {yours}\n  it should look like {expected}"), problem)

    def test_the_check_for_authors_names_the_check_for_students(self):
        said = self.lesson(PAGE + "```console\n$ ./exercise_2\n```\n").answer(None)
        self.assertIn("it says nothing about your exercises", said)
        self.assertTrue(said.endswith("To check yours:\n  examples/course/check.py 01 --exercise 1\n"
                                      "  examples/course/check.py 01 --exercise 2"), said)
        self.assertNotIn("To check yours", self.lesson("no exercises\n").answer(None))
        self.assertEqual("exercise 1 is solved", self.lesson().answer("1"))

    def test_an_exercise_that_crashes_makes_no_picture(self):
        page = PAGE.replace("./exercise_1", "./exercise_1 expected/b.txt")
        self.program("exercise_1", "echo > $1; echo not yet")
        self.assertIn("your picture is", self.lesson(page).check_exercise("1")[0])
        self.program("exercise_1", "kill -SEGV $$")
        self.assertEqual(["README.md:8: ./exercise_1 expected/b.txt: exercise_1 crashed: SIGSEGV"],
                         self.lesson(page).check_exercise("1"))

    def test_an_exercise_has_to_be_built_after_its_sources(self):
        now = time.time()
        self.program("exercise_1", "echo solved")
        os.utime(self.build / "course" / "01_a" / "exercise_1", (now, now))
        source, header = self.folder / "exercise_1.cpp", self.folder / "b.h"
        source.write_text('#include "01_a/b.h"\n')
        for newer in (source, header):
            for file in (source, header, self.folder / "c.h"):
                file.touch()
                os.utime(file, (now - 5, now - 5))
            os.utime(self.folder / "c.h", (now + 5, now + 5))  # not included
            self.assertEqual([], self.lesson().check_exercise("1"))
            os.utime(newer, (now + 5, now + 5))
            self.assertEqual([f"{newer.name} is newer than its program: build it again: scripts/build demo lesson_01"],
                             self.lesson().check_exercise("1"))
        self.assertIn("before it is solved", self.problems()[0])  # the check for authors looks at no time

    def test_an_endless_loop_ends(self):
        page = PAGE.replace("./a expected/a.txt\n4 triangles\n$ ", "")
        for program, text in (("sleep 100", "exercise_1 did not end within 0.5 seconds"),
                              ("yes", "prints without end")):
            self.program("exercise_1", program)
            begin = time.monotonic()
            with unittest.mock.patch.object(check, "SECONDS", 0.5 if program != "yes" else 60):
                self.assertIn(text, self.lesson(page).check_exercise("1")[0])
            self.assertLess(time.monotonic() - begin, 30)

    def test_shows_few_of_many_lines(self):
        self.program("exercise_1", "seq 100")
        problem = self.lesson().check_exercise("1")[0]
        self.assertIn("    20\n    ... and 80 more lines\n", problem)

    def test_finds_a_snippet_of_a_missing_file(self):
        problems = self.problems(PAGE.replace("a.cpp", "b.cpp"))
        self.assertIn("README.md:1: the snippet draw: b.cpp cannot be read", problems)

    def test_finds_commands_that_cannot_be_run(self):
        (self.folder / "b.cpp").write_text("")
        for command, text in (('./a "b', "a quotation mark is missing"), ("", "there is no command"),
                              ("rm b", "there is no program rm"), ("./c", "there is no program ./c"),
                              ("./b", "scripts/build demo lesson_01"),
                              ("../../bin/glark info", "scripts/build demo lesson_01")):
            problem = self.problems(PAGE + f"```console\n$ {command}\n```\n")[0]
            self.assertIn(f"README.md:12: {command}: ", problem)
            self.assertIn(text, problem)

    def test_finds_an_exercise_that_is_not_built(self):
        (self.build / "course" / "01_a" / "exercise_1").unlink()
        self.assertIn("no program ./exercise_1", self.problems()[0])
        self.assertIn("no program ./exercise_1", self.lesson().check_exercise("1")[0])

    def test_finds_a_damaged_picture(self):
        good, damaged = self.folder.parent / "good.png", self.folder / "expected" / "b.png"
        Image.effect_noise((100, 100), 90).save(good)
        self.program("a", f"cp {good} $1")
        page = "```console\n$ ./a expected/b.png\n```\n"
        (self.folder / "expected" / "a.txt").unlink()
        for content in (b"", b"no picture", good.read_bytes()[:2000]):
            damaged.write_bytes(content)
            self.assertEqual(["README.md:2: ./a expected/b.png: expected/b.png is no picture that can be read"],
                             self.problems(page))
        self.lesson(page).update()
        self.assertEqual([], self.problems(page))

    def test_adds_a_size_unless_there_is_one(self):
        self.program("a", "echo $*")
        for command, size in (("./a --png b.png", "--size 320x240"), ("./a --png b.png --size 8x8", "--size 8x8"),
                              ("./a", "")):
            printed = self.lesson().run(command, self.folder.parent)[0]
            self.assertEqual(" ".join(filter(None, [command[4:], size if size not in command else ""])), printed[0])

    def test_leaves_the_pictures_of_students_alone(self):
        picture = self.build / "course" / "01_a" / "expected" / "mine.png"
        picture.parent.mkdir()
        picture.write_text("")
        self.lesson().check_exercise("1")
        self.assertEqual([], self.problems())
        self.assertTrue(picture.exists())

    def test_update_keeps_what_it_cannot_make(self):
        page = PAGE.replace("a.cpp", "b.cpp").replace("./a expected", './"a expected')
        self.lesson(page).update()
        self.assertEqual(page, (self.folder / "README.md").read_text())

    def test_update_mends_the_page(self):
        self.lesson(PAGE.replace("one();", "two();").replace("4 triangles", "5 triangles")).update()
        self.assertEqual(PAGE, (self.folder / "README.md").read_text())


class Arguments(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.root = pathlib.Path(place.name).resolve()
        for name in ("01_one", "07_seven", "10_ten", "__pycache__"):
            (self.root / name).mkdir()
        (self.root / "CMakePresets.json").write_text('{"name": "debug"}')
        for name in ("COURSE", "ROOT"):
            patch = unittest.mock.patch.object(check, name, self.root)
            patch.start()
            self.addCleanup(patch.stop)

    def build(self, preset, seconds):
        """Builds a program of lesson 07 at that time."""
        program = self.root / "build" / preset / "course" / "07_seven" / "a"
        program.parent.mkdir(parents=True, exist_ok=True)
        program.write_text("#!/bin/sh\n")
        program.chmod(0o755)
        os.utime(program, (seconds, seconds))

    def message(self, *words):
        """What check.py says when it ends early."""
        with unittest.mock.patch("sys.argv", ["check.py", *words]), self.assertRaises(SystemExit) as ended:
            check.main()
        return str(ended.exception)

    def test_a_lesson_has_a_number_and_a_name(self):
        for name in ("1", "01", "01_one"):
            self.assertEqual("01_one", check.find_lesson(name).name)
        self.assertEqual("10_ten", check.find_lesson("10").name)
        for name in ("", "0", "00", "001", "01_", "one", "__pycache__"):
            self.assertIn("The lessons are:\n  01_one\n  07_seven\n  10_ten", self.message(name))

    def test_an_exercise_has_a_number(self):
        for number in ("", "0", "one"):
            with unittest.mock.patch("sys.stderr"):
                self.assertEqual("2", self.message("7", "--exercise", number))

    def test_says_that_a_lesson_is_not_built(self):
        demo = "check: lesson 07 is not built in build/demo: scripts/build demo lesson_07"
        self.assertEqual(demo, self.message("7"))
        self.assertEqual(demo, self.message("7", "--build", str(self.root / "build" / "demo")))
        self.assertIn("scripts/build debug lesson_07", self.message("7", "--build", str(self.root / "build" / "debug")))
        self.assertIn("is not built in /nowhere: scripts/build demo", self.message("7", "--build", "/nowhere"))
        (self.root / "build" / "demo" / "course" / "07_seven" / "expected").mkdir(parents=True)  # CMake makes it
        self.assertEqual(demo, self.message("7", "--exercise", "1"))

    def test_finds_the_newest_build(self):
        self.build("debug", 2000)
        self.build("demo", 1000)
        (self.root / "build" / "other" / "course" / "07_seven" / "expected").mkdir(parents=True)
        self.assertEqual("debug", check.find_build("07_seven", None).name)
        self.build("demo", 3000)
        self.assertEqual("demo", check.find_build("07_seven", None).name)

    def test_says_that_a_page_is_missing(self):
        self.build("demo", 1000)
        with unittest.mock.patch("sys.argv", ["check.py", "7"]), contextlib.redirect_stderr(io.StringIO()) as said:
            self.assertEqual(1, check.main())
        self.assertIn("README.md", said.getvalue())


class Python(unittest.TestCase):
    def run_check(self, **variables):
        environment = {**os.environ, **variables}
        return subprocess.run([check.__file__, "--help"], env=environment, capture_output=True, text=True)

    def test_uses_the_python_of_the_packages(self):
        with tempfile.TemporaryDirectory() as place:
            other = pathlib.Path(place) / "python3"
            other.write_text("#!/bin/sh\nexit 9\n")
            other.chmod(0o755)
            self.assertEqual(0, self.run_check(PATH=f"{place}:{os.environ['PATH']}").returncode)

    def test_names_the_missing_package(self):
        with tempfile.TemporaryDirectory() as place:
            (pathlib.Path(place) / "PIL.py").write_text("raise ImportError\n")
            done = self.run_check(PYTHONPATH=place)
            self.assertEqual((2, ""), (done.returncode, done.stdout))
            self.assertIn("python3-pil", done.stderr)
            self.assertNotIn("Traceback", done.stderr)


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
