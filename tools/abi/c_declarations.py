# SPDX-License-Identifier: MIT
"""The declarations of the public headers: functions, structs, enums, handles, callbacks, constants.

Types are C's, spelled one way: `const FlgColumn*`, `const char* const*`. The type of a function pointer is the name of
its callback, `FlgLog.write`. What the grammar of the headers does not have is an error.
"""
from dataclasses import dataclass, field
from pathlib import Path

from c_tokens import Constant, Misunderstood, Reader, Token

_BASES = {"void", "char", "float", "double", "size_t", "int32_t", "int64_t", "uint8_t", "uint16_t", "uint32_t",
          "uint64_t"}


@dataclass
class Place:
    name: str
    header: str
    section: str
    doc: str


@dataclass
class Variable:
    """A field or a parameter."""
    name: str
    type: str
    count: int = 1  # of an array; a parameter's array is a pointer to so many
    doc: str = ""


@dataclass
class Callback:
    name: str
    returns: str
    parameters: list[Variable]
    doc: str = ""


@dataclass
class Struct(Place):
    fields: list[Variable] = field(default_factory=list)


@dataclass
class Enum(Place):
    values: list[Constant] = field(default_factory=list)


@dataclass
class Function(Place):
    returns: str = ""
    parameters: list[Variable] = field(default_factory=list)


class Declarations:
    def __init__(self, folder: Path):
        reader = Reader(folder)
        for path in sorted(folder.glob("filigree*.h")):
            reader.read(path.name)
        self.headers = reader.headers
        self.constants = reader.constants
        self.handles: list[Place] = []
        self.objects: list[Place] = []
        self.callbacks: list[Callback] = []
        self.structs: list[Struct] = []
        self.enums: list[Enum] = []
        self.functions: list[Function] = []
        self.inline_functions: list[Function] = []
        self.types = set(_BASES)
        self._reader = reader
        self._tokens = reader.tokens
        self._next = 0
        while self._next < len(self._tokens):
            self._declaration()

    # ---- Tokens --------------------------------------------------------------------------------------------------

    def _peek(self, ahead: int = 0) -> str:
        place = self._next + ahead
        return self._tokens[place].text if place < len(self._tokens) else ""

    def _take(self, wanted: str = "") -> Token:
        if self._next == len(self._tokens):
            raise Misunderstood(f"the last header ends where `{wanted or 'more'}` has to follow")
        token = self._tokens[self._next]
        if wanted and token.text != wanted:
            raise Misunderstood(f"{token.header}:{token.line}: `{token.text}` stands where `{wanted}` has to")
        self._next += 1
        return token

    def _taken(self, text: str) -> bool:
        if self._peek() != text:
            return False
        self._next += 1
        return True

    def _word(self) -> Token:
        token = self._take()
        if not (token.text[0].isalpha() or token.text[0] == "_"):
            raise Misunderstood(f"{token.header}:{token.line}: `{token.text}` stands where a name has to")
        return token

    # ---- Declarations --------------------------------------------------------------------------------------------

    def _declaration(self) -> None:
        first = self._tokens[self._next]
        if self._taken("FLG_API"):
            self.functions.append(self._function(first))
            self._take(";")
        elif self._taken("FLG_HANDLE"):
            self._take("(")
            self.handles.append(self._place(first, self._word().text))
            self._take(")")
            self._take(";")
        elif self._taken("static"):
            self._take("inline")
            self.inline_functions.append(self._function(first))
            self._body()
        elif self._taken("enum"):  # without a name: constants
            self.constants += self._enum_values()
            self._take(";")
        else:
            self._take("typedef")
            self._typedef(first)

    def _place(self, first: Token, name: str) -> Place:
        self.types.add(name)
        return Place(name, first.header, first.section, first.lead)

    def _typedef(self, first: Token) -> None:
        kind = self._take().text
        tag = self._word().text
        if kind == "struct" and self._taken("*"):
            self.objects.append(self._place(first, self._word().text))
        elif kind == "struct":
            self.structs.append(Struct(tag, first.header, first.section, first.lead, self._fields(tag)))
            self.types.add(self._take(tag).text)
        elif kind == "enum":
            self.enums.append(Enum(tag, first.header, first.section, first.lead, self._enum_values()))
            self.types.add(self._take(tag).text)
        else:
            raise Misunderstood(f"{first.header}:{first.line}: typedef of `{kind}`")
        self._take(";")

    def _body(self) -> None:
        depth = 0
        while True:
            text = self._take().text
            depth += (text == "{") - (text == "}")
            if depth == 0:
                return

    def _function(self, first: Token) -> Function:
        returns = self._type()
        name = self._word().text
        return Function(name, first.header, first.section, first.lead, returns, self._parameters(name))

    def _enum_values(self) -> list[Constant]:
        self._take("{")
        values = []
        while not self._taken("}"):
            name = self._word()
            self._take("=")
            expression = ""
            while self._peek() not in (",", "}"):
                expression += " " + self._take().text
            last = self._tokens[self._next - 1]
            if self._peek() == ",":
                last = self._take()
            value = self._reader.value_of(expression)
            values.append(Constant(name.text, name.header, name.section, value, "int32_t", last.trail or name.lead))
        return values

    def _fields(self, struct: str) -> list[Variable]:
        self._take("{")
        fields: list[Variable] = []
        while not self._taken("}"):
            lead = self._tokens[self._next].lead
            declared = [self._variable(self._type(), struct)]
            while self._taken(","):  # `float u, v;`: values only, where the type is all that stands before the name
                declared.append(self._variable(declared[0].type, struct))
            doc = self._take(";").trail or " ".join(lead.split())
            for variable in declared:
                variable.doc = doc
                for callback in self.callbacks:
                    if callback.name == variable.type and callback.name == f"{struct}.{variable.name}":
                        callback.doc = doc
            fields += declared
        return fields

    # ---- Types ---------------------------------------------------------------------------------------------------

    def _type(self) -> str:
        spelled = "const " if self._taken("const") else ""
        base = self._word()
        if base.text not in self.types:
            raise Misunderstood(f"{base.header}:{base.line}: the type `{base.text}` is not known")
        spelled += base.text
        while True:
            if self._taken("*"):
                spelled += "*"
            elif spelled.endswith("*") and self._taken("const"):
                spelled += " const"
            else:
                return spelled

    def _variable(self, spelled: str, owner: str) -> Variable:
        """A declarator behind its type: a name, an array, or a function pointer: a callback of `owner`."""
        if self._taken("("):
            self._take("*")
            name = self._word().text
            self._take(")")
            callback = f"{owner}.{name}"
            parameters = self._parameters(callback)
            self.callbacks.append(Callback(callback, spelled, parameters))
            return Variable(name, callback)
        name = self._word().text
        count = 1
        if self._taken("["):
            count = self._reader.value_of(self._take().text)
            self._take("]")
        return Variable(name, spelled, count)

    def _parameters(self, owner: str) -> list[Variable]:
        self._take("(")
        if self._peek() == "void" and self._peek(1) == ")":
            self._next += 1
        parameters = []
        while not self._taken(")"):
            if parameters:
                self._take(",")
            parameters.append(self._variable(self._type(), owner))
        return parameters
