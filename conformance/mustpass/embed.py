# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""embed.py LIST OUT: writes the names of a must-pass list as a C++ initializer."""
import sys
from pathlib import Path

lines = [line.split("#")[0].strip() for line in Path(sys.argv[1]).read_text().splitlines()]
Path(sys.argv[2]).write_text("".join(f'"{name}",\n' for name in lines if name))
