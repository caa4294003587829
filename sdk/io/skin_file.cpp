// SPDX-License-Identifier: MIT
// The C ABI of files with skins, translated onto this room.
#include <algorithm>
#include <memory>

#include "filigree/filigree_io.h"
#include "io/base/box.h"
#include "io/base/checked_views.h"
#include "io/base/entry_point.h"
#include "io/base/files.h"
#include "io/gltf/gltf_materials.h"
#include "io/gltf/gltf_skin.h"

struct FlgSkinFileT : flg::io::HostFile {
    flg::io::SkinData data;
    flg::io::Box box;
    uint32_t part_count = 1;
    flg::io::Vector<const char*> joint_names, warnings;
    flg::io::Vector<FlgMeshMaterial> materials;
    flg::io::Vector<FlgTexture> textures;
    flg::io::Vector<FlgSkinAnimation> animations;
    flg::io::Vector<FlgMorphTarget> morphs;
    flg::io::Vector<FlgMorphAnimation> morph_animations;
};

namespace flg::io {

namespace {

FlgSkinAnimation view_of(const AnimationData& data) {
    auto view = sized<FlgSkinAnimation>();
    view.key_count = static_cast<uint32_t>(data.times.size());
    view.name = data.name.c_str();
    view.times = data.times.data();
    view.rotations = data.rotations.data();
    view.translations = data.translations.empty() ? nullptr : data.translations.data();
    return view;
}

FlgMorphTarget view_of(const MorphTargetData& data) {
    auto view = sized<FlgMorphTarget>();
    view.name = data.name.c_str();
    view.moves = data.moves.data();
    view.normal_moves = data.normal_moves.data();
    return view;
}

FlgMorphAnimation view_of(const MorphAnimationData& data) {
    auto view = sized<FlgMorphAnimation>();
    view.key_count = static_cast<uint32_t>(data.times.size());
    view.name = data.name.c_str();
    view.times = data.times.data();
    view.weights = data.weights.data();
    view.animation = data.animation;
    return view;
}

Owned<FlgSkinFileT> make_file(SkinData&& read) {
    auto file = make_owned<FlgSkinFileT>();
    file->data = std::move(read);
    const SkinData& data = file->data;
    file->box = box_of(data.positions);
    file->part_count = 1 + *std::max_element(data.parts.begin(), data.parts.end());
    for (const uint32_t part : data.triangle_parts) file->part_count = std::max(file->part_count, part + 1);
    for (const String& name : data.joint_names) file->joint_names.push_back(name.c_str());
    for (const String& warning : data.warnings) file->warnings.push_back(warning.c_str());
    for (const MaterialData& material : data.materials) file->materials.push_back(material_view(material));
    for (const TextureData& texture : data.textures) file->textures.push_back(texture_view(texture));
    for (const AnimationData& animation : data.animations) file->animations.push_back(view_of(animation));
    for (const MorphTargetData& target : data.morphs) file->morphs.push_back(view_of(target));
    for (const MorphAnimationData& animation : data.morph_animations)
        file->morph_animations.push_back(view_of(animation));
    return file;
}

}  // namespace

}  // namespace flg::io

using namespace flg::io;
using flg::sized;

extern "C" {

FlgResult flgSkinFileReadDescInit(FlgSkinFileReadDesc* desc, uint32_t struct_size) {
    return init("flgSkinFileReadDescInit", desc, struct_size, sized<FlgSkinFileReadDesc>());
}

FlgResult flgSkinFileRead(const char* path, const FlgSkinFileReadDesc* desc, FlgSkinFile* out_file) {
    return read_into(out_file, "flgSkinFileRead", path, desc, [](const Path& source) {
        const String extension = source.extension();
        if (extension != ".gltf" && extension != ".glb") {
            fail(FLG_ERROR_FORMAT, "", "holds no skin: %s is none of .gltf .glb", cited(extension).c_str());
        }
        std::optional<SkinData> data = read_gltf_skin(source);
        return data ? make_file(std::move(*data)) : nullptr;
    });
}

FlgResult flgSkinFileGetView(FlgSkinFile file, FlgSkinView* out_view) {
    return show("flgSkinFileGetView", file, out_view, "out_view", [](const FlgSkinFileT& shown) {
        const SkinData& data = shown.data;
        auto view = sized<FlgSkinView>();
        view.vertex_count = static_cast<uint32_t>(data.vertex_count());
        view.triangle_count = static_cast<uint32_t>(data.triangle_count());
        view.joint_count = static_cast<uint32_t>(data.joint_parents.size());
        view.positions = data.positions.data();
        view.normals = data.normals.data();
        view.triangles = data.triangles.data();
        view.vertex_joints = data.joints.data();
        view.vertex_weights = data.weights.data();
        view.vertex_parts = data.parts.data();
        if (!data.triangle_parts.empty()) view.triangle_parts = data.triangle_parts.data();
        view.joint_positions = data.joint_positions.data();
        view.joint_parents = data.joint_parents.data();
        view.joint_names = shown.joint_names.data();
        if (!data.corner_uvs.empty()) view.corner_uvs = data.corner_uvs.data();
        return view;
    });
}

FlgResult flgSkinFileGetAnimation(FlgSkinFile file, uint32_t animation, FlgSkinAnimation* out_animation) {
    return show_one("flgSkinFileGetAnimation", file, &FlgSkinFileT::animations, animation, "animation", out_animation,
                    "out_animation");
}

FlgResult flgSkinFileGetMaterial(FlgSkinFile file, uint32_t material, FlgMeshMaterial* out_material) {
    return show_one("flgSkinFileGetMaterial", file, &FlgSkinFileT::materials, material, "material", out_material,
                    "out_material");
}

FlgResult flgSkinFileGetTexture(FlgSkinFile file, uint32_t texture, FlgTexture* out_texture) {
    return show_one("flgSkinFileGetTexture", file, &FlgSkinFileT::textures, texture, "texture", out_texture,
                    "out_texture");
}

FlgResult flgMorphTargetInit(FlgMorphTarget* target, uint32_t struct_size) {
    return init("flgMorphTargetInit", target, struct_size, sized<FlgMorphTarget>(), "target");
}

FlgResult flgMorphAnimationInit(FlgMorphAnimation* animation, uint32_t struct_size) {
    auto defaults = sized<FlgMorphAnimation>();
    defaults.animation = FLG_NO_INDEX;
    return init("flgMorphAnimationInit", animation, struct_size, defaults, "animation");
}

FlgResult flgSkinFileGetMorphTarget(FlgSkinFile file, uint32_t target, FlgMorphTarget* out_target) {
    return show_one("flgSkinFileGetMorphTarget", file, &FlgSkinFileT::morphs, target, "target", out_target,
                    "out_target");
}

FlgResult flgSkinFileGetMorphAnimation(FlgSkinFile file, uint32_t animation, FlgMorphAnimation* out_animation) {
    return show_one("flgSkinFileGetMorphAnimation", file, &FlgSkinFileT::morph_animations, animation, "animation",
                    out_animation, "out_animation");
}

FlgResult flgSkinFileGetInfo(FlgSkinFile file, FlgSkinFileInfo* out_info) {
    return show("flgSkinFileGetInfo", file, out_info, "out_info", [](const FlgSkinFileT& shown) {
        auto info = sized<FlgSkinFileInfo>();
        info.part_count = shown.part_count;
        shown.box.show(info);
        info.animation_count = static_cast<uint32_t>(shown.animations.size());
        info.warning_count = static_cast<uint32_t>(shown.warnings.size());
        info.warnings = shown.warnings.data();
        info.material_count = static_cast<uint32_t>(shown.materials.size());
        info.texture_count = static_cast<uint32_t>(shown.textures.size());
        if (!shown.data.colors.empty()) info.vertex_colors = shown.data.colors.data();
        info.morph_count = static_cast<uint32_t>(shown.morphs.size());
        info.morph_animation_count = static_cast<uint32_t>(shown.morph_animations.size());
        return info;
    });
}

void flgSkinFileRelease(FlgSkinFile file) {
    release(file);
}

FlgResult flgSkinFileInfoInit(FlgSkinFileInfo* info, uint32_t struct_size) {
    return init("flgSkinFileInfoInit", info, struct_size, sized<FlgSkinFileInfo>(), "info");
}

FlgResult flgVrmInit(FlgVrm* vrm, uint32_t struct_size) {
    return init("flgVrmInit", vrm, struct_size, sized<FlgVrm>(), "vrm");
}

FlgResult flgSkinFileWriteDescInit(FlgSkinFileWriteDesc* desc, uint32_t struct_size) {
    return init("flgSkinFileWriteDescInit", desc, struct_size, sized<FlgSkinFileWriteDesc>());
}

FlgResult flgSkinFileWrite(const char* path, const FlgSkinFileWriteDesc* desc) {
    return write_to("flgSkinFileWrite", path, desc, [&](const Path& target) {
        const CheckedSkin skin(desc);
        check_is_glb(target);
        write_file(target, write_glb_skin(skin));
    });
}

}  // extern "C"
