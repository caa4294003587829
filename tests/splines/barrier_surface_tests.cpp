// SPDX-License-Identifier: MIT
#include "splines/obstacles/barrier_surface.h"

#include <numbers>

#include "core/failure.h"
#include "splines/obstacle_checks.h"
#include "splines/obstacles/obstacle_polygon.h"
#include "splines/obstacles/obstacle_shapes.h"

namespace flg::test {
namespace {

// A disc, a box and, below, a channel of width 0.1 between a capsule and a box.
struct Plane {
    BallObstacle ball{2, std::array{-1.0, 0.0}.data(), 0.5};
    BoxObstacle box{2, std::array{0.5, 0.5}.data(), std::array{0.4, 0.3}.data(), nullptr};
    BoxObstacle floor{2, std::array{0.5, -1.0}.data(), std::array{0.8, 0.2}.data(), nullptr};
    CapsuleObstacle bar{2, std::array{0.0, -0.6}.data(), std::array{1.0, -0.6}.data(), 0.1};
    const Obstacle* all[4] = {&ball, &box, &floor, &bar};
    ObstacleSet set{all, 0, heap()};
};

struct Space {
    BallObstacle ball{3, std::array{-0.5, 0.0, 0.1}.data(), 0.5};
    CapsuleObstacle bar{3, std::array{0.5, -0.6, 0.0}.data(), std::array{0.7, 0.6, 0.3}.data(), 0.2};
    BoxObstacle box{3, std::array{0.0, 0.8, 0.0}.data(), std::array{0.3, 0.2, 0.4}.data(), nullptr};
    const Obstacle* all[3] = {&ball, &bar, &box};
    ObstacleSet set{all, 0.05, heap()};
};

void check_derivatives(const ObstacleSet& set, double radius) {
    const BarrierSurface surface(set, radius, 4);
    uint32_t near = 0;
    for (uint64_t item = 0; item < 1000; ++item) {
        Numbers x = random_numbers(item, 1.4);
        x[set.dimension()] = 0.5 * radius * (1 + x[set.dimension()] / 1.4);
        double value, gradient[4], second[16];
        ASSERT_TRUE(surface.evaluate(x.data(), nullptr, &value, gradient, second));
        if (std::abs(value) > 0.5 * radius || set.distance(x.data()) < 0.01) continue;
        ++near;
        const auto function = [&](const double* at, double* g, double* h) {
            double result = 0;
            surface.evaluate(at, nullptr, &result, g, h);
            return result;
        };
        expect_derivatives(function, set.dimension() + 1, x, 1e-5);
    }
    EXPECT_GT(near, 50u);
}

TEST(BarrierSurface, DerivativesAreThoseOfDifferences) {
    check_derivatives(Plane().set, 0.3);
    check_derivatives(Space().set, 0.3);
}

// Projections of the generic default, at places where the surface bends evenly.
void check_second_form(const ObstacleSet& set, double radius) {
    const BarrierSurface surface(set, radius, 1);
    const uint32_t d = set.dimension(), n = d + 1;
    uint32_t checked = 0;
    for (uint64_t item = 0; item < 1000; ++item) {
        Numbers x = random_numbers(item, 1.4);
        x[d] = radius * 0.5;
        if (!surface.project(x.data(), nullptr)) continue;
        // Away from where circles begin and end.
        bool even = x[d] < radius - 1e-3;
        uint32_t within = 0;
        for (uint32_t i = 0; i < set.count(); ++i) {
            const double away = set.evaluate(i, x.data(), nullptr, nullptr);
            even = even && std::abs(away - radius) > 1e-3 && away > 1e-3;
            within += away < radius;
        }
        if (!even || within == 0) continue;
        double basis[12], form[9], generic[9];
        surface.tangent_basis(x.data(), nullptr, basis);
        const Numbers force = random_numbers(item + 5000);
        surface.second_form(x.data(), nullptr, basis, force.data(), form);
        surface.Manifold::second_form(x.data(), nullptr, basis, force.data(), generic);
        double most = 1;
        for (uint32_t i = 0; i < d * d; ++i) most = std::max(most, std::abs(form[i]));
        if (most > 30) continue;  // at a corner
        for (uint32_t i = 0; i < d * d; ++i) EXPECT_NEAR(form[i], generic[i], 2e-4 * most) << n;
        ++checked;
    }
    EXPECT_GT(checked, 50u);
}

TEST(BarrierSurface, SecondFormIsThatOfProjections) {
    check_second_form(Plane().set, 0.3);
    check_second_form(Space().set, 0.3);
}

// A disc's blend is part of a torus, whose curvatures are known.
TEST(BarrierSurface, ADiscsBlendIsPartOfATorus) {
    const double centre[2] = {0.2, -0.1}, disc = 0.7, r = 0.25;
    const BallObstacle ball(2, centre, disc);
    const Obstacle* one[] = {&ball};
    const ObstacleSet set(one, 0, heap());
    const BarrierSurface surface(set, r, 3);
    for (const double t : {0.1, 0.7, 1.4}) {
        const double rho = disc + r - r * std::sin(t);
        double x[3] = {centre[0] + 0.6 * rho, centre[1] + 0.8 * rho, r - r * std::cos(t)};
        double value, gradient[3], basis[6], form[4];
        ASSERT_TRUE(surface.evaluate(x, nullptr, &value, gradient, nullptr));
        EXPECT_NEAR(value, 0, 1e-15);
        EXPECT_NEAR(gradient[0], 0.6 * std::sin(t), 1e-12);
        EXPECT_NEAR(gradient[2], std::cos(t), 1e-12);
        surface.tangent_basis(x, nullptr, basis);
        surface.second_form(x, nullptr, basis, gradient, form);
        // Towards the normal the profile bends by 1 / r, the parallel away by sin t / rho.
        const double across = 1 / r, around = -std::sin(t) / rho;
        EXPECT_NEAR(form[0] + form[3], across + around, 1e-9);
        EXPECT_NEAR(form[0] * form[3] - form[1] * form[2], across * around, 1e-9);
    }
}

TEST(BarrierSurface, ProjectionIsToTheNearestPoint) {
    const Plane plane;
    for (const double radius : {0.4, 0.1, 1e-3}) {
        const BarrierSurface surface(plane.set, radius, 4);
        for (uint64_t item = 0; item < 300; ++item) {
            Numbers x = random_numbers(item, 1.6);
            Numbers y = x;
            ASSERT_TRUE(surface.project(y.data(), nullptr));
            uint32_t within = 0;
            for (uint32_t i = 0; i < 4; ++i) {
                within += plane.set.evaluate(i, x.data(), nullptr, nullptr) < radius ||
                          plane.set.evaluate(i, y.data(), nullptr, nullptr) < radius;
            }
            double value, gradient[3];
            surface.evaluate(y.data(), nullptr, &value, gradient, nullptr);
            EXPECT_NEAR(value, 0, 1e-12);
            if (within > 1 || x[2] > radius) continue;  // where f is the distance
            double before, other[3], away = 0;
            surface.evaluate(x.data(), nullptr, &before, other, nullptr);
            for (int k = 0; k < 3; ++k) away += (y[k] - x[k]) * (y[k] - x[k]);
            EXPECT_NEAR(std::sqrt(away), std::abs(before), 1e-9);
        }
    }
}

template <class Scene>
void check_outside(const Scene& scene, double radius) {
    BarrierSurface surface(scene.set, radius, 4);
    for (const double shrink : {1.0, 0.1, 0.01, 1e-4}) {
        surface.set_radius(radius * shrink);
        uint32_t inside = 0;
        for (uint64_t item = 0; item < 2000; ++item) {
            Numbers x = random_numbers(item, 1.4);
            x[scene.set.dimension()] *= 0.3;
            inside += scene.set.distance(x.data()) < 0;
            ASSERT_TRUE(surface.project(x.data(), nullptr)) << item;
            EXPECT_GT(scene.set.distance(x.data()), -1e-12);
        }
        EXPECT_GT(inside, 100u);
    }
}

TEST(BarrierSurface, ProjectedPointsAreOutside) {
    check_outside(Plane(), 0.4);
    check_outside(Space(), 0.4);
}

TEST(BarrierSurface, LiftingKeepsThePointAndGoesDownWithTheRadius) {
    const Plane plane;
    BarrierSurface surface(plane.set, 0.5, 4);
    for (uint64_t item = 0; item < 300; ++item) {
        const Numbers p = random_numbers(item, 1.4);
        const double away = plane.set.distance(p.data());
        double last = 1;
        for (double radius = 0.5; radius > 1e-4; radius /= 4) {
            surface.set_radius(radius);
            double x[3], value, gradient[3];
            const bool free = surface.lift(p.data(), x);
            EXPECT_EQ(free, away >= 0);
            surface.evaluate(x, nullptr, &value, gradient, nullptr);
            EXPECT_NEAR(value, 0, 1e-12);
            if (!free) continue;
            EXPECT_EQ(x[0], p[0]);
            EXPECT_EQ(x[1], p[1]);
            EXPECT_LE(x[2], last);
            if (radius <= away) {
                EXPECT_EQ(x[2], 0);
            }
            last = x[2];
        }
    }
}

// The channel is narrower than the radius, and open all the same; its middle has no crease.
TEST(BarrierSurface, AGapStaysOpenAndSmooth) {
    const Plane plane;  // the channel: 0 < x < 1, -0.8 < y < -0.7
    const BarrierSurface surface(plane.set, 0.4, 4);
    double last = 1;
    for (int i = 1; i <= 5; ++i) {
        const double p[2] = {0.5, -0.8 + 0.01 * i};
        double x[3], value, gradient[3];
        EXPECT_TRUE(surface.lift(p, x));
        EXPECT_LT(x[2], last);
        last = x[2];
        surface.evaluate(x, nullptr, &value, gradient, nullptr);
        EXPECT_NEAR(value, 0, 1e-12);
        if (i == 5) {
            EXPECT_NEAR(gradient[1], 0, 1e-12);
        }
    }
    for (const double side : {-1.0, 1.0}) {
        double x[3] = {0.5, -0.75 + side * 1e-7, last}, value, gradient[3];
        surface.evaluate(x, nullptr, &value, gradient, nullptr);
        EXPECT_NEAR(gradient[1], 0, 1e-4);
    }
}

// Steps below the limit from the boundary inwards come out where they came in.
TEST(BarrierSurface, ShortStepsStayOnTheirSide) {
    const Plane plane;
    const BarrierSurface surface(plane.set, 0.01, 4);
    const double limit = surface.step_limit();
    EXPECT_EQ(limit, 0.1);
    for (double angle = 0; angle < 6.28; angle += 0.1) {
        const double out[2] = {std::cos(angle), std::sin(angle)};
        double x[3] = {-1 + (0.5 - 0.99 * limit) * out[0], (0.5 - 0.99 * limit) * out[1], 0};
        ASSERT_TRUE(surface.project(x, nullptr));
        EXPECT_NEAR((x[0] + 1) * out[0] + x[1] * out[1], 0.5, 0.01);
    }
    for (double along = 0.05; along < 1; along += 0.1) {
        double x[3] = {along, -0.5 - 0.99 * limit, 0};  // from above into the bar
        ASSERT_TRUE(surface.project(x, nullptr));
        EXPECT_GT(x[1], -0.6);
    }
}

TEST(BarrierSurface, MovesWithTheObstacles) {
    const double a[2] = {0.1, 0.3}, half[2] = {0.4, 0.2};
    const auto turn = rotation(2);
    const double axes[4] = {turn[0][0], turn[1][0], turn[0][1], turn[1][1]};
    const auto a_moved = moved(2, {a[0], a[1], 0});
    const BoxObstacle box(2, a, half, nullptr), other(2, a_moved.data(), half, axes);
    const Obstacle *one[] = {&box}, *two[] = {&other};
    const ObstacleSet set(one, 0.1, heap()), set_moved(two, 0.1, heap());
    const BarrierSurface surface(set, 0.2, 2), surface_moved(set_moved, 0.2, 2);
    for (uint64_t item = 0; item < 200; ++item) {
        const Numbers x = random_numbers(item);
        double still[3] = {x[0], x[1], 0.1 * x[2]};
        const auto y = moved(2, {x[0], x[1], 0});
        double other_x[3] = {y[0], y[1], 0.1 * x[2]};
        ASSERT_TRUE(surface.project(still, nullptr));
        ASSERT_TRUE(surface_moved.project(other_x, nullptr));
        const auto expected = moved(2, {still[0], still[1], 0});
        EXPECT_NEAR(other_x[0], expected[0], 1e-9);
        EXPECT_NEAR(other_x[1], expected[1], 1e-9);
        EXPECT_NEAR(other_x[2], still[2], 1e-9);
    }
}

TEST(BarrierSurface, ARadiusHasToBePositive) {
    const Plane plane;
    EXPECT_THROW(BarrierSurface(plane.set, 0, 1), Failure);
    BarrierSurface surface(plane.set, 0.1, 1);
    EXPECT_THROW(surface.set_radius(-1), Failure);
    EXPECT_THROW(surface.set_radius(std::nan("")), Failure);
    EXPECT_EQ(surface.radius(), 0.1);
}

}  // namespace
}  // namespace flg::test
