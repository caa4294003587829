// SPDX-License-Identifier: MIT
// The three ways to run give the same results; nothing is lost when jobs are cancelled at random.
#include <gtest/gtest.h>

#include <ctime>
#include <deque>
#include <mutex>
#include <thread>

#include "runtime/busy.h"

namespace flg::test {
namespace {

// A host's job system: some threads and a queue.
class Pool {
public:
    explicit Pool(uint32_t threads) {
        for (uint32_t i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
    }
    ~Pool() {
        {
            std::lock_guard lock(mutex_);
            stop_ = true;
        }
        wake_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }
    // Valid until asked for again.
    const FlgJobSystem* hook(uint32_t concurrency) {
        hook_ = {sizeof hook_, concurrency, this, [](void* self, void (*run)(void*), void* task) {
                     auto& pool = *static_cast<Pool*>(self);
                     {
                         std::lock_guard lock(pool.mutex_);
                         pool.queue_.push_back({run, task});
                         pool.max_queued_ = std::max(pool.max_queued_, pool.queue_.size());
                     }
                     pool.wake_.notify_one();
                 }};
        return &hook_;
    }
    size_t max_queued() {
        std::lock_guard lock(mutex_);
        return max_queued_;
    }

private:
    FlgJobSystem hook_{};
    void work() {
        for (;;) {
            std::pair<void (*)(void*), void*> task;
            {
                std::unique_lock lock(mutex_);
                wake_.wait(lock, [this] { return stop_ || !queue_.empty(); });
                if (queue_.empty()) return;
                task = queue_.front();
                queue_.pop_front();
            }
            task.first(task.second);
        }
    }
    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<std::pair<void (*)(void*), void*>> queue_;
    size_t max_queued_ = 0;
    bool stop_ = false;
    std::vector<std::thread> threads_;
};

struct Sums {
    std::vector<uint64_t> values;
    static Task<void> one(Pace& pace, Sums& self, uint32_t i) { self.values[i] = co_await hash_sum(pace, 1000 + i, 7); }
    static Task<void> all(Pace& pace, Sums& self) {
        pace.stage("sums");
        co_await fork(pace, static_cast<uint32_t>(self.values.size()), &one, self);
    }
};

void expect_sums(Runtime& runtime, uint32_t budget_us) {
    std::vector<Sums> many(20, Sums{std::vector<uint64_t>(50)});
    for (Sums& sums : many) submit(runtime, [&](Pace& pace) { return Sums::all(pace, sums); });
    tick_until_done(runtime, budget_us);
    for (const Sums& sums : many) {
        for (uint32_t i = 0; i < sums.values.size(); ++i) ASSERT_EQ(sums.values[i], expected_hash_sum(1000 + i));
    }
}

TEST(Threads, SameResultsWithAnyNumberOfWorkersAndAnyBudget) {
    CountingMemory memory;
    for (uint32_t workers : {0u, 1u, 2u, 4u}) {
        for (uint32_t worker_budget_us : {0u, 150u}) {
            FlgContextDesc desc{};
            desc.worker_count = workers;
            desc.worker_budget_us = worker_budget_us;
            Runtime runtime(desc, &memory, memory.large_blocks);
            expect_sums(runtime, 100);
        }
        EXPECT_EQ(memory.live, 0);
    }
}

TEST(Threads, SameResultsInTheHostsJobSystem) {
    CountingMemory memory;
    Pool pool(3);
    for (uint32_t concurrency : {1u, 2u, 8u}) {
        FlgContextDesc desc{};
        desc.job_system = pool.hook(concurrency);
        Runtime runtime(desc, &memory, memory.large_blocks);
        expect_sums(runtime, 100);
        while (!runtime.stop()) std::this_thread::yield();
    }
    EXPECT_LE(pool.max_queued(), 8u);
    EXPECT_EQ(memory.live, 0);
}

TEST(Threads, AJobSystemThatNeverRunsOurTasksKeepsTheContextAlive) {
    struct Kept {
        std::vector<std::pair<void (*)(void*), void*>> tasks;
    } kept;
    FlgContextDesc desc{};
    const FlgJobSystem system = {sizeof system, 2, &kept, [](void* self, void (*run)(void*), void* task) {
                                     static_cast<Kept*>(self)->tasks.push_back({run, task});
                                 }};
    desc.job_system = &system;
    CountingMemory memory;
    {
        Runtime runtime(desc, &memory, memory.large_blocks);
        uint64_t sum = 0;
        const auto job = submit(runtime, [&](Pace& pace) { return store_hash_sum(pace, 100, 1, &sum); });
        runtime.tick(100);
        ASSERT_EQ(kept.tasks.size(), 1u);
        EXPECT_FALSE(runtime.stop());
        kept.tasks[0].first(kept.tasks[0].second);
        EXPECT_TRUE(runtime.stop());
        EXPECT_EQ(sum, 0u);
    }
    EXPECT_EQ(memory.live, 0);
}

// Ticks until workers have used ten milliseconds of the host's clock in all, and says how much that was for each tick.
// On a clock that moves by a microsecond at each look, the machine's speed doesn't matter: workers that kept no budget
// would use thousands. What they used before the first tick, and in the last one, is a frame more than ticks: many make
// that little.
float worker_us_per_tick(Runtime& runtime) {
    float worker_us = 0;
    int ticks = 0;
    for (; worker_us < 10000.0f; ++ticks) {
        worker_us += runtime.tick(1).worker_us;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return worker_us / static_cast<float>(ticks);
}

struct Endless {
    static Task<void> run(Pace& pace) {
        for (;;) co_await pace;
    }
};

TEST(Threads, WorkersKeepTheirBudgetBetweenTicks) {
    ManualClock clock;
    clock.step_ns = 1000;
    FlgContextDesc desc{};
    desc.worker_count = 1;
    desc.worker_budget_us = 200;
    desc.clock = clock.hook();
    CountingMemory memory;
    Runtime runtime(desc, &memory, memory.large_blocks);
    submit(runtime, [&](Pace& pace) { return Endless::run(pace); });
    EXPECT_LT(worker_us_per_tick(runtime), 250.0f);
}

double process_cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

TEST(Threads, WorkersThatSpentTheirBudgetSleep) {
    FlgContextDesc desc{};
    desc.worker_count = 4;
    desc.worker_budget_us = 200;
    CountingMemory memory;
    Runtime runtime(desc, &memory, memory.large_blocks);
    for (int i = 0; i < 8; ++i) submit(runtime, [&](Pace& pace) { return Endless::run(pace); });
    const double before = process_cpu_seconds();
    for (int i = 0; i < 4; ++i) {
        runtime.tick(100);
        std::this_thread::sleep_for(std::chrono::milliseconds(60));
    }
    // 4 workers x 4 frames x 0.2 ms of work; awake they would take 0.24 s.
    EXPECT_LT(process_cpu_seconds() - before, 0.06);
}

TEST(Threads, TheHostsJobSystemKeepsTheBudgetToo) {
    Pool pool(2);
    FlgContextDesc desc{};
    desc.job_system = pool.hook(2);
    desc.worker_budget_us = 100;
    ManualClock clock;  // every look at it takes a microsecond
    clock.step_ns = 1000;
    desc.clock = clock.hook();
    CountingMemory memory;
    Runtime runtime(desc, &memory, memory.large_blocks);
    for (int i = 0; i < 4; ++i) submit(runtime, [&](Pace& pace) { return Endless::run(pace); });
    EXPECT_LT(worker_us_per_tick(runtime), 300.0f);
    while (!runtime.stop()) std::this_thread::yield();
}

TEST(Threads, TheFailureOfTheSmallestIndexComesOutOfAFork) {
    struct Body {
        static Task<void> one(Pace& pace, int&, uint32_t i) {
            co_await pace;
            if (i % 7 == 3) throw Failure(FLG_ERROR_LIMIT, "index %u", i);
        }
        static Task<void> all(Pace& pace, int context) { co_await fork(pace, 40, &one, context); }
    };
    for (uint32_t workers : {0u, 3u}) {
        FlgContextDesc desc{};
        desc.worker_count = workers;
        CountingMemory memory;
        Runtime runtime(desc, &memory, memory.large_blocks);
        const auto job = submit(runtime, [&](Pace& pace) { return Body::all(pace, 0); });
        tick_until_done(runtime);
        EXPECT_EQ(job->status.result, FLG_ERROR_LIMIT);
        EXPECT_STREQ(job->status.error, "index 3");
    }
}

TEST(Threads, RandomCancellationLosesNothing) {
    CountingMemory memory;
    for (uint32_t workers : {0u, 1u, 2u, 4u}) {
        FlgContextDesc desc{};
        desc.worker_count = workers;
        {
            std::vector<Sums> many(60, Sums{std::vector<uint64_t>(20)});  // outlives the workers
            Runtime runtime(desc, &memory, memory.large_blocks);
            std::vector<std::shared_ptr<Job>> jobs;
            for (uint32_t i = 0; i < many.size(); ++i) {
                if (i % 3 == 2) {
                    jobs.push_back(submit(runtime, [&](Pace& pace) { return Sums::all(pace, many[i]); },
                                          FLG_PRIORITY_NORMAL, {jobs[i - 1]}));
                } else {
                    jobs.push_back(submit(runtime, [&](Pace& pace) { return Sums::all(pace, many[i]); }));
                }
                if (random_below(7, workers, i, 2) == 0) runtime.tick(20);
                runtime.scheduler().cancel(*jobs[random_below(7, workers, 1000 + i, i + 1)]);
            }
            // Half of the time the rest is left to the destructor.
            if (workers % 2 == 0) {
                tick_until_done(runtime);
                for (uint32_t i = 0; i < many.size(); ++i) {
                    EXPECT_EQ(jobs[i]->status.state, FLG_JOB_STATE_FINISHED);
                    if (jobs[i]->status.result != FLG_OK) continue;
                    for (uint32_t k = 0; k < 20; ++k) EXPECT_EQ(many[i].values[k], expected_hash_sum(1000 + k));
                }
            }
        }
        EXPECT_EQ(memory.live, 0);
    }
}

}  // namespace
}  // namespace flg::test
