// SPDX-License-Identifier: MIT
// Straight skeletons behind the C ABI.
#include <cmath>
#include <functional>
#include <vector>

#include "api/host.h"
#include "filigree/filigree_skeleton.h"

namespace flg::test {
namespace {

constexpr double frame[] = {0, 0, 6, 0, 6, 6, 0, 6, 1, 1, 5, 1, 5, 5, 1, 5};
constexpr uint32_t frame_rings[] = {0, 4, 8};

FlgContourView frame_contour() {
    FlgContourView contour = flgContourViewDefaults();
    contour.points = frame;
    contour.point_count = 8;
    contour.ring_offsets = frame_rings;
    contour.ring_count = 2;
    return contour;
}

FlgStraightSkeletonDesc desc_of(const FlgContourView& contour) {
    FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
    desc.contour = &contour;
    return desc;
}

TEST(SkeletonApi, AFrameHasARidgeAround) {
    const Host host;
    const FlgContourView drawn = frame_contour();
    const FlgStraightSkeletonDesc desc = desc_of(drawn);
    FlgStraightSkeleton skeleton{};
    FlgJob job{};
    ASSERT_EQ(flgStraightSkeletonCreate(host.context, &desc, &skeleton, &job), FLG_OK) << flgErrorGetMessage();
    FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
    EXPECT_EQ(flgStraightSkeletonGetView(host.context, skeleton, &view), FLG_NOT_READY);
    host.finish();
    ASSERT_EQ(flgStraightSkeletonGetView(host.context, skeleton, &view), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(view.contour_count, 8u);
    ASSERT_EQ(view.node_count, 12u);
    ASSERT_EQ(view.arc_count, 12u);
    for (uint32_t i = 8; i < 12; ++i) EXPECT_NEAR(view.nodes[3 * i + 2], 0.5, 1e-14);
    // The hole was turned.
    const uint32_t input[] = {0, 1, 2, 3, 7, 6, 5, 4};
    for (uint32_t i = 0; i < 8; ++i) {
        EXPECT_EQ(view.input_points[i], input[i]);
        EXPECT_EQ(view.nodes[3 * i], frame[2 * input[i]]);
        EXPECT_EQ(view.nodes[3 * i + 1], frame[2 * input[i] + 1]);
        EXPECT_EQ(view.face_nodes[view.face_offsets[i]], i);
    }
    for (uint32_t i = 0; i < 12; ++i) {
        const uint32_t* arc = view.arcs + 4 * i;
        EXPECT_LE(view.nodes[3 * arc[0] + 2], view.nodes[3 * arc[1] + 2]);
        EXPECT_LT(std::max(arc[2], arc[3]), 8u);
    }
    EXPECT_EQ(view.perturbation, 0);
    EXPECT_LT(view.residual, 1e-14);
    EXPECT_EQ(flgStraightSkeletonRelease(host.context, skeleton), FLG_OK);
    EXPECT_EQ(flgStraightSkeletonGetView(host.context, skeleton, &view), FLG_ERROR_INVALID_HANDLE);
    EXPECT_EQ(flgStraightSkeletonRelease(host.context, skeleton), FLG_ERROR_INVALID_HANDLE);
}

TEST(SkeletonApi, BadDescriptorsAreRefused) {
    const Host host;
    const auto refusal = [&](const std::function<void(FlgContourView&, FlgStraightSkeletonDesc&)>& change) {
        FlgContourView contour = frame_contour();
        FlgStraightSkeletonDesc desc = desc_of(contour);
        change(contour, desc);
        FlgStraightSkeleton skeleton{7};
        EXPECT_LT(flgStraightSkeletonCreate(host.context, &desc, &skeleton, nullptr), 0);
        EXPECT_EQ(skeleton.id, 0u);
        return std::string(flgErrorGetMessage());
    };
    using Drawn = FlgContourView;
    using Desc = FlgStraightSkeletonDesc;
    EXPECT_EQ(refusal([](Drawn& c, Desc&) { c.points = nullptr; }), "desc.contour.points is null");
    EXPECT_EQ(refusal([](Drawn& c, Desc&) { c.point_count = 2; }), "desc.contour.point_count is 2, must be at least 3");
    EXPECT_EQ(refusal([](Drawn& c, Desc&) { c.point_count = 1u << 25; }),
              "desc.contour.point_count is 33554432, at most 16777216");
    EXPECT_EQ(refusal([](Drawn& c, Desc&) { c.ring_count = 0; }),
              "desc.contour.ring_count is 0, must be at least 1, and at most the number of points");
    EXPECT_EQ(refusal([](Drawn& c, Desc&) { c.ring_offsets = nullptr; }),
              "desc.contour.ring_count is 2, must be 1 without ring_offsets");
    static constexpr uint32_t falling[] = {0, 9, 8}, late[] = {1, 4, 8}, early[] = {0, 4, 7};
    EXPECT_EQ(refusal([](Drawn& c, Desc&) { c.ring_offsets = falling; }),
              "desc.contour.ring_offsets[1] is 9; offsets rise from 0 to point_count, 8");
    EXPECT_EQ(refusal([](Drawn& c, Desc&) { c.ring_offsets = late; }),
              "desc.contour.ring_offsets[0] is 1; offsets rise from 0 to point_count, 8");
    EXPECT_EQ(refusal([](Drawn& c, Desc&) { c.ring_offsets = early; }),
              "desc.contour.ring_offsets[2] is 7; offsets rise from 0 to point_count, 8");
    EXPECT_NE(refusal([](Drawn& c, Desc&) { c.struct_size = 3; }).find("desc.contour: struct_size is 3"),
              std::string::npos);
    EXPECT_EQ(refusal([](Drawn&, Desc& d) { d.contour = nullptr; }), "desc.contour is null");
    EXPECT_NE(refusal([](Drawn&, Desc& d) { d.struct_size = 3; }).find("desc: struct_size is 3"), std::string::npos);
    EXPECT_EQ(flgStraightSkeletonCreate(host.context, nullptr, nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
}

// Found by the job: the skeleton has its sentence.
TEST(SkeletonApi, CrossingsFailTheJob) {
    const Host host;
    static constexpr double bow[] = {0, 0, 2, 2, 2, 0, 0, 2};
    FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
    FlgContourView drawn = flgContourViewDefaults();
    drawn.points = bow;
    drawn.point_count = 4;
    desc.contour = &drawn;
    FlgStraightSkeleton skeleton{};
    ASSERT_EQ(flgStraightSkeletonCreate(host.context, &desc, &skeleton, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
    EXPECT_EQ(flgStraightSkeletonGetView(host.context, skeleton, &view), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgErrorGetMessage(), "contour: the edges between points 0 and 1 and between 2 and 3 cross at (1, 1)");
    EXPECT_EQ(view.nodes, nullptr);
}

TEST(SkeletonApi, OffsetPolygonsAreCountedAndWritten) {
    const Host host;
    const FlgContourView drawn = frame_contour();
    const FlgStraightSkeletonDesc desc = desc_of(drawn);
    FlgStraightSkeleton skeleton{};
    ASSERT_EQ(flgStraightSkeletonCreate(host.context, &desc, &skeleton, nullptr), FLG_OK) << flgErrorGetMessage();
    FlgOffsetPolygons polygons = flgOffsetPolygonsDefaults();
    EXPECT_EQ(flgStraightSkeletonOffset(host.context, skeleton, 0.25, &polygons), FLG_NOT_READY);
    host.finish();
    ASSERT_EQ(flgStraightSkeletonOffset(host.context, skeleton, 0.25, &polygons), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(polygons.point_count, 8u);
    EXPECT_EQ(polygons.ring_count, 2u);
    double points[16] = {};
    uint32_t edges[8] = {}, offsets[3] = {7, 7, 7};
    polygons.points = points;
    polygons.edges = edges;
    polygons.ring_offsets = offsets;
    polygons.point_capacity = 7;
    polygons.ring_capacity = 2;
    ASSERT_EQ(flgStraightSkeletonOffset(host.context, skeleton, 0.25, &polygons), FLG_OK);
    EXPECT_EQ(offsets[2], 7u);  // no room
    polygons.point_capacity = 8;
    ASSERT_EQ(flgStraightSkeletonOffset(host.context, skeleton, 0.25, &polygons), FLG_OK);
    EXPECT_EQ(offsets[0], 0u);
    EXPECT_EQ(offsets[1], 4u);
    EXPECT_EQ(offsets[2], 8u);
    EXPECT_NEAR(points[0], 0.25, 1e-14);
    EXPECT_NEAR(points[1], 0.25, 1e-14);
    for (uint32_t i = 0; i < 8; ++i) EXPECT_EQ(edges[i], i);
    polygons.point_capacity = 0;
    ASSERT_EQ(flgStraightSkeletonOffset(host.context, skeleton, 0.5, &polygons), FLG_OK);
    EXPECT_EQ(polygons.point_count + polygons.ring_count, 0u);
    for (const double bad : {-0.1, HUGE_VAL, std::nan("")}) {
        EXPECT_EQ(flgStraightSkeletonOffset(host.context, skeleton, bad, &polygons), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(std::string(flgErrorGetMessage()).find("distance is"), std::string::npos);
    }
    EXPECT_EQ(flgStraightSkeletonOffset(host.context, skeleton, 0, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(flgStraightSkeletonOffset(host.context, {}, 0, &polygons), FLG_ERROR_INVALID_HANDLE);
}

// A hundred thousand points, also crossing once.
TEST(SkeletonApi, ManyPoints) {
    const Host host;
    constexpr uint32_t n = 100'000;
    std::vector<double> points;
    for (uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * M_PI * i / n, radius = 1 + 0.3 * std::sin(5 * angle) + 0.1 * std::sin(17 * angle);
        points.push_back(radius * std::cos(angle));
        points.push_back(radius * std::sin(angle));
    }
    FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
    FlgContourView drawn = flgContourViewDefaults();
    drawn.points = points.data();
    drawn.point_count = n;
    desc.contour = &drawn;
    FlgStraightSkeleton good{}, bad{};
    ASSERT_EQ(flgStraightSkeletonCreate(host.context, &desc, &good, nullptr), FLG_OK) << flgErrorGetMessage();
    std::swap(points[2 * 70'000], points[2 * 20'000]);
    ASSERT_EQ(flgStraightSkeletonCreate(host.context, &desc, &bad, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
    ASSERT_EQ(flgStraightSkeletonGetView(host.context, good, &view), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(view.contour_count, n);
    EXPECT_EQ(view.arc_count + 1, view.node_count);
    EXPECT_LT(view.residual, 1e-9);
    EXPECT_EQ(flgStraightSkeletonGetView(host.context, bad, &view), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgErrorGetMessage()).find(" cross at ("), std::string::npos) << flgErrorGetMessage();
}

TEST(SkeletonApi, SizesFromTinyToHuge) {
    const Host host;
    for (const double size : {1e-140, 1e-12, 1.0, 1e12, 1e140}) {
        double points[16];
        for (size_t i = 0; i < 16; ++i) points[i] = size * frame[i];
        FlgContourView drawn = frame_contour();
        drawn.points = points;
        const FlgStraightSkeletonDesc desc = desc_of(drawn);
        FlgStraightSkeleton skeleton{};
        ASSERT_EQ(flgStraightSkeletonCreate(host.context, &desc, &skeleton, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
        ASSERT_EQ(flgStraightSkeletonGetView(host.context, skeleton, &view), FLG_OK) << flgErrorGetMessage();
        ASSERT_EQ(view.node_count, 12u);
        for (uint32_t i = 8; i < 12; ++i) EXPECT_NEAR(view.nodes[3 * i + 2] / size, 0.5, 1e-13);
    }
}

TEST(SkeletonApi, WhatIsWrongIsSaid) {
    const Host host;
    const auto sentence = [&](std::vector<double> points, std::vector<uint32_t> rings) {
        FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
        FlgContourView drawn = flgContourViewDefaults();
        drawn.points = points.data();
        drawn.point_count = static_cast<uint32_t>(points.size() / 2);
        drawn.ring_offsets = rings.data();
        drawn.ring_count = static_cast<uint32_t>(rings.size()) - 1;
        desc.contour = &drawn;
        FlgStraightSkeleton skeleton{};
        if (flgStraightSkeletonCreate(host.context, &desc, &skeleton, nullptr) < 0)
            return std::string(flgErrorGetMessage());
        host.finish();
        FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
        EXPECT_EQ(flgStraightSkeletonGetView(host.context, skeleton, &view), FLG_ERROR_INVALID_ARGUMENT);
        return std::string(flgErrorGetMessage());
    };
    // A spike, holes that touch, a hole outside, a ring without area, a number that is none.
    EXPECT_EQ(sentence({0, 0, 10, 0, 10, 10, 10, 15, 10, 10, 0, 10}, {0, 6}),
              "contour: points 2 and 4 are at one place, (10, 10)");
    EXPECT_EQ(sentence({0, 0, 10, 0, 10, 10, 0, 10, 2, 2, 2, 5, 5, 5, 5, 2, 5, 5, 5, 7, 7, 7, 7, 5}, {0, 4, 8, 12}),
              "contour: points 6 and 8 are at one place, (5, 5)");
    EXPECT_EQ(sentence({0, 0, 10, 0, 10, 10, 0, 10, 20, 2, 20, 5, 23, 5}, {0, 4, 7}),
              "contour: ring 1, with (20, 2), is outside of ring 0");
    EXPECT_EQ(sentence({0, 0, 1, 1, 2, 2}, {0, 3}),
              "contour: ring 0, with (0, 0), has no area, or runs back on itself");
    EXPECT_EQ(sentence({0, 0, 1, 0, 1, HUGE_VAL}, {0, 3}),
              "contour: point 2 is (1, inf); coordinates are finite, at most 1e+150");
}

// The larger lobe of a figure of eight.
TEST(SkeletonApi, CrossingsAreRepairedIfAskedFor) {
    const Host host;
    static constexpr double eight[] = {0, 0, 4, 4, 4, 0, 0, 2}, line[] = {0, 0, 1, 1, 2, 2};
    FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
    EXPECT_EQ(desc.repair, 0u);
    desc.repair = 1;
    FlgContourView drawn = flgContourViewDefaults();
    drawn.points = eight;
    drawn.point_count = 4;
    desc.contour = &drawn;
    FlgStraightSkeleton skeleton{}, none{};
    ASSERT_EQ(flgStraightSkeletonCreate(host.context, &desc, &skeleton, nullptr), FLG_OK) << flgErrorGetMessage();
    drawn.points = line;
    drawn.point_count = 3;
    ASSERT_EQ(flgStraightSkeletonCreate(host.context, &desc, &none, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
    ASSERT_EQ(flgStraightSkeletonGetView(host.context, skeleton, &view), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(view.contour_count, 3u);
    uint32_t new_points = 0;
    for (uint32_t i = 0; i < 3; ++i) {
        new_points += view.input_points[i] == FLG_NO_INDEX;
        if (view.input_points[i] != FLG_NO_INDEX) {
            EXPECT_EQ(view.nodes[3 * i], 4);
        }
    }
    EXPECT_EQ(new_points, 1u);
    EXPECT_EQ(flgStraightSkeletonGetView(host.context, none, &view), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgErrorGetMessage(), "contour: its rings go around nothing that has an area");
}

// Each allocation fails once: nothing is lost, and the next try is good.
TEST(SkeletonApi, MemoryMayRunOut) {
    for (const uint32_t repair : {0u, 1u}) {
        Host host;
        HostAllocator& allocator = host.allocator;
        const FlgContourView drawn = frame_contour();
        FlgStraightSkeletonDesc desc = desc_of(drawn);
        desc.repair = repair;
        bool is_done = false;
        int64_t failures = 0;
        for (int64_t n = 0; !is_done; ++n) {
            allocator.fail_at = allocator.calls + n;
            FlgStraightSkeleton skeleton{};
            const FlgResult made = flgStraightSkeletonCreate(host.context, &desc, &skeleton, nullptr);
            if (made == FLG_OK) {
                host.finish();
                FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
                const FlgResult result = flgStraightSkeletonGetView(host.context, skeleton, &view);
                is_done = result == FLG_OK && allocator.calls <= allocator.fail_at;
                if (result != FLG_OK) {
                    EXPECT_EQ(result, FLG_ERROR_OUT_OF_MEMORY);
                    ++failures;
                }
                flgStraightSkeletonRelease(host.context, skeleton);
            } else {
                EXPECT_EQ(made, FLG_ERROR_OUT_OF_MEMORY);
                ++failures;
            }
            allocator.fail_at = -1;
        }
        EXPECT_GT(failures, 10);
    }
}

}  // namespace
}  // namespace flg::test
