# SPDX-License-Identifier: MIT
"""Structs grow: every struct with a struct_size gets a field at its end, the libraries are built so, and a host that was
compiled before makes every call of the ABI. It must end with the bits that it has from today's libraries.

    grown.py SOURCES FOLDER CMAKE C_COMPILER CXX_COMPILER TEST_HARDENING
"""
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

sources, folder = Path(sys.argv[1]), Path(sys.argv[2])
cmake, c_compiler, cxx_compiler, host = sys.argv[3:7]
copy, build = folder / "filigree", folder / "build"

# A field that no version of the library knows, and a value that only memory beyond the host's struct can have.
FIELD = "uint64_t grown_at_the_end;"


def grow(structs: list) -> None:
    for header in (copy / "sdk/include/filigree").glob("*.h"):
        text = header.read_text(encoding="utf-8")
        for name in (struct["name"] for struct in structs if struct["header"] == header.name):
            text, count = re.subn(rf"^}} {name};", f"    {FIELD}\n}} {name};", text, flags=re.MULTILINE)
            if count != 1:
                raise SystemExit(f"{header.name}: {name} ends {count} times")
        header.write_text(text, encoding="utf-8")
    sizes = "".join(f"template <>\ninline constexpr uint32_t first_size<{struct['name']}> = {struct['size']};\n"
                    for struct in structs)
    sized = copy / "sdk/core/sized_struct.h"
    text = sized.read_text(encoding="utf-8")
    place = "// What becomes of a host's struct"
    if place not in text:
        raise SystemExit(f"{sized.name}: first_size is not where it was")
    headers = "".join(f'#include "filigree/{header}"\n' for header in sorted({s["header"] for s in structs}))
    text = text.replace('#include "core/failure.h"\n', f'#include "core/failure.h"\n{headers}')
    sized.write_text(text.replace(place, f"{sizes}\n{place}", 1), encoding="utf-8")


def bits(libraries: Path | None) -> str:
    """What the host makes of every call, as one number."""
    report = folder / "report.json"
    report.unlink(missing_ok=True)
    environment = dict(os.environ)
    if libraries:
        environment["LD_LIBRARY_PATH"] = str(libraries)
    done = subprocess.run([host, "--gtest_filter=Completeness.*", f"--gtest_output=json:{report}"], env=environment,
                          capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"with {libraries or 'the libraries of the host'}:\n{done.stdout[-6000:]}{done.stderr[-2000:]}")
    return json.loads(report.read_text())["testsuites"][0]["testsuite"][0]["bits"]


structs = [struct for struct in json.loads((sources / "sdk/api/abi.json").read_text(encoding="utf-8"))["structs"]
           if struct["fields"][0]["name"] == "struct_size"]
if len(structs) < 80:
    raise SystemExit(f"only {len(structs)} structs have a struct_size")
shutil.rmtree(copy, ignore_errors=True)
copy.mkdir(parents=True)
for name in ("CMakeLists.txt", "LICENSE"):
    shutil.copy(sources / name, copy)
for name in ("sdk", "tools/unity"):
    shutil.copytree(sources / name, copy / name)
grow(structs)
off = [f"-DFLG_{part}=OFF" for part in ("BUILD_RENDERER", "BUILD_TOOLS", "BUILD_SAMPLES", "BUILD_TESTS", "INSTALL",
                                        "WARNINGS_AS_ERRORS")]
for command in ([cmake, "-S", copy, "-B", build, "-G", "Ninja", "-DCMAKE_UNITY_BUILD=ON",
                 # The bits are the same at any level. Coroutines need tail calls.
                 "-DCMAKE_CXX_FLAGS=-O1 -foptimize-sibling-calls -DNDEBUG -w",
                 f"-DCMAKE_C_COMPILER={c_compiler}", f"-DCMAKE_CXX_COMPILER={cxx_compiler}", *off],
                [cmake, "--build", build, "--target", "filigree", "filigree_io", "filigree_pick"]):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{done.stdout[-6000:]}{done.stderr[-2000:]}")
before, after = bits(None), bits(build / "lib")
print(f"{len(structs)} structs grew: bits {before} before, {after} after")
if before != after:
    raise SystemExit("a host that was compiled before has other results")
