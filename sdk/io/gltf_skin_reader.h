// SPDX-License-Identifier: MIT
// Skinned meshes of glTF files.
#pragma once

#include <filesystem>
#include <optional>

#include "io/skin_data.h"

namespace flg::io {

// None: the scene shows no skin.
std::optional<SkinData> read_gltf_skin(const std::filesystem::path& path);

}  // namespace flg::io
