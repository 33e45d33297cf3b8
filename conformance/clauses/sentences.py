# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Splits the text of the extension into sections and sentences.

Each row of a table and each item of a list is a sentence. A paragraph that ends in a formula continues until a full stop.
"""
import re

# Headings that open a section, and the names with which its sentences' ids begin.
HEADINGS = {
    "Name Strings": "name",
    "Dependencies": "dependencies",
    "Overview": "overview",
    "New Procedures and Functions": "functions",
    "New Tokens": "tokens",
    "Interactions with the Core Profile of OpenGL": "core",
    "Interactions with OpenGL ES 3.2": "es",
    "Interactions with Tessellation Shaders": "tessellation",
    "Interactions with ARB_vertex_program": "programs",
    "GLX Protocol": "glx",
    "Errors": "errors",
    "New State": "state",
    "New Implementation Dependent State": "limits",
    "Usage Examples": "usage",
    "Issues": "issues",
}
CHAPTER = re.compile(r"Additions to Chapters? (?:\d+ to )?(\d+)")
NUMBERED = re.compile(r"\s{4}(\d+\.R\.\d+[a-z]?)  ([A-Z].*)$")
RULE = re.compile(r"\s*-{5,}")
STOP = re.compile(r"(?<=[^\s.\d][.])\s+(?=[A-Z<(])|(?<=[a-z\]]\d[.]|[.]\d[.]|\s\d[.])\s+(?=[A-Z])")
ABBREVIATIONS = ("e.g.", "i.e.", "al.", " T.")


def sections(text: str):
    """Yields (id, heading, lines) of every section whose sentences count, in order."""
    current = None
    in_heading = False
    for line in text.splitlines():
        stripped = line.strip()
        numbered = NUMBERED.match(line)
        if line and not line[0].isspace():
            if in_heading:  # its second line
                continue
            if current:
                yield current
            addition = CHAPTER.match(line)
            section = f"chapter-{addition.group(1)}" if addition else HEADINGS.get(stripped)
            current = (section, stripped, []) if section else None
            in_heading = True
            continue
        in_heading = False
        if not line:
            if current:
                current[2].append(line)
        elif numbered:
            if current:
                yield current
            current = (numbered.group(1), numbered.group(2), [])
        elif current:
            current[2].append(line)
    if current:
        yield current


def blocks(lines: list):
    """Yields paragraphs as lists of lines."""
    block = []
    for line in lines + [""]:
        if line.strip():
            block.append(line)
        elif block:
            yield block
            block = []


def rows(block: list):
    """A table's rows. A line that begins further to the right than the first continues the row before."""
    body = block[next(i for i, line in enumerate(block) if RULE.match(line)) + 1:]
    margin = min(len(line) - len(line.lstrip()) for line in body)
    found = []
    for line in body:
        if len(line) - len(line.lstrip()) > margin and found:
            found[-1] += " " + " ".join(line.split())
        else:
            found.append(" ".join(line.split()))
    return found


def split(text: str) -> list:
    parts = []
    for part in STOP.split(text):
        if parts and parts[-1].endswith(ABBREVIATIONS):
            parts[-1] += " " + part
        else:
            parts.append(part)
    return parts


def sentences(section: str, lines: list) -> list:
    """The sentences of one section, in order."""
    found = []
    open_text = ""
    for block in blocks(lines):
        if any(RULE.match(line) for line in block):
            if open_text:
                found.append(open_text)
                open_text = ""
            found += rows(block)
            continue
        if section == "tokens" and any("0x" in line for line in block):
            found += [" ".join(line.split()) for line in block]
            continue
        text = " ".join(" ".join(block).split())
        item = text.startswith("* ")
        if open_text and not item:
            text = open_text + " " + text
            open_text = ""
        elif open_text:
            found.append(open_text)
            open_text = ""
        if text.endswith((".", ":", ";", "; or", ".)")) or section in ("name", "functions", "tokens"):
            found += split(text)
        else:
            open_text = text
    if open_text:
        found.append(open_text)
    return [sentence for sentence in found if not sentence.startswith("Table 11.R:")]


def specification(text: str) -> list:
    """[(section id, heading, [sentence, ...]), ...]"""
    return [(name, heading, sentences(name, lines)) for name, heading, lines in sections(text)]
