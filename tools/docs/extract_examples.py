#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Takes the examples out of the pages of sdk/docs, so that a compiler can judge them.

    extract_examples.py OUT PAGE.md...

A fenced block whose first line reads ```c complete (or ```cpp complete) is a whole program: OUT/complete/PAGE_N.c, to
be compiled and run. One that reads ```c part is code at file scope: OUT/part/PAGE_N.c, to be compiled, after all public
headers.
Files that have not changed are not written again; files that no page holds any more are removed.
"""
import pathlib
import re
import sys

FENCE = re.compile(r"^```(c|cpp) (complete|part)$")
HEADERS = ("filigree", "filigree_live", "filigree_surface", "filigree_project", "filigree_tangle", "filigree_spline",
           "filigree_motion", "filigree_skeleton", "filigree_model", "filigree_io", "filigree_pick")


def preamble(language):
    lines = [f"#include <filigree/{header}.h>" for header in HEADERS]
    if language == "cpp":
        lines.append("#include <filigree/filigree.hpp>")
    standard = ["<stdio.h>", "<stdlib.h>", "<string.h>", "<math.h>"]
    return "\n".join([f"#include {name}" for name in standard] + lines) + "\n"


def examples(page):
    """(language, kind, first line's number, text) of each example of a page."""
    found, block = [], None
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if block is None:
            match = FENCE.match(line)
            if match:
                block = (match.group(1), match.group(2), number + 1, [])
        elif line == "```":
            found.append((*block[:3], "\n".join(block[3]) + "\n"))
            block = None
        else:
            block[3].append(line)
    if block is not None:
        raise SystemExit(f"{page}: the example at line {block[2]} has no end")
    return found


def main():
    out, pages = pathlib.Path(sys.argv[1]), [pathlib.Path(name) for name in sys.argv[2:]]
    written = set()
    for page in pages:
        for index, (language, kind, line, text) in enumerate(examples(page), 1):
            path = out / kind / f"{page.stem}_{index}.{language}"
            head = preamble(language) if kind == "part" else ""
            content = f'{head}#line {line} "{page.name}"\n{text}'
            written.add(path)
            path.parent.mkdir(parents=True, exist_ok=True)
            if not path.exists() or path.read_text(encoding="utf-8") != content:
                path.write_text(content, encoding="utf-8")
    for path in out.glob("*/*"):
        if path not in written:
            path.unlink()


main()
