// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_textures.h"

#include <cmath>

#include "io/base/pictures.h"

namespace flg::io {

namespace {

constexpr size_t longest_name = 255;
constexpr uint64_t nearest = 9728, clamp_to_edge = 33071, mirrored_repeat = 33648, repeat = 10497;

FlgTextureWrap wrap_of(const Json& sampler, const char* key, const String& place) {
    const uint64_t wrap = gltf_unsigned(sampler, key, repeat, place);
    if (wrap == clamp_to_edge) return FLG_TEXTURE_WRAP_CLAMP;
    return wrap == mirrored_repeat ? FLG_TEXTURE_WRAP_MIRROR : FLG_TEXTURE_WRAP_REPEAT;
}

double number_in(const Json& object, const char* key, size_t index, double otherwise) {
    const Json* const found = object.find(key);
    if (found && found->is_array() && index < found->size() && (*found)[index].is_number())
        return (*found)[index].number();
    return otherwise;
}

// KHR_texture_transform: scaled, turned, moved.
void read_transform(const Json& info, GltfTextureUse& use, const String& place) {
    const Json* const extensions = info.find("extensions");
    const Json* const transform = extensions ? extensions->find("KHR_texture_transform") : nullptr;
    if (!transform || !transform->is_object()) return;
    const Json* const turn = transform->find("rotation");
    const double angle = turn && turn->is_number() ? turn->number() : 0;
    const double c = std::cos(angle), s = std::sin(angle);
    const double x = number_in(*transform, "scale", 0, 1), y = number_in(*transform, "scale", 1, 1);
    use.transform = {c * x,  s * y, number_in(*transform, "offset", 0, 0),
                     -s * x, c * y, number_in(*transform, "offset", 1, 0)};
    use.set = gltf_unsigned(*transform, "texCoord", use.set, place);
}

}  // namespace

std::optional<GltfUvs> GltfUvs::read(const GltfDocument& document, const GltfPrimitive& primitive,
                                     const GltfTextureUse& use, uint64_t vertex_count) {
    const std::optional<GltfValues> values =
        read_attribute(document, primitive, ("TEXCOORD_" + to_text(use.set)).c_str());
    if (!values) return {};
    const bool is_index = values->component_type == gltf_unsigned_int;
    if (values->components != 2 || is_index)
        fail(FLG_ERROR_FORMAT, values->place, "holds texture coordinates that are not two numbers a vertex");
    if (values->count != vertex_count)
        fail(FLG_ERROR_FORMAT, values->place + ".count", "is %llu, but there are %llu positions",
             static_cast<unsigned long long>(values->count), static_cast<unsigned long long>(vertex_count));
    return GltfUvs(*values, use);
}

std::array<float, 2> GltfUvs::at(uint32_t vertex) const {
    const double u = double{values_.number(vertex, 0)}, v = double{values_.number(vertex, 1)};
    const auto& m = transform_;
    const std::array<float, 2> uv = {static_cast<float>(m[0] * u + m[1] * v + m[2]),
                                     static_cast<float>(m[3] * u + m[4] * v + m[5])};
    for (const float value : uv)
        if (!(std::abs(value) <= max_coordinate)) refuse_value(values_, vertex, value);
    return uv;
}

GltfTextureUse GltfTextures::of_material(uint64_t material) {
    GltfTextureUse use;
    if (material >= document_.size("materials")) return use;
    const String place = "materials[" + to_text(material) + "].pbrMetallicRoughness";
    const Json* const factors = document_.element("materials", material, place).find("pbrMetallicRoughness");
    const Json* const info = factors ? factors->find("baseColorTexture") : nullptr;
    if (!info) return use;
    const String here = place + ".baseColorTexture";
    if (!info->is_object()) fail(FLG_ERROR_FORMAT, here, "is no object");
    use.set = gltf_unsigned(*info, "texCoord", 0, here);
    read_transform(*info, use, here);
    use.texture = find(gltf_required(*info, "index", here), here + ".index");
    return use;
}

uint32_t GltfTextures::find(uint64_t texture, const String& place) {
    const auto [found, is_new] = indices_.try_emplace(texture, FLG_NO_INDEX);
    if (!is_new) return found->second;
    if (std::optional<TextureData> data = read(texture, place)) {
        found->second = static_cast<uint32_t>(textures_.size());
        textures_.push_back(std::move(*data));
    }
    return found->second;
}

std::optional<TextureData> GltfTextures::read(uint64_t texture, const String& place) {
    const Json& json = document_.element("textures", texture, place);
    const String here = "textures[" + to_text(texture) + "]";
    TextureData data;
    if (const Json* const name = json.find("name")) data.name = name->string_or("");
    if (data.name.size() > longest_name) data.name.clear();
    if (json.find("sampler")) {
        const uint64_t index = gltf_required(json, "sampler", here);
        const Json& sampler = document_.element("samplers", index, here + ".sampler");
        const String sampler_place = "samplers[" + to_text(index) + "]";
        data.wrap_u = wrap_of(sampler, "wrapS", sampler_place);
        data.wrap_v = wrap_of(sampler, "wrapT", sampler_place);
        data.nearest = gltf_unsigned(sampler, "magFilter", 0, sampler_place) == nearest;
    }
    // Extensions name pictures of other formats.
    if (!json.find("source")) {
        others_.add(texture);
        return {};
    }
    const uint64_t source = gltf_required(json, "source", here);
    document_.element("images", source, here + ".source");
    try {
        data.picture = document_.image(source, here + ".source");
    } catch (const flg::Failure& failure) {
        if (failure.result() == FLG_ERROR_OUT_OF_MEMORY) throw;
        missing_.add(texture);
        return {};
    }
    if (!is_png(data.picture.bytes()) && !is_jpeg(data.picture.bytes())) {
        others_.add(texture);
        return {};
    }
    return data;
}

Vector<TextureData> GltfTextures::take(Vector<String>& warnings) {
    warn(warnings, missing_, "texture", "whose picture can't be read, left out");
    warn(warnings, others_, "texture", "whose picture is neither PNG nor JPEG, left out");
    return std::move(textures_);
}

}  // namespace flg::io
