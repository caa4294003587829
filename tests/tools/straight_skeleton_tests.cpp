// SPDX-License-Identifier: MIT
// filigree straight-skeleton: closed forms, formats, refusals.
#include <cmath>

#include "cli_test.h"

namespace flg::test {
namespace {

class StraightSkeletonCommand : public Cli {
protected:
    nlohmann::json skeleton(const std::string& contour) const {
        done({"straight-skeleton", contour, "-o", "out.json", "--quiet", "--report", "report.json"});
        return nlohmann::json::parse(folder.read("out.json"));
    }
};

using Json = nlohmann::json;

TEST_F(StraightSkeletonCommand, RectangleHasARidge) {
    folder.write("rectangle.poly.txt", "# made by hand\n0 0\n5 0\n5 2\n0 2\n");
    const Json json = skeleton("rectangle.poly.txt");
    ASSERT_EQ(json.at("nodes").size(), 6u);
    EXPECT_EQ(json.at("nodes")[0], Json({0.0, 0.0, 0.0}));
    EXPECT_EQ(json.at("nodes")[2], Json({5.0, 2.0, 0.0}));
    double low = 9, high = 0;
    for (size_t i = 4; i < 6; ++i) {
        EXPECT_NEAR(json.at("nodes")[i][1].get<double>(), 1, 1e-14);
        EXPECT_NEAR(json.at("nodes")[i][2].get<double>(), 1, 1e-14);
        low = std::min(low, json.at("nodes")[i][0].get<double>());
        high = std::max(high, json.at("nodes")[i][0].get<double>());
    }
    EXPECT_NEAR(low, 1, 1e-14);
    EXPECT_NEAR(high, 4, 1e-14);
    EXPECT_EQ(json.at("arcs").size(), 5u);
    ASSERT_EQ(json.at("faces").size(), 4u);
    for (size_t f = 0; f < 4; ++f) {
        EXPECT_EQ(json.at("faces")[f].at("edge"), f);
        EXPECT_EQ(json.at("faces")[f].at("ring")[0], f);
        EXPECT_EQ(json.at("faces")[f].at("ring")[1], (f + 1) % 4);
    }
    EXPECT_EQ(report().at("counts").at("nodes"), 6);
    EXPECT_LT(report().at("quality").at("residual").get<double>(), 1e-13);
    EXPECT_EQ(report().at("quality").at("perturbation"), 0);
}

TEST_F(StraightSkeletonCommand, HolesAreRingsAfterEmptyLines) {
    folder.write("frame.poly.txt", "0 0\n6 0 # a corner\n# no end of a ring\n6 6\n0\t6\r\n\n\n1 1\n5 1\n5 5\n1 5\n");
    const Json json = skeleton("frame.poly.txt");
    EXPECT_EQ(json.at("nodes").size(), 12u);
    EXPECT_EQ(json.at("arcs").size(), 12u);
    EXPECT_EQ(report().at("counts").at("rings"), 2);
}

TEST_F(StraightSkeletonCommand, SketchesEndWhereTheyBegin) {
    folder.write("SketchPolyline0.txt", "5\n0 0 26\n0 3 26\n4 0 26\n4 0 26\n0 0 26\n");
    const Json json = skeleton("SketchPolyline0.txt");
    ASSERT_EQ(json.at("nodes").size(), 4u);
    for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(json.at("nodes")[3][k].get<double>(), 1, 1e-14);
    EXPECT_EQ(report().at("counts").at("contour_points"), 3);
}

// Without the first point again at its end, which `SketchPolyline` files have, a ring is closed all the same.
TEST_F(StraightSkeletonCommand, OpenRingsAreClosed) {
    folder.write("SketchPolyline0.txt", "3\n0 0 26\n0 3 26\n4 0 26\n");
    const Json open = skeleton("SketchPolyline0.txt");
    folder.write("closed.poly.txt", "0 0\n0 3\n4 0\n0 0\n");
    EXPECT_EQ(open, skeleton("closed.poly.txt"));
}

TEST_F(StraightSkeletonCommand, OffsetsAreRings) {
    folder.write("rectangle.poly.txt", "0 0\n5 0\n5 2\n0 2\n");
    done({"straight-skeleton", "rectangle.poly.txt", "-o", "out.json", "--offset", "0", "--offset", "0.5", "--offset",
          "9"});
    const Json offsets = Json::parse(folder.read("out.json")).at("offsets");
    ASSERT_EQ(offsets.size(), 3u);
    EXPECT_EQ(offsets[0].at("rings"), Json({{{0.0, 0.0}, {5.0, 0.0}, {5.0, 2.0}, {0.0, 2.0}}}));
    EXPECT_EQ(offsets[1].at("distance"), 0.5);
    EXPECT_EQ(offsets[1].at("rings"), Json({{{0.5, 0.5}, {4.5, 0.5}, {4.5, 1.5}, {0.5, 1.5}}}));
    EXPECT_EQ(offsets[2].at("rings").size(), 0u);
    expect_refused({"straight-skeleton", "rectangle.poly.txt", "-o", "out.json", "--offset", "-1"}, 2, {"--offset"});
}

TEST_F(StraightSkeletonCommand, CrossingsAreRepaired) {
    folder.write("eight.poly.txt", "0 0\n4 4\n4 0\n0 2\n");
    done({"straight-skeleton", "eight.poly.txt", "-o", "out.json", "--repair", "--report", "report.json"});
    EXPECT_EQ(report().at("counts").at("contour_points"), 3);
    EXPECT_EQ(Json::parse(folder.read("out.json")).at("nodes").size(), 4u);
}

// The hole comes first in the file; y is upwards.
TEST_F(StraightSkeletonCommand, DrawingsAreRead) {
    folder.write(
        "frame.svg",
        "<svg xmlns='http://www.w3.org/2000/svg'><path d='M1 1 L5 1 L5 5 L1 5 Z M0 0 L6 0 L6 6 L0 6 Z'/></svg>");
    const Json json = skeleton("frame.svg");
    ASSERT_EQ(json.at("nodes").size(), 12u);
    EXPECT_EQ(report().at("counts").at("rings"), 2);
    double low = 9;
    for (size_t i = 0; i < 4; ++i) low = std::min(low, json.at("nodes")[i][1].get<double>());
    EXPECT_EQ(low, -6);
    for (size_t i = 8; i < 12; ++i) EXPECT_NEAR(json.at("nodes")[i][2].get<double>(), 0.5, 1e-12);
    folder.write("broken.svg", "<svg><path d='M0 0 L1'/></svg>");
    expect_refused({"straight-skeleton", "broken.svg", "-o", "out.json"}, 1, {"broken.svg"});
}

TEST_F(StraightSkeletonCommand, SameBitsUnderAnyWorkersAndBudget) {
    std::string text;
    for (int i = 0; i < 80; ++i) {
        const double angle = 2 * M_PI * i / 80, radius = 2 + std::sin(7 * angle) + 0.3 * std::sin(23 * angle);
        text += std::to_string(radius * std::cos(angle)) + " " + std::to_string(radius * std::sin(angle)) + "\n";
    }
    folder.write("star.poly.txt", text);
    done({"straight-skeleton", "star.poly.txt", "-o", "a.json", "--workers", "0"});
    done({"straight-skeleton", "star.poly.txt", "-o", "b.json", "--workers", "2", "--budget", "50"});
    EXPECT_EQ(folder.read("a.json"), folder.read("b.json"));
}

TEST_F(StraightSkeletonCommand, BadContoursAreRefused) {
    const auto refused = [&](const std::string& text, const std::vector<std::string>& words) {
        folder.write("c.poly.txt", text);
        std::vector<std::string> all = {"c.poly.txt"};
        all.insert(all.end(), words.begin(), words.end());
        expect_refused({"straight-skeleton", "c.poly.txt", "-o", "out.json"}, 1, all);
    };
    refused("", {"no points"});
    refused("0 0\n1 0\n1 x\n", {":3:", "'1 x'"});
    refused("0 0\n1 0 3\n1 1\n", {":2:", "x y"});
    refused("4\n0 0 1\n1 0 1\n1 1 1\n", {"3 points", "4"});
    refused("0 0\n1 0\n", {"desc.contour.point_count", "2"});
    refused("0 0\n1 0\n2 0\n", {"ring 0", "no area"});
    refused("0 0\n2 2\n2 0\n0 2\n", {"cross at (1, 1)"});
    refused("0 0\n1 0\n1 nan\n", {"point 2", "finite"});
    expect_refused({"straight-skeleton", "none.poly.txt", "-o", "out.json"}, 1, {"none.poly.txt", "can't be opened"});
    expect_refused({"straight-skeleton", "c.poly.txt", "-o", "no/out.json"}, 1, {"no/out.json"});
}

}  // namespace
}  // namespace flg::test
