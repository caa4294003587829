// SPDX-License-Identifier: MIT
#include "io/text/mtl.h"

#include <algorithm>

#include "io/base/pictures.h"
#include "io/text/text_lines.h"

namespace flg::io {

namespace {

// Numbers of 0 to 1, as many as are there.
void read_shares(LineCursor cursor, float* to, size_t count) {
    for (size_t k = 0; k < count && cursor.more(); ++k) {
        const std::string_view word = cursor.word();
        float value = 0;
        if (std::from_chars(word.data(), word.data() + word.size(), value).ec != std::errc{}) return;
        to[k] = std::clamp(value, 0.0f, 1.0f);
    }
}

// The file that a map is: what follows its options.
std::string_view file_of(LineCursor cursor) {
    const std::string_view rest = cursor.rest();
    if (!rest.starts_with('-')) return rest;
    const size_t blank = rest.find_last_of(" \t");
    return blank == rest.npos ? std::string_view() : rest.substr(blank + 1);
}

}  // namespace

std::optional<Path> MtlLibrary::below(std::string_view file) const {
    String name(file);
    std::replace(name.begin(), name.end(), '\\', '/');
    const bool parent = ("/" + name + "/").find("/../") != name.npos;
    if (name.empty() || name.find_first_of(std::string_view(":\0", 2)) != name.npos || name.starts_with('/') || parent)
        return {};
    Path target = path_.beside(name);
    if (!stays_beside(target, path_)) return {};
    return target;
}

void MtlLibrary::read(std::string_view file) {
    ByteBlock bytes;
    try {
        if (const std::optional<Path> path = below(file)) bytes = read_file(*path, "");
    } catch (const flg::Failure& failure) {
        if (failure.result() == FLG_ERROR_OUT_OF_MEMORY) throw;
    }
    if (bytes.size() == 0) {
        warnings_.push_back("the materials of " + cited(file) + " can't be read: left out");
        return;
    }
    TextLines lines(as_text(bytes.bytes()));
    Material* material = nullptr;
    for (std::string_view line; lines.next(line);) {
        LineCursor cursor(line, lines.number());
        const std::string_view keyword = cursor.word();
        if (keyword == "newmtl") {
            material = &materials_[String(cursor.rest())];
            *material = {};
            material->data.name = String(cursor.rest());
            if (material->data.name.size() > 255 || !is_utf8(material->data.name)) material->data.name.clear();
            material->data.metallic = 0;
            material->data.roughness = material_defaults().roughness;
        }
        if (!material) continue;
        if (keyword == "Kd") read_shares(cursor, material->data.color, 3);
        if (keyword == "Pm") read_shares(cursor, &material->data.metallic, 1);
        if (keyword == "Pr") read_shares(cursor, &material->data.roughness, 1);
        if (keyword == "map_Kd") material->picture = String(file_of(cursor));
    }
}

MaterialData MtlLibrary::find(const String& name) {
    const auto found = materials_.find(name);
    MaterialData data;
    if (found != materials_.end()) {
        data = found->second.data;
        if (!found->second.picture.empty()) data.texture = texture_of(found->second.picture);
        return data;
    }
    data.name = is_utf8(name) && name.size() <= 255 ? name : "";
    data.metallic = 0;
    data.roughness = material_defaults().roughness;
    return data;
}

uint32_t MtlLibrary::texture_of(const String& picture) {
    const auto [found, is_new] = textures_by_file_.try_emplace(picture, FLG_NO_INDEX);
    if (!is_new) return found->second;
    TextureData texture;
    try {
        if (const std::optional<Path> path = below(picture)) texture.picture = read_file(*path, "");
    } catch (const flg::Failure& failure) {
        if (failure.result() == FLG_ERROR_OUT_OF_MEMORY) throw;
    }
    if (!is_png(texture.picture.bytes()) && !is_jpeg(texture.picture.bytes())) {
        const bool is_there = texture.picture.size() != 0;
        warnings_.push_back("the texture " + cited(picture) +
                            (is_there ? " is neither PNG nor JPEG: left out" : " can't be read: left out"));
        return FLG_NO_INDEX;
    }
    found->second = static_cast<uint32_t>(textures_.size());
    textures_.push_back(std::move(texture));
    return found->second;
}

Vector<TextureData> MtlLibrary::take(Vector<String>& warnings) {
    warnings.insert(warnings.end(), warnings_.begin(), warnings_.end());
    return std::move(textures_);
}

}  // namespace flg::io
