# SPDX-License-Identifier: MIT
"""sdk/api/abi.json: the C ABI as data, from the public headers.

headers    name, library, doc: the comment it begins with
constants  name, header, section, type, value, doc
enums      name, header, section, doc, values (name, value, doc); 4 bytes each, signed
handles    name, header, section, doc; structs of one uint64_t `id`, passed by value
objects    name, header, section, doc; opaque pointers
callbacks  name (of a field: STRUCT.FIELD; of a callback's parameter: CALLBACK.PARAMETER), returns, parameters, doc
structs    name, header, section, doc, size, align, init (the function that fills it with defaults, or null), fields
           (name, type, count: of an array, or 1, offset, size, doc); layout of 64-bit machines
functions  name, header, library, section, doc, returns, parameters (name, type, count), thread: "any", or the type
           whose calls must not overlap: calls on one FlgContext, one FlgPickScene, one FlgCurveFile... A handle
           (FlgLiveStroke): calls that take it, whatever else runs on its context
inlines    functions in the headers themselves: name, header, returns, parameters

Types are C's, pointers as `const FlgColumn*`; a parameter of type T with count n is declared `T name[n]`.
"""
import json
import re
from pathlib import Path

from c_declarations import Declarations, Function, Place, Variable
from layout import Layout

_LIBRARIES = {"filigree_io.h": "filigree_io", "filigree_pick.h": "filigree_pick"}
_ANY = "[any thread]"
_ANY_BUT = re.compile(r"\[any thread, one per (\w+)\]")


def library(header: str) -> str:
    return _LIBRARIES.get(header, "filigree")


def _thread(function: Function, header_doc: str, owners: set[str]) -> str:
    """Which calls must not overlap with it. Functions without an object touch only what they are given."""
    if _ANY in function.doc:
        return "any"
    if _ANY_BUT.match(function.doc):
        return function.parameters[1].type
    first = function.parameters[0].type if function.parameters else ""
    if first in owners:
        return first
    if f"{_ANY} All functions" not in header_doc and any(p.type in owners for p in function.parameters):
        raise ValueError(f"{function.name}: its object is not its first parameter, so whose thread is it?")
    return "any"


def _head(place: Place) -> dict:
    return {"name": place.name, "header": place.header, "section": place.section, "doc": place.doc}


def _parameters(parameters: list[Variable]) -> list[dict]:
    return [{"name": p.name, "type": p.type, "count": p.count} for p in parameters]


def _init_functions(functions: list[Function]) -> dict[str, str]:
    return {f.parameters[0].type[:-1]: f.name for f in functions
            if f.name.endswith("Init") and f.parameters[0].type.endswith("*")}


def describe(headers: Path) -> dict:
    found = Declarations(headers)
    layout = Layout(found)
    owners = {place.name for place in found.objects} | {"FlgContext"}
    inits = _init_functions(found.functions)
    structs = []
    for struct in found.structs:
        size, align = layout.size(struct.name)
        fields = [{"name": f.name, "type": f.type, "count": f.count, "offset": offset, "size": layout.of(f)[0],
                   "doc": f.doc} for f, offset in zip(struct.fields, layout.offsets[struct.name])]
        structs.append(_head(struct) | {"size": size, "align": align, "init": inits.get(struct.name), "fields": fields})
    return {
        "headers": [{"name": name, "library": library(name), "doc": doc} for name, doc in found.headers.items()],
        "constants": [{"name": c.name, "header": c.header, "section": c.section, "type": c.type, "value": c.value,
                       "doc": c.doc} for c in found.constants],
        "enums": [_head(e) | {"values": [{"name": v.name, "value": v.value, "doc": v.doc} for v in e.values]}
                  for e in found.enums],
        "handles": [_head(handle) for handle in found.handles],
        "objects": [_head(item) for item in found.objects],
        "callbacks": [{"name": c.name, "returns": c.returns, "doc": c.doc, "parameters": _parameters(c.parameters)}
                      for c in found.callbacks],
        "structs": structs,
        "functions": [_head(f) | {"library": library(f.header), "returns": f.returns,
                                  "thread": _thread(f, found.headers[f.header], owners),
                                  "parameters": _parameters(f.parameters)} for f in found.functions],
        "inlines": [{"name": f.name, "header": f.header, "returns": f.returns, "parameters": _parameters(f.parameters)}
                    for f in found.inline_functions],
    }


def _lines(value, indent: str) -> str:
    """JSON with a line for each thing that holds no others: changes of a header are changes of few lines."""
    inner = indent + "  "
    if isinstance(value, list) and value:
        return "[\n" + ",\n".join(inner + _lines(item, inner) for item in value) + f"\n{indent}]"
    if isinstance(value, dict) and any(isinstance(item, list) for item in value.values()):
        items = [f"{inner}{json.dumps(key)}: {_lines(item, inner)}" for key, item in value.items()]
        return "{\n" + ",\n".join(items) + f"\n{indent}}}"
    return json.dumps(value, ensure_ascii=False)


def to_json(description: dict) -> str:
    return _lines(description, "") + "\n"
