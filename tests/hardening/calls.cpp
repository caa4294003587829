// SPDX-License-Identifier: MIT
#include "hardening/calls.h"

#include <mutex>

namespace flg::test {

namespace {

std::mutex names_mutex;
std::set<std::string>& names() {
    static std::set<std::string> all;
    return all;
}

}  // namespace

std::set<std::string> called_functions() {
    const std::lock_guard lock(names_mutex);
    return names();
}

void Calls::note_call(const char* name) {
    const std::lock_guard lock(names_mutex);
    names().insert(name);
}

bool Calls::allows(FlgResult result) const {
    return std::find(allowed.begin(), allowed.end(), result) != allowed.end();
}

void Calls::end() {
    ended = true;
    outs_.clear();
    jobs_.clear();
    throw Ended();
}

void Calls::returned(const char* name, FlgResult result) {
    for (uint64_t* id : outs_) {
        EXPECT_NE(*id, unwritten) << name;
        EXPECT_EQ(*id != 0, result == FLG_OK) << name << ": " << flgResultGetName(result);
    }
    outs_.clear();
    if (meddler) meddler->after(name, result);
    if (result == FLG_OK) return;
    EXPECT_STRNE(flgErrorGetMessage(), "") << name;
    EXPECT_TRUE(allows(result)) << name << ": " << flgResultGetName(result) << ", " << flgErrorGetMessage();
    end();
}

void Calls::finish() {
    FlgFrameReport report{};
    do {
        if (before_tick) before_tick();
        report.struct_size = sizeof report;
        ++ticks;
        FLG_CALL(*this, flgContextTick, context, tick_budget_us, &report);
        FLG_VALUE(*this, flgContextWait, context, 1000u);
    } while (report.jobs_pending > 0);
    bool all_done = true;
    for (const FlgJob job : jobs_) {
        FlgJobStatus status{};
        status.struct_size = sizeof status;
        FLG_CALL(*this, flgJobGetStatus, context, job, &status);
        EXPECT_EQ(status.state, FLG_JOB_STATE_FINISHED);
        if (status.result != FLG_OK) {
            all_done = false;
            EXPECT_STRNE(status.error, "");
            const bool follows = status.result == FLG_ERROR_DEPENDENCY && !allowed.empty();
            EXPECT_TRUE(follows || allows(status.result)) << flgResultGetName(status.result) << ", " << status.error;
        } else {
            EXPECT_EQ(status.progress, 1.0f);
            EXPECT_STREQ(status.error, "");
            FlgStageTime stages[16];
            uint32_t count = 0;
            FLG_CALL(*this, flgJobGetStages, context, job, stages, 16u, &count);
            EXPECT_LE(count, 16u);
            FLG_CALL(*this, flgJobCancel, context, job);  // does nothing any more
        }
        FLG_CALL(*this, flgJobRelease, context, job);
    }
    jobs_.clear();
    if (!all_done) end();
}

void Calls::note(FlgCurveSet set) {
    FlgCurveSetView view = FLG_INIT(*this, flgCurveSetViewInit);
    FLG_CALL(*this, flgCurveSetGetView, context, set, &view);
    bits += flg::test::bits(view);
}

void Calls::note(FlgField field) {
    FlgFieldView view = FLG_INIT(*this, flgFieldViewInit);
    FLG_CALL(*this, flgFieldGetView, context, field, &view);
    bits += flg::test::bits(view);
}

void Calls::note(FlgSurfaceCurves curves) {
    FlgSurfaceCurvesView view = FLG_INIT(*this, flgSurfaceCurvesViewInit);
    FLG_CALL(*this, flgSurfaceCurvesGetView, context, curves, &view);
    bits += flg::test::bits(view);
}

void Calls::note(FlgSurface surface) {
    FlgSurfaceView view = FLG_INIT(*this, flgSurfaceViewInit);
    FLG_CALL(*this, flgSurfaceGetView, context, surface, &view);
    surface_bits.push_back(flg::test::bits(view));
    bits += surface_bits.back();
}

}  // namespace flg::test
