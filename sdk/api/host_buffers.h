// SPDX-License-Identifier: MIT
// Buffers of the host that are written to: aligned, large enough, apart from each other and from what is read.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>

#include "filigree/filigree.h"

namespace flg {

// What sentences call a buffer, or one of its fields.
struct BlockName {
    BlockName() { text[0] = '\0'; }
    [[gnu::format(printf, 2, 3)]] explicit BlockName(const char* format, ...);
    char text[48];
};

// Memory that is written or read: `count` elements, of which `size` of every `stride` bytes are used.
struct Block {
    BlockName name;
    const void* data = nullptr;
    uint64_t stride = 0, size = 0, count = 0;

    bool meets(const Block& other) const;
};

// All that a call touches.
class Blocks {
public:
    // Outputs come first.
    void add_output(const Block& block);
    void add_input(const Block& block) { blocks_[count_++] = block; }
    void add_input(const FlgColumn& column, uint64_t rows, const BlockName& name);
    // Refuses an output that overlaps anything.
    void check_apart() const;

private:
    std::array<Block, 40> blocks_;
    uint32_t count_ = 0, output_count_ = 0;
};

// Refuses what output.columns[i] can't be, whatever there is to write. None before it is of the same attribute.
void check_buffer_column(const FlgBufferColumn* columns, uint32_t i);

// Refuses null, and what is not aligned to `number` bytes.
void check_aligned(const void* data, uint32_t number, const char* name);
// The stride that a host means: 0 stands for `size`.
uint32_t checked_stride(uint32_t stride, uint32_t number, uint32_t size, const char* name);
void check_capacity(uint64_t capacity, uint64_t needed, const char* name);
// output.indices, for `count` indices of vertices below `end_vertex`.
void check_indices(const void* indices, const FlgNumberFormat& format, uint64_t capacity, uint64_t count,
                   uint64_t end_vertex);

}  // namespace flg
