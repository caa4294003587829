// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_materials.h"

#include <algorithm>

#include "core/sized_struct.h"
#include "io/base/json_text.h"

namespace flg::io {

namespace {

constexpr float widest_border_px = 64;

float number_of(const Json& value, float most, const String& place) {
    if (!value.is_number()) fail(FLG_ERROR_FORMAT, place, "is no number");
    return static_cast<float>(std::clamp(value.number(), 0.0, double{most}));
}

void read_number(const Json& object, const char* key, float most, const String& place, float& to) {
    if (const Json* const value = object.find(key)) to = number_of(*value, most, place + "." + key);
}

// Three numbers, and a fourth that is passed over. Returns whether they are there.
bool read_color(const Json& object, const char* key, const String& place, float* to) {
    const Json* values = gltf_array(object, key, place);
    if (!values) return false;
    constexpr size_t components = 3;
    if (values->size() < components) fail(FLG_ERROR_FORMAT, place + "." + key, "has %zu numbers", values->size());
    for (size_t k = 0; k < components; ++k) to[k] = number_of((*values)[k], 1, place + "." + key);
    return true;
}

String json_color(const float* color) {
    return json_number(color[0]) + "," + json_number(color[1]) + "," + json_number(color[2]);
}

}  // namespace

GltfMaterial read_material(const GltfDocument& document, uint64_t index, const String& place) {
    GltfMaterial material;
    if (index >= document.size("materials")) return material;
    const Json& json = document.element("materials", index, place);
    const String here = "materials[" + to_text(index) + "]";
    MaterialData& data = material.data;
    if (const Json* const name = json.find("name")) data.name = name->string_or("");
    if (const Json* const factors = json.find("pbrMetallicRoughness")) {
        const String inside = here + ".pbrMetallicRoughness";
        if (!factors->is_object()) fail(FLG_ERROR_FORMAT, inside, "is no object");
        material.says_color = read_color(*factors, "baseColorFactor", inside, data.color);
        read_number(*factors, "metallicFactor", 1, inside, data.metallic);
        read_number(*factors, "roughnessFactor", 1, inside, data.roughness);
    }
    // Other programs' extras may be anything.
    if (const Json* const extras = json.find("extras"); extras && extras->find("border_width_px")) {
        const String inside = here + ".extras";
        read_color(*extras, "border_color", inside, data.border_color);
        read_number(*extras, "border_width_px", widest_border_px, inside, data.border_width_px);
    }
    return material;
}

FlgMeshMaterial material_view(const MaterialData& data) {
    auto material = sized<FlgMeshMaterial>();
    material.name = data.name.c_str();
    std::copy_n(data.color, 3, material.color);
    material.metallic = data.metallic;
    material.roughness = data.roughness;
    std::copy_n(data.border_color, 3, material.border_color);
    material.border_width_px = data.border_width_px;
    return material;
}

namespace {

constexpr const char* first_texture = "\"baseColorTexture\":{\"index\":0},";

}  // namespace

String json_plain_material(const String& name, bool has_texture) {
    return "{\"name\":\"" + name + "\",\"pbrMetallicRoughness\":{" + (has_texture ? first_texture : "") +
           "\"metallicFactor\":0,\"roughnessFactor\":0.6}}";
}

String json_material(const FlgMeshMaterial& material, const String& default_name, bool has_texture) {
    String json = "{\"name\":" + json_text(material.name ? material.name : default_name) +
                  ",\"pbrMetallicRoughness\":{" + (has_texture ? first_texture : "") + "\"baseColorFactor\":[" +
                  json_color(material.color) + ",1],\"metallicFactor\":" + json_number(material.metallic) +
                  ",\"roughnessFactor\":" + json_number(material.roughness) + "}";
    if (material.border_width_px > 0) {
        json += ",\"extras\":{\"border_color\":[" + json_color(material.border_color) +
                "],\"border_width_px\":" + json_number(material.border_width_px) + "}";
    }
    return json + "}";
}

}  // namespace flg::io
