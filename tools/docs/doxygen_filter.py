#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What Doxygen reads in place of headers and pages (its INPUT_FILTER): the same, lines being nearly where they were.

Headers: plain comments become documentation, those behind code that of what stands before them; sections become topics.
What the grammar of filigree.h says of all descriptors is said for each: `struct_size`, `reserved`, counts, functions
that give defaults. Anything else without a comment stays without one, so that Doxygen warns of it.

Pages: links that lead out of sdk/docs become words, as the reference is read without the repository.
"""
import functools
import json
import pathlib
import re
import sys

sys.dont_write_bytecode = True  # the sources' folder stays as it is

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMENT = re.compile(r"/\*.*?\*/", re.S)
SECTION = re.compile(r"/\* -{3,} (.+?)(?: -{3,})?\s*(?:\n \* -{3,})?\s*(?:\n(?P<rest>.*?))?\*/", re.S)
COLUMNS = re.compile(r"^\s{0,7}(\S(?:\S| (?! ))*)\s{2,}(\S.*)$")  # `word   what it means`
FIELD = re.compile(r"^    [\w* ]*[ *](\w+)(?:\[\w+\])?;$")
TWO_FIELDS = re.compile(r"^    (\w+) (\w+)(\[\w+\])?, (\w+)(\[\w+\])?;( */\*\*< .*?\*/)?", re.M | re.S)


# ---- text of comments ------------------------------------------------------------------------------------------------

def escaped(text):
    """Outside of code marks nothing is a command, a tag or a link by accident."""
    parts = re.split(r"(`[^`]*`)", text)
    parts[::2] = [re.sub(r"([\\@#<>&])", r"\\\1", part) for part in parts[::2]]
    # A brief ends at the first full stop before a space: not at an abbreviation's.
    return re.sub(r"\b(sec|Fig|Eq|al)\. (?=[0-9A-Z(])", r"\1.\\ ", "".join(parts))


def documentation(text):
    """The lines of a comment's inside as Markdown: two columns become lists, four spaces stay code."""
    lines, in_list, in_code, before = [], False, False, ""
    for line in text.split("\n"):
        body = re.sub(r"^ \*(?: |$)", "", line)
        columns = COLUMNS.match(body)
        indent = len(body) - len(body.lstrip())
        in_code = indent >= 4 and not in_list and (in_code or not before.strip())
        if not body.strip():
            lines.append("")
        elif in_code:
            lines.append(body)
        elif columns and (in_list or not before.strip() or indent > 0):
            in_list = True
            lines.append(f"- <b>{escaped(columns.group(1))}</b> {escaped(columns.group(2))}")
        elif in_list and indent >= 2:
            lines.append("  " + escaped(body.strip()))
        else:
            lines.append("\n" * in_list + escaped(body.strip()))  # what follows a list is no part of it
            in_list = False
        before = body
    return "\n".join(lines)


# ---- headers ---------------------------------------------------------------------------------------------------------

@functools.cache
def uses_of_structs():
    """struct -> (functions that are given it, functions that fill it)"""
    abi = json.loads((ROOT / "sdk/api/abi.json").read_text(encoding="utf-8"))
    uses = {}
    for function in abi["functions"]:
        for parameter in function["parameters"]:
            name = parameter["type"].replace("const ", "").rstrip("*")
            if parameter["type"].endswith("*") and not function["name"].endswith("Init"):
                given = parameter["type"].startswith("const ")
                uses.setdefault(name, ([], []))[0 if given else 1].append(function["name"] + "()")
    return uses


def struct_text(name):
    given, filled = uses_of_structs().get(name, ([], []))
    if given:
        return f"What {' and '.join(given[:2])} {'is' if len(given) == 1 else 'are'} asked for."
    return f"What {' and '.join(filled[:2])} {'tells' if len(filled) == 1 else 'tell'}." if filled else ""


def field_text(name, line):
    """What the grammar says of a field, or nothing."""
    if name == "struct_size":
        return "The size of this struct as the host knows it: set by its Init function, else by the host."
    if re.match(r"reserved\d?$", name):
        return "Nothing yet: 0."
    if line.lstrip().startswith("FlgJobOptions "):
        return "How the job is run."
    if name == "user_data":
        return "Passed to the function."
    if name.endswith("_count"):
        words = name[:-6].replace("_", " ")
        return f"How many {words[:-2] + 'ices' if words.endswith('ex') else words + 's'} there are."
    type_name = re.match(r"\s*(?:const )?(Flg\w+)\*? ", line)
    return f"See {type_name.group(1)}." if type_name else ""


def function_text(line):
    name = re.search(r"(flg\w+)\(", line).group(1)
    init = re.match(r"FLG_API \w+ (flg\w+)Init\((Flg\w+)\*", line)
    if init:
        return f"Fills an {init.group(2)} with its defaults."
    if line.startswith("static inline"):
        return f"An {re.match(r'static inline (Flg[A-Za-z]+)', line).group(1)} with its defaults."
    if name.endswith("Release"):
        return "Gives the handle back, and its views. What needs the thing behind it keeps it until it is done."
    return ""


def one_field_each(match):
    """`float a, b; about both` as two fields, so that both are documented."""
    type_name, first, first_size, second, second_size, about = match.groups()
    first_about = about.replace("\n", " ") if about else ""
    second_about = about or f" /**< See {first}. */"
    return (f"    {type_name} {first}{first_size or ''};{first_about}"
            f" {type_name} {second}{second_size or ''};{second_about}")


def with_common_texts(text):
    """Declarations without a comment get what is said of all of their kind, in their own line."""
    lines, before, in_struct, behind_code = [], "", False, False
    for line in text.split("\n"):
        documented = before.endswith("*/") and not behind_code and not before.endswith(("@{ */", "@} */"))
        struct = re.match(r"typedef struct (Flg\w+) \{$", line)
        common = ""
        if struct and not documented:
            common = struct_text(struct.group(1))
        elif re.match(r"FLG_API |static inline ", line) and not documented:
            common = function_text(line)
        elif in_struct and not documented and FIELD.match(line):
            common = field_text(FIELD.match(line).group(1), line)
        if struct:
            in_struct = True
        elif line.startswith("}"):
            in_struct = False
        lines.append(f"/** {common} */ {line}" if common else line)
        if line.strip():
            before = line.rstrip()
        if "/**" in line:
            behind_code = line[line.rindex("/**"):].startswith("/**<")
    return "\n".join(lines)


def header(path, text):
    name, pieces, at, sections = path.name, [], 0, 0
    for match in COMMENT.finditer(text):
        pieces.append(text[at:match.start()])
        at, comment = match.end(), match.group(0)
        section = SECTION.fullmatch(comment)
        line_before = text[text.rfind("\n", 0, match.start()) + 1:match.start()]
        if match.start() == 0:
            body = documentation(re.sub(r" \* SPDX.*\n|^/\* SPDX.*\n|\*/$", "", comment, flags=re.M).lstrip(" *\n"))
            pieces.append(f"/** @file {name}\n{body}*/")
            pieces.append("\n" * (comment.count("\n") - pieces[-1].count("\n")))
        elif section:
            topic = f"{path.stem}_{sections}"
            end = "/** @} */ " if sections else ""
            rest = "\n" + documentation(section.group("rest")).rstrip() if section.group("rest") else ""
            title = f"{name.removesuffix('.h').removeprefix('filigree_')}: {section.group(1).strip()}"
            pieces.append(f"{end}/** @defgroup {topic} {title}{rest}\n@{{ */")
            at += text.startswith("\n\n", at)  # the line that was added
            sections += 1
        elif line_before.strip():
            pieces.append("/**< " + documentation(comment[2:-2].strip()) + " */")
        else:
            inside = re.sub(r"^\[any thread\] ", "", comment[2:-2].strip())
            thread = "__Any thread__: " if "[any thread]" in comment[:20] else ""
            pieces.append("/** " + thread + documentation(inside) + " */")
    text = "".join(pieces) + text[at:]
    text = re.sub(r"^FLG_HANDLE\((\w+)\);", r"typedef struct \1 { uint64_t id; /**< 0: none */ } \1;", text, flags=re.M)
    text = re.sub(r",?(\s*/\*\*<[^/]*\*/)?\n +FLG_\w+_FORCE_32BIT = 0x7fffffff\n", r"\1\n\n", text)
    text = with_common_texts(TWO_FIELDS.sub(one_field_each, text))
    return text.replace("\n\n#ifdef __cplusplus\n}", "\n/** @} */\n#ifdef __cplusplus\n}") if sections else text


# ---- pages -----------------------------------------------------------------------------------------------------------

def words_for_link(match):
    target = (ROOT / "sdk/docs" / match.group(2)).resolve().relative_to(ROOT)
    return f"`{target}`" if str(target).startswith(match.group(1)) else f"{match.group(1)} (`{target}`)"


def page(text):
    text = re.sub(r"^```(c|cpp) (complete|part)$", r"```\1", text, flags=re.M)
    text = re.sub(r"!\[([^\]]*)\]\([^)]*/([^/)]+)\)", r"![\1](\2)", text)
    text = re.sub(r"(?<!!)\[([^\]]*)\]\((\.\./[^)#]*)[^)]*\)", words_for_link, text)
    text = re.sub(r"\]\((\w+\.md)#([\w-]+)\)", r"](\1)", text)
    text = re.sub(r"\[([^\]]*)\]\(#[\w-]+\)", r"\1", text)
    return re.sub(r"<!--.*?-->", "", text, flags=re.S)


def wrapper(text):
    """filigree.hpp has documentation's own comments; only their text is escaped, but for code, four spaces in."""
    return re.sub(r"^( *///<? (?!    ))(.*)$|( ///< )(.*)$",
                  lambda line: (line[1] or line[3]) + escaped(line[2] or line[4] or "").replace("\\@file", "@file"),
                  text, flags=re.M)


path = pathlib.Path(sys.argv[1])
source = path.read_text(encoding="utf-8")
if path.suffix == ".hpp":
    sys.stdout.write(wrapper(source))
else:
    sys.stdout.write(page(source) if path.suffix == ".md" else header(path, source))
