#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""check_registry.py must notice every kind of disagreement. Each case plants one mistake in a small correct example."""
import unittest
import xml.etree.ElementTree as ElementTree

import check_registry

HEADER = """
#define GL_ARK                                   0x6F00
typedef void (GLARK_APIENTRY *PFNGLDRAWARPPROC)(GLenum mode, const void *p);
GLARK_API void GLARK_APIENTRY glDrawARP(GLenum mode, const void *p);
"""
REGISTRY = """<registry>
<enums start="0x6F00" end="0x6F0F"><enum value="0x6F00" name="GL_ARK" group="EnableCap"/></enums>
<commands><command><proto>void <name>glDrawARP</name></proto>
<param group="EnableCap"><ptype>GLenum</ptype> <name>mode</name></param><param>const void *<name>p</name></param></command></commands>
<extensions><extension name="GL_ARK_adaptive_refinement" supported="gl|glcore|gles2">
<require><enum name="GL_ARK"/><command name="glDrawARP"/></require></extension></extensions>
</registry>"""
SPECIFICATION = """
New Procedures and Functions

    void DrawARP(enum mode, const void *p);

New Tokens

        ARK                                      0x6F00

Overview

    glDrawARP draws.
"""
KHRONOS = """<registry><types><type>typedef unsigned int <name>GLenum</name>;</type></types>
<enums start="0x0000" end="0x7FFF"><enum value="0x0004" name="GL_TRIANGLES" group="EnableCap"/><unused start="0x6000" end="0x6FFF"/></enums>
<commands><command><proto>void <name>glEnd</name></proto></command></commands><extensions/></registry>"""


class Notices(unittest.TestCase):
    def problems(self, header=HEADER, registry=REGISTRY, specification=SPECIFICATION, khronos=KHRONOS):
        root = ElementTree.fromstring(registry)
        return [*check_registry.disagreements(header, root, specification),
                *check_registry.clashes(root, ElementTree.fromstring(khronos))]

    def assert_noticed(self, word, **texts):
        for key, text in texts.items():
            self.assertNotEqual(text, globals()[key.upper()], "the mistake was not planted")
        self.assertTrue(any(word in problem for problem in self.problems(**texts)), self.problems(**texts))

    def test_sound_example(self):
        self.assertEqual(self.problems(), [])

    def test_value_in_header(self):
        self.assert_noticed("token GL_ARK", header=HEADER.replace("0x6F00", "0x6F01"))

    def test_value_in_specification(self):
        self.assert_noticed("token GL_ARK", specification=SPECIFICATION.replace("0x6F00", "0x6F01"))

    def test_token_missing_from_header(self):
        self.assert_noticed("token GL_ARK", header=HEADER.replace("#define GL_ARK", "#define GL_BARK"))

    def test_parameter_type_in_header(self):
        self.assert_noticed("prototype glDrawARP", header=HEADER.replace("glDrawARP(GLenum", "glDrawARP(GLint"))

    def test_function_type_in_header(self):
        self.assert_noticed("function type PFNGLDRAWARPPROC", header=HEADER.replace("PROC)(GLenum", "PROC)(GLint"))

    def test_prototype_in_specification(self):
        self.assert_noticed("prototype glDrawARP", specification=SPECIFICATION.replace("enum mode", "uint mode"))

    def test_unknown_name_in_specification(self):
        self.assert_noticed("glDrawARPs", specification=SPECIFICATION.replace("glDrawARP draws", "glDrawARPs draws"))

    def test_command_not_required(self):
        self.assert_noticed("required but not defined", registry=REGISTRY.replace('<command name="glDrawARP"/>', ""))

    def test_token_of_khronos(self):
        self.assert_noticed("already has GL_ARK", khronos=KHRONOS.replace("GL_TRIANGLES", "GL_ARK"))

    def test_function_of_khronos(self):
        self.assert_noticed("already has glDrawARP", khronos=KHRONOS.replace("glEnd", "glDrawARP"))

    def test_value_of_khronos(self):
        self.assert_noticed("lies in our block", khronos=KHRONOS.replace("0x0004", "0x6F00"))

    def test_block_no_longer_unused(self):
        self.assert_noticed("overlaps our block", khronos=KHRONOS.replace("0x6FFF", "0x6EFF"))

    def test_value_outside_block(self):
        self.assert_noticed("outside the block", registry=REGISTRY.replace('value="0x6F00"', 'value="0x6F10"'))

    def test_used_value_that_is_listed_as_unused(self):
        self.assert_noticed("listed as unused", registry=REGISTRY.replace("</enums>", '<unused start="0x6F00" end="0x6F02"/></enums>'))

    def test_unknown_type(self):
        self.assert_noticed("type GLenum", khronos=KHRONOS.replace("GLenum", "GLint"))


if __name__ == "__main__":
    unittest.main()
