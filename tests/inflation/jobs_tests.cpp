// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>

#include "inflation/inflation_jobs.h"
#include "inflation/models.h"
#include "runtime/job.h"

namespace flg::test {
namespace {

// Runs a task to its end without a scheduler; it pauses at each opportunity if `haltingly`. Throws what it throws.
template <class Make>
void run_to_end(const Make& make, bool haltingly) {
    const Host host({}, {}, {});
    Job job(host, test_memory(), 1);
    Pace pace(job, host, test_memory());
    Task<void> task = make(pace);
    pace.begin_slice(host.now_ns(), haltingly ? 0 : std::numeric_limits<uint64_t>::max());
    task.handle().resume();
    while (!task.done()) pace.resume_point.resume();
    if (task.exception()) std::rethrow_exception(task.exception());
}

struct Skinned {
    InflatedPart part{test_memory()};
    PartSurface surface;
    MergedMesh mesh;
    BoneWeights weights;
};

Skinned skinned(const Rings& rings, bool haltingly) {
    Skinned all;
    all.part.contour = contour_of(rings);
    run_to_end([&](Pace& pace) { return inflate_part(pace, {}, all.part); }, haltingly);
    run_to_end([&](Pace& pace) { return make_part_surface(pace, all.part, all.surface); }, haltingly);
    PlacedPart placed[1];
    placed[0].part = &all.part;
    run_to_end([&](Pace& pace) { return merge_parts(pace, placed, {.vertices = 1000}, all.mesh); }, haltingly);
    const BoneSegment bones[] = {{{-1, 0, 0}, {0, 0, 0}, 0.4, 0.4, 0, 0}, {{0, 0, 0}, {1, 0, 0}, 0.4, 0.4, 1, 0}};
    run_to_end([&](Pace& pace) { return weigh_bones(pace, all.mesh, bones, {}, all.weights); }, haltingly);
    return all;
}

TEST(InflationJobs, TheSameInOneGoAndHaltingly) {
    const Rings rings = {capsule(-1, 0, 0.4, 1, 0, 0.4)};
    const Skinned a = skinned(rings, false), b = skinned(rings, true);
    EXPECT_GT(a.surface.positions.size(), 500u);
    EXPECT_NEAR(static_cast<double>(a.mesh.positions.size()), 1000, 150);
    ASSERT_EQ(a.mesh.positions.size(), a.weights.weights.size());
    EXPECT_TRUE(std::equal(a.surface.positions.begin(), a.surface.positions.end(), b.surface.positions.begin(),
                           b.surface.positions.end()));
    EXPECT_TRUE(
        std::equal(a.mesh.positions.begin(), a.mesh.positions.end(), b.mesh.positions.begin(), b.mesh.positions.end()));
    EXPECT_TRUE(std::equal(a.weights.weights.begin(), a.weights.weights.end(), b.weights.weights.begin(),
                           b.weights.weights.end()));
    // The two-sided mesh and the merged one are of the same body.
    double reach = 0, merged_reach = 0;
    for (const Vec3& p : a.surface.positions) reach = std::max(reach, p.z());
    for (const Vec3& p : a.mesh.positions) merged_reach = std::max(merged_reach, p.z());
    EXPECT_NEAR(reach, merged_reach, 0.01);
}

TEST(InflationJobs, WhatIsWrongIsThrown) {
    EXPECT_THROW(skinned({{{0, 0}, {10, 8}, {10, 0}, {0, 10}}}, true), Failure);
}

}  // namespace
}  // namespace flg::test
