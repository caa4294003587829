// SPDX-License-Identifier: MIT
#include "pulling/pulling.h"

#include <gtest/gtest.h>

#include <cstring>

#include "reference/literal_arap.h"
#include "solids/solid_meshes.h"

namespace flg::test {
namespace {

struct Pulled {
    explicit Pulled(const Triangles& from) : triangles(from), repaired(from) {
        system = run_now(test_memory(), [&](Pace& pace) { return make_pull_system(pace, repaired.mesh()); });
        for (uint32_t v = 0; v < repaired.mesh().vertex_count(); ++v)
            for (int k = 0; k < 3; ++k) rest.push_back(repaired.mesh().positions[v][k]);
    }
    uint32_t count() const { return repaired.mesh().vertex_count(); }
    Vec3 at_rest(uint32_t v) const { return load_vec3(rest.data() + size_t{3} * v); }
    uint32_t nearest(const Vec3& at) const {
        uint32_t best = 0;
        for (uint32_t v = 0; v < count(); ++v)
            if ((at_rest(v) - at).norm() < (at_rest(best) - at).norm()) best = v;
        return best;
    }
    PullHandle handle(const Vec3& near, const Vec3& by = Vec3::Zero()) const {
        const uint32_t v = nearest(near);
        return {{v, v, v}, {1, 0, 0}, at_rest(v) + by, 0};
    }
    void pull_once(const std::vector<PullHandle>& handles, uint32_t rounds, bool haltingly = false) {
        auto next = std::make_unique<PulledState>(test_memory());
        run_now(
            test_memory(), [&](Pace& pace) { return pull(pace, system, rest, handles, state.get(), rounds, *next); },
            haltingly);
        state = std::move(next);
    }
    Vec3 at(uint32_t v) const {
        const double* moved = state->moved.data() + size_t{4} * system.place_of[v];
        return at_rest(v) + Vec3(moved[0], moved[1], moved[2]);
    }

    Triangles triangles;
    RepairedTriangles repaired;
    PullSystem system;
    std::vector<float> rest;
    std::unique_ptr<PulledState> state;
};

Triangles bar() {
    Triangles t;
    t.add_tube({0, 0, 0}, 0.2, {0, 2, 0}, 0.2, 12, 20);
    return t;
}

const std::vector<Vec3> corners = {{0.2, 0, 0}, {-0.1, 0, 0.17}, {0.2, 2, 0}, {0, 2.2, 0}};

TEST(Pulling, WithoutHandlesNothingMoves) {
    Pulled bar_(bar());
    bar_.pull_once({}, 3);
    for (uint32_t v = 0; v < bar_.count(); ++v) EXPECT_EQ(bar_.at(v), bar_.at_rest(v));
}

TEST(Pulling, OneHandleMovesAll) {
    Pulled p(bar());
    const Vec3 by(0.3, -0.2, 0.7);
    p.pull_once({p.handle({0, 2.2, 0}, by)}, 2);
    for (uint32_t v = 0; v < p.count(); ++v) EXPECT_LT((p.at(v) - p.at_rest(v) - by).norm(), 1e-6);
    EXPECT_LT(p.state->energy, 1e-10);
}

TEST(Pulling, HandlesThatMoveRigidlyMoveAllSo) {
    Pulled p(bar());
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.8, Vec3(1, 0.4, 0.2).normalized()).toRotationMatrix();
    const Vec3 by(0.5, 1, -2);
    std::vector<PullHandle> handles;
    for (const Vec3& corner : corners) {
        handles.push_back(p.handle(corner));
        handles.back().at = turn * handles.back().at + by;
    }
    p.pull_once(handles, 1);
    for (uint32_t v = 0; v < p.count(); ++v) EXPECT_LT((p.at(v) - turn * p.at_rest(v) - by).norm(), 1e-6);
    EXPECT_LT(p.state->energy, 1e-10);
}

TEST(Pulling, HandlesAreMet) {
    Pulled p(bar());
    std::vector<PullHandle> handles = {p.handle({0, -0.2, 0}), p.handle({0, 2.2, 0}, {0.7, -0.4, 0.1})};
    // Within a triangle.
    const Triple& corner = p.repaired.mesh().triangles[200];
    PullHandle within;
    within.vertices = corner;
    within.shares = {0.2, 0.3, 0.5};
    within.at = Vec3(0.05, 0, 0);
    for (int c = 0; c < 3; ++c) within.at += within.shares[c] * p.at_rest(corner[c]);
    handles.push_back(within);
    p.pull_once(handles, 3);
    for (const PullHandle& handle : handles) {
        Vec3 at = Vec3::Zero();
        for (int c = 0; c < 3; ++c) at += handle.shares[c] * p.at(handle.vertices[c]);
        EXPECT_LT((at - handle.at).norm(), 1e-8);
    }
}

// The largest share by which an edge of the surface is longer than at rest.
double largest_stretch(const Pulled& p) {
    double largest = 0;
    for (uint32_t t = 0; t < p.repaired.mesh().triangle_count(); ++t) {
        const Triple& triangle = p.repaired.mesh().triangles[t];
        for (int k = 0; k < 3; ++k) {
            const uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
            largest = std::max(largest, (p.at(a) - p.at(b)).norm() / (p.at_rest(a) - p.at_rest(b)).norm() - 1);
        }
    }
    return largest;
}

// A side of a bar pulled out by twice its width, its ends held.
double stretch_of_hard_pull(uint32_t around, double radius) {
    Triangles t;
    t.add_tube({0, 0, 0}, 0.2, {0, 2, 0}, 0.2, around, 2 * around);
    Pulled p(t);
    std::vector<PullHandle> handles = {p.handle({0.2, 0, 0}), p.handle({-0.2, 0, 0}), p.handle({0.2, 2, 0}),
                                       p.handle({-0.2, 2, 0}), p.handle({0.2, 1, 0}, {0.8, 0, 0})};
    for (PullHandle& handle : handles) handle.radius = radius;
    p.pull_once(handles, 60);
    for (const PullHandle& handle : handles) EXPECT_LT((p.at(handle.vertices[0]) - handle.at).norm(), 1e-7);
    return largest_stretch(p);
}

TEST(Pulling, HardPullsMakeNoSpike) {
    // At one vertex, the finer the mesh the longer the spike; a patch holds the surface, whatever its triangles.
    const double coarse_spike = stretch_of_hard_pull(24, 0), spike = stretch_of_hard_pull(48, 0);
    EXPECT_GT(spike, 1.5 * coarse_spike);
    const double coarse = stretch_of_hard_pull(24, 0.15), fine = stretch_of_hard_pull(48, 0.15);
    EXPECT_NEAR(fine, coarse, 0.15 * coarse);
    EXPECT_LT(fine, 0.35 * spike);
    EXPECT_LT(stretch_of_hard_pull(48, -1), 0.45 * spike);
}

TEST(Pulling, PatchesSettle) {
    Pulled p(bar());
    std::vector<PullHandle> handles = {p.handle({0.2, 0, 0}), p.handle({-0.2, 0, 0}), p.handle({0, 0, 0.2}),
                                       p.handle({0, 2.2, 0}, {0.2, 0, 0})};
    for (PullHandle& handle : handles) handle.radius = 0.25;
    p.pull_once(handles, 3000);
    const double before = p.state->energy;
    std::vector<Vec3> places;
    for (uint32_t v = 0; v < p.count(); ++v) places.push_back(p.at(v));
    p.pull_once(handles, 100);
    EXPECT_NEAR(p.state->energy, before, 1e-6 * before);
    for (uint32_t v = 0; v < p.count(); ++v) EXPECT_LT((p.at(v) - places[v]).norm(), 1e-4);
}

TEST(Pulling, PatchesOfHandlesBesideEachOtherEndInBetween) {
    Pulled p(bar());
    std::vector<PullHandle> handles = {p.handle({0, 0, 0.2}), p.handle({0.2, 1, 0}, {0.1, 0, 0}),
                                       p.handle({0.2, 1.1, 0}, {-0.1, 0, 0})};
    ASSERT_NE(handles[1].vertices, handles[2].vertices);
    for (PullHandle& handle : handles) handle.radius = 3;
    p.pull_once(handles, 30);
    for (const PullHandle& handle : handles) EXPECT_LT((p.at(handle.vertices[0]) - handle.at).norm(), 1e-7);
    EXPECT_LT(largest_stretch(p), 3);
    EXPECT_LE(p.state->responses[1]->handle.radius,
              0.5 * (p.at_rest(handles[1].vertices[0]) - p.at_rest(handles[2].vertices[0])).norm());
}

// A radius that reaches no other vertex holds the point alone.
TEST(Pulling, SmallPatchesArePoints) {
    Pulled points(bar()), patches(bar());
    std::vector<PullHandle> handles = {points.handle({0, 0, 0.2}), points.handle({0, 2.2, 0}, {0.5, 0, 0})};
    points.pull_once(handles, 5);
    for (PullHandle& handle : handles) handle.radius = 1e-3;
    patches.pull_once(handles, 5);
    for (uint32_t v = 0; v < points.count(); ++v) EXPECT_LT((points.at(v) - patches.at(v)).norm(), 1e-9);
}

TEST(Pulling, SpringsGiveWay) {
    Pulled p(bar());
    double before = 0;
    for (const double compliance : {0.0, 0.1, 1.0, 10.0}) {
        p.state.reset();
        std::vector<PullHandle> handles = {p.handle({0, -0.2, 0}), p.handle({0, 2.2, 0}, {0.5, 0, 0})};
        handles[1].compliance = compliance;
        p.pull_once(handles, 50);
        const double off = (p.at(handles[1].vertices[0]) - handles[1].at).norm();
        EXPECT_GE(off, before - 1e-9) << compliance;
        before = off;
    }
    EXPECT_GT(before, 0.02);
}

TEST(Pulling, EnergyNeverRises) {
    Pulled p(bar());
    const std::vector<PullHandle> handles = {p.handle({0.2, 0, 0}), p.handle({-0.2, 0, 0}),
                                             p.handle({0, 2.2, 0}, {1.1, -0.9, 0.3})};
    double before = HUGE_VAL;
    for (int round = 0; round < 60; ++round) {
        p.pull_once(handles, 1);
        // The first round begins at rest, where no handle is met.
        if (round == 0) continue;
        EXPECT_LE(p.state->energy, before * (1 + 1e-9)) << round;
        before = p.state->energy;
    }
}

TEST(Pulling, IsTheLiteralMethod) {
    Pulled p(bar());
    const std::vector<PullHandle> handles = {p.handle({0.2, 0, 0}), p.handle({-0.2, 0, 0}), p.handle({0, 0, 0.2}),
                                             p.handle({0, 2.2, 0}, {0.8, -0.4, 0.3})};
    std::vector<Vec3> rest;
    std::vector<std::array<uint32_t, 3>> triangles;
    for (uint32_t v = 0; v < p.count(); ++v) rest.push_back(p.at_rest(v));
    for (uint32_t t = 0; t < p.repaired.mesh().triangle_count(); ++t)
        triangles.push_back(p.repaired.mesh().triangles[t]);
    reference::LiteralArap literal(rest, triangles);
    for (const PullHandle& handle : handles) literal.fix(handle.vertices[0], handle.at);
    for (int round = 0; round < 30; ++round) {
        p.pull_once(handles, 1);
        const std::vector<Vec3>& there = literal.iterate();
        double off = 0;
        for (uint32_t v = 0; v < p.count(); ++v) off = std::max(off, (p.at(v) - there[v]).norm());
        EXPECT_LT(off, 1e-6) << round;
    }
}

TEST(Pulling, APoseIsWhatPullingAddsTo) {
    Pulled p(bar());
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.3, Vec3::UnitX()).toRotationMatrix();
    // What two handles leave open is as it may be.
    std::vector<PullHandle> handles = {p.handle({0.2, 0, 0}), p.handle({-0.2, 0, 0}), p.handle({0, 0, 0.2}),
                                       p.handle({0, 2.2, 0}, {0.2, 0, 0})};
    p.pull_once(handles, 3000);
    std::vector<Vec3> before;
    for (uint32_t v = 0; v < p.count(); ++v) before.push_back(p.at(v));
    for (uint32_t v = 0; v < p.count(); ++v) {
        const Vec3 turned = turn * p.at_rest(v);
        for (int k = 0; k < 3; ++k) p.rest[3 * v + k] = static_cast<float>(turned[k]);
    }
    for (PullHandle& handle : handles) handle.at = turn * handle.at;
    p.pull_once(handles, 3000);
    for (uint32_t v = 0; v < p.count(); ++v) EXPECT_LT((p.at(v) - turn * before[v]).norm(), 1e-5);
}

TEST(Pulling, SameBitsWhereverItPauses) {
    Pulled whole(bar()), halting(bar());
    for (int frame = 0; frame < 3; ++frame) {
        std::vector<PullHandle> handles = {whole.handle({0, -0.2, 0}), whole.handle({0, 2.2, 0}, {0.2 * frame, 0, 0})};
        handles[1].radius = 0.3;
        whole.pull_once(handles, 2);
        halting.pull_once(handles, 2, true);
    }
    EXPECT_EQ(std::memcmp(whole.state->moved.data(), halting.state->moved.data(), 8 * whole.state->moved.size()), 0);
}

}  // namespace
}  // namespace flg::test
