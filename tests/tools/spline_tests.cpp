// SPDX-License-Identifier: MIT
// filigree spline: closed forms, every kind of surface, what its options do, refusals.
#include <cmath>
#include <sstream>

#include "cli_test.h"
#include "meshes.h"

namespace flg::test {
namespace {

using Strings = std::vector<std::string>;

class SplineCommand : public Cli {
protected:
    // Runs it without warnings, into out.xyz and report.json; all points.
    std::vector<Point> curve(const std::string& surface, const Strings& options = {}) const {
        Strings arguments = {"spline", surface, "points.xyz", "-o", "out.xyz", "--quiet", "--report", "report.json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        done(arguments);
        return read("out.xyz");
    }
    void points(const std::vector<Point>& list, const std::string& name = "points.xyz") const {
        folder.write(name, text_of(list));
    }
    static std::string text_of(const std::vector<Point>& list) {
        std::ostringstream text;
        text.precision(9);
        for (const Point& p : list) text << p[0] << " " << p[1] << " " << p[2] << "\n";
        return text.str();
    }
    std::vector<Point> read(const std::string& name) const {
        std::vector<Point> list;
        std::istringstream lines(folder.read(name));
        for (std::string line; std::getline(lines, line);) {
            Point p;
            std::istringstream words(line);
            if (words >> p[0] >> p[1] >> p[2]) list.push_back(p);
        }
        return list;
    }
    double quality(const char* name) const { return report().at("quality").at(name).get<double>(); }
};

std::vector<Point> around_torus() {
    std::vector<Point> list;
    for (int i = 0; i < 6; ++i) {
        const double u = 0.7 * i, v = 1.1 * std::sin(2.3 * i), ring = 1 + 0.4 * std::cos(v);
        list.push_back({ring * std::cos(u), ring * std::sin(u), 0.4 * std::sin(v)});
    }
    return list;
}

TestMesh torus_mesh(size_t n) {
    TestMesh mesh;
    mesh.add_grid(n, [](double s, double t) {
        const double u = 2 * std::acos(-1.0) * s, v = 2 * std::acos(-1.0) * t, ring = 1 + 0.4 * std::cos(v);
        return Point{ring * std::cos(u), ring * std::sin(u), 0.4 * std::sin(v)};
    });
    return mesh;
}

double off_torus(const Point& p) {
    return std::abs(std::hypot(std::hypot(p[0], p[1]) - 1, p[2]) - 0.4);
}

double largest_distance(const std::vector<Point>& a, const std::vector<Point>& b) {
    EXPECT_EQ(a.size(), b.size());
    double largest = 0;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, distance(a[i], b[i]));
    return largest;
}

TEST_F(SplineCommand, TwoPointsOfASphereAreJoinedByAGreatCircle) {
    points({{2, 0, 0}, {0, 0, 2}});
    for (const char* energy : {"e1", "e2", "et"}) {
        const auto list = curve("sphere:2", {"--points", "31", "--energy", energy});
        ASSERT_EQ(list.size(), 31u);
        for (size_t i = 0; i <= 30; ++i) {
            const double angle = std::acos(0.0) * static_cast<double>(i) / 30;
            EXPECT_LT(distance(list[i], {2 * std::cos(angle), 0, 2 * std::sin(angle)}), 2e-5) << energy << " " << i;
        }
    }
}

TEST_F(SplineCommand, InThePlaneItIsTheNaturalCubic) {
    points({{0, 0, 0.25}, {1, 1, 0}, {2, 0, 0}});
    const auto list = curve("plane", {"--points", "41"});
    ASSERT_EQ(list.size(), 41u);
    for (const Point& p : list) {
        const double x = p[0] <= 1 ? p[0] : 2 - p[0];
        EXPECT_NEAR(p[1], 1.5 * x - 0.5 * x * x * x, 1e-8);
        EXPECT_EQ(p[2], 0);
    }
    EXPECT_NEAR(quality("largest_offset"), 0.25, 1e-12);
    // Second derivatives fall linearly to -3 / h^2 and back, h the length of the first curve's segments: they are
    // alike, so it is not measured again.
    EXPECT_NEAR(quality("energy"), 6 / std::pow(2, 1.5), 1e-9);
}

TEST_F(SplineCommand, TheReportSaysHowItWent) {
    points(around_torus());
    curve("torus:1,0.4", {"--energy", "et", "--tension", "3"});
    const nlohmann::json json = report();
    EXPECT_EQ(json.at("command"), "spline");
    EXPECT_EQ(json.at("parameters").at("surface"), "torus:1,0.4");
    EXPECT_EQ(json.at("parameters").at("energy"), "et");
    EXPECT_EQ(json.at("parameters").at("tension"), 3.0);
    EXPECT_EQ(json.at("counts").at("points"), 6);
    EXPECT_EQ(json.at("counts").at("curve_points"), 5 * 32 + 1);
    EXPECT_GE(json.at("quality").at("iterations").get<int>(), 1);
    EXPECT_GT(json.at("quality").at("energy").get<double>(), 0);
    EXPECT_GT(json.at("quality").at("residual").get<double>(), 0);
    EXPECT_LE(json.at("quality").at("residual").get<double>(), 1e-6);
    EXPECT_GT(json.at("quality").at("length").get<double>(), 4);
    EXPECT_TRUE(json.at("stages").contains("minimize"));
}

TEST_F(SplineCommand, AFormulaAMeshAndACloudOfATorusGiveOneCurve) {
    points(around_torus());
    const TestMesh torus = torus_mesh(96);
    folder.write("torus.off", torus.off());
    folder.write("cloud.xyz", text_of(torus.points));
    const auto exact = curve("torus:1,0.4", {"--points", "150"}), mesh = curve("torus.off", {"--points", "150"});
    EXPECT_LT(quality("surface_deviation_max"), 2e-3);
    const auto cloud = curve("cloud.xyz", {"--points", "150"});
    EXPECT_EQ(report().at("counts").at("cloud_points"), torus.points.size());
    for (const Point& p : exact) EXPECT_LT(off_torus(p), 1e-8);
    for (const Point& p : mesh) EXPECT_LT(off_torus(p), 1e-3);
    for (const Point& p : cloud) EXPECT_LT(off_torus(p), 2e-3);
    EXPECT_LT(largest_distance(exact, mesh), 5e-3);
    EXPECT_LT(largest_distance(exact, cloud), 1e-2);
}

// The distance of a place from the triangles of a mesh that is convex around the place's nearest triangle, to rounding:
// the least over their planes where the place is within the triangle.
double off_triangles(const TestMesh& mesh, const Point& p) {
    double least = 1e9;
    for (const auto& t : mesh.triangles) {
        const Point a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
        Point u, v, w;
        for (size_t k = 0; k < 3; ++k) u[k] = b[k] - a[k], v[k] = c[k] - a[k], w[k] = p[k] - a[k];
        const auto dot = [](const Point& x, const Point& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; };
        const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v),
                     area = uu * vv - uv * uv;
        const double s = (vv * wu - uv * wv) / area, r = (uu * wv - uv * wu) / area;
        if (s < -1e-6 || r < -1e-6 || s + r > 1 + 1e-6) continue;
        Point off;
        for (size_t k = 0; k < 3; ++k) off[k] = w[k] - s * u[k] - r * v[k];
        least = std::min(least, std::sqrt(dot(off, off)));
    }
    return least;
}

TEST_F(SplineCommand, OverTrianglesAndOnTheMeshItLiesOnThem) {
    points(around_torus());
    const TestMesh torus = torus_mesh(48);
    folder.write("torus.off", torus.off());
    const auto first = curve("torus.off", {"--over-triangles"});
    ASSERT_EQ(first.size(), 5 * 32 + 1u);
    for (const Point& p : first) EXPECT_LT(off_triangles(torus, p), 1e-6);
    const auto smooth = curve("torus.off"), laid = curve("torus.off", {"--on-mesh"});
    EXPECT_GT(laid.size(), smooth.size());
    for (const Point& p : laid) EXPECT_LT(off_triangles(torus, p), 1e-6);
    EXPECT_GT(quality("largest_moved"), 0);
    EXPECT_LT(quality("largest_moved"), 5e-3);
    // Beside a curve without sharp bends, and away from the seams of the grid, by as much, all along.
    std::vector<Point> gentle;
    for (int i = 0; i < 6; ++i) {
        const double u = 0.5 + 0.5 * i, v = 1.5 + 0.4 * std::sin(1.3 * i), ring = 1 + 0.4 * std::cos(v);
        gentle.push_back({ring * std::cos(u), ring * std::sin(u), 0.4 * std::sin(v)});
    }
    points(gentle);
    const auto middle = curve("torus.off", {"--on-mesh"}),
               beside = curve("torus.off", {"--on-mesh", "--offset", "0.05"});
    for (size_t i = 0; i < beside.size(); ++i) {
        EXPECT_LT(off_triangles(torus, beside[i]), 1e-6);
        double nearest = 1e9;
        for (const Point& p : middle) nearest = std::min(nearest, distance(beside[i], p));
        EXPECT_NEAR(nearest, 0.05, 0.002) << i;
    }
    EXPECT_EQ(run({"spline", "torus:1,0.4", "points.xyz", "-o", "out.xyz", "--on-mesh"}).status, 2);
    expect_refused({"spline", "torus.off", "points.xyz", "-o", "out.xyz", "--on-mesh", "--offset-above", "1"}, 2,
                   {"--on-mesh takes --offset alone"});
}

TEST_F(SplineCommand, OffsetsLieBesideTheCurve) {
    points({{2, 0, 0}, {0, 2, 0}, {-2, 0, 0}, {0, -2, 0}});
    for (const Point& p : curve("sphere:2", {"--closed", "--offset", "0.5", "--offset-above", "0.1"})) {
        EXPECT_NEAR(std::hypot(p[0], p[1], p[2]), 2.1, 1e-5);
        EXPECT_NEAR(std::asin(p[2] / 2.1), 0.25, 1e-5);
    }
    for (const Point& p : curve("sphere:2", {"--closed", "--offset", "-0.5", "--offset-up", "0,0,1"})) {
        EXPECT_NEAR(std::hypot(p[0], p[1]), 2.5, 1e-5);
        EXPECT_NEAR(p[2], 0, 1e-5);
    }
    points({{-4, 4, 0}, {0, 0, 0}, {4, 4, 0}});
    EXPECT_LT(curve("space", {"--offset", "2", "--points", "201"}).size(), 201u);
    EXPECT_EQ(curve("space", {"--offset", "2", "--points", "201", "--offset-loops"}).size(), 201u);
    expect_refused({"spline", "space", "points.xyz", "-o", "out.xyz", "--offset-up", "0,0,1"}, 2,
                   {"need --offset or --offset-above"});
}

TEST_F(SplineCommand, CablesHangAndRest) {
    points({{-2, 0, 3}, {2, 0, 3}});
    const double a = 2, length = 2 * a * std::sinh(2 / a);
    const std::string text = std::to_string(length);
    const auto cable = curve("space", {"--cable", "--cable-lengths", text, "--cable-segments", "100"});
    ASSERT_EQ(cable.size(), 101u);
    EXPECT_NEAR(cable[50][2], 3 - (a * std::cosh(2 / a) - a), 1e-5);
    EXPECT_NEAR(quality("length"), length, 1e-5);
    folder.write("ground.json", R"({"obstacles": [{"half_space": {"through": [0, 0, 2.2], "outwards": [0, 0, 1]}}]})");
    const auto resting = curve("space", {"--cable", "--cable-lengths", text, "--obstacles", "ground.json"});
    for (const Point& p : resting) EXPECT_GT(p[2], 2.2 - 1e-5);
    EXPECT_NEAR(resting[32][2], 2.2, 1e-4);
    const Strings begin = {"spline", "space", "points.xyz", "-o", "out.xyz", "--cable"};
    const auto refused = [&](const Strings& options, int status, const std::string& words) {
        Strings arguments = begin;
        arguments.insert(arguments.end(), options.begin(), options.end());
        expect_refused(arguments, status, {words});
    };
    refused({"--cable-lengths", "3"}, 1, "lengths[0] is 3");
    refused({"--cable-lengths", "5,5"}, 2, "has 2 lengths, points.xyz has 1 spans");
    // What would do nothing is no option of a cable's.
    for (const Strings& more : {Strings{"--closed"}, {"--offset", "1"}, {"--road", "1"}, {"--points", "9"}})
        refused(more, 2, more[0].c_str());
    refused({"--cable-lengths", "5", "--slack", "0.1"}, 2, "--slack");
    expect_refused({"spline", "space", "points.xyz", "-o", "out.xyz", "--slack", "0.1"}, 2, {"--slack", "--cable"});
    refused({"--gravity", "0,0,0"}, 1, "gravity");
    expect_refused({"spline", "sphere:1", "points.xyz", "-o", "out.xyz", "--cable"}, 2, {"SURFACE must be space"});
}

TEST_F(SplineCommand, ComesAsFewCubicPiecesWithCorners) {
    points({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}});
    for (const std::string fit : {"bezier", "hermite"}) {
        curve("space", {"--corners", "1", "--fit", fit, "--fit-output", "fit.json", "--fit-tolerance", "1e-6"});
        const nlohmann::json json = nlohmann::json::parse(folder.read("fit.json"));
        EXPECT_EQ(json.at("fit"), fit);
        const nlohmann::json& only = json.at("curves").at(0);
        EXPECT_LE(only.at("largest_error").get<double>(), 1e-6);
        // Straight to the corner and straight on.
        if (fit == "bezier") {
            ASSERT_EQ(only.at("control_points").size(), 7u);
            EXPECT_NEAR(only.at("control_points").at(1).at(0).get<double>(), 1.0 / 3, 1e-6);
            EXPECT_NEAR(only.at("control_points").at(4).at(1).get<double>(), 2.0 / 3, 1e-6);
        } else {
            ASSERT_EQ(only.at("points").size(), 3u);
            EXPECT_NEAR(only.at("leaving").at(1).at(1).get<double>(), -std::sqrt(0.5), 1e-6);
            EXPECT_NEAR(only.at("arriving").at(1).at(1).get<double>(), std::sqrt(0.5), 1e-6);
        }
    }
    EXPECT_EQ(run({"spline", "space", "points.xyz", "-o", "out.xyz", "--fit", "bezier"}).status, 2);
}

// A curve's own points are on the surface that it was made on, and it passes through the given ones' places there.
TEST_F(SplineCommand, EveryFormulaKeepsItsCurve) {
    points({{0.9, 0.1, 0.2}, {0.85, 0.2, 0.25}, {0.75, 0.25, 0.35}, {0.7, 0.4, 0.3}});
    const Outcome outcome = run({"spline", "implicit:?", "points.xyz", "-o", "out.xyz"});
    EXPECT_EQ(outcome.status, 2);
    const std::string list = outcome.err.substr(outcome.err.find("none of ") + 8);
    std::istringstream names(list.substr(0, list.find('\n')));
    size_t count = 0;
    for (std::string name; std::getline(names >> std::ws, name, ','); ++count) {
        SCOPED_TRACE(name);
        const auto made = curve("implicit:" + name, {"--points", "40"});
        EXPECT_EQ(made.size(), 40u);
        EXPECT_EQ(report().at("warnings").size(), 0u);
        folder.write("back.xyz", folder.read("out.xyz"));
        done({"spline", "implicit:" + name, "back.xyz", "-o", "again.xyz", "--quiet", "--report", "report.json"});
        EXPECT_LT(quality("largest_offset"), 1e-6);
    }
    EXPECT_GE(count, 6u);
}

TEST_F(SplineCommand, ClosedCurvesComeRound) {
    points({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}});
    const auto list = curve("sphere:1", {"--closed", "--points", "64"});
    ASSERT_EQ(list.size(), 64u);
    for (size_t i = 0; i < 64; ++i) {
        const double angle = 4 * std::acos(0.0) * static_cast<double>(i) / 64;
        EXPECT_LT(distance(list[i], {std::cos(angle), std::sin(angle), 0}), 1e-5);
    }
    EXPECT_TRUE(folder.read("out.xyz").starts_with("# closed\n"));
    // As a file says it of one of its curves.
    folder.write("closed.xyz", "# closed\n" + folder.read("points.xyz") + "\n0 0 1\n1 0 0\n");
    done(
        {"spline", "sphere:1", "closed.xyz", "-o", "both.xyz", "--quiet", "--points", "64", "--report", "report.json"});
    EXPECT_EQ(report().at("counts").at("curves"), 2);
    EXPECT_EQ(report().at("counts").at("curve_points"), 128);
    EXPECT_TRUE(folder.read("both.xyz").starts_with(folder.read("out.xyz"))) << "each as if it were alone";
}

TEST_F(SplineCommand, AsManyPointsAsWereAskedFor) {
    points(around_torus());
    for (const size_t count : {11, 12, 50, 333}) {
        EXPECT_EQ(curve("torus:1,0.4", {"--points", std::to_string(count)}).size(), count);
        EXPECT_EQ(report().at("counts").at("curve_points"), count);
    }
}

TEST_F(SplineCommand, EnergiesGoFromShortToSmooth) {
    points(around_torus());
    std::vector<double> lengths;
    for (const Strings& energy : std::vector<Strings>{{"--energy", "e1"},
                                                      {"--energy", "et", "--tension", "100"},
                                                      {"--energy", "et", "--tension", "3"},
                                                      {"--energy", "e2"}}) {
        curve("torus:1,0.4", energy);
        lengths.push_back(quality("length"));
    }
    for (size_t i = 1; i < lengths.size(); ++i) EXPECT_GT(lengths[i], lengths[i - 1]);
}

TEST_F(SplineCommand, SmoothingLeavesThePoints) {
    const auto given = around_torus();
    points(given);
    double last = 0;
    for (const char* smoothing : {"0", "0.001", "0.1"}) {
        const auto list = curve("torus:1,0.4", {"--smoothing", smoothing, "--points", "101"});
        double farthest = 0;
        for (const Point& p : given) {
            double nearest = 1e9;
            for (const Point& q : list) nearest = std::min(nearest, distance(p, q));
            farthest = std::max(farthest, nearest);
        }
        for (const Point& p : list) EXPECT_LT(off_torus(p), 1e-8);
        if (last == 0) {
            EXPECT_LT(farthest, 1e-7);
        } else {
            EXPECT_GT(farthest, 3 * last);
        }
        last = std::max(farthest, 1e-4);
    }
    const auto newton = curve("torus:1,0.4");
    EXPECT_EQ(largest_distance(newton, curve("torus:1,0.4", {"--method", "newton"})), 0);
    EXPECT_LT(largest_distance(newton, curve("torus:1,0.4", {"--tolerance", "1e-9"})), 1e-5);
}

TEST_F(SplineCommand, TheFootpointConeHasLeftTheProduct) {
    points(around_torus());
    const auto refused = [&](const std::string& method, const std::string& words) {
        expect_refused({"spline", "torus:1,0.4", "points.xyz", "-o", "out.xyz", "--method", method}, 2, {words});
    };
    refused("cone", "--method: the footpoint cone has left the product, newton is the one method");
    refused("descent", "--method: 'descent' is not newton");
}

TEST_F(SplineCommand, HeightLiftsAlongNormals) {
    points({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    for (const Point& p : curve("sphere:1", {"--height", "0.25"})) {
        EXPECT_NEAR(std::hypot(p[0], p[1], p[2]), 1.25, 1e-7);
    }
    points(around_torus());
    for (const Point& p : curve("torus:1,0.4", {"--height", "-0.1"})) EXPECT_NEAR(off_torus(p), 0.1, 1e-7);
}

// A prism's edge is between the points: with a weight of the normals the way over it is taken where it is needed.
TEST_F(SplineCommand, FeaturesKeepItOnItsSide) {
    points({{0.9, 0.5, 0.2}, {0.9, -0.1, 0.3}, {0.9, -0.6, -0.2}, {0.2, -0.9, -0.4}});
    const auto plain = curve("implicit:rounded_cube"), sensitive = curve("implicit:rounded_cube", {"--feature", "0.5"});
    EXPECT_EQ(report().at("parameters").at("feature"), 0.5);
    EXPECT_GT(largest_distance(plain, sensitive), 1e-3);
    folder.write("back.xyz", text_of(sensitive));
    done({"spline", "implicit:rounded_cube", "back.xyz", "-o", "again.xyz", "--quiet", "--report", "report.json"});
    EXPECT_LT(quality("largest_offset"), 1e-6);
}

TEST_F(SplineCommand, KeepsOutOfObstaclesOnTheSideThatIsAskedFor) {
    points({{-2, 0, 0}, {2, 0.25, 0}});
    const auto file = [&](const std::string& sides) {
        folder.write("ball.json",
                     R"({"clearance": 0.1, "obstacles": [{"ball": {"centre": [0, 0], "radius": 0.4}}])" + sides + "}");
    };
    for (const double side : {1.0, -1.0}) {
        file(R"(, "sides": [{"obstacle": 0, "direction": [0, )" + std::to_string(side) + "]}]");
        double least = 1e9;
        for (const Point& p : curve("plane", {"--obstacles", "ball.json"})) {
            least = std::min(least, std::hypot(p[0], p[1]));
            EXPECT_EQ(p[2], 0);
            if (std::abs(p[0]) < 0.3) {
                EXPECT_GT(side * p[1], 0);
            }
        }
        EXPECT_GT(least, 0.5 - 1e-6);
        EXPECT_LT(least, 0.53);
    }
    points({{-2, 0, 0}, {2, 0, 0}});
    folder.write("box.json", R"({"obstacles": [{"box": {"centre": [0, 0.1, 0.2], "half": [0.5, 0.5, 0.5]}}]})");
    for (const Point& p : curve("space", {"--obstacles", "box.json"})) {
        const double away = std::max({std::abs(p[0]), std::abs(p[1] - 0.1), std::abs(p[2] - 0.2)}) - 0.5;
        EXPECT_GT(away, -1e-6);
    }
}

TEST_F(SplineCommand, KeepsOutOfSolidsThatCutASurface) {
    points({{0.1, 0.1, 0}, {0.9, 0.9, 0}});
    folder.write("square.off", square(12).off());
    folder.write("ball.json", R"({"obstacles": [{"ball": {"centre": [0.5, 0.5, 0], "radius": 0.2}}]})");
    for (const Strings& more : std::vector<Strings>{{}, {"--inside"}}) {
        Strings options = {"--obstacles", "ball.json"};
        options.insert(options.end(), more.begin(), more.end());
        double nearest = 1e9;
        for (const Point& p : curve("square.off", options))
            nearest = std::min(nearest, std::hypot(p[0] - 0.5, p[1] - 0.5));
        EXPECT_GT(nearest, 0.2 - 1e-6);
        EXPECT_LT(nearest, 0.21);
    }
    // A mesh is a solid too; it is looked for beside the file.
    folder.write("cube.off",
                 "OFF\n8 12 0\n0.4 0.4 -1\n0.6 0.4 -1\n0.6 0.6 -1\n0.4 0.6 -1\n0.4 0.4 1\n0.6 0.4 1\n0.6 0.6 1\n"
                 "0.4 0.6 1\n3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n"
                 "3 3 0 4\n3 3 4 7\n");
    folder.write("cube.json", R"({"obstacles": [{"mesh": "cube.off"}]})");
    double nearest = 1e9;
    for (const Point& p : curve("square.off", {"--obstacles", "cube.json"}))
        nearest = std::min(nearest, std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5)) - 0.1);
    EXPECT_GT(nearest, -0.01) << "half a cell of the grid that meshes are known by";
    EXPECT_LT(nearest, 0.03);
}

// As far beyond the square's border as its surface goes, a quarter of an edge, if nothing holds it.
TEST_F(SplineCommand, StaysBetweenTheBordersOfAnOpenMesh) {
    folder.write("square.off", square(8).off());
    points({{0.1, 0.8, 0}, {0.3, 0.99, 0}, {0.7, 0.99, 0}, {0.9, 0.8, 0}});
    const auto farthest = [&](const Strings& options) {
        double beyond = 0;
        for (const Point& p : curve("square.off", options)) {
            EXPECT_NEAR(p[2], 0, 1e-3);
            beyond = std::max({beyond, p[0] - 1, p[1] - 1, -p[0], -p[1]});
        }
        return beyond;
    };
    const double free = farthest({});
    EXPECT_GT(free, 0.01);
    EXPECT_LT(farthest({"--inside"}), 1e-3);
    // A layer reaches as far beyond borders as it is thick.
    EXPECT_LT(farthest({"--layer", "0.025"}), 0.025 + 1e-3);
    EXPECT_EQ(report().at("parameters").at("layer"), 0.025);
    EXPECT_GT(free, 0.027) << "or the layer is not needed";
    for (const Strings& option : std::vector<Strings>{{"--inside"}, {"--layer", "0.1"}}) {
        Strings arguments = {"spline", "sphere:1", "points.xyz", "-o", "no.xyz"};
        arguments.insert(arguments.end(), option.begin(), option.end());
        expect_refused(arguments, 2, {"SURFACE must be a mesh, not sphere:1"});
    }
    EXPECT_FALSE(folder.has("no.xyz"));
}

TEST_F(SplineCommand, SameBytesWhateverRunsIt) {
    points(around_torus());
    folder.write("torus.off", torus_mesh(40).off());
    for (const char* surface : {"torus:1,0.4", "torus.off"}) {
        done({"spline", surface, "points.xyz", "-o", "a.xyz", "--quiet", "--workers", "0"});
        done({"spline", surface, "points.xyz", "-o", "b.xyz", "--quiet", "--workers", "2", "--budget", "50"});
        EXPECT_EQ(folder.read("a.xyz"), folder.read("b.xyz"));
        EXPECT_EQ(read("a.xyz").size(), 161u);
    }
}

// Rough ground: through a scale fewer rounds are needed, and no point is held.
TEST_F(SplineCommand, SeesRoughMeshesThroughAScale) {
    points({{-1.5, -1, 0}, {-0.5, 1, 0}, {0.4, -0.8, 0}, {1.2, 0.9, 0}, {1.6, -1.2, 0}});
    TestMesh rough;
    uint32_t state = 1;
    rough.add_grid(80, [&](double s, double t) {
        state = state * 1664525u + 1013904223u;
        return Point{4 * s - 2, 4 * t - 2, 0.04 * state / 4294967296.0};
    });
    folder.write("rough.off", rough.off());
    Strings arguments = {"spline", "rough.off", "points.xyz", "-o", "out.xyz", "--report", "report.json"};
    done(arguments);
    const double rounds = report().at("quality").at("iterations");
    arguments.insert(arguments.end(), {"--smoothing-scale", "0.2", "--quiet"});
    done(arguments);
    EXPECT_LT(report().at("quality").at("iterations"), 0.7 * rounds);
    EXPECT_EQ(report().at("parameters").at("smoothing_scale"), 0.2);
    EXPECT_FALSE(report().at("counts").contains("held_points"));
    expect_refused({"spline", "rough.off", "points.xyz", "-o", "no.xyz", "--smoothing-scale", "1e9"}, 1,
                   {"desc.smoothing_scale is 1e+09 m, and the surface has a size of"});
    expect_refused({"spline", "sphere:1", "points.xyz", "-o", "no.xyz", "--smoothing-scale", "1"}, 2,
                   {"--smoothing-scale: SURFACE must be a mesh or a cloud, not sphere:1"});
    EXPECT_FALSE(folder.has("no.xyz"));
}

TEST_F(SplineCommand, WritesWhatOtherCommandsRead) {
    points(around_torus());
    for (const char* name : {"out.obj", "out.glb", "out.xyz"}) {
        done({"spline", "torus:1,0.4", "points.xyz", "-o", name, "--quiet", "--points", "77"});
        EXPECT_NE(done({"info", name}).out.find("77"), std::string::npos) << name;
    }
}

TEST_F(SplineCommand, RefusesSurfacesItDoesNotKnow) {
    points({{1, 0, 0}, {0, 1, 0}});
    const auto refused = [&](const std::string& surface, int status, const std::string& words) {
        expect_refused({"spline", surface, "points.xyz", "-o", "out.xyz"}, status, {words});
        EXPECT_FALSE(folder.has("out.xyz")) << surface;
    };
    refused("implicit:none", 2, "SURFACE: implicit:none is none of blobs, ellipsoid");
    refused("implicit:", 2, "SURFACE: implicit: is none of");
    refused("torus:1", 2, "SURFACE: torus:1 must be torus:R,r");
    refused("torus:1,x", 2, "SURFACE: 'x' in torus:1,x is not a number");
    refused("torus:1,", 2, "is not a number");
    refused("torus:1,2", 2, "desc.tube_radius is 2");
    refused("sphere", 2, "must be sphere:R");
    refused("sphere:-1", 2, "desc.radius is -1");
    refused("sphere:nan", 2, "sphere:nan");
    refused("none.ply", 1, "none.ply: can't be opened");
    refused("none.xyz", 1, "none.xyz: can't be opened");
    refused("cube", 1, "cube");
    folder.write("few.xyz", "0 0 0\n1 0 0\n0 1 0\n");
    refused("few.xyz", 1, "few.xyz");
    folder.write("broken.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
    refused("broken.off", 1, "broken.off");
}

TEST_F(SplineCommand, RefusesPointsItCantUse) {
    const auto refused = [&](const std::string& text, const std::string& words, const Strings& options = {}) {
        folder.write("points.xyz", text);
        Strings arguments = {"spline", "sphere:1", "points.xyz", "-o", "out.xyz", "--quiet"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        expect_refused(arguments, 1, {"points.xyz", words});
        EXPECT_FALSE(folder.has("out.xyz")) << text;
    };
    refused("", "holds no points");
    refused("1 0 0\n", "desc.point_count is 1, must be 2");
    refused("1 0 0\n0 1 0\n", "desc.point_count is 2, must be 3", {"--closed"});
    refused("1 0 0\n2 0 0\n0 1 0\n", "points 0 and 1 come to one place");
    refused("1 0 0\n0 1 0\n1 0 0\n", "points 2 and 0 come to one place", {"--closed"});
    refused("0 0 0\n0 1 0\n", "point 0 can't be projected onto the manifold");
    refused("1 0 0\n2 x 0\n", "the y is no number");
    refused("1 0 0\n0 nan 0\n", "points.xyz");
    refused("1 0 0\n0 1 0\n\n1 0 0\n2 0 0\n", "curve 1: ");
    expect_refused({"spline", "plane", "none.xyz", "-o", "out.xyz"}, 1, {"none.xyz: can't be opened"});
}

TEST_F(SplineCommand, RefusesObstaclesItCantUse) {
    points({{-2, 0, 0}, {2, 0, 0}});
    const auto refused = [&](const std::string& json, const std::string& words) {
        folder.write("bad.json", json);
        expect_refused({"spline", "plane", "points.xyz", "-o", "out.xyz", "--obstacles", "bad.json"}, 1, {words});
        EXPECT_FALSE(folder.has("out.xyz")) << json;
    };
    const auto with = [](const std::string& obstacle) { return R"({"obstacles": [)" + obstacle + "]}"; };
    refused(with(R"({"ball": {"centre": [2, 0.5], "radius": 1}})"), "point 1 is 0.5 inside of obstacle 0");
    refused(with(R"({"ball": {"centre": [0, 0, 0], "radius": 1}})"), "obstacles[0].ball.centre: has 3 numbers");
    refused(with(R"({"ball": {"centre": [0, 0], "radius": -1}})"), "obstacles[0].ball.radius: must be a number");
    refused(with(R"({"ball": {"centre": [0, 0]}})"), "obstacles[0].ball: needs `radius`");
    refused(with(R"({"bal": 1})"), "obstacles[0]: does not know `bal`");
    refused(with("{}"), "obstacles[0]: must have one of ball");
    refused(with(R"({"polygon": [[0, 0], [1, 0]]})"), "bad.json");
    refused(with(R"({"box": {"centre": [0, 0], "half": [1, 0]}})"), "bad.json");
    refused(with(""), "desc.obstacle_count is 0");
    refused("{}", "needs `obstacles`");
    refused("{", "bad.json: ");
    const std::string ball = R"({"obstacles": [{"ball": {"centre": [0, 0], "radius": 1}}], "sides": [)";
    refused(ball + R"({"obstacle": 1, "direction": [0, 1]}]})", "sides[0].obstacle: must be a whole number");
    refused(ball + R"({"obstacle": 0, "direction": [0]}]})", "sides[0].direction: has 1 numbers");
    expect_refused({"spline", "plane", "points.xyz", "-o", "out.xyz", "--obstacles", "none.json"}, 1, {"none.json"});
}

TEST_F(SplineCommand, RefusesBadOptions) {
    points({{1, 0, 0}, {0, 1, 0}});
    const auto refused = [&](const Strings& options, const std::string& words) {
        Strings arguments = {"spline", "sphere:1", "points.xyz", "-o", "out.xyz"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        expect_refused(arguments, 2, {words});
        EXPECT_FALSE(folder.has("out.xyz"));
    };
    refused({"--energy", "e4"}, "--energy: 'e4' is none of e1|e2|et");
    refused({"--tension", "0"}, "--tension");
    refused({"--points", "-4"}, "--points");
    refused({"--points", "2000000"}, "--points");
    refused({"--smoothing", "-1"}, "--smoothing");
    refused({"--tolerance", "0"}, "--tolerance");
    refused({"--rounds", "0"}, "--rounds");
    refused({"--height", "nan"}, "--height");
    refused({"--feature", "-1"}, "--feature");
    refused({"--start", "here"}, "--start");
    refused({"--method", "guess"}, "--method");
    expect_refused({"spline", "sphere:1", "points.xyz", "-o", "out.ply"}, 2, {"out.ply"});
    expect_refused({"spline", "sphere:1", "points.xyz", "-o", "none/out.xyz"}, 1, {"none/out.xyz"});
    expect_refused({"spline", "sphere:1"}, 2, {"POINTS"});
}

}  // namespace
}  // namespace flg::test
