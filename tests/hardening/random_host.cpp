// SPDX-License-Identifier: MIT
#include "hardening/random_host.h"

namespace flg::test {

namespace {

// All that the headers say of calls and jobs, but for what means that something is wrong here.
bool is_documented(FlgResult result, const char* sentence) {
    switch (result) {
        // Of skeletons it is: one point 1e30 away from all others can be too much.
        case FLG_ERROR_INTERNAL: return std::strstr(sentence, "no skeleton was found") != nullptr;
        case FLG_OK:
        case FLG_NOT_READY:
        case FLG_ERROR_INVALID_ARGUMENT:
        case FLG_ERROR_INVALID_HANDLE:
        case FLG_ERROR_CANCELLED:
        case FLG_ERROR_DEPENDENCY:
        case FLG_ERROR_FORMAT:
        case FLG_ERROR_LIMIT: return true;
        default: return false;
    }
}

}  // namespace

RandomHost::RandomHost(uint64_t seed, uint32_t workers) : random_(seed) {
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = workers;
    desc.worker_budget_us = chance(3) ? 200 : 0;
    desc.allocator = ledger_.hook();
    EXPECT_EQ(flgContextCreate(&desc, &context), FLG_OK) << flgErrorGetMessage();
    Curves curves = arcs(2, 15);
    const FlgCurveSetView view = curves.view();
    EXPECT_EQ(flgCurveSetCreate(context, &view, &quiet_), FLG_OK) << flgErrorGetMessage();
}

// With whatever is still going on.
RandomHost::~RandomHost() {
    EXPECT_EQ(flgContextDestroy(context), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(ledger_.live_bytes, 0);
    EXPECT_EQ(ledger_.wrong_frees, 0);
}

const FlgJobOptions* RandomHost::options() {
    static thread_local FlgJobOptions options;
    options = flgJobOptionsDefaults();
    if (chance(60)) options.struct_size = draw(16);
    if (chance(8)) options.priority = static_cast<FlgPriority>(static_cast<int>(draw(5)) - 2);
    options.partial_results = chance(6);
    if (!chance(20)) return &options;
    static thread_local FlgJob dependency;
    dependency = any<FlgJob>(job);
    options.dependencies = maybe(&dependency);
    options.dependency_count = 1;
    return &options;
}

void RandomHost::returned(FlgResult result) {
    ++results[result];
    EXPECT_TRUE(is_documented(result, flgErrorGetMessage()))
        << flgResultGetName(result) << ", " << flgErrorGetMessage();
    for (const Output& output : outputs_) {
        if (result == FLG_OK) {
            EXPECT_NE(output.id, ~uint64_t{0}) << "an output was not written";
            if (output.id != 0 && output.id != ~uint64_t{0}) pools_[output.kind].push_back(output.id);
        } else {
            EXPECT_EQ(output.id, 0u) << flgErrorGetMessage();
        }
    }
    outputs_.clear();
    if (result < 0) {
        EXPECT_STRNE(flgErrorGetMessage(), "");
        EXPECT_STRNE(flgErrorGetMessage(), "no error");
    }
}

std::string RandomHost::quiet_bits() {
    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    desc.curves = quiet_;
    desc.spacing = 0.3f;
    FlgCurveSet made{};
    FlgJob under_way{};
    EXPECT_EQ(flgCurveSetResample(context, &desc, &made, &under_way), FLG_OK) << flgErrorGetMessage();
    FlgJobStatus status{};
    status.struct_size = sizeof status;
    do {
        EXPECT_EQ(flgContextTick(context, 500, nullptr), FLG_OK) << flgErrorGetMessage();
        flgContextWait(context, 500);
        EXPECT_EQ(flgJobGetStatus(context, under_way, &status), FLG_OK) << flgErrorGetMessage();
    } while (status.state != FLG_JOB_STATE_FINISHED && !testing::Test::HasFailure());
    FlgCurveSetView view = flgCurveSetViewDefaults();
    if (testing::Test::HasFailure()) return {};
    EXPECT_EQ(flgCurveSetGetView(context, made, &view), FLG_OK) << flgErrorGetMessage();
    std::string all = view.curve_offsets ? bits(view) : "";
    EXPECT_EQ(flgCurveSetRelease(context, made), FLG_OK);
    EXPECT_EQ(flgJobRelease(context, under_way), FLG_OK);
    return all;
}

void RandomHost::step() {
    using Step = void (RandomHost::*)();
    static constexpr Step steps[] = {&RandomHost::tick,        &RandomHost::tick,           &RandomHost::tick,
                                     &RandomHost::ask_jobs,    &RandomHost::release_any,    &RandomHost::make_curves,
                                     &RandomHost::resample,    &RandomHost::simplify,       &RandomHost::make_style,
                                     &RandomHost::keep_style,  &RandomHost::stylize,        &RandomHost::draw_live,
                                     &RandomHost::end_live,    &RandomHost::make_surface,   &RandomHost::measure,
                                     &RandomHost::measure,     &RandomHost::trace,          &RandomHost::cut,
                                     &RandomHost::trace,       &RandomHost::divide_tangle,  &RandomHost::divide_tangle,
                                     &RandomHost::edit_tangle, &RandomHost::replay_tangle,  &RandomHost::make_manifold,
                                     &RandomHost::fit_spline,  &RandomHost::make_obstacles, &RandomHost::move_body,
                                     &RandomHost::sketch,      &RandomHost::make_model,     &RandomHost::change_surface,
                                     &RandomHost::look};
    (this->*steps[draw(std::size(steps))])();
}

void RandomHost::tick() {
    FlgFrameReport report{};
    report.struct_size = chance(40) ? draw(8) : static_cast<uint32_t>(sizeof report);
    const uint32_t budgets[] = {0, 20, 100, 500, FLG_UNLIMITED};
    const FlgContext on = at();
    returned(flgContextTick(on, budgets[draw(5)], maybe(&report)));
    if (chance(3)) returned(flgContextWait(on, draw(200)));
}

void RandomHost::ask_jobs() {
    const FlgJob asked = any<FlgJob>(job);
    FlgJobStatus status{};
    status.struct_size = sizeof status;
    odd(status);
    const FlgResult result = flgJobGetStatus(at(), asked, maybe(&status));
    returned(result);
    if (result == FLG_OK && status.struct_size == sizeof status) {
        EXPECT_TRUE(is_documented(status.result, status.error))
            << flgResultGetName(status.result) << ", " << status.error;
        EXPECT_TRUE(status.progress >= 0 && status.progress <= 1);
        EXPECT_EQ(*status.error != '\0', status.result < 0);
    }
    FlgStageTime stages[16];
    uint32_t count = 0;
    if (chance(3)) returned(flgJobGetStages(at(), asked, maybe(stages), draw(17), maybe(&count)));
    if (chance(4)) returned(flgJobCancel(at(), asked));
    if (chance(4)) returned(flgJobRelease(at(), asked));
}

void RandomHost::release_any() {
    switch (static_cast<Kind>(draw(kind_count))) {
        case job: return release(flgJobRelease, job);
        case curve_set: return release(flgCurveSetRelease, curve_set);
        case style: return release(flgStyleRelease, style);
        case live_stroke: return release(flgLiveStrokeRelease, live_stroke);
        case surface: return release(flgSurfaceRelease, surface);
        case field: return release(flgFieldRelease, field);
        case surface_curves: return release(flgSurfaceCurvesRelease, surface_curves);
        case tangle: return release(flgTangleRelease, tangle);
        case manifold: return release(flgManifoldRelease, manifold);
        case spline: return release(flgSplineRelease, spline);
        case obstacles: return release(flgObstaclesRelease, obstacles);
        case motion: return release(flgMotionRelease, motion);
        case skeleton: return release(flgStraightSkeletonRelease, skeleton);
        case outline: return release(flgOutlineRelease, outline);
        case part: return release(flgPartRelease, part);
        case part_mesh: return release(flgPartMeshRelease, part_mesh);
        case model: return release(flgModelRelease, model);
        case skin: return release(flgSkinRelease, skin);
        case kind_count: break;
    }
}

}  // namespace flg::test
