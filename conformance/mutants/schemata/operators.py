# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The rules that make mutants: each finds places in a function, and what to write there instead."""
import dataclasses

from .functions import Function, Record, Statement, Statements, functions_of, is_lambda
from .tokens import Tokens

PRECEDENCE = {"||": 1, "&&": 2, "|": 3, "^": 4, "&": 5, "==": 6, "!=": 6, "<": 7, ">": 7, "<=": 7, ">=": 7, "<=>": 7,
              "<<": 8, ">>": 8, "+": 9, "-": 9, "*": 10, "/": 10, "%": 10}
ASSIGNS = {"=", "+=", "-=", "*=", "/=", "%=", "|=", "&=", "^=", "<<=", ">>="}
ENDS = ASSIGNS | {",", ";", "?", ":", "return", "case", "throw", "else"}
COMPARISONS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
ARITHMETIC = {"+": "-", "-": "+", "*": "/"}
OPERATORS = {
    "drop": "a statement is left out",
    "swap": "two neighbouring arguments of the same type are swapped",
    "compare": "a comparison is narrowed, widened or flipped",
    "number": "a number is off by one; 0 and 1 are exchanged",
    "constant": "true and false are exchanged",
    "arithmetic": "+ and - are exchanged, * becomes /",
    "logic": "&& and || are exchanged",
    "forget": "one operand of && or || is forgotten",
    "not": "a ! is left out",
    "negate": "a condition is negated",
    "member": "a member of a struct is not copied",
    "equality": "a member of a struct is not compared",
    "case": "a case of a switch does nothing",
    "return": "the function returns at once",
}


@dataclasses.dataclass
class Edit:
    begin: int
    end: int
    new: str
    form: str = "expression"  # expression, statement, before, equality


@dataclasses.dataclass
class Mutant:
    file: str
    function: str
    operator: str
    line: int
    old: str
    new: str
    edits: list
    is_glsl: bool = False
    number: int = 0  # its place among all mutants

    def key(self) -> tuple:
        return self.file, self.function, self.operator, self.old, self.new

    def folder(self) -> str:
        return "/".join(self.file.split("/")[:3]) if self.file.startswith("glark/") else "/".join(self.file.split("/")[:2])

    def text(self) -> str:
        return f"{self.file}:{self.line} {self.function}: {self.operator}: {flat(self.old)} -> {flat(self.new) or '(nothing)'}"


def flat(text: str, most: int = 110) -> str:
    text = " ".join(text.split())
    return text if len(text) <= most else text[:most - 3] + "..."


class Operators:
    """Makes the mutants of one text. `offset` and `line` are where the text begins in its file."""

    def __init__(self, file: str, tokens: Tokens, is_glsl: bool = False, offset: int = 0, line: int = 1):
        self.file = file
        self.tokens = tokens
        self.is_glsl = is_glsl
        self.offset = offset
        self.line = line
        self.function = ""
        self.mutants = []

    def add(self, operator: str, first: int, last: int, new: str, edits: list | None = None, form: str = "expression") -> None:
        begin, end = self.tokens[first].begin, self.tokens[last - 1].end
        edits = edits or [Edit(begin, end, new, form)]
        for edit in edits:
            edit.begin += self.offset
            edit.end += self.offset
        old = self.tokens.text[begin:end]
        line = self.line + self.tokens.text.count("\n", 0, begin)
        self.mutants.append(Mutant(self.file, self.function, operator, line, old, new, edits, self.is_glsl))

    def whole(self) -> list:
        functions, records = functions_of(self.tokens)
        for function in functions:
            self.function_body(function)
        for record in records:
            self.equality(record)
        return self.mutants

    def function_body(self, function: Function) -> None:
        self.function = function.name
        if "constexpr" not in function.returns.split() or self.is_glsl:
            self.early_return(function)
        self.range(function.body + 1, function.end)

    def range(self, first: int, last: int) -> None:
        statements = Statements(self.tokens, first, last).list
        for statement in statements:
            self.statement(statement)

    def early_return(self, function: Function) -> None:
        first, last = function.body + 1, function.end
        if last - first < 2 or self.is_glsl:
            return
        words = function.returns.replace("static", "").replace("inline", "").replace("[[nodiscard]]", "").split()
        values = {"void": [""], "bool": ["true", "false"], "": []}.get(" ".join(words), ["{}"])
        if not words and function.name.split("::")[-1].startswith("~"):
            values = [""]
        for value in values if "&" not in words else ():
            text = f"return {value};" if value else "return;"
            if self.tokens.source(first, last) != text:
                edit = Edit(self.tokens[first].begin, self.tokens[first].begin, text, "before")
                self.mutants.append(Mutant(self.file, self.function, "return", self.line_of(first), "{", "{ " + text,
                                           [dataclasses.replace(edit, begin=edit.begin + self.offset, end=edit.end + self.offset)]))

    def line_of(self, index: int) -> int:
        return self.line + self.tokens.text.count("\n", 0, self.tokens[index].begin)

    def statement(self, statement: Statement) -> None:
        first, last = statement.first, statement.last
        if statement.kind == "case":
            self.case(last)
            return
        if statement.kind == "skipped":
            return
        if statement.kind == "expression" and last - first > 1 and self.tokens.word(last - 1) == ";":
            self.add("drop", first, last, "", form="statement")
        if not statement.inner or statement.inner[1] <= statement.inner[0]:
            return
        parts = self.tokens.parts(*statement.inner, separator=";")
        if statement.kind in ("if", "switch") and parts:
            if statement.kind == "if":
                self.negate(*parts[-1])
        if statement.kind == "for":
            parts = parts[:2]  # without its step, a loop hangs
        for part in parts:
            self.expression(*part, is_declaration=statement.kind == "declaration")

    def case(self, behind: int) -> None:
        word = self.tokens.word(behind)
        if self.is_glsl or word in ("case", "default", "break", "}", ""):
            return
        self.add("case", behind, behind + 1, f"break; {word}", [Edit(self.tokens[behind].begin, self.tokens[behind].begin, "break;", "before")])
        mutant = self.mutants[-1]
        mutant.old = mutant.old and self.tokens.source(behind, self.statement_end(behind))
        mutant.new = "break;"

    def statement_end(self, at: int) -> int:
        while at < len(self.tokens) and self.tokens.word(at) not in (";", "}"):
            at = self.tokens[at].match + 1 if self.tokens.opens(at) else at + 1
        return min(at + 1, len(self.tokens))

    def level(self, first: int, last: int) -> list:
        """The indices of tokens in no bracket, and of brackets."""
        indices = []
        at = first
        while at < last:
            indices.append(at)
            at = self.tokens[at].match if self.tokens.opens(at) and self.tokens[at].match < last else at
            at += 1
        return indices

    def expression(self, first: int, last: int, is_declaration: bool = False) -> None:
        tokens = self.tokens
        for at in self.level(first, last):
            token = tokens[at]
            if tokens.opens(at) and token.match < last:
                self.bracket(at, token.match, is_declaration)
            elif token.is_binary and token.text in PRECEDENCE:
                self.binary(first, at, last)
            elif token.text == "!" and not token.is_binary:
                end = self.operand_end(at + 1, last)
                self.add("not", at, end, tokens.source(at + 1, end))
            elif token.text == "?":
                begin = self.operand_begin(first, at, 0)
                if begin < at:
                    self.negate(begin, at)
            elif token.kind == "number":
                self.number(at)
            elif token.text in ("true", "false"):
                self.add("constant", at, at + 1, "false" if token.text == "true" else "true")

    def bracket(self, first: int, last: int, is_declaration: bool) -> None:
        tokens = self.tokens
        word = tokens.word(first)
        if word == "<" or (word == "{" and is_lambda(tokens, first)):
            return
        before = tokens[first - 1] if first else None
        if word == "[" and (before is None or before.kind not in ("name",) and before.text not in (")", "]")):
            return  # the captures of a lambda
        if word == "[" and is_declaration and tokens.word(last + 1) in ("=", ";", "{"):
            return  # the size of an array
        if word == "(" and before is not None and before.text == "]" and tokens.word(last + 1) in ("{", "mutable", "-"):
            return  # the parameters of a lambda
        parts = tokens.parts(first + 1, last)
        for part in parts:
            if word == "{" and tokens.word(part[0]) == "." and tokens.word(part[0] + 2) == "=":
                self.member(part[0] + 3, part[1])
                self.expression(part[0] + 3, part[1])
            else:
                self.expression(*part)
        if word == "(" and before is not None and (before.kind == "name" or before.text in (">", ")")) and not self.is_glsl:
            for left, right in zip(parts, parts[1:]):
                self.swap(left, right)

    def operand_begin(self, first: int, operator: int, precedence: int) -> int:
        at = operator - 1
        while at >= first:
            token = self.tokens[at]
            if 0 <= token.match < at:
                at = token.match - 1
                continue
            if token.text in ENDS or token.text in ("(", "[", "{") or (token.is_binary and PRECEDENCE.get(token.text, 99) < precedence):
                break
            at -= 1
        return at + 1

    def operand_end_of(self, operator: int, last: int, precedence: int) -> int:
        at = operator + 1
        while at < last:
            token = self.tokens[at]
            if self.tokens.opens(at):
                at = token.match + 1
                continue
            if token.text in ENDS or (token.is_binary and PRECEDENCE.get(token.text, 99) <= precedence):
                break
            at += 1
        return min(at, last)

    def operand_end(self, at: int, last: int) -> int:
        """The end of the operand of a unary operator."""
        tokens = self.tokens
        while at < last and tokens[at].kind == "sign" and tokens.word(at) in ("!", "*", "-", "~", "&"):
            at += 1
        at = tokens[at].match + 1 if tokens.opens(at) else at + 1
        while at < last:
            if tokens.word(at) in ("::", ".", "->"):
                at += 2
            elif tokens.word(at) in ("(", "[", "<") and tokens.opens(at):
                at = tokens[at].match + 1
            else:
                break
        return min(at, last)

    def binary(self, first: int, at: int, last: int) -> None:
        tokens = self.tokens
        word = tokens.word(at)
        precedence = PRECEDENCE[word]
        begin, end = self.operand_begin(first, at, precedence), self.operand_end_of(at, last, precedence)
        if begin >= at or end <= at + 1:
            return
        left, right = tokens.source(begin, at), tokens.source(at + 1, end)
        if word in COMPARISONS:
            self.add("compare", begin, end, f"{left} {COMPARISONS[word]} {right}")
        elif word in ("&&", "||"):
            self.add("logic", begin, end, f"({left}) {'||' if word == '&&' else '&&'} ({right})")
            self.add("forget", begin, end, left)
            if word not in [tokens.word(i) for i in self.level(begin, at)]:
                self.add("forget", begin, end, right)
        elif word in ARITHMETIC and not any(tokens[i].kind in ("text", "raw") for i in range(first, last)):
            self.add("arithmetic", begin, end, f"{left} {ARITHMETIC[word]} {right}")

    def negate(self, first: int, last: int) -> None:
        words = [self.tokens.word(i) for i in self.level(first, last)]
        binary = {self.tokens.word(i) for i in self.level(first, last) if self.tokens[i].is_binary}
        if "=" in words or (len(binary & set(COMPARISONS)) > 0 and not binary & {"&&", "||"}):
            return
        if words[0] == "!" and not binary:
            return
        self.add("negate", first, last, f"!({self.tokens.source(first, last)})")

    def number(self, at: int) -> None:
        text = self.tokens.word(at)
        if text.startswith("0x") and len(text) > 4:
            return  # a mask or a constant of a hash
        bare = text.rstrip("uUlLzZ") if text.startswith("0x") else text.rstrip("fFuUlLzZ")
        suffix = text[len(bare):]
        if bare in ("0.0", "1.0"):
            self.add("number", at, at + 1, ("1.0" if bare == "0.0" else "0.0") + suffix)
            return
        try:
            value = int(bare.replace("'", ""), 0)
        except ValueError:
            return
        self.add("number", at, at + 1, str({0: 1, 1: 0}.get(value, value + 1)) + suffix)

    def member(self, first: int, last: int) -> None:
        if self.is_glsl or self.tokens.word(first) in ("{", "[") or last - first == 1 and self.tokens.word(first) in ("0", "false", "nullptr"):
            return
        source = self.tokens.source(first, last)
        self.add("member", first, last, "{}", [Edit(self.tokens[first].begin, self.tokens[last - 1].end,
                                                    f"std::remove_cvref_t<decltype({source})>{{}}")])

    def swap(self, left: tuple, right: tuple) -> None:
        tokens = self.tokens
        one, two = tokens.source(*left), tokens.source(*right)
        if one == two or any(tokens.word(part[0]) in ("{", "[", ".") or tokens[part[0]].kind in ("text", "raw") or part[1] <= part[0]
                             for part in (left, right)):
            return
        edits = [Edit(tokens[part[0]].begin, tokens[part[1] - 1].end, f"glark_mutants::same_type<decltype({mine})>({other})")
                 for part, mine, other in ((left, one, two), (right, two, one))]
        self.add("swap", left[0], right[1], f"{two}, {one}", edits)

    def equality(self, record: Record) -> None:
        self.function = record.name
        if len(record.members) < 2 or "?" in record.members:
            return
        for member in record.members:
            begin, end = self.tokens[record.first].begin, self.tokens[record.last - 1].end
            edit = Edit(begin + self.offset, end + self.offset, member, "equality")
            self.mutants.append(Mutant(self.file, record.name, "equality", self.line_of(record.first), member, "", [edit]))


def mutants_of_cpp(file: str, text: str) -> list:
    tokens = Tokens(text)
    mutants = Operators(file, tokens).whole()
    for token in tokens.list:
        mark = token.text.find("(") + 1
        if token.kind == "raw" and ";" in token.text:
            content = token.text[mark:1 - mark]  # R"x( is one longer than )x"
            mutants += mutants_of_glsl(file, content, token.begin + mark, 1 + text.count("\n", 0, token.begin))
    return mutants


def mutants_of_glsl(file: str, text: str, offset: int = 0, line: int = 1) -> list:
    tokens = Tokens(text)
    operators = Operators(file, tokens, is_glsl=True, offset=offset, line=line)
    functions, _ = functions_of(tokens)
    for function in functions:
        operators.function_body(function)
    if not functions:
        operators.range(0, len(tokens))
    return operators.mutants


def mutants_of(file: str, text: str) -> list:
    made = mutants_of_glsl(file, text) if file.endswith(".glsl") else mutants_of_cpp(file, text)
    return without_crossing(made)


def without_crossing(mutants: list) -> list:
    """Leaves out mutants whose texts overlap with others without lying in them: the tokens were misread there."""
    spans = sorted({(edit.begin, -edit.end) for mutant in mutants for edit in mutant.edits})
    bad, open_spans = set(), []
    for begin, end in spans:
        while open_spans and open_spans[-1] <= begin:
            open_spans.pop()
        if open_spans and -end > open_spans[-1]:
            bad.add((begin, -end))
        else:
            open_spans.append(-end)
    return [mutant for mutant in mutants if not any((edit.begin, edit.end) in bad for edit in mutant.edits)]
