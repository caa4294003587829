// SPDX-License-Identifier: MIT
// Triangles of ribbons and tubes along curves.
#pragma once

#include <cstdint>
#include <vector>

#include "filigree/filigree_io.h"
#include "io/checked_view.h"

namespace flg::io {

struct SweptMesh {
    std::vector<float> positions;
    std::vector<float> normals;
    std::vector<float> colors;  // empty without a COLOR column
    std::vector<uint32_t> indices;
};

// desc.geometry is RIBBON or TUBE. Curves without length leave nothing.
SweptMesh sweep(const CheckedView& view, const FlgCurveWriteDesc& desc);

}  // namespace flg::io
