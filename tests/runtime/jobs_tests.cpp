// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "runtime/busy.h"

namespace flg::test {
namespace {

struct WithoutWorkers : testing::Test {
    static FlgContextDesc desc(ManualClock& clock) {
        FlgContextDesc d{};
        d.clock = clock.hook();
        return d;
    }
    ManualClock clock;
    CountingMemory memory;
};

TEST_F(WithoutWorkers, TickStopsAtItsBudgetAndGoesOnNextTime) {
    clock.step_ns = 1000;  // each look at the clock costs a microsecond
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    uint64_t sum = 0;
    const auto job = submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 1000, 1, &sum); });
    const FlgFrameReport first = runtime.tick(100);
    EXPECT_EQ(first.jobs_pending, 1u);
    EXPECT_GE(first.tick_us, 90.0f);
    EXPECT_LE(first.tick_us, 115.0f);
    int ticks = 1;
    while (runtime.tick(100).jobs_pending > 0) ++ticks;
    EXPECT_GE(ticks, 8);
    EXPECT_EQ(sum, expected_hash_sum(1000));
    EXPECT_EQ(job->status.result, FLG_OK);
}

// A slow clock or a slow callback takes all of a small budget, in every frame.
TEST_F(WithoutWorkers, ABudgetThatIsSpentBeforeTheWorkStillAdvancesIt) {
    clock.step_ns = 10'000;
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    uint64_t sum = 0;
    const auto job = submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 100, 1, &sum); });
    int ticks = 1;
    while (runtime.tick(1).jobs_pending > 0 && ticks < 200) ++ticks;
    EXPECT_LT(ticks, 200);
    EXPECT_EQ(sum, expected_hash_sum(100));
    EXPECT_EQ(job->status.result, FLG_OK);
}

// What is left of a frame may be nothing.
TEST_F(WithoutWorkers, ABudgetOfZeroAdvancesNothing) {
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    uint64_t sum = 0;
    const auto job = submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 10, 1, &sum); });
    for (int i = 0; i < 100; ++i) EXPECT_EQ(runtime.tick(0).jobs_pending, 1u);
    EXPECT_EQ(sum, 0u);
    runtime.tick(FLG_UNLIMITED);
    EXPECT_EQ(sum, expected_hash_sum(10));
    EXPECT_EQ(job->status.result, FLG_OK);
}

TEST_F(WithoutWorkers, ProgressRisesAndIsOneExactlyWhenDone) {
    clock.step_ns = 1000;
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    uint64_t sum = 0;
    const auto job = submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 500, 1, &sum); });
    float last = 0;
    for (;;) {
        const bool done = runtime.tick(50).jobs_pending == 0;
        EXPECT_GE(job->status.progress, last);
        last = job->status.progress;
        if (done) break;
        EXPECT_LT(last, 1.0f);
        EXPECT_EQ(job->status.state, FLG_JOB_STATE_RUNNING);
        EXPECT_STREQ(job->status.stage, "hash");
    }
    EXPECT_EQ(last, 1.0f);
}

Task<void> add_one(Pace& pace, uint64_t& sum) {
    ++sum;
    co_await pace;
}

Task<void> add_ones(Pace& pace, uint32_t count, uint64_t& sum) {
    for (uint32_t i = 0; i < count; ++i) co_await add_one(pace, sum);
}

// Without tail calls (unoptimized code, thread sanitizer) each task that was awaited in a slice keeps its frame.
TEST_F(WithoutWorkers, ATickWithoutABudgetNeedsABoundedStack) {
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    uint64_t sum = 0;
    submit(runtime, [&](Pace& pace) { return add_ones(pace, 1'000'000, sum); });
    EXPECT_EQ(runtime.tick(FLG_UNLIMITED).jobs_pending, 0u);
    EXPECT_EQ(sum, 1'000'000u);
}

TEST_F(WithoutWorkers, HigherPriorityRunsFirstEqualsInOrder) {
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    std::vector<int> order;
    const auto note = [&order](Pace& pace, int id) -> Task<void> {
        struct Body {
            static Task<void> run(Pace& p, std::vector<int>& out, int value) {
                co_await p;
                out.push_back(value);
            }
        };
        return Body::run(pace, order, id);
    };
    submit(
        runtime, [&](Pace& pace) { return note(pace, 1); }, FLG_PRIORITY_LOW);
    submit(runtime, [&](Pace& pace) { return note(pace, 2); });
    submit(
        runtime, [&](Pace& pace) { return note(pace, 3); }, FLG_PRIORITY_HIGH);
    submit(runtime, [&](Pace& pace) { return note(pace, 4); });
    runtime.tick(FLG_UNLIMITED);
    EXPECT_EQ(order, (std::vector<int>{3, 2, 4, 1}));
}

TEST_F(WithoutWorkers, DependentsWaitAndFailWithTheirDependencies) {
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    struct Body {
        static Task<void> fail(Pace& pace) {
            co_await pace;
            throw Failure(FLG_ERROR_LIMIT, "too many %s", "things");
        }
    };
    uint64_t never = 0;
    const auto failing = submit(
        runtime, [&](Pace& pace) { return Body::fail(pace); }, FLG_PRIORITY_LOW);
    const auto after =
        submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 10, 1, &never); }, FLG_PRIORITY_HIGH, {failing});
    const auto last =
        submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 10, 1, &never); }, FLG_PRIORITY_HIGH, {after});
    runtime.tick(FLG_UNLIMITED);
    EXPECT_EQ(failing->status.result, FLG_ERROR_LIMIT);
    EXPECT_STREQ(failing->status.error, "too many things");
    EXPECT_EQ(after->status.result, FLG_ERROR_DEPENDENCY);
    EXPECT_STREQ(last->status.error, "a job it depends on failed: too many things");
    EXPECT_EQ(never, 0u);
    // One submitted after the failure fails as well.
    const auto late =
        submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 10, 1, &never); }, FLG_PRIORITY_HIGH, {failing});
    runtime.tick(FLG_UNLIMITED);
    EXPECT_EQ(late->status.result, FLG_ERROR_DEPENDENCY);
}

TEST_F(WithoutWorkers, JobsThatWaitForOrderOnlyRunAfterAFailure) {
    clock.step_ns = 1000;
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    uint64_t never = 0, sum = 0;
    const auto failing = submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 1000, 1, &never); });
    const auto ordered = submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 10, 1, &sum); },
                                FLG_PRIORITY_HIGH, {{failing, true}});
    const auto dependent =
        submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 10, 1, &never); }, FLG_PRIORITY_HIGH, {failing});
    runtime.tick(50);
    EXPECT_EQ(ordered->status.state, FLG_JOB_STATE_WAITING);
    runtime.scheduler().cancel(*failing);
    const auto late = submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 10, 1, &sum); }, FLG_PRIORITY_HIGH,
                             {{failing, true}});
    runtime.tick(FLG_UNLIMITED);
    EXPECT_EQ(failing->status.result, FLG_ERROR_CANCELLED);
    EXPECT_EQ(ordered->status.result, FLG_OK);
    EXPECT_EQ(late->status.result, FLG_OK);
    EXPECT_EQ(dependent->status.result, FLG_ERROR_DEPENDENCY);
    EXPECT_EQ(sum, expected_hash_sum(10));
    EXPECT_EQ(never, 0u);
}

TEST_F(WithoutWorkers, ACommittedJobGoesOnAlthoughCancelledButNotBeyondTheContext) {
    struct Body {
        static Task<void> run(Pace& pace, int steps, int* done) {
            co_await pace;
            pace.commit();
            for (; *done < steps; ++*done) co_await pace;
        }
    };
    clock.step_ns = 1000;
    int whole = 0, cut_off = 0;
    {
        Runtime runtime(desc(clock), &memory, memory.large_blocks);
        const auto job = submit(runtime, [&](Pace& pace) { return Body::run(pace, 1000, &whole); });
        runtime.tick(50);
        ASSERT_GT(whole, 0);
        runtime.scheduler().cancel(*job);
        runtime.tick(FLG_UNLIMITED);
        EXPECT_EQ(job->status.result, FLG_OK);
        EXPECT_EQ(whole, 1000);
        submit(runtime, [&](Pace& pace) { return Body::run(pace, 1000, &cut_off); });
        runtime.tick(50);
    }
    EXPECT_GT(cut_off, 0);
    EXPECT_LT(cut_off, 1000);
    EXPECT_EQ(memory.live, 0);
}

TEST_F(WithoutWorkers, LongChainsOfDependentsFailWithoutRecursion) {
    {
        Runtime runtime(desc(clock), &memory, memory.large_blocks);
        uint64_t never = 0;
        std::shared_ptr<Job> first = submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 10, 1, &never); });
        std::shared_ptr<Job> last = first;
        for (int i = 0; i < 20'000; ++i) {
            last = submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 10, 1, &never); }, FLG_PRIORITY_NORMAL,
                          {last});
        }
        runtime.scheduler().cancel(*first);
        runtime.tick(FLG_UNLIMITED);
        EXPECT_EQ(last->status.result, FLG_ERROR_DEPENDENCY);
        EXPECT_EQ(never, 0u);
    }
    EXPECT_EQ(memory.live, 0);
}

TEST_F(WithoutWorkers, TheSameDependencyManyTimesIsOne) {
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    uint64_t sum = 0, after = 0;
    const auto first = submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 10, 1, &sum); });
    const auto second =
        submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 10, 1, &after); }, FLG_PRIORITY_HIGH,
               {first, first, first, first, first, first, first, first, first, first});
    runtime.tick(FLG_UNLIMITED);
    EXPECT_EQ(second->status.result, FLG_OK);
    EXPECT_EQ(after, sum);
}

TEST_F(WithoutWorkers, MemoryThatRunsOutInSubmitLeavesNoTrace) {
    for (int64_t fail = 0; fail < 4; ++fail) {
        {
            Runtime runtime(desc(clock), &memory, memory.large_blocks);
            uint64_t sum = 0, never = 0;
            const auto first = submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 10, 1, &sum); });
            std::shared_ptr<Job> job = runtime.scheduler().make_job(runtime.memory());
            job->strand.start(store_hash_sum(job->strand.pace, 10, 1, &never));
            const std::pmr::vector<Prerequisite> dependencies(9, Prerequisite(first), std::pmr::new_delete_resource());
            memory.fail_at = memory.calls + fail;
            bool failed = false;
            try {
                runtime.scheduler().submit(job, dependencies);
            } catch (const std::bad_alloc&) {
                failed = true;
            }
            memory.fail_at = -1;
            job.reset();
            runtime.tick(FLG_UNLIMITED);
            EXPECT_EQ(sum, expected_hash_sum(10));
            EXPECT_EQ(never, failed ? 0 : expected_hash_sum(10));
        }
        EXPECT_EQ(memory.live, 0);
    }
}

TEST_F(WithoutWorkers, ACancelledJobDoesNotWaitItsTurn) {
    clock.step_ns = 1000;
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    struct Body {
        static Task<void> run(Pace& pace) {
            for (;;) co_await pace;
        }
    };
    const auto low = submit(
        runtime, [&](Pace& pace) { return Body::run(pace); }, FLG_PRIORITY_LOW);
    const auto low_too = submit(
        runtime, [&](Pace& pace) { return Body::run(pace); }, FLG_PRIORITY_LOW);
    submit(
        runtime, [&](Pace& pace) { return Body::run(pace); }, FLG_PRIORITY_HIGH);
    runtime.tick(50);
    runtime.scheduler().cancel(*low_too);
    runtime.scheduler().cancel(*low);
    runtime.tick(50);
    runtime.tick(50);
    EXPECT_EQ(low->status.result, FLG_ERROR_CANCELLED);
    EXPECT_EQ(low_too->status.result, FLG_ERROR_CANCELLED);
}

TEST_F(WithoutWorkers, PublishedInOrderOfSubmissionAndOnlyInTicks) {
    FlgContextDesc d = desc(clock);
    Runtime runtime(d, &memory, memory.large_blocks);
    std::vector<uint64_t> order;
    std::vector<std::shared_ptr<Job>> jobs;
    uint64_t sums[4];
    for (uint64_t& sum : sums) {
        const auto job = runtime.scheduler().make_job(runtime.memory());
        job->priority = &sum == &sums[3] ? FLG_PRIORITY_HIGH : FLG_PRIORITY_NORMAL;
        job->user_data = &order;
        job->handle = {jobs.size()};
        job->on_finished = [](void* user, FlgJob handle, FlgResult) {
            static_cast<std::vector<uint64_t>*>(user)->push_back(handle.id);
        };
        job->strand.start(store_hash_sum(job->strand.pace, 4, 2, &sum));
        runtime.scheduler().submit(job, std::pmr::vector<Prerequisite>(&memory));
        jobs.push_back(job);
    }
    while (runtime.scheduler().run_next(UINT64_MAX)) {}
    for (const auto& job : jobs) EXPECT_EQ(job->status.state, FLG_JOB_STATE_WAITING);
    EXPECT_TRUE(order.empty());
    runtime.tick(FLG_UNLIMITED);
    EXPECT_EQ(order, (std::vector<uint64_t>{0, 1, 2, 3}));
}

TEST_F(WithoutWorkers, ABudgetOfCallbacksIsKept) {
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    uint64_t sums[5];
    for (uint64_t& sum : sums) {
        const auto job = runtime.scheduler().make_job(runtime.memory());
        job->user_data = &clock;
        job->on_finished = [](void* user, FlgJob, FlgResult) { static_cast<ManualClock*>(user)->now_ns += 60'000; };
        job->strand.start(store_hash_sum(job->strand.pace, 4, 4, &sum));
        runtime.scheduler().submit(job, std::pmr::vector<Prerequisite>(&memory));
    }
    while (runtime.scheduler().run_next(UINT64_MAX)) {}
    EXPECT_EQ(runtime.tick(100).jobs_finished, 2u);
    EXPECT_EQ(runtime.tick(10).jobs_finished, 1u);
    const FlgFrameReport rest = runtime.tick(FLG_UNLIMITED);
    EXPECT_EQ(rest.jobs_finished, 2u);
    EXPECT_NEAR(rest.callback_us, 120.0f, 1.0f);
}

TEST_F(WithoutWorkers, TheLongestChunkIsNamed) {
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    struct Body {
        static Task<void> run(Pace& pace, ManualClock& time) {
            pace.stage("short");
            time.now_ns += 20'000;
            co_await pace;
            pace.stage("long");
            time.now_ns += 70'000;
            co_await pace;
        }
    };
    const auto job = submit(runtime, [&](Pace& pace) { return Body::run(pace, clock); });
    const FlgFrameReport report = runtime.tick(FLG_UNLIMITED);
    EXPECT_NEAR(report.max_slice_us, 70.0f, 0.1f);
    EXPECT_STREQ(report.max_slice_stage, "long");
    ASSERT_EQ(job->stage_count, 2u);
    EXPECT_EQ(job->stages[0].busy_end_ns - job->stages[0].busy_start_ns, 20'000u);
    EXPECT_EQ(job->stages[1].busy_end_ns - job->stages[1].busy_start_ns, 70'000u);
    EXPECT_EQ(runtime.tick(FLG_UNLIMITED).max_slice_us, 0.0f);
}

TEST_F(WithoutWorkers, AChunkBeforeTheFirstStageIsNamedToo) {
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    struct Body {
        static Task<void> run(Pace& pace, ManualClock& time) {
            time.now_ns += 70'000;
            pace.stage("short");
            time.now_ns += 20'000;
            co_await pace;
        }
    };
    submit(runtime, [&](Pace& pace) { return Body::run(pace, clock); });
    const FlgFrameReport report = runtime.tick(FLG_UNLIMITED);
    EXPECT_NEAR(report.max_slice_us, 70.0f, 0.1f);
    EXPECT_STREQ(report.max_slice_stage, "start");
}

TEST_F(WithoutWorkers, CancelledJobsFreeWhatTheyHold) {
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    clock.step_ns = 1000;
    struct Body {
        static Task<void> run(Pace& pace) {
            std::pmr::vector<char> held(1 << 20, pace.memory());
            for (;;) co_await pace;
        }
    };
    const auto job = submit(runtime, [&](Pace& pace) { return Body::run(pace); });
    runtime.tick(100);
    EXPECT_GT(memory.live, 1 << 20);
    runtime.scheduler().cancel(*job);
    runtime.tick(100);
    EXPECT_EQ(job->status.result, FLG_ERROR_CANCELLED);
    EXPECT_LT(memory.live, 1 << 16);
    runtime.scheduler().cancel(*job);
    EXPECT_EQ(job->status.result, FLG_ERROR_CANCELLED);
}

TEST_F(WithoutWorkers, TicksAllocateNothingInSteadyState) {
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    clock.step_ns = 1000;
    uint64_t sum;
    const auto job = submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 100'000, 1, &sum); });
    runtime.tick(100);
    const int64_t before = memory.calls;
    for (int i = 0; i < 100; ++i) runtime.tick(100);
    EXPECT_EQ(memory.calls, before);
    EXPECT_EQ(job->status.state, FLG_JOB_STATE_RUNNING);
}

TEST_F(WithoutWorkers, MemoryThatRunsOutFailsTheJobAndNothingElse) {
    Runtime runtime(desc(clock), &memory, memory.large_blocks);
    struct Body {
        static Task<void> run(Pace& pace) {
            std::pmr::vector<char> taken(100, pace.memory());
            co_await pace;
        }
    };
    const auto job = submit(runtime, [&](Pace& pace) { return Body::run(pace); });
    memory.fail_at = memory.calls.load();
    runtime.tick(FLG_UNLIMITED);
    EXPECT_EQ(job->status.result, FLG_ERROR_OUT_OF_MEMORY);
    uint64_t sum = 0;
    submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 10, 1, &sum); });
    runtime.tick(FLG_UNLIMITED);
    EXPECT_EQ(sum, expected_hash_sum(10));
}

}  // namespace
}  // namespace flg::test
