// SPDX-License-Identifier: MIT
// The built-in scene: what benchmarks and pictures rest on.
#include "scenes/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

namespace flg::scenes {
namespace {

using State = std::array<double, 3>;

bool same_bits(const Curve& a, const Curve& b) {
    return a.points.size() == b.points.size() && a.radii == b.radii &&
           std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(Point)) == 0;
}

double distance(const Point& a, const Point& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

void expect_usable(const Curve& curve, const std::string& name) {
    for (const Point& p : curve.points) {
        ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) << name;
    }
    for (size_t i = 1; i < curve.points.size(); ++i) {
        ASSERT_GT(distance(curve.points[i - 1], curve.points[i]), 0.0) << name << " repeats point " << i;
    }
    if (!curve.radii.empty()) {
        ASSERT_EQ(curve.radii.size(), curve.points.size()) << name;
        EXPECT_GT(*std::min_element(curve.radii.begin(), curve.radii.end()), 0.0f) << name;
    }
}

State add(const State& p, const State& v, double h) {
    return {p[0] + h * v[0], p[1] + h * v[1], p[2] + h * v[2]};
}

// A method of another kind than the generator's: Heun's, in many small steps.
State integrate(const Attractor& attractor, State p, double time) {
    constexpr int kSteps = 400;
    const double h = time / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        const State a = attractor.velocity(p);
        const State b = attractor.velocity(add(p, a, h));
        p = {p[0] + 0.5 * h * (a[0] + b[0]), p[1] + 0.5 * h * (a[1] + b[1]), p[2] + 0.5 * h * (a[2] + b[2])};
    }
    return p;
}

// Undoes the picture's turn, scale and shift.
State state_of(const Attractor& attractor, const Point& p) {
    const double s = attractor.metres;
    return {p.x / s + attractor.centre[0], -p.z / s + attractor.centre[1], p.y / s + attractor.centre[2]};
}

void expect_trajectory(const Attractor& attractor, const Curve& curve) {
    for (size_t i = 0; i + 1 < curve.points.size(); i += 37) {
        const State predicted = integrate(attractor, state_of(attractor, curve.points[i]), attractor.step);
        const State actual = state_of(attractor, curve.points[i + 1]);
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(predicted[c], actual[c], 2e-5) << "after point " << i;
    }
}

TEST(Scenes, StylesHaveTheirCountsAndNoRepeatedPoints) {
    ASSERT_EQ(library_names().size(), 24u);
    for (const std::string& name : library_names()) {
        const Curve style = make_style(name);
        EXPECT_GE(style.points.size(), 150u) << name;
        EXPECT_LE(style.points.size(), 600u) << name;
        EXPECT_FALSE(style.closed) << name;
        EXPECT_EQ(style.radii.size(), style.points.size()) << name;
        expect_usable(style, name);
    }
}

TEST(Scenes, StylesDifferFromEachOtherAndFromTheirMirrorImage) {
    for (const std::string& name : library_names()) {
        for (const std::string& other : library_names()) {
            EXPECT_EQ(same_bits(make_style(name), make_style(other)), name == other);
        }
        // Drawn by hand: the second half is not the first half again.
        const Curve style = make_style(name);
        const size_t half = style.points.size() / 2;
        double difference = 0.0;
        for (size_t i = 0; i < half; ++i) {
            difference += std::abs(style.points[i].y - style.points[half + i].y) / static_cast<double>(half);
        }
        EXPECT_GT(difference, 1e-3) << name;
    }
}

TEST(Scenes, TargetsHaveTheCountAskedFor) {
    for (const std::string& name : target_names()) {
        for (uint32_t count : {2u, 3u, 500u, 12345u}) {
            const Curve target = make_target(name, count);
            EXPECT_EQ(target.points.size(), count) << name;
            expect_usable(target, name);
        }
        EXPECT_GE(make_target(name).points.size(), 200u) << name;
    }
    EXPECT_EQ(make_target("thomas").points.size(), 369400u);
}

TEST(Scenes, UnknownNamesGiveNothing) {
    EXPECT_TRUE(make_style("nosuch").points.empty());
    EXPECT_TRUE(make_target("nosuch").points.empty());
    EXPECT_TRUE(make_target("").points.empty());
}

TEST(Scenes, SameNameSameBits) {
    for (const std::string& name : library_names()) EXPECT_TRUE(same_bits(make_style(name), make_style(name))) << name;
    for (const std::string& name : target_names()) {
        EXPECT_TRUE(same_bits(make_target(name, 5000), make_target(name, 5000))) << name;
    }
}

TEST(Scenes, LongerAttractorsContinueShorterOnes) {
    for (const char* name : {"lorenz", "thomas"}) {
        const Curve longer = make_target(name, 4000);
        Curve head = longer;
        head.points.resize(1500);
        EXPECT_TRUE(same_bits(head, make_target(name, 1500))) << name;
    }
}

TEST(Scenes, LorenzIsATrajectoryOfItsEquations) {
    expect_trajectory(lorenz(), make_target("lorenz", 8000));
}

TEST(Scenes, ThomasIsATrajectoryOfItsEquations) {
    expect_trajectory(thomas(), make_target("thomas", 8000));
}

TEST(Scenes, AttractorsStayInTheirTrappingRegions) {
    // rho x^2 + sigma y^2 + sigma (z - 2 rho)^2 can't grow where it is above sigma rho^2 beta^2 / (beta - 1).
    const double rho = 28.0, sigma = 10.0, beta = 8.0 / 3.0;
    const double most = sigma * rho * rho * beta * beta / (beta - 1.0);
    for (const Point& p : make_target("lorenz", 50000).points) {
        const State s = state_of(lorenz(), p);
        const double height = s[2] - 2.0 * rho;
        EXPECT_LE(rho * s[0] * s[0] + sigma * (s[1] * s[1] + height * height), most);
    }
    // |sin| <= 1, so |x| can't grow where it is above 1 / b.
    for (const Point& p : make_target("thomas", 50000).points) {
        for (double c : state_of(thomas(), p)) EXPECT_LE(std::abs(c), 1.0 / 0.208186);
    }
}

TEST(Scenes, AllScenesAreUsableAndTheSameEachTime) {
    for (const std::string& name : scene_names()) {
        const Scene scene = make_scene(name), again = make_scene(name);
        EXPECT_GE(scene.curves.size(), 10u) << name;
        ASSERT_EQ(scene.curves.size(), again.curves.size());
        for (size_t c = 0; c < scene.curves.size(); ++c) {
            expect_usable(scene.curves[c], name);
            EXPECT_FALSE(scene.curves[c].radii.empty()) << name;
            EXPECT_TRUE(same_bits(scene.curves[c], again.curves[c])) << name;
        }
    }
    EXPECT_TRUE(make_scene("nosuch").curves.empty());
}

// How many curves end at each place, bit by bit.
std::map<std::array<float, 3>, int> ends_of(const Scene& scene) {
    std::map<std::array<float, 3>, int> ends;
    for (const Curve& curve : scene.curves) {
        for (const Point& p : {curve.points.front(), curve.points.back()}) ++ends[{p.x, p.y, p.z}];
    }
    return ends;
}

// Places that are nearly the same but not quite would be joints that come apart.
void expect_exact_joints(const Scene& scene, const std::string& name) {
    const auto ends = ends_of(scene);
    for (const auto& [a, count] : ends) {
        for (const auto& [b, other] : ends) {
            if (a == b) continue;
            ASSERT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 1e-4) << name;
        }
    }
}

TEST(Scenes, NetworksMeetExactly) {
    for (const std::string& name : scene_names()) {
        const Scene scene = make_scene(name);
        EXPECT_EQ(scene.network, name == "tree" || name == "icosahedron" || name == "tower");
        if (scene.network) expect_exact_joints(scene, name);
    }
}

TEST(Scenes, TheIcosahedronHas60JointsOfThreeArcsOnASphere) {
    const Scene scene = make_scene("icosahedron");
    EXPECT_EQ(scene.curves.size(), 90u);
    const auto ends = ends_of(scene);
    EXPECT_EQ(ends.size(), 60u);
    for (const auto& [place, count] : ends) EXPECT_EQ(count, 3);
    for (const Curve& arc : scene.curves) {
        for (const Point& p : arc.points) ASSERT_NEAR(std::hypot(p.x, p.y, p.z), 0.5, 1e-6);
    }
}

TEST(Scenes, TheTreeIsATree) {
    const Scene scene = make_scene("tree");
    const auto ends = ends_of(scene);
    // Connected and without cycles: Euler's number is one, and each curve but the trunk begins where another ends.
    EXPECT_EQ(ends.size(), scene.curves.size() + 1);
    std::set<std::array<float, 3>> reached = {{0.0f, 0.0f, 0.0f}};
    for (const Curve& branch : scene.curves) {
        const Point &from = branch.points.front(), &to = branch.points.back();
        EXPECT_TRUE(reached.count({from.x, from.y, from.z}));
        EXPECT_TRUE(reached.insert({to.x, to.y, to.z}).second);
    }
    // Its branches are straight: there the Frenet frame is undefined, sec. 7.
    for (const Curve& branch : scene.curves) {
        const Point &a = branch.points.front(), &b = branch.points.back(), &m = branch.points[1];
        ASSERT_NEAR(distance(a, m) + distance(m, b), distance(a, b), 1e-6);
    }
}

TEST(Scenes, HairGrowsFromTheScalpAndStaysOutsideTheHead) {
    const Scene scene = make_scene("hair");
    const Curve head = make_head();
    const Mesh scalp = make_scalp();
    ASSERT_EQ(scene.curves.size(), 2000u);
    EXPECT_EQ(make_scene("hair", 37).curves.size(), 37u);
    const auto head_radius = [&](float y) {
        for (size_t i = 0; i + 1 < head.points.size(); ++i) {
            const float y0 = head.points[i].y, y1 = head.points[i + 1].y;
            if (y0 <= y && y <= y1) {
                const float t = (y - y0) / (y1 - y0);
                return head.radii[i] + t * (head.radii[i + 1] - head.radii[i]);
            }
        }
        return 0.0f;
    };
    float lowest = 1.0f;
    for (const Point& p : scalp.vertices) lowest = std::min(lowest, p.y);
    for (const Curve& strand : scene.curves) {
        ASSERT_EQ(strand.points.size(), 100u);
        const Point& root = strand.points[0];
        EXPECT_NEAR(std::hypot(root.x, root.z), head_radius(root.y), 3e-3);
        EXPECT_GE(root.y, lowest - 1e-6f);
        for (const Point& p : strand.points) ASSERT_GT(std::hypot(p.x, p.z), head_radius(p.y) - 3e-3f);
    }
}

TEST(Scenes, FlowLinesKeepTheirStreamFunctionAndLeaveTheBallOut) {
    // Psi = r_away^2 (1 - a^3 / r^3) / 2 is constant along streamlines.
    const double a = 0.13;
    const auto psi = [a](const Point& p) {
        const double r = std::hypot(p.x, p.y, p.z);
        return 0.5 * (double{p.y} * p.y + double{p.z} * p.z) * (1.0 - a * a * a / (r * r * r));
    };
    for (const Curve& line : make_scene("flow").curves) {
        for (const Point& p : line.points) {
            ASSERT_NEAR(psi(p), psi(line.points[0]), 1e-6);
            ASSERT_GT(std::hypot(p.x, p.y, p.z), a);
        }
    }
}

TEST(Scenes, PlanarStylesLieInTheirPlane) {
    for (const char* name : {"wave", "knit"}) {
        for (const Point& p : make_style(name).points) ASSERT_EQ(p.z, 0.0f) << name;
    }
}

TEST(Scenes, StylesWithAttributesHaveOneOfEachForEachPoint) {
    const Curve beads = make_style("beads"), twist = make_style("twist");
    EXPECT_EQ(beads.colors.size(), beads.points.size());
    EXPECT_EQ(twist.colors.size(), twist.points.size());
    ASSERT_EQ(twist.angles.size(), twist.points.size());
    // It rolls over several times.
    EXPECT_GT(twist.angles.back() - twist.angles.front(), 20.0f);
    const auto [thin, thick] = std::minmax_element(beads.radii.begin(), beads.radii.end());
    EXPECT_GT(*thick, 3.0f * *thin);
}

TEST(Scenes, TheCoasterLeansIntoItsTurns) {
    const Curve track = make_target("coaster");
    ASSERT_EQ(track.normals.size(), track.points.size());
    const size_t count = track.points.size();
    float flattest = 1.0f;
    for (size_t i = 0; i < count; ++i) {
        const Point &p = track.points[(i + count - 1) % count], &q = track.points[(i + 1) % count],
                    &n = track.normals[i];
        EXPECT_NEAR(std::hypot(n.x, n.y, n.z), 1.0, 1e-5);
        EXPECT_NEAR((n.x * (q.x - p.x) + n.y * (q.y - p.y) + n.z * (q.z - p.z)) / distance(p, q), 0.0, 1e-4);
        EXPECT_GT(n.y, 0.0f) << "upside down at " << i;
        flattest = std::min(flattest, n.y);
    }
    EXPECT_LT(flattest, 0.85f);
}

TEST(Scenes, TheFigureIsClosedManifoldAndOfOnePiece) {
    const Mesh figure = make_figure();
    std::set<std::pair<uint32_t, uint32_t>> edges;
    for (const auto& triangle : figure.triangles) {
        for (int k = 0; k < 3; ++k) {
            EXPECT_TRUE(edges.insert({triangle[k], triangle[(k + 1) % 3]}).second) << "an edge of more than two";
        }
    }
    for (const auto& [from, to] : edges) EXPECT_TRUE(edges.count({to, from})) << "a border";
    // A sphere's Euler number: no holes, no pinched vertices, one piece.
    EXPECT_EQ(figure.vertices.size() - edges.size() / 2 + figure.triangles.size(), 2u);
}

}  // namespace
}  // namespace flg::scenes
