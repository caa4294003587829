// SPDX-License-Identifier: MIT
// Arrays of a result into the host's buffers, each with a stride and a number format of its own: at once, or as a task.
//
// - Written from front to back, never read: buffers may be a graphics card's memory. Interleaved columns are written
//   few rows at a time, so that a line of write-combined memory is filled before it leaves.
// - The same bits at once and by the task.
#pragma once

#include <array>
#include <cstdint>

#include "core/origin.h"
#include "filigree/filigree_buffers.h"
#include "runtime/task.h"

namespace flg {

// One array: a row a point or vertex.
struct ResultColumn {
    FlgAttribute attribute = FLG_ATTRIBUTE_POSITION;
    FlgNumberFormat format = FLG_NUMBER_FORMAT_FLOAT32;  // or UINT16, UINT32
    uint32_t components = 0;
    uint32_t stride = 0;         // bytes
    const void* data = nullptr;  // null: there is none
};

// What there is to write.
struct ResultArrays {
    std::array<ResultColumn, 17> columns;
    uint32_t column_count = 0;
    uint32_t rows = 0;
    uint32_t triangle_count = 0;
    const uint32_t* triangles = nullptr;  // null: there are none
    const uint32_t* regions = nullptr;
    Origin origin{};

    // Tightly packed.
    template <class Number>
    void add(FlgAttribute attribute, uint32_t components, const Number* data) {
        const FlgNumberFormat format = sizeof(Number) == 2                ? FLG_NUMBER_FORMAT_UINT16
                                       : std::is_same_v<Number, uint32_t> ? FLG_NUMBER_FORMAT_UINT32
                                                                          : FLG_NUMBER_FORMAT_FLOAT32;
        columns[column_count++] = {attribute, format, components, static_cast<uint32_t>(components * sizeof(Number)),
                                   data};
    }
};

// A column and where it goes; `to` with components and stride resolved.
struct ColumnCopy {
    ResultColumn from;
    FlgBufferColumn to;
};

// What to write, checked: everything fits.
struct BufferPlan {
    std::array<ColumnCopy, 16> columns;
    uint32_t column_count = 0;
    uint32_t first_row = 0, row_count = 0;
    uint32_t triangle_count = 0;
    const uint32_t* triangles = nullptr;  // the first written
    const uint32_t* regions = nullptr;
    void* indices = nullptr;
    void* labels = nullptr;  // of triangles
    FlgNumberFormat index_format = FLG_NUMBER_FORMAT_UINT32, label_format = FLG_NUMBER_FORMAT_UINT32;
    uint32_t base_vertex = 0;
    bool left_handed = false;
    bool shifted = false;
    double shift[3] = {};  // added to positions
};

// Allocates nothing. Whole numbers must fit their formats.
void write_buffers(const BufferPlan& plan);

// Likewise in slices. Throws before anything is written if a whole number does not fit.
Task<void> write_buffers(Pace& pace, const BufferPlan& plan);

}  // namespace flg
