// SPDX-License-Identifier: MIT
#include "splines/obstacles/obstacle_mesh.h"

#include <numbers>

#include "core/failure.h"
#include "splines/obstacle_checks.h"
#include "splines/obstacles/barrier_surface.h"
#include "splines/obstacles/mesh_distance.h"
#include "splines/obstacles/obstacle_path.h"
#include "splines/obstacles/obstacle_shapes.h"
#include "surfaces/mesh/nearest_points.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

SampledDistance sampled(const Mesh& mesh, double reach, uint32_t cells, bool has_sign, bool haltingly = false) {
    return run_now(
        heap(), [&](Pace& pace) { return mesh_distance(pace, mesh, reach, cells, has_sign); }, haltingly);
}

MeshObstacle solid(const SampledDistance& distance, const Mesh& mesh) {
    return MeshObstacle(distance, run_now(heap(), [&](Pace& pace) { return triangle_solid(pace, mesh); }));
}

// Corners in binary fractions, so that nodes lie on planes of faces and on edges.
Soup box_soup(double x, double y, double z) {
    Soup soup;
    for (uint32_t i = 0; i < 8; ++i) {
        soup.positions.push_back(to_position(Vec3(i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z)));
    }
    soup.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return soup;
}

// Values at the nodes, by the spline, against a box's distance in closed form: exact, signs too.
TEST(MeshDistance, OfABoxIsExactAtTheNodes) {
    const double half[3] = {1, 0.5, 0.25}, centre[3] = {0, 0, 0};
    const BoxObstacle box(3, centre, half, nullptr);
    for (const uint32_t cells : {20u, 24u, 33u}) {
        const SampledDistance d = sampled(make_mesh(box_soup(1, 0.5, 0.25)), 0.25, cells, true);
        uint32_t inside = 0;
        for (uint32_t i = 0; i < d.grid.size(); ++i) {
            const Obstacle::Place x = d.grid.place(i);
            const double exact = box.evaluate(x.data(), nullptr, nullptr);
            double value = 0, gradient[3];
            Obstacle::Place in = x;  // the last nodes may lie outside by rounding
            for (uint32_t k = 0; k < 3; ++k) in[k] -= 1e-12 * x[k];
            ASSERT_TRUE(d.evaluate(in.data(), &value, gradient, nullptr));
            EXPECT_NEAR(value, exact, 1e-6);  // samples are floats
            inside += exact < 0;
        }
        EXPECT_GT(inside, 100u);
        EXPECT_LE(d.deepest, 0.25);
        EXPECT_GT(d.deepest, 0.15);
    }
}

// All triangles tried, at every node, of a bent mesh.
TEST(MeshDistance, SweepingFindsTheNearestTriangles) {
    const Mesh mesh = make_mesh(torus(40, 20));
    const SampledDistance d = sampled(mesh, 0.5, 24, true);
    NearestPoints nearest(mesh);
    run_now(heap(), [&](Pace& pace) { return build(pace, nearest); });
    double most = 0;
    uint32_t missed = 0, tried = 0;
    for (uint32_t i = 0; i < d.grid.size(); i += 3) {
        Obstacle::Place x = d.grid.place(i);
        for (uint32_t k = 0; k < 3; ++k) x[k] -= 1e-12 * x[k];
        nearest.begin(to_position(Vec3(x[0], x[1], x[2])));
        while (!nearest.find(1000)) {}
        const SurfacePoint& at = nearest.found();
        const Triple& t = mesh.triangles[at.triangle];
        const Vec3 foot = mesh.position(t[0]) + double(at.u) * (mesh.position(t[1]) - mesh.position(t[0])) +
                          double(at.v) * (mesh.position(t[2]) - mesh.position(t[0]));
        double value = 0;
        ASSERT_TRUE(d.evaluate(x.data(), &value, nullptr, nullptr));
        const double error = std::abs(std::abs(value) - (foot - Vec3(x[0], x[1], x[2])).norm());
        most = std::max(most, error);
        missed += error > 1e-5;
        ++tried;
    }
    EXPECT_LT(most, 1e-3);
    EXPECT_LT(missed, tried / 1000);
}

TEST(MeshDistance, ASmallHoleIsOutvoted) {
    Soup soup = sphere(3);
    soup.triangles.erase(soup.triangles.begin() + 100);
    const SampledDistance d = sampled(make_mesh(soup), 0.3, 30, true);
    const SampledDistance whole = sampled(make_mesh(sphere(3)), 0.3, 30, true);
    uint32_t differ = 0;
    for (uint32_t i = 0; i < d.grid.size(); ++i) {
        Obstacle::Place x = d.grid.place(i);
        for (uint32_t k = 0; k < 3; ++k) x[k] -= 1e-12 * x[k];
        double a = 0, b = 0;
        ASSERT_TRUE(d.evaluate(x.data(), &a, nullptr, nullptr));
        ASSERT_TRUE(whole.evaluate(x.data(), &b, nullptr, nullptr));
        differ += (a < 0) != (b < 0);
    }
    EXPECT_LT(differ, 3u);  // where lines through the hole cross
}

TEST(MeshDistance, DerivativesAreThoseOfDifferences) {
    const SampledDistance d = sampled(make_mesh(sphere(2)), 0.3, 24, true);
    for (uint64_t item = 0; item < 200; ++item) {
        const Numbers x = random_numbers(item, 1.2);
        const auto function = [&](const double* at, double* g, double* h) {
            double value = 0;
            EXPECT_TRUE(d.evaluate(at, &value, g, h));
            return value;
        };
        expect_derivatives(function, 3, x, 1e-4);
    }
}

TEST(MeshDistance, ChunksDoNotMatter) {
    const Mesh mesh = make_mesh(torus(20, 10));
    const SampledDistance a = sampled(mesh, 0.2, 16, true, true), b = sampled(mesh, 0.2, 16, true);
    EXPECT_EQ(a.deepest, b.deepest);
    for (uint64_t item = 0; item < 1000; ++item) {
        const Numbers x = random_numbers(item, 1.4);
        double first[13] = {}, second[13] = {};
        EXPECT_EQ(a.evaluate(x.data(), first, first + 1, first + 4),
                  b.evaluate(x.data(), second, second + 1, second + 4));
        EXPECT_TRUE(std::equal(first, first + 13, second));
    }
}

TEST(MeshDistance, BadNumbersAreRefused) {
    const Mesh mesh = make_mesh(sphere(0));
    EXPECT_THROW(sampled(mesh, 0, 16, true), Failure);
    EXPECT_THROW(sampled(mesh, std::nan(""), 16, true), Failure);
    EXPECT_THROW(sampled(mesh, 1, 7, true), Failure);
    EXPECT_THROW(sampled(mesh, 1, 193, true), Failure);
    EXPECT_THROW(sampled(Mesh(heap()), 1, 16, true), Failure);
}

// Of a fine mesh of a sphere: the distance to the mesh's error, inside too; far away it is not more.
TEST(MeshObstacle, ASphereIsABall) {
    const Mesh mesh = make_mesh(sphere(4));
    const SampledDistance d = sampled(mesh, 0.4, 48, true);
    const MeshObstacle obstacle = solid(d, mesh);
    const double centre[3] = {0, 0, 0};
    const BallObstacle ball(3, centre, 1);
    for (uint64_t item = 0; item < 1000; ++item) {
        const Numbers x = random_numbers(item, 3);
        double gradient[3], exact[3], second[9], exact_second[9];
        const double value = obstacle.evaluate(x.data(), gradient, second);
        const double away = ball.evaluate(x.data(), exact, exact_second);
        if (away > obstacle.reach()) {
            EXPECT_LT(value, away + 0.01);  // the mesh is inscribed
            EXPECT_GT(value, 0.2);
        } else if (away > -0.7) {
            EXPECT_NEAR(value, away, 0.005);
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(gradient[k], exact[k], 0.05);
        }
    }
    EXPECT_NEAR(obstacle.core_depth(), 0.5, 0.03);
    EXPECT_THROW(sampled(make_mesh(plane(4)), 0.3, 30, true), Failure);  // nothing is inside
    EXPECT_THROW(solid(sampled(mesh, 0.3, 30, false), mesh), Failure);
}

// Of a box, sharp edges and all: distance and derivatives in closed form, near its surface and deep in it.
TEST(MeshObstacle, ABoxIsOneExactly) {
    const double half[3] = {1, 0.5, 0.25}, centre[3] = {0, 0, 0};
    const BoxObstacle box(3, centre, half, nullptr);
    const Mesh mesh = make_mesh(box_soup(1, 0.5, 0.25));
    const SampledDistance d = sampled(mesh, 0.25, 24, true);
    const MeshObstacle obstacle = solid(d, mesh);
    uint32_t near = 0;
    for (uint64_t item = 0; item < 8000; ++item) {
        const Numbers x = random_numbers(item, 1.2);
        double gradient[3], second[9], exact[3], exact_second[9];
        const double away = box.evaluate(x.data(), exact, exact_second);
        const double value = obstacle.evaluate_exactly(x.data(), gradient, second);
        EXPECT_LE(obstacle.evaluate_exactly(x.data(), nullptr, nullptr), away + 1e-12);
        if (away > d.reach) {
            EXPECT_LE(value, away + 1e-12);
            continue;
        }
        ++near;
        EXPECT_NEAR(value, away, 1e-12);
        for (uint32_t k = 0; k < 3; ++k) EXPECT_NEAR(gradient[k], exact[k], 1e-9);
        for (uint32_t k = 0; k < 9; ++k) EXPECT_NEAR(second[k], exact_second[k], 1e-6 / std::abs(away));
    }
    EXPECT_GT(near, 1000u);
}

// With a clearance of many cells, of values alone too; and no jump in what barriers see.
// All triangles within reach of a straight piece are below one of the planes, and all of the piece is above them.
TEST(MeshObstacle, PlanesPartAPieceFromTheTriangles) {
    const Mesh mesh = make_mesh(torus(60, 30));
    const SampledDistance d = sampled(mesh, 0.3, 32, true);
    const MeshObstacle obstacle = solid(d, mesh);
    const double reach = 0.25;
    uint32_t parted = 0, met = 0, planes = 0;
    for (uint64_t k = 0; k < 400; ++k) {
        const Numbers from = random_numbers(2 * k, 1.6), by = random_numbers(2 * k + 1, 0.15);
        const Vec3 a(from[0], from[1], 0.5 * from[2]), b = a + Vec3(by[0], by[1], by[2]);
        Obstacle::Parting out[32];
        uint32_t count = 0;
        for (uint32_t found = 0; found < 32; ++found) {
            count = obstacle.part(a.data(), b.data(), reach, out, found);
            if (count == found || count == Obstacle::no_parting) break;
        }
        const bool meets = obstacle.meets(a.data(), b.data()) == Obstacle::Meets::yes;
        EXPECT_EQ(count == Obstacle::no_parting, meets) << k;
        if (count == Obstacle::no_parting) {
            ++met;
            continue;
        }
        ASSERT_LT(count, 32u);
        parted += count > 0;
        planes = std::max(planes, count);
        for (uint32_t i = 0; i < count; ++i) {
            const Vec3 outwards(out[i].outwards.data());
            EXPECT_NEAR(outwards.norm(), 1, 1e-12);
            EXPECT_NEAR(std::min(outwards.dot(a), outwards.dot(b)) - out[i].height, out[i].away, 1e-9);
            EXPECT_LT(out[i].away, reach);
        }
        for (const Triple& t : mesh.triangles) {
            const bool below = std::any_of(out, out + count, [&](const Obstacle::Parting& plane) {
                const Vec3 outwards(plane.outwards.data());
                return std::max({outwards.dot(mesh.position(t[0])), outwards.dot(mesh.position(t[1])),
                                 outwards.dot(mesh.position(t[2]))}) <= plane.height + 1e-9;
            });
            if (below) continue;
            double nearest = HUGE_VAL;
            for (int s = 0; s <= 20; ++s) {
                const Vec3 x = a + s / 20.0 * (b - a);
                nearest = std::min(
                    nearest, triangle_foot(x, mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])).to.norm());
            }
            EXPECT_GE(nearest, reach) << k;
        }
    }
    EXPECT_GT(parted, 50u);
    EXPECT_GT(met, 5u);
    EXPECT_GT(planes, 1u);
}

TEST(MeshObstacle, WithAWideClearanceItIsExactThere) {
    const double half[3] = {1, 0.5, 0.25}, centre[3] = {0, 0, 0}, clearance = 0.6;
    const BoxObstacle box(3, centre, half, nullptr);
    const Mesh mesh = make_mesh(box_soup(1, 0.5, 0.25));
    const SampledDistance d = sampled(mesh, clearance + 0.3, 64, true);
    const MeshObstacle obstacle = solid(d, mesh);
    const Obstacle* one[] = {&obstacle};
    ObstacleSet set(one, clearance, heap());
    set.set_smooth(false);
    uint32_t near = 0;
    for (uint64_t item = 0; item < 4000; ++item) {
        const Numbers x = random_numbers(item, 1.8);
        const double away = box.evaluate(x.data(), nullptr, nullptr);
        if (away > clearance + 0.25) continue;
        EXPECT_NEAR(set.evaluate(0, x.data(), nullptr, nullptr), away - clearance, 1e-12);
        EXPECT_LE(set.distance(x.data()), away - clearance + 1e-12);
        if (away > clearance) continue;
        ++near;
        EXPECT_NEAR(set.distance(x.data()), away - clearance, 1e-12);
        EXPECT_NEAR(obstacle.evaluate_exactly(x.data(), nullptr, nullptr, clearance), away, 1e-12);
    }
    EXPECT_GT(near, 500u);
}

// Two closed meshes in one that overlap: what one of them holds is inside, however near the other's surface is.
TEST(MeshObstacle, OverlappingShellsAreOneSolid) {
    Soup soup = box_soup(1, 1, 1);
    const Soup other = box_soup(1, 0.5, 0.5);
    for (const Position& at : other.positions) soup.positions.push_back({at[0] + 1, at[1], at[2]});
    for (const Triple& t : other.triangles) soup.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    const Mesh mesh = make_mesh(soup);
    const SampledDistance d = sampled(mesh, 0.3, 24, true);
    const MeshObstacle obstacle = solid(d, mesh);
    for (const double x : {-0.1, -0.01, 0.1, 0.9, 0.99, 1.1}) {
        for (const double y : {0.0, 0.45, 0.4999}) {
            const double at[] = {x, y, 0.1};
            EXPECT_LT(obstacle.evaluate_exactly(at, nullptr, nullptr), 0) << x << " " << y;
        }
    }
    const double beside[] = {1.0001, 0.5001, 0};
    EXPECT_GT(obstacle.evaluate_exactly(beside, nullptr, nullptr), 0);
}

TEST(MeshObstacle, ABarrierKeepsPointsOut) {
    const Mesh mesh = make_mesh(torus(60, 30));
    const SampledDistance d = sampled(mesh, 0.3, 64, true);
    const MeshObstacle obstacle = solid(d, mesh);
    const Obstacle* one[] = {&obstacle};
    const ObstacleSet set(one, 0.05, heap());
    EXPECT_THROW(BarrierSurface(set, 0.26, 4), Failure);
    BarrierSurface surface(set, 0.2, 4);
    for (const double radius : {0.2, 0.02, 0.002}) {
        surface.set_radius(radius);
        uint32_t inside = 0, failed = 0;
        for (uint64_t item = 0; item < 1000; ++item) {
            Numbers x = random_numbers(item, 1.3);
            x[2] *= 0.3;
            x[3] *= 0.1;
            inside += set.distance(x.data()) < 0;
            if (!surface.project(x.data(), nullptr)) {
                ++failed;
                continue;
            }
            EXPECT_GT(set.evaluate(0, x.data(), nullptr, nullptr), -1e-9);
        }
        EXPECT_GT(inside, 100u);
        EXPECT_LT(failed, 10u);
    }
}

// The unit square: points within epsilon of it are free, all around its boundary too.
TEST(LayerObstacle, KeepsPointsNearTheMesh) {
    const SampledDistance d = sampled(make_mesh(plane(8)), 0.2, 96, false);
    const double epsilon = 0.1;
    const LayerObstacle layer(d, epsilon);
    for (uint64_t item = 0; item < 1000; ++item) {
        Numbers x = random_numbers(item, 1);
        for (uint32_t k = 0; k < 2; ++k) x[k] = 0.5 + 0.7 * x[k];
        x[2] *= 0.25;
        double away = x[2] * x[2], gradient[3];
        for (uint32_t k = 0; k < 2; ++k) away += std::pow(std::max({-x[k], x[k] - 1, 0.0}), 2);
        away = std::sqrt(away);
        const double value = layer.evaluate(x.data(), gradient, nullptr);
        if (away > d.reach) {
            EXPECT_LT(value, 0);
            EXPECT_GT(value, epsilon - away - 0.01);
        } else if (away > epsilon - layer.reach()) {
            EXPECT_NEAR(value, epsilon - away, 2e-3);
            EXPECT_NEAR(gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2], 1, 0.1);
        }
    }
    EXPECT_THROW(LayerObstacle(d, 1.0), Failure);
    EXPECT_THROW(LayerObstacle(d, 0.01), Failure);
    EXPECT_THROW(LayerObstacle(d, std::nan("")), Failure);
}

// Along a bent strip, three quarters of a cylinder: the straight way is refused, the path stays in the layer.
TEST(LayerObstacle, APathStaysInTheLayer) {
    const Soup strip = grid(48, 8, [](double u, double v) {
        const double angle = 1.5 * std::numbers::pi * u;
        return Vec3(std::cos(angle), std::sin(angle), v);
    });
    const Mesh mesh = make_mesh(strip);
    const SampledDistance d = sampled(mesh, 0.3, 80, false);
    const LayerObstacle layer(d, 0.2);
    const Obstacle* one[] = {&layer};
    const ObstacleSet set(one, 0, heap());
    const std::vector<double> points = {1, 0, 0.5, 0, -1, 0.5};
    const ObstaclePath path = run_now(heap(), [&](Pace& pace) { return obstacle_path(pace, set, points, false, {}); });
    double length = 0, turned = 0;
    for (size_t i = 3; i < path.points.size(); i += 3) {
        const double* a = &path.points[i - 3];
        const double* b = &path.points[i];
        length += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        turned += std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
        for (int s = 0; s <= 100; ++s) {
            double x[3];
            for (int k = 0; k < 3; ++k) x[k] = a[k] + s / 100.0 * (b[k] - a[k]);
            EXPECT_GT(set.distance(x), -1e-9);
        }
    }
    EXPECT_NEAR(turned, 1.5 * std::numbers::pi, 1e-9);
    EXPECT_LT(length, 1.5 * std::numbers::pi);  // on the inner side of the layer
    EXPECT_GT(length, 1.5 * std::numbers::pi * 0.78);
    // Lifted and projected its points are still in the layer.
    const BarrierSurface surface(set, 0.05, 2);
    for (size_t i = 0; i < path.points.size(); i += 3) {
        double x[4];
        EXPECT_TRUE(surface.lift(&path.points[i], x));
        x[0] *= 1.3;
        x[1] *= 1.3;
        EXPECT_TRUE(surface.project(x, nullptr));
        EXPECT_GT(set.distance(x), -1e-9);
    }
}

}  // namespace
}  // namespace flg::test
