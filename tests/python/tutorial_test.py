# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The program of docs/tutorial/python.md runs, and its picture shows a round body."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

try:
    from PIL import Image
except ImportError:
    Image = None

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/tutorial/python.md"


class Tutorial(unittest.TestCase):
    @unittest.skipIf(Image is None and not os.environ.get("CI"), "python3-pil is missing (scripts/install_packages installs it)")
    def test_program(self):
        text = re.search(r"```python\n(.*?)```", PAGE.read_text(), re.DOTALL).group(1)
        self.assertLessEqual(len([line for line in text.splitlines() if line.strip()]), 42)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            coverage = []
            for number, source in enumerate((text, text.replace("GL.glEnable(ark.GL_ARK)\n", ""))):
                (folder / "ball.py").write_text(source)
                done = subprocess.run([sys.executable, "-m", "glark.gl", "ball.py"], cwd=folder, capture_output=True, text=True,
                                      env=os.environ | {"PYOPENGL_PLATFORM": "osmesa"})
                self.assertEqual(0, done.returncode, done.stderr)
                self.assertRegex(done.stdout, r"^20000 points, (39|40)\d coarse triangles, ball.png$")
                pixels = Image.open(folder / "ball.png").convert("L")
                coverage.append(sum(value > 0 for value in pixels.getdata()))
            self.assertGreater(coverage[0], 60000)
            self.assertGreater(coverage[0], coverage[1])  # the curved body reaches beyond the coarse one


if __name__ == "__main__":
    unittest.main()
