// SPDX-License-Identifier: MIT
// What tangles refuse, and with which sentence; and what they take although it is odd.
#include "tangles/tangle_host.h"

namespace flg::test {
namespace {

const Regions root = {0};

FlgTangleSeeds outer_borders() {
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
    seeds.borders = FLG_TANGLE_BORDERS_OUTER;
    return seeds;
}

struct Refused {
    FlgResult result;
    std::string sentence;
};

// By the call or by its job.
Refused divide(const TangleHost& host, const FlgTangleDivideDesc& desc) {
    FlgJob job{};
    const FlgResult result = flgTangleDivide(host.context, &desc, &job);
    if (result != FLG_OK) return {result, flgErrorGetMessage()};
    host.finish();
    const FlgJobStatus status = host.status_of(job);
    return {status.result, status.error};
}

class TangleRefusals : public testing::Test {
protected:
    void expect_refused(const FlgTangleDivideDesc& desc, const std::string& part) {
        const std::string before = bits(host.view(surface)) + host.tree_bits(tangle);
        const Refused refused = divide(host, desc);
        EXPECT_EQ(refused.result, FLG_ERROR_INVALID_ARGUMENT) << part;
        EXPECT_NE(refused.sentence.find(part), std::string::npos) << refused.sentence;
        EXPECT_EQ(bits(host.view(surface)) + host.tree_bits(tangle), before) << "nothing is changed";
        EXPECT_EQ(host.info(tangle).undo_count, 0u) << "and no step";
    }

    const TangleHost host;
    const FlgSurface surface = host.surface(plane(6));
    const FlgTangle tangle = host.tangle(surface);
    const FlgTangleDivideDesc good = contour(tangle, root, outer_borders(), 0.1f, 1);
};

TEST_F(TangleRefusals, NumbersOutOfRange) {
    FlgTangleDivideDesc desc = good;
    for (float delta : {0.0f, -1.0f, NAN, INFINITY}) {
        desc.delta = delta;
        expect_refused(desc, "desc.delta");
    }
    desc = good;
    desc.count = 1'000'000;
    expect_refused(desc, "desc.count is 1000000");
    desc = good;
    desc.kind = static_cast<FlgTangleOperator>(4);
    expect_refused(desc, "desc.kind");
    desc = good;
    desc.grouping = static_cast<FlgTangleGrouping>(-1);
    expect_refused(desc, "desc.grouping");
    desc = good;
    desc.cycle = 0;
    expect_refused(desc, "desc.cycle");
    desc = good;
    desc.perturbation = -1;
    expect_refused(desc, "desc.perturbation");
    desc = good;
    desc.frequency = 0;
    expect_refused(desc, "desc.frequency");
    desc = good;
    desc.b = kept(outer_borders());
    desc.delta = 1;
    expect_refused(desc, "below 1");
}

TEST_F(TangleRefusals, RegionsThatAreNotThere) {
    const Regions none = {7};
    FlgTangleDivideDesc desc = good;
    desc.regions = none.data();
    expect_refused(desc, "desc.regions[0] is 7, the tangle has 1 regions");
    desc = good;
    desc.region_count = 0;
    expect_refused(desc, "desc.region_count");
    desc = good;
    desc.regions = nullptr;
    expect_refused(desc, "desc.regions");
    EXPECT_EQ(flgTangleGroup(host.context, tangle, nullptr, 1, nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    for (const auto change : {flgTangleGroup, flgTangleJoin}) {
        FlgJob job{};
        ASSERT_EQ(change(host.context, tangle, none.data(), 1, nullptr, &job), FLG_OK);
        host.finish();
        EXPECT_EQ(host.result_of(job), FLG_ERROR_INVALID_ARGUMENT);
    }
}

TEST_F(TangleRefusals, SeedsThatComeToNothing) {
    FlgTangleDivideDesc desc = good;
    const FlgTangleSeeds empty = flgTangleSeedsDefaults();
    desc.a = nullptr;
    expect_refused(desc, "desc.a is empty");
    desc.a = &empty;
    expect_refused(desc, "desc.a is empty");
    FlgTangleSeeds unsized = empty;
    unsized.struct_size = 0;
    desc.a = &unsized;
    expect_refused(desc, "desc.a: struct_size is 0");
    desc = good;
    FlgTangleSeeds a = empty;
    desc.a = &a;
    const FlgBorderStretch no_loop = {3, 0, 1}, backwards = {0, 0.5f, 0.2f}, twice_around = {0, 0, 1.5f};
    a.stretch_count = 1;
    a.stretches = &no_loop;
    expect_refused(desc, "desc.a.stretches[0].loop is 3, the regions have 1 borders");
    a.stretches = &backwards;
    expect_refused(desc, "desc.a.stretches[0]");
    a.stretches = &twice_around;
    expect_refused(desc, "desc.a.stretches[0]");
    desc = good;
    a = empty;
    desc.a = &a;
    const FlgSurfacePoint point = {100'000, 0, 0};
    a.points = &point;
    a.point_count = 1;
    expect_refused(desc, "triangle 100000");
    desc.kind = FLG_TANGLE_OPERATOR_POLYLINE;
    expect_refused(desc, "a polyline needs 2 points");
    desc = good;
    desc.kind = FLG_TANGLE_OPERATOR_VORONOI;
    expect_refused(desc, "neither points nor samples");
    desc = good;
    desc.kind = FLG_TANGLE_OPERATOR_STREAM;
    a = empty;
    desc.a = &a;
    a.sample_radius = 0.2f;
    expect_refused(desc, "for streams to begin on");
    a.sample_radius = -1;
    expect_refused(desc, "desc.a.sample_radius");
}

TEST(TangleRefusalsOnClosedSurfaces, BordersAreAskedForWhereThereAreNone) {
    const TangleHost host;
    const FlgTangle tangle = host.tangle(host.surface(sphere(3)));
    for (const FlgTangleOperator kind : {FLG_TANGLE_OPERATOR_CONTOUR, FLG_TANGLE_OPERATOR_STREAM}) {
        FlgTangleDivideDesc desc = contour(tangle, root, outer_borders(), 0.1f, 1);
        desc.kind = kind;
        const Refused refused = divide(host, desc);
        EXPECT_EQ(refused.result, FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(refused.sentence.find("closed surface"), std::string::npos) << refused.sentence;
    }
}

// A plane, cut in two by a contour of its left side.
class TangleInHalves : public testing::Test {
protected:
    void SetUp() override {
        const FlgBorderStretch left = {0, 0.75f, 1};
        FlgTangleSeeds side = flgTangleSeedsDefaults();
        side.stretches = &left;
        side.stretch_count = 1;
        ASSERT_EQ(host.divide(contour(tangle, root, side, 0.5f, 1)), FLG_OK);
    }

    const TangleHost host;
    const FlgSurface surface = host.surface(plane(12));
    const FlgTangle tangle = host.tangle(surface);
};

TEST_F(TangleInHalves, ASeedOutsideOfTheRegionDividesNothing) {
    // A point of the left half; the operator is for the right one.
    const FlgSurfaceView view = host.view(surface);
    const FlgSurfacePoint point = point_above(view, 0.2, 0.5);
    const Regions right = {view.mesh->regions[point_above(view, 0.8, 0.5).triangle]};
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
    seeds.points = &point;
    seeds.point_count = 1;
    ASSERT_EQ(host.divide(contour(tangle, right, seeds, 0.1f, 2)), FLG_OK);
    EXPECT_EQ(host.info(tangle).leaf_count, 2u);
}

TEST_F(TangleInHalves, APolylineOutsideOfTheRegionIsRefused) {
    const FlgSurfaceView view = host.view(surface);
    const Regions right = {view.mesh->regions[point_above(view, 0.8, 0.5).triangle]};
    // Vertices, all triangles around which are in the left half.
    const FlgSurfacePoint points[] = {{point_above(view, 0.17, 0.33).triangle, 0, 0},
                                      {point_above(view, 0.17, 0.67).triangle, 0, 0}};
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
    seeds.points = points;
    seeds.point_count = 2;
    FlgTangleDivideDesc desc = contour(tangle, right, seeds, 0.1f, 1);
    desc.kind = FLG_TANGLE_OPERATOR_POLYLINE;
    const Refused refused = divide(host, desc);
    EXPECT_EQ(refused.result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(refused.sentence.find("no way leads from"), std::string::npos) << refused.sentence;
    EXPECT_EQ(host.info(tangle).leaf_count, 2u);
}

TEST(TangleOddities, WithoutRoomForSamplesNothingIsDivided) {
    for (const FlgTangleOperator kind : {FLG_TANGLE_OPERATOR_CONTOUR, FLG_TANGLE_OPERATOR_VORONOI}) {
        const TangleHost host;
        const FlgSurface surface = host.surface(plane(8));
        const FlgTangle tangle = host.tangle(surface);
        const std::string before = bits(host.view(surface));
        FlgTangleSeeds samples = flgTangleSeedsDefaults();
        samples.sample_radius = 5;
        FlgTangleDivideDesc desc = contour(tangle, root, samples, 0.1f, 1);
        desc.kind = kind;
        ASSERT_EQ(host.divide(desc), FLG_OK);
        EXPECT_EQ(bits(host.view(surface)), before);
        EXPECT_EQ(host.info(tangle).undo_count, 1u);
    }
}

TEST(TangleOddities, ARegionOfOneTriangleIsDivided) {
    const TangleHost host;
    const FlgSurface surface = host.surface(loose_triangles(1));
    const FlgTangle tangle = host.tangle(surface);
    ASSERT_EQ(host.divide(contour(tangle, root, outer_borders(), 0.1f, 1)), FLG_OK)
        << "no vertex is off the border: nothing to divide";
    EXPECT_EQ(host.info(tangle).leaf_count, 1u);
    const FlgSurfacePoint corner = {0, 0, 0};
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
    seeds.points = &corner;
    seeds.point_count = 1;
    ASSERT_EQ(host.divide(contour(tangle, root, seeds, 0.3f, 2)), FLG_OK);
    EXPECT_EQ(host.info(tangle).leaf_count, 3u);
    expect_valid(host, surface, tangle, 0.5);
}

TEST(TangleOddities, WhatOthersCutIsRefusedFromThenOn) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(6));
    const FlgTangle tangle = host.tangle(surface);
    const float level = 0.4f;
    FlgSurfaceCutIsolinesDesc cut = flgSurfaceCutIsolinesDefaults();
    cut.field = host.field(surface, [](const Point& p) { return p[0]; });
    cut.levels = &level;
    cut.level_count = 1;
    ASSERT_EQ(flgSurfaceCutIsolines(host.context, &cut, nullptr, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const Refused refused = divide(host, contour(tangle, root, outer_borders(), 0.1f, 1));
    EXPECT_EQ(refused.result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(refused.sentence.find("changed by others"), std::string::npos) << refused.sentence;
    FlgSurfaceCurves borders{};
    expect_failure(flgTangleTraceBorders(host.context, tangle, nullptr, &borders, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "changed by others");
}

TEST(TangleOddities, ACancelledStepIsNone) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(12));
    const FlgTangle tangle = host.tangle(surface);
    const std::string before = bits(host.view(surface));
    const FlgTangleDivideDesc desc = contour(tangle, root, outer_borders(), 0.1f, 1);
    FlgJob job{};
    ASSERT_EQ(flgTangleDivide(host.context, &desc, &job), FLG_OK);
    ASSERT_EQ(flgJobCancel(host.context, job), FLG_OK);
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_ERROR_CANCELLED);
    EXPECT_EQ(bits(host.view(surface)), before);
    ASSERT_EQ(host.divide(desc), FLG_OK);
    EXPECT_EQ(host.info(tangle).leaf_count, 2u);
}

// Whenever it is cancelled, up to its last stage: what it has cut by then is taken back.
TEST(TangleOddities, AStepThatIsCancelledWhileItCutsIsTakenBack) {
    const auto grid_of = [](FlgTangle tangle) {
        FlgTangleApplyMacroDesc desc = flgTangleApplyMacroDefaults();
        desc.kind = FLG_TANGLE_MACRO_GRID;
        desc.tangle = tangle;
        desc.regions = root.data();
        desc.region_count = 1;
        desc.size = 0.3f;
        return desc;
    };
    const TangleHost whole;
    const FlgSurface uncancelled = whole.surface(cylinder(60, 30));
    const FlgTangle of_uncancelled = whole.tangle(uncancelled);
    const FlgTangleApplyMacroDesc desc_of_whole = grid_of(of_uncancelled);
    ASSERT_EQ(flgTangleApplyMacro(whole.context, &desc_of_whole, nullptr), FLG_OK);
    whole.finish();

    const TangleHost host;
    const FlgSurface surface = host.surface(cylinder(60, 30));
    const FlgTangle tangle = host.tangle(surface);
    const std::string before = bits(host.view(surface));
    const FlgTangleApplyMacroDesc desc = grid_of(tangle);
    std::set<std::string> cancelled_in;
    for (uint32_t ticks = 1;; ticks += 1 + ticks / 8) {
        FlgJob job{};
        ASSERT_EQ(flgTangleApplyMacro(host.context, &desc, &job), FLG_OK);
        for (uint32_t i = 0; i < ticks; ++i) flgContextTick(host.context, 1, nullptr);
        const std::string stage = host.status_of(job).stage;
        ASSERT_EQ(flgJobCancel(host.context, job), FLG_OK);
        host.finish();
        if (host.result_of(job) == FLG_OK) break;
        ASSERT_EQ(host.result_of(job), FLG_ERROR_CANCELLED);
        cancelled_in.insert(stage);
        ASSERT_EQ(bits(host.view(surface)), before) << "cancelled in " << stage;
        ASSERT_EQ(host.info(tangle).region_count, 1u);
        ASSERT_EQ(host.info(tangle).redo_count, 0u);
    }
    EXPECT_TRUE(cancelled_in.contains("cut"));
    EXPECT_TRUE(cancelled_in.contains("regions"));
    EXPECT_EQ(bits(host.view(surface)), bits(whole.view(uncancelled)));
    EXPECT_EQ(host.tree_bits(tangle), whole.tree_bits(of_uncancelled));
}

TEST(TangleDisplacement, HeightsFollowTheProfile) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(20));
    const FlgTangle tangle = host.tangle(surface);
    FlgTangleDisplaceDesc desc = flgTangleDisplaceDefaults();
    desc.tangle = tangle;
    desc.regions = root.data();
    desc.region_count = 1;
    desc.amount = 0.25f;
    ASSERT_EQ(flgTangleDisplace(host.context, &desc, nullptr), FLG_OK);
    host.finish();
    // A pyramid over the square, its ridges rounded: distance to the nearest side over the largest, 0.5.
    const FlgSurfaceView view = host.view(surface);
    double highest = 0;
    for (uint32_t v = 0; v < view.mesh->vertex_count; ++v) {
        const Point p = vertex_at(view, v);
        const double u = std::min(p[0], 1 - p[0]), w = std::min(p[1], 1 - p[1]), side = std::min(u, w);
        highest = std::max<double>(highest, p[2]);
        // Flanks keep their shape; what the rounding takes from the top makes them a little steeper.
        EXPECT_NEAR(p[2], 0.25 * side / 0.5, 0.02);
        EXPECT_LE(p[2] == 0, side == 0);
    }
    EXPECT_NEAR(highest, 0.25, 1e-6);
    for (const auto& [member, value] : {std::pair{&FlgTangleDisplaceDesc::bias, 0.0f},
                                        {&FlgTangleDisplaceDesc::bias, 1.0f},
                                        {&FlgTangleDisplaceDesc::gain, 0.0f},
                                        {&FlgTangleDisplaceDesc::reach, -1.0f},
                                        {&FlgTangleDisplaceDesc::amount, NAN}}) {
        FlgTangleDisplaceDesc bad = desc;
        bad.*member = value;
        EXPECT_EQ(flgTangleDisplace(host.context, &bad, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    }
}

Point area_vector(const FlgSurfaceView& view, uint32_t triangle) {
    const uint32_t* const corners = view.mesh->triangles + 3 * size_t{triangle};
    const Point a = vertex_at(view, corners[0]), b = vertex_at(view, corners[1]), c = vertex_at(view, corners[2]);
    Point area;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        area[i] = ((b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j])) / 2;
    }
    return area;
}

FlgTangleDisplaceDesc displacement(FlgTangle tangle, float amount) {
    FlgTangleDisplaceDesc desc = flgTangleDisplaceDefaults();
    desc.tangle = tangle;
    desc.regions = root.data();
    desc.region_count = 1;
    desc.amount = amount;
    return desc;
}

// A bowl: its normals meet a radius above it, so heights beyond that would turn all of it over.
TEST(TangleDisplacement, NoTriangleTurnsOver) {
    for (const float amount : {0.3f, 3.0f, -0.3f}) {
        const TangleHost host;
        const MeshArrays bowl = grid(24, 24, [](double u, double v) {
            const double x = u - 0.5, y = v - 0.5;
            return Point{x, y, 1.2 * (x * x + y * y)};
        });
        const FlgSurface surface = host.surface(bowl);
        const FlgSurfaceView before = host.view(surface);
        std::vector<Point> normals;
        for (uint32_t t = 0; t < before.mesh->triangle_count; ++t) normals.push_back(area_vector(before, t));
        const FlgTangle tangle = host.tangle(surface);
        const FlgTangleDisplaceDesc desc = displacement(tangle, amount);
        ASSERT_EQ(flgTangleDisplace(host.context, &desc, nullptr), FLG_OK);
        host.finish();
        const FlgSurfaceView view = host.view(surface);
        double most = 0;
        for (uint32_t t = 0; t < view.mesh->triangle_count; ++t) {
            const Point now = area_vector(view, t);
            EXPECT_GE(now[0] * normals[t][0] + now[1] * normals[t][1] + now[2] * normals[t][2], 0) << t;
        }
        for (uint32_t v = 0; v < view.mesh->vertex_count; ++v)
            most = std::max<double>(most, std::abs(vertex_at(view, v)[2]));
        EXPECT_GT(most, 0.2);
    }
}

}  // namespace
}  // namespace flg::test
