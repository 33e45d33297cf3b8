# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Every shader of ours that stands alone (has a #version of its own) compiles with glslangValidator, as it is embedded."""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from tracked import ROOT, tracked_files

STAGES = {"vert", "tesc", "tese", "geom", "frag", "comp"}


def embedded_text(name: str) -> str:
    """The shader as cmake/embed_glsl.py puts it into the library, its #include lines expanded."""
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder) / "shader.inc"
        subprocess.run([sys.executable, ROOT / "cmake" / "embed_glsl.py", ROOT, ROOT / name, output], check=True)
        return "".join(re.findall(r'R"glsl\((.*?)\)glsl"', output.read_text(), re.DOTALL))


def stage_of(name: str, text: str) -> str:
    """From NAME.STAGE.glsl, or from what only one stage has."""
    infix = name.split(".")[-2] if name.count(".") > 1 else ""
    if infix in STAGES:
        return infix
    if re.search(r"\blocal_size_x\b", text):
        return "comp"
    return "vert" if re.search(r"\bgl_Position\b", text) else "frag"


def stands_alone(text: str) -> bool:
    return re.search(r"^\s*#\s*version\b", text, re.MULTILINE) is not None


def compile_errors(name: str, text: str) -> str:
    result = subprocess.run(["glslangValidator", "--stdin", "-S", stage_of(name, text)], input=text,
                            capture_output=True, text=True)
    return "" if result.returncode == 0 else f"{name}:\n{result.stdout}{result.stderr}"


class Shaders(unittest.TestCase):
    def test_shaders_compile(self):
        shaders = [name for name in tracked_files() if name.endswith(".glsl")]
        alone = [(name, text) for name, text in ((name, embedded_text(name)) for name in shaders) if stands_alone(text)]
        print(f"{len(alone)} of {len(shaders)} shaders stand alone", file=sys.stderr)
        self.assertEqual([], [errors for errors in (compile_errors(*shader) for shader in alone) if errors])

    def test_rejects_a_wrong_shader(self):
        self.assertTrue(compile_errors("a.vert.glsl", "#version 430\nvoid main() { gl_Position = undeclared; }\n"))

    def test_accepts_a_right_shader(self):
        self.assertEqual("", compile_errors("a.glsl", "#version 430\nvoid main() { gl_Position = vec4(0); }\n"))


if __name__ == "__main__":
    unittest.main()
