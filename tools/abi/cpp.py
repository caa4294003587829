# SPDX-License-Identifier: MIT
"""filigree.hpp: C++ over abi.json. wrapper_parts.hpp holds what is written by hand: results, spans, the owners' bases, and
two functions that put several calls together.

What abi.json does not say is derived from names and comments: the length of an array (`3 per vertex`, `X_count` beside
`xs`), which handles a descriptor can't do without, which arguments may be null. An array of a view whose length cannot
be derived is an error, unless _LENGTHS has it.
"""
import re
import textwrap
from pathlib import Path

from c_tokens import Misunderstood

_WIDTH = 120

# Lengths of arrays in views, by the view's own members, where the comments have no simple pattern.
_LENGTHS = {
    "FlgStraightSkeletonView.face_nodes": "face_offsets.empty() ? 0 : face_offsets[contour_count]",
    "FlgStraightSkeletonView.input_points": "contour_count",
    "FlgSurfaceView.neighbours": "std::size_t{3} * mesh.triangle_count",
    "FlgSurfaceProvenanceView.input_vertices": "std::size_t{3} * input_triangle_count",
    "FlgSurfaceCurvesView.points": "curve_offsets.empty() ? 0 : curve_offsets[curve_count]",
    "FlgFieldView.labels": "vertex_count",
    "FlgPartView.arcs": "node_count == 0 ? 0 : std::size_t{2} * (node_count - 1)",
    "FlgSplineView.nodes": "std::size_t{ambient} * node_count",
}
# Numbers in one element of an array parameter that a count follows; 1 if not here.
_FACTORS = {"flgCurveSetCreateFromPoints.points": 3, "flgSurfaceCreateFromTriangles.positions": 3,
            "flgSurfaceCreateFromTriangles.triangles": 3}
# Arguments most callers leave alone.
_DEFAULTS = {"flgContextRun.jobs": "{}", "flgContextRun.seconds": "1e9", "flgStyleWarm.temperature": "0.0f",
             "flgCurveSetCreateFromPoints.flags": "0", "flgPickSceneSetSurface.changed": "{}",
             "flgManifoldProject.out_distances": "nullptr"}
# Structs that calls fill, but hosts make too: a length of theirs is another struct's.
_DESCRIPTORS = {"FlgSkinAnimation", "FlgMeshFaceColumn", "FlgMeshMaterial", "FlgTexture", "FlgMorphTarget",
                "FlgMorphAnimation"}
# Members of views whose length only another view knows: pointers, as in C.
_POINTERS = {"FlgSkinFileInfo.vertex_colors"}
# Structs that are changed, and may be null.
_NULLABLE = {"flgBrushMeshWrite.state"}
# Results without `out_` in their name.
_OUTPUTS = {"flgContextTick.report"}
_ALIASES = {"FlgResult": "ResultCode"}  # Result is what a call gives
_FAILURES = {"filigree": "", "filigree_io": "<flgIoErrorGetMessage>", "filigree_pick": "<flgPickErrorGetMessage>"}


def _snake(name: str) -> str:
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


def _base(spelled: str) -> str:
    return spelled.replace("const ", "").replace(" const", "").rstrip("*")


def _doc(text: str, indent: str = "") -> list[str]:
    """The C comment, filled anew. Indented lines begin items; what is indented further belongs to the item above it."""
    start = f"{indent}/// "
    items: list[tuple[int, str]] = []  # indentation and text
    for line in text.split("\n"):
        inner = len(line) - len(line.lstrip())
        if not line:
            items.append((0, ""))
        elif items and items[-1][1] and (inner > items[-1][0] > 0 or inner == items[-1][0] == 0):
            items[-1] = (items[-1][0], f"{items[-1][1]} {line.strip()}")
        else:
            items.append((inner, line.strip()))
    lines: list[str] = []
    for inner, said in items:
        columns = re.match(r"\S+ {2,}", said) if inner else None  # `word  what it means`
        hanging = start + " " * (inner + (len(columns[0]) if columns else 0))
        lines += textwrap.wrap(said, _WIDTH, initial_indent=start + " " * inner, subsequent_indent=hanging,
                               break_long_words=False, break_on_hyphens=False)
    return lines


def _broken(line: str) -> list[str]:
    """A line of code that is too long, broken behind commas, or behind its equals sign."""
    inner = re.match(" *", line)[0] + "    "
    pieces = [line]
    while len(pieces[-1]) > _WIDTH:
        at = max(pieces[-1].rfind(", ", 0, _WIDTH), pieces[-1].rfind(" = ", 0, _WIDTH) + 1) + 1
        if at <= len(inner) or line.lstrip().startswith("//"):
            raise Misunderstood(f"no place to break `{pieces[-1]}`")
        pieces[-1:] = [pieces[-1][:at], inner + pieces[-1][at + 1:]]
    return pieces


class _Array:
    """The length of a pointer field: `factor * count + more`, where `count` is a field beside it."""

    def __init__(self, count: str, factor: int = 1, more: str = ""):
        self.count, self.factor, self.more = count, factor, more

    def expression(self) -> str:
        if self.factor != 1:
            return f"std::size_t{{{self.factor}}} * {self.count}"
        return f"std::size_t{{{self.count}}} + {self.more}" if self.more else self.count


def _array(struct: dict, field: dict) -> "_Array | None":
    counts = {f["name"] for f in struct["fields"] if f["name"].endswith("_count")}
    name, doc = field["name"], field["doc"]
    singular = re.sub(r"ices$", "ex", re.sub(r"ies$", "y", name)).removesuffix("s")
    stated = re.match(r"(\w+_count)( \+ 1)?\b", doc)
    if stated and stated[1] in counts:
        return _Array(stated[1], 1, "1" if stated[2] else "")
    per = re.search(r"^(\d+|one)(?: \w+)? (?:per|for each of the) (?:given )?([a-z ]+?)(?=[,:;.(]|$)", doc)
    if f"{singular}_count" in counts:
        if per is None and _base(field["type"]) in ("float", "double"):
            return None  # of how many numbers each?
        return _Array(f"{singular}_count", int(per[1]) if per and per[1].isdigit() else 1)
    if per and f"{per[2].replace(' ', '_')}_count" in counts:
        more = "(closed != 0)" if "closed: one more" in doc and per[1] == "one" else ""
        return _Array(f"{per[2].replace(' ', '_')}_count", 1 if per[1] == "one" else int(per[1]), more)
    prefix = f"{name.split('_')[0]}_count"
    return _Array(prefix) if "_" in name and prefix in counts else None


class Wrapper:
    def __init__(self, abi: dict, parts: Path):
        self._abi = abi
        self._structs = {s["name"]: s for s in abi["structs"]}
        self._handles = {h["name"] for h in abi["handles"]} - {"FlgContext"}
        self._objects = {o["name"] for o in abi["objects"]}
        self._owners = self._handles | self._objects | {"FlgContext"}
        self._functions = {f["name"]: f for f in abi["functions"]}
        self._callbacks = {c["name"] for c in abi["callbacks"]}
        self._parts = {part.split("\n", 1)[0]: part.split("\n", 1)[1].rstrip("\n")
                       for part in parts.read_text(encoding="utf-8").split("//@ ")[1:]}
        self._outputs = self._find_outputs()
        self._views = {name for name in self._outputs if self._has_arrays(self._structs[name])}
        self._releases = {f["parameters"][-1]["type"]: f["name"] for f in abi["functions"]
                          if re.search("(Release|Destroy)$", f["name"])}

    def text(self) -> str:
        lines = [self._parts["head"]]
        lines += self._aliases()
        methods: dict[str, list[list[str]]] = {}
        free: list[list[str]] = []
        needs: dict[str, set[str]] = {name: set() for name in self._owners}
        for function in self._abi["functions"]:
            if function["name"].endswith("Init") or function["name"] in self._releases.values():
                continue
            owner = self._owner_of(function)
            text, made = self._function(function, owner)
            (methods.setdefault(owner, []) if owner else free).append(text)
            if owner in needs:
                needs[owner] |= made - {owner}
        for name in self._sorted_views():
            lines += self._view(self._structs[name], methods.pop(name, []))
        for struct in self._abi["structs"]:
            if struct["init"] and struct["name"] not in self._outputs:
                lines += self._descriptor(struct)
        for name in self._sorted(needs):
            lines += self._class(name, methods.pop(name, []))
        for text in free:
            lines += [""] + [line[4:] if line.startswith("    ") else line for line in text]
        assert not methods, methods.keys()
        lines = "\n".join(lines).split("\n")  # parts by hand have many lines in one
        return "\n".join([piece for line in lines for piece in _broken(line)] + [self._parts["tail"], ""])

    # ---- Structs -------------------------------------------------------------------------------------------------

    def _find_outputs(self) -> set[str]:
        found = set()
        for function in self._abi["functions"]:
            for p in function["parameters"]:
                out = p["name"].startswith("out_") or f"{function['name']}.{p['name']}" in _OUTPUTS
                if out and p["type"].count("*") == 1 and _base(p["type"]) in self._structs:
                    if self._structs[_base(p["type"])]["init"] and _base(p["type"]) not in _DESCRIPTORS:
                        found.add(_base(p["type"]))
        nested = {_base(f["type"]) for name in found for f in self._structs[name]["fields"]}
        return found | {name for name in nested if name.endswith("View")}

    def _has_arrays(self, struct: dict) -> bool:
        return any(self._is_array(struct, f) or _base(f["type"]).endswith("View") for f in struct["fields"])

    def _is_array(self, struct: dict, field: dict) -> bool:
        if f"{struct['name']}.{field['name']}" in _POINTERS:
            return False
        kind = field["type"]
        return kind.startswith("const ") and kind.endswith("*") and kind != "const char*" and not self._is_nested(field)

    def _is_nested(self, field: dict) -> bool:
        """A view in a view, embedded or pointed at."""
        return _base(field["type"]) in self._structs and _base(field["type"]).endswith("View")

    def _aliases(self) -> list[str]:
        lines = []
        for enum in self._abi["enums"]:
            lines += [""] + _doc(enum["doc"] or f"{enum['name']} of the C ABI.")
            lines.append(f"using {_ALIASES.get(enum['name'], enum['name'][3:])} = {enum['name']};")
        for struct in self._abi["structs"]:
            if struct["name"] in self._views or (struct["init"] and struct["name"] not in self._outputs):
                continue
            lines += [""] + _doc(struct["doc"] or f"{struct['name']} of the C ABI.")
            lines.append(f"using {struct['name'][3:]} = {struct['name']};")
        return lines

    def _sorted_views(self) -> list[str]:
        done: list[str] = []

        def visit(name: str) -> None:
            if name not in done:
                for field in self._structs[name]["fields"]:
                    if self._is_nested(field):
                        visit(_base(field["type"]))
                done.append(name)

        for struct in self._abi["structs"]:
            if struct["name"] in self._views:
                visit(struct["name"])
        return done

    def _view(self, struct: dict, methods: list[list[str]]) -> list[str]:
        name, c_name = struct["name"][3:], struct["name"]
        lines = [""] + _doc(struct["doc"] or f"What {c_name} shows.") + [f"struct {name} {{"]
        plain, nested, arrays = [], [], []
        for field in struct["fields"]:
            if field["name"] in ("struct_size", "reserved"):
                continue
            kind, member = field["type"], field["name"]
            doc = _doc(field["doc"] or f"{c_name}::{member}.", "    ")
            if self._is_nested(field):
                lines += doc + [f"    {_base(kind)[3:]} {member};"]
                value = f"c.{member}" if not kind.endswith("*") else None
                nested.append(f"{member} = {value};" if value else f"if (c.{member}) {member} = *c.{member};")
            elif self._is_array(struct, field):
                element = kind[:-1]
                length = _LENGTHS.get(f"{c_name}.{member}")
                if length is None:
                    array = _array(struct, field)
                    if array is None:
                        raise Misunderstood(f"{c_name}.{member}: how long is it? Neither a count beside it nor its comment "
                                            "says so, nor _LENGTHS of tools/abi/cpp.py")
                    length = array.expression()
                lines += doc + [f"    Span<{element}> {member};"]
                arrays.append(f"{member} = detail::span(c.{member}, {length});")
            elif field["count"] != 1:
                lines += doc + [f"    {kind} {member}[{field['count']}]{{}};"]
                plain.append(f"for (int i = 0; i < {field['count']}; ++i) {member}[i] = c.{member}[i];")
            else:
                lines += doc + [f"    {kind} {member}{{}};"]
                plain.append(f"{member} = c.{member};")
        lines += ["", "    /// Empty.", f"    {name}() {{ {struct['init']}(&c_, detail::size_of<{c_name}>); }}",
                  "    /// Of the C struct.", f"    {name}(const {c_name}& c) : c_(c) {{"]
        lines += [f"        {line}" for line in plain + nested + arrays] + ["    }"]
        lines += ["    /// The C struct, for C functions.", f"    const {c_name}& get() const noexcept {{ return c_; }}",
                  "    /// The C struct.", f"    operator {c_name}() const noexcept {{ return c_; }}"]
        for method in methods:
            lines += [""] + method
        if name in self._parts:
            lines += ["", self._parts[name]]
        return lines + ["", "private:", f"    {c_name} c_;", "};"]

    def _descriptor(self, struct: dict) -> list[str]:
        c_name, name = struct["name"], struct["name"][3:]
        sized = len(self._functions[struct["init"]]["parameters"]) == 2
        init = f"{struct['init']}(this" + (f", detail::size_of<{c_name}>" if sized else "") + ");"
        lines = [""] + _doc(struct["doc"] or f"{c_name} with its defaults.") + [f"struct {name} : {c_name} {{"]
        lines += ["    /// The defaults.", f"    {name}() {{ {init} }}"]
        lines += ["    /// Of the C struct.", f"    {name}(const {c_name}& c) : {c_name}(c) {{}}"]
        needed = self._needed(struct)
        if needed:
            names = [f["name"] for f in needed]
            parameters = ", ".join(f"{f['type']} {f['name']}_" for f in needed)
            lines += [f"    /// The defaults, with {' and '.join(names)}.", f"    {name}({parameters}) {{", f"        {init}"]
            lines += [f"        {n} = {n}_;" for n in names] + ["    }"]
        for field in struct["fields"]:
            array = _array(struct, field) if self._is_array(struct, field) else None
            kind = field["type"][:-1]
            if not array or array.more.startswith("("):
                continue
            count = "values.size()" + (f", {array.factor}" if array.factor != 1 else "")
            if array.more:
                count = "values.empty() ? 0 : values.size() - 1"
            doc = f"Sets {field['name']} and {array.count}. The array must live until the descriptor is used."
            lines += _doc(doc, "    ")
            lines += [f"    void set_{field['name']}(Span<{kind}> values) {{",
                      f"        {field['name']} = values.data();",
                      f"        {array.count} = detail::count({count});", "    }"]
            if not kind.endswith("*") and not kind.endswith("* const"):
                lines += ["    /// A list would end before the descriptor is used.",
                          f"    void set_{field['name']}(std::initializer_list<{_base(kind)}>) = delete;"]
        return lines + ["};"]

    def _needed(self, struct: dict) -> list[dict]:
        """The handles right at its beginning, behind size, one more number and options: those that may not be null."""
        fields = list(struct["fields"])
        if fields[0]["name"] == "struct_size":
            fields = fields[2:] if fields[1]["size"] == 4 else fields[1:]
        if fields and fields[0]["name"] == "job":
            fields = fields[1:]
        needed = []
        for field in fields:
            if field["type"] not in self._handles or re.search(r"\b[Nn]ull\b", field["doc"]):
                break
            needed.append(field)
        return needed

    # ---- Functions -----------------------------------------------------------------------------------------------

    def _noun_is(self, function: dict, type_name: str) -> bool:
        return re.match(rf"flg{type_name[3:]}(?![a-z])", function["name"]) is not None

    def _owner_of(self, function: dict) -> str:
        """The class a function belongs to; "" for none."""
        parameters = function["parameters"]
        types = [p["type"] for p in parameters]
        if types and types[0] == "FlgContext":
            second = types[1] if len(types) > 1 else ""
            longest = max((o for o in self._owners if self._noun_is(function, o)), key=len, default="")
            if longest and "Create" not in function["name"] and longest in (second, self._described(second)):
                return longest
            return "FlgContext"
        if types and types[0] in self._objects:
            return types[0]
        for owner in sorted(self._owners, key=len, reverse=True):
            if self._noun_is(function, owner) and (owner in self._objects or f"{owner}*" in types):
                return owner
        view = _base(types[0]) if types and types[0].startswith("const ") else ""
        return view if view in self._views and self._noun_is(function, view.removesuffix("View")) else ""

    def _described(self, spelled: str) -> str:
        """The one handle that a descriptor needs."""
        struct = self._structs.get(_base(spelled))
        needed = self._needed(struct) if struct and spelled.endswith("Desc*") else []
        return needed[0]["type"] if len(needed) == 1 else ""

    def _name(self, function: dict, owner: str) -> str:
        name = function["name"][3:]
        if owner == "FlgContext" and not name.startswith("Context"):
            noun = max((o[3:] for o in self._owners if self._noun_is(function, o)), key=len, default="")
            rest = name[len(noun):]
            return _snake(noun + rest[len("Create"):]) if rest.startswith("Create") else _snake(rest)
        if owner:
            noun = owner[3:] if self._noun_is(function, owner) else owner[3:].removesuffix("View")
            return _snake(name[len(noun):].removeprefix("Get"))
        return _snake(re.sub(r"Get(?=[A-Z]|$)", "", name))

    def _function(self, function: dict, owner: str) -> tuple[list[str], set[str]]:
        call = _Call(self, function, owner)
        return call.text(), call.owners

    def _class(self, c_name: str, methods: list[list[str]]) -> list[str]:
        name = c_name[3:]
        place = next(i for kind in ("handles", "objects") for i in self._abi[kind] if i["name"] == c_name)
        if c_name == "FlgContext":
            base = "detail::ContextOwner"
        else:
            kind = "Owner" if c_name in self._handles else "Object"
            base = f"detail::{kind}<{c_name}, {self._releases[c_name]}>"
        lines = [""] + _doc(place["doc"] or f"Owns a {c_name}.") + [f"class {name} : public {base} {{", "public:"]
        short = base.split("::")[1].split("<")[0]
        lines.append(f"    using {short}::{short};")
        for method in methods:
            lines += [""] + method
        ready = self._ready(c_name)
        if ready:
            function, struct = ready
            lines += ["", f"    /// Whether {function}() has something to show. Fails as the job that makes it did.",
                      "    Result<bool> ready() const {", f"        {struct} shown;",
                      f"        {self._structs[struct]['init']}(&shown, detail::size_of<{struct}>);",
                      f"        return detail::done(flg{name}Get{function.capitalize()}(context_, handle_, &shown));", "    }"]
        if name in self._parts:
            lines += ["", self._parts[name]]
        return lines + ["};"]

    def _ready(self, c_name: str) -> "tuple[str, str] | None":
        if c_name not in self._handles:
            return None
        for what in ("View", "Info"):
            function = self._functions.get(f"flg{c_name[3:]}Get{what}")
            if function and (what == "View" or "FLG_NOT_READY until" in function["doc"]):
                return what.lower(), _base(function["parameters"][-1]["type"])
        return None

    def _sorted(self, needs: dict[str, set[str]]) -> list[str]:
        done: list[str] = []

        def visit(name: str, above: tuple) -> None:
            if name in above:
                raise Misunderstood(f"{name} makes what makes it: {above}")
            if name not in done:
                for needed in sorted(needs[name]):
                    visit(needed, above + (name,))
                done.append(name)

        for name in [i["name"] for kind in ("handles", "objects") for i in self._abi[kind] if i["name"] != "FlgContext"]:
            visit(name, ())
        visit("FlgContext", ())
        return done


class _Call:
    """One function: its C++ parameters, the C arguments, and what becomes of the outputs."""

    def __init__(self, wrapper: Wrapper, function: dict, owner: str):
        self._wrapper, self._function, self._owner = wrapper, function, owner
        self.owners: set[str] = set()
        self._parameters: list[str] = []
        self._before: list[str] = []
        self._arguments: list[str] = []
        self._after: list[str] = []
        self._results: list[tuple[str, str, str]] = []  # C++ type, expression, name
        self._fill = ""  # the element type of an array that is filled up to a capacity
        self._static = True
        self._parse()

    def _default(self, name: str, otherwise: "str | None" = None) -> str:
        value = _DEFAULTS.get(f"{self._function['name']}.{name}", otherwise)
        return f" = {value}" if value is not None else ""

    def _parse(self) -> None:
        parameters = list(self._function["parameters"])
        w, owner = self._wrapper, self._owner
        context = "handle_" if owner == "FlgContext" else "context_"
        if parameters and parameters[0]["type"] == "FlgContext":
            self._static = False
            parameters.pop(0)
            self._arguments.append(context)
            if owner in w._handles and parameters[0]["type"] == owner:
                parameters.pop(0)
                self._arguments.append("handle_")
            elif owner in w._handles:  # its place is in the descriptor
                desc = parameters.pop(0)
                kind = _base(desc["type"])
                self._parameters.append(f"{kind[3:]} {desc['name']} = {{}}")
                self._before.append(f"{desc['name']}.{w._needed(w._structs[kind])[0]['name']} = handle_;")
                self._arguments.append(f"&{desc['name']}")
        elif parameters and owner in w._objects and parameters[0]["type"] == owner:
            self._static = False
            parameters.pop(0)
            self._arguments.append("handle_")
        elif owner in w._views:
            self._static = False
            parameters.pop(0)
            self._arguments.append("&c_")
        while parameters:
            self._parameter(parameters, context)

    def _parameter(self, rest: list[dict], context: str) -> None:
        w = self._wrapper
        p = rest.pop(0)
        name, kind, base = p["name"], p["type"], _base(p["type"])
        struct = w._structs.get(base)
        after = rest[0] if rest else {"name": "", "type": ""}
        counted = after["type"] in ("uint32_t", "size_t") and (
            after["name"] in ("count", "size") or after["name"].endswith("_count"))
        counted = counted and not (struct and not name.endswith("s"))  # one struct, and a number of something else
        out = name.startswith("out_") or f"{self._function['name']}.{name}" in _OUTPUTS
        short = name.removeprefix("out_")
        if out and base == "FlgJob" and not self._results:  # all there is: it may be let go of
            self.owners.add(base)
            self._before.append(f"FlgJob {name}{{}};")
            self._arguments.append(f"&{name}")
            self._results.append(("Job", f"Job({context}, {name})", short))
        elif out and base == "FlgJob":
            self.owners.add("FlgJob")
            self._parameters.append("Job* out_job = nullptr")
            self._before.append("FlgJob job_made{};")
            self._arguments.append("out_job ? &job_made : nullptr")
            self._after.append(f"if (out_job) *out_job = Job({context}, job_made);")
        elif out and base in w._owners:
            self.owners.add(base)
            self._before.append(f"{base} {name}{{}};")
            self._arguments.append(f"&{name}")
            made = f"{base[3:]}({context}, {name})" if base in w._handles else f"{base[3:]}({name})"
            self._results.append((base[3:], made, short))
        elif out and kind.endswith("**") and after["type"].endswith("*"):  # an array of the library's own, and its count
            rest.pop(0)
            element = kind[:-2]
            self._before += [f"{element}* {name} = nullptr;", "uint32_t count = 0;"]
            self._arguments += [f"&{name}", "&count"]
            self._results.append((f"Span<{element}>", f"detail::span({name}, count)", short))
        elif out and struct and struct["init"]:
            self._before += [f"{base} {name};", f"{struct['init']}(&{name}, detail::size_of<{base}>);"]
            self._arguments.append(f"&{name}")
            self._results.append((base[3:], f"{base[3:]}({name})" if base in w._views or base in _DESCRIPTORS else name,
                                  short))
        elif out and after["name"] == "capacity":  # filled as far as it goes; the count is that of all
            rest.pop(0)
            total = rest.pop(0)
            self._fill = "uint8_t" if base == "void" else base
            size = "values.size()" if total["type"] == "size_t*" else "detail::count(values.size())"
            self._parameters.append(f"Span<{self._fill}> values")
            self._before.append(f"{_base(total['type'])} count{{}};")
            self._arguments += ["values.data()", size, "&count"]
            self._results.append(("std::size_t", "std::size_t{count}", "count"))
        elif out and kind.endswith("*") and not struct and short.endswith("count"):
            self._before.append(f"{base} {name}{{}};")
            self._arguments.append(f"&{name}")
            self._results.append((base, name, short))
        elif out and struct and not short.endswith("s"):
            self._before.append(f"{base} {name}{{}};")
            self._arguments.append(f"&{name}")
            self._results.append((base[3:], name, short))
        elif kind == "const FlgJobOptions*":
            self._parameters.append(f"const FlgJobOptions* {name} = nullptr")
            self._arguments.append(name)
        elif kind.endswith("*") and counted and kind != "const char*":
            rest.pop(0)
            element = kind[:-1]
            if base == "void":
                element = element.replace("void", "uint8_t")
            factor = _FACTORS.get(f"{self._function['name']}.{name}", 1)
            size = f"{name}.size()"
            if after["type"] == "uint32_t" or factor != 1:
                size = f"detail::count({size}{f', {factor}' if factor != 1 else ''})"
            if self._function["name"] == "flgManifoldProject":  # of 2, 3 or 4 numbers a point: the caller counts
                self._parameters += [f"{kind} {name}", f"uint32_t {after['name']}"]
                self._arguments += [name, after["name"]]
                return
            self._parameters.append(f"Span<{element}> {name}" + self._default(name))
            self._arguments += [f"{name}.data()", size]
        elif kind.startswith("const Flg") and struct and struct["init"] and kind.endswith("*"):
            null = f"`{name}` may be null" in self._function["doc"]
            if null and base not in w._outputs and base.endswith("Desc"):
                self._parameters.append(f"const {base[3:]}& {name} = {base[3:]}()")
                self._arguments.append(f"&{name}")
            elif null:
                self._parameters.append(f"const {base}* {name} = nullptr")
                self._arguments.append(name)
            else:
                own = base[3:] if base not in w._outputs else base
                self._parameters.append(f"const {own}& {name}")
                self._arguments.append(f"&{name}")
        elif kind.endswith("*") and struct and struct["init"]:
            null = f"{self._function['name']}.{name}" in _NULLABLE
            self._parameters.append(f"{base}* {name}" if null else f"{base}& {name}")
            self._arguments.append(name if null else f"&{name}")
        else:
            declared = f"{kind} {name}[{p['count']}]" if p["count"] != 1 else f"{kind} {name}"
            self._parameters.append(declared + self._default(name))
            self._arguments.append(name)

    def _parameter_list(self) -> str:
        """Defaults only at the end."""
        out, optional = [], True
        for parameter in reversed(self._parameters):
            optional = optional and " = " in parameter
            out.append(parameter if optional else parameter.split(" = ")[0])
        return ", ".join(reversed(out))

    def text(self) -> list[str]:
        f, w = self._function, self._wrapper
        name = w._name(f, self._owner)
        doc = _doc(f"{f['doc']}\n\nCalls {f['name']}.".strip(), "    ")
        call = f"{f['name']}({', '.join(self._arguments)})"
        head = ("static " if self._owner and self._static else "" if self._owner else "inline ")
        tail = "" if self._static else " const"
        if f["returns"] != "FlgResult":
            lines = doc + self._signature(f"{head}{f['returns']} {name}", tail)
            return lines + [f"        return {call};", "    }"]
        made = _FAILURES[f["library"]]
        structs: list[str] = []
        if not self._results:
            kind, give = "bool", f"return detail::done{made}(result);"
        elif len(self._results) == 1:
            kind = self._results[0][0]
            give = f"return detail::made{made}(result, {self._results[0][1]});"
        else:
            kind = f["name"][3 + len(self._owner[3:]):] + "Results"
            structs = [f"    /// What {name}() makes.", f"    struct {kind} {{"]
            structs += [f"        {k} {n};  ///< out_{n} of {f['name']}" for k, _, n in self._results] + ["    };"]
            values = ", ".join(e for _, e, _ in self._results)
            give = f"return detail::made{made}(result, {kind}{{{values}}});"
        lines = structs + doc + self._signature(f"{head}Result<{kind}> {name}", tail)
        lines += [f"        {line}" for line in self._before]
        lines.append(f"        const FlgResult result = {call};")
        lines += [f"        {line}" for line in self._after] + [f"        {give}", "    }"]
        return lines + (self._vector(name, made, tail) if self._fill else [])

    def _signature(self, head: str, tail: str) -> list[str]:
        return [f"    {head}({self._parameter_list()}){tail} {{"]

    def _vector(self, name: str, made: str, tail: str) -> list[str]:
        """The same, into an array that is as large as it has to be."""
        names = [re.split(r"[ *&]", p.split(" = ")[0])[-1] for p in self._parameters if not p.startswith("Span")]
        others = ", ".join(p for p in self._parameters if not p.startswith("Span"))
        context = "context_" if self._owner in self._wrapper._handles else "handle_"
        call = ", ".join([context, "handle_", *names])
        total = "std::size_t" if self._fill == "uint8_t" else "uint32_t"
        lines = [f"    /// All of them, by two calls of {self._function['name']}; empty if not ready.",
                 f"    Result<std::vector<{self._fill}>> {name}({others}){tail} {{", f"        {total} count{{}};",
                 f"        FlgResult result = {self._function['name']}({call}, nullptr, 0, &count);",
                 f"        std::vector<{self._fill}> values(result == FLG_OK ? count : 0);",
                 "        if (!values.empty()) {",
                 f"            result = {self._function['name']}({call}, values.data(), count, &count);", "        }",
                 f"        return detail::made{made}(result, std::move(values));", "    }"]
        return lines
