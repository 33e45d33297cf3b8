# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Installs glark under a temporary prefix, and compiles, links and runs programs against it, by pkg-config and by CMake.

check_package.py CMAKE BUILD CC CXX COMPONENT ...: the build, the compilers and the client libraries that were built.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PROGRAMS = HERE / "programs"
README = HERE.parents[1] / "README.md"
CMAKE = BUILD = CC = CXX = ""
COMPONENTS = []


def readme_lines() -> str:
    return re.search(r"```c\n(.*?)```", README.read_text(), re.DOTALL).group(1)


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.prefix = cls.folder / "prefix"
        subprocess.run([CMAKE, "--install", BUILD, "--prefix", cls.prefix], check=True, capture_output=True)
        cls.packages = next(cls.prefix.rglob("glark.pc")).parent
        cls.libraries = cls.packages.parent
        (cls.folder / "readme_lines.inc").write_text(readme_lines())
        # An installation in a folder of the user's own: nothing else may help to find it.
        cls.environment = {key: value for key, value in os.environ.items() if not key.startswith(("GLARK_", "LD_", "CMAKE_"))}
        cls.environment.update(PKG_CONFIG_PATH=str(cls.packages), GLARK_CONFIG="/dev/null")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def run_checked(self, *words, **more) -> str:
        variables = self.environment | more
        done = subprocess.run(words, env=variables, cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(0, done.returncode, f"{words}\n{done.stdout}{done.stderr}")
        return done.stdout

    def flags(self, *words) -> list:
        return self.run_checked("pkg-config", *words).split()

    def expect_refined(self, program, **variables):
        """The program has the version of the launcher, draws something, and its draw is refined."""
        statistics = self.folder / "statistics.json"
        version, covered = self.run_checked(program, GLARK_STATS=str(statistics), **variables).split()
        self.assertEqual(f"glark {version}\n", self.run_checked(self.prefix / "bin/glark", "--version"))
        self.assertEqual(version, self.flags("--modversion", "glark")[0])
        self.assertGreater(int(covered), 1000)
        self.assertEqual(1, json.loads(statistics.read_text())["draws"]["refined"])

    def test_readme_by_pkg_config(self):
        self.run_checked(CC, "-I.", PROGRAMS / "readme.c", "-o", "readme", *self.flags("--cflags", "--libs", "glark", "osmesa"), "-lm")
        self.expect_refined(self.folder / "readme", LD_LIBRARY_PATH=str(self.libraries))

    def compile_and_run(self, source, program, *compiler):
        flags = self.flags("--cflags", "--libs", f"glark-{source.stem}")
        self.run_checked(*compiler, source, "-o", program, *flags, "-lm")
        self.run_checked(self.folder / program, LD_LIBRARY_PATH=str(self.libraries))

    def test_clients_by_pkg_config(self):
        def check(name):
            self.compile_and_run(PROGRAMS / f"{name}.cpp", f"{name}_cpp", CXX, "-std=c++20")
            self.compile_and_run(PROGRAMS / "c" / f"{name}.c", f"{name}_c", CC, "-std=c99", "-pedantic", "-Wall", "-Werror")

        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            list(pool.map(check, COMPONENTS))

    def test_older_cpp_is_told_what_to_do(self):
        for name in COMPONENTS:
            source = self.folder / f"old_{name}.cpp"
            source.write_text(f"#include <glark/{name}.h>\n")
            done = subprocess.run([CXX, "-std=c++17", "-c", source, *self.flags("--cflags", f"glark-{name}")], env=self.environment,
                                  cwd=self.folder, capture_output=True, text=True)
            self.assertIn("the C++ headers of glark need C++20: compile with -std=c++20", done.stderr)

    def test_shared_libraries_export_what_is_public(self):
        for name in COMPONENTS:
            library = self.libraries / f"libglark-{name}.so.0"
            dynamic = self.run_checked("readelf", "--dynamic", "--wide", library)
            self.assertIn(f"[libglark-{name}.so.0]", dynamic)
            symbols = self.run_checked("nm", "--dynamic", "--defined-only", "--demangle", library).splitlines()
            own = re.compile(r"(glark_|glark::|(typeinfo|typeinfo name|vtable) for glark::)")
            self.assertEqual([], [line for line in symbols if not own.match(line.split(maxsplit=2)[2])])
            self.assertEqual([], [line for line in symbols if "::State::" in line])

    def test_cmake(self):
        build = self.folder / "build"
        self.run_checked(CMAKE, "-S", HERE / "project", "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}", f"-DCMAKE_C_COMPILER={CC}",
                         f"-DCMAKE_CXX_COMPILER={CXX}", f"-DPROGRAMS={PROGRAMS}", f"-DREADME_LINES={self.folder}",
                         f"-DCOMPONENTS={';'.join(COMPONENTS)}")
        self.run_checked(CMAKE, "--build", build, "--parallel", "2")
        self.expect_refined(build / "readme")
        if COMPONENTS:
            self.run_checked(build / "client")
            self.run_checked(build / "client_static")

    def test_registry(self):
        self.assertIn("GL_ARK", pathlib.Path(self.flags("--variable=registry", "glark")[0]).read_text())

    def test_headers_are_all_installed(self):
        """Every public header is there, unless its client library was not built."""
        source = HERE.parents[1] / "include"
        wanted = {"GL/glark.h", "GL/glark_version.h", "glark/error.h", "glark/export.h", "glark/c/types.h"}
        wanted |= {f"{folder}/{name}.h" for name in COMPONENTS for folder in ("glark", "glark/c")}
        wanted |= {"glark/point_stream.h"} if "stream" in COMPONENTS else set()
        wanted |= {"glark/edit_operations.h"} if "edit" in COMPONENTS else set()
        installed = {str(file.relative_to(self.prefix / "include")) for file in (self.prefix / "include").rglob("*.h")}
        self.assertEqual(wanted, installed)
        self.assertLessEqual({str(file.relative_to(source)) for file in source.rglob("*.h")} - installed,
                             {f"{folder}/{name}.h" for name in ("depth", "edit", "maps", "pn", "qas", "reconstruct", "stream", "surfel", "vstree")
                              for folder in ("glark", "glark/c")} | {"glark/edit_operations.h", "glark/point_stream.h"})

    def test_version_of_the_debian_packages(self):
        newest = (HERE.parents[1] / "debian/changelog").read_text().splitlines()[0]
        version = self.run_checked(self.prefix / "bin/glark", "--version").split()[1]
        self.assertTrue(newest.startswith(f"glark ({version})"), newest)

    def test_nothing_names_the_build(self):
        for file in [*self.packages.glob("*.pc"), *self.libraries.rglob("*.cmake")]:
            self.assertNotIn(str(README.parent), file.read_text(), file.name)


if __name__ == "__main__":
    CMAKE, BUILD, CC, CXX, *COMPONENTS = sys.argv[1:]
    unittest.main(argv=sys.argv[:1])
