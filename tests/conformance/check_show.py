# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""glark-conformance --show: the calls of a case are a program in C that compiles, and that draws what the case draws."""
import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

SUITE, LIBRARY, INCLUDE = os.environ["SUITE"], os.environ["LIBRARY"], os.environ["INCLUDE"]
COMPILER = ["cc", "-std=c99", "-Wall", "-Werror", "-Wno-unused", "-I" + INCLUDE]
# Makes a context, calls draw(), and prints the first error of GL and the mean of the bytes that were read last.
FRAME = """
#include <GL/osmesa.h>
#include <stdio.h>

static unsigned char pixels[128 * 128 * 4];

int main(void) {
  OSMesaMakeCurrent(OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL), pixels, GL_UNSIGNED_BYTE, 128, 128);
  draw();
  unsigned long sum = 0;
  for (int i = 0; i < 128 * 128 * 4; ++i) sum += results[i];
  printf("%x %lu\\n", glGetError(), sum / sizeof(pixels));
  return 0;
}
"""


def show(case, *options):
    done = subprocess.run([SUITE, "--implementation", LIBRARY, "--show", case, *options], capture_output=True, text=True,
                          timeout=120)
    return done.returncode, done.stdout, done.stderr


class Show(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def compile(self, text, *options):
        source = self.folder / "shown.c"
        source.write_text(text)
        subprocess.run([*COMPILER, str(source), *options], check=True, cwd=self.folder)

    def test_compiles(self):
        for case in ("ark.draw.again.other_command", "ark.change.result.get_query_objectuiv", "ark.random.program_00",
                     "ark.random.stage_00",
                     "ark.change.texture.tex_image2_d", "ark.list.again.attributes", "ark.usage.fixed_function"):
            with self.subTest(case):
                status, text, errors = show(case)
                self.assertEqual((0, ""), (status, errors))
                self.assertIn("// Plan: ", text)
                self.compile(text, "-fsyntax-only")
        status, text, _ = show("ark.draw.again.other_command", "--platform", "egl", "--api", "gles")
        self.assertEqual(0, status)
        self.assertIn("#include <GLES3/gl32.h>", text)
        self.compile(text, "-fsyntax-only")

    def test_draws(self):
        _, text, _ = show("ark.draw.again.other_command")
        self.compile(text + FRAME, "-o", "shown", "-Wl,--no-as-needed", LIBRARY, "-lOSMesa", "-lm")
        statistics = self.folder / "statistics.json"
        done = subprocess.run([self.folder / "shown"], capture_output=True, text=True, check=True,
                              env={**os.environ, "GLARK_STATS": str(statistics),
                                   "LD_LIBRARY_PATH": str(Path(LIBRARY).parent)})
        error, mean = done.stdout.split()
        self.assertEqual("0", error)
        self.assertGreater(int(mean), 5)
        counts = json.loads(statistics.read_text())
        self.assertGreater(counts["refined_triangles"], counts["coarse_triangles"])

    def test_a_case_that_does_not_exist(self):
        status, _, errors = show("ark.nothing")
        self.assertNotEqual(0, status)
        self.assertIn("no case ark.nothing", errors)


if __name__ == "__main__":
    unittest.main()
