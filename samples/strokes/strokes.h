// SPDX-License-Identifier: MIT
// Strokes read from files, sorted by size, so that each gets the style in a size that suits it.
#pragma once

#include <string>
#include <vector>

#include "filigree/filigree.h"
#include "support/curve_source.h"

namespace flg::samples {

// Curves in flat arrays, with radius and colour; what the host keeps.
class StrokeSet {
public:
    // Appends curve `index` of `view`. Where it has no radius or colour, it gets these.
    void add(const FlgCurveSetView& view, uint32_t index, float radius, const float* color, float radius_factor);
    // Appends all curves of a result, with their frames.
    void add_all(const FlgCurveSetView& view);

    uint32_t curve_count() const { return static_cast<uint32_t>(offsets_.size() - 1); }
    size_t point_count() const { return offsets_.back(); }
    // Valid until the next add.
    FlgCurveSetView view();

private:
    std::vector<float> positions_, radii_, colors_, normals_;
    std::vector<uint32_t> offsets_ = {0};
    std::vector<uint8_t> flags_;
    std::vector<FlgColumn> columns_;
};

// Strokes of about one size.
struct StrokeGroup {
    float displacement;  // root mean square that suits them, metres
    StrokeSet strokes;   // radii thinned for the styled result
};

// All strokes of the sources, in groups of a factor of two in size, the largest first. A stroke's size is its own
// radius where it has one (the style shall be a small multiple of it), its length otherwise.
std::vector<StrokeGroup> group_by_size(const std::vector<CurveSource>& sources);

}  // namespace flg::samples
