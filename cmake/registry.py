# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Merges registries in the schema of Khronos' gl.xml, for generators that read only one."""
import xml.etree.ElementTree as ElementTree

SECTIONS = ("types", "commands", "extensions")


def merged(base: ElementTree.Element, additions: list) -> ElementTree.Element:
    """Changes and returns `base`: the children of each section of the additions follow those of the section of the same name."""
    for section in (section for addition in additions for section in addition):
        if section.tag == "enums":  # a registry has many of these, one for each range of values
            base.append(section)
        elif section.tag in SECTIONS:
            base.find(section.tag).extend(section)
        else:
            raise ValueError(f"a section {section.tag} cannot be merged")
    return base
