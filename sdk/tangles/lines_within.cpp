// SPDX-License-Identifier: MIT
#include "tangles/lines_within.h"

#include "surfaces/surface_place.h"

namespace flg {

// The stretch from a point to the next.
void LinesWithinKernel::look() {
    const SurfacePoint& point = lines_.points[point_];
    if (regions_.contains(mesh_.regions[point.triangle])) {
        out_.points.push_back(point);
        triangle_ = point.triangle;
        return;
    }
    all_within_ = false;
    end_piece(point_);
}

// Points where a piece ends are those of its last stretch's triangle.
void LinesWithinKernel::end_piece(uint32_t last) {
    if (out_.points.size() == out_.offsets.back()) return;
    SurfacePoint end = lines_.points[last];
    if (end.triangle != triangle_) find_in(mesh_, place_in(mesh_, end.triangle, weights_of(end)), triangle_, end);
    out_.points.push_back(end);
    out_.offsets.push_back(static_cast<uint32_t>(out_.points.size()));
    out_.closed.push_back(false);
    out_.values.push_back(lines_.values[line_]);
}

void LinesWithinKernel::end_line() {
    if (!lines_.closed[line_]) {
        end_piece(lines_.offsets[line_ + 1] - 1);
    } else if (!all_within_) {
        end_piece(lines_.offsets[line_]);
    } else {
        out_.offsets.push_back(static_cast<uint32_t>(out_.points.size()));
        out_.closed.push_back(true);
        out_.values.push_back(lines_.values[line_]);
    }
    all_within_ = true;
    point_ = lines_.offsets[++line_];
}

bool LinesWithinKernel::run(uint32_t count) {
    for (; count > 0 && line_ < lines_.curve_count(); --count) {
        if (point_ + (lines_.closed[line_] ? 0 : 1) < lines_.offsets[line_ + 1]) {
            look();
            ++point_;
        } else {
            end_line();
        }
    }
    return line_ == lines_.curve_count();
}

}  // namespace flg
