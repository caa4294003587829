#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""c_proof.py ABI.json OUT.c: a C11 program that compiles only if abi.json is what the compiler sees in the headers
(every type, offset, size, value and signature); it prints sizes and offsets: `STRUCT SIZE`,
`STRUCT.FIELD OFFSET`."""
import json
import sys
from pathlib import Path

_HEAD = """/* Written by tools/abi/c_proof.py. Each line below holds, or this does not compile. */
#include <inttypes.h>
#include <stdio.h>

#include "filigree/filigree_all.h"

#define SAME_TYPE(Struct, field, ...) \\
    _Static_assert(_Generic(&((Struct*)0)->field, __VA_ARGS__: 1, default: 0), #Struct "." #field)
#define LAID_OUT(Struct, field, offset, size) \\
    _Static_assert(offsetof(Struct, field) == (offset) && sizeof(((Struct*)0)->field) == (size), #Struct "." #field)
"""


class _Types:
    """C's declarators for the description's types."""

    def __init__(self, abi: dict):
        self._callbacks = {callback["name"]: callback for callback in abi["callbacks"]}

    def declare(self, kind: str, name: str, count: int = 1) -> str:
        callback = self._callbacks.get(kind)
        if callback:
            return f"{callback['returns']} (*{name})({self.parameters(callback['parameters'])})"
        if count != 1:
            return f"{kind} {name}[{count}]" if name.isidentifier() else f"{kind} ({name})[{count}]"
        return f"{kind} {name}"

    def parameters(self, parameters: list[dict]) -> str:
        return ", ".join(self.declare(p["type"], p["name"], p["count"]) for p in parameters) or "void"


def proof(abi: dict) -> str:
    types = _Types(abi)
    lines = [_HEAD]
    for constant in abi["constants"]:
        lines.append(f'_Static_assert({constant["name"]} == {constant["value"]}, "{constant["name"]}");')
    for enum in abi["enums"]:
        lines.append(f'_Static_assert(sizeof({enum["name"]}) == 4, "{enum["name"]}");')
        lines += [f'_Static_assert({v["name"]} == {v["value"]}, "{v["name"]}");' for v in enum["values"]]
    for handle in abi["handles"]:
        lines.append(f'_Static_assert(sizeof({handle["name"]}) == 8, "{handle["name"]}");')
        lines.append(f'SAME_TYPE({handle["name"]}, id, uint64_t*);')
    for struct in abi["structs"]:
        name = struct["name"]
        shape = f'sizeof({name}) == {struct["size"]} && _Alignof({name}) == {struct["align"]}'
        lines.append(f'_Static_assert({shape}, "{name}");')
        for f in struct["fields"]:
            lines.append(f'LAID_OUT({name}, {f["name"]}, {f["offset"]}, {f["size"]});')
            lines.append(f'SAME_TYPE({name}, {f["name"]}, {types.declare(f["type"], "*", f["count"])});')
    for function in abi["functions"] + abi["inlines"]:
        name, signature = function["name"], f'{function["returns"]} (*)({types.parameters(function["parameters"])})'
        lines.append(f'_Static_assert(_Generic(&{name}, {signature}: 1, default: 0), "{name}");')
    lines.append("\nint main(void) {")
    for struct in abi["structs"]:
        name = struct["name"]
        lines.append(f'    printf("{name} %zu\\n", sizeof({name}));')
        lines += [f'    printf("{name}.{f["name"]} %zu\\n", offsetof({name}, {f["name"]}));' for f in struct["fields"]]
    lines.append("    return 0;\n}")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    source, out = map(Path, sys.argv[1:])
    out.write_text(proof(json.loads(source.read_text(encoding="utf-8"))), encoding="utf-8")
