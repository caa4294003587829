// SPDX-License-Identifier: MIT
// A column that a cut carries along, taken away again at the end, however it ends.
#pragma once

#include "surfaces/mesh/mesh_growth.h"

namespace flg {

class ExtraColumn {
public:
    ExtraColumn(MeshColumns& columns, GrowingBuffer<float> values) : columns_(columns) {
        columns_.push_back({1, std::move(values)});
    }
    ~ExtraColumn() { columns_.pop_back(); }
    ExtraColumn(const ExtraColumn&) = delete;
    ExtraColumn& operator=(const ExtraColumn&) = delete;

    uint32_t index() const { return static_cast<uint32_t>(columns_.size() - 1); }
    const GrowingBuffer<float>& values() const { return columns_.back().values; }

private:
    MeshColumns& columns_;
};

}  // namespace flg
