// SPDX-License-Identifier: MIT
// A sparse symmetric matrix: its diagonal and, row by row, what is off it. Both halves are kept: entry (i, j) stands in
// row i and in row j. Columns of a row ascend.
#pragma once

#include <cstdint>

#include "core/memory.h"

namespace flg {

struct SymmetricMatrix {
    uint32_t size() const { return static_cast<uint32_t>(diagonal.size()); }

    Buffer<double> diagonal;
    Buffer<uint32_t> offsets;  // where each row begins, and the end
    Buffer<uint32_t> columns;
    Buffer<double> values;
};

}  // namespace flg
