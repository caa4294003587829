// SPDX-License-Identifier: MIT
// filigree_slices [--size N] [--jobs PART] [--work | --runs N]: how long every job of the ABI holds the host's thread
// between two looks at the clock, at any size. With --work by a clock that counts work, and it fails if anything takes
// more than 100 us; else in processor time, the least of some runs, with an engine's pool and without an allocator.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iterator>
#include <stdexcept>
#include <string>

#include "slices/memory_clocks.h"
#include "slices/sized_jobs.h"

namespace flg::slices {

namespace {

constexpr double most_us = 100;

struct Measured {
    Longest slices, ticks, calls, copies;
    uint32_t tick_count = 0;
};

constexpr std::pair<const char*, Longest Measured::*> columns[] = {
    {"slice", &Measured::slices}, {"tick", &Measured::ticks}, {"call", &Measured::calls}, {"copy", &Measured::copies}};

// Cancelled before tick `cancel_at`, counted from 1; 0: not.
Measured run(const SizedJob& job, uint32_t size, const FlgClock& clock, const FlgAllocator* allocator,
             uint32_t cancel_at = 0) {
    WatchedHost host(clock, allocator);
    host.cancel_at_tick(cancel_at);
    try {
        job.run(host, size);
    } catch (const WatchedHost::Cancelled&) {}
    host.release_all();
    return {host.slices, host.ticks, host.calls, host.copies, host.tick_count};
}

// By work, also of jobs that are cancelled; returns how many violations there are.
uint32_t check(const SizedJob& job, uint32_t size) {
    uint32_t violations = 0;
    const auto look_at = [&](const Longest& longest, const char* what) {
        if (longest.us <= most_us) return;
        std::printf("%-18s %8u  %-7s %9.0f us  %s\n", job.name, size, what, longest.us, longest.where.c_str());
        ++violations;
    };
    const auto work = [&](uint32_t cancel_at) {
        WorkClock clock;
        return run(job, size, clock.clock(), clock.allocator(), cancel_at);
    };
    const Measured whole = work(0);
    for (const auto& [what, longest] : columns)
        if (longest != &Measured::copies) look_at(whole.*longest, what);
    constexpr uint32_t cancelled = 3;
    for (uint32_t i = 1; i <= cancelled; ++i) {
        const Measured part = work(1 + whole.tick_count * i / (cancelled + 1));
        look_at(part.slices, "cancelled slice");
        look_at(part.ticks, "cancelled tick");
        look_at(part.calls, "cancelled call");
    }
    return violations;
}

uint64_t processor_ns(void*) {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<uint64_t>(now.tv_sec) * 1'000'000'000 + static_cast<uint64_t>(now.tv_nsec);
}

void measure(const SizedJob& job, uint32_t size, uint32_t runs, bool pooled) {
    const FlgClock clock = {sizeof(FlgClock), nullptr, processor_ns};
    Pool pool;
    Measured least;
    for (uint32_t i = 0; i < runs; ++i) {
        const Measured measured = run(job, size, clock, pooled ? pool.allocator() : nullptr);
        for (const auto& column : columns) {
            const auto longest = column.second;
            if (i == 0 || (measured.*longest).us < (least.*longest).us) least.*longest = measured.*longest;
        }
    }
    std::printf("%-18s %8u %-5s", job.name, size, pooled ? "pool" : "plain");
    for (const auto& [what, longest] : columns)
        std::printf(" | %9.1f %-24.24s", (least.*longest).us, (least.*longest).where.c_str());
    std::printf("\n");
    std::fflush(stdout);
}

struct Options {
    uint32_t size = 3000, runs = 3;
    const char* jobs = "";
    bool work = false;
};

Options read(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const auto is = [&](const char* name) { return std::strcmp(arguments[i], name) == 0; };
        if (is("--work")) {
            options.work = true;
        } else if (i + 1 == count) {
            throw std::runtime_error(std::string("no option, or without a value: ") + arguments[i]);
        } else if (is("--size")) {
            options.size = static_cast<uint32_t>(std::strtoul(arguments[++i], nullptr, 10));
        } else if (is("--runs")) {
            options.runs = static_cast<uint32_t>(std::strtoul(arguments[++i], nullptr, 10));
        } else if (is("--jobs")) {
            options.jobs = arguments[++i];
        } else {
            throw std::runtime_error(std::string("no option: ") + arguments[i]);
        }
    }
    return options;
}

uint32_t run_all(const Options& options) {
    uint32_t violations = 0, count = 0;
    for (const auto& jobs : {stroke_jobs(), surface_jobs(), tangle_jobs(), spline_jobs(), model_jobs()}) {
        for (const SizedJob& job : jobs) {
            if (std::strstr(job.name, options.jobs) == nullptr) continue;
            ++count;
            const uint32_t size = std::min(options.size, job.largest);
            try {
                if (options.work) {
                    violations += check(job, size);
                    continue;
                }
                for (const bool pooled : {false, true}) measure(job, size, options.runs, pooled);
            } catch (const std::exception& e) {
                std::printf("%-18s %8u  FAILED: %s\n", job.name, size, e.what());
                ++violations;
            }
        }
    }
    if (count == 0) throw std::runtime_error(std::string("no job has ") + options.jobs + " in its name");
    return violations;
}

}  // namespace

}  // namespace flg::slices

int main(int argc, char** argv) {
    try {
        return flg::slices::run_all(flg::slices::read(argc, argv)) == 0 ? 0 : 1;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "filigree_slices: %s\n", e.what());
        return 2;
    }
}
