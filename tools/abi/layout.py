# SPDX-License-Identifier: MIT
"""Where fields lie on 64-bit machines: natural alignment, which is what every ABI there has for the types we use. The
program that c_proof.py writes has a compiler confirm it."""
from c_declarations import Declarations, Variable
from c_tokens import Misunderstood

_SIZES = {"char": 1, "uint8_t": 1, "uint16_t": 2, "int32_t": 4, "uint32_t": 4, "float": 4, "int64_t": 8, "uint64_t": 8,
          "size_t": 8, "double": 8}


class Layout:
    def __init__(self, declarations: Declarations):
        self._known: dict[str, tuple[int, int]] = {name: (size, size) for name, size in _SIZES.items()}
        pointers = declarations.objects + declarations.callbacks
        self._known |= {pointer.name: (8, 8) for pointer in pointers}
        self._known |= {handle.name: (8, 8) for handle in declarations.handles}
        self._known |= {enum.name: (4, 4) for enum in declarations.enums}
        self.offsets: dict[str, list[int]] = {}
        for struct in declarations.structs:
            self._lay_out(struct.name, struct.fields)

    def of(self, variable: Variable) -> tuple[int, int]:
        """Size and alignment, arrays whole."""
        if variable.type.endswith(("*", "* const")):
            size, alignment = 8, 8
        elif variable.type in self._known:
            size, alignment = self._known[variable.type]
        else:
            raise Misunderstood(f"{variable.name}: how large is a `{variable.type}`?")
        return size * variable.count, alignment

    def size(self, name: str) -> tuple[int, int]:
        return self._known[name]

    def _lay_out(self, name: str, fields: list[Variable]) -> None:
        end, strictest, offsets = 0, 1, []
        for variable in fields:
            size, alignment = self.of(variable)
            begin = -(-end // alignment) * alignment
            offsets.append(begin)
            end, strictest = begin + size, max(strictest, alignment)
        self.offsets[name] = offsets
        self._known[name] = (-(-end // strictest) * strictest, strictest)
