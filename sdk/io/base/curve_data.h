// SPDX-License-Identifier: MIT
// What readers fill: curves in flat arrays, as in FlgCurveSetView, and what is odd about them.
#pragma once

#include <cstdint>

#include "filigree/filigree_io.h"
#include "io/base/column_names.h"
#include "io/base/memory.h"
#include "io/base/placing.h"
#include "io/base/tally.h"

namespace flg::io {

struct CurveData {
    const char* format = "";
    const char* units = "as given";
    Vector<uint32_t> offsets{0};
    Vector<uint8_t> flags;
    // Columns: empty, or of as many values as there are points.
    Vector<float> positions;
    Placing placing;
    Vector<float> radii;
    Vector<float> colors;
    Vector<float> times;
    Vector<float> pressures;
    Vector<float> orientations;
    Vector<VertexColumn> columns;  // further ones
    Vector<FlgStroke> strokes;
    Vector<String> warnings;

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
