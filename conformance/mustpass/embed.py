# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""embed.py LIST OUT: writes a must-pass list as initializers of RequiredCase."""
import sys
from pathlib import Path

lines = [line.split("#")[0].strip() for line in Path(sys.argv[1]).read_text().splitlines()]
rows = []
for name, *apis in (line.split() for line in lines if line):
    rows.append(f'{{"{name}", {{{", ".join("Api::" + api.replace("-", "_") for api in apis)}}}}},\n')
Path(sys.argv[2]).write_text("".join(rows))
