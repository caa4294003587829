// SPDX-License-Identifier: MIT
// The columns of a host's view of curves or of a mesh, checked whole before anything is made of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "filigree/filigree.h"

namespace flg::io {

// A column with its stride resolved; null data when the view has none of that attribute.
struct Column {
    const float* data = nullptr;
    size_t stride = 0;  // bytes
    explicit operator bool() const { return data != nullptr; }
    const float* at(size_t point) const {
        return reinterpret_cast<const float*>(reinterpret_cast<const char*>(data) + point * stride);
    }
};

class CheckedColumns {
public:
    CheckedColumns() = default;
    // Fails with FLG_ERROR_INVALID_ARGUMENT at the first thing that is wrong. The host's arrays must outlive this.
    CheckedColumns(const FlgColumn* columns, uint32_t count, size_t point_count);

    Column find(FlgAttribute attribute) const;

private:
    void check(uint32_t index, size_t point_count) const;

    const FlgColumn* columns_ = nullptr;
    uint32_t count_ = 0;
};

Column resolved(const FlgColumn& column);

// The values of a column back to back.
std::vector<float> packed(const Column& column, size_t point_count, uint32_t components);

}  // namespace flg::io
