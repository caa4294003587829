// SPDX-License-Identifier: MIT
// filigree path: lengths against closed forms.
#include "cli_test.h"
#include "meshes.h"

namespace flg::test {
namespace {

class Path : public Cli {
protected:
    // The points of the path.
    std::vector<Point> path(const std::string& mesh, const std::string& from, const std::string& to,
                            const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments = {"path", mesh,       "--from",  from,       "--to",       to,
                                              "-o",   "path.xyz", "--quiet", "--report", "report.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        done(arguments);
        std::istringstream text(folder.read("path.xyz"));
        std::vector<Point> points;
        for (Point p; text >> p[0] >> p[1] >> p[2];) points.push_back(p);
        EXPECT_EQ(report().at("counts").at("path_points"), points.size());
        return points;
    }

    double reported_length() const { return report().at("quality").at("length"); }
};

double length_of(const std::vector<Point>& points) {
    double length = 0.0;
    for (size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
    return length;
}

TEST_F(Path, InThePlaneItIsStraight) {
    const TestMesh mesh = square(12);
    folder.write("square.off", mesh.off());
    const size_t from = 13 + 2, to = 11 * 13 + 9;
    const std::vector<Point> points = path("square.off", std::to_string(from), std::to_string(to));
    const double straight = distance(mesh.points[from], mesh.points[to]);
    ASSERT_GT(points.size(), 2u);
    EXPECT_NEAR(distance(points.front(), mesh.points[from]), 0.0, 1e-6);
    EXPECT_NEAR(distance(points.back(), mesh.points[to]), 0.0, 1e-6);
    EXPECT_NEAR(length_of(points), straight, 1e-5);
    EXPECT_NEAR(reported_length(), straight, 1e-6);
    EXPECT_EQ(report().at("command"), "path");
}

#if defined(FLG_WITH_PICK)
TEST_F(Path, EndsMayBePointsInSpace) {
    folder.write("square.off", square(12).off());
    const std::vector<Point> points = path("square.off", "0.11,0.23,1", "0.87,0.71,-2");
    EXPECT_NEAR(distance(points.front(), {0.11, 0.23, 0}), 0.0, 1e-6);
    EXPECT_NEAR(distance(points.back(), {0.87, 0.71, 0}), 0.0, 1e-6);
    EXPECT_NEAR(reported_length(), std::hypot(0.76, 0.48), 1e-6);
    EXPECT_NEAR(report().at("quality").at("from_gap").get<double>(), 1.0, 1e-6);
    EXPECT_NEAR(report().at("quality").at("to_gap").get<double>(), 2.0, 1e-6);
}
#endif

TEST_F(Path, OnACubeItUnfoldsStraight) {
    const size_t n = 8;
    const TestMesh mesh = cube(n);
    folder.write("cube.off", mesh.off());
    const auto vertex_at = [&](const Point& p) {
        size_t v = 0;
        while (v < mesh.points.size() && distance(mesh.points[v], p) > 1e-9) ++v;
        return std::to_string(v);
    };
    const auto length = [&](const Point& from, const Point& to) {
        const std::vector<Point> points = path("cube.off", vertex_at(from), vertex_at(to));
        EXPECT_NEAR(length_of(points), reported_length(), 1e-5);
        return reported_length();
    };
    // From the middle of a side to that of the next, over the edge between them.
    EXPECT_NEAR(length({0.5, 0.5, 1}, {1, 0.5, 0.5}), 1.0, 1e-6);
    // Both sides laid flat: 1/4 + 1/2 across, 1/2 along.
    EXPECT_NEAR(length({0.75, 0.25, 1}, {1, 0.75, 0.5}), std::hypot(0.75, 0.5), 1e-6);
    // Opposite corners: two sides laid flat are 2 by 1.
    EXPECT_NEAR(length({0, 0, 0}, {1, 1, 1}), std::sqrt(5.0), 1e-6);
    // Middles of opposite sides.
    EXPECT_NEAR(length({0.5, 0.5, 0}, {0.5, 0.5, 1}), 2.0, 1e-6);
}

TEST_F(Path, WritesAllFormats) {
    folder.write("square.off", square(4).off());
    for (const char* out : {"a.xyz", "a.obj", "a.glb"}) {
        done({"path", "square.off", "--from", "0", "--to", "24", "-o", out});
        done({"info", out, "--report", "report.json"});
        EXPECT_EQ(report().at("counts").at("curves"), 1) << out;
        EXPECT_NEAR(report().at("quality").at("total_length").get<double>(), std::sqrt(2.0), 1e-5) << out;
    }
}

TEST_F(Path, SameBitsWhateverTheWorkersAndTheBudget) {
    folder.write("sphere.off", sphere(20).off());
    std::string first;
    for (const char* workers : {"0", "2"}) {
        for (const char* budget : {"0", "100"}) {
            path("sphere.off", "17", kPlace, {"--workers", workers, "--budget", budget});
            const std::string curve = folder.read("path.xyz");
            if (first.empty()) first = curve;
            EXPECT_TRUE(curve == first) << workers << " workers, budget " << budget;
        }
    }
}

TEST_F(Path, BadUsageExitsWithTwo) {
    folder.write("square.off", square(1).off());
    expect_refused({"path", "square.off", "--from", "0", "-o", "a.xyz"}, 2, {"--to"});
    expect_refused({"path", "square.off", "--to", "0", "-o", "a.xyz"}, 2, {"--from"});
    expect_refused({"path", "square.off", "--from", "0", "--to", "3"}, 2, {"--output"});
    expect_refused({"path", "square.off", "--from", "0;1", "--to", "3", "-o", "a.xyz"}, 2, {"--from", "'0;1'"});
    expect_refused({"path", "square.off", "--from", "0", "--to", "1,2", "-o", "a.xyz"}, 2, {"--to", "'1,2'"});
    expect_refused({"path", "square.off", "--from", "0", "--to", "3", "-o", "a.ply"}, 2,
                   {"a.ply", ".xyz, .obj or .glb"});
    EXPECT_EQ(folder.list(), std::vector<std::string>{"square.off"});
}

TEST_F(Path, BadInputExitsWithOneAndIsNamed) {
    TestMesh mesh = square(1);
    mesh.add_grid(1, [](double u, double v) { return Point{5 + u, v, 0.0}; });
    folder.write("two.off", mesh.off());
    const auto refused = [&](const std::string& file, const std::string& from, const std::string& to,
                             const std::vector<std::string>& words) {
        expect_refused({"path", file, "--from", from, "--to", to, "-o", "a.xyz"}, 1, words);
    };
    refused("two.off", "0", "4", {"two.off: --from 0 --to 4: ", "no way leads from vertex 0 to vertex 4"});
    refused("two.off", "8", "0", {"two.off: --from: there is no vertex 8, they are 0 to 7"});
    refused("two.off", "0", "8", {"two.off: --to: there is no vertex 8"});
    refused("two.off", "5", "5", {"two.off: --from 5 --to 5: ", "the same place"});
    refused("nosuch.off", "0", "1", {"nosuch.off"});
    EXPECT_EQ(folder.list(), std::vector<std::string>{"two.off"});
}

}  // namespace
}  // namespace flg::test
