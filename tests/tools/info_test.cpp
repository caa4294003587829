// SPDX-License-Identifier: MIT
// filigree info and filigree bench: what they say.
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

TEST_F(Info, BenchPrintsBarsAsJson) {
    const Outcome outcome = done({"bench", "prepare", "--json", "--quiet"});
    const nlohmann::json bars = nlohmann::json::parse(outcome.out).at("bars");
    ASSERT_FALSE(bars.empty());
    for (const nlohmann::json& bar : bars) {
        EXPECT_FALSE(bar.at("name").get<std::string>().empty());
        EXPECT_GT(bar.at("figure").get<double>(), 0.0);
        EXPECT_FALSE(bar.at("bar").get<std::string>().empty());
        EXPECT_TRUE(bar.at("held").is_boolean());
    }
}

}  // namespace
}  // namespace flg::test
