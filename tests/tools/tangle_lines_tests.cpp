// SPDX-License-Identifier: MIT
// filigree tangle: operations of scripts that lay lines onto the surface.
#include <cmath>
#include <sstream>

#include "cli_test.h"
#include "meshes.h"

namespace flg::test {
namespace {

class TangleLines : public Cli {
protected:
    void SetUp() override {
        folder.write("square.off", square(24).off());
        folder.write("sphere.off", sphere(12).off());
        folder.write("box.svg", "<svg><rect width='30' height='30'/></svg>");
        folder.write("ring.svg", "<svg><circle r='5'/><circle r='2'/></svg>");
        folder.write("wave.xyz", wave());
    }
    // A stroke along x, 2 long, 0.1 up and down: whole waves, so that its guide, which ends where it does, is straight.
    static std::string wave() {
        std::ostringstream text;
        for (int i = 0; i <= 400; ++i) text << i / 200.0 << " " << 0.1 * std::sin(M_PI * i / 10) << " 0\n";
        return text.str();
    }
    std::vector<std::string> command(const std::string& mesh, const std::string& script,
                                     const std::vector<std::string>& more = {}) const {
        folder.write("script.json", script);
        std::vector<std::string> arguments = {"tangle",  mesh,       "script.json", "-o",
                                              "out.glb", "--report", "report.json", "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
    void expect_refused(const std::string& mesh, const std::string& script, const std::string& sentence) const {
        const Outcome outcome = run(command(mesh, script));
        EXPECT_EQ(outcome.status, 1);
        EXPECT_NE(outcome.err.find(sentence), std::string::npos) << outcome.err;
        EXPECT_FALSE(folder.has("out.glb"));
    }
    std::vector<Point> borders() const {
        std::istringstream text(folder.read("borders.xyz"));
        std::vector<Point> points;
        for (std::string line; std::getline(text, line);) {
            std::istringstream numbers(line);
            Point p;
            if (numbers >> p[0] >> p[1] >> p[2]) points.push_back(p);
        }
        return points;
    }
};

TEST_F(TangleLines, ShapesFillTheirShareOfTheRoom) {
    done(command("square.off", R"({"operations": [{"op": "shapes", "on": "root", "svg": "box.svg", "size": 0.6}]})",
                 {"--curves", "borders.xyz"}));
    EXPECT_EQ(report().at("counts").at("leaves"), 2);
    // 0.5 from the middle to the sides; the box reaches 0.3 to its corners.
    const double side = 0.3 / std::sqrt(2.0);
    ASSERT_GT(borders().size(), 20u);
    for (const Point& p : borders()) {
        EXPECT_NEAR(std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5)), side, 1e-4);
    }
    done(command("square.off",
                 R"({"operations": [{"op": "shapes", "on": "root", "svg": "box.svg", "size": 0.6, "turn": 45}]})",
                 {"--curves", "borders.xyz"}));
    for (const Point& p : borders()) EXPECT_NEAR(std::abs(p[0] - 0.5) + std::abs(p[1] - 0.5), 0.3, 1e-4);
}

// What a ring encloses is the foreground, by the even-odd rule: its hole and what is around it are the background.
TEST_F(TangleLines, ShapesAreTheForeground) {
    done(command("sphere.off", R"({"operations": [
        {"name": "halves", "op": "contour", "on": "root", "from": {"points": [[0, 0, 1]]}, "delta": 1.5},
        {"name": "rings", "op": "shapes", "on": "halves", "svg": "ring.svg"},
        {"op": "group", "on": ["rings.background", "rings.foreground"]}]})"));
    EXPECT_EQ(report().at("counts").at("leaves"), 6);
    for (const auto& [which, count] :
         {std::pair{"rings.part:0", 2}, {"rings.foreground", 2}, {"rings.background", 4}}) {
        done(command("sphere.off", std::string(R"({"operations": [
            {"name": "halves", "op": "contour", "on": "root", "from": {"points": [[0, 0, 1]]}, "delta": 1.5},
            {"name": "rings", "op": "shapes", "on": "halves", "svg": "ring.svg"},
            {"op": "outline", "each": true, "size": 0.01, "on": ")") +
                                       which + "\"}]}"));
        EXPECT_EQ(report().at("counts").at("steps"), 2 + count) << which;
    }
}

TEST_F(TangleLines, ShapesThatCantBePlacedSayWhy) {
    const auto refuse = [&](const std::string& rest, const std::string& sentence) {
        expect_refused("sphere.off", R"({"operations": [{"op": "shapes", "on": "root")" + rest + "}]}", sentence);
    };
    refuse("", "script.operations[0]: needs `svg`");
    refuse(R"(, "svg": "none.svg")", "none.svg: can't be opened");
    refuse(R"(, "svg": 3)", "script.operations[0].svg");
    refuse(R"(, "svg": "box.svg")", "script.operations[0]: has no room in any of its regions");
    refuse(R"(, "svg": "box.svg", "size": -1)", "script.operations[0].size");
    refuse(R"(, "svg": "box.svg", "turn": "left")", "script.operations[0].turn");
    folder.write("bad.svg", "<svg><path d='M0 0 L1'/></svg>");
    refuse(R"(, "svg": "bad.svg")", "bad.svg:1: no number");
}

// In the plane the curve that bends least through four points of a circle is the periodic cubic spline: between them a
// 36th nearer to the middle (cubics with second derivatives towards it). A polyline would come to 0.21.
TEST_F(TangleLines, SmoothPolylinesAreSplines) {
    const std::string points = R"("from": {"points": [[0.8, 0.5, 0], [0.5, 0.8, 0], [0.2, 0.5, 0], [0.5, 0.2, 0]]})";
    done(
        command("square.off",
                R"({"operations": [{"op": "polyline", "on": "root", "closed": true, "smooth": true, )" + points + "}]}",
                {"--curves", "borders.xyz"}));
    EXPECT_EQ(report().at("counts").at("leaves"), 2);
    ASSERT_GT(borders().size(), 40u);
    for (const Point& p : borders()) EXPECT_NEAR(std::hypot(p[0] - 0.5, p[1] - 0.5), 0.3, 0.01);
}

TEST_F(TangleLines, SmoothPolylinesThatAreNoneSayWhy) {
    const std::string points = R"("from": {"points": [[0.8, 0.5, 0], [0.5, 0.8, 0]]})";
    const auto refuse = [&](const std::string& operation, const std::string& sentence) {
        expect_refused("square.off", R"({"operations": [{"on": "root", "smooth": true, )" + operation + "}]}",
                       sentence);
    };
    refuse(R"("op": "contour", )" + points, "script.operations[0].smooth: is for polylines");
    refuse(R"("op": "polyline", "from": {"borders": "outer"})", "script.operations[0].from: has no points");
    refuse(R"("op": "polyline", "from": {"points": [[0.8, 0.5, 0], [0.8, 0.5, 0]]})",
           "points 0 and 1 come to one place");
}

// The outermost of a disc's border, from its middle, as the wave leads it.
TEST_F(TangleLines, StylizedBordersAreTheRegionsBorders) {
    const std::string disc = R"({"name": "disc", "op": "contour", "on": "root", "from": {"points": [[0.5, 0.5, 0]]},
                                 "delta": 0.25})";
    const std::string wavy = R"({"name": "wavy", "op": "stylize", "on": "disc.foreground", "style": "wave.xyz",
                                 "size": 0.8})";
    done(command("square.off", R"({"operations": [)" + disc + "," + wavy + "]}"));
    const uint32_t steps = report().at("counts").at("steps");
    done(command("square.off", R"({"operations": [)" + disc + "," + wavy + R"(,
        {"op": "outline", "on": "wavy.foreground", "each": true, "size": 0.01}]})"));
    EXPECT_EQ(report().at("counts").at("steps"), steps + 1) << "what was won is part of the disc";
    done(command("square.off", R"({"operations": [)" + disc + "," + wavy + R"(,
        {"name": "rim", "op": "outline", "on": "wavy.foreground", "size": 0.01}]})",
                 {"--curves", "borders.xyz"}));
    double least = 1, most = 0;
    for (const Point& p : borders()) {
        const double radius = std::hypot(p[0] - 0.5, p[1] - 0.5);
        least = std::min(least, radius);
        most = std::max(most, radius);
    }
    // The wave is 0.04 high and low on the square; the rim is 0.01 within.
    EXPECT_NEAR(most, 0.25 + 0.04, 0.012);
    EXPECT_NEAR(least, 0.25 - 0.04 - 0.01, 0.012);
}

// A border that the surface's own cuts short is an open line.
TEST_F(TangleLines, StylizedBordersEndWhereTheSurfaceDoes) {
    done(command("square.off", R"({"operations": [
        {"name": "half", "op": "contour", "on": "root", "delta": 0.5,
         "from": {"stretches": [{"loop": 0, "end": 0.25}]}},
        {"name": "wavy", "op": "stylize", "on": "half.foreground", "style": "wave.xyz", "size": 0.8}]})",
                 {"--curves", "borders.xyz"}));
    Point least = {1, 1, 1}, most = {0, 0, 0};
    for (const Point& p : borders()) {
        for (size_t k = 0; k < 2; ++k) {
            least[k] = std::min(least[k], p[k]);
            most[k] = std::max(most[k], p[k]);
        }
    }
    EXPECT_NEAR(least[0], 0, 1e-6);
    EXPECT_NEAR(most[0], 1, 1e-6);
    // So that the ends stay, up to as much again as the wave is high is taken back.
    EXPECT_GT(least[1], 0.5 - 0.08);
    EXPECT_LT(least[1], 0.5 - 0.02);
    EXPECT_GT(most[1], 0.5 + 0.02);
    EXPECT_LT(most[1], 0.5 + 0.08);
}

TEST_F(TangleLines, StylizingWhatCantBeSaysWhy) {
    const auto refuse = [&](const std::string& rest, const std::string& sentence) {
        expect_refused("sphere.off", R"({"operations": [
            {"name": "cap", "op": "contour", "on": "root", "from": {"points": [[0, 0, 1]]}, "delta": 0.6},
            {"op": "stylize")" + rest + "}]}",
                       sentence);
    };
    refuse(R"(, "on": "root", "style": "wave.xyz", "size": 1)",
           "script.operations[1].on: has no borders on the surface");
    refuse(R"(, "on": "cap.foreground", "size": 1)", "script.operations[1]: needs `style`");
    refuse(R"(, "on": "cap.foreground", "style": "wave.xyz")", "script.operations[1]: needs `size`");
    refuse(R"(, "on": "cap.foreground", "style": "wave.xyz", "size": 0)", "script.operations[1].size: must be above 0");
    refuse(R"(, "on": "cap.foreground", "style": "none.xyz", "size": 1)", "none.xyz: can't be opened");
    refuse(R"(, "on": "cap.foreground", "style": "box.svg", "size": 1)", "box.svg");
    folder.write("dot.xyz", "1 2 3\n1 2 3\n");
    refuse(R"(, "on": "cap.foreground", "style": "dot.xyz", "size": 1)", "dot.xyz: has no length");
}

}  // namespace
}  // namespace flg::test
