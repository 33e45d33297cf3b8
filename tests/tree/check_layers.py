# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""cmake/check_layers.py finds includes that go up, and the tree has none; every folder of the tree has a layer."""
import subprocess
import sys
import unittest

from tracked import ROOT, tracked_files

sys.path.insert(0, str(ROOT / "cmake"))
import check_layers  # noqa: E402

SMALL = """
[public:]
include/glark
[library: public]
core/state   # lowest
core/draw | core/list
core/context
[clients: public]
clients/a | clients/b
never core: EGL/
"""


def small(name: str, included: str) -> str:
    return check_layers.complaint_about(check_layers.read_layers(SMALL), name, included)


class Rule(unittest.TestCase):
    def test_down_is_allowed(self):
        for name, included in [("core/draw/a.cpp", "core/state/b.h"), ("core/context.cpp", "core/list/a.h"),
                               ("core/context.h", "core/context.inc"), ("clients/a/x.cpp", "include/glark/a.h"),
                               ("core/draw/a.cpp", "vector")]:
            self.assertEqual("", small(name, included), (name, included))

    def test_up_is_refused(self):
        self.assertIn("below", small("core/state/a.h", "core/draw/b.h"))
        self.assertIn("below", small("core/list/a.h", "core/context.h"))

    def test_siblings_are_refused(self):
        self.assertIn("siblings", small("core/draw/a.h", "core/list/b.h"))
        self.assertIn("siblings", small("clients/a/x.cpp", "clients/b/private.h"))

    def test_groups_are_refused(self):
        self.assertIn("does not use", small("clients/a/x.cpp", "core/state/b.h"))
        self.assertIn("does not use", small("core/state/a.h", "clients/a/x.h"))

    def test_forbidden_headers_are_refused(self):
        self.assertIn("never", small("core/state/a.cpp", "EGL/egl.h"))
        self.assertIn("root", small("core/state/a.cpp", "../draw/b.h"))

    def test_a_file_needs_a_layer(self):
        found = check_layers.complaints_in(check_layers.read_layers(SMALL), "elsewhere/a.cpp", "#include <vector>\n")
        self.assertEqual(1, len(found))

    def test_includes_are_found(self):
        layers = check_layers.read_layers(SMALL)
        text = '  # include "core/draw/b.h"\n#include <vector>\n// #include "core/context.h"\n'
        self.assertEqual(1, len(check_layers.complaints_in(layers, "core/state/a.h", text)))


class Tree(unittest.TestCase):
    def setUp(self):
        self.layers = check_layers.read_layers((ROOT / "cmake" / "layers.txt").read_text())

    def test_tree_follows_the_layers(self):
        done = subprocess.run([sys.executable, ROOT / "cmake" / "check_layers.py", ROOT], capture_output=True, text=True)
        self.assertEqual((0, ""), (done.returncode, done.stderr))

    def test_every_layer_has_files(self):
        names = tracked_files()
        for path in self.layers.lines:
            if path.endswith(".inc"):  # generated
                continue
            self.assertTrue(any(check_layers.layer_of(self.layers, name) == path for name in names), path)

    def test_rules_that_must_stay(self):
        for name, included in [("conformance/cases/a.cpp", "include/glark/pn.h"), ("examples/a.cpp", "glark/core/report/log.h"),
                               ("glark/clients/qas/a.cpp", "glark/core/report/log.h"), ("glark/tool/run.cpp", "glark/core/report/log.h"),
                               ("glark/tool/scan/info.cpp", "glark/tool/view/draw/camera.h"), ("tests/clients/a.c", "glark/gl/types.h"),
                               ("glark/gl/types.h", "glark/core/report/log.h"), ("shim/entry/glx.cpp", "GL/osmesa.h")]:
            self.assertNotEqual("", check_layers.complaint_about(self.layers, name, included), (name, included))


if __name__ == "__main__":
    unittest.main()
