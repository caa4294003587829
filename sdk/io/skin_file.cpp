// SPDX-License-Identifier: MIT
// The C ABI of files with skins, translated onto this room.
#include <algorithm>
#include <memory>

#include "filigree/filigree_io.h"
#include "io/base/checked_views.h"
#include "io/base/entry_point.h"
#include "io/base/files.h"
#include "io/gltf/gltf_materials.h"
#include "io/gltf/gltf_skin.h"

struct FlgSkinFileT {
    flg::io::SkinData data;
    float box_min[3], box_max[3];
    uint32_t part_count = 1;
    std::vector<const char*> joint_names, warnings;
    std::vector<FlgSkinAnimation> animations;
    std::vector<FlgMeshMaterial> materials;
};

namespace flg::io {

namespace {

FlgSkinAnimation view_of(const AnimationData& data) {
    FlgSkinAnimation view = {};
    view.struct_size = sizeof view;
    view.key_count = static_cast<uint32_t>(data.times.size());
    view.name = data.name.c_str();
    view.times = data.times.data();
    view.rotations = data.rotations.data();
    view.translations = data.translations.empty() ? nullptr : data.translations.data();
    return view;
}

std::unique_ptr<FlgSkinFileT> make_file(SkinData&& read) {
    auto file = std::make_unique<FlgSkinFileT>();
    file->data = std::move(read);
    const SkinData& data = file->data;
    for (size_t k = 0; k < 3; ++k) file->box_min[k] = file->box_max[k] = data.positions[k];
    for (size_t i = 0; i < data.positions.size(); ++i) {
        file->box_min[i % 3] = std::min(file->box_min[i % 3], data.positions[i]);
        file->box_max[i % 3] = std::max(file->box_max[i % 3], data.positions[i]);
    }
    file->part_count = 1 + *std::max_element(data.parts.begin(), data.parts.end());
    for (const std::string& name : data.joint_names) file->joint_names.push_back(name.c_str());
    for (const std::string& warning : data.warnings) file->warnings.push_back(warning.c_str());
    for (const AnimationData& animation : data.animations) file->animations.push_back(view_of(animation));
    for (const MaterialData& material : data.materials) file->materials.push_back(material_view(material));
    return file;
}

}  // namespace

}  // namespace flg::io

using namespace flg::io;

extern "C" {

FlgResult flgSkinFileRead(const char* path, FlgSkinFile* out_file) {
    if (out_file) *out_file = nullptr;
    return guarded(path ? path : "flgSkinFileRead", [&] {
        check_argument(path, "path");
        check_argument(out_file, "out_file");
        const std::filesystem::path source = to_path(path);
        const std::string extension = extension_of(source);
        if (extension != ".gltf" && extension != ".glb") {
            fail(FLG_ERROR_FORMAT, "", "holds no skin: %s is none of .gltf .glb", cited(extension).c_str());
        }
        std::optional<SkinData> data = read_gltf_skin(source);
        if (data) *out_file = make_file(std::move(*data)).release();
    });
}

FlgResult flgSkinFileGetView(FlgSkinFile file, FlgSkinView* out_view) {
    return guarded("flgSkinFileGetView", [&] {
        const uint32_t struct_size = open_out(out_view, "out_view");
        check_argument(file, "file");
        const SkinData& data = file->data;
        FlgSkinView view = {};
        view.vertex_count = static_cast<uint32_t>(data.vertex_count());
        view.triangle_count = static_cast<uint32_t>(data.triangle_count());
        view.joint_count = static_cast<uint32_t>(data.joint_parents.size());
        view.positions = data.positions.data();
        view.normals = data.normals.data();
        view.triangles = data.triangles.data();
        view.vertex_joints = data.joints.data();
        view.vertex_weights = data.weights.data();
        view.vertex_parts = data.parts.data();
        view.joint_positions = data.joint_positions.data();
        view.joint_parents = data.joint_parents.data();
        view.joint_names = file->joint_names.data();
        hand_out(view, out_view, struct_size);
    });
}

FlgResult flgSkinFileGetAnimations(FlgSkinFile file, const FlgSkinAnimation** out_animations, uint32_t* out_count) {
    if (out_animations) *out_animations = nullptr;
    if (out_count) *out_count = 0;
    return guarded("flgSkinFileGetAnimations", [&] {
        check_argument(file, "file");
        check_argument(out_animations, "out_animations");
        check_argument(out_count, "out_count");
        if (file->animations.empty()) return;
        *out_animations = file->animations.data();
        *out_count = static_cast<uint32_t>(file->animations.size());
    });
}

FlgResult flgSkinFileGetMaterials(FlgSkinFile file, const FlgMeshMaterial** out_materials, uint32_t* out_count) {
    if (out_materials) *out_materials = nullptr;
    if (out_count) *out_count = 0;
    return guarded("flgSkinFileGetMaterials", [&] {
        check_argument(file, "file");
        check_argument(out_materials, "out_materials");
        check_argument(out_count, "out_count");
        if (file->materials.empty()) return;
        *out_materials = file->materials.data();
        *out_count = static_cast<uint32_t>(file->materials.size());
    });
}

FlgResult flgSkinFileGetInfo(FlgSkinFile file, FlgSkinFileInfo* out_info) {
    return guarded("flgSkinFileGetInfo", [&] {
        const uint32_t struct_size = open_out(out_info, "out_info");
        check_argument(file, "file");
        FlgSkinFileInfo info = {};
        info.part_count = file->part_count;
        std::copy_n(file->box_min, 3, info.box_min);
        std::copy_n(file->box_max, 3, info.box_max);
        info.warning_count = static_cast<uint32_t>(file->warnings.size());
        info.warnings = file->warnings.data();
        hand_out(info, out_info, struct_size);
    });
}

void flgSkinFileRelease(FlgSkinFile file) {
    delete file;
}

FlgResult flgSkinFileDescInit(FlgSkinFileDesc* desc, uint32_t struct_size) {
    return guarded("flgSkinFileDescInit", [&] {
        check_argument(desc, "desc");
        check_size<FlgSkinFileDesc>(struct_size, "desc");
        std::memset(desc, 0, struct_size);
        hand_out(skin_file_defaults(), desc, struct_size);
    });
}

FlgResult flgSkinFileWrite(const char* path, const FlgSkinFileDesc* desc) {
    return guarded(path ? path : "flgSkinFileWrite", [&] {
        check_argument(path, "path");
        const CheckedSkin skin(desc);
        const std::filesystem::path target = to_path(path);
        const std::string extension = extension_of(target);
        if (extension != ".glb")
            fail(FLG_ERROR_FORMAT, "", "can't be written: %s is not .glb", cited(extension).c_str());
        write_file(target, write_glb_skin(skin));
    });
}

}  // extern "C"
