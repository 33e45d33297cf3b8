# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Writes all mutants of a file into its text. Each is a choice at run time: `(glark_mutants::on(17) ? mutant : original)`.

Only one mutant is ever chosen, so the text of a mutant needs no choices inside. That keeps the text short: each original
is repeated only as often as mutants lie around it.
"""
import dataclasses

from .operators import Edit, Mutant

CONDITIONS = {"compare", "logic", "forget", "not", "negate"}
# In GLSL, a choice is marked by these characters. The library makes it when it hands the text to GL: runtime.h.in.
BEGIN, NEW, OLD, END = "\x01", "\x02", "\x03", "\x04"


@dataclasses.dataclass
class Place:
    """A range of the text with its alternatives."""
    begin: int
    end: int
    choices: list  # [(mutant, edit)]
    inner: list = dataclasses.field(default_factory=list)


class Writer:
    """Collects text, and notes which mutants each line belongs to."""

    def __init__(self):
        self.parts = []
        self.line = 1
        self.owners = {}  # {line: mutants whose own text is on it}

    def put(self, text: str, owner: Mutant | None = None) -> None:
        if owner is not None:
            for line in range(self.line, self.line + text.count("\n") + (0 if text.endswith("\n") else 1)):
                self.owners.setdefault(line, []).append(owner)
        self.parts.append(text)
        self.line += text.count("\n")

    def text(self) -> str:
        return "".join(self.parts)


def places_of(mutants: list) -> list:
    """The outermost places, each with those inside it."""
    by_range = {}
    for mutant in mutants:
        for edit in mutant.edits:
            place = by_range.setdefault((edit.begin, edit.end, edit.form in ("before", "statement")), Place(edit.begin, edit.end, []))
            place.choices.append((mutant, edit))
    outermost, stack = [], []
    for key in sorted(by_range, key=lambda key: (key[0], -key[1] if key[0] != key[1] else -float("inf"), not key[2])):
        place = by_range[key]
        while stack and not (stack[-1].begin <= place.begin and place.end <= stack[-1].end and stack[-1].end > stack[-1].begin):
            stack.pop()
        (stack[-1].inner if stack else outermost).append(place)
        stack.append(place)
    return outermost


def write_range(writer: Writer, text: str, begin: int, end: int, places: list) -> None:
    for place in places:
        writer.put(text[begin:place.begin])
        write_place(writer, text, place)
        begin = place.end
    writer.put(text[begin:end])


def write_place(writer: Writer, text: str, place: Place) -> None:
    first = place.choices[0]
    if first[0].is_glsl:
        for mutant, edit in place.choices:
            writer.put(f"{BEGIN}{mutant.number}{NEW}{edit.new}{OLD}")
        write_range(writer, text, place.begin, place.end, place.inner)
        writer.put(END * len(place.choices))
    elif first[1].form == "equality":
        write_equality(writer, place.choices)
    elif first[1].form == "before":
        for mutant, edit in place.choices:
            writer.put(f"\nif ({chosen(mutant)}) {edit.new}\n", mutant)
    elif first[1].form == "statement":
        for mutant, _ in place.choices:
            writer.put(f"\nif ({chosen(mutant)}) {{}} else\n", mutant)
        write_range(writer, text, place.begin, place.end, place.inner)
    else:
        cast = "static_cast<bool>" if first[0].operator in CONDITIONS else ""  # both sides of ?: need the same type
        for mutant, edit in place.choices:
            writer.put(f"\n({chosen(mutant)} ?\n{cast}({edit.new})\n: {cast}\n(", mutant)
        write_range(writer, text, place.begin, place.end, place.inner)
        writer.put("\n" + "))" * len(place.choices))


def write_equality(writer: Writer, choices: list) -> None:
    """The parameter has no type of its own: the name of the struct may be hidden, but its comparison is always with itself."""
    record = choices[0][0].function
    writer.put(f"bool operator==(const {record}& glark_other) const {{ return true")
    for mutant, edit in choices:
        writer.put(f"\n&& ({chosen(mutant)} || {edit.new} == glark_other.{edit.new})\n", mutant)
    writer.put("; }")


def chosen(mutant: Mutant) -> str:
    return f"glark_mutants::on({mutant.number})"


def instrumented(text: str, mutants: list) -> tuple:
    """Returns the text with the mutants, and {line: the mutants whose own text is on it}."""
    writer = Writer()
    write_range(writer, text, 0, len(text), places_of(mutants))
    return writer.text(), writer.owners


def edited(text: str, edit: Edit) -> str:
    return text[:edit.begin] + edit.new + text[edit.end:]


def alone(text: str, mutant: Mutant) -> str:
    """The text with only this mutant, as a person would write it."""
    for edit in sorted(mutant.edits, key=lambda edit: -edit.begin):
        text = edited(text, edit)
    return text
