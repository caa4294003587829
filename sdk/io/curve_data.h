// SPDX-License-Identifier: MIT
// What readers fill: curves in flat arrays, as in FlgCurveSetView, and what is odd about them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "filigree/filigree_io.h"

namespace flg::io {

// How often one oddity was met, and where first.
struct Tally {
    uint64_t count = 0;
    uint64_t first = 0;
    void add(uint64_t index) {
        if (count++ == 0) first = index;
    }
};

struct CurveData {
    const char* format = "";
    const char* units = "as given";
    std::vector<uint32_t> offsets{0};
    std::vector<uint8_t> flags;
    // Columns: empty, or of as many values as there are points.
    std::vector<float> positions;
    std::vector<float> radii;
    std::vector<float> colors;
    std::vector<float> times;
    std::vector<float> pressures;
    std::vector<float> orientations;
    std::vector<FlgStroke> strokes;
    std::vector<std::string> warnings;

    size_t point_count() const { return positions.size() / 3; }
    size_t curve_count() const { return flags.size(); }

    // All points since the last call become a curve.
    void end_curve(bool closed) {
        offsets.push_back(static_cast<uint32_t>(point_count()));
        flags.push_back(closed ? FLG_CURVE_CLOSED : 0);
    }

    // One sentence a kind of oddity: "2 strokes: <what> (first: stroke 7)".
    void warn(const Tally& tally, const char* unit, const char* what) {
        if (tally.count == 0) return;
        warnings.push_back(std::to_string(tally.count) + " " + unit + (tally.count == 1 ? "" : "s") + ": " + what +
                           " (first: " + unit + " " + std::to_string(tally.first) + ")");
    }
};

}  // namespace flg::io
