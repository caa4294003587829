// SPDX-License-Identifier: MIT
#include "splines/cable.h"

#include <memory>

#include "core/failure.h"
#include "reference/literal_cable.h"
#include "splines/catenary.h"
#include "splines/obstacle_checks.h"
#include "splines/obstacles/obstacle_mesh.h"
#include "splines/obstacles/obstacle_shapes.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

using Places = std::vector<Vec3>;

const Vec3 downwards(0, 0, -1);

struct Hung {
    Places places;
    std::vector<double> lengths;
    uint32_t rounds = 0;
};

Hung hang(const ObstacleSet* set, const Vec3& from, const Vec3& to, double length, uint32_t segments, double size = 10,
          const Vec3& down = downwards) {
    const HungCable hung =
        run_now(heap(), [&](Pace& pace) { return hang_cable(pace, set, from, to, length, segments, down, size, 0); });
    return {Places(hung.places.begin(), hung.places.end()), {hung.lengths.begin(), hung.lengths.end()}, hung.rounds};
}

// Each segment is as long as the lengths along the cable say, and these go from 0 to all of it.
void expect_lengths(const Hung& hung, double length) {
    EXPECT_EQ(hung.lengths.front(), 0);
    EXPECT_DOUBLE_EQ(hung.lengths.back(), length);
    const double even = length / static_cast<double>(hung.places.size() - 1);
    for (size_t i = 0; i + 1 < hung.places.size(); ++i) {
        const double own = hung.lengths[i + 1] - hung.lengths[i];
        EXPECT_GT(own, 0);
        EXPECT_NEAR((hung.places[i + 1] - hung.places[i]).norm(), own, 2e-8 * even) << i;
    }
}

// The potential energy over the weight of a metre.
double energy_of(const Places& places) {
    double sum = 0;
    for (size_t i = 0; i + 1 < places.size(); ++i)
        sum += 0.5 * (places[i].z() + places[i + 1].z()) * (places[i + 1] - places[i]).norm();
    return sum;
}

double catenary_energy(const Vec3& from, const Vec3& to, double length) {
    const Catenary catenary(from, to, length, downwards);
    Places places;
    for (int i = 0; i <= 1000; ++i) places.push_back(catenary.place(length * i / 1000));
    return energy_of(places);
}

// The least energy of a cable over two edges, `left` and `right`, with a catenary to either side: by a golden section
// over how much hangs to the left, from where what hangs to the right is tight.
double energy_over(const Vec3& from, const Vec3& left, const Vec3& right, const Vec3& to, double length) {
    const double over = (right - left).norm(), least = (left - from).norm() * (1 + 1e-6),
                 most = length - over - (to - right).norm() * (1 + 1e-6);
    const auto energy = [&](double own) {
        return catenary_energy(from, left, own) + catenary_energy(right, to, length - over - own) + over * left.z();
    };
    double low = least, high = most;
    const double golden = 0.5 * (std::sqrt(5.0) - 1);
    for (int round = 0; round < 40; ++round) {
        const double a = high - golden * (high - low), b = low + golden * (high - low);
        (energy(a) < energy(b) ? high : low) = energy(a) < energy(b) ? b : a;
    }
    return energy(0.5 * (low + high));
}

// By 200 places of each segment.
double deepest(const ObstacleSet& set, const Places& places) {
    double least = 1e9;
    for (size_t i = 0; i + 1 < places.size(); ++i) {
        for (int s = 0; s <= 200; ++s) {
            const Vec3 x = places[i] + s / 200.0 * (places[i + 1] - places[i]);
            least = std::min(least, set.distance(x.data()));
        }
    }
    return -least;
}

// Solids that live as long as their set.
struct Scene {
    template <class Solid, class... Arguments>
    Scene& add(const Arguments&... arguments) {
        solids.push_back(std::make_unique<Solid>(3, arguments...));
        return *this;
    }
    ObstacleSet set(double clearance = 0) const {
        std::vector<const Obstacle*> all;
        for (const auto& solid : solids) all.push_back(solid.get());
        return ObstacleSet(all, clearance, heap());
    }
    std::vector<std::unique_ptr<Obstacle>> solids;
};

const double origin[3] = {0, 0, 0}, upwards[3] = {0, 0, 1};

TEST(Catenary, HasTheSagOfItsEquation) {
    // a cosh(x / a) from -2 to 2 with a = 1.5 is 2 a sinh(2 / a) long.
    const double a = 1.5, length = 2 * a * std::sinh(2 / a);
    const Catenary catenary({-2, 0, 1}, {2, 0, 1}, length, downwards);
    const double sag = a * std::cosh(2 / a) - a;
    EXPECT_NEAR(catenary.place(0.5 * length).z(), 1 - sag, 1e-12);
    EXPECT_NEAR(catenary.tension(), a * std::cosh(2 / a), 1e-12);
    for (int i = 0; i <= 40; ++i) {
        const Vec3 x = catenary.place(length * i / 40);
        EXPECT_NEAR(x.z(), 1 - sag + a * std::cosh(x.x() / a) - a, 1e-12);
        EXPECT_NEAR(a * std::sinh(x.x() / a), length * i / 40 - 0.5 * length, 1e-12);
    }
}

// Steep, nearly taut, far too long, straight down; and to all of them the ends and the lengths belong.
TEST(Catenary, ReachesBothEndsWhateverItsLength) {
    const Vec3 from(0.3, -1, 2);
    for (const Vec3& to : {Vec3(4, 2, 1), Vec3(0.3, -1, 5), Vec3(0.3 + 1e-9, -1, -3), Vec3(0.31, -1, 9)}) {
        for (const double slack : {1e-12, 1e-8, 1e-5, 1e-2, 0.5, 3.0, 900.0}) {
            const double length = (to - from).norm() * (1 + slack);
            const Catenary catenary(from, to, length, downwards);
            EXPECT_LT((catenary.place(0) - from).norm(), 1e-12 * length);
            EXPECT_LT((catenary.place(length) - to).norm(), 1e-8 * length) << slack;
            double chords = 0;
            Vec3 before = from;
            for (int i = 1; i <= 4000; ++i) {
                const Vec3 x = catenary.place(length * i / 4000);
                chords += (x - before).norm();
                before = x;
            }
            EXPECT_NEAR(chords, length, 1e-3 * length) << slack;
        }
    }
}

TEST(Cable, ThatTouchesNothingIsACatenary) {
    const Scene scene = std::move(Scene().add<HalfSpaceObstacle>(origin, upwards));
    const ObstacleSet set = scene.set();
    const Hung hung = hang(&set, {0, 0, 3}, {4, 0, 3}, 4.5, 64);
    EXPECT_EQ(hung.rounds, 0u);
    const Catenary catenary({0, 0, 3}, {4, 0, 3}, 4.5, downwards);
    for (uint32_t i = 0; i <= 64; ++i) EXPECT_LT((hung.places[i] - catenary.place(4.5 * i / 64)).norm(), 1e-12);
}

// What the solver makes of a cable that just touches the ground is the catenary that it would be.
TEST(Cable, TheSolverFindsTheCatenary) {
    const Catenary catenary({0, 0, 3}, {4, 0, 3}, 5, downwards);
    const double lowest[3] = {0, 0, catenary.place(2.5).z() + 1e-5};
    const Scene scene = std::move(Scene().add<HalfSpaceObstacle>(lowest, upwards));
    const ObstacleSet set = scene.set();
    const Hung hung = hang(&set, {0, 0, 3}, {4, 0, 3}, 5, 128);
    EXPECT_GT(hung.rounds, 0u);
    expect_lengths(hung, 5);
    EXPECT_LE(deepest(set, hung.places), 1e-5);
    double farthest = 0;
    for (uint32_t i = 0; i <= 128; ++i)
        farthest = std::max(farthest, (hung.places[i] - catenary.place(5.0 * i / 128)).norm());
    EXPECT_LT(farthest, 1e-3);
}

// On the floor in between it is straight; to either side it is a piece of a catenary that leaves the floor level: with
// the pull a it rises by sqrt(a^2 + s^2) - a over s metres of cable.
TEST(Cable, RestsOnTheFloor) {
    const Scene scene = std::move(Scene().add<HalfSpaceObstacle>(origin, upwards));
    const ObstacleSet set = scene.set();
    const double high = 1, length = 7;
    const Hung hung = hang(&set, {-3, 0, high}, {3, 0, high}, length, 256);
    expect_lengths(hung, length);
    EXPECT_LE(deepest(set, hung.places), 1e-5);
    // high = sqrt(a^2 + s^2) - a; 3 = a asinh(s / a) + length / 2 - s.
    double low = 1e-3, most = 100;
    for (int round = 0; round < 200; ++round) {
        const double a = std::sqrt(low * most), s = std::sqrt(high * high + 2 * a * high);
        (a * std::asinh(s / a) + 0.5 * length - s < 3 ? low : most) = a;
    }
    const double s = std::sqrt(high * high + 2 * low * high);
    for (uint32_t i = 0; i <= 128; ++i) {
        const double along = length * i / 256, left = std::max(s - along, 0.0);
        EXPECT_NEAR(hung.places[i].z(), std::sqrt(low * low + left * left) - low, 1e-3) << i;
        EXPECT_NEAR(hung.places[i].y(), 0, 1e-6);
    }
}

// Over a log that lies across: as high as the log, and both sides alike.
TEST(Cable, RestsOnALogABoxAndABall) {
    const double a[3] = {0, -2, 0.5}, b[3] = {0, 2, 0.5};
    Scene log;
    log.add<CapsuleObstacle>(a, b, 0.5);
    const ObstacleSet set = log.set();
    const Hung hung = hang(&set, {-3, 0, 0.6}, {3, 0, 0.6}, 6.6, 65);
    expect_lengths(hung, 6.6);
    EXPECT_LE(deepest(set, hung.places), 1e-5);
    for (size_t i = 0; i <= 65; ++i) {
        EXPECT_NEAR(hung.places[i].x(), -hung.places[65 - i].x(), 1e-5);
        EXPECT_NEAR(hung.places[i].z(), hung.places[65 - i].z(), 1e-5);
    }
    EXPECT_NEAR(0.5 * (hung.places[32].z() + hung.places[33].z()), 1, 1e-3);

    const double centre[3] = {0.4, 0, 0.5}, half[3] = {0.6, 2, 0.5};
    Scene box;
    box.add<BoxObstacle>(centre, half, nullptr);
    const ObstacleSet boxes = box.set(0.02);
    const Hung over = hang(&boxes, {-3, 0, 1.1}, {3, 0.2, 1.5}, 6.8, 64);
    expect_lengths(over, 6.8);
    EXPECT_LE(deepest(boxes, over.places), 1e-5);
}

// The literal one, with the same number of segments: neither is lower than the other by more than it is off, and both
// lie in one place.
TEST(Cable, IsWhatFallingBeadsComeTo) {
    const double a[3] = {0.5, -2, 0.3}, b[3] = {0.5, 2, 0.3}, centre[3] = {-1.2, 0, 0.2}, half[3] = {0.4, 1, 0.2};
    Scene scene;
    scene.add<HalfSpaceObstacle>(origin, upwards).add<CapsuleObstacle>(a, b, 0.5);
    scene.add<BoxObstacle>(centre, half, nullptr);
    const ObstacleSet set = scene.set();
    const Vec3 from(-2.5, 0, 1.2), to(2.5, 0, 1);
    const double length = 5.9;
    const uint32_t segments = 40;
    const Hung hung = hang(&set, from, to, length, segments);
    const Places literal = reference::literal_cable(&set, from, to, length, segments, downwards, 3000);
    EXPECT_NEAR(reference::mean_height(hung.places, downwards), reference::mean_height(literal, downwards), 5e-3);
    double farthest = 0;
    for (uint32_t i = 0; i <= segments; ++i) farthest = std::max(farthest, (hung.places[i] - literal[i]).norm());
    EXPECT_LT(farthest, 0.06);
    EXPECT_LE(deepest(set, hung.places), 1e-5);
    expect_lengths(hung, length);
}

TEST(Cable, GoesOverWhatBlocksTheStraightWay) {
    const double centre[3] = {0, 0, 0.5}, half[3] = {0.3, 3, 1.5};
    Scene scene;
    scene.add<HalfSpaceObstacle>(origin, upwards).add<BoxObstacle>(centre, half, nullptr);
    const ObstacleSet set = scene.set();
    const Hung hung = hang(&set, {-2, 0, 1}, {2, 0.3, 1.2}, 5.5, 64);
    expect_lengths(hung, 5.5);
    EXPECT_LE(deepest(set, hung.places), 1e-5);
    double highest = 0;
    for (const Vec3& x : hung.places) highest = std::max(highest, x.z());
    EXPECT_NEAR(highest, 2, 1e-3);
    try {
        hang(&set, {-2, 0, 1}, {2, 0.3, 1.2}, 4.1, 64);
        ADD_FAILURE() << "it is too short";
    } catch (const Failure& failure) {
        EXPECT_NE(std::string(failure.what()).find("too short for the shortest way"), std::string::npos)
            << failure.what();
    }
}

// Links would catch on the fence's edges (5.99 and 6.13 in place of 5.61 and 5.92 m^2): the cable slides to where its
// energy is least, which is known in closed form but for one number.
TEST(Cable, SlidesOverAFence) {
    const double centre[3] = {0.8, 0, 1}, half[3] = {0.03, 3, 1};
    Scene scene;
    scene.add<BoxObstacle>(centre, half, nullptr).add<HalfSpaceObstacle>(origin, upwards);
    const ObstacleSet set = scene.set();
    const Vec3 from(-2, 0, 1), to(2, 0, 1.2), left(0.77, 0, 2), right(0.83, 0, 2);
    const double straight = (left - from).norm() + 0.06 + (to - right).norm();
    for (const double slack : {0.1, 0.2}) {
        for (const uint32_t segments : {24u, 64u, 200u}) {
            const double length = straight * (1 + slack);
            const Hung hung = hang(&set, from, to, length, segments);
            expect_lengths(hung, length);
            EXPECT_LE(deepest(set, hung.places), 1e-5);
            const double least = energy_over(from, left, right, to, length);
            EXPECT_NEAR(energy_of(hung.places), least, 0.6 * length / (segments * segments) + 3e-4)
                << slack << " " << segments;
        }
    }
}

// Over a thin rail in the middle the shape is the same to both sides, but it would fall to either: it does.
TEST(Cable, FallsFromASaddle) {
    const double a[3] = {0, -2, 1.99}, b[3] = {0, 2, 1.99};
    const Scene scene = std::move(Scene().add<CapsuleObstacle>(a, b, 0.01));
    const ObstacleSet set = scene.set();
    const Vec3 from(-2, 0, 2.05), to(2, 0, 2.05), top(0, 0, 2);
    const double length = 6, even = 2 * catenary_energy(from, top, 3);
    const Hung hung = hang(&set, from, to, length, 64);
    expect_lengths(hung, length);
    EXPECT_LE(deepest(set, hung.places), 1e-5);
    double least = even;
    for (double own = 2.02; own < 3; own += 0.02)
        least = std::min(least, catenary_energy(from, top, own) + catenary_energy(top, to, length - own));
    EXPECT_LT(least, even - 0.1);
    EXPECT_NEAR(energy_of(hung.places), least, 0.03);
}

// What is far away, or too far for the cable, is nothing to it.
TEST(Cable, FindsTheWayWhateverIsFarAway) {
    const double centre[3] = {0, 0, 1}, half[3] = {0.03, 3, 1}, far[3] = {300, 0, 0}, wide[3] = {1, 1, 1};
    const double from_far[3] = {-500, 2.8, 0}, to_far[3] = {500, 2.8, 0};
    Scene near, all;
    near.add<BoxObstacle>(centre, half, nullptr);
    all.add<BoxObstacle>(centre, half, nullptr).add<BoxObstacle>(far, wide, nullptr);
    all.add<CapsuleObstacle>(from_far, to_far, 0.01);
    const ObstacleSet nearby = near.set(), both = all.set();
    const Vec3 from(-2, 0, 1), to(2, 0, 1.2);
    const Hung alone = hang(&nearby, from, to, 5, 64), hung = hang(&both, from, to, 5, 64);
    double highest = 0;
    for (const Vec3& x : hung.places) highest = std::max(highest, x.z());
    EXPECT_NEAR(highest, 2, 1e-3);
    EXPECT_NEAR(energy_of(hung.places), energy_of(alone.places), 1e-4);
}

// Nearly straight down and up again: a bend that lay between two points would be cut off, and half a segment or more of
// the cable with it.
TEST(Cable, ASteepFoldHasItsLength) {
    for (const double aside : {0.0, 0.001, 0.03, 0.1}) {
        for (const double length : {3.0, 3.02, 3.05}) {
            const Hung hung = hang(nullptr, {0, 0, 3}, {aside, 0, 2.5}, length, 64);
            double chords = 0;
            for (size_t i = 0; i < 64; ++i) chords += (hung.places[i + 1] - hung.places[i]).norm();
            EXPECT_LE(chords, length * (1 + 1e-12));
            EXPECT_GT(chords, length * (1 - 0.16 / 64)) << aside << " " << length;
        }
    }
}

// A ring of knobs and dents, at many numbers of segments.
TEST(Cable, RestsOnAKnobblyMesh) {
    Soup soup = torus(96, 48);
    for (Position& p : soup.positions) {
        const Vec3 x = load_vec3(p.data());
        const double around = std::atan2(x.y(), x.x());
        const Vec3 ring(std::cos(around), std::sin(around), 0), out = x - ring;
        const double knob = 0.15 * std::sin(7 * around) * std::cos(7 * std::atan2(out.z(), out.dot(ring)));
        p = to_position(ring + (1 + knob) * out);
    }
    const Mesh mesh = make_mesh(soup);
    const SampledDistance distance =
        run_now(heap(), [&](Pace& pace) { return mesh_distance(pace, mesh, 0.4, 64, true); });
    const MeshObstacle knobs(distance, run_now(heap(), [&](Pace& pace) { return triangle_solid(pace, mesh); }));
    const Obstacle* const all[] = {&knobs};
    const ObstacleSet set(all, 0, heap());
    for (const double aside : {0.0, 0.7}) {
        const Vec3 from(-2.5, aside, 0.9), to(2.5, aside - 0.3, 0.7);
        const double length = 1.1 * (to - from).norm();
        double energies[4];
        uint32_t k = 0;
        for (const uint32_t segments : {16u, 24u, 40u, 64u}) {
            const Hung hung = hang(&set, from, to, length, segments, 5);
            expect_lengths(hung, length);
            EXPECT_GT(hung.rounds, 0u);
            for (size_t i = 0; i + 1 < hung.places.size(); ++i)
                EXPECT_EQ(knobs.meets(hung.places[i].data(), hung.places[i + 1].data()), Obstacle::Meets::no) << i;
            energies[k++] = energy_of(hung.places);
        }
        // However fine, it is one cable.
        for (uint32_t i = 0; i < 3; ++i) EXPECT_NEAR(energies[i], energies[3], 0.02 * length) << aside << " " << i;
    }
}

// Far too long for the floor: what is too much lies there, and has its length.
TEST(Cable, TooMuchLiesInFolds) {
    const Scene scene = std::move(Scene().add<HalfSpaceObstacle>(origin, upwards));
    const ObstacleSet set = scene.set();
    const Hung hung = hang(&set, {-1, 0, 0.5}, {1, 0, 0.5}, 4, 80);
    expect_lengths(hung, 4);
    EXPECT_LE(deepest(set, hung.places), 1e-5);
    EXPECT_NEAR(hung.places[40].z(), 0, 1e-2);
}

TEST(Cable, RandomScenesAreNeverEntered) {
    uint32_t resting = 0;
    for (uint64_t k = 0; k < 40; ++k) {
        Scene scene;
        scene.add<HalfSpaceObstacle>(origin, upwards);
        for (uint64_t i = 0; i < 5; ++i) {
            const Numbers x = random_numbers(100 * k + 2 * i, 2), y = random_numbers(100 * k + 2 * i + 1, 1);
            const double at[3] = {x[0], 0.5 * x[1], 0.3 + 0.1 * std::abs(x[2])};
            const double ends[2][3] = {{at[0], -3, at[2]}, {at[0] + 0.3 * y[0], 3, at[2]}};
            const double half[3] = {0.1 + 0.2 * std::abs(y[1]), 2, 0.2 + 0.2 * std::abs(y[2])};
            if (i % 2 == 0) {
                scene.add<CapsuleObstacle>(ends[0], ends[1], 0.1 + 0.2 * std::abs(y[1]));
            } else {
                scene.add<BoxObstacle>(at, half, nullptr);
            }
        }
        const ObstacleSet set = scene.set();
        const Vec3 from(-3, 0, 1.2), to(3, 0.5, 1.4);
        const double length = 6.1 + 0.05 * static_cast<double>(k % 10);
        Hung hung;
        try {
            hung = hang(&set, from, to, length, 64);
        } catch (const Failure& failure) {
            ADD_FAILURE() << k << ": " << failure.what();
            continue;
        }
        resting += hung.rounds > 0;
        if (hung.rounds > 0) expect_lengths(hung, length);
        EXPECT_LE(deepest(set, hung.places), 1e-5) << k;
        EXPECT_EQ(hung.places.front(), from);
        EXPECT_EQ(hung.places.back(), to);
    }
    EXPECT_GT(resting, 20u);
}

}  // namespace
}  // namespace flg::test
