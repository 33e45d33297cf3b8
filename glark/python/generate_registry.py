# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""usage: generate_registry.py GLARK.XML FOLDER: writes the tokens and signatures of the registry file as Python.

FOLDER/_registry.py has a constant for each token, and COMMANDS: the GL types of each command's parameters. FOLDER/gl.pyi has the
tokens for type checkers, before the functions of gl_functions.pyi beside this program."""
import pathlib
import sys
import xml.etree.ElementTree as xml

HEAD = """# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
# Generated from glark.xml.
"""


def type_of(parameter: xml.Element) -> str:
    text = "".join(parameter.itertext())
    return "pointer" if "*" in text else parameter.find("ptype").text


def main() -> None:
    registry, folder = xml.parse(sys.argv[1]).getroot(), pathlib.Path(sys.argv[2])
    tokens = {token.get("name"): token.get("value") for token in registry.findall("enums/enum")}
    commands = {command.find("proto/name").text: tuple(map(type_of, command.findall("param")))
                for command in registry.findall("commands/command")}
    values = "".join(f"{name} = {value}\n" for name, value in tokens.items())
    signatures = "".join(f"    {name!r}: {types!r},\n" for name, types in commands.items())
    (folder / "_registry.py").write_text(f"{HEAD}{values}\nCOMMANDS = {{\n{signatures}}}\n")
    functions = (pathlib.Path(__file__).parent / "gl_functions.pyi").read_text()
    (folder / "gl.pyi").write_text(functions + "\n" + "".join(f"{name}: int\n" for name in tokens))


if __name__ == "__main__":
    main()
