// SPDX-License-Identifier: MIT
// filigree tangle: scripts of operations, what they leave in files, and what is wrong with those that can't be run.
#include "cli_test.h"
#include "meshes.h"

namespace flg::test {
namespace {

class Tangle : public Cli {
protected:
    void SetUp() override { folder.write("sphere.off", sphere(16).off()); }

    std::vector<std::string> command(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments = {"tangle",  "sphere.off", "script.json", "-o",
                                              "out.glb", "--report",   "report.json", "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
    void expect_refused(const std::string& script, const std::string& sentence) const {
        folder.write("script.json", script);
        const Outcome outcome = run(command());
        EXPECT_EQ(outcome.status, 1);
        EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
        EXPECT_FALSE(folder.has("out.glb"));
    }
};

// Bands, each a group by turns; dots in every other one; these raised.
const char* const kScript = R"({
  "unit": "metres",
  "operations": [
    {"name": "bands", "op": "contour", "on": "root", "from": {"points": [312]}, "delta": 0.6, "count": 0},
    {"name": "dots", "op": "contour", "on": "bands.background", "each": true,
     "from": {"samples": {"radius": 0.35}}, "delta": 0.1},
    {"op": "displace", "on": "dots.foreground", "amount": 0.05, "bias": 0.7},
    {"name": "rest", "op": "outline", "on": "bands.foreground", "size": 0.05}
  ]})";

TEST_F(Tangle, RunsAScriptAndWritesMasks) {
    folder.write("script.json", kScript);
    done(command({"--masks", "masks.ply", "--curves", "borders.xyz"}));
    EXPECT_GT(report().at("counts").at("border_points"), 100);
    EXPECT_FALSE(folder.read("borders.xyz").empty());
    const nlohmann::json counts = report().at("counts");
    EXPECT_GT(counts.at("leaves"), 20);
    EXPECT_EQ(counts.at("depth"), 2);
    // Of 6 bands 3 are divided, each by itself, then the dots are raised and the others outlined.
    EXPECT_EQ(counts.at("steps"), 6);
    done({"mesh", "info", "masks.ply", "--report", "info.json"});
    const nlohmann::json info = report("info.json").at("counts");
    EXPECT_EQ(info.at("input_regions"), counts.at("leaves"));
    EXPECT_EQ(info.at("triangles"), counts.at("cut_triangles"));
    EXPECT_EQ(folder.read("out.glb").substr(0, 4), "glTF");
}

TEST_F(Tangle, SameBitsWithAnyWorkersAndBudget) {
    folder.write("script.json", kScript);
    done(command({"--masks", "masks.ply", "--workers", "0"}));
    const std::string expected = folder.read("masks.ply");
    done(command({"--masks", "masks.ply", "--workers", "3", "--budget", "200"}));
    EXPECT_TRUE(folder.read("masks.ply") == expected);
}

TEST_F(Tangle, ScriptsThatCantBeRunSayWhere) {
    expect_refused("{", "script.json");
    expect_refused("[]", "must be an object");
    expect_refused("{}", "needs `operations`");
    expect_refused(R"({"operations": [], "materials": {}})", "does not know `materials`");
    expect_refused(R"({"operations": [{"op": "spiral", "on": "root"}]})", "operations[0].op: is `spiral`");
    expect_refused(R"({"operations": [{"op": "contour", "on": "root", "form": {}}]})", "does not know `form`");
    expect_refused(R"({"operations": [{"op": "contour", "on": "root"}]})", "operations[0]: needs `from`");
    expect_refused(R"({"operations": [{"op": "contour", "on": "leaf", "from": {}}]})", "names no operation before");
    expect_refused(R"({"operations": [{"op": "contour", "on": "root", "from": {"borders": "outer"}}]})",
                   "closed surface");
    expect_refused(R"({"operations": [{"op": "contour", "on": "root", "from": {"points": [1]}, "delta": 0}]})",
                   "desc.delta");
    expect_refused(R"({"operations": [{"op": "contour", "on": "root", "from": {"points": [1, 9999999]}}]})",
                   "there is no vertex 9999999");
    expect_refused(R"({"operations": [{"op": "join", "on": []}]})", "selects no region");
}

}  // namespace
}  // namespace flg::test
