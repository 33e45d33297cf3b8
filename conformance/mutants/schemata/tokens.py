# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Splits C++ or GLSL that clang-format has formatted into tokens, and finds the bracket that closes each bracket.

The formatting tells operators apart: a binary `<`, `*` or `&` has a space on both sides, a template's `<` and a unary
operator do not. So no syntax tree is needed. A wrong guess gives a mutant that does not compile, and the build leaves it out.
"""
import dataclasses
import re

PATTERN = re.compile(r"""
  (?P<raw>(?:u8|[uUL])?R"(?P<mark>[^(\s]*)\((?s:.*?)\)(?P=mark)")
| (?P<comment>//[^\n]*|/\*(?s:.*?)\*/)
| (?P<text>(?:u8|[uUL])?"(?:[^"\\\n]|\\.)*")
| (?P<char>'(?:[^'\\\n]|\\.)+')
| (?P<number>\.?\d(?:[eEpP][+-]|[\w.]|'(?=\w))*)
| (?P<name>[A-Za-z_@]\w*)
| (?P<sign>\.\.\.|<=>|<<=|>>=|->\*|::|->|\+\+|--|<<|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|[^\s\w])
""", re.VERBOSE)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n\\]|\\.|\\\n)*", re.MULTILINE)
OPENS = {"(": ")", "[": "]", "{": "}"}


@dataclasses.dataclass
class Token:
    kind: str
    text: str
    begin: int
    end: int
    match: int = -1  # index of the other bracket
    is_binary: bool = False  # white space on both sides


class Tokens:
    """The tokens of a text, without comments and directives. Offsets are those of the text."""

    def __init__(self, text: str):
        self.text = text
        self.list = []
        at = 0
        blanked = DIRECTIVE.sub(lambda found: " " * len(found.group()), hide_raw(text))
        while found := PATTERN.search(blanked, at):
            at = found.end()
            kind = found.lastgroup if found.lastgroup != "mark" else "raw"
            if kind != "comment":
                self.list.append(Token(kind, text[found.start():at], found.start(), at))
        self.mark_binary()
        self.find_brackets()

    def __len__(self) -> int:
        return len(self.list)

    def __getitem__(self, index: int) -> Token:
        return self.list[index]

    def word(self, index: int) -> str:
        return self.list[index].text if 0 <= index < len(self.list) else ""

    def source(self, first: int, last: int) -> str:
        """The text of the tokens from `first` up to, but without, `last`."""
        return self.text[self.list[first].begin:self.list[last - 1].end]

    def mark_binary(self) -> None:
        for token in self.list:
            around = self.text[max(token.begin - 1, 0)] + self.text[min(token.end, len(self.text) - 1)]
            token.is_binary = token.kind == "sign" and around.isspace()
        shifts = [i for i in range(len(self) - 1) if self.word(i) == self.word(i + 1) == ">"
                  and self[i].end == self[i + 1].begin and self.text[self[i].begin - 1].isspace()]
        for i in reversed(shifts):
            self.list[i:i + 2] = [Token("sign", ">>", self[i].begin, self[i + 1].end, is_binary=True)]

    def find_brackets(self) -> None:
        stack = []
        for index, token in enumerate(self.list):
            if token.text in OPENS and token.kind == "sign":
                stack.append(index)
            elif token.text == "<" and not token.is_binary and self.follows_name(index):
                stack.append(index)
            elif token.text == ">" and not token.is_binary and stack and self.word(stack[-1]) == "<":
                self.pair(stack.pop(), index)
            elif token.text in (")", "]", "}"):
                while stack and OPENS.get(self.word(stack[-1])) != token.text:
                    stack.pop()  # a `<` that was no bracket
                if stack:
                    self.pair(stack.pop(), index)

    def follows_name(self, index: int) -> bool:
        before = self.list[index - 1] if index else None
        return before is not None and before.kind == "name" and before.end == self.list[index].begin

    def pair(self, first: int, last: int) -> None:
        self.list[first].match = last
        self.list[last].match = first

    def opens(self, index: int) -> bool:
        return self.list[index].match > index

    def parts(self, first: int, last: int, separator: str = ",") -> list:
        """The parts of a range between separators that are in no bracket: [(first, last), ...]."""
        parts = []
        begin = at = first
        while at < last:
            if self.opens(at):
                at = min(self.list[at].match, last - 1)
            elif self.word(at) == separator:
                parts.append((begin, at))
                begin = at + 1
            at += 1
        if begin < last:
            parts.append((begin, last))
        return parts


def hide_raw(text: str) -> str:
    """Hides # at the beginnings of lines in raw strings, which are not directives of C++."""
    return re.sub(r'R"([^(\s]*)\((?s:.*?)\)\1"', lambda found: found.group().replace("#", "."), text)
