// SPDX-License-Identifier: MIT
// The soak: minutes of frames at 90 Hz with everything going on at once. Every two seconds all comes to rest; then the
// memory in use must be what it was the last time, and in between it must not grow. Fails for errors and for memory,
// not for time, which it prints.
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>

#include "soak/abilities.h"
#include "soak/frame_times.h"

namespace {

using namespace flg::soak;
using Clock = std::chrono::steady_clock;

constexpr uint32_t frames_a_second = 90, frames_a_cycle = 180, budget_us = 2000;
// A few caches fill when a job first needs them, jobs decide when. From some rest on all must be the same; a run too
// short for that on a slow machine may have grown at some of its rests after the first ones, not at each.
constexpr size_t first_rests = 3, rests_to_fill_caches = 10;
// What is in use at once varies by chance: of few cycles the peaks say nothing.
constexpr size_t min_cycles = 50;
constexpr double max_growth = 1.1;

double thread_us() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

uint64_t resident_bytes() {
    uint64_t whole = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> whole >> resident;
    return resident * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

struct Outcome {
    explicit Outcome(size_t frames) : wall(frames), processor(frames) {}

    FrameTimes wall, processor;
    float max_slice_us = 0;
    const char* max_slice_stage = "";
    std::vector<int64_t> rest_bytes, cycle_peaks;
    uint64_t resident_first = 0, resident_last = 0;
};

class Soak {
public:
    Soak(uint64_t frames, uint64_t seed) : frames_(frames), stage_(seed), outcome_(frames) {
        for (const auto make : {draw_strokes, stylize_curves, measure_distances, decorate_surfaces, drag_parts,
                                draw_contours, drag_splines, move_bodies}) {
            abilities_.push_back(make(stage_));
        }
    }

    void run() {
        next_ = Clock::now();
        for (uint64_t frame = 1; frame <= frames_ && stage_.errors.size() < 10; ++frame) {
            for (const auto& ability : abilities_) ability->frame();
            tick();
            if (frame % frames_a_cycle == 0) rest();
        }
    }
    const Stage& stage() const { return stage_; }
    const Outcome& outcome() const { return outcome_; }

private:
    void tick() {
        FlgFrameReport report{};
        report.struct_size = sizeof report;
        const auto wall = Clock::now();
        const double processor = thread_us();
        stage_.must(flgContextTick(stage_.context, budget_us, &report), "flgContextTick");
        outcome_.processor.add(thread_us() - processor);
        outcome_.wall.add(std::chrono::duration<double, std::micro>(Clock::now() - wall).count());
        if (report.max_slice_us > outcome_.max_slice_us) {
            outcome_.max_slice_us = report.max_slice_us;
            outcome_.max_slice_stage = report.max_slice_stage;
        }
        pending_ = report.jobs_pending;
        next_ += std::chrono::nanoseconds(1'000'000'000 / frames_a_second);
        std::this_thread::sleep_until(next_);
    }
    void rest() {
        outcome_.cycle_peaks.push_back(stage_.max_live_bytes);
        bool resting = false;
        while (!resting && stage_.errors.size() < 10) {
            resting = true;
            for (const auto& ability : abilities_) resting = ability->rest() && resting;
            tick();
            resting = resting && pending_ == 0;
        }
        outcome_.rest_bytes.push_back(stage_.live_bytes);
        stage_.max_live_bytes = stage_.live_bytes.load();
        outcome_.resident_last = resident_bytes();
        if (outcome_.rest_bytes.size() == first_rests) outcome_.resident_first = outcome_.resident_last;
    }

    const uint64_t frames_;
    Stage stage_;
    Outcome outcome_;
    std::vector<std::unique_ptr<Ability>> abilities_;
    Clock::time_point next_;
    uint32_t pending_ = 0;
};

int64_t most(const std::vector<int64_t>& values, size_t begin, size_t end) {
    int64_t most = 0;
    for (size_t i = begin; i < end && i < values.size(); ++i) most = std::max(most, values[i]);
    return most;
}

// What is wrong with the memory, "" if nothing.
std::string memory_fault(const Outcome& outcome) {
    const std::vector<int64_t>&rests = outcome.rest_bytes, &peaks = outcome.cycle_peaks;
    const bool is_short = rests.size() < 2 * rests_to_fill_caches;
    const size_t begin = is_short ? first_rests : rests_to_fill_caches + 1;
    size_t changes = 0;
    for (size_t i = begin; i < rests.size(); ++i) {
        changes += is_short ? rests[i] > rests[i - 1] : rests[i] != rests[rests_to_fill_caches];
    }
    if (changes > 0 && (!is_short || begin + changes == rests.size())) {
        return "at " + std::to_string(changes) + " of the last " + std::to_string(rests.size() - begin) +
               " rests it was another than before, from " + std::to_string(rests[begin - 1]) + " to " +
               std::to_string(rests.back()) + " bytes";
    }
    if (peaks.size() < min_cycles) return "";
    const size_t half = peaks.size() / 2;
    const int64_t first = most(peaks, 0, half), last = most(peaks, half, peaks.size());
    if (static_cast<double>(last) <= max_growth * static_cast<double>(first)) return "";
    return "the peak grew from " + std::to_string(first) + " to " + std::to_string(last) + " bytes";
}

void print(const char* name, const FrameTimes& times) {
    std::printf("  %-22s p50 %7.1f us   p99 %7.1f us   p99.9 %7.1f us   longest %7.1f us\n", name, times.quantile(0.5),
                times.quantile(0.99), times.quantile(0.999), times.quantile(1));
}

void write_times(std::ofstream& file, const char* name, const FrameTimes& times) {
    file << "  \"" << name << "\": {\"p50\": " << times.quantile(0.5) << ", \"p99\": " << times.quantile(0.99)
         << ", \"p99.9\": " << times.quantile(0.999) << ", \"max\": " << times.quantile(1) << "},\n";
}

bool write_json(const char* path, double minutes, const Soak& soak, const std::string& fault) {
    const Outcome& outcome = soak.outcome();
    const size_t half = outcome.cycle_peaks.size() / 2;
    std::ofstream file(path);
    file << "{\n  \"minutes\": " << minutes << ",\n";
    write_times(file, "tick_wall_us", outcome.wall);
    write_times(file, "tick_processor_us", outcome.processor);
    file << "  \"longest_chunk_us\": " << outcome.max_slice_us << ",\n  \"longest_chunk_stage\": \""
         << outcome.max_slice_stage << "\",\n  \"jobs_finished\": " << soak.stage().jobs_finished
         << ",\n  \"jobs_cancelled\": " << soak.stage().jobs_cancelled
         << ",\n  \"peak_bytes_first_half\": " << most(outcome.cycle_peaks, 0, half)
         << ",\n  \"peak_bytes_last_half\": " << most(outcome.cycle_peaks, half, outcome.cycle_peaks.size())
         << ",\n  \"bytes_at_rest\": " << (outcome.rest_bytes.empty() ? 0 : outcome.rest_bytes.back())
         << ",\n  \"resident_bytes_first\": " << outcome.resident_first
         << ",\n  \"resident_bytes_last\": " << outcome.resident_last
         << ",\n  \"memory_flat\": " << (fault.empty() ? "true" : "false")
         << ",\n  \"errors\": " << soak.stage().errors.size() << "\n}\n";
    return static_cast<bool>(file.flush());
}

}  // namespace

int main(int argc, char** argv) {
    double minutes = 0.2;
    uint64_t seed = 1;
    const char* json = nullptr;
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        if (i + 1 == argc || (name != "--minutes" && name != "--seed" && name != "--json")) {
            std::fprintf(stderr, "usage: filigree_soak [--minutes M] [--seed N] [--json FILE]\n");
            return 2;
        }
        const char* const value = argv[++i];
        if (name == "--minutes") minutes = std::atof(value);
        if (name == "--seed") seed = std::strtoull(value, nullptr, 10);
        if (name == "--json") json = value;
    }
    Soak soak(static_cast<uint64_t>(60 * minutes * frames_a_second), seed);
    soak.run();
    const Outcome& outcome = soak.outcome();
    const std::string fault = memory_fault(outcome);
    std::printf("soak of %.1f minutes, one worker, ticks at %u Hz with %u us\n", minutes, frames_a_second, budget_us);
    print("tick, wall time", outcome.wall);
    print("tick, processor time", outcome.processor);
    std::printf("  longest chunk          %.1f us, in %s\n", outcome.max_slice_us, outcome.max_slice_stage);
    std::printf("  jobs                   %llu, %llu of them cancelled\n",
                static_cast<unsigned long long>(soak.stage().jobs_finished),
                static_cast<unsigned long long>(soak.stage().jobs_cancelled));
    const size_t half = outcome.cycle_peaks.size() / 2;
    std::printf("  memory, peak           %.2f MB in the first half, %.2f MB in the last\n",
                1e-6 * static_cast<double>(most(outcome.cycle_peaks, 0, half)),
                1e-6 * static_cast<double>(most(outcome.cycle_peaks, half, outcome.cycle_peaks.size())));
    std::printf("  memory, at rest        %lld bytes; resident %.1f MB, at first %.1f MB\n",
                outcome.rest_bytes.empty() ? 0LL : static_cast<long long>(outcome.rest_bytes.back()),
                1e-6 * static_cast<double>(outcome.resident_last), 1e-6 * static_cast<double>(outcome.resident_first));
    for (const std::string& error : soak.stage().errors) std::fprintf(stderr, "error: %s\n", error.c_str());
    if (!fault.empty()) std::fprintf(stderr, "memory: %s\n", fault.c_str());
    if (json && !write_json(json, minutes, soak, fault)) {
        std::fprintf(stderr, "%s can't be written\n", json);
        return 1;
    }
    return soak.stage().errors.empty() && fault.empty() ? 0 : 1;
}
