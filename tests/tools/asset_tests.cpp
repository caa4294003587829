// SPDX-License-Identifier: MIT
// filigree tangle on assets: a drawn model is ornamented and stays the model that it was.
#include <cstring>
#include <set>

#include "cli_test.h"

namespace flg::test {
namespace {

using Json = nlohmann::json;

class AssetCommand : public Cli {
protected:
    void SetUp() override {
        done({"skeleton", FLG_SOURCES "/samples/models/cat.json", "--motion", "walk", "--vertices", "2000", "-o",
              "model.glb", "--quiet"});
    }
    Json json(const std::string& file) const {
        const std::string glb = folder.read(file);
        uint32_t size = 0;
        std::memcpy(&size, glb.data() + 12, sizeof size);
        return Json::parse(glb.substr(20, size));
    }
    // An accessor's bytes, back to back.
    std::string bytes(const std::string& file, const Json& accessor) const {
        const std::string glb = folder.read(file);
        const Json whole = json(file), view = whole["bufferViews"][accessor["bufferView"].get<size_t>()];
        const size_t begin = glb.size() - whole["buffers"][0]["byteLength"].get<size_t>();
        return glb.substr(begin + view["byteOffset"].get<size_t>(), view["byteLength"]);
    }
};

TEST_F(AssetCommand, AModelIsOrnamentedAndStaysAModel) {
    const Outcome outcome = run({"tangle", "model.glb", FLG_SOURCES "/samples/tangles/medals.json", "-o", "out.glb",
                                 "--report", "report.json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("left out"), std::string::npos) << outcome.err;
    const Json before = json("model.glb"), after = json("out.glb");
    for (const char* const list : {"nodes", "scenes", "skins"}) EXPECT_EQ(after[list], before[list]) << list;
    for (size_t m = 0; m < before["materials"].size(); ++m) EXPECT_EQ(after["materials"][m], before["materials"][m]);
    std::set<std::string> names;
    for (const Json& material : after["materials"]) names.insert(material["name"]);
    for (const char* const name : {"cobalt", "ivory", "gold"}) EXPECT_TRUE(names.contains(name)) << name;
    // Animations are what they were, to the bit.
    ASSERT_EQ(after["animations"].size(), before["animations"].size());
    for (size_t s = 0; s < before["animations"][0]["samplers"].size(); ++s) {
        for (const char* const end : {"input", "output"}) {
            const size_t b = before["animations"][0]["samplers"][s][end],
                         a = after["animations"][0]["samplers"][s][end];
            EXPECT_TRUE(bytes("model.glb", before["accessors"][b]) == bytes("out.glb", after["accessors"][a]));
        }
    }
    done({"info", "out.glb", "--report", "after.json"});
    done({"info", "model.glb", "--report", "before.json"});
    EXPECT_EQ(report("after.json").at("parameters").at("joints"), report("before.json").at("parameters").at("joints"));
    EXPECT_GT(report("after.json").at("counts").at("triangles"), report("before.json").at("counts").at("triangles"));
}

TEST_F(AssetCommand, MaterialsAreKeptWhereTheScriptNamesNone) {
    const std::string operation =
        R"("operations": [{"name": "a", "op": "contour", "on": "root", "from": {"points": [0]}, "delta": 0.05}])";
    folder.write("none.json", "{" + operation + "}");
    const Outcome none = run({"tangle", "model.glb", "none.json", "-o", "out.glb"});
    ASSERT_EQ(none.status, 0) << none.err;
    EXPECT_NE(none.err.find("none.json: has no materials, so all regions have those of model.glb"), std::string::npos)
        << none.err;
    EXPECT_EQ(json("out.glb")["materials"], json("model.glb")["materials"]);
    folder.write("one.json", "{" + operation + R"(, "materials": [{"on": "a.foreground", "color": "#ff0000"}]})");
    done({"tangle", "model.glb", "one.json", "-o", "out.glb"});
    EXPECT_EQ(json("out.glb")["materials"].size(), json("model.glb")["materials"].size() + 1);
    folder.write("keep.json", "{" + operation + R"(, "materials": [{"on": "default", "keep": true}]})");
    const Outcome plain = run({"tangle", "builtin:vase", "keep.json", "-o", "vase.glb"});
    EXPECT_EQ(plain.status, 1);
    EXPECT_NE(plain.err.find("materials[0].keep: the mesh is no .gltf or .glb file"), std::string::npos) << plain.err;
}

TEST_F(AssetCommand, SameBitsWithAnyWorkers) {
    for (const char* const workers : {"0", "3"})
        done({"tangle", "model.glb", FLG_SOURCES "/samples/tangles/medals.json", "-o",
              "out" + std::string(workers) + ".glb", "--workers", workers, "--quiet"});
    EXPECT_TRUE(folder.read("out0.glb") == folder.read("out3.glb"));
}

}  // namespace
}  // namespace flg::test
