// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (5.19 material, 5.22 material.pbrMetallicRoughness).
// Materials of glTF documents: their factors and their names, and the border lines that Filigree writes as `extras`.
// Their textures are gltf_textures.h's.
#pragma once

#include "io/base/memory.h"
#include "io/base/mesh_data.h"
#include "io/base/tally.h"
#include "io/gltf/gltf_document.h"

namespace flg::io {

struct GltfMaterial {
    MaterialData data;
    bool says_color = false;
};

// Numbers outside of their range are taken to its ends; what is no number is refused. A material that isn't there is
// the format's default.
GltfMaterial read_material(const GltfDocument& document, uint64_t index, const String& place);

// What materials say besides, which is not read.
class LostLooks {
public:
    void add(const GltfDocument& document, uint64_t material);
    void warn(Vector<String>& warnings) const;

private:
    static constexpr size_t kinds = 6;
    Tally lost_[kinds];
    Map<uint64_t, bool> seen_;
};

// As hosts see it; lives as long as `data`.
FlgMeshMaterial material_view(const MaterialData& data);
FlgTexture texture_view(const TextureData& data);

// A material as JSON, to be read back with the same look; `default_name` where it has no name. `texture`: of the
// document's, in place of the material's own.
String json_material(const FlgMeshMaterial& material, const String& default_name, uint32_t texture = FLG_NO_INDEX);

// One that says no colour: `name` needs no escapes.
String json_plain_material(const String& name, uint32_t texture = FLG_NO_INDEX);

}  // namespace flg::io
