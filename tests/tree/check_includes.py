# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Which folder may include what: the data flow of docs/architecture.md, one stage, one folder."""
import re
import unittest

from tracked import tracked_files, violations

CORE = "glark/core/"
# The folders of the core, lowest first. A folder includes headers of its own and of those before it; files at the core's root
# include all of them.
STAGES = ["objects", "state", "pattern", "capture", "weld", "depth", "keep", "refine", "programs", "polygons", "plan", "passes",
          "submit", "feedback", "immediate", "track"]
# Values that the state holds.
VALUE_HEADERS = {
    "glark/core/capture/record.h",
    "glark/core/refine/derive.h",
}
TOP = (CORE + "context.h", CORE + "refined_draw.h", CORE + "stages.h")
WINDOW_SYSTEMS = ("EGL/", "X11/", "GL/glx", "GL/osmesa", "epoxy/", "dlfcn.h", "link.h")
PUBLIC_HEADER = re.compile(r"glark/\w+\.h")  # include/glark; no header of the library lies in glark/ itself
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)


def stage_of(name: str) -> str:
    """The stage that a path of the core lies in; empty at the core's root and outside."""
    if not name.startswith(CORE):
        return ""
    folder, _, rest = name[len(CORE):].partition("/")
    return folder if rest else ""


def stage_may_include(name: str, included: str) -> bool:
    mine, theirs = stage_of(name), stage_of(included)
    if not theirs or mine == theirs:
        return True
    return not mine or included in VALUE_HEADERS or STAGES.index(theirs) < STAGES.index(mine)


def complaint_about(name: str, included: str, quoted: bool) -> str:
    """Why the file may not include this; empty when it may."""
    ours = included.startswith(("glark/", "shim/", "generated/", "tests/", "examples/", "conformance/"))
    if included.startswith("generated/") or "../" in included:
        return "paths are written from the repository's root or the root of the generated files"
    if name.startswith("glark/gl/"):
        return "glark/gl includes nothing of ours" if ours and not included.startswith("glark/gl/") else ""
    if name.startswith(CORE):
        if included.startswith(WINDOW_SYSTEMS):
            return "the core gets its functions from a gl::Dispatch and knows no window system"
        if ours and not included.startswith((CORE, "glark/gl/")):
            return "the core includes glark/core and glark/gl only"
        if stage_of(name) not in ("", "track") and included in TOP:
            return "the list of steps sees the stages, not they it; only track, which comes before it, hands draws to it"
        if not stage_may_include(name, included):
            return f"stage {stage_of(name) or 'root'} may include only earlier stages"
    elif name.startswith("shim/"):
        if included.startswith(("epoxy/", "GL/osmesa")):
            return "the shim loads no GL library by itself"
        if ours and not included.startswith(("shim/", "glark/core/", "glark/gl/", "glark/settings")):
            return "the shim includes shim, glark/core, glark/gl and glark/settings only"
    elif name.startswith("glark/settings/"):
        if ours and not included.startswith(("glark/settings/", CORE + "refinement.h", CORE + "report.h")):
            return "the settings include only themselves and what they set: glark/core/refinement.h and report.h"
    elif name.startswith(("glark/tool/scan/", "glark/tool/view/")):
        allowed = ("glark/clients/common/", "glark/clients/geometry/", "glark/tool/scan/", name[:len("glark/tool/scan/")])
        if ours and not included.startswith(allowed) and not PUBLIC_HEADER.fullmatch(included):
            return "the commands for files use glark/clients/geometry, glark/clients/common and the public headers"
    elif name.startswith("glark/tool/"):
        if ours and not included.startswith(("glark/settings", "glark/tool/")):
            return "the launcher includes only glark/settings"
    elif name.startswith("glark/clients/"):
        own = "/".join(name.split("/")[:3]) + "/"
        if ours and not included.startswith((own, "glark/clients/common/")) and not PUBLIC_HEADER.fullmatch(included):
            return "a client library uses the public headers, glark/clients/common and its own folder only"
    elif name.startswith("examples/"):
        if (ours and not PUBLIC_HEADER.fullmatch(included)) or (quoted and "/" in included):
            return "examples use the public headers only"
    elif name.startswith("conformance/"):
        if ours and not included.startswith("conformance/"):
            return "the conformance suite uses the extension's header and a context, nothing of the library"
    elif name.startswith("tests/clients/"):
        if ours and not included.startswith("tests/clients/"):
            return "client programs know nothing of glark"
    return ""


def rule(name: str, text: str) -> list:
    found = []
    for match in INCLUDE.finditer(text):
        complaint = complaint_about(name, match.group(1) or match.group(2), match.group(1) is not None)
        if complaint:
            found.append(f"includes {match.group(1) or match.group(2)}: {complaint}")
    return found


class Includes(unittest.TestCase):
    def test_tree_follows_the_data_flow(self):
        names = [name for name in tracked_files() if name.endswith((".c", ".cpp", ".h", ".glsl"))]
        self.assertEqual([], violations(rule, names))

    def test_rule_rejects(self):
        for name, line in [
            ("glark/gl/types.h", '#include "glark/core/report.h"'),
            ("glark/core/context.cpp", '#include "shim/thread.h"'),
            ("glark/core/context.cpp", '#include "generated/glark/gl/dispatch.h"'),
            ("glark/core/report.cpp", "#include <EGL/egl.h>"),
            ("glark/core/capture/capture.cpp", '#include "glark/core/refine/rewrite.h"'),
            ("glark/core/capture/capture.cpp", '#include "glark/core/submit/submit.h"'),
            ("glark/core/submit/submit.cpp", '#include "glark/core/context.h"'),
            ("glark/core/plan/planner.cpp", '#include "glark/core/track/track.h"'),
            ("shim/glx.cpp", "#include <GL/osmesa.h>"),
            ("glark/tool/run.cpp", '#include "glark/core/report.h"'),
            ("glark/tool/run.cpp", '#include "glark/clients/geometry/formats.h"'),
            ("glark/tool/scan/info.cpp", '#include "glark/clients/qas/topology.h"'),
            ("glark/tool/scan/info.cpp", '#include "glark/tool/view/camera.h"'),
            ("examples/a.cpp", '#include "glark/core/report.h"'),
            ("glark/clients/depth/a.cpp", '#include "glark/core/report.h"'),
            ("tests/clients/a.c", '#include "glark/gl/types.h"'),
            ("conformance/cases/a.cpp", '#include "glark/core/pattern/pool.h"'),
            ("conformance/cases/a.cpp", "#include <glark/pn.h>"),
            ("glark/clients/qas/a.cpp", '#include "glark/core/report.h"'),
            ("glark/clients/reconstruct/a.cpp", '#include "glark/clients/vstree/quadric.h"'),
            ("glark/clients/common/a.h", '#include "glark/clients/vstree/quadric.h"'),
        ]:
            with self.subTest(file=name, line=line):
                self.assertEqual(1, len(rule(name, line + "\n")))

    def test_rule_accepts(self):
        for name, line in [
            ("glark/core/submit/submit.cpp", '#include "glark/core/capture/record.h"'),
            ("glark/core/refined_draw.cpp", '#include "glark/core/submit/submit.h"'),
            ("glark/core/context.h", '#include "glark/core/refine/fixed_function.h"'),
            ("shim/glx.cpp", '#include "glark/core/context.h"'),
            ("examples/a.cpp", "#include <GL/glark.h>"),
            ("conformance/cases/a.cpp", '#include "conformance/suite/test.h"'),
            ("examples/a.cpp", "#include <glark/qas.h>"),
            ("glark/clients/qas/a.cpp", "#include <glark/qas.h>"),
            ("glark/clients/qas/a.cpp", '#include "glark/clients/qas/topology.h"'),
            ("glark/clients/qas/a.cpp", '#include "glark/clients/common/vector.h"'),
            ("glark/tool/scan/info.cpp", '#include "glark/clients/geometry/formats.h"'),
            ("glark/tool/scan/strip.cpp", "#include <glark/surfel.h>"),
            ("glark/tool/view/main.cpp", '#include "glark/tool/scan/files.h"'),
            ("examples/a.cpp", "#include <glark/depth.h>"),
            ("glark/clients/depth/a.cpp", "#include <glark/depth.h>"),
        ]:
            with self.subTest(file=name, line=line):
                self.assertEqual([], rule(name, line + "\n"))


if __name__ == "__main__":
    unittest.main()
