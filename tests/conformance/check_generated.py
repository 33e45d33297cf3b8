# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Tests the generated mutants: the rules that make them, the library that holds them all, and the list of equivalents."""
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "conformance/mutants"))
import generated  # noqa: E402
import run  # noqa: E402
from schemata import build, equivalents, instrument, judge, table  # noqa: E402
from schemata.operators import mutants_of  # noqa: E402

TOY = """// A toy.
#include "glark/core/toy.h"
namespace toy {
int smaller(int a, int b) {
  if (a < b && b != 7) {
    return a;
  }
  return b;
}
}  // namespace toy
extern "C" int answer(int a, int b) {
  int last = 0;
  last = toy::smaller(a, b);
  const char* const name = "x";
  return last + (take(name, last) ? 0 : 100);
}
extern "C" const char* shader() {
  static std::string text;
  text = glark_mutants::text_of_shader(R"(void main() { if (a < 1.0) b = 2; })");
  return text.c_str();
}
"""
HEADER = """// A toy.
#pragma once
#include <string>
struct Pair {
  int one = 0;
  float two = 0;
  bool operator==(const Pair&) const = default;
};
inline bool take(const char* name, int number) { return name != nullptr && number < 50; }
"""
CMAKE = """cmake_minimum_required(VERSION 3.25)
project(toy CXX)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
add_custom_target(glark_gl_generated)
add_library(GLARK SHARED glark/core/toy.cpp)
target_include_directories(GLARK PRIVATE ${PROJECT_SOURCE_DIR})
"""


def changes(text: str, operator: str, file: str = "a.cpp") -> list:
    return [(mutant.old, mutant.new) for mutant in mutants_of(file, text) if mutant.operator == operator]


class Operators(unittest.TestCase):
    def body(self, text: str, operator: str) -> list:
        return changes(f"void f() {{ {text} }}", operator)

    def test_each_on_a_line(self):
        for operator, text, expected in [
                ("drop", "stamp(x); int y = z;", [("stamp(x);", "")]),
                ("swap", "g(a, b + 1);", [("a, b + 1", "b + 1, a")]),
                ("compare", "x = a < b;", [("a < b", "a <= b")]),
                ("compare", "x = static_cast<int>(a) == b;", [("static_cast<int>(a) == b", "static_cast<int>(a) != b")]),
                ("number", "x = 0; y = 7U; z = 1.0F;", [("0", "1"), ("7U", "8U"), ("1.0F", "0.0F")]),
                ("constant", "x = true;", [("true", "false")]),
                ("arithmetic", "x = a + b;", [("a + b", "a - b")]),
                ("logic", "x = a && b;", [("a && b", "(a) || (b)")]),
                ("forget", "x = a && b && c;", [("a && b", "a"), ("a && b", "b"), ("a && b && c", "a && b")]),
                ("not", "x = !a.b(c) && d;", [("!a.b(c)", "a.b(c)")]),
                ("negate", "if (a && b) g();", [("a && b", "!(a && b)")]),
                ("negate", "x = a ? b : c;", [("a", "!(a)")]),
                ("member", "x = {.a = b, .c = d.e};", [("b", "{}"), ("d.e", "{}")]),
                ("case", "switch (x) { case 1: case 2: g(); break; default: break; }", [("g();", "break;")]),
                ("return", "g();", [("{", "{ return;")])]:
            with self.subTest(operator=operator, text=text):
                self.assertEqual(sorted(expected), sorted(self.body(text, operator)))

    def test_what_is_left_alone(self):
        for operator, text in [("compare", "std::vector<int> x;"), ("number", "constexpr int x = 3; int y[4];"), ("drop", "const T x = f(y); T z(y);"),
                               ("negate", "if (const T* x = f(); x != nullptr) g();"), ("swap", "[](int a, int b) {};"), ("number", "case 3: g();")]:
            with self.subTest(text=text):
                self.assertEqual([], self.body(text, operator))

    def test_lambdas_and_structs(self):
        self.assertIn(("g();", ""), self.body("h([&](int x) { g(); });", "drop"))
        self.assertEqual([("one", ""), ("two", "")], changes(HEADER, "equality"))

    def test_glsl(self):
        text = "uniform int a;\nvoid main() {\n  #if A == 1\n  b = a < 1;\n  #endif\n}\n"
        self.assertEqual([("a < 1", "a <= 1")], changes(text, "compare", "a.glsl"))
        found = [mutant for mutant in mutants_of("a.cpp", f'const char* x =\n  R"({text})";\n') if mutant.operator == "compare"]
        self.assertEqual([(5, "main", True)], [(mutant.line, mutant.function, mutant.is_glsl) for mutant in found])

    def test_alone_is_what_a_person_would_write(self):
        text = "int f() { return g(a) + 2; }"
        mutant = next(mutant for mutant in mutants_of("a.cpp", text) if mutant.operator == "number")
        self.assertEqual("int f() { return g(a) + 3; }", instrument.alone(text, mutant))


class OneLibrary(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        root = Path(cls.scratch.name) / "root"
        (root / "glark/core").mkdir(parents=True)
        (root / "shim").mkdir()
        for name, text in (("CMakeLists.txt", CMAKE), ("glark/core/toy.cpp", TOY), ("glark/core/toy.h", HEADER)):
            (root / name).write_text(text)
        subprocess.run(["git", "init", "--quiet"], cwd=root, check=True)
        subprocess.run(["git", "add", "."], cwd=root, check=True)
        cls.root = root
        cls.mutants = build.all_mutants(root)
        cls.library = build.Library(Path(cls.scratch.name) / "out", root, cls.mutants, 2, lambda text: None)
        cls.library.make()

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def number(self, operator: str, old: str) -> int:
        return next(mutant.number for mutant in self.mutants if (mutant.operator, mutant.old) == (operator, old))

    def call(self, what: str, **environment) -> str:
        code = f"import ctypes; l = ctypes.CDLL({str(self.library.path)!r}); l.shader.restype = ctypes.c_char_p; print({what})"
        done = subprocess.run([sys.executable, "-c", code], env={**os.environ, **environment}, capture_output=True, text=True, check=True)
        return done.stdout.strip()

    def test_the_variable_chooses(self):
        self.assertEqual("3", self.call("l.answer(3, 5)"))
        for operator, old, answer in [("negate", "a < b && b != 7", "5"), ("drop", "last = toy::smaller(a, b);", "0"),
                                      ("swap", "a, b", "3"), ("number", "7", "3"), ("return", "{", "0")]:
            with self.subTest(operator=operator):
                self.assertEqual(answer, self.call("l.answer(3, 5)", GLARK_MUTANT=str(self.number(operator, old))))
        self.assertEqual("103", self.call("l.answer(3, 5)", GLARK_MUTANT=str(self.number("negate", "take(name, last)"))))

    def test_what_does_not_compile_is_left_out(self):
        out = [(mutant.operator, mutant.old) for mutant in self.mutants if mutant.number in self.library.left_out]
        self.assertEqual([("swap", "name, last")], out)  # arguments of two types

    def test_what_is_reached_is_noted(self):
        path = Path(self.scratch.name) / "reached"
        self.call("l.answer(9, 5)", GLARK_MUTANT_REACHED=str(path))
        reached = path.read_bytes()
        self.assertEqual(1, reached[self.number("compare", "a < b")])
        self.assertEqual(0, reached[self.number("compare", "b != 7")])
        self.assertEqual(0, reached[self.number("compare", "a < 1.0")])
        self.call("l.shader()", GLARK_MUTANT_REACHED=str(path))
        self.assertEqual(1, path.read_bytes()[self.number("compare", "a < 1.0")])

    def test_the_text_of_a_shader(self):
        self.assertIn("if (a < 1.0) b = 2;", self.call("l.shader().decode()"))
        self.assertIn("if (a <= 1.0) b = 2;", self.call("l.shader().decode()", GLARK_MUTANT=str(self.number("compare", "a < 1.0"))))
        self.assertIn("if (a < 1.0)  }", self.call("l.shader().decode()", GLARK_MUTANT=str(self.number("drop", "b = 2;"))))


class Equivalents(unittest.TestCase):
    def complaints(self, text: str) -> list:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "equivalents.toml"
            path.write_text(text)
            return equivalents.complaints(*equivalents.read(path), mutants_of("a.cpp", "void f() { x = a < 1; y = 1; }"))

    def entry(self, old: str, **more) -> str:
        fields = {"file": "a.cpp", "function": "f", "operator": "compare", "old": old, "reason": "It is never seen."} | more
        return "[[equivalent]]\n" + "".join(f"{name} = {json.dumps(value)}\n" for name, value in fields.items())

    def test_a_mutant_that_is_there(self):
        self.assertEqual([], self.complaints(self.entry("a  < 1")))
        self.assertEqual([], self.complaints(self.entry("1", operator="number", all=True)))

    def test_complaints(self):
        for text, words in [(self.entry("a < 2"), "no mutant is a.cpp f: compare: a < 2"), (self.entry("1", operator="number"), "2 mutants are"),
                            (self.entry("a < 1", reason="so"), "no reason"), ('[[outside]]\nfile = "b*"\nreason = "It is not there."\n', "outside by b")]:
            with self.subTest(words=words):
                self.assertIn(words, "\n".join(self.complaints(text)))
        with self.assertRaisesRegex(run.Complaint, "unexpected keyword"):
            self.complaints(self.entry("a < 1", line=3))

    def test_what_is_not_judged(self):
        mutants = mutants_of("a.cpp", "void f() { x = a < 1; y = 1; }")
        sorter = equivalents.Sorter([equivalents.Equivalent("a.cpp", "compare", "a < 1", "It is never seen.", "f")],
                                    [equivalents.Outside("Nobody asks for it.", old="y = *")])
        kinds = {(mutant.operator, mutant.old): sorter.sort(mutant) for mutant in mutants}
        self.assertEqual(("equivalent", "outside", ""), (kinds["compare", "a < 1"], kinds["drop", "y = 1;"], kinds["drop", "x = a < 1;"]))


class Results(unittest.TestCase):
    def setUp(self):
        self.mutants = mutants_of("a.cpp", "void f() { x = a < 1; y = 1; }")
        for number, mutant in enumerate(self.mutants):
            mutant.number = number

    def test_rates(self):
        kinds = ["killed", "killed", "survived", "undecided", "not covered", "equivalent", "does not compile"]
        judged = [(self.mutants[0], kind) for kind in kinds]
        self.assertIn("| all | 6 | 1 | 1 | 1 | 1 | 2 | 40.0 % | 50.0 % |", table.table_of(judged))
        self.assertEqual(1, table.survivors_of(judged, {}, {0: "x"}).count("a.cpp:1"))

    def test_resumed(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "journal.jsonl"
            journal = table.Journal(path, resume=False)
            journal.add(judge.Verdict("a", "survived"))
            journal.add(judge.Verdict("a", "killed", by="ark.x"))
            self.assertEqual("killed", table.Journal(path, resume=True).verdicts["a"].verdict)
            self.assertEqual({}, table.Journal(path, resume=False).verdicts)

    def test_identities_follow_the_file(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "a.cpp").write_text("one")
            before = table.identities_of(self.mutants, Path(folder))
            self.assertEqual(len(self.mutants), len(set(before.values())))
            (Path(folder) / "a.cpp").write_text("two")
            self.assertNotEqual(before, table.identities_of(self.mutants, Path(folder)))

    def test_order_of_cases(self):
        reaches = [judge.Reach("gl-compat", name, verdict, cpu, frozenset(numbers)) for name, verdict, cpu, numbers in
                   [("slow", "Pass", 9, [0]), ("broad", "Pass", 1, [0, 1, 2]), ("narrow", "Pass", 1, [0]), ("bad", "Fail", 1, [0]),
                    ("other", "Pass", 1, [1])]]
        self.assertEqual(reaches[0], judge.reach_of(reaches[0].line()))
        judges = judge.Judge(None, reaches)
        self.assertEqual(["narrow", "broad", "slow"], [reach.case for reach in judges.order(self.mutants[0])])
        turns = judge.Judge(None, [judge.Reach("gl-compat", name, "Pass", 1, frozenset([0])) for name in ("ark.a.1", "ark.a.2", "ark.b.1")])
        self.assertEqual(["ark.a.1", "ark.b.1", "ark.a.2"], [reach.case for reach in turns.order(self.mutants[0])])
        judges.remember(self.mutants[0], "gl-compat", "slow")
        self.assertEqual("slow", judges.order(self.mutants[0])[0].case)


class Program(unittest.TestCase):
    def test_patterns(self):
        mutants = mutants_of("a.cpp", "void f() { x = a < 1; y = 1; }")
        self.assertEqual(2, len(generated.matching(mutants, ["a.cpp:f:drop"])))
        self.assertEqual(len(mutants), len(generated.matching(mutants, ["a.*"])))
        with self.assertRaisesRegex(run.Complaint, "no mutant matches b"):
            generated.matching(mutants, ["b*"])

    def test_undecided(self):
        class Passes:
            def run(self, *_arguments, **_more):
                return judge.CaseRun([], 0)
        mutant = next(mutant for mutant in mutants_of("a.cpp", "void f() { y = 1; }") if mutant.operator == "drop")
        reaches = [judge.Reach("gl-core", name, "Pass", 1, frozenset([0])) for name in "abc"]
        for most, verdict in [(2, "undecided"), (0, "survived"), (3, "survived")]:
            self.assertEqual(verdict, judge.Judge(Passes(), reaches, most).judge(mutant, "x").verdict)
        self.assertEqual("not covered", judge.Judge(Passes(), []).judge(mutant, "x").verdict)

    def test_groups(self):
        pairs = [("gl-core", "a"), ("gl-core", "b"), ("gl-core", "c"), ("gles", "a")]
        self.assertEqual([("gl-core", ["a", "b"]), ("gl-core", ["c"]), ("gles", ["a"])], generated.groups_of(pairs, 2))


if __name__ == "__main__":
    unittest.main()
