#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Takes the examples out of pages, so that a compiler can judge them.

    extract_examples.py OUT PAGE.md...

Each fenced block of C or C++ says in its first line what it is:

    ```c complete   a whole program: OUT/complete/PAGE_N.c, to be compiled and run
    ```c part       code at file scope: OUT/part/PAGE_N.c, to be compiled, after all public headers
    ```c inside     statements of a function: the same, within one. What they take as given is declared in a comment
                    right before the block, which readers of the page do not see: <!-- given FlgContext context; -->

A block of C or C++ that says nothing is an error. Files that have not changed are not written again; files that no page
holds any more are removed.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FENCE = re.compile(r"^```(c|cpp)\b ?(.*)$")
KINDS = ("complete", "part", "inside")
GIVEN = re.compile(r"<!-- given\s(.*?)-->\s*$", re.DOTALL)


def preamble(language):
    lines = ["#include <filigree/filigree_all.h>"]
    if language == "cpp":
        lines.append("#include <filigree/filigree.hpp>")
    standard = ["<stdio.h>", "<stdlib.h>", "<string.h>", "<math.h>"]
    return "\n".join([f"#include {name}" for name in standard] + lines) + "\n"


def examples(page):
    """(language, kind, first line's number, text, what is given) of each example of a page."""
    found, block, before = [], None, ""
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if block is None:
            match = FENCE.match(line)
            if match:
                language, kind = match.groups()
                if kind not in KINDS:
                    raise SystemExit(f"{page}:{number}: the block does not say whether it is {', '.join(KINDS)}")
                given = GIVEN.search(before)
                block = (language, kind, number + 1, [], given.group(1) if given else "")
            before += line + "\n"
        elif line == "```":
            found.append((*block[:3], "\n".join(block[3]) + "\n", block[4]))
            block, before = None, ""
        else:
            block[3].append(line)
    if block is not None:
        raise SystemExit(f"{page}: the example at line {block[2]} has no end")
    return found


def name_of(page):
    """That of a page of sdk/docs; of another README, with its folders."""
    place = page.resolve().relative_to(ROOT).with_suffix("")
    return "_".join(place.parts) if place.name == "README" else place.name


def content_of(page, language, kind, line, text, given):
    mark = f'#line {line} "{page.name}"\n'
    if kind == "complete":
        return mark + text
    if kind == "part":
        return preamble(language) + mark + text
    function = f"void inside_{name_of(page)}_{line}(void)"
    return f"{preamble(language)}{given}\n{function};\n{function} {{\n{mark}{text}}}\n"


def main():
    out, pages = pathlib.Path(sys.argv[1]), [pathlib.Path(name) for name in sys.argv[2:]]
    written = set()
    for page in pages:
        for index, (language, kind, line, text, given) in enumerate(examples(page), 1):
            folder = "complete" if kind == "complete" else "part"
            path = out / folder / f"{name_of(page)}_{index}.{language}"
            content = content_of(page, language, kind, line, text, given)
            written.add(path)
            path.parent.mkdir(parents=True, exist_ok=True)
            if not path.exists() or path.read_text(encoding="utf-8") != content:
                path.write_text(content, encoding="utf-8")
    for path in out.glob("*/*"):
        if path not in written:
            path.unlink()


main()
