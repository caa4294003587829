// SPDX-License-Identifier: MIT
// A curve that grows at its end: what prepare_curves makes of all of its points at once, made as they come, and which
// of it the device does not have yet. Host only.
#pragma once

#include <vector>

#include "curve_columns.h"
#include "curve_data.h"
#include "curve_frames.h"

namespace flg::render {

constexpr uint32_t max_growing_points = 1u << 22;

class GrowingCurve {
public:
    // Takes all memory that `capacity` points will need, here and in `data`, which it keeps up to date from then on.
    GrowingCurve(CurveData& data, const CurveLook& look, uint32_t capacity);

    // Throws Error, and changes nothing, for points that can't be used or are too many.
    void append(const FlgCurveSetView& view);
    // Throws Error if there are fewer.
    void truncate(uint32_t points);

    // Of the device's copies of centers and looks, and of chunks, what has changed since they were last uploaded.
    struct Changes {
        uint32_t first_point, point_count;
        uint32_t first_chunk, chunk_count;
    };
    Changes changes() const;
    void changes_uploaded();

private:
    void check_points(const CurveColumns& columns, uint32_t count) const;
    // After points were added or taken away, of which `from` is the first whose surroundings have changed.
    void refresh(uint32_t from);
    void make_chunks(uint32_t from);

    CurveData& data_;
    CurveLook look_;
    uint32_t capacity_;
    uint32_t given_count_ = 0;        // points appended, repeated ones included
    std::vector<uint32_t> ordinals_;  // of the points kept: how many were appended before them
    std::vector<uint32_t> colors_;
    GrowingNormals normals_;
    std::vector<Box> boxes_;  // around all up to each chunk
    uint32_t first_changed_point_ = 0, first_changed_chunk_ = 0;
};

}  // namespace flg::render
