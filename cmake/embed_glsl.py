# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Writes a GLSL file as a C++ raw string literal, with its #include "..." lines (from the root) expanded once each."""
import pathlib
import re
import sys


def expand(root: pathlib.Path, path: pathlib.Path, seen: set) -> str:
    lines = []
    for line in path.read_text().splitlines():
        match = re.match(r'\s*#\s*include\s+"([^"]+)"', line)
        if match:
            included = root / match.group(1)
            if included not in seen:
                seen.add(included)
                lines.append(expand(root, included, seen))
        elif not re.match(r"\s*#\s*pragma\s+once", line):
            lines.append(line)
    return "\n".join(lines)


def main() -> None:
    root, source, output = map(pathlib.Path, sys.argv[1:4])
    text = expand(root, source, {source})
    output.parent.mkdir(parents=True, exist_ok=True)
    pieces = [text[i:i + 12000] for i in range(0, len(text), 12000)]  # compilers limit the length of one literal
    output.write_text("\n".join(f'R"glsl({piece})glsl"' for piece in pieces) + "\n")


main()
