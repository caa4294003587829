// SPDX-License-Identifier: MIT
// A curve set view from a host, checked whole before anything is made of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "filigree/filigree.h"
#include "io/checked_columns.h"

namespace flg::io {

class CheckedView {
public:
    // Fails with FLG_ERROR_INVALID_ARGUMENT at the first thing that is wrong. The host's arrays must outlive this.
    explicit CheckedView(const FlgCurveSetView* view);

    uint32_t curve_count() const { return view_.curve_count; }
    size_t point_count() const { return view_.curve_offsets[view_.curve_count]; }
    size_t begin(uint32_t curve) const { return view_.curve_offsets[curve]; }
    size_t end(uint32_t curve) const { return view_.curve_offsets[curve + 1]; }
    std::span<const FlgColumn> columns() const { return {view_.columns, view_.column_count}; }
    bool closed(uint32_t curve) const { return view_.curve_flags && (view_.curve_flags[curve] & FLG_CURVE_CLOSED); }

    Column position, radius, color, normal;

private:
    void check_curves() const;

    FlgCurveSetView view_ = {};
};

}  // namespace flg::io
