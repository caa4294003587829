// SPDX-License-Identifier: MIT
// What covers a model: materials by part, textures, colours of vertices.
#pragma once

#include <string>
#include <vector>

#include "documents/mesh_file.h"
#include "documents/model_drawing.h"
#include "documents/report.h"
#include "drawn_picture.h"
#include "filigree/filigree_io.h"

namespace flg::cli {

struct SkinLooks {
    std::vector<FlgMeshMaterial> materials;
    std::vector<FlgTexture> textures;
    std::vector<uint8_t> picture;  // instead, of all materials: a PNG file
    std::vector<float> colors;     // 4 a vertex, or none

    void describe(FlgSkinFileWriteDesc& file) const;
};

// Of a model that was drawn; names are the drawing's.
SkinLooks looks_of(const PictureOptions& options, const ModelDrawing& drawing, const FlgModelView& bones);

// Of a mesh, which outlives them; `skin`, made of it, gets its texture coordinates and its regions. What can't be kept
// is warned of.
SkinLooks looks_of(const MeshFile& mesh, FlgSkinView& skin, Report& report);

}  // namespace flg::cli
