// SPDX-License-Identifier: MIT
// Parts and models behind the C ABI.
#include <algorithm>
#include <cmath>
#include <functional>

#include "api/part_inputs.h"

namespace flg::test {
namespace {

// A closed line around the stretch from a to b, `radius` away.
std::vector<double> capsule(double ax, double ay, double bx, double by, double radius) {
    std::vector<double> points;
    const double along = std::atan2(by - ay, bx - ax);
    for (int i = 0; i < 64; ++i) {
        const bool at_b = i < 32;
        const double angle = along + M_PI * (at_b ? i / 31.0 - 0.5 : (i - 32) / 31.0 + 0.5);
        points.push_back((at_b ? bx : ax) + radius * std::cos(angle));
        points.push_back((at_b ? by : ay) + radius * std::sin(angle));
    }
    return points;
}

struct ModelHost : PartHost {
    using PartHost::PartHost;

    FlgModelView model(
        const std::vector<FlgModelPart>& parts,
        const std::function<void(FlgModelDesc&)>& change = [](FlgModelDesc&) {}) const {
        FlgModelDesc desc = flgModelDefaults();
        desc.parts = parts.data();
        desc.part_count = static_cast<uint32_t>(parts.size());
        change(desc);
        FlgModel model{};
        EXPECT_EQ(flgModelCreate(context, &desc, &model, nullptr), FLG_OK) << flgErrorGetMessage();
        finish();
        FlgModelView view = flgModelViewDefaults();
        EXPECT_EQ(flgModelGetView(context, model, &view), FLG_OK) << flgErrorGetMessage();
        return view;
    }
};

FlgModelPart placed(FlgPart part, const char* name, double x = 0, double y = 0, double z = 0) {
    FlgModelPart out = flgModelPartDefaults();
    out.part = part;
    out.name = name;
    out.placement[3] = x;
    out.placement[7] = y;
    out.placement[11] = z;
    return out;
}

// A body along x, a head in front, and a leg that is there twice, either side of z = 0.
std::vector<FlgModelPart> animal(const ModelHost& host) {
    std::vector<FlgModelPart> parts = {placed(host.part(capsule(-4, 0, 4, 0, 1.5)), "body"),
                                       placed(host.part(capsule(4.5, 1, 6.5, 2, 1.2)), "head"),
                                       placed(host.part(capsule(-3, -4, -3, -1, 0.5)), "leg", 0, 0, 0.8)};
    parts[2].mirrored = 1;
    return parts;
}

const auto mirror_z = [](FlgModelDesc& desc) {
    desc.mirror[0] = 0;
    desc.mirror[2] = 2;  // of any length
};

TEST(Model, PartsBecomeOneTreeWithNames) {
    const ModelHost host;
    const FlgModelView view = host.model(animal(host), mirror_z);
    ASSERT_EQ(view.part_count, 4u);
    EXPECT_EQ(view.part_events[0], FLG_PART_EVENT_ROOT);
    EXPECT_EQ(view.part_parents[0], FLG_NO_INDEX);
    for (uint32_t p = 1; p < 4; ++p) {
        EXPECT_NE(view.part_events[p], FLG_PART_EVENT_ROOT) << p;
        EXPECT_EQ(view.part_parents[p], 0u) << p;
    }
    EXPECT_EQ(view.part_twins[2], 3u);
    EXPECT_EQ(view.part_twins[3], 2u);
    EXPECT_EQ(view.part_sources[3], 2u);
    EXPECT_EQ(view.part_mirrored[3], 1u);
    for (uint32_t p = 1; p < 4; ++p) {  // what swings a part is its own topmost joint
        EXPECT_EQ(view.joint_parts[view.part_joints[p]], p);
        EXPECT_NE(view.joint_parts[view.joint_parents[view.part_joints[p]]], p);
    }
    EXPECT_EQ(view.joint_parents[0], FLG_NO_INDEX);
    std::vector<std::string> names;
    for (uint32_t j = 0; j < view.joint_count; ++j) {
        if (j > 0) {
            EXPECT_LT(view.joint_parents[j], j);
        }
        EXPECT_GT(view.joint_radii[j], 0);
        names.emplace_back(view.joint_names[j]);
    }
    for (const char* name : {"body_0", "head_0", "leg_0.L", "leg_0.R"})
        EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
    EXPECT_NEAR(view.size, 16 + 3 * M_PI, 0.1);
}

TEST(Model, MirrorImagesAreMirrored) {
    const ModelHost host;
    const FlgModelView view = host.model(animal(host), mirror_z);
    const auto find = [&](const std::string& name) {
        for (uint32_t j = 0; j < view.joint_count; ++j)
            if (name == view.joint_names[j]) return j;
        ADD_FAILURE() << name;
        return 0u;
    };
    uint32_t twins = 0;
    for (uint32_t j = 0; j < view.joint_count; ++j) {
        std::string name = view.joint_names[j];
        if (name.back() != 'L') continue;
        ++twins;
        EXPECT_GT(view.joint_positions[3 * j + 2], 0) << "left is where the normal points";
        name.back() = 'R';
        const uint32_t twin = find(name);
        for (int i = 0; i < 2; ++i) EXPECT_EQ(view.joint_positions[3 * j + i], view.joint_positions[3 * twin + i]);
        EXPECT_EQ(view.joint_positions[3 * j + 2], -view.joint_positions[3 * twin + 2]);
        EXPECT_EQ(view.joint_radii[j], view.joint_radii[twin]);
    }
    EXPECT_GE(twins, 2u);
}

TEST(Model, LeftIsLeftWhicheverSideWasDrawn) {
    const ModelHost host;
    std::vector<FlgModelPart> parts = animal(host);
    const FlgModelView left = host.model(parts, mirror_z);
    parts[2].placement[11] = -0.8;
    const FlgModelView right = host.model(parts, mirror_z);
    ASSERT_EQ(left.joint_count, right.joint_count);
    for (uint32_t j = 0; j < left.joint_count; ++j) {
        for (uint32_t k = 0; k < right.joint_count; ++k) {
            if (std::string(left.joint_names[j]) != right.joint_names[k]) continue;
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(left.joint_positions[3 * j + i], right.joint_positions[3 * k + i], 1e-6);
        }
    }
}

TEST(Model, MovingAPartMovesItsBonesAndWhereItHangs) {
    const ModelHost host;
    std::vector<FlgModelPart> parts = animal(host);
    parts[2].mirrored = 0;
    const FlgModelView before = host.model(parts);
    EXPECT_EQ(before.part_parents[2], 0u);
    parts[2].placement[3] = 5;
    const FlgModelView after = host.model(parts);
    EXPECT_EQ(after.part_parents[2], 0u);
    parts[2].placement[3] = 50;
    const FlgModelView away = host.model(parts);
    EXPECT_EQ(away.part_events[2], FLG_PART_EVENT_ROOT);
    EXPECT_EQ(std::count(away.joint_parents, away.joint_parents + away.joint_count, FLG_NO_INDEX), 2);
    // Views of models that were made before are as they were.
    EXPECT_EQ(before.part_parents[2], 0u);
}

TEST(Model, ANewContourShowsItsBonesInTheSameFrame) {
    const ModelHost host;
    const std::vector<FlgModelPart> parts = animal(host);
    FlgModelDesc desc = flgModelDefaults();
    desc.parts = parts.data();
    desc.part_count = 3;
    FlgModel model{};
    ASSERT_EQ(flgModelCreate(host.context, &desc, &model, nullptr), FLG_OK);
    FlgModelView view = flgModelViewDefaults();
    EXPECT_EQ(flgModelGetView(host.context, model, &view), FLG_NOT_READY);
    ASSERT_EQ(flgContextTick(host.context, FLG_UNLIMITED, nullptr), FLG_OK);
    EXPECT_EQ(flgModelGetView(host.context, model, &view), FLG_OK);
}

TEST(Model, IsTheSameUnderWorkers) {
    std::vector<float> expected;
    for (const uint32_t workers : {0u, 1u, 3u}) {
        const ModelHost host(workers);
        const FlgModelView view = host.model(animal(host), mirror_z);
        const std::vector<float> positions(view.joint_positions, view.joint_positions + 3 * view.joint_count);
        if (workers == 0) expected = positions;
        EXPECT_EQ(positions, expected);
    }
}

FlgBoneThresholds thresholds(float simplify, float merge, float prune, float collapse) {
    return {.struct_size = sizeof(FlgBoneThresholds),
            .simplify = simplify,
            .merge = merge,
            .prune = prune,
            .collapse = collapse,
            .detail = 0};
}

TEST(Model, ThresholdsMakeItCoarser) {
    const ModelHost host;
    const std::vector<FlgModelPart> parts = animal(host);
    uint32_t before = 0xffffffffu;
    for (const float scale : {0.0f, 1.0f, 4.0f, 20.0f}) {
        FlgBoneThresholds scaled;
        const FlgModelView view = host.model(parts, [&](FlgModelDesc& desc) {
            scaled = thresholds(0.0025f * scale, 0.015f * scale, 0.015f * scale, 0.005f * scale);
            desc.thresholds = &scaled;
        });
        EXPECT_LE(view.joint_count, before);
        before = view.joint_count;
    }
    EXPECT_LE(before, 8u);
    // A part's own thresholds, and a branch's, are its alone.
    std::vector<FlgModelPart> fine = parts;
    const FlgBoneThresholds none = thresholds(0, 0, 0, 0), coarse = thresholds(1, 0.5f, 0.5f, 0.5f),
                            simple = thresholds(1, 0, 0, 0);
    fine[0].thresholds = &none;
    const FlgModelView body = host.model(fine, [&](FlgModelDesc& desc) { desc.thresholds = &coarse; });
    const auto joints_of = [](const FlgModelView& view, uint32_t part) {
        return std::count(view.joint_parts, view.joint_parts + view.joint_count, part);
    };
    EXPECT_GT(joints_of(body, 0), 10);
    EXPECT_LE(joints_of(body, 1), 3);
    FlgPartView view = flgPartViewDefaults();
    ASSERT_EQ(flgPartGetView(host.context, parts[1].part, &view), FLG_OK);
    ASSERT_EQ(view.branch_count, 1u);
    const float branch = 0;
    fine = parts;
    fine[1].branch_simplify = &branch;
    fine[1].branch_count = 1;
    const FlgModelView head = host.model(fine, [&](FlgModelDesc& desc) { desc.thresholds = &simple; });
    EXPECT_GT(joints_of(head, 1), 10);
}

TEST(Model, OfOneRoundPartHasAJoint) {
    const ModelHost host;
    const FlgModelView view = host.model({placed(host.part({0, 0, 4, 0, 0, 3}), nullptr)});
    ASSERT_GE(view.joint_count, 1u);
    EXPECT_EQ(std::string(view.joint_names[0]), "part0_0");
    EXPECT_EQ(view.part_joints[0], 0u);
}

TEST(Part, ShowsOutlineAxisAndSlices) {
    const ModelHost host;
    const FlgPart part = host.part(capsule(0, 0, 10, 0, 1));
    host.finish();
    FlgPartView view = flgPartViewDefaults();
    ASSERT_EQ(flgPartGetView(host.context, part, &view), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(view.ring_count, 1u);
    EXPECT_EQ(view.outline_rings[1], view.outline_count);
    EXPECT_GT(view.outline_count, 8u);
    EXPECT_LT(view.outline_count, 64u);
    EXPECT_NEAR(view.length, 20 + 2 * M_PI, 0.02);
    ASSERT_EQ(view.branch_count, 1u);
    EXPECT_EQ(view.branches[3], view.sample_count);
    for (uint32_t s = view.branches[2]; s < view.branches[3]; ++s) {
        const FlgAxisSample& sample = view.samples[s];
        EXPECT_NEAR(sample.y, 0, 0.05);
        if (sample.x > 0.5 && sample.x < 9.5) {
            EXPECT_NEAR(sample.left, 1, 0.05);
            EXPECT_NEAR(sample.right, 1, 0.05);
        }
    }
}

// What may be wrong with a drawing, and the words that say so.
TEST(Part, RefusesWhatIsNoContour) {
    const ModelHost host;
    const auto refused = [&](const std::vector<double>& points, const std::string& words) {
        FlgPartDesc desc = flgPartDefaults();
        FlgContourView drawn = flgContourViewDefaults();
        drawn.points = points.data();
        drawn.point_count = static_cast<uint32_t>(points.size() / 2);
        desc.contour = &drawn;
        FlgPart part{};
        FlgJob job{};
        std::string error;
        if (flgPartCreate(host.context, &desc, &part, &job) != FLG_OK) {
            error = flgErrorGetMessage();
        } else {
            host.finish();
            FlgPartView view = flgPartViewDefaults();
            EXPECT_EQ(flgPartGetView(host.context, part, &view), FLG_ERROR_INVALID_ARGUMENT);
            error = flgErrorGetMessage();
        }
        EXPECT_NE(error.find(words), std::string::npos) << error;
    };
    refused({0, 0, 1, 0}, "desc.contour.point_count is 2");
    refused({0, 0, 1, 0, 2, 0, 3, 0}, "has no area");
    refused({0, 0, 4, 4, 4, 0, 0, 4}, "cross at (2, 2)");
    refused({0, 0, 1, 0, 1, NAN, 0, 1}, "");
    refused({0, 0, 2, 0, 2, 2, 4, 2, 2, 2, 0, 2}, "");  // a spike
}

TEST(Part, RepairsWhatCrossesItselfOnRequest) {
    const ModelHost host;
    // Two triangles that touch at a crossing; the larger one is kept.
    const std::vector<double> points = {0, 0, 6, 6, 6, 0, 0, 6, -2, 3};
    FlgPartDesc desc = flgPartDefaults();
    FlgContourView drawn = flgContourViewDefaults();
    drawn.points = points.data();
    drawn.point_count = 5;
    desc.contour = &drawn;
    FlgPart part{};
    for (const uint32_t repair : {0u, 1u}) {
        desc.repair = repair;
        ASSERT_EQ(flgPartCreate(host.context, &desc, &part, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        FlgPartView view = flgPartViewDefaults();
        ASSERT_EQ(flgPartGetView(host.context, part, &view), repair ? FLG_OK : FLG_ERROR_INVALID_ARGUMENT);
        if (!repair) continue;
        for (uint32_t i = 0; i < view.outline_count; ++i) EXPECT_LE(view.outline[2 * i], 3.001);
        EXPECT_GE(view.node_count, 1u);
    }
}

TEST(Part, RefusesNumbersOutOfTheirRange) {
    const ModelHost host;
    const std::vector<double> points = capsule(0, 0, 4, 0, 1);
    const auto refused = [&](const std::function<void(FlgPartDesc&)>& change, const std::string& words) {
        FlgPartDesc desc = flgPartDefaults();
        FlgContourView drawn = flgContourViewDefaults();
        drawn.points = points.data();
        drawn.point_count = static_cast<uint32_t>(points.size() / 2);
        desc.contour = &drawn;
        change(desc);
        FlgPart part{77};
        EXPECT_EQ(flgPartCreate(host.context, &desc, &part, nullptr), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(part.id, 0u);
        EXPECT_NE(std::string(flgErrorGetMessage()).find(words), std::string::npos) << flgErrorGetMessage();
    };
    refused([](FlgPartDesc& d) { d.spacing = 1e-9; }, "desc.spacing is 1e-09");
    refused([](FlgPartDesc& d) { d.tolerance = -1; }, "desc.tolerance is -1");
    refused([](FlgPartDesc& d) { d.collapse = NAN; }, "desc.collapse is nan");
    refused(
        [](FlgPartDesc& d) {
            static FlgContourView wrong = flgContourViewDefaults();
            wrong.struct_size = 4;
            d.contour = &wrong;
        },
        "desc.contour");
}

TEST(Model, RefusesWhatItCantUse) {
    const ModelHost host;
    const FlgPart part = host.part(capsule(0, 0, 4, 0, 1));
    const auto refused = [&](const std::function<void(FlgModelDesc&, FlgModelPart&)>& change,
                             const std::string& words) {
        FlgModelPart one = placed(part, "one");
        FlgModelDesc desc = flgModelDefaults();
        desc.parts = &one;
        desc.part_count = 1;
        change(desc, one);
        FlgModel model{};
        EXPECT_LT(flgModelCreate(host.context, &desc, &model, nullptr), 0);
        EXPECT_EQ(model.id, 0u);
        EXPECT_NE(std::string(flgErrorGetMessage()).find(words), std::string::npos) << flgErrorGetMessage();
    };
    refused([](FlgModelDesc& d, FlgModelPart&) { d.part_count = 0; }, "desc.part_count is 0");
    refused([](FlgModelDesc& d, FlgModelPart&) { d.parts = nullptr; }, "desc.parts is null");
    refused([](FlgModelDesc&, FlgModelPart& p) { p.part = {12345}; }, "desc.parts[0].part");
    refused([](FlgModelDesc&, FlgModelPart& p) { p.placement[5] = 2; }, "desc.parts[0].placement does more than");
    refused([](FlgModelDesc&, FlgModelPart& p) { p.placement[3] = NAN; }, "desc.parts[0].placement[3] is nan");
    refused([](FlgModelDesc&, FlgModelPart& p) { p.thickness = 0; }, "desc.parts[0].thickness is 0");
    refused([](FlgModelDesc&, FlgModelPart& p) { p.name = ""; }, "desc.parts[0].name has 0 bytes");
    const FlgBoneThresholds negative = thresholds(0, 0, -1, 0);
    refused([&](FlgModelDesc& d, FlgModelPart&) { d.thresholds = &negative; }, "desc.thresholds.prune is -1");
    refused([](FlgModelDesc& d, FlgModelPart&) { d.shape_weight = 1e9f; }, "desc.shape_weight");
    refused([](FlgModelDesc& d, FlgModelPart&) { d.mirror[0] = 0; }, "desc.mirror has a normal of no length");
    FlgModelPart twice[2] = {placed(part, "leg"), placed(part, "leg")};
    refused([&](FlgModelDesc& d, FlgModelPart&) { d.parts = twice, d.part_count = 2; },
            "desc.parts[1].name is \"leg\", as that of a part before");
    const std::string name(64, 'x');
    refused([&](FlgModelDesc&, FlgModelPart& p) { p.name = name.c_str(); }, "desc.parts[0].name has 64 bytes");
    // Only the job can know how many branches a part has.
    const float branches[5] = {};
    FlgModelPart one = placed(part, "one");
    one.branch_simplify = branches;
    one.branch_count = 5;
    FlgModelDesc desc = flgModelDefaults();
    desc.parts = &one;
    desc.part_count = 1;
    FlgModel model{};
    ASSERT_EQ(flgModelCreate(host.context, &desc, &model, nullptr), FLG_OK);
    host.finish();
    FlgModelView view = flgModelViewDefaults();
    EXPECT_EQ(flgModelGetView(host.context, model, &view), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgErrorGetMessage()).find("desc.parts[0].branch_count is 5"), std::string::npos)
        << flgErrorGetMessage();
}

TEST(Model, AFailedPartFailsItsModel) {
    const ModelHost host;
    const FlgPart part = host.part({0, 0, 4, 4, 4, 0, 0, 4});
    const FlgModelPart parts[] = {placed(part, "knot")};
    FlgModelDesc desc = flgModelDefaults();
    desc.parts = parts;
    desc.part_count = 1;
    FlgModel model{};
    ASSERT_EQ(flgModelCreate(host.context, &desc, &model, nullptr), FLG_OK);
    host.finish();
    FlgModelView view = flgModelViewDefaults();
    EXPECT_EQ(flgModelGetView(host.context, model, &view), FLG_ERROR_DEPENDENCY);
}

TEST(Model, OutOfMemoryNothingIsLost) {
    int64_t calls = 0;
    for (int64_t fail_at = -1; fail_at < calls; fail_at = fail_at < 0 ? 0 : fail_at + 1 + calls / 400) {
        HostAllocator allocator;
        {
            FlgContextDesc context_desc = flgContextDefaults();
            context_desc.worker_count = 0;
            context_desc.allocator = allocator.hook();
            FlgContext context{};
            ASSERT_EQ(flgContextCreate(&context_desc, &context), FLG_OK);
            const int64_t before = allocator.calls;
            allocator.fail_at = fail_at < 0 ? -1 : before + fail_at;
            const std::vector<double> points = capsule(0, 0, 4, 0, 1);
            FlgPartDesc part_desc = flgPartDefaults();
            FlgContourView drawn = flgContourViewDefaults();
            drawn.points = points.data();
            drawn.point_count = static_cast<uint32_t>(points.size() / 2);
            part_desc.contour = &drawn;
            FlgPart part{};
            FlgModel model{};
            bool failed = flgPartCreate(context, &part_desc, &part, nullptr) != FLG_OK;
            if (!failed) {
                FlgModelPart one = placed(part, "one");
                one.mirrored = 1;
                FlgModelDesc desc = flgModelDefaults();
                desc.parts = &one;
                desc.part_count = 1;
                failed = flgModelCreate(context, &desc, &model, nullptr) != FLG_OK;
                EXPECT_EQ(flgContextTick(context, FLG_UNLIMITED, nullptr), FLG_OK);
                FlgModelView view = flgModelViewDefaults();
                failed = failed || flgModelGetView(context, model, &view) != FLG_OK;
            }
            if (fail_at < 0) calls = allocator.calls - before;
            EXPECT_EQ(failed, fail_at >= 0) << fail_at;
            flgContextDestroy(context);
        }
        ASSERT_EQ(allocator.live_bytes.load(), 0) << fail_at;
    }
    EXPECT_GT(calls, 20);
}

}  // namespace
}  // namespace flg::test
