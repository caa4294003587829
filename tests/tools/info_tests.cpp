// SPDX-License-Identifier: MIT
// filigree info and filigree bench: what they say.
#include <cmath>

#include "cli_test.h"

namespace flg::test {
namespace {

using Info = Cli;

TEST_F(Info, CountsAndSizesOfBuiltInCurves) {
    const Outcome outcome = done({"info", "builtin:thomas:1000", "--report", "report.json"});
    EXPECT_NE(outcome.out.find("points: 1000"), std::string::npos) << outcome.out;
    EXPECT_EQ(report().at("command"), "info");
    EXPECT_EQ(report().at("counts").at("curves"), 1);
    EXPECT_EQ(report().at("counts").at("points"), 1000);
    for (const char* key : {"version", "seed", "workers", "parameters", "stages", "ticks", "warnings", "quality"}) {
        EXPECT_TRUE(report().contains(key)) << key;
    }
}

TEST_F(Info, OdditiesAreCounted) {
    // A square ring of circumference 4, a single point, a curve without length, and a repeated point.
    folder.write(
        "odd.xyz",
        "# closed\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n\n5 5 5\n\n2 2 2\n2 2 2\n2 2 2\n\n0 0 3\n0 0 4\n0 0 4\n0 0 5\n");
    const Outcome outcome = done({"info", "odd.xyz", "--report", "report.json"});
    EXPECT_EQ(outcome.err, "");
    const nlohmann::json counts = report().at("counts");
    EXPECT_EQ(counts.at("curves"), 4);
    EXPECT_EQ(counts.at("closed"), 1);
    EXPECT_EQ(counts.at("points"), 12);
    EXPECT_EQ(counts.at("single_points"), 1);
    EXPECT_EQ(counts.at("without_length"), 1);
    EXPECT_EQ(counts.at("repeated_points"), 3);
    EXPECT_DOUBLE_EQ(report().at("quality").at("total_length"), 4.0 + 2.0);
    EXPECT_DOUBLE_EQ(report().at("quality").at("curve_length").at("max"), 4.0);
    EXPECT_EQ(report().at("quality").at("box"), nlohmann::json({{0.0, 0.0, 0.0}, {5.0, 5.0, 5.0}}));
}

TEST_F(Info, OdditiesOfTheFileAreSaidOnce) {
    folder.write("odd.xyz", "0 0 0\n1 0 0\n\n# closed\n");
    const Outcome outcome = done({"info", "odd.xyz", "--report", "report.json"});
    EXPECT_NE(outcome.out.find("odd: line 4: no curve follows"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(report().at("warnings").size(), 1u);
}

TEST_F(Info, MeshesAreMeasured) {
    // A pyramid of height 1 over the unit square, with two regions and a vertex that no face names.
    folder.write("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
                 "property float radius\nelement face 5\nproperty list uchar int vertex_indices\nproperty int region\n"
                 "property int tag\nend_header\n0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n0.5 0.5 1 1\n9 9 9 1\n"
                 "4 3 2 1 0 7 0\n3 0 1 4 8 0\n3 1 2 4 8 0\n3 2 3 4 8 0\n3 3 0 4 8 0\n");
    const Outcome outcome = done({"info", "a.ply", "--report", "report.json"});
    EXPECT_NE(outcome.out.find("vertices: 6, faces: 5, triangles: 6, regions: 2"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("columns of faces: region tag"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("odd: 1 vertex: in no triangle"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(report().at("counts").at("triangles"), 6);
    EXPECT_EQ(report().at("counts").at("without_area"), 0);
    EXPECT_EQ(report().at("parameters").at("columns"), nlohmann::json({"position", "radius"}));
    EXPECT_EQ(report().at("warnings").size(), 1u);
    // Four sides of base 1 and slant height sqrt(1 + 1/4).
    EXPECT_NEAR(report().at("quality").at("area").get<double>(), 1 + 2 * std::sqrt(1.25), 1e-6);
    EXPECT_NEAR(report().at("quality").at("edge_length").at("min").get<double>(), 1.0, 1e-6);
    EXPECT_NEAR(report().at("quality").at("edge_length").at("max").get<double>(), std::sqrt(2.0), 1e-6);
    EXPECT_EQ(report().at("quality").at("box"), nlohmann::json({{0.0, 0.0, 0.0}, {9.0, 9.0, 9.0}}));
}

TEST_F(Info, FilesMayHoldCurvesAMeshOrBoth) {
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    folder.write("both.obj", points + "f 1 2 3\nf 1 2 2\nl 1 2 3\n");
    const Outcome both = done({"info", "both.obj", "--report", "report.json"});
    EXPECT_NE(both.out.find("curves: 1"), std::string::npos) << both.out;
    EXPECT_NE(both.out.find("triangles: 2"), std::string::npos) << both.out;
    EXPECT_EQ(report().at("counts").at("curves"), 1);
    EXPECT_EQ(report().at("counts").at("without_area"), 1);
    folder.write("mesh.obj", points + "f 1 2 3\n");
    EXPECT_EQ(done({"info", "mesh.obj"}).out.find("curves"), std::string::npos);
    folder.write("lines.obj", points + "l 1 2 3\n");
    EXPECT_EQ(done({"info", "lines.obj"}).out.find("triangles"), std::string::npos);
    folder.write("none.obj", points);
    expect_refused({"info", "none.obj"}, 1, {"none.obj:3: ", "no faces", "as curves: none.obj:3: ", "no lines"});
    folder.write("bad.off", "OFF\n3 1\n");
    expect_refused({"info", "bad.off"}, 1, {"bad.off:2: declares 3 vertices"});
}

TEST_F(Info, BenchPrintsBarsAsJson) {
    const Outcome outcome = run({"bench", "prepare", "--json", "--quiet"});
    const nlohmann::json bars = nlohmann::json::parse(outcome.out).at("bars");
    ASSERT_FALSE(bars.empty());
    bool all_held = true;  // no test fails on a clock
    for (const nlohmann::json& bar : bars) {
        EXPECT_EQ(bar.at("ability"), "stylization");
        EXPECT_EQ(bar.at("group"), "prepare");
        EXPECT_FALSE(bar.at("name").get<std::string>().empty());
        EXPECT_GT(bar.at("figure").get<double>(), 0.0);
        EXPECT_FALSE(bar.at("bar").get<std::string>().empty());
        all_held = all_held && bar.at("held").get<bool>();
    }
    EXPECT_EQ(outcome.status, all_held ? 0 : 1);
    EXPECT_EQ(outcome.err.find("missed") == std::string::npos, all_held) << outcome.err;
}

}  // namespace
}  // namespace flg::test
