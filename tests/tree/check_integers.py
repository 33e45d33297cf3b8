# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""A file that names std::uint32_t and the like includes <cstdint>, itself or through files of the tree: GCC 14's other headers
no longer do."""
import posixpath
import re
import unittest

from tracked import text_of, tracked_files

INTEGER = re.compile(r"\bstd::u?int(?:_fast|_least)?(?:8|16|32|64|ptr|max)_t\b")
INCLUDED = re.compile(r'^\s*#include [<"]([^>"]+)[>"]', re.MULTILINE)


def without_comments(text: str) -> str:
    return re.sub(r"//.*", "", text)


def find(name: str, included: str, sources: dict):
    """The file of the tree that an #include means, or None."""
    places = (included, f"include/{included}", posixpath.join(posixpath.dirname(name), included))
    return next((place for place in places if place in sources), None)


def includes_integers(name: str, sources: dict, seen: set) -> bool:
    if name in seen:
        return False
    seen.add(name)
    for included in INCLUDED.findall(sources[name]):
        if included in ("cstdint", "stdint.h"):
            return True
        file = find(name, included, sources)
        if file and includes_integers(file, sources, seen):
            return True
    return False


def offenders(sources: dict) -> list:
    return [name for name, text in sources.items()
            if INTEGER.search(without_comments(text)) and not includes_integers(name, sources, set())]


class Integers(unittest.TestCase):
    def test_tree(self):
        sources = {name: text_of(name) for name in tracked_files() if name.endswith((".h", ".cpp"))}
        self.assertEqual([], offenders(sources))

    def test_finds_a_missing_header(self):
        sources = {"a.h": "std::uint8_t a;", "b.h": "#include <cstdint>\n", "c.cpp": '#include "b.h"\nstd::int64_t c;',
                   "d.cpp": "// std::uint8_t\n", "e/f.h": '#include "g.h"\nstd::uintptr_t f;', "e/g.h": "#include <stdint.h>\n"}
        self.assertEqual(["a.h"], offenders(sources))


if __name__ == "__main__":
    unittest.main()
