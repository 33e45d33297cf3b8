#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Fails unless glark.h, glark.xml and the specification agree, and glark.xml merges with Khronos' gl.xml without a clash."""
import argparse
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

EXTENSION = "GL_ARK_adaptive_refinement"
HEADER = "include/GL/glark.h"
REGISTRY = "glark/gl/glark.xml"
SPECIFICATION = f"docs/spec/{EXTENSION}.txt"


def normal(declaration):
    """Normalises the spaces of a C declaration."""
    declaration = re.sub(r"\s+", " ", declaration)
    return re.sub(r" ?([*(),]) ?", r"\1", declaration).strip()


def header_api(text):
    """Reads glark.h: tokens {name: value}, prototypes and function pointer types {name: declaration}."""
    tokens = {name: int(value, 16) for name, value in re.findall(r"^#define (GL_\w+)\s+(0x[0-9A-F]{4})\b", text, re.M)}
    prototypes = {
        name: normal(f"{result} {name}({parameters})")
        for result, name, parameters in re.findall(r"^GLARK_API (\w+) GLARK_APIENTRY (gl\w+)\(([^;]*)\);", text, re.M)
    }
    pointers = {
        name: normal(parameters)
        for name, parameters in re.findall(r"^typedef void \(GLARK_APIENTRY \*(PFN\w+PROC)\)\(([^;]*)\);", text, re.M)
    }
    return tokens, prototypes, pointers


def registry_api(root):
    """Reads the same from a registry fragment, and the requirements of its extension."""
    tokens = {enum.get("name"): int(enum.get("value"), 16) for enum in root.iterfind("enums/enum")}
    prototypes = {}
    for command in root.iterfind("commands/command"):
        name = command.find("proto/name").text
        parameters = ", ".join("".join(parameter.itertext()) for parameter in command.iterfind("param"))
        prototypes[name] = normal(f"{''.join(command.find('proto').itertext())}({parameters})")
    extension = root.find(f"extensions/extension[@name='{EXTENSION}']")
    required = {item.get("name") for item in extension.iterfind("require/*")}
    return tokens, prototypes, extension.get("supported"), required


def section(text, title):
    """Returns the body of a top-level section of the specification. Its title stands at the left margin."""
    found = re.search(rf"^{re.escape(title)}\n(.*?)(?=^\S|\Z)", text, re.M | re.S)
    return found.group(1) if found else ""


def specification_api(text):
    tokens = {f"GL_{name}": int(value, 16) for name, value in re.findall(r"^ +(\w+)\s+(0x[0-9A-F]{4})\b", section(text, "New Tokens"), re.M)}
    prototypes = {}
    for result, name, parameters in re.findall(r"^ +(\w+) (\w+)\(([^;]*)\);", section(text, "New Procedures and Functions"), re.M):
        types = re.sub(r"\b(u?int|sizei|enum|char|float)\b", r"GL\1", parameters)
        prototypes[f"gl{name}"] = normal(f"{result} gl{name}({types})")
    return tokens, prototypes


def differences(what, one, one_name, other, other_name):
    for name in sorted(one.keys() | other.keys()):
        if one.get(name) != other.get(name):
            yield f"{what} {name}: {one.get(name)!r} in {one_name}, {other.get(name)!r} in {other_name}"


def disagreements(header_text, registry_root, specification_text):
    tokens, prototypes, supported, required = registry_api(registry_root)
    header_tokens, header_prototypes, pointers = header_api(header_text)
    specification_tokens, specification_prototypes = specification_api(specification_text)
    yield from differences("token", tokens, REGISTRY, header_tokens, HEADER)
    yield from differences("token", tokens, REGISTRY, specification_tokens, SPECIFICATION)
    yield from differences("prototype", prototypes, REGISTRY, header_prototypes, HEADER)
    yield from differences("prototype", prototypes, REGISTRY, specification_prototypes, SPECIFICATION)
    expected = {f"PFN{name.upper()}PROC": text[text.index("(") + 1:-1] for name, text in prototypes.items()}
    yield from differences("function type", expected, REGISTRY, pointers, HEADER)
    if required != tokens.keys() | prototypes.keys():
        yield f"{REGISTRY}: required but not defined, or the reverse: {sorted(required ^ (tokens.keys() | prototypes.keys()))}"
    if supported != "gl|glcore|gles2":
        yield f"{REGISTRY}: supported is {supported!r}"
    for name in re.findall(r"\b\w+_ARK\b|\bgl\w*(?:ARK|ARP)\w*\b", specification_text):
        known = name in prototypes or f"GL_{name.removeprefix('GL_')}" in tokens
        if not known:
            yield f"{SPECIFICATION}: {name} is neither a token nor a function"


def bounds(element):
    start, end = element.get("start"), element.get("end")
    return (int(start, 0), int(end or start, 0)) if start else (0, -1)


def overlaps(element, first, last):
    start, end = bounds(element)
    return start <= last and first <= end


def covers(element, first, last):
    start, end = bounds(element)
    return start <= first and last <= end


def clashes(registry_root, khronos_root):
    """Returns the names and values that a merged registry would hold twice."""
    tokens, prototypes, _, _ = registry_api(registry_root)
    block = registry_root.find("enums")
    first, last = int(block.get("start"), 16), int(block.get("end"), 16)
    if len(set(tokens.values())) != len(tokens):
        yield f"{REGISTRY}: a value is given twice"
    for name, value in tokens.items():
        if not first <= value <= last:
            yield f"{REGISTRY}: {name} lies outside the block {block.get('start')}-{block.get('end')}"
        for unused in block.iterfind("unused"):
            if overlaps(unused, value, value):
                yield f"{REGISTRY}: {name} has a value that is listed as unused"
    for enums in khronos_root.iterfind("enums"):
        for enum in enums.iterfind("enum"):
            value = int(enum.get("value"), 0)
            if enum.get("name") in tokens:
                yield f"gl.xml already has {enum.get('name')}"
            if enums.get("type") != "bitmask" and first <= value <= last:
                yield f"gl.xml gives {enum.get('name')} the value {value:#x}, which lies in our block"
        if overlaps(enums, first, last) and not any(covers(unused, first, last) for unused in enums.iterfind("unused")):
            yield f"gl.xml reserves {enums.get('start')}-{enums.get('end')}, which overlaps our block"
    for name in khronos_root.iterfind("commands/command/proto/name"):
        if name.text in prototypes:
            yield f"gl.xml already has {name.text}"
    if khronos_root.find(f"extensions/extension[@name='{EXTENSION}']") is not None:
        yield f"gl.xml already has {EXTENSION}"
    groups = {group for enum in registry_root.iterfind("enums/enum") for group in enum.get("group").split(",")}
    known = {group for enum in khronos_root.iterfind("enums/enum") for group in (enum.get("group") or "").split(",")}
    known |= {enums.get("group") for enums in khronos_root.iterfind("enums")}
    used = {p.get("group") for p in registry_root.iterfind("commands/command/param") if p.get("group")}
    for group in sorted(used - groups - known):
        yield f"{REGISTRY}: group {group} has no member"
    types = {"".join(kind.itertext()).split()[-1].rstrip(";") for kind in khronos_root.iterfind("types/type")}
    for kind in {kind.text for kind in registry_root.iterfind("commands/command//ptype")} - types:
        yield f"{REGISTRY}: type {kind} is not in gl.xml"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--root", type=pathlib.Path, required=True, help="root of the repository")
    parser.add_argument("--khronos", type=pathlib.Path, default="/usr/share/khronos-api/gl.xml", help="gl.xml of Debian's khronos-api")
    arguments = parser.parse_args()
    registry_root = ElementTree.parse(arguments.root / REGISTRY).getroot()
    problems = list(disagreements(
        (arguments.root / HEADER).read_text(encoding="utf-8"), registry_root,
        (arguments.root / SPECIFICATION).read_text(encoding="utf-8")))
    problems += clashes(registry_root, ElementTree.parse(arguments.khronos).getroot())
    for problem in problems:
        print(problem, file=sys.stderr)
    tokens, prototypes, _, _ = registry_api(registry_root)
    print(f"{len(tokens)} tokens, {len(prototypes)} functions, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
