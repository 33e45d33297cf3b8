# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Feeds glark.xml to the generator of a loader library, compiles the loader, and calls the extension through it.

  check_generator.py LOADER SOURCES LIBRARY REGISTRY CC

LOADER is epoxy or glew. SOURCES is the folder where scripts/parts/generator_sources puts the sources of both. Status 77: they
are not there.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "cmake"))
from registry import merged  # noqa: E402

EXTENSION = "GL_ARK_adaptive_refinement"
SPECIFICATION = HERE.parents[1] / "docs/spec" / f"{EXTENSION}.txt"
EXPECTED = "deepest 3, tag 2, enabled 1, error 0x0"
EGL = ["-lEGL"]


def run(*words, cwd=None, given="", **variables) -> str:
    done = subprocess.run([str(word) for word in words], cwd=cwd, env=os.environ | variables, input=given, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"check_generator: status {done.returncode}: {' '.join(map(str, words))}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done.stdout


def make_epoxy(source: pathlib.Path, registry: pathlib.Path, folder: pathlib.Path) -> list:
    """libepoxy reads one registry: its own, with ours merged into it."""
    base = ElementTree.parse(source / "registry/gl.xml").getroot()
    ElementTree.ElementTree(merged(base, [ElementTree.parse(registry).getroot()])).write(folder / "gl.xml")
    generated = folder / "epoxy"
    generated.mkdir()
    for file in (folder / "gl.xml", source / "registry/egl.xml"):
        run(sys.executable, source / "src/gen_dispatch.py", "--includedir", generated, "--srcdir", folder, file)
    (folder / "config.h").write_text("#define ENABLE_EGL 1\n#define ENABLE_GLX 0\n#define ENABLE_X11 0\n"
                                     '#define EPOXY_PUBLIC __attribute__((visibility("default"))) extern\n#define HAVE_KHRPLATFORM_H\n')
    files = [source / "src/dispatch_common.c", source / "src/dispatch_egl.c", *folder.glob("*_generated_dispatch.c")]
    # The generated headers lie beside headers of the same folder in the sources.
    return ["-DEGL_NO_X11", f"-I{folder}", f"-I{source}/include", f"-I{source}/src", *files, "-ldl"]


def lines_of(descriptor: pathlib.Path) -> set:
    """The tokens and functions that a text of GLEW's names. Its reader of registries knows no "const *const*" and drops the second
    const, so types are compared without spaces and without it."""
    lines = [line.strip() for line in descriptor.read_text().splitlines()[4:]]
    return {line.replace(" ", "").replace("*const*", "*") for line in lines}


def make_glew(source: pathlib.Path, registry: pathlib.Path, folder: pathlib.Path) -> list:
    """GLEW reads one text for each extension. Its scripts write it from the specification, as GLEW does for OpenGL, or from a
    registry, as GLEW does for window systems. Both must say the same."""
    copy = folder / "glew"
    shutil.copytree(source, copy)
    auto = copy / "auto"
    texts = auto / "extensions/gl"
    run(sys.executable, "bin/parse_xml.py", registry, "--api", "gl", "--extensions", texts, cwd=auto)
    from_registry = lines_of(texts / EXTENSION)
    run("perl", "bin/parse_spec.pl", texts, cwd=auto, given=f"{SPECIFICATION}\n")
    from_specification = lines_of(texts / EXTENSION)
    if from_registry != from_specification or len(from_registry) < 50:
        sys.exit(f"check_generator: GLEW reads differently: {sorted(from_registry ^ from_specification)}")
    for name in ("include/GL/glew.h", "src/glew.c"):
        (copy / name).unlink()
    for done in (auto / "OpenGL-Registry", auto / "EGL-Registry", texts):  # the texts of all other extensions come with the sources
        done.mkdir(exist_ok=True)
        (done / ".dummy").touch()
    run("make", "-C", auto, f"PYTHON={sys.executable}", "../include/GL/glew.h", "../src/glew.c")
    return ["-DGLEW_EGL", "-DGLEW_NO_GLU", "-DGLEW_STATIC", f"-I{copy}/include", copy / "src/glew.c", "-lOpenGL"]


MAKERS = {"epoxy": ("libepoxy-*", make_epoxy), "glew": ("glew-*", make_glew)}


def main() -> int:
    loader, sources, library, registry, compiler = sys.argv[1:]
    pattern, make = MAKERS[loader]
    found = sorted(path for path in pathlib.Path(sources).glob(pattern) if path.is_dir())
    if not found:
        print(f"check_generator: skipped: there is no {pattern} in {sources}; run scripts/parts/generator_sources")
        return 77
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        parts = make(found[-1], pathlib.Path(registry), folder)
        program = folder / "program"
        run(compiler, "-std=gnu11", "-O0", "-w", HERE / f"programs/use_{loader}.c", "-o", program, *parts, *EGL)
        printed = run(program, LD_PRELOAD=library, GLARK_CONFIG="/dev/null", LIBGL_ALWAYS_SOFTWARE="1")
        without = subprocess.run([program], env=os.environ | {"LIBGL_ALWAYS_SOFTWARE": "1"}, capture_output=True, text=True)
    if printed.strip() != EXPECTED or without.returncode != 4:
        print(f"check_generator: with libGLARK: {printed}; without: status {without.returncode}, {without.stderr}", file=sys.stderr)
        return 1
    return 0


sys.exit(main())
