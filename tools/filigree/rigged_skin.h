// SPDX-License-Identifier: MIT
// A drawn model's skin with what engines ask of it: bones by a standard's names, a T-pose at rest, test motions.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "documents/model_drawing.h"
#include "documents/test_motion.h"
#include "filigree/filigree_rig.h"

namespace flg::cli {

enum class SkinMotion { walk, idle, wave, swing };

struct RigOptions {
    std::optional<FlgRigStandard> standard;
    bool t_pose = false;
    std::vector<SkinMotion> motions = {SkinMotion::swing};
    std::vector<std::string> authors;  // of a VRM avatar
};

// The rig of a model's joints, with its memory.
class ModelRig {
public:
    // `left` is the drawing's mirror, if parts are mirrored. Throws InputError about `subject`.
    ModelRig(const float* positions, const FlgModelView& model, const std::array<float, 3>& left,
             const std::string& subject);
    ModelRig(const ModelRig&) = delete;
    ModelRig& operator=(const ModelRig&) = delete;

    const FlgRig& rig() const { return rig_; }

private:
    std::vector<FlgRigJoint> joints_;
    FlgRig rig_ = flgRigDefaults();
};

// Where a drawing says that left is: 0 0 0 without mirrored parts.
std::array<float, 3> left_of(const ModelDrawing& drawing);

class RiggedSkin {
public:
    // `skin` and `model` outlive this. Throws InputError where the model has no limbs for what is asked.
    RiggedSkin(const RigOptions& options, const FlgSkinView& skin, const FlgModelView& model,
               const ModelDrawing& drawing, const std::string& subject);
    RiggedSkin(const RiggedSkin&) = delete;
    RiggedSkin& operator=(const RiggedSkin&) = delete;

    const FlgSkinView& skin() const { return skin_; }
    // Null: it has more joints than rigs have, and nothing was asked of it.
    const FlgRig* rig() const { return rig_ ? &rig_->rig() : nullptr; }
    // One per joint, null: none of the standard's. Empty without a standard.
    const std::vector<const char*>& bones() const { return bones_; }
    std::vector<FlgSkinAnimation> animations() const;

private:
    void name_joints(FlgRigStandard standard);
    void stand_in_t();
    void add_motion(FlgRigMotion motion, const char* name, float seconds);

    FlgSkinView skin_;
    const FlgModelView& model_;
    std::string subject_;
    std::optional<ModelRig> rig_;
    std::vector<const char*> bones_, names_;
    std::vector<float> positions_, normals_, joint_positions_;
    std::vector<TestMotion> motions_;
};

}  // namespace flg::cli
