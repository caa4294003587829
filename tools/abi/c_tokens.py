# SPDX-License-Identifier: MIT
"""The public headers as tokens: comments joined to what they speak of, conditionals decided, constants evaluated.

Only what the headers use is understood; anything else is an error that names file and line, so that nothing is left out
of the description unnoticed.
"""
import re
from dataclasses import dataclass
from pathlib import Path


class Misunderstood(Exception):
    """Something in a header that this reader does not know."""


@dataclass
class Token:
    text: str
    header: str
    line: int
    section: str = ""  # the last heading `---- Name ----` above it
    lead: str = ""     # the comment that ends on the line above
    trail: str = ""    # the comment that begins on its line, behind it


@dataclass
class Constant:
    name: str
    header: str
    section: str
    value: int
    type: str
    doc: str


_PIECES = re.compile(r"""(?P<space>[ \t]+)|(?P<newline>\n)|(?P<comment>/\*.*?\*/)|(?P<directive>\#(?:\\\n|[^\n])*)
    |(?P<word>[A-Za-z_]\w*)|(?P<number>\d\w*)|(?P<punctuation>[][(){};,*=&-])|(?P<string>"[^"\n]*")""", re.X | re.S)
_MACROS_OF_CODE = {"FLG_API", "FLG_HANDLE"}  # they stand for text, not for a value


def comment_lines(comment: str) -> list[str]:
    """The lines of a comment without its frame; indentation behind ` * ` stays."""
    lines = comment[2:-2].split("\n")
    text = [lines[0].strip()]
    for line in lines[1:]:
        line = line.strip()
        text.append(re.sub(r"^\* ?", "", line).rstrip())
    return text


def block(comment: str) -> str:
    return "\n".join(comment_lines(comment)).strip()


def one_line(comment: str) -> str:
    return " ".join(block(comment).split())


def file_comment(text: str) -> str:
    """The comment that a header begins with, without its licence."""
    comment = re.match(r"/\*.*?\*/", text, re.S)
    if comment is None:
        raise Misunderstood("a header without a comment that says what it is")
    return "\n".join(line for line in comment_lines(comment[0]) if not line.startswith("SPDX-")).strip()


class Reader:
    """Reads headers as one translation unit does: each once, macros shared."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.headers: dict[str, str] = {}  # name -> file comment, in the order they were met
        self.tokens: list[Token] = []
        self.constants: list[Constant] = []
        self._defined: dict[str, int] = {}

    def read(self, name: str) -> None:
        if name in self.headers:
            return
        text = (self.folder / name).read_text(encoding="utf-8")
        self.headers[name] = file_comment(text)
        _File(self, name, text).read()

    def define(self, constant: Constant) -> None:
        if self._defined.setdefault(constant.name, constant.value) != constant.value:
            raise Misunderstood(f"{constant.name} has another value already: {self._defined[constant.name]}")
        if all(known.name != constant.name for known in self.constants):
            self.constants.append(constant)

    def value_of(self, expression: str) -> int:
        """An integer constant expression of C: literals, constants before it, + - << | and parentheses."""
        words = re.findall(r"0[xX][0-9a-fA-F]+[uU]?|\d+[uU]?|[A-Za-z_]\w*|<<|[-+|()]|\S", expression)
        python = []
        for word in words:
            if word in self._defined:
                python.append(str(self._defined[word]))
            elif re.fullmatch(r"(0[xX][0-9a-fA-F]+|\d+)[uU]?", word):
                python.append(word.rstrip("uU"))
            elif word in ("<<", "|", "+", "-", "(", ")"):
                python.append(word)
            else:
                raise Misunderstood(f"`{word}` in the constant `{expression}`")
        return int(eval(" ".join(python), {"__builtins__": {}}))  # nothing but numbers and operators is left

    def is_defined(self, name: str) -> bool:
        return name in self._defined


class _File:
    def __init__(self, reader: Reader, name: str, text: str):
        self.reader, self.name, self.text = reader, name, text
        self.line = 1
        self.section = ""
        self.shown = [True]            # of each open conditional: is its present branch read?
        self.decided = [True]          # and was one of its branches?
        self.comment: tuple[int, str] | None = None  # a comment that may lead: the line it ends on, its text
        self.own: list[Token] = []

    def fail(self, what: str) -> Misunderstood:
        return Misunderstood(f"{self.name}:{self.line}: {what}")

    def read(self) -> None:
        position = 0
        while position < len(self.text):
            piece = _PIECES.match(self.text, position)
            if piece is None:
                raise self.fail(f"`{self.text[position]}` is not known")
            position = piece.end()
            kind = piece.lastgroup
            try:
                if kind == "comment":
                    self.take_comment(piece[0])
                elif kind == "directive":
                    self.take_directive(piece[0])
                elif kind in ("word", "number", "punctuation", "string") and self.shown[-1]:
                    self.take_token(piece[0])
            except Misunderstood as error:
                raise error if str(error).startswith(self.name) else self.fail(str(error)) from None
            self.line += piece[0].count("\n")
        if len(self.shown) != 1:
            raise self.fail("a conditional is left open")

    def lead(self) -> str:
        """The comment that ends on the line above, or nothing; it is used up."""
        comment, self.comment = self.comment, None
        return comment[1] if comment and comment[0] >= self.line - 1 else ""

    def take_token(self, text: str) -> None:
        lead = block(self.lead() or "/**/")
        token = Token(text, self.name, self.line, self.section, lead)
        self.own.append(token)
        self.reader.tokens.append(token)

    def take_comment(self, comment: str) -> None:
        heading = re.match(r"/\* -{4} (.+?)(?:\s|\*|-)*\*/", comment, re.S)
        if heading:
            self.section = heading[1]
        elif self.own and self.own[-1].line == self.line:
            self.own[-1].trail = one_line(comment)
        else:
            self.comment = (self.line + comment.count("\n"), comment)

    def take_directive(self, directive: str) -> None:
        directive = directive.replace("\\\n", " ")
        word, _, rest = directive[1:].strip().partition(" ")
        rest = rest.strip()
        if word in ("if", "ifdef", "ifndef"):
            holds = self.shown[-1] and self.condition(word, rest)
            self.decided.append(holds or not self.shown[-1])
            self.shown.append(holds)
        elif word in ("elif", "else"):
            holds = not self.decided[-1] and (word == "else" or self.condition("if", rest))
            self.decided[-1] = self.decided[-1] or holds
            self.shown[-1] = holds
        elif word == "endif":
            self.shown.pop()
            self.decided.pop()
        elif not self.shown[-1]:
            return
        elif word == "define":
            self.take_define(rest)
        elif word == "include":
            own = re.fullmatch(r'"(\w+\.h)"', rest)
            if own:
                self.reader.read(own[1])
            elif not re.fullmatch(r"<std(int|def)\.h>", rest):
                raise self.fail(f"#include {rest}: only filigree's own headers and the C library's integers are known")
        else:
            raise self.fail(f"#{word} is not known")

    def condition(self, word: str, rest: str) -> bool:
        name = re.fullmatch(r"(?:defined\()?([A-Za-z_]\w*)\)?", rest)
        if name is None:
            raise self.fail(f"#{word} {rest} is not known")
        return self.reader.is_defined(name[1]) != (word == "ifndef")

    def take_define(self, rest: str) -> None:
        comment = re.search(r"/\*.*", rest)
        doc = block(comment[0]) if comment else block(self.lead() or "/**/")
        self.comment = None
        name, _, expression = re.sub(r"/\*.*", "", rest).strip().partition(" ")
        macro = name.partition("(")[0]
        guard = "FILIGREE_" + self.name.upper().replace(".", "_")
        if macro in _MACROS_OF_CODE or macro == guard:
            return
        if "(" in name or not expression.strip():
            raise self.fail(f"#define {name} is not known")
        value = self.reader.value_of(expression)
        unsigned = value > 0x7fffffff or re.search(r"\b(0[xX][0-9a-fA-F]+|\d+)[uU]\b", expression)
        kind = "uint32_t" if unsigned else "int32_t"
        self.reader.define(Constant(name, self.name, self.section, value, kind, doc))
