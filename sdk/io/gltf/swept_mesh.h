// SPDX-License-Identifier: MIT
// Triangles of ribbons and tubes along curves, in pieces.
#pragma once

#include <cstdint>

#include "filigree/filigree_io.h"
#include "io/base/checked_views.h"
#include "io/base/memory.h"

namespace flg::io {

// Neighbouring curves of one geometry. At most 65,535 vertices, so that 16 bits number them, if it has more than one
// curve.
struct SweptPiece {
    FlgCurveGeometry geometry;
    Vector<float> positions;
    Vector<float> normals;
    Vector<float> colors;  // empty without a COLOR column
    Vector<uint32_t> indices;

    size_t vertex_count() const { return positions.size() / 3; }
};

// Each curve is a RIBBON or a TUBE: desc.geometries, else desc.geometry. Curves without length leave nothing.
Vector<SweptPiece> sweep(const CheckedView& view, const FlgCurveFileWriteDesc& desc);

}  // namespace flg::io
