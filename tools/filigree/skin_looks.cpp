// SPDX-License-Identifier: MIT
#include "skin_looks.h"

#include <algorithm>

#include "support/curve_source.h"

namespace flg::cli {
namespace {

constexpr uint32_t most_labels = 1024;  // that become materials

// The colours of a mesh's vertices, back to back.
std::vector<float> colors_of(const FlgMeshView& mesh) {
    std::vector<float> colors;
    for (uint32_t i = 0; i < mesh.column_count; ++i) {
        if (mesh.columns[i].attribute != FLG_ATTRIBUTE_COLOR) continue;
        for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
            const float* rgba = samples::value_at(mesh.columns[i], v);
            for (size_t k = 0; k < 4; ++k) colors.push_back(std::clamp(rgba[k], 0.0f, 1.0f));
        }
    }
    return colors;
}

void warn_of_columns(const MeshFile& mesh, Report& report) {
    const FlgMeshView& view = mesh.view();
    const auto is_lost = [](const FlgColumn& column) {
        return column.attribute != FLG_ATTRIBUTE_POSITION && column.attribute != FLG_ATTRIBUTE_NORMAL &&
               column.attribute != FLG_ATTRIBUTE_COLOR;
    };
    const auto lost = std::count_if(view.columns, view.columns + view.column_count, is_lost);
    if (lost > 0)
        report.warn(mesh.name() + ": " + std::to_string(lost) + (lost == 1 ? " column" : " columns") +
                    " of vertices besides positions, normals and colours: not kept");
    std::string names;
    for (const FlgMeshFaceColumn& column : mesh.face_columns())
        names += (names.empty() ? "" : ", ") + std::string(column.name);
    if (!names.empty()) report.warn(mesh.name() + ": columns of faces are not kept: " + names);
}

}  // namespace

void SkinLooks::describe(FlgSkinFileWriteDesc& file) const {
    file.materials = materials.data();
    file.material_count = static_cast<uint32_t>(materials.size());
    file.textures = textures.data();
    file.texture_count = static_cast<uint32_t>(textures.size());
    if (!picture.empty()) file.texture = picture.data();
    file.texture_size = picture.size();
    if (!colors.empty()) file.vertex_colors = colors.data();
}

SkinLooks looks_of(const PictureOptions& options, const ModelDrawing& drawing, const FlgModelView& bones) {
    SkinLooks looks;
    if (!options.file.empty()) looks.picture = bled_picture(options, drawing);
    for (uint32_t p = 0; p < bones.part_count && drawing.has_colors; ++p) {
        const DrawnPart& part = drawing.parts[bones.part_sources[p]];
        looks.materials.push_back(part.material);
        looks.materials.back().name = part.name.c_str();
        // The picture says the colours.
        if (!looks.picture.empty()) std::fill_n(looks.materials.back().color, 3, 1.0f);
    }
    return looks;
}

SkinLooks looks_of(const MeshFile& mesh, FlgSkinView& skin, Report& report) {
    SkinLooks looks;
    const FlgMeshFileInfo& info = mesh.info();
    for (uint32_t i = 0; i < info.warning_count; ++i) report.warn(mesh.name() + ": " + info.warnings[i]);
    warn_of_columns(mesh, report);
    looks.materials = mesh.materials();
    looks.textures = mesh.textures();
    looks.colors = colors_of(mesh.view());
    skin.corner_uvs = info.corner_uvs;
    const uint32_t* const regions = mesh.view().regions;
    if (!regions) return looks;
    const uint32_t highest = *std::max_element(regions, regions + mesh.view().triangle_count);
    if (looks.materials.empty() && highest < most_labels)
        looks.materials.assign(highest + 1, flgMeshMaterialDefaults());
    if (highest < looks.materials.size()) {
        skin.triangle_parts = regions;
        skin.vertex_parts = nullptr;  // limbs, which are no materials
    } else {
        report.warn(mesh.name() + ": labels of regions up to " + std::to_string(highest) + ": not kept");
    }
    return looks;
}

}  // namespace flg::cli
