#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""generate.py GLAD_HEADER OUT REGISTRY ...: C++ functions that note each call of OpenGL and then make it.

GLAD_HEADER is the header of the loader. It says which commands there are, and how they are called in C. The registries
(gl.xml and others in its schema) say which group of values a parameter belongs to, and how long its array is.
"""
import re
import sys
import xml.etree.ElementTree as ElementTree
from collections import defaultdict
from pathlib import Path

# What only asks is not noted, except where the answer may go to a buffer.
ASKS = re.compile(r"Get(?!(Query(Buffer)?Object|TexImage|TextureImage|TextureSubImage|nTexImage|Compressed))|Is[A-Z]"
                  r"|CheckFramebufferStatus|CheckNamedFramebufferStatus")
NUMBERS = {"GLfloat", "GLdouble", "GLint", "GLuint", "GLshort", "GLushort", "GLbyte", "GLubyte", "GLsizei", "GLintptr",
           "GLsizeiptr", "GLint64", "GLuint64", "GLfixed", "GLenum", "GLboolean", "GLclampf", "GLclampd", "GLchar",
           "GLintptrARB", "GLsizeiptrARB"}
SUFFIX = re.compile(r"_(ARB|EXT|NV|OES|KHR|ATI|AMD|SGI|SGIS|SGIX|APPLE|IBM|INTEL|HP|MESA|SUN|3DFX|OML|PGI|IMG|QCOM|ANGLE)$")


def commands_of(header):
    """[(name, result, [(type, name)])] in the order of the loader."""
    types = {}
    for line in header.splitlines():
        found = re.match(r"typedef (.*?)\s*\(GLAD_API_PTR \*(PFN\w+)\)\((.*)\);", line)
        if found:
            parameters = [] if found[3] == "void" else [re.match(r"(.*?)\s*(\w+)$", each.strip()).groups()
                                                       for each in found[3].split(",")]
            types[found[2]] = (found[1], parameters)
    members = re.search(r"struct GladGLContext \{(.*?)\}", header, re.S)[1]
    return [(name, *types[type]) for type, name in re.findall(r"(PFN\w+) (\w+);", members)]


def described(registries):
    """{command: {parameter: (group, length)}}"""
    found = {}
    for registry in registries:
        for command in registry.iter("command"):
            proto = command.find("proto")
            if proto is not None:
                found[proto.findtext("name")] = {each.findtext("name"): (each.get("group", ""), each.get("len", ""))
                                                 for each in command.findall("param")}
    return found


def values_of(registries, header):
    """[(group, value, name)]: the values that the loader has, without a vendor's name where another fits."""
    best = {}
    for registry in registries:
        for enum in registry.iter("enum"):
            name, value = enum.get("name"), enum.get("value")
            if value is None or f"#define {name} " not in header:
                continue
            for group in set((enum.get("group") or "").split(",")) | {""}:
                key = (group, int(value, 0) & 0xffffffff)
                rank = (bool(SUFFIX.search(name)), len(name), name)
                best[key] = min(best.get(key, (rank, name)), (rank, name))
    return [(group, value, name) for (group, value), (_, name) in sorted(best.items())]


def length_in_c(length, names):
    """The length as an expression of parameters; none if the registry gives none that can be computed."""
    words = set(re.findall(r"[A-Za-z_]\w*", length))
    return length if length and "COMPSIZE" not in length and words <= names else None


def pixels(length, name):
    """The call that notes an image in memory; none if the parameter is no image."""
    found = re.fullmatch(r"COMPSIZE\((?:target,)?(format,type(?:,width|,height|,depth)*)\)", length)
    if not found or "width" not in found[1]:
        return None
    sizes = [each for each in ("width", "height", "depth") if each in found[1].split(",")]
    return f"call.pixels({name}, format, type, {{{', '.join(sizes)}}});"


def note_of(type, name, group, length, names):
    """The statement that notes a parameter."""
    count = length_in_c(length, names)
    target = re.sub(r"\bconst\b|\*|\s", "", type)
    if "*" not in type:
        if target in ("GLenum", "GLbitfield"):
            return f"call.{'flags' if target == 'GLbitfield' else 'value'}({name}, \"{group}\");"
        if target == "GLint" and (group == "InternalFormat" or name == "param"):
            return f"call.number_or_value({name}, \"{group}\");"
        if target == "GLboolean":
            return f"call.boolean({name});"
        if target == "GLsync":
            return "call.sync();"
        return f"call.number({name});" if target in NUMBERS or target == "GLbitfield" else "call.other();"
    if type.count("*") == 2:
        return f"call.texts({name}, {count});" if target == "GLchar" and count else f"call.pointers({name}, {count or 0});"
    if target == "void":
        image = pixels(length, name) if "const" in type else None
        return image or (f"call.bytes({name}, {count});" if count and "const" in type else f"call.pointer({name});" if "const" in type
                         else f"call.result_pointer({name});")
    if target == "GLchar" and "const" in type:
        return f"call.text({name});"
    if target not in NUMBERS:
        return "call.other();"
    if "const" in type:
        if length == "COMPSIZE(pname)":
            count = "values_of_parameter(pname)"
        return f"call.array(\"{target}\", {name}, {count or 1});"
    return f"call.result_array(\"{target}\", {name}, {count or 1});"


def function_of(name, result, parameters, description):
    """A function with the command's signature."""
    signature = ", ".join(f"{type} {parameter}" for type, parameter in parameters)
    arguments = ", ".join(parameter for _, parameter in parameters)
    names = {parameter for _, parameter in parameters}
    lines = [f"{result} GLAD_API_PTR noted_{name}({signature}) {{", f"  Call call(\"gl{name}\");"]
    lines += ["  " + note_of(type, parameter, *description.get(parameter, ("", "")), names) for type, parameter in parameters]
    if result == "void":
        lines += ["  call.begin();", f"  real.{name}({arguments});", "  call.end();"]
    else:
        lines += ["  call.begin();", f"  const auto result = real.{name}({arguments});", "  call.end(result);", "  return result;"]
    return "\n".join([*lines, "}"])


def main():
    header_path, out, *registry_paths = sys.argv[1:]
    header = Path(header_path).read_text()
    registries = [ElementTree.parse(path).getroot() for path in registry_paths]
    descriptions = described(registries)
    noted = [each for each in commands_of(header) if not ASKS.match(each[0])]
    texts = ["// Generated by show/generate.py.", "", "constexpr NamedValue named_values[] = {"]
    texts += [f"    {{\"{group}\", {value:#x}U, \"{name}\"}}," for group, value, name in values_of(registries, header)]
    texts += ["};", ""]
    texts += [function_of(name, result, parameters, descriptions.get("gl" + name, {})) + "\n"
              for name, result, parameters in noted]
    texts.append("void note_calls(GladGLContext& functions) {")
    texts += [f"  if (functions.{name} != nullptr) functions.{name} = noted_{name};" for name, _, _ in noted]
    texts.append("}")
    Path(out).write_text("\n".join(texts) + "\n")


if __name__ == "__main__":
    main()
