// SPDX-License-Identifier: MIT
#include "skin_file.h"

#include "documents/failure.h"

namespace flg::cli {
namespace {

void check_io(FlgResult result) {
    if (result != FLG_OK) throw InputError(flgIoErrorGetMessage());
}

FlgSkinAnimation find_animation(const SkinFile& skin, const std::string& wanted) {
    const std::vector<FlgSkinAnimation> animations = skin.animations();
    if (animations.empty()) throw InputError(skin.name() + ": has no animations, which --time takes poses from");
    if (wanted.empty()) return animations[0];
    std::string known;
    for (const FlgSkinAnimation& animation : animations) {
        if (wanted == animation.name) return animation;
        known += (known.empty() ? "" : ", ") + std::string(animation.name);
    }
    throw InputError(skin.name() + ": has no animation '" + wanted + "'; it has " + known);
}

}  // namespace

std::optional<SkinFile> SkinFile::read(const std::string& name) {
    FlgSkinFile file = nullptr;
    check_io(flgSkinFileRead(name.c_str(), nullptr, &file));
    if (file == nullptr) return {};
    SkinFile skin(name);
    skin.file_.reset(file);
    skin.view_.struct_size = sizeof skin.view_;
    check_io(flgSkinFileGetView(file, &skin.view_));
    skin.info_.struct_size = sizeof skin.info_;
    check_io(flgSkinFileGetInfo(file, &skin.info_));
    return skin;
}

std::vector<FlgSkinAnimation> SkinFile::animations() const {
    std::vector<FlgSkinAnimation> animations(info_.animation_count, flgSkinAnimationDefaults());
    for (uint32_t i = 0; i < info_.animation_count; ++i) {
        check_io(flgSkinFileGetAnimation(file_.get(), i, &animations[i]));
    }
    return animations;
}

std::vector<FlgMeshMaterial> SkinFile::materials() const {
    std::vector<FlgMeshMaterial> materials(info_.material_count, flgMeshMaterialDefaults());
    for (uint32_t i = 0; i < materials.size(); ++i) check_io(flgSkinFileGetMaterial(file_.get(), i, &materials[i]));
    return materials;
}

SkinPose pose_skin(const SkinFile& skin, const PoseOptions& options) {
    const FlgSkinView& view = skin.view();
    const size_t joint_count = view.joint_count;
    const bool linear = options.skinning == FLG_SKINNING_LINEAR;
    std::vector<float> rotations(4 * joint_count), matrices(12 * joint_count), duals(8 * joint_count);
    float translation[3] = {0, 0, 0};
    if (options.time) {
        const FlgSkinAnimation animation = find_animation(skin, options.animation);
        check(flgSkinAnimationSample(&animation, view.joint_count, static_cast<float>(*options.time), rotations.data(),
                                     translation),
              skin.name());
    }
    check(flgSkinPose(&view, options.time ? rotations.data() : nullptr, translation, matrices.data(), duals.data()),
          skin.name());
    SkinPose pose;
    for (size_t j = 0; j < joint_count; ++j) {
        const float *m = &matrices[12 * j], *p = view.joint_positions + 3 * j;
        for (size_t row = 0; row < 3; ++row, m += 4)
            pose.joint_positions.push_back(m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3]);
    }
    pose.transforms = std::move(linear ? matrices : duals);
    pose.positions.resize(3 * size_t{view.vertex_count});
    check(flgSkinDeform(&view, options.skinning, pose.transforms.data(), pose.positions.data(), nullptr), skin.name());
    return pose;
}

}  // namespace flg::cli
