#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts the figures of a run of `filigree bench --json` into sdk/docs/performance.md.

    filigree bench --json > bars.json
    tools/docs/bars.py bars.json "2 cores of a Xeon at 2.8 GHz, GCC 12, release, 1 May 2026"

Replaces what stands between the page's two marks: a table an ability, rows in their order.
"""
import itertools
import json
import pathlib
import sys

PAGE = pathlib.Path(__file__).resolve().parents[2] / "sdk/docs/performance.md"
BEGIN, END = "<!-- bars: begin -->\n", "<!-- bars: end -->\n"


def number(value):
    return "not measured" if value is None or value != value else f"{value:.4g}"


def ability_of(row):
    return row["ability"]


def table(rows):
    lines = ["| what | figure | asked for | |", "|---|---|---|---|"]
    for row in rows:
        figure = f"{number(row['figure'])} {row['unit']}".rstrip()
        met = "met" if row["held"] else "**missed**"
        note = f"; {row['note']}" if row.get("note") else ""
        cells = (row["name"], figure, row["bar"], met + note)
        lines.append("| " + " | ".join(cell.replace("|", "/") for cell in cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    rows = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))["bars"]
    met = sum(row["held"] for row in rows)
    parts = [f"{met} of {len(rows)} bars met. {sys.argv[2]}.\n"]
    for name, group in itertools.groupby(rows, ability_of):
        parts.append(f"**{name[:1].upper()}{name[1:]}**\n\n{table(group)}")
    text = PAGE.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    PAGE.write_text(before + BEGIN + "\n" + "\n".join(parts) + "\n" + END + rest.split(END)[1], encoding="utf-8")


main()
