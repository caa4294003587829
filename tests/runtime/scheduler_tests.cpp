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
                                      std::initializer_list<Prerequisite> prerequisites = {},
                                      uint32_t deadline_us = 0) {
        struct Body {
            static Task<void> run(Pace& pace, ManualClock& clock, uint32_t count) {
                pace.expect(count);
                for (uint32_t i = 0; i < count; ++i) {
                    clock.now_ns += 100'000;
                    pace.advance(1);
                    co_await pace;
                }
            }
        };
        return submit(
            runtime, [&](Pace& pace) { return Body::run(pace, clock, steps); }, priority, prerequisites,
            deadline_us == 0 ? UINT64_MAX : clock.now_ns + uint64_t{1000} * deadline_us);
    }
    std::shared_ptr<Job> submit_wanted(Runtime& runtime, uint32_t steps, uint32_t deadline_us,
                                       std::initializer_list<Prerequisite> prerequisites = {}) {
        return submit_steps(runtime, steps, FLG_PRIORITY_NORMAL, prerequisites, deadline_us);
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

TEST_F(Turns, DeadlinesComeFirstTheNearestBeforeTheOthers) {
    Runtime runtime(desc, &memory, memory.large_blocks);
    submit_steps(runtime, 100'000);
    const auto short_one = submit_steps(runtime, 10);
    const auto later = submit_wanted(runtime, 30, 50'000), sooner = submit_wanted(runtime, 30, 10'000);
    EXPECT_LE(frames_until_done(runtime, *sooner), 2u);
    EXPECT_LE(later->status.busy_us, 1'100);
    EXPECT_LE(frames_until_done(runtime, *later), 3u);
    EXPECT_EQ(short_one->status.state, FLG_JOB_STATE_WAITING);
    EXPECT_EQ(later->status.late_us, 0);
    EXPECT_EQ(sooner->status.late_us, 0);
}

// 20 ms of work that is wanted in 30 ms has to go on at once where it has 1 ms left in 12 ms; but not later on.
TEST_F(Turns, WhatIsLeftCountsAgainstADeadline) {
    Runtime runtime(desc, &memory, memory.large_blocks);
    const auto large = submit_wanted(runtime, 200, 30'000);
    runtime.tick(frame_us);
    EXPECT_NEAR(large->status.remaining_us, 18'000, 200);
    const auto small = submit_wanted(runtime, 10, 14'000);
    runtime.tick(frame_us);
    EXPECT_EQ(small->status.state, FLG_JOB_STATE_WAITING);
    EXPECT_LE(frames_until_done(runtime, *small), 4u);
    EXPECT_EQ(large->status.state, FLG_JOB_STATE_RUNNING);
    frames_until_done(runtime, *large);
    EXPECT_EQ(small->status.late_us, 0);
    EXPECT_EQ(large->status.late_us, 0);
    EXPECT_EQ(large->status.remaining_us, 0);
}

// Jobs that do not tell their share take what the last ones of their kind took, also before they begin.
TEST_F(Turns, WorkThatIsLeftIsThatOfTheLastJobsOfAKind) {
    struct Body {
        static Task<void> run(Pace& pace, ManualClock& clock, uint32_t count) {
            for (uint32_t i = 0; i < count; ++i) {
                clock.now_ns += 100'000;
                co_await pace;
            }
        }
        static Task<void> run_of_another_kind(Pace& pace, ManualClock& clock, uint32_t count) {
            co_await run(pace, clock, count);
        }
    };
    Runtime runtime(desc, &memory, memory.large_blocks);
    const auto start = [&](uint32_t steps, bool is_other = false) {
        auto job = runtime.scheduler().make_job(&memory);
        Pace& pace = job->strand.pace;
        job->strand.start(is_other ? Body::run_of_another_kind(pace, clock, steps) : Body::run(pace, clock, steps));
        runtime.scheduler().submit(job, std::pmr::vector<Prerequisite>(&memory));
        return job;
    };
    const auto status_of = [&](const std::shared_ptr<Job>& job) {
        FlgJobStatus status = job->status;
        runtime.scheduler().fill_wait(*job, status);
        return status;
    };
    const auto first = start(60);
    EXPECT_LT(status_of(first).remaining_us, 0);
    frames_until_done(runtime, *first);
    EXPECT_EQ(status_of(first).remaining_us, 0);
    const auto second = start(60), other = start(60, true);
    EXPECT_NEAR(status_of(second).remaining_us, 6'000, 100);
    EXPECT_LT(status_of(other).remaining_us, 0);
    runtime.tick(frame_us);
    EXPECT_NEAR(status_of(second).remaining_us, 4'000, 200);
    frames_until_done(runtime, *second);
    frames_until_done(runtime, *other);
    // The mean follows: a quarter of each.
    frames_until_done(runtime, *start(20));
    EXPECT_NEAR(status_of(start(1)).remaining_us, 5'000, 100);
}

TEST_F(Turns, WhatAJobWaitsForHasItsDeadline) {
    Runtime runtime(desc, &memory, memory.large_blocks);
    for (int i = 0; i < 5; ++i) submit_steps(runtime, 100'000);
    const auto first = submit_steps(runtime, 30), second = submit_steps(runtime, 30, FLG_PRIORITY_NORMAL, {first});
    const auto wanted = submit_wanted(runtime, 10, 10'000, {second});
    EXPECT_LE(frames_until_done(runtime, *wanted), 4u);
    EXPECT_EQ(wanted->status.late_us, 0);
    // Of higher priority all the same.
    const auto high = submit_steps(runtime, 10, FLG_PRIORITY_HIGH);
    const auto late = submit_wanted(runtime, 100, 1000);
    EXPECT_EQ(frames_until_done(runtime, *high), 1u);
    EXPECT_NE(late->status.state, FLG_JOB_STATE_FINISHED);
}

TEST_F(Turns, MissedDeadlinesAreCountedOnceAndTheJobGoesOn) {
    Runtime runtime(desc, &memory, memory.large_blocks);
    const auto job = submit_wanted(runtime, 100, 5'000);
    uint32_t late = 0;
    for (int i = 0; i < 10; ++i) {
        late += runtime.tick(frame_us).jobs_late;
        if (job->status.state != FLG_JOB_STATE_FINISHED) {
            EXPECT_NEAR(job->status.late_us, std::max(0, 2000 * i - 5000), 2100) << i;
        }
    }
    EXPECT_EQ(late, 1u);
    EXPECT_EQ(job->status.result, FLG_OK);
    EXPECT_NEAR(job->status.late_us, 5'000, 2'200);
}

// None of these may take time that grows with the square of their number.
TEST_F(Turns, AHundredThousandDeadlinesAreKeptInTheirOrderWhateverIsCancelled) {
    constexpr uint32_t count = 100'000;
    Runtime runtime(desc, &memory, memory.large_blocks);
    struct Body {
        static Task<void> run(Pace&, std::vector<uint32_t>& order, uint32_t number) {
            order.push_back(number);
            co_return;
        }
    };
    const auto deadline = [&](uint32_t i) { return uint64_t{1'000'000'000} + uint64_t{i} * 70'001 % 99'991; };
    std::vector<uint32_t> order, expected;
    std::vector<std::shared_ptr<Job>> jobs;
    for (uint32_t i = 0; i < count; ++i) {
        jobs.push_back(submit(
            runtime, [&](Pace& pace) { return Body::run(pace, order, i); }, FLG_PRIORITY_NORMAL, {}, deadline(i)));
    }
    for (uint32_t i = 0; i < count; ++i) {
        if (i % 3 == 1) {
            runtime.scheduler().cancel(*jobs[i]);
        } else {
            expected.push_back(i);
        }
    }
    std::sort(expected.begin(), expected.end(),
              [&](uint32_t a, uint32_t b) { return std::pair(deadline(a), a) < std::pair(deadline(b), b); });
    runtime.tick(FLG_UNLIMITED);
    EXPECT_TRUE(order == expected);
    for (uint32_t i = 0; i < count; ++i) ASSERT_EQ(jobs[i]->status.result, i % 3 == 1 ? FLG_ERROR_CANCELLED : FLG_OK);
}

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
