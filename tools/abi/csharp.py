# SPDX-License-Identifier: MIT
"""The C# binding of abi.json: a file for each header and kind of thing, of blittable structs and static functions with
pointers, so that no call marshals, copies or allocates. Structs, fields and functions keep their C names, which the
comments, that come along, speak of; values of enums become FlgResult.NotReady. Layouts are those of C: C# lays structs
out in sequence.
"""
import re
import textwrap

_NUMBERS = {"void": "void", "char": "byte", "uint8_t": "byte", "uint16_t": "ushort", "int32_t": "int",
            "uint32_t": "uint", "int64_t": "long", "uint64_t": "ulong", "size_t": "UIntPtr", "float": "float",
            "double": "double"}
_KEYWORDS = {"base", "object", "string", "params", "in", "out", "ref", "event", "lock", "fixed", "is", "as"}
_WIDTH = 116  # inside of the namespace


def _pascal(name: str) -> str:
    return "".join(word[:1].upper() + word[1:] for word in name.split("_"))


def identifier(name: str) -> str:
    return f"@{name}" if name in _KEYWORDS else name


def _delegate(callback: str) -> str:
    owner, _, rest = callback.partition(".")
    return owner + "".join(_pascal(part) for part in rest.split("."))


class _Enum:
    """An enum's values by their C names."""

    def __init__(self, enum: dict):
        self.name = enum["name"]
        shown = [v for v in enum["values"] if not v["name"].endswith("_FORCE_32BIT")]
        names = [v["name"] for v in shown]
        common = names[0]
        while not all(name.startswith(common) for name in names):
            common = common[:-1]
        common = common[:common.rindex("_") + 1]
        self.members = [(_pascal(v["name"][len(common):].lower()), v) for v in shown]


class Binding:
    def __init__(self, abi: dict):
        self._abi = abi
        self._enums = {enum["name"]: _Enum(enum) for enum in abi["enums"]}
        self._callbacks = {callback["name"] for callback in abi["callbacks"]}
        self._inits = {struct["name"]: struct["init"] for struct in abi["structs"]}
        self._functions = {function["name"]: function for function in abi["functions"]}
        self._values = {value["name"]: f"{enum.name}.{member}" for enum in self._enums.values()
                        for member, value in enum.members}

    def files(self) -> dict[str, str]:
        """File names and texts."""
        files = {}
        for header in self._abi["headers"]:
            stem = _pascal(header["name"].removesuffix(".h"))
            for kind, body in (("Types", self._types(header["name"])), ("Structs", self._structs(header["name"])),
                               ("Functions", self._functions_of(header))):
                if body:
                    files[f"{stem}{kind}.cs"] = self._file(header, kind, body)
        return files

    # ---- Comments ------------------------------------------------------------------------------------------------

    def _said(self, text: str) -> str:
        return re.sub(r'(?<!")\bFLG_\w+', lambda name: self._values.get(name[0], name[0]), text)

    def _doc(self, text: str, indent: str, name: str = "") -> list[str]:
        """A summary, its paragraphs filled anew; lines that are indented stay lines. A name comes first, as it is."""
        text = f"{name}: {self._said(text)}" if name and text else name or self._said(text)
        if not text:
            return []
        paragraphs: list[str] = []
        for line in text.split("\n"):
            if paragraphs and line and not line.startswith(" ") and not paragraphs[-1].startswith(" "):
                paragraphs[-1] += " " + line
            else:
                paragraphs.append(line)
        start = f"{indent}/// "
        lines = []
        for paragraph in paragraphs:
            escaped = paragraph.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
            inner = re.match(" *", paragraph)[0]
            lines += textwrap.wrap(escaped, _WIDTH, initial_indent=start, subsequent_indent=start + inner,
                                   break_long_words=False, break_on_hyphens=False)
        if len(lines) == 1 and len(lines[0]) + len("<summary></summary>") <= _WIDTH:
            return [f"{start}<summary>{lines[0][len(start):]}</summary>"]
        return [f"{start}<summary>", *lines, f"{start}</summary>"]

    def _file(self, header: dict, kind: str, body: list[str]) -> str:
        lines = ["// SPDX-License-Identifier: MIT",
                 f"// {kind} of {header['name']}. "
                 "Written by tools/abi/generate from sdk/api/abi.json: change the header."]
        if kind == "Functions":
            lines.append("//")
            source = self._said(header["doc"]).split("\n")
            for line, after in zip(source, source[1:] + [""]):
                inner = re.match(" *", after if after.startswith(" ") else line)[0]
                lines += textwrap.wrap(line, _WIDTH + 4, initial_indent="// ", subsequent_indent="// " + inner,
                                       drop_whitespace=True, replace_whitespace=False) or ["//"]
        lines += ["", "using System;"]
        if any("Cdecl" in line for line in body):
            lines += ["using System.Runtime.InteropServices;",
                      "using static System.Runtime.InteropServices.CallingConvention;"]
        lines += ["", "namespace Filigree", "{"]
        return "\n".join(lines + [f"    {line}" if line else "" for line in body[:-1]] + ["}", ""])

    # ---- Types ---------------------------------------------------------------------------------------------------

    def _type(self, spelled: str, count: int = 1) -> str:
        """Of a parameter or a result: arrays are pointers."""
        if spelled in self._callbacks:
            return "IntPtr"
        base = spelled.replace("const ", "").replace(" const", "")
        stars = base.count("*") + (count != 1)
        base = base.replace("*", "")
        return _NUMBERS.get(base, base) + "*" * stars

    def _parameters(self, parameters: list[dict]) -> list[str]:
        return [f"{self._type(p['type'], p['count'])} {identifier(p['name'])}" for p in parameters]

    def _types(self, header: str) -> list[str]:
        abi, lines = self._abi, []
        constants = [c for c in abi["constants"] if c["header"] == header]
        if constants:
            lines += ["public static unsafe partial class Native", "{"]
            for c in constants:
                lines += self._doc(c["doc"], "    ")
                lines.append(f"    public const {_NUMBERS[c['type']]} {c['name']} = {c['value']};")
            lines += ["}", ""]
        for enum in (e for e in abi["enums"] if e["header"] == header):
            lines += self._enum(enum)
        for kind, body in (("handles", self._handle), ("objects", self._object)):
            for item in (i for i in abi[kind] if i["header"] == header):
                lines += self._doc(item["doc"], "") + body(item["name"]) + [""]
        return lines

    def _structs(self, header: str) -> list[str]:
        abi, lines = self._abi, []
        for struct in (s for s in abi["structs"] if s["header"] == header):
            for callback in abi["callbacks"]:
                if callback["name"].startswith(struct["name"] + "."):
                    lines += self._callback(callback)
            lines += self._struct(struct)
        return lines

    def _enum(self, enum: dict) -> list[str]:
        lines = self._doc(enum["doc"], "") + [f"public enum {enum['name']}", "{"]
        for member, value in self._enums[enum["name"]].members:
            lines += self._doc(value["doc"], "    ", value["name"])
            lines.append(f"    {member} = {value['value']},")
        return lines + ["}", ""]

    def _handle(self, name: str) -> list[str]:
        return [f"public partial struct {name} : IEquatable<{name}>", "{",
                "    public ulong id;", "    public bool IsNull => id == 0;",
                f"    public bool Equals({name} other) => id == other.id;",
                f"    public override bool Equals(object other) => other is {name} handle && Equals(handle);",
                "    public override int GetHashCode() => id.GetHashCode();", "}"]

    def _object(self, name: str) -> list[str]:
        return [f"public partial struct {name}", "{", "    public IntPtr pointer;",
                "    public bool IsNull => pointer == IntPtr.Zero;", "}"]

    def _callback(self, callback: dict) -> list[str]:
        parameters = ", ".join(self._parameters(callback["parameters"]))
        head = f"public unsafe delegate {self._type(callback['returns'])} {_delegate(callback['name'])}("
        lines = self._doc(f"Of {callback['name']}. {callback['doc']}".strip(), "")
        return lines + ["[UnmanagedFunctionPointer(Cdecl)]", *self._call(head, parameters), ""]

    def _struct(self, struct: dict) -> list[str]:
        lines = self._doc(struct["doc"], "")
        lines += [f"public unsafe partial struct {struct['name']}", "{"]
        for f in struct["fields"]:
            if f["type"] in self._callbacks:
                doc = f"A {_delegate(f['type'])}, by Marshal.GetFunctionPointerForDelegate. {f['doc']}".strip()
                lines += self._doc(doc, "    ")
            else:
                lines += self._doc(f["doc"], "    ")
            if f["count"] == 1:
                lines.append(f"    public {self._type(f['type'])} {identifier(f['name'])};")
            else:
                lines.append(f"    public fixed {self._type(f['type'])} {identifier(f['name'])}[{f['count']}];")
        return lines + ["}", ""]

    # ---- Functions -----------------------------------------------------------------------------------------------

    def _functions_of(self, header: dict) -> list[str]:
        functions = [f for f in self._abi["functions"] if f["header"] == header["name"]]
        inlines = [f for f in self._abi["inlines"] if f["header"] == header["name"]]
        if not functions:
            return []
        library = _pascal(header["library"].removeprefix("filigree_"))
        lines = ["public static unsafe partial class Native", "{"]
        for function in functions:
            lines += self._doc(function["doc"], "    ")
            lines.append(f"    [DllImport(Library.{library}, CallingConvention = Cdecl, ExactSpelling = true)]")
            head = f"public static extern {self._type(function['returns'])} {function['name']}("
            lines += ["    " + line for line in self._call(head, ", ".join(self._parameters(function["parameters"])))]
            lines.append("")
        for inline in inlines:
            lines += self._defaults(inline)
        return lines[:-1] + ["}", ""]

    def _defaults(self, inline: dict) -> list[str]:
        """The one kind of function that the headers hold themselves: a struct of defaults, by value."""
        struct = inline["returns"]
        init = self._functions[self._inits[struct]]
        size = f", (uint)sizeof({struct})" if len(init["parameters"]) == 2 else ""
        return [f"    public static {struct} {inline['name']}()", "    {", f"        {struct} made;",
                f"        {init['name']}(&made{size});", "        return made;", "    }", ""]

    def _call(self, head: str, parameters: str) -> list[str]:
        """A declaration, broken between parameters."""
        room = _WIDTH - 4
        if len(head) + len(parameters) + 2 <= room:
            return [f"{head}{parameters});"]
        lines = textwrap.wrap(parameters, room - 4 - len(");"), break_long_words=False, break_on_hyphens=False)
        return [head] + [f"    {line}" for line in lines[:-1]] + [f"    {lines[-1]});"]
