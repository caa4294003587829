// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (5.28 sampler, 5.29 texture, 5.30 textureInfo), KHR_texture_transform.
// Base colour textures of glTF documents, each once, and the texture coordinates that they are seen by. Pictures that
// are not there, or of other formats, are named in a warning: the mesh is read without them.
#pragma once

#include <array>
#include <optional>

#include "io/base/memory.h"
#include "io/base/mesh_data.h"
#include "io/gltf/gltf_scene.h"

namespace flg::io {

// What a material takes of a primitive's texture coordinates.
struct GltfTextureUse {
    uint32_t texture = FLG_NO_INDEX;  // of those that are read
    uint64_t set = 0;                 // TEXCOORD_n
    // u = a u + b v + c, v = d u + e v + f
    std::array<double, 6> transform = {1, 0, 0, 0, 1, 0};
};

// Texture coordinates of a primitive's vertices, as its material sees them.
class GltfUvs {
public:
    // None: the primitive has none.
    static std::optional<GltfUvs> read(const GltfDocument& document, const GltfPrimitive& primitive,
                                       const GltfTextureUse& use, uint64_t vertex_count);
    std::array<float, 2> at(uint32_t vertex) const;

private:
    GltfUvs(GltfValues values, const GltfTextureUse& use) : values_(std::move(values)), transform_(use.transform) {}

    GltfValues values_;
    std::array<double, 6> transform_;
};

class GltfTextures {
public:
    explicit GltfTextures(const GltfDocument& document) : document_(document) {}

    // Of a material; of none, nothing.
    GltfTextureUse of_material(uint64_t material);
    // Hands over what was read, and warns of what was not.
    Vector<TextureData> take(Vector<String>& warnings);

private:
    uint32_t find(uint64_t texture, const String& place);
    std::optional<TextureData> read(uint64_t texture, const String& place);

    const GltfDocument& document_;
    Map<uint64_t, uint32_t> indices_;  // by texture of the document
    Vector<TextureData> textures_;
    Tally missing_, others_;
};

}  // namespace flg::io
