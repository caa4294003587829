// SPDX-License-Identifier: MIT
#include "skin_file.h"

#include <algorithm>
#include <cmath>

#include "documents/failure.h"

namespace flg::cli {
namespace {

void check_io(FlgResult result) {
    if (result != FLG_OK) throw InputError(flgIoErrorGetMessage());
}

// What moves joints, and what moves vertices before; one of them may be missing.
struct Moving {
    std::optional<FlgSkinAnimation> joints;
    std::optional<FlgMorphAnimation> shapes;
};

Moving find_animation(const SkinFile& skin, const std::string& wanted) {
    const std::vector<FlgSkinAnimation> animations = skin.animations();
    const std::vector<FlgMorphAnimation> shapes = skin.morph_animations();
    if (animations.empty() && shapes.empty())
        throw InputError(skin.name() + ": has no animations, which --time takes poses from");
    std::string known;
    Moving found;
    for (uint32_t i = 0; i < animations.size() && !found.joints; ++i) {
        known += (known.empty() ? "" : ", ") + std::string(animations[i].name);
        if (!wanted.empty() && wanted != animations[i].name) continue;
        found.joints = animations[i];
        for (const FlgMorphAnimation& shape : shapes)
            if (shape.animation == i) found.shapes = shape;
    }
    if (found.joints) return found;
    for (const FlgMorphAnimation& shape : shapes) {
        if (shape.animation != FLG_NO_INDEX) continue;
        known += (known.empty() ? "" : ", ") + std::string(shape.name);
        if (!wanted.empty() && wanted != shape.name) continue;
        found.shapes = shape;
        return found;
    }
    throw InputError(skin.name() + ": has no animation '" + wanted + "'; it has " + known);
}

// Vertices as targets have them, by their weights at a time; normals too, of length 1.
void move_by_shapes(const SkinFile& skin, const FlgMorphAnimation& animation, float time, SkinPose& pose) {
    const FlgSkinView& view = skin.view();
    const std::vector<FlgMorphTarget> targets = skin.morphs();
    const float* const end = animation.times + animation.key_count;
    const auto after = static_cast<size_t>(std::upper_bound(animation.times, end, time) - animation.times);
    const size_t before = after == 0 ? 0 : after - 1, next = std::min<size_t>(after, animation.key_count - 1);
    const float share =
        before == next ? 0.0f : (time - animation.times[before]) / (animation.times[next] - animation.times[before]);
    pose.rest.assign(view.positions, view.positions + 3 * size_t{view.vertex_count});
    pose.normals.assign(view.normals, view.normals + 3 * size_t{view.vertex_count});
    for (size_t i = 0; i < targets.size(); ++i) {
        const float from = animation.weights[before * targets.size() + i],
                    to = animation.weights[next * targets.size() + i], weight = from + share * (to - from);
        for (size_t k = 0; weight != 0 && k < pose.rest.size(); ++k) {
            pose.rest[k] += weight * targets[i].moves[k];
            pose.normals[k] += weight * targets[i].normal_moves[k];
        }
    }
    for (size_t k = 0; k < pose.normals.size(); k += 3) {
        float* n = &pose.normals[k];
        const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (size_t axis = 0; length > 0 && axis < 3; ++axis) n[axis] /= length;
    }
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

std::vector<FlgTexture> SkinFile::textures() const {
    std::vector<FlgTexture> textures(info_.texture_count, flgTextureDefaults());
    for (uint32_t i = 0; i < textures.size(); ++i) check_io(flgSkinFileGetTexture(file_.get(), i, &textures[i]));
    return textures;
}

std::vector<FlgMorphTarget> SkinFile::morphs() const {
    std::vector<FlgMorphTarget> morphs(info_.morph_count, flgMorphTargetDefaults());
    for (uint32_t i = 0; i < morphs.size(); ++i) check_io(flgSkinFileGetMorphTarget(file_.get(), i, &morphs[i]));
    return morphs;
}

std::vector<FlgMorphAnimation> SkinFile::morph_animations() const {
    std::vector<FlgMorphAnimation> animations(info_.morph_animation_count, flgMorphAnimationDefaults());
    for (uint32_t i = 0; i < animations.size(); ++i)
        check_io(flgSkinFileGetMorphAnimation(file_.get(), i, &animations[i]));
    return animations;
}

SkinPose pose_skin(const SkinFile& skin, const PoseOptions& options) {
    const FlgSkinView& view = skin.view();
    const size_t joint_count = view.joint_count;
    const bool linear = options.skinning == FLG_SKINNING_LINEAR;
    std::vector<float> rotations(4 * joint_count), matrices(12 * joint_count), duals(8 * joint_count);
    float translation[3] = {0, 0, 0};
    SkinPose pose;
    Moving moving;
    if (options.time) {
        const auto time = static_cast<float>(*options.time);
        moving = find_animation(skin, options.animation);
        if (moving.joints)
            check(flgSkinAnimationSample(&*moving.joints, view.joint_count, time, rotations.data(), translation),
                  skin.name());
        if (moving.shapes) move_by_shapes(skin, *moving.shapes, time, pose);
    }
    check(flgSkinPose(&view, moving.joints ? rotations.data() : nullptr, translation, matrices.data(), duals.data()),
          skin.name());
    for (size_t j = 0; j < joint_count; ++j) {
        const float *m = &matrices[12 * j], *p = view.joint_positions + 3 * j;
        for (size_t row = 0; row < 3; ++row, m += 4)
            pose.joint_positions.push_back(m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3]);
    }
    pose.transforms = std::move(linear ? matrices : duals);
    pose.positions.resize(3 * size_t{view.vertex_count});
    const FlgSkinView shaped = morphed(skin, pose);
    check(flgSkinDeform(&shaped, options.skinning, pose.transforms.data(), pose.positions.data(), nullptr),
          skin.name());
    return pose;
}

FlgSkinView morphed(const SkinFile& skin, const SkinPose& pose) {
    FlgSkinView view = skin.view();
    if (!pose.rest.empty()) {
        view.positions = pose.rest.data();
        view.normals = pose.normals.data();
    }
    return view;
}

}  // namespace flg::cli
