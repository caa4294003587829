// SPDX-License-Identifier: MIT
// With a host's job system the SDK starts no thread, and all it does is done on the host's; with any of the three ways
// to run, results are the same to the bit. Zones of the profiler are nested, by literals; the log has one line a
// message.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "hardening/ledger.h"
#include "hardening/random_pool.h"
#include "hardening/scenarios.h"

namespace flg::test {
namespace {

size_t thread_count() {
    return static_cast<size_t>(std::distance(std::filesystem::directory_iterator("/proc/self/task"), {}));
}

// Threads that were joined are still counted for a moment.
size_t settled_thread_count() {
    for (size_t before = thread_count();;) {
        std::this_thread::sleep_for(std::chrono::milliseconds(3));
        const size_t now = thread_count();
        if (now == before) return now;
        before = now;
    }
}

// Which memory of the process is a file's that can't be written: where literals are.
class Constants {
public:
    Constants() {
        std::ifstream maps("/proc/self/maps");
        for (std::string line; std::getline(maps, line);) {
            unsigned long begin = 0, end = 0;
            char rights[5] = {};
            if (std::sscanf(line.c_str(), "%lx-%lx %4s", &begin, &end, rights) != 3) continue;
            if (rights[0] == 'r' && rights[1] == '-' && line.find('/') != line.npos) ranges_.push_back({begin, end});
        }
    }
    bool holds(const void* pointer) const {
        const auto at = reinterpret_cast<unsigned long>(pointer);
        return std::any_of(ranges_.begin(), ranges_.end(), [&](auto& r) { return at >= r.first && at < r.second; });
    }

private:
    std::vector<std::pair<unsigned long, unsigned long>> ranges_;
};

// Hooks that note on which threads they are called, and how zones lie in one another.
class Watch {
public:
    const FlgAllocator* allocator() const { return &allocator_; }

    const FlgAllocator allocator_{sizeof(FlgAllocator), this,
                                  [](void* self, size_t size, size_t alignment) {
                                      auto& watch = *static_cast<Watch*>(self);
                                      watch.note_thread();
                                      const FlgAllocator& hook = *watch.ledger.hook();
                                      return hook.allocate(hook.user_data, size, alignment);
                                  },
                                  [](void* self, void* memory, size_t size, size_t alignment) {
                                      auto& watch = *static_cast<Watch*>(self);
                                      watch.note_thread();
                                      const FlgAllocator& hook = *watch.ledger.hook();
                                      hook.free(hook.user_data, memory, size, alignment);
                                  }};
    const FlgProfiler* profiler() const { return &profiler_; }

    const FlgProfiler profiler_{sizeof(FlgProfiler), this,
                                [](void* self, const char* name) {
                                    auto& watch = *static_cast<Watch*>(self);
                                    const std::lock_guard lock(watch.mutex_);
                                    ++watch.depth[std::this_thread::get_id()];
                                    ++watch.zones[name];
                                },
                                [](void* self) {
                                    auto& watch = *static_cast<Watch*>(self);
                                    const std::lock_guard lock(watch.mutex_);
                                    if (--watch.depth[std::this_thread::get_id()] < 0) watch.is_nested = false;
                                }};
    void note_thread() {
        const std::lock_guard lock(mutex_);
        threads.insert(std::this_thread::get_id());
    }

    Ledger ledger;
    std::set<std::thread::id> threads;
    std::map<std::thread::id, int> depth;
    std::map<const char*, int> zones;
    bool is_nested = true;

private:
    std::mutex mutex_;
};

std::string run(const Scenario& scenario, FlgContextDesc desc, Watch& watch) {
    desc.allocator = watch.allocator();
    desc.profiler = watch.profiler();
    FlgContext context{};
    EXPECT_EQ(flgContextCreate(&desc, &context), FLG_OK) << flgErrorGetMessage();
    Calls calls(context);
    calls.contexts.allocator = watch.ledger.hook();
    calls.tick_budget_us = desc.worker_count == 0 && !desc.job_system ? 50 : FLG_UNLIMITED;
    scenario.run(calls);
    EXPECT_FALSE(calls.ended);
    while (flgContextDestroy(context) == FLG_NOT_READY) std::this_thread::yield();
    EXPECT_EQ(watch.ledger.live_bytes, 0);
    EXPECT_TRUE(watch.is_nested);
    for (const auto& [thread, depth] : watch.depth) EXPECT_EQ(depth, 0) << "zones that did not end";
    const Constants constants;
    for (const auto& [name, times] : watch.zones) {
        EXPECT_STRNE(name, "");
        EXPECT_TRUE(constants.holds(name)) << name << " is no literal";
    }
    return calls.bits;
}

class HostHooks : public testing::TestWithParam<Scenario> {};

TEST_P(HostHooks, AJobSystemsThreadsDoAllTheWork) {
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = 0;
    Watch alone;
    const std::string bits = run(GetParam(), desc, alone);
    EXPECT_EQ(alone.threads.size(), 1u);
    desc.worker_count = 2;
    Watch with_workers;
    EXPECT_TRUE(run(GetParam(), desc, with_workers) == bits) << "with workers";
    for (uint64_t seed = 0; seed < 3; ++seed) {
        RandomPool pool(3, seed);
        const size_t threads = settled_thread_count();
        desc.job_system = pool.hook(1 + 3 * static_cast<uint32_t>(seed));
        Watch watch;
        EXPECT_TRUE(run(GetParam(), desc, watch) == bits) << "in a job system, seed " << seed;
        EXPECT_EQ(thread_count(), threads);
        std::set<std::thread::id> hosts = {std::this_thread::get_id()};
        for (const std::thread::id id : pool.ids()) hosts.insert(id);
        EXPECT_TRUE(std::includes(hosts.begin(), hosts.end(), watch.threads.begin(), watch.threads.end()));
        for (const auto& [thread, depth] : watch.depth) EXPECT_TRUE(hosts.contains(thread));
        // The host's own thread works on no job.
        EXPECT_FALSE(watch.depth.contains(std::this_thread::get_id()));
    }
}

std::vector<Scenario> with_jobs() {
    std::vector<Scenario> all(std::begin(scenarios), std::end(scenarios));
    std::erase_if(all, [](const Scenario& of) { return of.run == pose_skins || of.run == make_contexts; });
    return all;
}

INSTANTIATE_TEST_SUITE_P(Of, HostHooks, testing::ValuesIn(with_jobs()), name_of);

TEST(HostLog, OneLineAMessageOnTheHostsThread) {
    struct Lines {
        std::vector<std::string> all;
        std::thread::id thread = std::this_thread::get_id();
    } lines;
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = 2;
    const FlgLog log = {sizeof log, &lines, [](void* user, FlgLogLevel level, const char* message) {
                            auto& heard = *static_cast<Lines*>(user);
                            EXPECT_EQ(level, FLG_LOG_LEVEL_ERROR);
                            EXPECT_EQ(std::this_thread::get_id(), heard.thread);
                            heard.all.push_back(message);
                        }};
    desc.log = &log;
    const Host host(desc);
    Curves curves = coil();
    for (const char* name : {"first", "second"}) {
        FlgCurveSetStylizeDesc stylize = flgCurveSetStylizeDefaults();
        FlgStyleDesc style = flgStyleDefaults();
        style.style = host.create(curves);
        ASSERT_EQ(flgStyleCreate(host.context, &style, &stylize.style, nullptr), FLG_OK) << flgErrorGetMessage();
        stylize.target = host.create(arcs(1));
        stylize.max_points = 2;
        FlgCurveSet out{};
        ASSERT_EQ(flgCurveSetStylize(host.context, &stylize, &out, nullptr), FLG_OK) << name << flgErrorGetMessage();
    }
    host.finish();
    ASSERT_EQ(lines.all.size(), 2u);
    for (const std::string& line : lines.all) {
        EXPECT_EQ(line.find('\n'), line.npos);
        EXPECT_NE(line.find("max_points is 2"), line.npos) << line;
    }
}

}  // namespace
}  // namespace flg::test
