// SPDX-License-Identifier: MIT
// Who runs next, and what it costs to end many.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "runtime/busy.h"

namespace flg::test {
namespace {

constexpr uint32_t frame_us = 2000;

struct Turns : testing::Test {
    Turns() { desc.clock = clock.hook(); }

    // Each of its steps takes 100 us.
    std::shared_ptr<Job> submit_steps(Runtime& runtime, uint32_t steps, FlgPriority priority = FLG_PRIORITY_NORMAL,
                                      std::initializer_list<Prerequisite> prerequisites = {}) {
        struct Body {
            static Task<void> run(Pace& pace, ManualClock& clock, uint32_t count) {
                for (uint32_t i = 0; i < count; ++i) {
                    clock.now_ns += 100'000;
                    co_await pace;
                }
            }
        };
        return submit(
            runtime, [&](Pace& pace) { return Body::run(pace, clock, steps); }, priority, prerequisites);
    }
    static uint32_t frames_until_done(Runtime& runtime, const Job& job) {
        uint32_t frames = 0;
        while (job.status.state != FLG_JOB_STATE_FINISHED && frames < 10'000) {
            runtime.tick(frame_us);
            ++frames;
        }
        return frames;
    }

    ManualClock clock;
    CountingMemory memory;
    FlgContextDesc desc{};
};

TEST_F(Turns, AShortJobDoesNotWaitForALongOneOfItsPriority) {
    Runtime runtime(desc, &memory, memory.large_blocks);
    const auto ornament = submit_steps(runtime, 100'000);
    for (int i = 0; i < 10; ++i) runtime.tick(frame_us);
    for (int i = 0; i < 20; ++i) {
        const auto stroke = submit_steps(runtime, 15);
        EXPECT_LE(frames_until_done(runtime, *stroke), 2u);
    }
    EXPECT_EQ(ornament->status.state, FLG_JOB_STATE_RUNNING);
}

TEST_F(Turns, FourLongJobsTakeTurnsTheOthersWait) {
    Runtime runtime(desc, &memory, memory.large_blocks);
    std::vector<std::shared_ptr<Job>> jobs;
    for (int i = 0; i < 6; ++i) jobs.push_back(submit_steps(runtime, 500));
    // Each runs for 4 ms, in order; then the first four take turns.
    for (int i = 0; i < 60; ++i) runtime.tick(frame_us);
    float least = HUGE_VALF, most = 0;
    for (size_t i = 0; i < 4; ++i) {
        least = std::min(least, jobs[i]->status.busy_us);
        most = std::max(most, jobs[i]->status.busy_us);
    }
    EXPECT_GT(least, 15'000);
    EXPECT_LT(most - least, 2.1f * frame_us);
    for (size_t i = 4; i < 6; ++i) EXPECT_LT(jobs[i]->status.busy_us, 4'000 + 1.1f * frame_us);
    for (const auto& job : jobs) EXPECT_LT(frames_until_done(runtime, *job), 200u);
}

TEST_F(Turns, WhatAJobWaitsForHasItsPriority) {
    Runtime runtime(desc, &memory, memory.large_blocks);
    const auto low = submit_steps(runtime, 30, FLG_PRIORITY_LOW);
    const auto lower = submit_steps(runtime, 30, FLG_PRIORITY_LOW, {low});
    submit_steps(runtime, 100'000);
    runtime.tick(frame_us);
    const auto urgent = submit_steps(runtime, 10, FLG_PRIORITY_HIGH, {lower});
    EXPECT_LE(frames_until_done(runtime, *urgent), 5u);
    EXPECT_EQ(low->status.result, FLG_OK);
    EXPECT_EQ(lower->status.result, FLG_OK);
}

// None of these may take time that grows with the square of their number.
TEST_F(Turns, AHundredThousandJobsEndOneByOne) {
    constexpr uint32_t count = 100'000;
    {
        Runtime runtime(desc, &memory, memory.large_blocks);
        std::vector<std::shared_ptr<Job>> jobs;
        for (uint32_t i = 0; i < count; ++i) jobs.push_back(submit_steps(runtime, 1));
        for (uint32_t i = count; i-- > count / 2;) runtime.scheduler().cancel(*jobs[i]);
        runtime.tick(FLG_UNLIMITED);
        for (uint32_t i = 0; i < count; ++i) {
            ASSERT_EQ(jobs[i]->status.result, i < count / 2 ? FLG_OK : FLG_ERROR_CANCELLED) << i;
        }
        for (uint32_t i = 0; i < count; ++i) submit_steps(runtime, 1);
    }
    EXPECT_EQ(memory.live, 0);
}

TEST_F(Turns, AFailureIsToldToManyInSlices) {
    constexpr uint32_t count = 10'000;
    clock.step_ns = 20'000;  // a slice a look
    Runtime runtime(desc, &memory, memory.large_blocks);
    const auto first = submit_steps(runtime, 1);
    std::vector<std::shared_ptr<Job>> dependents;
    for (uint32_t i = 0; i < count; ++i) dependents.push_back(submit_steps(runtime, 1, FLG_PRIORITY_NORMAL, {first}));
    runtime.scheduler().cancel(*first);
    uint32_t frames = 0;
    while (runtime.tick(100).jobs_pending > 0) ++frames;
    EXPECT_GT(frames, 20u);
    for (const auto& job : dependents) ASSERT_EQ(job->status.result, FLG_ERROR_DEPENDENCY);
}

// Jobs that end with the context while others are still to be told.
TEST_F(Turns, WhoIsNotToldIsFreedWithTheContext) {
    {
        Runtime runtime(desc, &memory, memory.large_blocks);
        const auto first = submit_steps(runtime, 1);
        for (int i = 0; i < 1000; ++i) submit_steps(runtime, 1, FLG_PRIORITY_NORMAL, {first});
        runtime.scheduler().cancel(*first);
    }
    EXPECT_EQ(memory.live, 0);
}

}  // namespace
}  // namespace flg::test
