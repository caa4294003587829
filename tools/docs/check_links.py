#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that the relative links of all pages lead somewhere: to a file or folder, and to a heading in it.

    check_links.py ROOT

Prints each link that does not, and ends with status 1 if there is one. Links out of the project are not followed.
"""
import functools
import pathlib
import re
import sys

LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\])*\]\(([^()\s]+)\)")
HEADING = re.compile(r"^#{1,6} +(.*?) *#*$")
CODE = re.compile(r"`[^`]*`")


def lines_of(page):
    """The lines outside of fenced blocks, with their numbers."""
    fenced = False
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        elif not fenced:
            yield number, line


def slug(heading):
    """The anchor that GitHub and GitLab give a heading."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


@functools.cache
def anchors(page):
    found, seen = set(), {}
    for _, line in lines_of(page):
        match = HEADING.match(line)
        if not match:
            continue
        name = slug(match.group(1))
        count = seen.get(name, 0)
        seen[name] = count + 1
        found.add(f"{name}-{count}" if count else name)
    return found


def fault(page, target):
    if re.match(r"[a-z]+:", target):
        return None
    place, _, anchor = target.partition("#")
    file = page if not place else page.parent / place
    if not file.exists():
        return "no such file"
    if anchor and file.suffix == ".md" and anchor not in anchors(file.resolve()):
        return "no such heading"
    return None


def main():
    root, faults, links = pathlib.Path(sys.argv[1]).resolve(), 0, 0
    pages = [page for page in sorted(root.rglob("*.md"))
             if not {"build", "out", ".git"} & set(page.relative_to(root).parts)]
    for page in pages:
        for number, line in lines_of(page):
            for target in LINK.findall(CODE.sub("", line)):
                links += 1
                why = fault(page, target)
                if why:
                    faults += 1
                    print(f"{page.relative_to(root)}:{number}: {target}: {why}")
    print(f"{len(pages)} pages, {links} links, {faults} that lead nowhere")
    sys.exit(1 if faults or not links else 0)


main()
