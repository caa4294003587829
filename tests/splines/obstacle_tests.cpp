// SPDX-License-Identifier: MIT
#include <memory>
#include <numbers>

#include "core/failure.h"
#include "splines/obstacle_checks.h"
#include "splines/obstacles/clearance.h"
#include "splines/obstacles/obstacle_polygon.h"
#include "splines/obstacles/obstacle_shapes.h"

namespace flg::test {
namespace {

using Places = std::vector<std::array<double, 3>>;

double egg(void*, const double* x, double* gradient) {
    // 0.4 (|M x| - 1) with M = diag(1, 2, 2): its gradient is never longer than 0.8.
    const double m[3] = {x[0], 2 * x[1], 2 * x[2]};
    const double length = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    gradient[0] = 0.4 * m[0] / length;
    for (int k = 1; k < 3; ++k) gradient[k] = 0.8 * m[k] / length;
    return 0.4 * (length - 1);
}

std::vector<double> star(uint32_t corners) {
    std::vector<double> xy;
    for (uint32_t i = 0; i < 2 * corners; ++i) {
        const double angle = std::numbers::pi * i / corners, radius = i % 2 == 0 ? 1 : 0.4;
        xy.push_back(radius * std::cos(angle));
        xy.push_back(radius * std::sin(angle));
    }
    return xy;
}

std::vector<std::unique_ptr<Obstacle>> all_shapes() {
    std::vector<std::unique_ptr<Obstacle>> all;
    const double centre[3] = {0.1, -0.2, 0.15}, half[3] = {0.5, 0.3, 0.2}, to[3] = {0.6, 0.3, -0.4};
    for (const uint32_t d : {2u, 3u}) {
        const auto turn = rotation(d);
        double axes[9];
        for (uint32_t i = 0; i < d; ++i) std::copy_n(turn[i].begin(), d, axes + i * d);
        all.push_back(std::make_unique<BallObstacle>(d, centre, 0.5));
        all.push_back(std::make_unique<BoxObstacle>(d, centre, half, axes));
        all.push_back(std::make_unique<BoxObstacle>(d, centre, half, nullptr));
        all.push_back(std::make_unique<CapsuleObstacle>(d, centre, to, 0.25));
        all.push_back(std::make_unique<CapsuleObstacle>(d, centre, centre, 0.25));
        all.push_back(std::make_unique<HalfSpaceObstacle>(d, centre, to));
        if (d == 3) all.push_back(std::make_unique<PrismObstacle>(PolygonObstacle(star(5), heap()), centre, axes, 0.3));
    }
    all.push_back(std::make_unique<PolygonObstacle>(star(5), heap()));
    const FunctionObstacle::Function function{egg, nullptr, nullptr};
    const Obstacle::Box box{{-1, -0.5, -0.5}, {1, 0.5, 0.5}};
    all.push_back(std::make_unique<FunctionObstacle>(3, function, box, true, 0.2, 10));
    return all;
}

TEST(Obstacles, DerivativesAreThoseOfDifferences) {
    for (const auto& shape : all_shapes()) {
        const uint32_t d = shape->dimension();
        for (uint64_t item = 0; item < 300; ++item) {
            const Numbers x = random_numbers(item, 1.5);
            // Near its corner or edge the distance bends as much as one likes.
            double gradient[3], second[9];
            shape->evaluate(x.data(), gradient, second);
            double most = 0;
            for (uint32_t i = 0; i < d * d; ++i) most = std::max(most, std::abs(second[i]));
            if (most > 50) continue;
            const auto function = [&](const double* at, double* g, double* h) { return shape->evaluate(at, g, h); };
            expect_derivatives(function, d, x, 1e-5);
        }
    }
}

// |gradient| = 1, and what is `value` along it from x lies on the boundary: so it is the distance.
TEST(Obstacles, ValuesAreSignedDistances) {
    const auto shapes = all_shapes();
    for (size_t s = 0; s + 1 < shapes.size(); ++s) {
        const Obstacle& shape = *shapes[s];
        const uint32_t d = shape.dimension();
        uint32_t inside = 0;
        for (uint64_t item = 0; item < 400; ++item) {
            const Numbers x = random_numbers(item, 1.5);
            double gradient[3];
            const double value = shape.evaluate(x.data(), gradient, nullptr);
            inside += value < 0;
            Numbers foot = x;
            double square = 0;
            for (uint32_t k = 0; k < d; ++k) {
                square += gradient[k] * gradient[k];
                foot[k] -= value * gradient[k];
            }
            EXPECT_NEAR(square, 1, 1e-12);
            EXPECT_NEAR(shape.evaluate(foot.data(), nullptr, nullptr), 0, 1e-12);
            for (uint32_t k = 0; k < d; ++k) {
                EXPECT_GT(foot[k], shape.box().lower[k] - 1e-12);
                EXPECT_LT(foot[k], shape.box().upper[k] + 1e-12);
            }
            // No farther than its neighbours, that is: never more than the distance.
            const Numbers y = random_numbers(item + 1000, 1.5);
            double away = 0;
            for (uint32_t k = 0; k < d; ++k) away += (y[k] - x[k]) * (y[k] - x[k]);
            EXPECT_LE(std::abs(shape.evaluate(y.data(), nullptr, nullptr) - value), std::sqrt(away) + 1e-12);
        }
        EXPECT_GT(inside, 0u);
    }
}

TEST(Obstacles, MoveWithTheirShapes) {
    const std::array<double, 3> a{0.1, -0.2, 0.15}, b{0.6, 0.3, -0.4};
    const double half[3] = {0.5, 0.3, 0.2};
    for (const uint32_t d : {2u, 3u}) {
        const auto turn = rotation(d);
        double axes[9];  // the columns of the rotation: where the coordinates' axes go
        for (uint32_t i = 0; i < d; ++i) {
            for (uint32_t k = 0; k < d; ++k) axes[i * d + k] = turn[k][i];
        }
        const auto a_moved = moved(d, a), b_moved = moved(d, b);
        const BallObstacle ball(d, a.data(), 0.5), ball_moved(d, a_moved.data(), 0.5);
        const BoxObstacle box(d, a.data(), half, nullptr), box_moved(d, a_moved.data(), half, axes);
        const CapsuleObstacle capsule(d, a.data(), b.data(), 0.2),
            capsule_moved(d, a_moved.data(), b_moved.data(), 0.2);
        const std::pair<const Obstacle*, const Obstacle*> pairs[] = {
            {&ball, &ball_moved}, {&box, &box_moved}, {&capsule, &capsule_moved}};
        for (uint64_t item = 0; item < 100; ++item) {
            const auto x = place_of(random_numbers(item, 1.5)), y = moved(d, x);
            for (const auto& [still, other] : pairs) {
                double g[3], h[3];
                EXPECT_NEAR(still->evaluate(x.data(), g, nullptr), other->evaluate(y.data(), h, nullptr), 1e-13);
                for (uint32_t i = 0; i < d; ++i) {
                    double turned = 0;
                    for (uint32_t k = 0; k < d; ++k) turned += turn[i][k] * g[k];
                    EXPECT_NEAR(turned, h[i], 1e-12);
                }
            }
        }
    }
}

TEST(Obstacles, APolygonIsABoxEitherWayRound) {
    const double centre[2] = {0.5, 1}, half[2] = {0.5, 1};
    const BoxObstacle box(2, centre, half, nullptr);
    const std::vector<double> left = {0, 0, 1, 0, 1, 2, 0, 2}, right = {0, 2, 1, 2, 1, 0, 0, 0};
    const PolygonObstacle a(left, heap()), b(right, heap());
    for (uint64_t item = 0; item < 300; ++item) {
        const Numbers x = random_numbers(item, 3);
        EXPECT_NEAR(a.evaluate(x.data(), nullptr, nullptr), box.evaluate(x.data(), nullptr, nullptr), 1e-12);
        EXPECT_NEAR(b.evaluate(x.data(), nullptr, nullptr), box.evaluate(x.data(), nullptr, nullptr), 1e-12);
    }
}

TEST(Obstacles, APolygonOfManyEdgesIsADisc) {
    std::vector<double> xy;
    constexpr uint32_t n = PolygonObstacle::max_vertices;
    for (uint32_t i = 0; i < n; ++i) {
        xy.push_back(std::cos(2 * std::numbers::pi * i / n));
        xy.push_back(std::sin(2 * std::numbers::pi * i / n));
    }
    const PolygonObstacle polygon(xy, heap());
    const double sagitta = 1 - std::cos(std::numbers::pi / n);
    for (uint64_t item = 0; item < 300; ++item) {
        const Numbers x = random_numbers(item, 3);
        const double disc = std::hypot(x[0], x[1]) - 1;
        EXPECT_GE(polygon.evaluate(x.data(), nullptr, nullptr), disc - 1e-12);
        EXPECT_LE(polygon.evaluate(x.data(), nullptr, nullptr), disc + sagitta + 1e-12);
    }
    EXPECT_NEAR(polygon.core_depth(), 0.5, 1e-3);
}

// The neck of an hourglass is 0.2 wide; a comb's teeth have no neck, but are thin.
TEST(Obstacles, APolygonsCoreIsNoDeeperThanItsNeck) {
    const std::vector<double> hourglass = {-1, -1, 1, -1, 0.1, 0, 1, 1, -1, 1, -0.1, 0};
    EXPECT_NEAR(PolygonObstacle(hourglass, heap()).core_depth(), 0.1, 1e-12);
    const std::vector<double> triangle = {0, 0, 4, 0, 0, 3};  // inscribed circle of radius 1
    EXPECT_NEAR(PolygonObstacle(triangle, heap()).core_depth(), 0.5, 1e-12);
}

TEST(Obstacles, ASetIsTheNearestLessTheClearance) {
    const double a[2] = {-1, 0}, b[2] = {1, 0.2}, half[2] = {0.3, 0.4};
    const BallObstacle ball(2, a, 0.5);
    const BoxObstacle box(2, b, half, nullptr);
    const Obstacle* both[] = {&ball, &box};
    const ObstacleSet set(both, 0.1, heap());
    for (uint64_t item = 0; item < 300; ++item) {
        const Numbers x = random_numbers(item, 2);
        uint32_t which = 9;
        double gradient[2], expected[2];
        const double first = ball.evaluate(x.data(), nullptr, nullptr),
                     second = box.evaluate(x.data(), nullptr, nullptr);
        EXPECT_EQ(set.distance(x.data(), &which, gradient), std::min(first, second) - 0.1);
        EXPECT_EQ(which, second < first ? 1u : 0u);
        both[which]->evaluate(x.data(), expected, nullptr);
        EXPECT_EQ(gradient[0], expected[0]);
        EXPECT_EQ(gradient[1], expected[1]);
        for (uint32_t i = 0; i < 2; ++i)
            EXPECT_LE(set.at_least(i, x.data()), both[i]->evaluate(x.data(), nullptr, nullptr) - 0.1 + 1e-14);
    }
    EXPECT_EQ(set.step_limit(), 0.3);
    Obstacle::Box bounds;
    ASSERT_TRUE(set.box(bounds));
    EXPECT_NEAR(bounds.lower[0], -1.6, 1e-15);
    EXPECT_NEAR(bounds.upper[1], 0.7, 1e-15);
}

// Against 2,000 samples of the way.
TEST(Obstacles, AWayIsClearIfAllItsPointsAre) {
    const auto shapes = all_shapes();
    uint32_t clear = 0, hit = 0;
    for (size_t s = 0; s + 1 < shapes.size(); ++s) {
        const Obstacle* one = shapes[s].get();
        const ObstacleSet set({&one, 1}, 0.05, heap());
        for (uint64_t item = 0; item < 50; ++item) {
            const Numbers a = random_numbers(item, 1.5), b = random_numbers(item + 500, 1.5);
            double least = 10;
            for (int i = 0; i <= 2000; ++i) {
                Numbers x{};
                for (uint32_t k = 0; k < 3; ++k) x[k] = a[k] + i / 2000.0 * (b[k] - a[k]);
                least = std::min(least, set.distance(x.data()));
            }
            const bool found_clear =
                run_now(heap(), [&](Pace& pace) { return is_clear(pace, set, place_of(a), place_of(b), 0.01); });
            if (found_clear) {
                EXPECT_GT(least, 0);
            }
            if (least > 0.011) {
                EXPECT_TRUE(found_clear);
            }
            ++(found_clear ? clear : hit);
        }
    }
    EXPECT_GT(clear, 50u);
    EXPECT_GT(hit, 50u);
}

TEST(Obstacles, CoresAreDeepInside) {
    for (const auto& shape : all_shapes()) {
        EXPECT_LT(shape->evaluate(shape->core().data(), nullptr, nullptr), -0.05);
    }
    // A frame with a slit: its middle is outside.
    const std::vector<double> frame = {-1,   -1,  1,   -1,  1,   1,    -1,   1,    -1,   0.1,  -0.8, 0.1,
                                       -0.8, 0.8, 0.8, 0.8, 0.8, -0.8, -0.8, -0.8, -0.8, -0.1, -1,   -0.1};
    const PolygonObstacle polygon(frame, heap());
    EXPECT_NEAR(polygon.core_depth(), 0.1, 0.01);
    EXPECT_LT(polygon.evaluate(polygon.core().data(), nullptr, nullptr), -0.05);
}

// A piece may slide along a disc, not jump over it, nor swing around one of its ends through it.
TEST(Obstacles, PiecesOfCurvesKeepTheirSides) {
    const BallObstacle disc(2, std::array{0.0, 0.0}.data(), 0.5);
    const BoxObstacle wall(2, std::array{3.0, 0.0}.data(), std::array{0.05, 1.0}.data(), nullptr);
    const Obstacle* all[] = {&disc, &wall};
    const ObstacleSet set(all, 0, heap());
    const auto keeps = [&](std::array<double, 8> x) { return set.keeps_sides(&x[0], &x[2], &x[4], &x[6]); };
    EXPECT_TRUE(keeps({-1, 0.6, 1, 0.6, -1, 0.9, 1, 0.7}));
    EXPECT_TRUE(keeps({-1, 0.6, 1, 0.6, -1, 0.6, 1, 0.6}));
    EXPECT_FALSE(keeps({-1, 0.6, 1, 0.6, -1, -0.6, 1, -0.6}));
    EXPECT_FALSE(keeps({-0.1, 0.6, 0.1, 0.6, -0.1, -0.6, 0.1, -0.6}));  // short ones too
    EXPECT_FALSE(keeps({-1, 0.6, 1, 0.6, -1, 0.6, 1, -0.7}));
    EXPECT_TRUE(keeps({-1, 0.6, 0, 0.6, -1, 0.6, 0.6, 0.5}));
    EXPECT_FALSE(keeps({2, 0, 2.9, 0, 2, 0, 3.1, 0}));  // through the wall, beside its core
    EXPECT_FALSE(keeps({2, 0.7, 2.9, 0.7, 2, 0.7, 3.1, 0.7}));
    EXPECT_TRUE(keeps({2, 0.7, 2.9, 0.7, 2, 0.5, 2.9, 0.9}));
    const BallObstacle ball(3, std::array{0.0, 0.0, 0.0}.data(), 0.5);
    const Obstacle* one[] = {&ball};
    const ObstacleSet space(one, 0, heap());
    const double a[3] = {-0.1, 0, 0.6}, b[3] = {0.1, 0, 0.6}, c[3] = {-0.1, 0, -0.6}, e[3] = {0.1, 0, -0.6};
    const double f[3] = {-0.1, 0.2, 0.6}, g[3] = {0.1, 0.2, 0.6};
    EXPECT_FALSE(space.keeps_sides(a, b, c, e));
    EXPECT_TRUE(space.keeps_sides(a, b, f, g));
}

// Over a rectangle a prism is a box.
TEST(Obstacles, APrismOverARectangleIsABox) {
    const auto turn = rotation(3);
    double axes[9];
    for (uint32_t i = 0; i < 3; ++i) std::copy_n(turn[i].begin(), 3, axes + i * 3);
    const double centre[3] = {0.1, -0.2, 0.15}, half[3] = {0.5, 0.3, 0.2};
    const BoxObstacle box(3, centre, half, axes);
    const PrismObstacle prism(PolygonObstacle(std::vector{-0.5, -0.3, 0.5, -0.3, 0.5, 0.3, -0.5, 0.3}, heap()), centre,
                              axes, 0.2);
    for (uint32_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(prism.box().lower[k], box.box().lower[k], 1e-12);
        EXPECT_NEAR(prism.box().upper[k], box.box().upper[k], 1e-12);
    }
    for (uint64_t item = 0; item < 1000; ++item) {
        const Numbers x = random_numbers(item, 1.2);
        double g[3], h[9], expected_g[3], expected_h[9];
        EXPECT_NEAR(prism.evaluate(x.data(), g, h), box.evaluate(x.data(), expected_g, expected_h), 1e-12);
        for (uint32_t k = 0; k < 3; ++k) EXPECT_NEAR(g[k], expected_g[k], 1e-12);
        for (uint32_t k = 0; k < 9; ++k) EXPECT_NEAR(h[k], expected_h[k], 1e-9);
    }
}

TEST(Obstacles, BadNumbersAreRefused) {
    const double nan = std::nan("");
    const double good[3] = {0, 0, 0}, bad[3] = {0, nan, 0}, half[3] = {1, 1, 1}, flat[3] = {1, 0, 1};
    const double skew[4] = {1, 0, 0.1, 1};
    EXPECT_THROW(BallObstacle(4, good, 1), Failure);
    EXPECT_THROW(BallObstacle(2, bad, 1), Failure);
    EXPECT_THROW(BallObstacle(2, good, 0), Failure);
    EXPECT_THROW(BallObstacle(2, good, nan), Failure);
    EXPECT_THROW(BoxObstacle(3, bad, half, nullptr), Failure);
    EXPECT_THROW(BoxObstacle(3, good, flat, nullptr), Failure);
    EXPECT_THROW(BoxObstacle(2, good, half, skew), Failure);
    EXPECT_THROW(CapsuleObstacle(2, good, bad, 1), Failure);
    EXPECT_THROW(CapsuleObstacle(2, good, half, -1), Failure);
    const double nothing[3] = {0, 0, 0};
    EXPECT_THROW(HalfSpaceObstacle(2, good, nothing), Failure);
    EXPECT_THROW(HalfSpaceObstacle(3, bad, half), Failure);
    EXPECT_THROW(HalfSpaceObstacle(3, good, bad), Failure);
    const PolygonObstacle base(star(3), heap());
    EXPECT_THROW(PrismObstacle(base, good, nullptr, 0), Failure);
    EXPECT_THROW(PrismObstacle(base, bad, nullptr, 1), Failure);
    EXPECT_THROW(PrismObstacle(base, good, std::array{1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0}.data(), 1), Failure);
    EXPECT_THROW(FunctionObstacle(3, {nullptr, nullptr, nullptr}, {{0, 0, 0}, {1, 1, 1}}, true, 1, 1), Failure);
    EXPECT_THROW(FunctionObstacle(3, {egg, nullptr, nullptr}, {{0, 0, 0}, {1, nan, 1}}, true, 1, 1), Failure);
    const auto polygon = [](std::vector<double> xy) { return PolygonObstacle(xy, heap()); };
    EXPECT_THROW(polygon({0, 0, 1, 0}), Failure);
    EXPECT_THROW(polygon({0, 0, 1, nan, 1, 1}), Failure);
    EXPECT_THROW(polygon({0, 0, 1, 0, 1, 0, 0, 1}), Failure);  // an edge without length
    EXPECT_THROW(polygon({0, 0, 1, 1, 1, 0, 0, 1}), Failure);  // a bow tie
    EXPECT_THROW(polygon({0, 0, 2, 0, 1, 0}), Failure);        // flat
    EXPECT_THROW(polygon(std::vector<double>(2 * 257, 0.0)), Failure);
    const BallObstacle disc(2, good, 1), ball(3, good, 1);
    const Obstacle *mixed[] = {&disc, &ball}, *one[] = {&disc}, *none[] = {nullptr};
    EXPECT_THROW(ObstacleSet(mixed, 0, heap()), Failure);
    EXPECT_THROW(ObstacleSet(none, 0, heap()), Failure);
    EXPECT_THROW(ObstacleSet({}, 0, heap()), Failure);
    EXPECT_THROW(ObstacleSet(one, -1, heap()), Failure);
    EXPECT_THROW(ObstacleSet(one, nan, heap()), Failure);
}

}  // namespace
}  // namespace flg::test
