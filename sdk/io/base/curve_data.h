// SPDX-License-Identifier: MIT
// What readers fill: curves in flat arrays, as in FlgCurveSetView, and what is odd about them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "filigree/filigree_io.h"
#include "io/base/column_names.h"
#include "io/base/placing.h"
#include "io/base/tally.h"

namespace flg::io {

struct CurveData {
    const char* format = "";
    const char* units = "as given";
    std::vector<uint32_t> offsets{0};
    std::vector<uint8_t> flags;
    // Columns: empty, or of as many values as there are points.
    std::vector<float> positions;
    Placing placing;
    std::vector<float> radii;
    std::vector<float> colors;
    std::vector<float> times;
    std::vector<float> pressures;
    std::vector<float> orientations;
    std::vector<VertexColumn> columns;  // further ones
    std::vector<FlgStroke> strokes;
    std::vector<std::string> warnings;

    size_t point_count() const { return positions.size() / 3; }
    size_t curve_count() const { return flags.size(); }

    // All points since the last call become a curve.
    void end_curve(bool closed) {
        offsets.push_back(static_cast<uint32_t>(point_count()));
        flags.push_back(closed ? FLG_CURVE_CLOSED : 0);
    }

    void warn(const Tally& tally, const char* unit, const char* what) { io::warn(warnings, tally, unit, what); }
};

}  // namespace flg::io
