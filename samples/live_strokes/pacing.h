// SPDX-License-Identifier: MIT
// What each frame took, and what it says of all of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace flg::samples {

struct FrameRecord {
    double push_us, tick_us, record_ms, submit_ms, wait_ms, frame_ms;
    double gpu_ms;  // of an earlier frame; negative: not known
    uint32_t missed, samples, points, strokes, tips;
    uint64_t uploaded_bytes;
};

// What the report says of the session besides.
struct SessionFacts {
    std::string device, source, style;
    double hertz = 0, seconds = 0;
    bool paced = false;
    uint32_t eye_width = 0, eye_height = 0, strokes = 0;
    uint64_t device_bytes = 0;
};

class PacingReport {
public:
    void add(const FrameRecord& frame) { frames_.push_back(frame); }
    // As a table for people.
    void print(const SessionFacts& facts) const;
    // As JSON; throws std::runtime_error.
    void write(const SessionFacts& facts, const std::string& path) const;

private:
    double percentile(double FrameRecord::*member, double share) const;
    template <class Number>
    uint64_t sum(Number FrameRecord::*member) const {
        uint64_t total = 0;
        for (const FrameRecord& frame : frames_) total += frame.*member;
        return total;
    }
    // Frames that uploaded more than their new points, the last one before those and the chunks they are in. The first
    // frames don't count: they bring the scene.
    uint32_t over_bound() const;
    uint64_t growth_bytes() const;

    std::vector<FrameRecord> frames_;
};

}  // namespace flg::samples
