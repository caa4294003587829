// SPDX-License-Identifier: MIT
// Motions of least energy: against free bodies, statics, the natural spline, and the keys.
#include "splines/motion/motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "core/failure.h"
#include "runtime/run_now.h"
#include "splines/nan_memory.h"
#include "splines/obstacles/obstacle_shapes.h"
#include "splines/optimizer/natural_cubic.h"

namespace flg::test {
namespace {

using Mat3 = Eigen::Matrix3d;

const std::vector<double> hammer{0, 0, 0, 0.5, 0, 0, 1, 0, 0, 1, 0.3, 0.1, 1, -0.3, 0.1, 1.2, 0.1, -0.2};

Mat3 turn(const Vec3& vector) {
    return Eigen::AngleAxisd(vector.norm(), vector.normalized()).toRotationMatrix();
}

struct Pose {
    Mat3 rotation;
    Vec3 place;
    Vec3 at(const Vec3& p) const { return rotation * p + place; }
};

Pose pose_at(const double* p) {
    Pose pose;
    pose.rotation << p[0], p[1], p[2], p[4], p[5], p[6], p[8], p[9], p[10];
    pose.place = Vec3(p[3], p[7], p[11]);
    return pose;
}

MotionInput random_keys(size_t count, double amount, bool closed) {
    MotionInput input(nan_memory());
    input.body = inertia_of_points(hammer, {});
    input.desc.closed = closed;
    input.desc.tolerance = 1e-6;
    input.desc.max_rounds = 200;
    input.desc.obstacle_radius = 1e-3;
    input.desc.key_count = static_cast<uint32_t>(count);
    std::mt19937 random(static_cast<unsigned>(count));
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> gap(0.6, 1.4);
    Mat3 rotation = Mat3::Identity();
    double time = 0.5;
    for (size_t i = 0; i < count; ++i) {
        input.times.push_back(time);
        time += gap(random);
        const Vec3 place(normal(random), 2 * normal(random), normal(random));
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) input.poses.push_back(rotation(row, column));
            input.poses.push_back(place[row]);
        }
        rotation = rotation * turn(amount * Vec3(normal(random), normal(random), normal(random)).normalized());
    }
    input.desc.end_time = time;
    input.desc.position_count = static_cast<uint32_t>(24 * count);
    return input;
}

std::shared_ptr<Motion> make(const MotionInput& input, bool haltingly = false) {
    auto motion = std::make_shared<Motion>(input, nan_memory());
    const auto make = [&](Pace& pace) { return make_motion(pace, motion); };
    run_now(nan_memory(), make, haltingly);
    motion->publish_complete();
    return motion;
}

void set_energy(MotionInput& input, FlgSplineEnergy energy, double tension = 3) {
    input.desc.energy = energy;
    input.desc.tension = tension;
}

constexpr FlgSplineEnergy all_energies[] = {FLG_SPLINE_ENERGY_E2, FLG_SPLINE_ENERGY_E1, FLG_SPLINE_ENERGY_ET};

TEST(Motion, KeysAreHit) {
    for (const bool closed : {false, true}) {
        for (const FlgSplineEnergy energy : all_energies) {
            MotionInput input = random_keys(6, 2, closed);
            set_energy(input, energy);
            const auto motion = make(input);
            const FlgMotionView& view = motion->view();
            EXPECT_EQ(view.ending, FLG_SPLINE_ENDING_CONVERGED);
            EXPECT_LE(view.residual, 1e-6);
            ASSERT_EQ(view.key_count, 6u);
            for (uint32_t i = 0; i < 6; ++i) {
                const uint32_t position = view.key_positions[i];
                EXPECT_EQ(view.times[position], input.times[i]);
                for (int c = 0; c < 12; ++c) EXPECT_NEAR(view.poses[12 * position + c], input.poses[12 * i + c], 1e-13);
            }
            EXPECT_EQ(view.key_positions[0], 0u);
            if (closed) {
                EXPECT_EQ(view.times[view.position_count], input.desc.end_time);
            } else {
                EXPECT_EQ(view.key_positions[5], view.position_count - 1);
            }
            for (uint32_t i = 1; i < view.position_count; ++i) EXPECT_LT(view.times[i - 1], view.times[i]);
        }
    }
}

TEST(Motion, PositionsAreRotationsAndQuaternionsAreTheirs) {
    const auto motion = make(random_keys(7, 2.5, true));
    const FlgMotionView& view = motion->view();
    for (uint32_t i = 0; i < view.position_count; ++i) {
        const Pose pose = pose_at(view.poses + 12 * i);
        EXPECT_LT((pose.rotation.transpose() * pose.rotation - Mat3::Identity()).norm(), 1e-14);
        EXPECT_GT(pose.rotation.determinant(), 0);
        const Eigen::Map<const Eigen::Quaterniond> q(view.quaternions + 4 * i);
        EXPECT_LT((q.toRotationMatrix() - pose.rotation).norm(), 1e-14);
        if (i > 0) {
            EXPECT_GT(q.dot(Eigen::Map<const Eigen::Quaterniond>(view.quaternions + 4 * i - 4)), 0.5);
        }
    }
}

TEST(Motion, TheBarycentreIsTheClassicalSpline) {
    for (const bool closed : {false, true}) {
        for (const FlgSplineEnergy energy : all_energies) {
            MotionInput input = random_keys(5, 1.5, closed);
            set_energy(input, energy);
            const auto motion = make(input);
            const FlgMotionView& view = motion->view();
            const Vec3 middle(view.barycentre[0], view.barycentre[1], view.barycentre[2]);
            std::vector<double> values, knots(input.times.begin(), input.times.end());
            if (closed) knots.push_back(input.desc.end_time);
            for (size_t i = 0; i < 5; ++i) {
                const Vec3 p = pose_at(&input.poses[12 * i]).at(middle);
                values.insert(values.end(), p.data(), p.data() + 3);
            }
            const CubicData data{.knots = knots,
                                 .values = values,
                                 .ends = closed ? CubicEnds::periodic : CubicEnds::natural,
                                 .tension = energy == FLG_SPLINE_ENERGY_E1 ? HUGE_VAL : input.tension()};
            const NaturalCubic spline = run_now(nan_memory(), [&](Pace& pace) { return natural_cubic(pace, data); });
            for (uint32_t i = 0; i < view.position_count; ++i) {
                Vec3 expected;
                spline.evaluate(view.times[i], 0, expected.data());
                EXPECT_LT((pose_at(view.poses + 12 * i).at(middle) - expected).norm(), 1e-13);
            }
        }
    }
}

// The derivative of order 2 or 4 of a point's path, by differences around a position whose neighbours are equally far.
Vec3 derivative(const FlgMotionView& view, uint32_t position, int order, const Vec3& p) {
    constexpr double weights[2][5] = {{-1.0 / 12, 4.0 / 3, -5.0 / 2, 4.0 / 3, -1.0 / 12}, {1, -4, 6, -4, 1}};
    const double step = view.times[position + 1] - view.times[position];
    Vec3 sum = Vec3::Zero();
    for (int j = 0; j < 5; ++j) sum += weights[order / 4][j] * pose_at(view.poses + 12 * (position + j - 2)).at(p);
    return sum / std::pow(step, order);
}

struct ForceSystem {
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    double size = 0;  // of the single forces, and of their arms
};

ForceSystem forces(const FlgMotionView& view, uint32_t position, int order) {
    ForceSystem system;
    const Vec3 middle =
        pose_at(view.poses + 12 * position).at(Vec3(view.barycentre[0], view.barycentre[1], view.barycentre[2]));
    for (size_t i = 0; i < hammer.size(); i += 3) {
        const Vec3 p(hammer[i], hammer[i + 1], hammer[i + 2]);
        const Vec3 force = derivative(view, position, order, p);
        system.force += force;
        system.moment += (pose_at(view.poses + 12 * position).at(p) - middle).cross(force);
        system.size += force.norm();
    }
    return system;
}

// Away from keys, where derivatives of that order jump.
template <class Visit>
void visit_smooth(const FlgMotionView& view, const Visit& visit) {
    for (uint32_t k = 0; k + 1 < view.key_count; ++k) {
        for (uint32_t i = view.key_positions[k] + 3; i + 3 < view.key_positions[k + 1]; i += 5) visit(i);
    }
}

TEST(Motion, FourthDerivativesAreInBalance) {
    double before = 0;
    for (const uint32_t positions : {121u, 241u}) {
        MotionInput input = random_keys(5, 1.5, false);
        input.desc.position_count = positions;
        const auto motion = make(input);
        const FlgMotionView& view = motion->view();
        double worst = 0;
        visit_smooth(view, [&](uint32_t i) {
            const ForceSystem system = forces(view, i, 4);
            EXPECT_LT(system.force.norm(), 1e-3 * system.size);
            worst = std::max(worst, system.moment.norm() / system.size);
        });
        // Up to the differences' error, the square of the step.
        EXPECT_LT(worst, 0.02);
        if (before > 0) {
            EXPECT_LT(worst, 0.4 * before);
        }
        before = worst;
    }
}

// At natural ends the forces of the second derivatives are in balance: nothing turns the body there, nor pushes it.
TEST(Motion, SecondDerivativesAreInBalanceAtTheEnds) {
    double before = 0;
    for (const uint32_t positions : {121u, 481u}) {
        MotionInput input = random_keys(4, 1.5, false);
        input.desc.position_count = positions;
        const auto motion = make(input);
        const FlgMotionView& view = motion->view();
        double greatest = 0;
        visit_smooth(view, [&](uint32_t i) { greatest = std::max(greatest, forces(view, i, 2).moment.norm()); });
        const double at_end = forces(view, 2, 2).moment.norm() + forces(view, view.position_count - 3, 2).moment.norm();
        // Two steps away from the end: as large as they are long.
        EXPECT_LT(at_end, 0.25 * greatest);
        if (before > 0) {
            EXPECT_LT(at_end, 0.3 * before);
        }
        before = at_end;
    }
}

// Between two keys E1 gives the flight of a free body: the barycentre goes evenly, energy and angular momentum stay.
TEST(Motion, FreeBodiesKeepTheirAngularMomentum) {
    MotionInput input = random_keys(2, 2.5, false);
    set_energy(input, FLG_SPLINE_ENERGY_E1);
    input.desc.position_count = 401;
    const auto motion = make(input);
    const FlgMotionView& view = motion->view();
    const Vec3 middle(view.barycentre[0], view.barycentre[1], view.barycentre[2]);
    Vec3 first = Vec3::Zero();
    double first_energy = 0, turned = 0;
    for (uint32_t i = 0; i + 1 < view.position_count; ++i) {
        const Pose a = pose_at(view.poses + 12 * i), b = pose_at(view.poses + 12 * (i + 1));
        const double step = view.times[i + 1] - view.times[i];
        Vec3 momentum = Vec3::Zero();
        double energy = 0;
        for (size_t k = 0; k < hammer.size(); k += 3) {
            const Vec3 p(hammer[k], hammer[k + 1], hammer[k + 2]);
            const Vec3 arm = 0.5 * (a.at(p) + b.at(p) - a.at(middle) - b.at(middle)),
                       velocity = (b.at(p) - a.at(p)) / step;
            momentum += arm.cross(velocity);
            energy += velocity.squaredNorm();
        }
        if (i == 0) {
            first = momentum;
            first_energy = energy;
        }
        EXPECT_LT((momentum - first).norm(), 1e-4 * first.norm());
        EXPECT_NEAR(energy, first_energy, 1e-4 * first_energy);
        EXPECT_LT(
            ((b.at(middle) - a.at(middle)) / step -
             (pose_at(view.poses + 12).at(middle) - pose_at(view.poses).at(middle)) / (view.times[1] - view.times[0]))
                .norm(),
            1e-10);
        const Mat3 moved = pose_at(view.poses).rotation.transpose() * b.rotation;
        turned = std::max(turned, Eigen::AngleAxisd(moved).angle());
    }
    EXPECT_NEAR(view.energy, first_energy * (view.times[400] - view.times[0]), 1e-3 * view.energy);
    EXPECT_GT(turned, 2.4);
}

// A ball turns at constant speed about one axis: the great circle of the quaternions (Fig. 9), and E1 of it.
TEST(Motion, BallsTurnAboutOneAxis) {
    MotionInput input = random_keys(2, 2, false);
    input.body = BodyInertia();
    set_energy(input, FLG_SPLINE_ENERGY_E1);
    input.desc.position_count = 101;
    const auto motion = make(input);
    const FlgMotionView& view = motion->view();
    const Mat3 first = pose_at(view.poses).rotation, last = pose_at(view.poses + 1200).rotation;
    for (uint32_t i = 0; i <= 100; ++i) {
        EXPECT_LT((pose_at(view.poses + 12 * i).rotation - rotation_between(first, last, 0.01 * i)).norm(), 1e-7);
    }
}

// Moving the space, and another choice of the body's coordinates, change nothing else.
TEST(Motion, IsEquivariant) {
    const MotionInput input = random_keys(5, 2, true);
    const Pose space{turn(Vec3(1, -2, 0.5)), Vec3(5, 6, -7)}, body{turn(Vec3(0.3, 1, 2)), Vec3(-1, 2, 3)};
    MotionInput moved = input;
    std::vector<double> points;
    for (size_t i = 0; i < hammer.size(); i += 3) {
        const Vec3 p = body.at(Vec3(hammer[i], hammer[i + 1], hammer[i + 2]));
        points.insert(points.end(), p.data(), p.data() + 3);
    }
    moved.body = inertia_of_points(points, {});
    const auto change = [&](const Pose& pose) {
        Pose changed;
        changed.rotation = space.rotation * pose.rotation * body.rotation.transpose();
        changed.place = space.at(pose.at(-body.rotation.transpose() * body.place));
        return changed;
    };
    for (size_t i = 0; i < 5; ++i) {
        const Pose pose = change(pose_at(&input.poses[12 * i]));
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                moved.poses[12 * i + 4 * row + column] = pose.rotation(row, column);
            moved.poses[12 * i + 4 * row + 3] = pose.place[row];
        }
    }
    const auto first = make(input), second = make(moved);
    EXPECT_NEAR(first->view().energy, second->view().energy, 1e-9 * first->view().energy);
    for (uint32_t i = 0; i < input.desc.position_count; ++i) {
        const Pose expected = change(pose_at(first->view().poses + 12 * i));
        const Pose found = pose_at(second->view().poses + 12 * i);
        EXPECT_LT((expected.rotation - found.rotation).norm(), 1e-7);
        EXPECT_LT((expected.place - found.place).norm(), 1e-6);
    }
}

TEST(Motion, ManyPositionsComeToTheSameMotion) {
    MotionInput coarse = random_keys(5, 1.5, false), fine = coarse, straight = coarse;
    coarse.desc.position_count = 4 * 20 + 1;
    fine.desc.position_count = 4 * 80 + 1;
    for (size_t i = 0; i < 5; ++i) coarse.times[i] = fine.times[i] = static_cast<double>(i);
    const auto a = make(coarse), b = make(fine);
    for (uint32_t i = 0; i < coarse.desc.position_count; ++i) {
        EXPECT_EQ(a->view().times[i], b->view().times[4 * i]);
        const Pose p = pose_at(a->view().poses + 12 * i), q = pose_at(b->view().poses + 48 * i);
        EXPECT_LT((p.rotation - q.rotation).norm(), 2e-4);
    }
    // Few positions, where no coarse chain comes first.
    straight.desc.position_count = 5;
    const auto keys_only = make(straight);
    EXPECT_EQ(keys_only->view().position_count, 5u);
    EXPECT_EQ(keys_only->view().ending, FLG_SPLINE_ENDING_CONVERGED);
}

// Near keys that jitter the motion goes with little energy; with a small weight it hardly smooths, with a large one it
// goes far off.
TEST(Motion, SmoothingGoesNearTheKeys) {
    MotionInput input = random_keys(40, 0.4, false);
    input.desc.position_count = 40;
    const double rough = make(input)->view().energy;
    double energy = rough, off = 0;
    for (const double smoothing : {1e-8, 1e-2, 1.0}) {
        input.desc.smoothing = smoothing;
        const auto motion = make(input);
        double distance = 0;
        for (size_t i = 0; i < 40; ++i) {
            for (int c = 0; c < 12; ++c) {
                distance = std::max(distance, std::abs(motion->view().poses[12 * i + c] - input.poses[12 * i + c]));
            }
        }
        // Ends move too: Newton's method has to know all that depends on where they are.
        EXPECT_EQ(motion->view().ending, FLG_SPLINE_ENDING_CONVERGED);
        EXPECT_LE(motion->view().rounds, 12u);
        EXPECT_LE(motion->view().energy, energy * (1 + 1e-12));
        EXPECT_GT(distance, off);
        if (smoothing == 1e-8) {
            EXPECT_LT(distance, 1e-4);
        }
        energy = motion->view().energy;
        off = distance;
    }
    EXPECT_LT(energy, 0.1 * rough);
}

// Fig. 16: with a clearance of the body's radius no point of it comes into the obstacle, however it turns.
TEST(Motion, KeepsOutOfObstacles) {
    MotionInput input = random_keys(2, 2, false);
    input.desc.position_count = 200;
    const double ways[2][3] = {{-4, 0.1, 0}, {4, 0.2, 0.1}};
    for (size_t k = 0; k < 2; ++k) {
        const Pose pose = pose_at(&input.poses[12 * k]);
        const Vec3 place = Vec3(ways[k][0], ways[k][1], ways[k][2]) - pose.rotation * input.body.barycentre;
        for (int row = 0; row < 3; ++row) input.poses[12 * k + 4 * row + 3] = place[row];
    }
    const auto held = std::make_shared<Obstacles>(3u, nan_memory());
    const double centre[3] = {0, 0, 0};
    held->solids.push_back(std::make_shared<BallObstacle>(3, centre, 1.0));
    const Obstacle* const solid = held->solids[0].get();
    held->set.emplace(std::span(&solid, 1), input.body.radius, nan_memory());
    const auto through = make(input);
    input.obstacles = held;
    const auto around = make(input), halting = make(input, true);
    const auto nearest = [&](const Motion& motion) {
        double least = 1e9;
        for (uint32_t i = 0; i < input.desc.position_count; ++i) {
            for (size_t p = 0; p < hammer.size(); p += 3) {
                const Vec3 point(hammer[p], hammer[p + 1], hammer[p + 2]);
                least = std::min(least, pose_at(motion.view().poses + 12 * i).at(point).norm());
            }
        }
        return least;
    };
    EXPECT_LT(nearest(*through), 0.8);
    EXPECT_GT(nearest(*around), 1);
    EXPECT_GT(around->view().barycentre_energy, through->view().barycentre_energy);
    // The rotations know nothing of it.
    EXPECT_EQ(around->view().rotation_energy, through->view().rotation_energy);
    EXPECT_TRUE(
        std::equal(around->view().poses, around->view().poses + 12 * input.desc.position_count, halting->view().poses));
    for (int c = 0; c < 12; ++c) EXPECT_NEAR(around->view().poses[12 * 199 + c], input.poses[12 + c], 1e-12);
    // A key within the clearance.
    input.poses[3] += 4;
    try {
        make(input);
        ADD_FAILURE();
    } catch (const Failure& failure) {
        EXPECT_STREQ(failure.what(), "keys[0] has its barycentre in obstacle 0 or nearer to it than the clearance");
    }
}

// The error falls with the fourth power of the step, whatever the energy.
TEST(Motion, ConvergesWithTheFourthPower) {
    for (const FlgSplineEnergy energy : all_energies) {
        SCOPED_TRACE(energy);
        MotionInput input = random_keys(4, 1.5, false);
        for (size_t i = 0; i < 4; ++i) input.times[i] = static_cast<double>(i);
        set_energy(input, energy, 30);
        input.desc.tolerance = 1e-10;
        std::vector<std::shared_ptr<Motion>> made;
        for (const uint32_t intervals : {20u, 40u, 320u}) {
            input.desc.position_count = 3 * intervals + 1;
            made.push_back(make(input));
        }
        double off[2] = {};
        for (size_t k = 0; k < 2; ++k) {
            const uint32_t step = k == 0 ? 16 : 8;
            for (uint32_t i = 0; i < made[k]->view().position_count; ++i) {
                const Pose p = pose_at(made[k]->view().poses + 12 * i),
                           q = pose_at(made[2]->view().poses + 12 * step * i);
                off[k] = std::max(off[k], (p.rotation - q.rotation).norm());
            }
        }
        EXPECT_LT(off[0], 1e-4);
        EXPECT_LT(off[1], off[0] / 12);
    }
}

MotionInput with_pause(FlgSplineEnergy energy, bool closed) {
    MotionInput input = random_keys(6, 1.5, closed);
    std::copy_n(input.poses.begin() + 24, 12, input.poses.begin() + 36);
    set_energy(input, energy);
    return input;
}

TEST(Motion, StandsStillInAPauseAndComesToItAtRest) {
    for (const bool closed : {false, true}) {
        for (const FlgSplineEnergy energy : all_energies) {
            SCOPED_TRACE(energy);
            MotionInput input = with_pause(energy, closed);
            input.desc.position_count = 6 * 200;
            const auto motion = make(input);
            const FlgMotionView& view = motion->view();
            EXPECT_EQ(view.ending, FLG_SPLINE_ENDING_CONVERGED);
            const uint32_t begin = view.key_positions[2], end = view.key_positions[3];
            ASSERT_GT(end, begin + 10);
            for (uint32_t i = begin; i <= end; ++i) {
                for (int c = 0; c < 12; ++c) EXPECT_EQ(view.poses[12 * i + c], view.poses[12 * begin + c]);
            }
            for (int c = 0; c < 12; ++c) EXPECT_NEAR(view.poses[12 * begin + c], input.poses[24 + c], 1e-13);
            // Speeds of the first and the last step beside it are small against those in the middle of a segment.
            const auto speed = [&](uint32_t i) {
                double square = 0;
                for (int c = 0; c < 12; ++c) {
                    const double change = view.poses[12 * i + 12 + c] - view.poses[12 * i + c];
                    square += change * change;
                }
                return std::sqrt(square) / (view.times[i + 1] - view.times[i]);
            };
            EXPECT_LT(speed(begin - 1), 0.05 * speed(begin - 100));
            EXPECT_LT(speed(end), 0.05 * speed(end + 100));
            EXPECT_EQ(view.times[end], input.times[3]);
        }
    }
}

// Of all motions that stand still there: with the barycentre's path in closed form.
TEST(Motion, APauseIsLeftWithTheLeastEnergy) {
    MotionInput input = random_keys(3, 1, false);
    input.body = BodyInertia();
    std::copy_n(input.poses.begin(), 12, input.poses.begin() + 12);
    for (size_t i = 0; i < 3; ++i) input.times[i] = static_cast<double>(i);
    input.desc.position_count = 65;
    const auto motion = make(input);
    const FlgMotionView& view = motion->view();
    const Vec3 from = pose_at(&input.poses[12]).place, to = pose_at(&input.poses[24]).place;
    for (uint32_t i = view.key_positions[1]; i < 65; ++i) {
        const double t = view.times[i] - 1, share = (3 * t * t - t * t * t) / 2;  // clamped, then natural
        EXPECT_LT((pose_at(view.poses + 12 * i).place - (from + share * (to - from))).norm(), 1e-13);
    }
}

TEST(Motion, ABodyThatOnlyPausesStands) {
    MotionInput input = random_keys(2, 1, false);
    std::copy_n(input.poses.begin(), 12, input.poses.begin() + 12);
    input.desc.position_count = 9;
    for (const FlgMotionPacing pacing : {FLG_MOTION_PACING_KEYS, FLG_MOTION_PACING_BODY}) {
        input.desc.pacing = pacing;
        const auto motion = make(input);
        EXPECT_EQ(motion->view().ending, FLG_SPLINE_ENDING_CONVERGED);
        EXPECT_EQ(motion->view().greatest_speed, 0);
        EXPECT_EQ(motion->view().times[8], input.times[1]);
        for (uint32_t i = 0; i < 9; ++i) {
            for (int c = 0; c < 12; ++c) EXPECT_NEAR(motion->view().poses[12 * i + c], input.poses[c], 1e-14);
        }
    }
}

TEST(Motion, KeepsItsSpeed) {
    for (const FlgSplineEnergy energy : {FLG_SPLINE_ENERGY_E2, FLG_SPLINE_ENERGY_E1}) {
        for (const bool closed : {false, true}) {
            MotionInput input = random_keys(5, 1, closed);
            set_energy(input, energy);
            input.desc.position_count = 2000;
            input.desc.pacing = FLG_MOTION_PACING_PATH;
            const auto given = make(random_keys(5, 1, closed));
            const auto motion = make(input);
            const FlgMotionView& view = motion->view();
            const Vec3 middle(view.barycentre[0], view.barycentre[1], view.barycentre[2]);
            const uint32_t last = closed ? view.position_count : view.position_count - 1;
            EXPECT_NEAR(view.times[last], closed ? input.desc.end_time : input.times[4], 1e-12);
            const double speed = view.length / (view.times[last] - view.times[0]);
            for (uint32_t i = 0; i < last; ++i) {
                const Vec3 a = pose_at(view.poses + 12 * i).at(middle),
                           b = pose_at(view.poses + 12 * ((i + 1) % view.position_count)).at(middle);
                EXPECT_NEAR((b - a).norm() / (view.times[i + 1] - view.times[i]), speed, 2e-3 * speed) << i;
            }
            for (uint32_t k = 0; k < 5; ++k) {
                for (int c = 0; c < 12; ++c)
                    EXPECT_NEAR(view.poses[12 * view.key_positions[k] + c], input.poses[12 * k + c], 1e-13);
            }
            // A speed instead of a duration.
            input.desc.speed = 2;
            const auto faster = make(input);
            EXPECT_NEAR(faster->view().times[last] - faster->view().times[0], view.length / 2, 1e-4 * view.length);
        }
    }
}

TEST(Motion, TheBodysSpeedCountsItsTurns) {
    // Turns on the spot, then goes.
    MotionInput input = random_keys(3, 1, false);
    input.body = BodyInertia();
    for (size_t k = 0; k < 3; ++k) {
        const Mat3 rotation = turn(Vec3(0, 0, k > 0 ? 1 : 1e-9));
        const Vec3 place(k == 2 ? 2 : 0, 0, 0);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) input.poses[12 * k + 4 * row + column] = rotation(row, column);
            input.poses[12 * k + 4 * row + 3] = place[row];
        }
    }
    set_energy(input, FLG_SPLINE_ENERGY_E1);
    input.desc.pacing = FLG_MOTION_PACING_BODY;
    input.desc.speed = 1;
    input.desc.position_count = 400;
    const auto motion = make(input);
    const FlgMotionView& view = motion->view();
    // The six points of a ball of 1 m: two of them stay on the axis.
    EXPECT_NEAR(view.times[view.key_positions[1]] - view.times[0], std::sqrt(4.0 / 6), 1e-4);
    EXPECT_NEAR(view.times[399] - view.times[view.key_positions[1]], 2, 1e-4);
    input.desc.pacing = FLG_MOTION_PACING_PATH;
    try {
        make(input);
        ADD_FAILURE();
    } catch (const Failure& failure) {
        EXPECT_NE(std::string(failure.what()).find("keys[1] has its barycentre where the one before it has"),
                  std::string::npos)
            << failure.what();
    }
}

TEST(Motion, EasesKeepTimesOfKeysAndStop) {
    MotionInput input = random_keys(4, 1, false);
    input.eases = {0, 1, 1, 1, 0.5, 0.5, 1, 0};
    input.desc.position_count = 3 * 200 + 1;
    const auto motion = make(input);
    const FlgMotionView& view = motion->view();
    const auto plain = make([&] {
        MotionInput without = input;
        without.eases.clear();
        return without;
    }());
    const auto speed = [](const FlgMotionView& of, uint32_t i) {
        return (pose_at(of.poses + 12 * (i + 1)).place - pose_at(of.poses + 12 * i).place).norm() /
               (of.times[i + 1] - of.times[i]);
    };
    for (uint32_t k = 0; k < 4; ++k) {
        const uint32_t at = view.key_positions[k];
        EXPECT_EQ(view.times[at], input.times[k]);
        for (int c = 0; c < 12; ++c) EXPECT_NEAR(view.poses[12 * at + c], input.poses[12 * k + c], 1e-13);
    }
    const uint32_t second = view.key_positions[1], third = view.key_positions[2];
    EXPECT_LT(speed(view, 0), 0.03 * speed(plain->view(), 0));
    EXPECT_LT(speed(view, second - 1), 0.03 * speed(plain->view(), second - 1));
    EXPECT_LT(speed(view, second), 0.03 * speed(plain->view(), second));
    EXPECT_NEAR(speed(view, third), 0.5 * speed(plain->view(), third), 0.05 * speed(plain->view(), third));
}

TEST(Motion, LimitsSlowWhatIsTooFastAndKeepThePath) {
    for (const bool closed : {false, true}) {
        MotionInput input = random_keys(5, 1.5, closed);
        input.desc.position_count = 3000;
        const auto plain = make(input);
        input.desc.max_speed = 2;
        input.desc.max_turn = 1;
        input.desc.max_acceleration = 3;
        const auto motion = make(input), halting = make(input, true);
        const FlgMotionView& view = motion->view();
        EXPECT_GT(plain->view().greatest_speed, 3);
        EXPECT_GT(plain->view().greatest_turn, 1.2);
        EXPECT_LE(view.greatest_speed, 2 * 1.005);
        EXPECT_LE(view.greatest_turn, 1 * 1.005);
        EXPECT_LE(view.greatest_acceleration, 3 * 1.05);
        EXPECT_NEAR(view.length, plain->view().length, 1e-3 * view.length);
        EXPECT_GT(view.times[2999], plain->view().times[2999]);
        EXPECT_TRUE(std::equal(view.poses, view.poses + 12 * 3000, halting->view().poses));
        // Places of the slower motion are places of the other one.
        for (uint32_t i = 0; i < 3000; i += 50) {
            double nearest = 1e9;
            for (uint32_t j = 0; j < 3000; ++j) {
                nearest = std::min(
                    nearest, (pose_at(view.poses + 12 * i).place - pose_at(plain->view().poses + 12 * j).place).norm());
            }
            EXPECT_LT(nearest, 0.01);
        }
        for (uint32_t k = 0; k < 5; ++k) {
            for (int c = 0; c < 12; ++c)
                EXPECT_NEAR(view.poses[12 * view.key_positions[k] + c], input.poses[12 * k + c], 1e-13);
        }
    }
}

// In the angle to the target and the way upwards.
TEST(Motion, LooksAtAPointAndAtAnotherCurve) {
    MotionInput input = random_keys(5, 1.5, true);
    input.body = BodyInertia();
    input.look.kind = LookKind::target;
    input.look.up = Vec3(0, 0, 2);
    input.look.points = {9, 1, 2};
    const auto check = [&](const std::function<Vec3(double)>& target) {
        const auto motion = make(input);
        const FlgMotionView& view = motion->view();
        for (uint32_t i = 0; i < view.position_count; ++i) {
            const Pose pose = pose_at(view.poses + 12 * i);
            const Vec3 direction = (target(view.times[i]) - pose.place).normalized();
            EXPECT_LT((pose.rotation * -Vec3::UnitZ() - direction).norm(), 1e-12);
            EXPECT_GT((pose.rotation * Vec3::UnitY()).z(), 0);
            EXPECT_NEAR((pose.rotation * Vec3::UnitX()).z(), 0, 1e-12);
        }
        return motion;
    };
    const auto still = check([](double) { return Vec3(9, 1, 2); });
    EXPECT_EQ(still->view().rotation_energy, 0);
    input.look.points = {9, 1, 2, 19, 1, 2};
    input.look.times = {1, 3};
    check([](double time) { return Vec3(9 + 5 * std::clamp(time - 1, 0.0, 2.0), 1, 2); });
    input.look.times = {3, 1};
    try {
        make(input);
        ADD_FAILURE();
    } catch (const Failure& failure) {
        EXPECT_STREQ(failure.what(), "look_times[1] is 1 after 3; times must rise");
    }
}

// A circle at constant speed: the angle's tangent is v^2 / (r g).
TEST(Motion, LooksAheadAndLeansIntoCurves) {
    MotionInput input = random_keys(8, 0, true);
    input.body = BodyInertia();
    constexpr double radius = 20, period = 12;
    for (size_t k = 0; k < 8; ++k) {
        const double angle = 0.25 * 3.14159265358979323846 * static_cast<double>(k);
        input.times[k] = period / 8 * static_cast<double>(k);
        const Vec3 place(radius * std::cos(angle), radius * std::sin(angle), 0);
        for (int row = 0; row < 3; ++row) input.poses[12 * k + 4 * row + 3] = place[row];
    }
    input.desc.end_time = period;
    input.desc.position_count = 800;
    input.look.kind = LookKind::path;
    input.look.up = Vec3::UnitZ();
    input.look.bank = 1;
    const auto motion = make(input);
    const FlgMotionView& view = motion->view();
    const double speed = 2 * 3.14159265358979323846 * radius / period, tangent = speed * speed / radius / 9.80665;
    EXPECT_NEAR(std::tan(view.greatest_bank), tangent, 0.02 * tangent);
    for (uint32_t i = 0; i < 800; ++i) {
        const Pose pose = pose_at(view.poses + 12 * i);
        const Vec3 out = pose.place.normalized(), up = pose.rotation * Vec3::UnitY();
        EXPECT_NEAR(std::atan2(-up.dot(out), up.z()), std::atan(tangent), 0.03);
        EXPECT_GT((pose.rotation * -Vec3::UnitZ()).dot(Vec3::UnitZ().cross(out)), 0.999);
    }
}

// Everything at once, in another world.
TEST(Motion, LooksAndLawsAreEquivariant) {
    MotionInput input = random_keys(5, 1, false);
    input.look.kind = LookKind::target;
    input.look.points = {9, 1, 2, 3, -8, 1};
    input.look.bank = 0.5;
    input.desc.pacing = FLG_MOTION_PACING_PATH;
    input.desc.max_acceleration = 2;
    input.eases = {0, 0, 0.5, 0.5, 0, 0, 0, 0, 0, 0};
    const Pose space{turn(Vec3(1, -2, 0.5)), Vec3(5, 6, -7)};
    MotionInput moved = input;
    moved.look.up = space.rotation * input.look.up;
    for (size_t i = 0; i < 2; ++i) {
        const Vec3 point =
            space.at(Vec3(input.look.points[3 * i], input.look.points[3 * i + 1], input.look.points[3 * i + 2]));
        std::copy_n(point.data(), 3, &moved.look.points[3 * i]);
    }
    for (size_t i = 0; i < 5; ++i) {
        const Pose pose = pose_at(&input.poses[12 * i]);
        const Mat3 rotation = space.rotation * pose.rotation;
        const Vec3 place = space.at(pose.place);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) moved.poses[12 * i + 4 * row + column] = rotation(row, column);
            moved.poses[12 * i + 4 * row + 3] = place[row];
        }
    }
    const auto first = make(input), second = make(moved);
    for (uint32_t i = 0; i < input.desc.position_count; ++i) {
        EXPECT_NEAR(first->view().times[i], second->view().times[i], 1e-8);
        const Pose a = pose_at(first->view().poses + 12 * i), b = pose_at(second->view().poses + 12 * i);
        EXPECT_LT((space.rotation * a.rotation - b.rotation).norm(), 1e-6);
        EXPECT_LT((space.at(a.place) - b.place).norm(), 1e-6);
    }
}

TEST(Motion, ACameraKeepsItsNearPlaneOutOfObstaclesAndLooks) {
    MotionInput input = random_keys(2, 0, false);
    input.body = BodyInertia();
    input.desc.position_count = 200;
    for (int row = 0; row < 3; ++row) {
        input.poses[4 * row + 3] = row == 0 ? -4 : 0.1;
        input.poses[12 + 4 * row + 3] = row == 0 ? 4 : 0.1;
    }
    const auto held = std::make_shared<Obstacles>(3u, nan_memory());
    const double centre[3] = {0, 0, 0};
    held->solids.push_back(std::make_shared<BallObstacle>(3, centre, 1.0));
    const Obstacle* const solid = held->solids[0].get();
    held->clearance = 0.1;
    held->set.emplace(std::span(&solid, 1), held->clearance, nan_memory());
    input.obstacles = held;
    input.desc.clearance = 0.3;
    input.look.kind = LookKind::target;
    input.look.points = {0, 0, 0};
    input.look.up = Vec3::UnitZ();
    const auto motion = make(input);
    double least = 1e9;
    for (uint32_t i = 0; i < 200; ++i) {
        const Pose pose = pose_at(motion->view().poses + 12 * i);
        least = std::min(least, pose.place.norm());
        EXPECT_LT((pose.rotation * Vec3::UnitZ() - pose.place.normalized()).norm(), 1e-12);
    }
    EXPECT_GT(least, 1.4 - 1e-4);
    EXPECT_LT(least, 1.45);
    // A pause beside the obstacle.
    input = random_keys(4, 0, false);
    input.body = BodyInertia();
    const double places[4][3] = {{-4, 0.1, 0.1}, {0, 1.6, 0}, {0, 1.6, 0}, {4, 0.1, 0.1}};
    for (size_t k = 0; k < 4; ++k) {
        for (size_t row = 0; row < 3; ++row) input.poses[12 * k + 4 * row + 3] = places[k][row];
    }
    input.obstacles = held;
    const auto pausing = make(input);
    const FlgMotionView& view = pausing->view();
    EXPECT_EQ(view.poses[12 * view.key_positions[1] + 7], view.poses[12 * view.key_positions[2] + 7]);
    const uint32_t at = view.key_positions[1];
    EXPECT_LT((pose_at(view.poses + 12 * at).place - pose_at(view.poses + 12 * (at - 1)).place).norm(), 0.02);
}

// Fig. 11: a measured motion that trembles is smooth after a few rounds, however long it is.
TEST(Motion, AFewRoundsFairAMeasuredMotion) {
    for (const size_t count : {100u, 1000u, 4000u}) {
        MotionInput input = random_keys(count, 0, false);
        std::mt19937 random(7);
        std::normal_distribution<double> noise(0, 0.01);
        for (size_t i = 0; i < count; ++i) {
            const double t = 0.05 * static_cast<double>(i);
            input.times[i] = t;
            const Mat3 rotation =
                turn(Vec3(0.2 * std::sin(t), t, 0.3 * std::cos(0.7 * t)) + Vec3(1, 1, 1) * noise(random));
            const Vec3 place(3 * std::sin(t) + noise(random), std::cos(0.5 * t) + noise(random), t + noise(random));
            for (int row = 0; row < 3; ++row) {
                for (int column = 0; column < 3; ++column)
                    input.poses[12 * i + 4 * row + column] = rotation(row, column);
                input.poses[12 * i + 4 * row + 3] = place[row];
            }
        }
        input.desc.position_count = static_cast<uint32_t>(count);
        input.desc.smoothing = 1e-3;
        const auto motion = make(input);
        EXPECT_EQ(motion->view().ending, FLG_SPLINE_ENDING_CONVERGED);
        EXPECT_LE(motion->view().rounds, 4u);
        double off = 0, rough = 0, smooth = 0;
        const auto bend = [](const double* poses, size_t i) {
            return (pose_at(poses + 12 * (i + 1)).place - 2 * pose_at(poses + 12 * i).place +
                    pose_at(poses + 12 * (i - 1)).place)
                .squaredNorm();
        };
        for (size_t i = 1; i + 1 < count; ++i) {
            off = std::max(off,
                           (pose_at(motion->view().poses + 12 * i).place - pose_at(&input.poses[12 * i]).place).norm());
            rough += bend(input.poses.data(), i);
            smooth += bend(motion->view().poses, i);
        }
        EXPECT_LT(off, 0.06);
        EXPECT_LT(smooth, 0.05 * rough);
    }
}

// Counts what is given back: that takes as long as it is large.
class CountingMemory final : public Memory {
public:
    size_t given_back = 0;

private:
    void* do_allocate(size_t bytes, size_t alignment) override {
        return std::pmr::new_delete_resource()->allocate(bytes, alignment);
    }
    void do_deallocate(void* block, size_t bytes, size_t alignment) override {
        given_back += bytes;
        std::pmr::new_delete_resource()->deallocate(block, bytes, alignment);
    }
    bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
};

// A motion's memory is 4 kB a position while it is made; no slice gives more than a few numbers of each back.
TEST(Motion, NoSliceGivesMuchMemoryBack) {
    for (const FlgSplineEnergy energy : all_energies) {
        MotionInput input = random_keys(600, 0.5, false);
        set_energy(input, energy);
        input.desc.position_count = 32 * 600;
        input.desc.max_speed = 3;
        CountingMemory memory;
        size_t most = 0, all = 0;
        const auto motion = std::make_shared<Motion>(input, &memory);
        run_haltingly(
            &memory, [&](Pace& pace) { return make_motion(pace, motion); },
            [&](const auto& slice) {
                const size_t before = memory.given_back;
                slice();
                most = std::max(most, memory.given_back - before);
                all = memory.given_back;
            });
        EXPECT_GT(all, size_t{2000} * input.desc.position_count);
        EXPECT_LT(most, size_t{320} * input.desc.position_count);
    }
}

TEST(Motion, SameBitsWhereverItPauses) {
    const MotionInput input = random_keys(6, 2, true);
    const auto whole = make(input), halting = make(input, true);
    EXPECT_TRUE(
        std::equal(whole->view().poses, whole->view().poses + 12 * input.desc.position_count, halting->view().poses));
    EXPECT_EQ(whole->view().energy, halting->view().energy);
    for (const FlgSplineEnergy energy : all_energies) {
        MotionInput paused = with_pause(energy, true);
        paused.desc.pacing = FLG_MOTION_PACING_BODY;
        paused.look.kind = LookKind::path;
        paused.look.bank = 1;
        const auto a = make(paused), b = make(paused, true);
        EXPECT_TRUE(std::equal(a->view().poses, a->view().poses + 12 * paused.desc.position_count, b->view().poses));
    }
}

}  // namespace
}  // namespace flg::test
