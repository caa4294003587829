# SPDX-License-Identifier: MIT
"""README's two smallest programs: as short as they are said to be, few calls, and alike in what they print.

    smallest_programs.py README.md C_PROGRAM CPP_PROGRAM
"""
import re
import subprocess
import sys
from pathlib import Path

MOST_LINES = {"c": 25, "cpp": 12}
# What a line costs once there are a context and a style: its points in, the job's defaults, the job, waiting, the points
# out. (The view's defaults only say how large it is.)
MOST_CALLS = 5


def main() -> None:
    readme, c_program, cpp_program = sys.argv[1:]
    blocks = dict(re.findall(r"^```(c|cpp) complete\n(.*?)^```$", Path(readme).read_text(encoding="utf-8"), re.M | re.S))
    for language, most in MOST_LINES.items():
        lines = len(blocks[language].splitlines())
        print(f"{language}: {lines} lines, at most {most}")
        assert lines <= most

    calls = re.findall(r"\bflg[A-Z]\w+(?=\()", blocks["c"])
    for_style = ["flgContextCreate", "flgContextDestroy", "flgErrorGetMessage", "flgCurveSetCreateFromPoints",
                 "flgStyleDefaults", "flgStyleCreate", "flgCurveSetViewDefaults"]
    for name in for_style:
        calls.remove(name)
    print(f"a line: {', '.join(calls)}")
    assert len(calls) <= MOST_CALLS and len(set(calls)) == len(calls)

    printed = [subprocess.run([program], check=True, capture_output=True, text=True).stdout
               for program in (c_program, cpp_program)]
    points = [line.split() for line in printed[0].splitlines()]
    print(f"{len(points)} points")
    assert printed[0] == printed[1]
    assert len(points) > 100 and all(len(point) == 3 for point in points)
    assert max(float(point[1]) for point in points) > 0.5, "the line has no zigzag"


main()
