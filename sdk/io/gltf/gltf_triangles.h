// SPDX-License-Identifier: MIT
// Triangles of glTF primitives.
#pragma once

#include <cstdint>

#include "io/base/memory.h"
#include "io/gltf/gltf_scene.h"

namespace flg::io {

// Calls add(a, b, c) for each triangle of TRIANGLES, TRIANGLE_STRIP or TRIANGLE_FAN. Strips and fans lose those that
// name a vertex twice: they only lead on.
template <class Add>
void visit_triangles(uint64_t mode, const Vector<uint32_t>& indices, Add add) {
    if (mode == gltf_triangles) {
        for (size_t i = 2; i < indices.size(); i += 3) add(indices[i - 2], indices[i - 1], indices[i]);
        return;
    }
    const bool fan = mode == gltf_triangle_fan;
    for (size_t i = 2; i < indices.size(); ++i) {
        const uint32_t a = fan ? indices[0] : indices[i - 2], b = indices[i - 1], c = indices[i];
        if (a == b || b == c || c == a) continue;
        if (fan || i % 2 == 0)
            add(a, b, c);
        else
            add(b, a, c);
    }
}

}  // namespace flg::io
