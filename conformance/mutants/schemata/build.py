# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Makes the library that holds all mutants. Mutants that do not compile are left out."""
import fnmatch
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import run

from .instrument import instrumented
from .operators import Mutant, mutants_of

MOST = 65536  # mutants; a constant, so that another number of them does not build everything again
FOLDERS = ("glark/core", "shim")
NOT_MUTATED = (".glsl.h",)  # read by C++ and by GLSL
ERROR = re.compile(r"^(?P<path>[^\s:]+):(?P<line>\d+):\d+: (?:fatal )?error: (?P<text>.*)$")
NOTE = re.compile(r"^(?P<path>[^\s:]+):(?P<line>\d+):\d+:   (?:required|in .constexpr)")
UNDECLARED = re.compile(r"[‘'](\w+)[’'] was not declared")
# Where a mutant in the text of a shader is chosen: where the texts go to GL, and where the text that stands for fixed
# function is complete, since it is parsed before. A hook adds no line.
HOOKS = {"glark/core/objects/programs/shader.cpp": [
    ("const char* text = source.c_str();",
     "const std::string chosen_text = glark_mutants::text_of_shader(source); const char* text = chosen_text.c_str();"),
    ("GLint compiled = GL_FALSE;",
     "GLint compiled = GL_FALSE; struct Watch { const GLint& is; ~Watch() { glark_mutants::shader_compiled(is != 0); } } "
     "const watch{compiled};")],
         "glark/core/refine/fixed_function/fixed_function.cpp": [
    ('return text + "}\\n";', 'return glark_mutants::text_that_is_parsed(text + "}\\n");')]}
ROUNDS = 25


def sources_of(root: pathlib.Path, globs: list | None = None) -> list:
    """The names of the files from which mutants are made: all, or those that a glob matches."""
    names = [str(path.relative_to(root)) for folder in FOLDERS for path in (root / folder).rglob("*")
             if path.suffix in (".cpp", ".h", ".glsl") and not path.name.endswith(NOT_MUTATED)]
    return sorted(name for name in names if any(fnmatch.fnmatchcase(name, glob) for glob in globs or ["*"]))


def all_mutants(root: pathlib.Path, globs: list | None = None) -> list:
    mutants = []
    for name in sources_of(root, globs):
        mutants += mutants_of(name, (root / name).read_text())
    if len(mutants) > MOST:
        raise run.Complaint(f"there are {len(mutants)} mutants; schemata/build.py has room for {MOST}")
    for number, mutant in enumerate(mutants):
        mutant.number = number
    return mutants


def hooked(name: str, text: str, has_mutants: bool) -> str:
    """Adds what the mutants need, without a line of its own: the line of an error tells which mutant it is about."""
    for old, new in HOOKS.get(name, ()):
        if text.count(old) != 1:
            raise run.Complaint(f"{name}: {old!r} occurs {text.count(old)} times; schemata/build.py hooks in there")
        text = text.replace(old, new)
    if name.endswith(".glsl") or not (has_mutants or name in HOOKS):
        return text
    first, _, rest = text.partition("\n")
    if not first.startswith("//"):
        raise run.Complaint(f"{name} does not begin with a comment, which schemata/build.py replaces by an #include")
    return f'#include "glark_mutants.h"\n{rest}'


class Library:
    """The copy of the sources with all mutants, and the library that is built from it."""

    def __init__(self, folder: pathlib.Path, root: pathlib.Path, mutants: list, jobs: int, say=print):
        self.folder = folder
        self.root = root
        self.jobs = jobs
        self.say = say
        self.source = folder / "source"
        self.build = self.source / "build/release"  # at the place that the release build has in the true sources: see configure
        self.path = self.build / "lib/libGLARK.so"
        self.by_file = {}
        for mutant in mutants:
            self.by_file.setdefault(mutant.file, []).append(mutant)
        self.owners = {}  # {file: {line: [mutants]}}
        self.left_out = set()  # numbers

    def make(self) -> None:
        self.folder.mkdir(parents=True, exist_ok=True)
        self.remember()
        self.copy()
        runtime = (pathlib.Path(__file__).parent / "runtime.h.in").read_text()
        write_if_other(self.source / "glark_mutants.h", f"#define GLARK_MUTANT_COUNT {MOST}\n{runtime}")
        self.configure()
        self.prune("headers", [name for name in self.by_file if name.endswith(".h")], self.errors_of_headers)
        self.prune("sources", list(self.by_file), self.errors_of_build)

    def note(self) -> None:
        keys = {mutant.key() for mutants in self.by_file.values() for mutant in mutants if mutant.number in self.left_out}
        (self.folder / "left_out.json").write_text(json.dumps(sorted(map(list, keys))))

    def remember(self) -> None:
        """Leaves out what an earlier build had to leave out: it would cost compilations to find that again."""
        path = self.folder / "left_out.json"
        earlier = {tuple(key) for key in json.loads(path.read_text())} if path.is_file() else set()
        for mutants in self.by_file.values():
            self.left_out |= {mutant.number for mutant in mutants if mutant.key() in earlier}

    def copy(self) -> None:
        listed = subprocess.run(["git", "ls-files", "-z", *run.COPIED], cwd=self.root, check=True, capture_output=True, text=True).stdout
        names = [name for name in listed.split("\0") if name and (self.root / name).is_file()]
        for name in names:
            path = self.source / name
            path.parent.mkdir(parents=True, exist_ok=True)
            if name in self.by_file or name in HOOKS:
                self.write(name)
            elif name != "CMakeLists.txt" and (not path.is_file() or path.read_bytes() != (self.root / name).read_bytes()):
                shutil.copyfile(self.root / name, path)

    def write(self, name: str) -> None:
        mutants = [mutant for mutant in self.by_file.get(name, ()) if mutant.number not in self.left_out]
        text, self.owners[name] = instrumented((self.root / name).read_text(), mutants)
        write_if_other(self.source / name, hooked(name, text, bool(mutants)))

    def configure(self) -> None:
        """With the flags and the relative paths of the release build, so that ccache has the files without mutants."""
        launcher = ["-DCMAKE_C_COMPILER_LAUNCHER=ccache", "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        self.relax_flags()
        command = ["cmake", "-S", self.source, "-B", self.build, "-G", "Ninja", "-DGLARK_MUTANT=ON", "-DGLARK_TESTS=OFF", "-DGLARK_BENCH=OFF",
                   "-DGLARK_PROGRAMS=OFF", "-DCMAKE_BUILD_TYPE=Release", f"-DPython3_EXECUTABLE={sys.executable}", *launcher]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise run.Complaint(f"the copy with all mutants cannot be configured:\n{done.stdout}{done.stderr}")

    def relax_flags(self) -> None:
        """Files with mutants, or with headers that have some, are compiled once and run for a while: without warnings, without -O3."""
        has_headers = any(name.endswith(".h") for name in self.by_file)
        names = [name for name in sources_of(self.root) if name.endswith(".cpp") and (has_headers or name in self.by_file or name in HOOKS)]
        paths = "\n  ".join(f"${{PROJECT_SOURCE_DIR}}/{name}" for name in names)
        text = (self.root / "CMakeLists.txt").read_text() + f"""
foreach(target glark_core glark_pattern glark_derive GLARK)
  if(TARGET ${{target}})
    set_source_files_properties(
  {paths}
    TARGET_DIRECTORY ${{target}} PROPERTIES COMPILE_OPTIONS "-w;-O0")
  endif()
endforeach()
"""
        write_if_other(self.source / "CMakeLists.txt", text)

    def prune(self, what: str, names: list, errors_of) -> None:
        for number in range(ROUNDS):
            errors = errors_of(names)
            if not errors:
                return
            before = len(self.left_out)
            changed = self.blame(errors)
            self.say(f"{what}, round {number + 1}: {len(errors)} lines of errors, {len(self.left_out) - before} mutants left out")
            self.note()
            for name in changed:
                self.write(name)
        raise run.Complaint(f"{what} do not compile after {ROUNDS} rounds: {errors[0]}")

    def blame(self, errors: list) -> set:
        """Leaves out the mutants that errors point to. Returns the files that changed."""
        changed = set()
        in_doubt = []
        for name, line, text in errors:
            owners = [mutant for mutant in self.owners.get(name, {}).get(line, ()) if mutant.number not in self.left_out]
            if owners:
                self.left_out |= {mutant.number for mutant in owners}
                changed.add(name)
            elif not any(mutant.number in self.left_out for mutant in self.owners.get(name, {}).get(line, ())):
                in_doubt.append((name, line, text))
        if changed:
            return changed
        for name, line, text in in_doubt:
            found = self.suspects(name, line, text)
            self.left_out |= {mutant.number for mutant in found}
            changed |= {name} if found else set()
        if not changed:
            raise run.Complaint(f"the copy with all mutants does not compile: {errors[0]}")
        return changed

    def suspects(self, name: str, line: int, text: str) -> list:
        """The mutants that may have made this line wrong, although their own lines are right."""
        mutants = [mutant for mutant in self.by_file.get(name, ()) if mutant.number not in self.left_out]
        if undeclared := UNDECLARED.search(text):
            found = [mutant for mutant in mutants if mutant.operator == "drop" and re.search(rf"\b{undeclared.group(1)}\b", mutant.old)]
            if found:
                return found
        lines = [other for other in self.owners.get(name, {}) if other <= line] or sorted(self.owners.get(name, {}))[:1]
        if not lines:
            return mutants
        functions = {mutant.function for mutant in self.owners[name][max(lines)]}
        return [mutant for mutant in mutants if mutant.function in functions] or mutants

    def read_errors(self, output: str, folder: pathlib.Path) -> list:
        errors = []
        for line in output.splitlines():
            found = ERROR.match(line) or NOTE.match(line)
            if not found:
                continue
            path = pathlib.Path(os.path.normpath(folder / found["path"]))
            if path.is_relative_to(self.source):
                errors.append((str(path.relative_to(self.source)), int(found["line"]), found.groupdict().get("text", "")))
        return errors

    def errors_of_headers(self, names: list) -> list:
        """Compiles all headers at once: an error found only with the sources would make most of them compile again."""
        commands = json.loads((self.build / "compile_commands.json").read_text())
        subprocess.run(["cmake", "--build", self.build, "--target", "glark_gl_generated"], capture_output=True, check=False)
        words = {word: None for entry in commands for word in entry["command"].split() if word.startswith(("-I", "-D", "-std", "-f"))}
        for entry in commands:
            words |= {word: None for word in re.findall(r"-isystem \S+", entry["command"])}
        if not names:
            return []
        path = self.folder / "headers.cpp"
        path.write_text("".join(f'#include "{name}"\n' for name in names))
        done = subprocess.run([compiler_of(commands[0]), *" ".join(words).split(), "-w", "-fsyntax-only", "-I", self.source, path],
                              capture_output=True, text=True, check=False, cwd=self.build, env=plain_environment())
        if done.returncode == 0:
            return []
        errors = self.read_errors(done.stderr, self.build)
        if not errors:
            raise run.Complaint(f"the headers with all mutants do not compile: {done.stderr[:1500]}")
        return errors

    def errors_of_build(self, _names: list) -> list:
        command = ["cmake", "--build", self.build, "--target", "GLARK", "--parallel", str(self.jobs), "--", "-k", "0"]
        done = subprocess.run(command, capture_output=True, text=True, check=False, env=plain_environment())
        if done.returncode == 0:
            return []
        errors = self.read_errors(done.stdout + done.stderr, self.build)
        if not errors:
            raise run.Complaint(f"the library with all mutants cannot be built:\n{done.stdout[-1500:]}{done.stderr[-500:]}")
        return errors


def compiler_of(entry: dict) -> str:
    words = entry["command"].split()
    return words[1] if words[0].endswith("ccache") else words[0]


def plain_environment() -> dict:
    return {**os.environ, "LC_ALL": "C.UTF-8"}


def write_if_other(path: pathlib.Path, text: str) -> None:
    if not path.is_file() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
