# SPDX-License-Identifier: MIT
"""filigree.hpp for Doxygen: its comments as documentation, and for functions without one what they call.

The wrapper does nothing that the C functions don't do; so a function is explained by the first of these in its body, an
owner by the handle it owns.
"""
import re

CALL = re.compile(r"\b(flg[A-Z]\w+)\b(?<!Defaults)")
OWNER = re.compile(r"^class (\w+) : public detail::Owner<(\w+), \w+>")
VIEWED = re.compile(r"^using (\w+) =")
FUNCTION = re.compile(r"^    (?=\S)(?:explicit |inline |static )?[\w:<>~&, ]*?(~?\w+|operator[ =\w]+)\(.*[{;]")
KNOWN = {
    "get": "The C handle, to be used beside.",
    "ready": "Whether its view may be looked at. Throws what its job failed with.",
    "finish": "Ticks until no job is left: for tools, not for frames.",
}


def body_of(lines, at):
    """The lines of the function that begins at `at`, as far as its closing brace."""
    end = at
    while end + 1 < len(lines) and not re.match(r"^    \}|^    .*\}$", lines[end]):
        end += 1
    return "\n".join(lines[at:end + 1])


def text_of(lines, at, name, owner):
    if name in KNOWN:
        return KNOWN[name]
    if name.startswith("operator"):
        return "Moves; what was owned is released by the other." if "=" in name else "Whether it owns anything."
    if name.startswith("~"):
        return "Releases what it owns."
    if name == owner:
        return "Moves." if "&&" in lines[at] else "Makes it; throws Error."
    body = body_of(lines, at)
    called = CALL.search(body)
    return f"Calls {called.group(1)}()." if called else ""


def documented(text):
    """The header with its line numbers as they were."""
    lines = text.split("\n")
    out, comment, scope, hidden = [], False, "", False
    for at, line in enumerate(lines):
        prefix = ""
        is_comment = re.match(r"^\s*// ", line) is not None
        type_line = re.match(r"^(?:class|    struct) (\w+)", line)
        if type_line and not line.startswith("    "):
            scope, hidden = type_line.group(1), line.startswith("class")
        if re.match(r"^(public|private|protected):", line):
            hidden = not line.startswith("public")
        function = FUNCTION.match(line)
        if not comment and not is_comment and OWNER.match(line):
            prefix = f"Owns an {OWNER.match(line).group(2)}."
        elif not comment and not is_comment and VIEWED.match(line):
            prefix = f"Owns an Flg{VIEWED.match(line).group(1)}."
        elif not comment and not is_comment and not hidden and scope and function and "using " not in line:
            prefix = text_of(lines, at, function.group(1).strip(), scope)
        out.append(f"/** {prefix} */ {line}" if prefix else line)
        comment = is_comment
        if line.startswith("}"):
            scope = ""
    text = "\n".join(out)
    text = re.sub(r"^( {8}\w.*;) +// ", r"\1  ///< ", text, flags=re.M)
    text = re.sub(r"^(\s*)// (?!clang-format|SPDX|namespace)", r"\1/// ", text, flags=re.M)
    text = re.sub(r"^// SPDX.*\n// SPDX.*\n//\n///", "/// @file filigree.hpp\n///\n///\n///", text)
    return re.sub(r"^//$", "///", text, flags=re.M)
