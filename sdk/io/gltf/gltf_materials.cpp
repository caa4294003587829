// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_materials.h"

#include <algorithm>
#include <iterator>

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
    const Json* const two_sided = json.find("doubleSided");
    data.two_sided = two_sided && two_sided->is_boolean() && two_sided->boolean();
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
    material.texture = data.texture;
    material.two_sided = data.two_sided;
    return material;
}

FlgTexture texture_view(const TextureData& data) {
    auto texture = sized<FlgTexture>();
    texture.nearest = data.nearest;
    texture.wrap_u = data.wrap_u;
    texture.wrap_v = data.wrap_v;
    texture.picture = data.picture.bytes().data();
    texture.picture_size = data.picture.size();
    if (!data.name.empty()) texture.name = data.name.c_str();
    return texture;
}

namespace {

constexpr const char* lost_members[] = {"normalTexture", "occlusionTexture", "emissiveTexture", "emissiveFactor",
                                        "alphaMode"};

String json_texture_use(uint32_t texture) {
    return texture == FLG_NO_INDEX ? "" : "\"baseColorTexture\":{\"index\":" + to_text(texture) + "},";
}

}  // namespace

void LostLooks::add(const GltfDocument& document, uint64_t material) {
    if (material >= document.size("materials") || !seen_.try_emplace(material, true).second) return;
    const Json& json = document.element("materials", material, "materials");
    for (size_t k = 0; k < std::size(lost_members); ++k) {
        const Json* const member = json.find(lost_members[k]);
        bool is_default = !member || *member == "OPAQUE";
        if (member && member->is_array()) {
            is_default = true;
            for (size_t i = 0; i < member->size(); ++i)
                is_default = is_default && (*member)[i].is_number() && (*member)[i].number() == 0;
        }
        if (!is_default) lost_[k].add(material);
    }
    const Json* const factors = json.find("pbrMetallicRoughness");
    if (factors && factors->find("metallicRoughnessTexture")) lost_[kinds - 1].add(material);
}

void LostLooks::warn(Vector<String>& warnings) const {
    for (size_t k = 0; k < kinds; ++k) {
        const char* name = k < std::size(lost_members) ? lost_members[k] : "metallicRoughnessTexture";
        io::warn(warnings, lost_[k], "material", ("with " + String(name) + ", which is left out").c_str());
    }
}

String json_plain_material(const String& name, uint32_t texture) {
    return "{\"name\":\"" + name + "\",\"pbrMetallicRoughness\":{" + json_texture_use(texture) +
           "\"metallicFactor\":0,\"roughnessFactor\":0.6}}";
}

String json_material(const FlgMeshMaterial& material, const String& default_name, uint32_t texture) {
    String json = "{\"name\":" + json_text(material.name ? material.name : default_name) +
                  ",\"pbrMetallicRoughness\":{" + json_texture_use(texture) + "\"baseColorFactor\":[" +
                  json_color(material.color) + ",1],\"metallicFactor\":" + json_number(material.metallic) +
                  ",\"roughnessFactor\":" + json_number(material.roughness) + "}";
    if (material.two_sided) json += ",\"doubleSided\":true";
    if (material.border_width_px > 0) {
        json += ",\"extras\":{\"border_color\":[" + json_color(material.border_color) +
                "],\"border_width_px\":" + json_number(material.border_width_px) + "}";
    }
    return json + "}";
}

}  // namespace flg::io
