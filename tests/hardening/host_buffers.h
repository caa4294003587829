// SPDX-License-Identifier: MIT
// Buffers of a host that results are written into.
#pragma once

#include <array>
#include <initializer_list>

#include "filigree/filigree_buffers.h"
#include "hardening/calls.h"

namespace flg::test {

// Of a thread, so longer than its contexts: where a scenario ends early, a job may still write.
struct HostBuffers {
    static constexpr uint32_t rows = 4096;
    std::array<FlgBufferColumn, 4> columns;
    std::array<std::array<float, 4 * rows>, 4> numbers;
    std::array<uint32_t, 6 * rows> indices, regions;
};

inline HostBuffers& host_buffers() {
    static thread_local HostBuffers buffers;
    return buffers;
}

// All columns that are named, cleared.
inline FlgBufferOutput output_to_buffers(Calls& calls,
                                         std::initializer_list<std::pair<FlgAttribute, FlgNumberFormat>> columns) {
    HostBuffers& buffers = host_buffers();
    FlgBufferOutput output = FLG_INIT(calls, flgBufferOutputInit);
    for (const auto& [attribute, format] : columns) {
        buffers.numbers[output.column_count].fill(0);
        FlgBufferColumn& column = buffers.columns[output.column_count];
        column = {};
        column.attribute = attribute;
        column.format = format;
        column.data = buffers.numbers[output.column_count++].data();
    }
    output.columns = buffers.columns.data();
    output.row_capacity = HostBuffers::rows;
    return output;
}

// Likewise triangles.
inline void add_triangles(FlgBufferOutput& output) {
    HostBuffers& buffers = host_buffers();
    buffers.indices.fill(0);
    output.indices = buffers.indices.data();
    output.index_capacity = buffers.indices.size();
}

inline void note_buffers(Calls& calls, const FlgBufferOutput& output) {
    const HostBuffers& buffers = host_buffers();
    for (uint32_t c = 0; c < output.column_count; ++c) calls.note(&buffers.numbers[c], sizeof buffers.numbers[c]);
    if (output.indices) calls.note(&buffers.indices, sizeof buffers.indices);
    if (output.regions) calls.note(&buffers.regions, sizeof buffers.regions);
}

}  // namespace flg::test
