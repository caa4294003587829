// SPDX-License-Identifier: MIT
// Exact distances, those of the oracle and those of the SDK, against closed forms: surfaces that unfold into the plane.
// And the oracle that is geoTangle's graph.
#include "reference/literal_geodesics.h"

#include <gtest/gtest.h>

#include "surfaces/exact_distances.h"

namespace flg::test {
namespace {

struct Method {
    const char* name;
    std::vector<double> (*distances)(const Mesh& mesh, uint32_t source);
};

class ExactDistances : public ::testing::TestWithParam<Method> {
protected:
    static std::vector<double> exact_distances(const Mesh& mesh, uint32_t source) {
        return GetParam().distances(mesh, source);
    }
};
INSTANTIATE_TEST_SUITE_P(By, ExactDistances,
                         ::testing::Values(Method{"Literal", literal::exact_distances},
                                           Method{"Windows", window_distances}),
                         [](const auto& method) { return method.param.name; });

// Positions are rounded to floats: where a form is that of the surface before rounding.
constexpr double float_rounding = 1e-6;

// Each triangle split in `parts` squared, in its own plane.
Soup split(const Soup& coarse, uint32_t parts) {
    Soup fine;
    std::map<std::array<long, 3>, uint32_t> places;
    for (const Triple& t : coarse.triangles) {
        const Vec3 a = load_vec3(coarse.positions[t[0]].data()), b = load_vec3(coarse.positions[t[1]].data()),
                   c = load_vec3(coarse.positions[t[2]].data());
        const auto vertex = [&](uint32_t i, uint32_t j) {
            const Vec3 p = a + (b - a) * i / parts + (c - a) * j / parts;
            const std::array<long, 3> place = {std::lround(p.x() * 1e5), std::lround(p.y() * 1e5),
                                               std::lround(p.z() * 1e5)};
            const auto [found, is_new] = places.try_emplace(place, static_cast<uint32_t>(fine.positions.size()));
            if (is_new) fine.positions.push_back(to_position(p));
            return found->second;
        };
        for (uint32_t j = 0; j < parts; ++j) {
            for (uint32_t i = 0; i + j < parts; ++i) {
                fine.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
                if (i + j + 1 < parts) {
                    fine.triangles.push_back({vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
                }
            }
        }
    }
    return fine;
}

uint32_t vertex_at(const Soup& soup, const Vec3& place) {
    for (uint32_t v = 0; v < soup.positions.size(); ++v) {
        if ((load_vec3(soup.positions[v].data()) - place).norm() < 1e-5) return v;
    }
    ADD_FAILURE() << "no vertex at " << place.transpose();
    return 0;
}

TEST_P(ExactDistances, AreStraightInThePlane) {
    const Mesh mesh = make_mesh(plane(20, 0.2));
    for (uint32_t source : {0u, 7u, 220u, 440u}) {
        const std::vector<double> distances = exact_distances(mesh, source);
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            EXPECT_NEAR(distances[v], (mesh.position(v) - mesh.position(source)).norm(), 1e-11)
                << source << " to " << v;
        }
    }
}

TEST_P(ExactDistances, WindAroundAPrism) {
    constexpr uint32_t around = 24, up = 15;
    const Mesh mesh = make_mesh(cylinder(around, up));
    const double side = 2 * std::sin(std::numbers::pi / around);
    const uint32_t source = 7 * around + 3;
    const std::vector<double> distances = exact_distances(mesh, source);
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const int turns = std::abs(static_cast<int>(v % around) - 3);
        const double across = side * std::min<int>(turns, around - turns);
        const double along = 2.0 * (static_cast<int>(v / around) - 7) / up;
        EXPECT_NEAR(distances[v], std::hypot(across, along), float_rounding) << "vertex " << v;
    }
}

TEST_P(ExactDistances, CrossTheEdgesOfACube) {
    Soup cube{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}, {}};
    for (const std::array<uint32_t, 4>& face :
         {std::array<uint32_t, 4>{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
        cube.triangles.push_back({face[0], face[1], face[2]});
        cube.triangles.push_back({face[0], face[2], face[3]});
    }
    for (uint32_t parts : {1u, 2u, 6u}) {
        const Soup fine = split(cube, parts);
        const std::vector<double> distances = exact_distances(make_mesh(fine), vertex_at(fine, {0, 0, 0}));
        EXPECT_NEAR(distances[vertex_at(fine, {1, 1, 1})], std::sqrt(5.0), float_rounding);
        EXPECT_NEAR(distances[vertex_at(fine, {1, 1, 0})], std::sqrt(2.0), float_rounding);
        if (parts == 1) continue;
        // Over the nearest side: right along x and up along z, or the like; the middle of an edge, that of a face.
        EXPECT_NEAR(distances[vertex_at(fine, {1, 0.5, 1})], std::hypot(1.5, 1.0), float_rounding);
        EXPECT_NEAR(distances[vertex_at(fine, {0.5, 0.5, 1})], std::hypot(1.5, 0.5), float_rounding);
    }
}

// The plane wraps twice around a regular tetrahedron: half turns about the points of a triangular lattice leave the
// place on it as it is, so a distance is the least one to an image in the plane.
TEST_P(ExactDistances, AreThoseOfTheLatticeOnATetrahedron) {
    const Soup coarse = tetrahedron();
    const Soup fine = split(coarse, 8);
    const double side = std::sqrt(8.0);
    const Vec3 a(0, 0, 0), b(side, 0, 0), c(side / 2, side * std::sqrt(0.75), 0), d = b - c;
    // Its triangles 0, 1, 2 about vertex 0, which is at the origin, and 3 beyond the edge from c to b.
    const std::array<std::array<Vec3, 3>, 4> unfolded = {{{a, b, c}, {a, d, b}, {a, c, c - b}, {b, b + c, c}}};
    const auto place = [&](const Vec3& p) {
        for (int t = 0; t < 4; ++t) {
            const Triple& triangle = coarse.triangles[t];
            Eigen::Matrix3d corners;
            for (int k = 0; k < 3; ++k) corners.col(k) = load_vec3(coarse.positions[triangle[k]].data());
            const Vec3 weights = corners.inverse() * p;
            if (std::abs(weights.sum() - 1) > 1e-5 || weights.minCoeff() < -1e-5) continue;
            return Vec3(unfolded[t][0] * weights[0] + unfolded[t][1] * weights[1] + unfolded[t][2] * weights[2]);
        }
        ADD_FAILURE() << "not on the tetrahedron";
        return a;
    };
    const Mesh mesh = make_mesh(fine);
    for (uint32_t source : {0u, 20u, 57u}) {
        const Vec3 from = place(mesh.position(source));
        const std::vector<double> distances = exact_distances(mesh, source);
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            const Vec3 to = place(mesh.position(v));
            double least = unreachable;
            for (int i = -4; i <= 4; ++i) {
                for (int j = -4; j <= 4; ++j) {
                    const Vec3 shift = 2 * i * b + 2 * j * c;
                    least = std::min({least, (to + shift - from).norm(), (shift - to - from).norm()});
                }
            }
            EXPECT_NEAR(distances[v], least, float_rounding) << source << " to " << v;
        }
    }
}

// `sides` equal triangles about an apex, each flat and split; their rims alternately up and down by `height`.
void expect_cone(const Method& method, uint32_t sides, double height, bool is_saddle) {
    Soup coarse;
    coarse.positions.push_back({0, 0, 0});
    for (uint32_t i = 0; i < sides; ++i) {
        const double turn = 2 * std::numbers::pi * i / sides;
        const double z = is_saddle && i % 2 == 1 ? -height : height;
        coarse.positions.push_back(to_position({std::cos(turn), std::sin(turn), z}));
        coarse.triangles.push_back({0, 1 + i, 1 + (i + 1) % sides});
    }
    const Vec3 one = load_vec3(coarse.positions[1].data()), two = load_vec3(coarse.positions[2].data());
    const double sector = std::acos(one.dot(two) / (one.norm() * two.norm()));
    EXPECT_EQ(sides * sector > 2 * std::numbers::pi, is_saddle);

    const Soup fine = split(coarse, 6);
    // The angle of a place along the cone.
    const auto angle = [&](const Vec3& p) {
        for (uint32_t i = 0; i < sides; ++i) {
            Eigen::Matrix<double, 3, 2> rims;
            for (uint32_t k : {0u, 1u}) rims.col(k) = load_vec3(coarse.positions[1 + (i + k) % sides].data());
            const Eigen::Vector2d weights = (rims.transpose() * rims).inverse() * rims.transpose() * p;
            if ((rims * weights - p).norm() > 1e-5 || weights.minCoeff() < -1e-5) continue;
            const Vec3 rim = rims.col(0);
            return sector * i + std::atan2(rim.cross(p).norm(), rim.dot(p));
        }
        ADD_FAILURE() << "not on the cone";
        return 0.0;
    };
    const Mesh mesh = make_mesh(fine);
    const uint32_t source = vertex_at(fine, 0.5 * one + 1.0 / 3 * (two - one));
    const std::vector<double> distances = method.distances(mesh, source);
    const double from = angle(mesh.position(source)), r = mesh.position(source).norm();
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const double s = mesh.position(v).norm();
        double turn = s == 0 ? 0 : std::abs(angle(mesh.position(v)) - from);
        turn = std::min(turn, sides * sector - turn);
        const double expected =
            turn >= std::numbers::pi ? r + s : std::sqrt(std::max(r * r + s * s - 2 * r * s * std::cos(turn), 0.0));
        EXPECT_NEAR(distances[v], expected, 10 * float_rounding) << "vertex " << v;
    }
}

TEST_P(ExactDistances, PassTheApexOfACone) {
    expect_cone(GetParam(), 6, 1, false);
}

TEST_P(ExactDistances, BendAtASaddle) {
    expect_cone(GetParam(), 8, 0.5, true);
}

TEST_P(ExactDistances, BendAtAConcaveBorder) {
    // [0, 1]^2 without its upper right quarter.
    Soup soup = plane(10);
    std::erase_if(soup.triangles, [&](const Triple& t) {
        Vec3 middle(0, 0, 0);
        for (uint32_t v : t) middle += load_vec3(soup.positions[v].data()) / 3;
        return middle.x() > 0.5 && middle.y() > 0.5;
    });
    std::map<uint32_t, uint32_t> used;
    Soup bent;
    for (Triple& t : soup.triangles) {
        for (uint32_t& v : t) {
            const auto [found, is_new] = used.try_emplace(v, static_cast<uint32_t>(bent.positions.size()));
            if (is_new) bent.positions.push_back(soup.positions[v]);
            v = found->second;
        }
        bent.triangles.push_back(t);
    }
    const uint32_t source = vertex_at(bent, {1, 0.3, 0});
    const std::vector<double> distances = exact_distances(make_mesh(bent), source);
    const double around = std::hypot(0.5, 0.2) + std::hypot(0.2, 0.5);
    EXPECT_NEAR(distances[vertex_at(bent, {0.3, 1, 0})], around, float_rounding);
    EXPECT_NEAR(distances[vertex_at(bent, {0.5, 0.5, 0})], std::hypot(0.5, 0.2), float_rounding);
}

TEST_P(ExactDistances, AreSymmetricAndStopAtOtherComponents) {
    Soup soup = sphere(2);
    const uint32_t first = static_cast<uint32_t>(soup.positions.size());
    for (const Position& p : tetrahedron().positions) soup.positions.push_back(p);
    for (const Triple& t : tetrahedron().triangles)
        soup.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    const Mesh mesh = make_mesh(soup);
    const std::vector<double> distances = exact_distances(mesh, 5);
    EXPECT_EQ(distances[first], unreachable);
    for (uint32_t v : {0u, 17u, 42u, 99u}) EXPECT_NEAR(exact_distances(mesh, v)[5], distances[v], 1e-11);
}

TEST(LiteralGraph, IsThatOfASquareOfTwoTriangles) {
    // A kite: its long diagonal is an edge, the short one a dual arc; and an arrowhead: the arc would leave it.
    const auto arcs = [](float tip) {
        const Soup soup{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {tip, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}};
        return literal::geodesic_graph(make_mesh(soup));
    };
    const literal::GeodesicGraph kite = arcs(1);
    ASSERT_EQ(kite[2].size(), 3u);
    EXPECT_EQ(literal::GraphField(kite, {{2, 0, 0}}).distances[3], 2.0f);
    const literal::GeodesicGraph arrowhead = arcs(5);
    ASSERT_EQ(arrowhead[2].size(), 2u);
    const float around = static_cast<float>(std::sqrt(2.0)) + static_cast<float>(std::sqrt(10.0));
    EXPECT_EQ(literal::GraphField(arrowhead, {{2, 0, 0}}).distances[3], around);
}

// And the paper's visit finds the same bits in another order.
TEST(LiteralGraph, DistancesAreNeverBelowTheExactOnesAndSymmetric) {
    for (const Soup& soup : {sphere(3), torus(24, 12), plane(20, 0.3)}) {
        const Mesh mesh = make_mesh(soup);
        const literal::GeodesicGraph graph = literal::geodesic_graph(mesh);
        const std::vector<float> from = literal::GraphField(graph, {{11, 0, 0}}).distances;
        EXPECT_EQ(literal::visit_graph(graph, 11), from);
        const std::vector<double> exact = literal::exact_distances(mesh, 11);
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            EXPECT_GE(from[v], exact[v] * (1 - 1e-6));
            // A step of the graph leaves out at most half the angle between two of its arcs: 45 degrees in worst
            // triangles.
            EXPECT_LE(from[v], exact[v] * 1.4);
        }
        for (uint32_t v : {0u, 30u, 77u}) {
            EXPECT_NEAR(literal::GraphField(graph, {{v, 0, 0}}).distances[11], from[v], 1e-6 * from[v]);
        }
    }
}

// Of a grid of squares cut in two along the same diagonal each: arcs lead along the axes, along both diagonals and like
// a knight's move across the long one, which leaves no direction further than 1 / cos(22.5 degrees) off.
TEST(LiteralGraph, IsOffByTheAngleBetweenArcsAtMost) {
    const Mesh mesh = make_mesh(plane(24));
    const literal::GraphField field(literal::geodesic_graph(mesh), {{12 * 25 + 12, 0, 0}});
    const double most = 1 / std::cos(std::numbers::pi / 8);
    double worst = 0;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        if (v == 12 * 25 + 12) continue;
        const double ratio = field.distances[v] / (mesh.position(v) - mesh.position(12 * 25 + 12)).norm();
        EXPECT_LE(ratio, most + 1e-6);
        worst = std::max(worst, ratio);
    }
    EXPECT_GT(worst, 1.07);
}

}  // namespace
}  // namespace flg::test
