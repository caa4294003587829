// SPDX-License-Identifier: MIT
#include "rigged_skin.h"

#include <algorithm>

#include "documents/failure.h"

namespace flg::cli {
namespace {

constexpr uint32_t keys_a_cycle = 48;

}  // namespace

std::array<float, 3> left_of(const ModelDrawing& drawing) {
    const bool is_mirrored =
        std::any_of(drawing.parts.begin(), drawing.parts.end(), [](const DrawnPart& p) { return p.is_mirrored; });
    if (!is_mirrored) return {};
    return {drawing.mirror[0], drawing.mirror[1], drawing.mirror[2]};
}

ModelRig::ModelRig(const float* positions, const FlgModelView& model, const std::array<float, 3>& left,
                   const std::string& subject)
    : joints_(model.joint_count) {
    FlgRigFindDesc desc = flgRigFindDefaults();
    desc.joint_count = model.joint_count;
    desc.joint_positions = positions;
    desc.joint_radii = model.joint_radii;
    desc.joint_parents = model.joint_parents;
    std::copy(left.begin(), left.end(), desc.left);
    check(flgRigFind(&desc, joints_.data(), &rig_), subject);
}

RiggedSkin::RiggedSkin(const RigOptions& options, const FlgSkinView& skin, const FlgModelView& model,
                       const ModelDrawing& drawing, const std::string& subject)
    : skin_(skin), model_(model), subject_(subject) {
    const bool only_swings = std::all_of(options.motions.begin(), options.motions.end(),
                                         [](SkinMotion motion) { return motion == SkinMotion::swing; });
    if (model.joint_count <= FLG_RIG_MAX_JOINTS || options.standard || options.t_pose || !only_swings)
        rig_.emplace(skin.joint_positions, model, left_of(drawing), subject);
    if (options.standard) name_joints(*options.standard);
    if (options.t_pose) stand_in_t();
    for (const SkinMotion motion : options.motions) {
        switch (motion) {
            case SkinMotion::walk: add_motion(FLG_RIG_MOTION_WALK, "walk", 1.2f); break;
            case SkinMotion::idle: add_motion(FLG_RIG_MOTION_IDLE, "idle", 4); break;
            case SkinMotion::wave: add_motion(FLG_RIG_MOTION_WAVE, "wave", 3); break;
            case SkinMotion::swing: motions_.push_back(make_test_motion(model, drawing)); break;
        }
    }
}

void RiggedSkin::name_joints(FlgRigStandard standard) {
    bones_.resize(model_.joint_count);
    check(flgRigGetNames(rig(), standard, bones_.data()), subject_);
    names_.assign(skin_.joint_names, skin_.joint_names + model_.joint_count);
    for (uint32_t j = 0; j < model_.joint_count; ++j)
        if (bones_[j]) names_[j] = bones_[j];
    skin_.joint_names = names_.data();
}

void RiggedSkin::stand_in_t() {
    std::vector<float> rotations(4 * size_t{model_.joint_count}), matrices(12 * size_t{model_.joint_count}),
        duals(8 * size_t{model_.joint_count});
    check(flgRigGetTPose(rig(), rotations.data()), subject_);
    check(flgSkinPose(&skin_, rotations.data(), nullptr, matrices.data(), duals.data()), subject_);
    positions_.resize(3 * size_t{skin_.vertex_count});
    normals_.resize(positions_.size());
    check(flgSkinDeform(&skin_, FLG_SKINNING_DUAL_QUATERNION, duals.data(), positions_.data(), normals_.data()),
          subject_);
    joint_positions_.resize(3 * size_t{model_.joint_count});
    for (size_t j = 0; j < model_.joint_count; ++j) {
        const float *at = skin_.joint_positions + 3 * j, *m = matrices.data() + 12 * j;
        for (size_t k = 0; k < 3; ++k)
            joint_positions_[3 * j + k] = m[4 * k] * at[0] + m[4 * k + 1] * at[1] + m[4 * k + 2] * at[2] + m[4 * k + 3];
    }
    skin_.positions = positions_.data();
    skin_.normals = normals_.data();
    skin_.joint_positions = joint_positions_.data();
    const float* left = rig()->left;
    rig_.emplace(skin_.joint_positions, model_, std::array<float, 3>{left[0], left[1], left[2]}, subject_);
}

void RiggedSkin::add_motion(FlgRigMotion motion, const char* name, float seconds) {
    TestMotion& made = motions_.emplace_back();
    made.name = name;
    const size_t joints = model_.joint_count;
    made.rotations.resize(4 * joints * (keys_a_cycle + 1));
    made.translations.resize(3 * (keys_a_cycle + 1));
    for (uint32_t key = 0; key <= keys_a_cycle; ++key) {
        const float share = static_cast<float>(key) / keys_a_cycle;
        made.times.push_back(share * seconds);
        check(flgRigMotionSample(rig(), motion, share, made.rotations.data() + 4 * joints * key,
                                 made.translations.data() + size_t{3} * key, nullptr),
              subject_);
    }
}

std::vector<FlgSkinAnimation> RiggedSkin::animations() const {
    std::vector<FlgSkinAnimation> out;
    for (const TestMotion& motion : motions_) out.push_back(motion.animation());
    return out;
}

}  // namespace flg::cli
