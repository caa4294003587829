// SPDX-License-Identifier: MIT
// Source: Wavefront's MTL specification (newmtl, Kd, map_Kd); physically based materials extend it (Pr, Pm).
// Materials of .obj files, and textures of these and .ply files.
#pragma once

#include <optional>

#include "io/base/checked_views.h"
#include "io/base/files.h"
#include "io/base/json_text.h"
#include "io/base/memory.h"
#include "io/base/mesh_data.h"

namespace flg::io {

class MtlLibrary {
public:
    // `path`: the mesh file's; libraries and pictures lie in its folder or below.
    explicit MtlLibrary(const Path& path) : path_(path) {}

    // Reads a library. What is not there becomes a warning.
    void read(std::string_view file);
    // A material, with its texture; what no library has is white.
    MaterialData find(const String& name);
    bool says_color(const String& name) const { return materials_.contains(name); }
    // A picture's file; FLG_NO_INDEX: it can't be read.
    uint32_t texture_of(const String& picture);
    // Hands over the textures of the materials that were asked for.
    Vector<TextureData> take(Vector<String>& warnings);

private:
    struct Material {
        MaterialData data;
        String picture;  // a file; empty: none
    };
    // A file below the folder; none: it leads out.
    std::optional<Path> below(std::string_view file) const;
    const Path path_;
    Map<String, Material> materials_;
    Map<String, uint32_t> textures_by_file_;
    Vector<TextureData> textures_;
    Vector<String> warnings_;
};

}  // namespace flg::io
