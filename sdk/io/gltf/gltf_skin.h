// SPDX-License-Identifier: MIT
// Skinned meshes in glTF 2.0 files: read from .gltf and .glb, written to .glb.
#pragma once

#include <optional>

#include "io/base/checked_views.h"
#include "io/base/files.h"
#include "io/base/memory.h"
#include "io/base/skin_data.h"

namespace flg::io {

// None: the scene shows no skin.
std::optional<SkinData> read_gltf_skin(const Path& path);

String write_glb_skin(const CheckedSkin& skin);

}  // namespace flg::io
