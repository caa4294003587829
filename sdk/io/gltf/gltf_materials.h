// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (5.19 material, 5.22 material.pbrMetallicRoughness).
// Materials of glTF documents: their factors and their names, and the border lines that Filigree writes as `extras`.
#pragma once

#include "io/base/memory.h"
#include "io/base/mesh_data.h"
#include "io/gltf/gltf_document.h"

namespace flg::io {

struct GltfMaterial {
    MaterialData data;
    bool says_color = false;
};

// Numbers outside of their range are taken to its ends; what is no number is refused. A material that isn't there is
// the format's default.
GltfMaterial read_material(const GltfDocument& document, uint64_t index, const String& place);

// As hosts see it; lives as long as `data`.
FlgMeshMaterial material_view(const MaterialData& data);

// A material as JSON, to be read back with the same look; `default_name` where it has no name. With texture 0, if
// asked for.
String json_material(const FlgMeshMaterial& material, const String& default_name, bool has_texture = false);

// One that says no colour: `name` needs no escapes.
String json_plain_material(const String& name, bool has_texture = false);

}  // namespace flg::io
