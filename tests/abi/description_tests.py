# SPDX-License-Identifier: MIT
"""What tools/abi makes of headers: everything in them or an error; and its proof refuses what is not so.

    description_tests.py SOURCES C_COMPILER
"""
import copy
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCES, COMPILER = Path(sys.argv[1]), sys.argv[2]
sys.path.insert(0, str(SOURCES / "tools/abi"))

import c_proof  # noqa: E402
import description  # noqa: E402
from c_tokens import Misunderstood  # noqa: E402

HEADERS = SOURCES / "sdk/include/filigree"
COMMITTED = json.loads((SOURCES / "sdk/api/abi.json").read_text(encoding="utf-8"))


def described(body: str) -> dict:
    """The description of one small header."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "filigree.h").write_text(f"/* SPDX-License-Identifier: MIT\n *\n * A header. */\n{body}")
        return description.describe(Path(folder))


def named(items: list, name: str) -> dict:
    return next(item for item in items if item["name"] == name)


class Headers(unittest.TestCase):
    def test_every_function_of_the_headers_is_described(self):
        text = "".join(path.read_text(encoding="utf-8") for path in HEADERS.glob("*.h"))
        declared = re.findall(r"^FLG_API [^(;]*\b(flg\w+)\(", text, re.M)
        self.assertGreater(len(declared), 150)
        self.assertEqual(sorted(declared), sorted(f["name"] for f in COMMITTED["functions"]))

    def test_every_type_of_the_headers_is_described(self):
        text = "".join(path.read_text(encoding="utf-8") for path in HEADERS.glob("*.h"))
        text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
        declared = re.findall(r"^\} (Flg\w+);|^FLG_HANDLE\((\w+)\)|^typedef struct \w+\* (\w+);", text, re.M)
        kinds = ("structs", "enums", "handles", "objects")
        self.assertEqual(sorted("".join(names) for names in declared),
                         sorted(item["name"] for kind in kinds for item in COMMITTED[kind]))

    def test_threads_are_those_of_the_comments(self):
        functions = COMMITTED["functions"]
        self.assertEqual(named(functions, "flgLastError")["thread"], "any")
        self.assertEqual(named(functions, "flgTick")["thread"], "FlgContext")
        self.assertEqual(named(functions, "flgCurveFileGetView")["thread"], "FlgCurveFile")
        self.assertEqual(named(functions, "flgCurveFileWrite")["thread"], "any")
        self.assertEqual(named(functions, "flgPickRays")["thread"], "any")
        self.assertEqual(named(functions, "flgPickSceneCommit")["thread"], "FlgPickScene")

    def test_comments_go_to_what_they_stand_at(self):
        struct = described("""
/* A place. */
typedef struct FlgPlace {
    /* Across. */
    float x, y; /* metres */
    uint32_t name;      /* of so many
                           letters */
    /* Called when it moves. */
    void (*moved)(void* user_data, const float to[3]);
} FlgPlace;
""")
        place = struct["structs"][0]
        self.assertEqual(place["doc"], "A place.")
        self.assertEqual([(f["name"], f["offset"], f["doc"]) for f in place["fields"]],
                         [("x", 0, "metres"), ("y", 4, "metres"), ("name", 8, "of so many letters"),
                          ("moved", 16, "Called when it moves.")])
        self.assertEqual(struct["callbacks"], [
            {"name": "FlgPlace.moved", "returns": "void", "doc": "Called when it moves.",
             "parameters": [{"name": "user_data", "type": "void*", "count": 1},
                            {"name": "to", "type": "const float", "count": 3}]}])

    def test_what_it_does_not_know_is_an_error_with_its_place(self):
        for body, place in [("union Flg { int x; };", "filigree.h:4"),
                            ("FLG_API FlgFoo flgFoo(void);", "filigree.h:4: the type `FlgFoo`"),
                            ("\ntypedef struct FlgA {\n    float x : 3;\n} FlgA;", "filigree.h:6"),
                            ("#define FLG_SQUARE(x) x", "filigree.h:4: #define FLG_SQUARE"),
                            ("#pragma pack(1)", "filigree.h:4: #pragma"),
                            ("#if 1", "filigree.h:4")]:
            with self.assertRaises(Misunderstood, msg=body) as caught:
                described(body + "\n")
            self.assertIn(place, str(caught.exception))


class Check(unittest.TestCase):
    def test_a_header_that_changed_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            binding = "samples/unity_csharp/com.filigree.sdk/Runtime/Native"
            for part in ("tools/abi", "sdk/include/filigree", "sdk/api", binding):
                shutil.copytree(SOURCES / part, Path(folder) / part, ignore=shutil.ignore_patterns("*.cpp"))
            check = [sys.executable, f"{folder}/tools/abi/generate", "--check"]
            self.assertEqual(subprocess.run(check).returncode, 0)
            header = Path(folder) / "sdk/include/filigree/filigree.h"
            header.write_text(header.read_text(encoding="utf-8").replace("float progress; ", "float progress_; ", 1),
                              encoding="utf-8")
            found = subprocess.run(check, capture_output=True, text=True)
            self.assertEqual(found.returncode, 1)
            self.assertIn("sdk/api/abi.json is not what the headers say", found.stderr)
            self.assertIn(f"{binding}/FiligreeStructs.cs is not what the headers say", found.stderr)
            self.assertEqual(len(found.stderr.splitlines()), 2)

            subprocess.run(check[:-1], check=True, stdout=subprocess.DEVNULL)
            self.assertEqual(subprocess.run(check).returncode, 0)
            (Path(folder) / binding / "FiligreeGoneTypes.cs").touch()
            self.assertEqual(subprocess.run(check, stderr=subprocess.DEVNULL).returncode, 1)


class Proof(unittest.TestCase):
    def compiles(self, abi: dict) -> bool:
        command = [COMPILER, "-std=c11", "-fsyntax-only", "-w", f"-I{HEADERS.parent}", "-xc", "-"]
        return subprocess.run(command, input=c_proof.proof(abi), text=True, capture_output=True).returncode == 0

    def test_only_the_truth_compiles(self):
        self.assertTrue(self.compiles(COMMITTED))

        def changed(change) -> dict:
            abi = copy.deepcopy(COMMITTED)
            change(abi)
            return abi

        def of_stage(abi: dict) -> dict:
            return named(abi["structs"], "FlgStageTime")

        lies = {
            "a size": lambda abi: of_stage(abi).update(size=24),
            "an offset": lambda abi: of_stage(abi)["fields"][1].update(offset=12),
            "a field's type": lambda abi: of_stage(abi)["fields"][1].update(type="uint32_t"),
            "a const": lambda abi: of_stage(abi)["fields"][0].update(type="char*"),
            "an array's length": lambda abi: named(abi["structs"], "FlgStroke")["fields"][0].update(count=39),
            "a value": lambda abi: abi["enums"][0]["values"][1].update(value=2),
            "a parameter": lambda abi: named(abi["functions"], "flgTick")["parameters"][1].update(type="uint64_t"),
            "a callback": lambda abi: named(abi["callbacks"], "FlgLog.write").update(returns="int32_t"),
        }
        for name, lie in lies.items():
            self.assertFalse(self.compiles(changed(lie)), name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
