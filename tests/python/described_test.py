# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""help() explains every function, method and property, and the type stubs name them all."""
import inspect
import pathlib
import re
import unittest

import glark

STUBS = pathlib.Path(glark.__file__).parent


def public(things: dict) -> dict:
    return {name: thing for name, thing in things.items() if not name.startswith("_")}


def is_ours(thing) -> bool:
    return getattr(thing, "__module__", "").startswith("glark")


class Described(unittest.TestCase):
    def setUp(self):
        self.modules = [glark, *(thing for thing in public(vars(glark)).values()
                                 if inspect.ismodule(thing) and (STUBS / f"{thing.__name__.split('.')[-1]}.pyi").exists())]
        self.assertGreater(len(self.modules), 5)

    def described(self, module):
        """(name, what has the text) of each public thing of a module, with the members of its classes."""
        for name, thing in public(vars(module)).items():
            if inspect.isclass(thing) and is_ours(thing):
                yield name, thing
                for member, value in public(vars(thing)).items():
                    yield f"{name}.{member}", value
            elif callable(thing) and is_ours(thing):
                yield name, thing

    def test_texts(self):
        mute = [f"{module.__name__}.{name}" for module in self.modules for name, thing in self.described(module)
                if not (thing.__doc__ or "").strip()]
        self.assertEqual([], mute)

    def test_stubs(self):
        for module in self.modules:
            parts = module.__name__.split(".")
            stub = (STUBS / ("__init__.pyi" if len(parts) == 1 else f"{parts[-1]}.pyi")).read_text(encoding="utf-8")
            missing = [name for name, _ in self.described(module)
                       if not re.search(rf"\b{name.split('.')[-1]}\b", stub)]
            self.assertEqual([], missing, module.__name__)


if __name__ == "__main__":
    unittest.main()
