// SPDX-License-Identifier: MIT
#include "live_strokes/pacing.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace flg::samples {
namespace {

constexpr size_t kSceneFrames = 2;
// Renderer::append's: bytes a point, and of the record of each 64 points.
constexpr uint64_t kPointBytes = 24, kChunkBytes = 16, kChunkPoints = 64;

struct Figure {
    const char* name;
    const char* title;
    double FrameRecord::*member;
};
constexpr Figure kFigures[] = {
    {"push_us", "push, us", &FrameRecord::push_us},       {"tick_us", "tick, us", &FrameRecord::tick_us},
    {"record_ms", "record, ms", &FrameRecord::record_ms}, {"submit_ms", "submit, ms", &FrameRecord::submit_ms},
    {"wait_ms", "wait, ms", &FrameRecord::wait_ms},       {"gpu_ms", "device, ms", &FrameRecord::gpu_ms},
    {"frame_ms", "frame, ms", &FrameRecord::frame_ms}};
constexpr double kShares[] = {0.5, 0.99, 0.999, 1.0};

}  // namespace

double PacingReport::percentile(double FrameRecord::*member, double share) const {
    std::vector<double> values;
    for (size_t i = std::min(kSceneFrames, frames_.size()); i < frames_.size(); ++i)
        values.push_back(frames_[i].*member);
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[static_cast<size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

uint32_t PacingReport::over_bound() const {
    uint32_t count = 0;
    for (size_t i = kSceneFrames; i < frames_.size(); ++i) {
        const FrameRecord& frame = frames_[i];
        const uint64_t points = frame.points + frame.tips + frame.strokes;
        const uint64_t chunks = (frame.points + frame.tips) / kChunkPoints + 2 * frame.strokes;
        count += frame.uploaded_bytes > kPointBytes * points + kChunkBytes * chunks;
    }
    return count;
}

uint64_t PacingReport::growth_bytes() const {
    uint64_t bytes = 0;
    for (size_t i = kSceneFrames; i < frames_.size(); ++i) bytes += frames_[i].uploaded_bytes;
    return bytes;
}

void PacingReport::print(const SessionFacts& facts) const {
    const uint64_t points = sum(&FrameRecord::points), missed = sum(&FrameRecord::missed);
    std::printf("%s, %u x %u pixels an eye, %.0f Hz%s: %zu frames, %llu displays missed\n", facts.device.c_str(),
                facts.eye_width, facts.eye_height, facts.hertz, facts.paced ? "" : " (not paced)", frames_.size(),
                static_cast<unsigned long long>(missed));
    std::printf("%-12s %9s %9s %9s %9s\n", "", "p50", "p99", "p99.9", "most");
    for (const Figure& figure : kFigures) {
        std::printf("%-12s", figure.title);
        for (const double share : kShares) std::printf(" %9.3f", percentile(figure.member, share));
        std::printf("\n");
    }
    std::printf("%u strokes, %llu points; %.1f bytes uploaded a new point, %u frames over what is new\n", facts.strokes,
                static_cast<unsigned long long>(points),
                points ? static_cast<double>(growth_bytes()) / static_cast<double>(points) : 0.0, over_bound());
}

void PacingReport::write(const SessionFacts& facts, const std::string& path) const {
    std::FILE* file = std::fopen(path.c_str(), "w");
    if (file == nullptr) throw std::runtime_error(path + ": can't be written");
    std::fprintf(file,
                 "{\"device\": \"%s\", \"source\": \"%s\", \"style\": \"%s\",\n"
                 " \"hertz\": %.3f, \"seconds\": %.3f, \"paced\": %s, \"eye\": [%u, %u],\n"
                 " \"frames\": %zu, \"missed\": %llu, \"samples\": %llu, \"points\": %llu, \"strokes\": %u,\n",
                 facts.device.c_str(), facts.source.c_str(), facts.style.c_str(), facts.hertz, facts.seconds,
                 facts.paced ? "true" : "false", facts.eye_width, facts.eye_height, frames_.size(),
                 static_cast<unsigned long long>(sum(&FrameRecord::missed)),
                 static_cast<unsigned long long>(sum(&FrameRecord::samples)),
                 static_cast<unsigned long long>(sum(&FrameRecord::points)), facts.strokes);
    for (const Figure& figure : kFigures)
        std::fprintf(file, " \"%s\": {\"p50\": %.4f, \"p99\": %.4f, \"p99.9\": %.4f, \"max\": %.4f},\n", figure.name,
                     percentile(figure.member, kShares[0]), percentile(figure.member, kShares[1]),
                     percentile(figure.member, kShares[2]), percentile(figure.member, kShares[3]));
    std::fprintf(
        file, " \"tip_points\": %llu, \"growth_bytes\": %llu, \"frames_over_bound\": %u, \"device_bytes\": %llu}\n",
        static_cast<unsigned long long>(sum(&FrameRecord::tips)), static_cast<unsigned long long>(growth_bytes()),
        over_bound(), static_cast<unsigned long long>(facts.device_bytes));
    if (std::fclose(file) != 0) throw std::runtime_error(path + ": can't be written");
}

}  // namespace flg::samples
