// SPDX-License-Identifier: MIT
// Steps taken back and made again; groups and joins.
#include "tangles/random_session.h"

namespace flg::test {
namespace {

const Regions root = {0};

TEST(TangleHistory, StepsAreTakenBackAndMadeAgainToTheBit) {
    const TangleHost host;
    const FlgSurface surface = host.surface(sphere(10));
    const FlgTangle tangle = host.tangle(surface);
    const double area = host.report(surface).area;
    std::vector<std::string> meshes = {bits(host.view(surface))}, trees = {host.tree_bits(tangle)};
    const auto remember = [&] {
        meshes.push_back(bits(host.view(surface)));
        trees.push_back(host.tree_bits(tangle));
    };
    ASSERT_EQ(host.divide(contour(tangle, root, samples(0.8f), 0.3f, 2)), FLG_OK);
    remember();
    const Regions first = {1}, some = host.children(tangle, 0);
    ASSERT_EQ(host.divide(contour(tangle, some, borders(FLG_TANGLE_BORDERS_EACH), 0.05f, 1)), FLG_OK);
    remember();
    FlgTangleDisplaceDesc displace = flgTangleDisplaceDefaults();
    displace.tangle = tangle;
    displace.regions = first.data();
    displace.region_count = 1;
    ASSERT_EQ(flgTangleDisplace(host.context, &displace, nullptr), FLG_OK);
    host.finish();
    remember();
    ASSERT_EQ(flgTangleGroup(host.context, tangle, some.data(), static_cast<uint32_t>(some.size()), nullptr, nullptr),
              FLG_OK);
    host.finish();
    remember();
    ASSERT_EQ(flgTangleJoin(host.context, tangle, root.data(), 1, nullptr, nullptr), FLG_OK);
    host.finish();
    remember();
    EXPECT_EQ(host.info(tangle).leaf_count, 1u);
    for (size_t step = meshes.size() - 1; step-- > 0;) {
        ASSERT_EQ(host.undo(tangle), FLG_OK);
        EXPECT_EQ(bits(host.view(surface)), meshes[step]) << "back to step " << step;
        EXPECT_EQ(host.tree_bits(tangle), trees[step]);
    }
    EXPECT_EQ(host.undo(tangle), FLG_ERROR_INVALID_ARGUMENT) << "no step is left";
    for (size_t step = 1; step < meshes.size(); ++step) {
        ASSERT_EQ(host.redo(tangle), FLG_OK);
        EXPECT_EQ(bits(host.view(surface)), meshes[step]) << "again to step " << step;
        EXPECT_EQ(host.tree_bits(tangle), trees[step]);
    }
    EXPECT_EQ(host.redo(tangle), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_GT(area, 0);
}

TEST(TangleHistory, DistancesAfterAStepIsTakenBackAreThoseBefore) {
    const TangleHost host;
    const FlgSurface surface = host.surface(sphere(12));
    const FlgTangle tangle = host.tangle(surface);
    const auto solve = [&] {
        FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
        const uint32_t vertex = 5;
        desc.surface = surface;
        desc.vertices = &vertex;
        desc.vertex_count = 1;
        return bits(host.view(host.solve(desc)));
    };
    const std::string before = solve();
    ASSERT_EQ(host.divide(contour(tangle, root, samples(0.5f), 0.2f, 1)), FLG_OK);
    const std::string after = solve();
    ASSERT_EQ(host.undo(tangle), FLG_OK);
    EXPECT_EQ(solve(), before);
    ASSERT_EQ(host.redo(tangle), FLG_OK);
    EXPECT_EQ(solve(), after);
}

TEST(TangleHistory, ANewStepForgetsThoseTakenBack) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(10));
    const FlgTangle tangle = host.tangle(surface);
    ASSERT_EQ(host.divide(contour(tangle, root, samples(0.3f), 0.1f, 1)), FLG_OK);
    ASSERT_EQ(host.undo(tangle), FLG_OK);
    EXPECT_EQ(host.info(tangle).redo_count, 1u);
    ASSERT_EQ(host.divide(contour(tangle, root, samples(0.4f), 0.1f, 1)), FLG_OK);
    EXPECT_EQ(host.info(tangle).redo_count, 0u);
    EXPECT_EQ(host.info(tangle).undo_count, 1u);
}

TEST(TangleHistory, SameBitsWithAnyWorkersAndBudget) {
    std::string expected;
    for (const auto& [workers, budget] : {std::pair{0u, FLG_UNLIMITED}, {0u, 100u}, {1u, FLG_UNLIMITED}, {4u, 50u}}) {
        const TangleHost host(workers, budget);
        const FlgSurface surface = host.surface(sphere(8));
        const FlgTangle tangle = host.tangle(surface);
        RandomSession session(host, surface, tangle, 7);
        for (uint32_t i = 0; i < 12; ++i) session.step();
        const std::string got = bits(host.view(surface)) + host.tree_bits(tangle);
        if (expected.empty()) expected = got;
        EXPECT_EQ(got, expected) << workers << " workers, " << budget << " us";
    }
}

TEST(TangleHistory, GroupsAreGivenAndTakenApart) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(12));
    const FlgTangle tangle = host.tangle(surface);
    ASSERT_EQ(host.divide(contour(tangle, root, borders(FLG_TANGLE_BORDERS_OUTER), 0.1f, 3)), FLG_OK);
    const Regions leaves = host.leaves(tangle);
    ASSERT_EQ(leaves.size(), 4u);
    ASSERT_EQ(flgTangleGroup(host.context, tangle, leaves.data(), 3, nullptr, nullptr), FLG_OK);
    host.finish();
    const uint32_t group = host.region(tangle, leaves[0]).group;
    EXPECT_EQ(host.region(tangle, leaves[2]).group, group);
    EXPECT_NE(host.region(tangle, leaves[3]).group, group);
    ASSERT_EQ(flgTangleUngroup(host.context, tangle, group, nullptr, nullptr), FLG_OK);
    host.finish();
    std::set<uint32_t> groups;
    for (uint32_t leaf : leaves) groups.insert(host.region(tangle, leaf).group);
    EXPECT_EQ(groups.size(), 4u);
}

TEST(TangleHistory, JoinedRegionsAreOne) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(20));
    const FlgTangle tangle = host.tangle(surface);
    ASSERT_EQ(host.divide(contour(tangle, root, borders(FLG_TANGLE_BORDERS_OUTER), 0.1f, 3)), FLG_OK);
    const auto join = [&](const Regions& regions) {
        FlgJob job{};
        EXPECT_EQ(
            flgTangleJoin(host.context, tangle, regions.data(), static_cast<uint32_t>(regions.size()), nullptr, &job),
            FLG_OK);
        host.finish();
        return host.result_of(job);
    };
    const std::string before = bits(host.view(surface)) + host.tree_bits(tangle);
    EXPECT_EQ(join({1, 3}), FLG_ERROR_INVALID_ARGUMENT) << "ring 2 lies between them";
    EXPECT_EQ(bits(host.view(surface)) + host.tree_bits(tangle), before);
    EXPECT_EQ(host.info(tangle).undo_count, 1u);
    ASSERT_EQ(join({2, 3}), FLG_OK);
    expect_valid(host, surface, tangle, 1);
    EXPECT_EQ(host.info(tangle).leaf_count, 3u);
    EXPECT_EQ(host.region(tangle, 3).joined_into, 2u);
    // It is divided under its name, by which its other name is divided too.
    const Regions other_name = {3};
    ASSERT_EQ(host.divide(contour(tangle, other_name, borders(FLG_TANGLE_BORDERS_OUTER), 0.02f, 1)), FLG_OK);
    expect_valid(host, surface, tangle, 1);
    EXPECT_GT(host.region(tangle, 2).child_count, 0u);
}

}  // namespace
}  // namespace flg::test
