// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.7.2.2 morph targets, 3.11 animations).
// Morph targets of a skin that one node shows, and the animations of their weights. What can't be read is named in a
// warning, and the mesh is read without its shapes.
#pragma once

#include "io/base/skin_data.h"
#include "io/gltf/gltf_scene.h"

namespace flg::io {

class GltfMorphReader {
public:
    explicit GltfMorphReader(const GltfDocument& document) : document_(document) {}

    // The targets of vertices that follow those before; of a primitive at this node.
    void append(const GltfPrimitive& primitive, uint64_t node, uint64_t vertex_count);
    // Hands over the targets.
    void finish(SkinData& data);
    // Whether an animation has weights for them; then they are read. `index`: of the skin's animation that it is too.
    bool read_animation(const Json& animation, const String& place, const String& name, uint32_t index,
                        SkinData& data) const;

private:
    void append_values(const Json& target, const char* name, const GltfPrimitive& primitive, uint64_t vertex_count,
                       Vector<float>& to) const;
    String name_of(size_t target) const;

    const GltfDocument& document_;
    Vector<MorphTargetData> targets_;
    uint64_t node_ = UINT64_MAX;
    size_t vertex_count_ = 0;
    bool is_uneven_ = false;  // they can't be told as shapes of the whole
    bool has_any_ = false;
};

}  // namespace flg::io
