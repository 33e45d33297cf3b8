# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Objects whose __init__ never ran raise TypeError wherever they are used. They do not crash."""
import unittest

import glark

SUBMODULES = (glark.depth, glark.maps, glark.pn, glark.qas, glark.surfel, glark.vstree)
MESSAGE = "its __init__ was not called"


def classes() -> list:
    found = {glark.Geometry, glark.Reconstructed}
    for module in SUBMODULES:
        found |= {value for value in vars(module).values() if isinstance(value, type) and not hasattr(value, "__members__")}
    return sorted(found, key=lambda one: one.__name__)


class Uninitialised(unittest.TestCase):
    def test_properties_raise(self):
        for one in classes():
            names = [name for name, value in vars(one).items() if isinstance(value, property)]
            self.assertTrue(names or one is glark.qas.LoopSurface, one)
            for name in names:
                with self.subTest(f"{one.__name__}.{name}"), self.assertRaisesRegex(TypeError, MESSAGE):
                    getattr(one.__new__(one), name)

    def test_methods_raise(self):
        for one in classes():
            for name, value in vars(one).items():
                if callable(value) and not name.startswith("_"):
                    with self.subTest(f"{one.__name__}.{name}"), self.assertRaises(TypeError):
                        value(one.__new__(one))
        with self.assertRaisesRegex(TypeError, MESSAGE):
            glark.qas.LoopSurface.__new__(glark.qas.LoopSurface).refine(1)

    def test_subclasses_without_init_raise(self):
        class Own(glark.vstree.Tree):
            pass

        with self.assertRaisesRegex(TypeError, MESSAGE):
            len(Own.__new__(Own).nodes)


if __name__ == "__main__":
    unittest.main()
