# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Finds the functions of a file and the statements in them, from the tokens."""
import dataclasses

from .tokens import Tokens

LEADING = {"if", "while", "for", "switch", "else", "do", "return", "case", "default", "break", "continue", "throw", "try", "catch", "goto",
           "using", "typedef", "static_assert", "static", "constexpr", "const", "auto", "struct", "class", "enum", "precise", "in", "out",
           "uniform", "layout", "buffer", "shared", "flat", "extern", "constinit", "thread_local", "discard", "delete", "public", "private"}


@dataclasses.dataclass
class Function:
    name: str
    returns: str  # the type of what it returns, as far as it is written before the name
    body: int  # index of its {
    end: int  # index of its }


@dataclasses.dataclass
class Statement:
    kind: str  # expression, declaration, condition, return, case, other
    first: int
    last: int  # the index behind its last token: the ; is part of it
    inner: tuple = ()  # the range of the expression in it


@dataclasses.dataclass
class Record:
    """A struct whose operator== is defaulted."""
    name: str
    members: list
    first: int  # the tokens of the declaration of operator==
    last: int


class Finder:
    """Walks over the parts of a file that are not in a function."""

    def __init__(self, tokens: Tokens):
        self.tokens = tokens
        self.functions = []
        self.records = []

    def walk(self, first: int, last: int, record: str = "") -> None:
        head = first
        at = first
        members = []
        compared = None
        while at < last:
            word = self.tokens.word(at)
            if word == ";":
                if record and (member := self.member(head, at)):
                    members.append(member)
                if record and "operator" in self.words(head, at) and self.words(head, at)[-1] == "default":
                    compared = (head, at + 1)
                head = at + 1
            elif word == "}" or (word == ":" and self.tokens.word(at - 1) in ("public", "private", "protected")):
                head = at + 1
            elif word == "{":
                close = self.tokens[at].match
                if self.enter(head, at, close):
                    head = close + 1
                at = max(close, at)
            elif self.tokens.opens(at):
                at = self.tokens[at].match
            at += 1
        if compared and "==" in self.words(*compared):
            self.records.append(Record(record, members, *compared))

    def words(self, first: int, last: int) -> list:
        return [self.tokens.word(i) for i in range(first, last)]

    def enter(self, head: int, brace: int, close: int) -> bool:
        """Looks at what begins with this brace. Returns whether the declaration ends with it."""
        top = [self.tokens.word(i) for i in self.top(head, brace)]
        if "namespace" in top or ("extern" in top and "(" not in top):
            self.walk(brace + 1, close)
            return True
        if "enum" in top or "=" in top:
            return False
        if "(" in top:
            if self.is_initializer(head, brace, top):
                return False
            name = self.name_of(head, brace)
            returns = " ".join(self.words(head, name[0])) if name else ""
            self.functions.append(Function(name[1] if name else "?", returns, brace, close))
            return True
        if {"struct", "class", "union"} & set(top):
            names = [word for word in top if word[0].isalpha() and word not in ("struct", "class", "final", "alignas")]
            self.walk(brace + 1, close, names[0] if names else "?")
        return False

    def top(self, first: int, last: int) -> list:
        """The indices of the tokens that are in no bracket, with the brackets."""
        indices = []
        at = first
        while at < last:
            indices.append(at)
            at = self.tokens[at].match + 1 if self.tokens.opens(at) else at + 1
        return indices

    def is_initializer(self, head: int, brace: int, top: list) -> bool:
        """Whether the brace belongs to a member in the list behind a constructor's colon."""
        return ":" in top and self.tokens[brace - 1].kind == "name" and self.tokens[brace - 1].end == self.tokens[brace].begin

    def name_of(self, head: int, brace: int):
        for index in self.top(head, brace):
            if self.tokens.word(index) == "(" and index > head:
                if self.tokens.word(index - 1) == "operator":
                    return index - 1, "operator()"
                first = index - 1
                while first > head and (self.tokens.word(first - 1) in ("operator", "~", "::") or self.tokens.word(first) == "::"):
                    first -= 1
                return first, self.tokens.source(first, index)
        return None

    def member(self, head: int, end: int) -> str:
        top = [self.tokens.word(i) for i in self.top(head, end)]
        if not top or {"(", "using", "static", "friend", "operator", "struct", "enum", "class"} & set(top):
            return ""
        for index in self.top(head, end):
            if self.tokens.word(index) in ("=", "{"):
                end = index
                break
        name = self.tokens[end - 1]
        return name.text if name.kind == "name" and "," not in top else "?"


def functions_of(tokens: Tokens) -> tuple:
    finder = Finder(tokens)
    finder.walk(0, len(tokens))
    return finder.functions, finder.records


def is_declaration(tokens: Tokens, first: int, last: int) -> bool:
    """Whether a statement such as `Type<x> name = ...` begins here."""
    at = first
    while at < last and tokens[at].kind == "name":
        at += 1
        if tokens.word(at) == "<" and tokens.opens(at):
            at = tokens[at].match + 1
        if tokens.word(at) != "::":
            break
        at += 1
    while tokens.word(at) in ("*", "&", "&&"):
        at += 1
    return at > first and at < last and (tokens[at].kind == "name" or (tokens.word(at) == "[" and tokens.word(at - 1) in ("&", "auto")))


class Statements:
    """The statements of a range of tokens, with those of inner blocks and of lambdas."""

    def __init__(self, tokens: Tokens, first: int, last: int):
        self.tokens = tokens
        self.list = []
        self.block(first, last)

    def block(self, first: int, last: int) -> None:
        while first < last:
            first = self.statement(first, last)

    def statement(self, at: int, last: int) -> int:
        tokens = self.tokens
        word = tokens.word(at)
        if word in ("{", ";", "}"):
            if word == "{" and tokens.opens(at):
                self.block(at + 1, tokens[at].match)
                return tokens[at].match + 1
            return at + 1
        if word in ("else", "do", "try"):
            return at + 1
        if word in ("if", "while", "for", "switch", "catch"):
            return self.condition(at)
        if word in ("case", "default") and tokens.word(at + 1) != "(":
            return self.label(at, last)
        end = self.end_of(at, last)
        kind = "expression"
        if word in LEADING or is_declaration(tokens, at, end):
            kind = word if word in ("return", "static_assert", "using", "constexpr") else "declaration"
            kind = "skipped" if kind in ("static_assert", "using") or "constexpr" in [tokens.word(at), tokens.word(at + 1)] else kind
            kind = "other" if word in ("break", "continue", "goto", "discard", "throw", "delete") else kind
        self.list.append(Statement(kind, at, end, (at + 1 if word == "return" else at, end - 1)))
        self.lambdas(at, end)
        return end

    def condition(self, at: int) -> int:
        tokens = self.tokens
        word = tokens.word(at)
        bracket = at + 1
        if tokens.word(bracket) == "constexpr":
            return tokens[bracket + 1].match + 1
        close = tokens[bracket].match
        if close < 0:
            return at + 1
        self.list.append(Statement(word, at, close + 1, (bracket + 1, close)))
        self.lambdas(bracket + 1, close)
        return close + 1

    def label(self, at: int, last: int) -> int:
        end = at
        while end < last and self.tokens.word(end) != ":":
            end += 1
        self.list.append(Statement("case", at, end + 1))
        return end + 1

    def end_of(self, at: int, last: int) -> int:
        while at < last and self.tokens.word(at) != ";":
            at = self.tokens[at].match + 1 if self.tokens.opens(at) else at + 1
        return min(at + 1, last)

    def lambdas(self, first: int, last: int) -> None:
        for at in range(first, last):
            if self.tokens.word(at) == "{" and self.tokens.opens(at) and is_lambda(self.tokens, at):
                self.block(at + 1, self.tokens[at].match)


def is_lambda(tokens: Tokens, brace: int) -> bool:
    """Whether the brace in an expression opens the body of a lambda."""
    at = brace - 1
    for back in range(brace - 1, max(brace - 8, 0), -1):
        if tokens.word(back) == "->":
            at = back - 1
            break
    while tokens.word(at) in ("mutable", "noexcept"):
        at -= 1
    if tokens.word(at) == ")":
        at = tokens[at].match - 1
    return tokens.word(at) == "]" and not (tokens[tokens[at].match].end == tokens[at].begin and tokens.word(tokens[at].match - 1) == "auto") \
        and tokens[tokens[at].match - 1].kind != "name"
