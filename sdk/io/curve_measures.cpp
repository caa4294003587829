// SPDX-License-Identifier: MIT
#include "io/curve_measures.h"

#include <algorithm>
#include <cmath>

namespace flg::io {

CurveMeasures measure(CurveData& data) {
    CurveMeasures result;
    if (data.point_count() == 0) return result;
    const float* points = data.positions.data();
    std::copy_n(points, 3, result.box_min);
    std::copy_n(points, 3, result.box_max);
    for (size_t i = 0; i < data.positions.size(); ++i) {
        result.box_min[i % 3] = std::min(result.box_min[i % 3], points[i]);
        result.box_max[i % 3] = std::max(result.box_max[i % 3], points[i]);
    }

    const auto distance = [&](size_t a, size_t b) {
        const double x = double{points[3 * a]} - points[3 * b];
        const double y = double{points[3 * a + 1]} - points[3 * b + 1];
        const double z = double{points[3 * a + 2]} - points[3 * b + 2];
        return std::sqrt(x * x + y * y + z * z);
    };
    Tally repeated;
    Tally no_length;
    Tally lone;
    double total = 0;
    for (size_t c = 0; c < data.curve_count(); ++c) {
        const size_t begin = data.offsets[c];
        const size_t end = data.offsets[c + 1];
        double length = 0;
        bool repeats = false;
        for (size_t i = begin + 1; i < end; ++i) {
            const double step = distance(i - 1, i);
            repeats |= step == 0;
            length += step;
        }
        if (data.flags[c] & FLG_CURVE_CLOSED) length += distance(end - 1, begin);
        total += length;
        if (end - begin == 1)
            lone.add(c);
        else if (length == 0)
            no_length.add(c);
        else if (repeats)
            repeated.add(c);
    }
    result.total_length = static_cast<float>(total);
    data.warn(lone, "curve", "of a single point");
    data.warn(no_length, "curve", "of zero length");
    data.warn(repeated, "curve", "has points repeated in a row");
    return result;
}

}  // namespace flg::io
