# SPDX-License-Identifier: MIT
"""What tools/abi makes of headers: everything in them or an error; and its proof refuses what is not so.

    description_tests.py SOURCES C_COMPILER CXX_COMPILER
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

SOURCES, COMPILER, CXX_COMPILER = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
sys.path.insert(0, str(SOURCES / "tools/abi"))

import c_proof  # noqa: E402
import cpp  # noqa: E402
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


class Grammar(unittest.TestCase):
    """flg + noun + verb; constants prefixed by their enum; descriptors named like their function."""

    # Nouns that are no types of the interface.
    NOUNS = {"Version", "Error", "IoError", "PickError", "Formula", "BrushMesh", "Cable", "Columns", "Debug", "Indices"}
    VERBS = ("Apply|Bake|Begin|Blend|Cancel|Cast|Commit|Create|Cut|Deform|Destroy|Displace|Divide|Draw|Edit|End|Find|Get|Group|Hang|Init|"
             "Insert|Join|Lift|Move|Mute|Offset|Pose|Project|Push|Read|Redo|Refine|Release|Remove|Replay|Resample|"
             "Resume|Run|Sample|Set|Simplify|Split|"
             "Stylize|Sweep|Tick|Trace|Undo|Ungroup|Wait|Warm|Write").split("|")

    def nouns(self) -> set:
        types = {item["name"][3:] for kind in ("structs", "enums", "handles", "objects") for item in COMMITTED[kind]}
        # A file of a kind is written without a handle of its own.
        return types | self.NOUNS | {"MotionFile", "TangleFile"}

    def verb_of(self, function: str) -> str:
        """The part behind the noun; empty where there is no noun, or no verb behind it."""
        name = function.removeprefix("flg")
        ends = [name[len(noun):] for noun in self.nouns() if name.startswith(noun)]
        found = [end for end in ends if re.match(rf"({'|'.join(self.VERBS)})(?![a-z])", end)]
        return min(found, key=len, default="")

    def test_functions_are_noun_and_verb(self):
        for wrong in ("flgTick", "flgLastError", "flgStylize", "flgMeshViewColumn", "flgTangleBorders"):
            self.assertEqual(self.verb_of(wrong), "", wrong)
        for function in COMMITTED["functions"]:
            self.assertNotEqual(self.verb_of(function["name"]), "", function["name"])

    def test_descriptors_are_named_like_their_function(self):
        for function in COMMITTED["functions"]:
            for parameter in function["parameters"]:
                described = re.fullmatch(r"const Flg(\w+)Desc\*", parameter["type"])
                if not described or function["name"].endswith("DescInit"):
                    continue
                name = function["name"].removeprefix("flg")
                # What makes an object is described by the object's noun.
                names = {name, re.sub(r"(Create|Begin|Replay)", "", name)}
                if not name.startswith(described[1]):  # or the noun itself is described
                    self.assertIn(described[1], names, function["name"])

    def test_constants_begin_with_their_enum(self):
        for enum in COMMITTED["enums"]:
            words = re.findall(r"[A-Z][a-z]*", enum["name"])[1:]
            prefix = "FLG_" + "_".join(words).upper() + "_"
            for value in enum["values"]:
                if enum["name"] == "FlgResult":
                    self.assertRegex(value["name"], "^FLG_(OK|NOT_READY|ERROR_[A-Z_]+|RESULT_FORCE_32BIT)$")
                else:
                    self.assertTrue(value["name"].startswith(prefix), value["name"])

    def test_what_starts_a_job_takes_options_and_gives_the_job(self):
        options = "const FlgJobOptions*"
        structs = {s["name"]: s["fields"] for s in COMMITTED["structs"]}
        for function in COMMITTED["functions"]:
            types = [p["type"] for p in function["parameters"]]
            within = [f for t in types for f in structs.get(t.removeprefix("const ").rstrip("*"), [])]
            takes = types.count(options) + sum(f["type"] == options for f in within)
            gives = sum(p["type"] == "FlgJob*" and p["name"] == "out_job" for p in function["parameters"])
            if function["name"].endswith("Init"):
                continue
            self.assertEqual(takes, gives, function["name"])
            if gives:
                self.assertEqual(function["parameters"][-1]["name"], "out_job", function["name"])

    # Values whose layout never changes: what is new comes as an array beside them.
    VALUES = {"FlgStageTime", "FlgColumn", "FlgStyleAttribute", "FlgStyleDrive", "FlgPatchSize", "FlgBufferColumn",
              "FlgSurfacePoint", "FlgSourceWeights", "FlgAxisSample", "FlgBorderStretch", "FlgTangleRegionName",
              "FlgObstacleSide", "FlgRay", "FlgHit", "FlgDebugVertex", "FlgRigJoint"}

    def test_all_structs_can_grow_but_plain_values(self):
        unsized = {struct["name"] for struct in COMMITTED["structs"] if struct["fields"][0]["name"] != "struct_size"}
        self.assertEqual(unsized, self.VALUES)
        sized = {struct["name"] for struct in COMMITTED["structs"]} - unsized
        for struct in COMMITTED["structs"]:
            for field in struct["fields"]:
                self.assertNotIn(field["type"], sized, f"{struct['name']}.{field['name']} can't grow where it is")

    def test_every_sized_struct_has_its_defaults(self):
        functions = {f["name"] for f in COMMITTED["functions"]}
        inlines = {f["returns"] for f in COMMITTED["inlines"]}
        for struct in COMMITTED["structs"]:
            if struct["fields"][0]["name"] == "struct_size":
                self.assertIn(f"flg{struct['name'][3:]}Init", functions)
                self.assertIn(struct["name"], inlines)


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
        self.assertEqual(named(functions, "flgErrorGetMessage")["thread"], "any")
        self.assertEqual(named(functions, "flgContextTick")["thread"], "FlgContext")
        self.assertEqual(named(functions, "flgLiveStrokePush")["thread"], "FlgLiveStroke")
        self.assertEqual(named(functions, "flgLiveStrokeGetTip")["thread"], "FlgLiveStroke")
        self.assertEqual(named(functions, "flgLiveStrokeEnd")["thread"], "FlgContext")
        self.assertEqual(named(functions, "flgCurveFileGetView")["thread"], "FlgCurveFile")
        self.assertEqual(named(functions, "flgCurveFileWrite")["thread"], "any")
        self.assertEqual(named(functions, "flgPickSceneCastRays")["thread"], "any")
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


class Coverage(unittest.TestCase):
    """Every function, struct, enum, handle and object of abi.json is in filigree.hpp and in the C# binding."""

    CPP = HEADERS / "filigree.hpp"
    CSHARP = SOURCES / "samples/unity_csharp/com.filigree.sdk/Runtime/Native"

    @staticmethod
    def code(text: str) -> str:
        return re.sub(r"/\*.*?\*/|//[^\n]*", "", text, flags=re.S)

    def missing(self, text: str, functions: str, types: str) -> list[str]:
        """Names that stand nowhere in the code as the patterns have it, `@` for the name."""
        text = self.code(text)
        found = []
        for kind, pattern in (("functions", functions), ("structs", types), ("enums", types), ("handles", types),
                              ("objects", types)):
            found += [item["name"] for item in COMMITTED[kind]
                      if not re.search(pattern.replace("@", item["name"]), text)]
        return found

    def cpp_missing(self, text: str) -> list[str]:
        # Called, or what an owner releases with; an alias, a descriptor, a view or an owner.
        types = r"using \w+ = @;|struct \w+ : @ \{|@ c_;|(?:Owner|Object)<@,|class ContextOwner.*@ handle_"
        return self.missing(text, r"\b@(?:\(|>)", f"(?s:{types})")

    def csharp_missing(self, text: str) -> list[str]:
        return self.missing(text, r"static extern \S+ @\(", r"(?:enum|struct) @\b")

    def test_all_of_it_is_in_the_wrapper(self):
        text = self.CPP.read_text(encoding="utf-8")
        self.assertEqual(self.cpp_missing(text), [])
        for gone, names in ((r"\bflgPickSceneCommit\(", ["flgPickSceneCommit"]), ("using Ray = FlgRay;", ["FlgRay"]),
                            ("struct StyleDesc : FlgStyleDesc {", ["FlgStyleDesc"]),
                            ("using Metric = FlgMetric;", ["FlgMetric"]), ("FlgMeshView c_;", ["FlgMeshView"]),
                            ("Object<FlgCurveFile, flgCurveFileRelease>", ["flgCurveFileRelease", "FlgCurveFile"])):
            self.assertNotEqual(re.sub(gone, "", text), text)
            self.assertEqual(self.cpp_missing(re.sub(gone, "", text)), names)

    def test_all_of_it_is_in_the_binding(self):
        text = "".join(path.read_text(encoding="utf-8") for path in sorted(self.CSHARP.glob("*.cs")))
        self.assertEqual(self.csharp_missing(text), [])
        for gone in ("flgBrushMeshWrite", "FlgHit", "FlgNumberFormat"):
            self.assertEqual(self.csharp_missing(re.sub(rf"\b{gone}\b", "", text)), [gone])


class Wrapper(unittest.TestCase):
    def wrapper(self, abi: dict) -> str:
        return cpp.Wrapper(abi, SOURCES / "tools/abi/wrapper_parts.hpp").text()

    def test_an_array_of_unknown_length_is_an_error(self):
        abi = copy.deepcopy(COMMITTED)
        named(named(abi["structs"], "FlgPartView")["fields"], "nodes")["doc"] = "discs inside of the outline"
        with self.assertRaises(Misunderstood) as caught:
            self.wrapper(abi)
        self.assertIn("FlgPartView.nodes", str(caught.exception))

    def test_views_may_embed_or_point(self):
        abi = copy.deepcopy(COMMITTED)
        for kind in ("FlgMeshView", "const FlgMeshView*"):
            named(named(abi["structs"], "FlgSurfaceView")["fields"], "mesh")["type"] = kind
            text = self.wrapper(abi)
            self.assertIn("    MeshView mesh;\n", text)
            self.assertEqual("if (c.mesh) mesh = *c.mesh;" in text, kind.endswith("*"))


class Umbrella(unittest.TestCase):
    """filigree_all.h alone declares everything, to C and to C++."""

    def compiles(self, folder: Path, compiler: str, language: str) -> bool:
        lines = ['#include "filigree/filigree_all.h"', "void everything(void);", "void everything(void) {"]
        lines += [f"    (void)&{function['name']};" for function in COMMITTED["functions"]]
        for kind in ("structs", "enums", "handles", "objects"):
            lines += [f"    (void)sizeof({item['name']});" for item in COMMITTED[kind]]
        lines += [f"    (void){constant['name']};" for constant in COMMITTED["constants"]]
        command = [compiler, f"-std={language}", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", f"-I{folder}",
                   "-xc++" if "++" in language else "-xc", "-"]
        return subprocess.run(command, input="\n".join(lines + ["}", ""]), text=True, capture_output=True).returncode == 0

    def test_it_has_all_headers(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(HEADERS, Path(folder) / "filigree")
            umbrella = Path(folder) / "filigree/filigree_all.h"
            whole = umbrella.read_text(encoding="utf-8")
            for compiler, language in ((COMPILER, "c11"), (CXX_COMPILER, "c++17")):
                umbrella.write_text(whole, encoding="utf-8")
                self.assertTrue(self.compiles(Path(folder), compiler, language), language)
                for header in ("filigree_pick.h", "filigree_brush.h", "filigree_buffers.h", "filigree_debug.h",
                               "filigree_project.h"):
                    umbrella.write_text(whole.replace(f'#include "{header}"', ""), encoding="utf-8")
                    self.assertFalse(self.compiles(Path(folder), compiler, language), f"{language}, {header}")


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
            "a parameter": lambda abi: named(abi["functions"], "flgContextTick")["parameters"][1].update(type="uint64_t"),
            "a callback": lambda abi: named(abi["callbacks"], "FlgLog.write").update(returns="int32_t"),
        }
        for name, lie in lies.items():
            self.assertFalse(self.compiles(changed(lie)), name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
