// SPDX-License-Identifier: MIT
#include "io/checked_view.h"

#include <cstring>
#include <string>

#include "io/failure.h"
#include "io/limits.h"

namespace flg::io {

CheckedView::CheckedView(const FlgCurveSetView* view) {
    if (!view) fail(FLG_ERROR_INVALID_ARGUMENT, "view", "is null");
    if (view->struct_size < sizeof(FlgCurveSetView)) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.struct_size", "is %u; FlgCurveSetView has %zu bytes", view->struct_size,
             sizeof(FlgCurveSetView));
    }
    std::memcpy(&view_, view, sizeof view_);
    check_curves();
    const CheckedColumns columns(view_.columns, view_.column_count, point_count());
    position = columns.find(FLG_ATTRIBUTE_POSITION);
    radius = columns.find(FLG_ATTRIBUTE_RADIUS);
    color = columns.find(FLG_ATTRIBUTE_COLOR);
    normal = columns.find(FLG_ATTRIBUTE_NORMAL);
}

void CheckedView::check_curves() const {
    if (view_.curve_count == 0) fail(FLG_ERROR_INVALID_ARGUMENT, "view.curve_count", "is 0: there is nothing to write");
    if (!view_.curve_offsets) fail(FLG_ERROR_INVALID_ARGUMENT, "view.curve_offsets", "is null");
    if (view_.curve_offsets[0] != 0) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.curve_offsets[0]", "is %u, must be 0", view_.curve_offsets[0]);
    }
    for (uint32_t c = 0; c < view_.curve_count; ++c) {
        if (view_.curve_offsets[c + 1] <= view_.curve_offsets[c]) {
            fail(FLG_ERROR_INVALID_ARGUMENT, "view.curve_offsets[" + std::to_string(c + 1) + "]",
                 "is %u, not above %u: every curve needs a point", view_.curve_offsets[c + 1], view_.curve_offsets[c]);
        }
    }
    if (point_count() > max_points) {
        fail(FLG_ERROR_LIMIT, "view", "has %zu points, more than the limit of 2^31", point_count());
    }
}

}  // namespace flg::io
