# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Programs of 32 bits, programs of 64 bits, and programs of one kind that start one of the other, all under one `glark run`.

  check_i386.py --glark GLARK [--library LIBRARY --library-i386 LIBRARY] [--compiler CC]

Without the libraries, those of the installation of GLARK are used. Status 77: something for programs of 32 bits is not installed.
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
GEARS = "glxgears.i386-linux-gnu"
HOW = "run scripts/install_packages --i386"
ARGUMENTS = argparse.Namespace()


def environment(**more) -> dict:
    kept = {key: value for key, value in os.environ.items() if not key.startswith("GLARK_") and key != "LD_PRELOAD"}
    return kept | {"GLARK_CONFIG": "/dev/null", "LIBGL_ALWAYS_SOFTWARE": "1"} | more


def compile_programs(compiler: str, folder: pathlib.Path) -> str:
    """Returns why the programs cannot be made, or nothing."""
    libraries = {"picture": ["-l:libOpenGL.so.0", "-l:libEGL.so.1"], "start": []}
    for name in libraries:
        for bits in (32, 64):
            words = [compiler, "-std=gnu11", f"-m{bits}", "-O1", HERE / f"programs/{name}.c", "-o", folder / f"{name}{bits}"]
            done = subprocess.run([*words, *libraries[name]], capture_output=True, text=True)
            if done.returncode != 0:
                return f"{name}.c cannot be compiled with -m{bits}; {HOW}: {done.stderr.splitlines()[0]}"
    return ""


class Programs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        if why := compile_programs(ARGUMENTS.compiler, cls.folder):
            raise unittest.SkipTest(why)
        cls.variables = {}
        if ARGUMENTS.library:  # where the dynamic linkers look for $LIB
            for file, machine in ((ARGUMENTS.library, "x86_64"), (ARGUMENTS.library_i386, "i386")):
                place = cls.folder / "lib" / f"{machine}-linux-gnu"
                place.mkdir(parents=True)
                (place / "libGLARK.so.0").symlink_to(file)
            cls.variables = {"GLARK_LIBRARY": f"{cls.folder}/$LIB/libGLARK.so.0"}

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def run_(self, *words, **variables) -> str:
        done = subprocess.run([str(word) for word in words], env=environment(**variables), cwd=self.folder, capture_output=True, text=True,
                              timeout=200)
        self.assertEqual(0, done.returncode, f"{words}\n{done.stdout}{done.stderr}")
        return done.stderr

    def expect_refined(self, *program):
        """The program draws as it does alone, its draws are refined, and nobody complains."""
        alone, refined = self.folder / "alone.ppm", self.folder / "refined.ppm"
        self.run_(*program, alone)
        for file in self.folder.glob("statistics-*"):
            file.unlink()
        said = self.run_(ARGUMENTS.glark, "run", "--refine", "outputs", "--level", "2", "--everything", "--stats", "statistics-%p.json", "--",
                         *program, refined, **self.variables)
        self.assertEqual("", said)
        draws = [json.loads(file.read_text())["draws"]["refined"] for file in self.folder.glob("statistics-*")]
        self.assertEqual(3, sum(draws))
        one, other = alone.read_bytes(), refined.read_bytes()
        self.assertEqual(len(one), len(other))
        self.assertGreater(sum(value > 20 for value in one), 10000, "the picture is empty")
        far = sum(abs(a - b) > 2 for a, b in zip(one, other))
        self.assertLess(far, 300, "the pictures differ")

    def test_32_bits(self):
        self.expect_refined(self.folder / "picture32")

    def test_64_bits(self):
        self.expect_refined(self.folder / "picture64")

    def test_64_bits_start_32(self):
        self.expect_refined(self.folder / "start64", self.folder / "picture32")

    def test_32_bits_start_64(self):
        self.expect_refined(self.folder / "start32", self.folder / "picture64")

    def test_gears_of_32_bits(self):
        if not shutil.which(GEARS) or not shutil.which("xvfb-run"):
            self.skipTest(f"{GEARS} or xvfb-run is not installed; {HOW}")
        statistics = self.folder / "gears.json"
        words = ["xvfb-run", "-a", ARGUMENTS.glark, "run", "--refine", "outputs", "--level", "2", "--everything", "--stats", statistics,
                 "--capture", f"10:{self.folder}/gears.png", "--", "timeout", "-s", "INT", "40", GEARS]
        done = subprocess.run([str(word) for word in words], env=environment(**self.variables), capture_output=True, text=True)
        self.assertTrue((self.folder / "gears.png").exists(), done.stderr)
        if ARGUMENTS.keep:
            shutil.copy(self.folder / "gears.png", ARGUMENTS.keep)

    def test_without_the_library(self):
        """One line says what is missing, and the program runs unrefined."""
        only = ARGUMENTS.library or next(pathlib.Path("/usr/lib/x86_64-linux-gnu").glob("libGLARK.so.0"))
        said = self.run_(ARGUMENTS.glark, "run", "--", self.folder / "picture32", self.folder / "plain.ppm", GLARK_LIBRARY=str(only))
        own = [line for line in said.splitlines() if line.startswith("glark: ")]
        self.assertEqual(1, len(own), said)
        self.assertIn("there is no libGLARK.so for i386, so it stays unrefined; install the package libglark0:i386", own[0])
        self.assertTrue((self.folder / "plain.ppm").exists())


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--glark", required=True)
    parser.add_argument("--library", type=pathlib.Path)
    parser.add_argument("--library-i386", type=pathlib.Path)
    parser.add_argument("--compiler", default="gcc")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the picture of glxgears")
    parser.parse_args(namespace=ARGUMENTS)
    if ARGUMENTS.library and not (ARGUMENTS.library_i386 and ARGUMENTS.library_i386.exists()):
        print("check_i386: skipped: there is no libGLARK.so for i386 here. scripts/in_root bookworm-i386 scripts/build release GLARK makes "
              "it in the chroot's var/build/release/lib; then configure with -DGLARK_LIBRARY_I386=FILE")
        return 77
    program = unittest.main(argv=sys.argv[:1], exit=False, verbosity=2)
    if not program.result.wasSuccessful():
        return 1
    return 77 if program.result.skipped else 0


sys.exit(main())
