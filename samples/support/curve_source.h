// SPDX-License-Identifier: MIT
// Curves by name, as command line and samples take them: a file, or `builtin:NAME[:COUNT]` from the built-in scene.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "filigree/filigree_io.h"
#include "support/curve_arrays.h"

namespace flg::samples {

// One sentence that starts with the file or the built-in name.
class SourceError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// A view of curves together with the memory behind it.
class CurveSource {
public:
    // Reads the file or makes the curves; throws SourceError.
    explicit CurveSource(const std::string& name);
    ~CurveSource();
    CurveSource(CurveSource&& other) noexcept;
    CurveSource(const CurveSource&) = delete;
    CurveSource& operator=(const CurveSource&) = delete;
    CurveSource& operator=(CurveSource&&) = delete;

    const std::string& name() const { return name_; }
    // Lives as long as the source.
    const FlgCurveSetView& view() const { return view_; }
    size_t point_count() const { return view_.curve_offsets[view_.curve_count]; }
    // Whether its curves are known to meet at their ends, as those of some built-in scenes are.
    bool is_network() const { return network_; }
    // What is odd about the file.
    std::vector<std::string> warnings() const;
    // Format, units and box; zero for what is built in.
    FlgCurveFile file() const { return file_; }

private:
    void make(std::string_view builtin);

    std::string name_;
    FlgCurveSetView view_;
    FlgCurveFile file_ = nullptr;
    CurveArrays arrays_;  // of what is built in
    bool network_ = false;
};

// Some neighbouring curves of a view, without a copy of their points.
class CurveRange {
public:
    CurveRange(const FlgCurveSetView& view, uint32_t first, uint32_t count);
    const FlgCurveSetView& view() const { return view_; }
    CurveRange(const CurveRange&) = delete;
    CurveRange& operator=(const CurveRange&) = delete;

private:
    std::vector<uint32_t> offsets_;
    std::vector<FlgColumn> columns_;
    FlgCurveSetView view_;
};

// The points from `first` on of a view's only curve, without a copy.
class PointRange {
public:
    PointRange(const FlgCurveSetView& view, uint32_t first);
    const FlgCurveSetView& view() const { return view_; }
    bool empty() const { return view_.curve_count == 0; }
    PointRange(const PointRange&) = delete;
    PointRange& operator=(const PointRange&) = delete;

private:
    uint32_t offsets_[2] = {0, 0};
    std::vector<FlgColumn> columns_;
    FlgCurveSetView view_;
};

// Null if the view has no such column.
const FlgColumn* find_column(const FlgCurveSetView& view, FlgAttribute attribute);

// The values of one point in a column.
inline const float* value_at(const FlgColumn& column, size_t point) {
    const size_t stride = column.stride == 0 ? column.components * sizeof(float) : column.stride;
    return reinterpret_cast<const float*>(reinterpret_cast<const char*>(column.data) + point * stride);
}

// Length of curve `index` as a polyline, metres.
double curve_length(const FlgCurveSetView& view, uint32_t index);

}  // namespace flg::samples
