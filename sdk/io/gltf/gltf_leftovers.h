// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.6 accessors).
// What a document no longer needs once primitives are gone: the accessors that only these use, and the buffer views
// that only those accessors use. Nothing where extensions may refer to accessors in ways that are not known here.
#pragma once

#include <functional>

#include "io/gltf/gltf_document.h"

namespace flg::io {

struct GltfLeftovers {
    Vector<size_t> accessors, views;  // rising
};

// `is_gone(mesh, primitive)`.
GltfLeftovers find_leftovers(const GltfDocument& document, const std::function<bool(uint64_t, uint64_t)>& is_gone);

}  // namespace flg::io
