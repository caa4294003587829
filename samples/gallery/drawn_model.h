// SPDX-License-Identifier: MIT
// Models of samples/models, in poses of their test motion, and their bones as strokes.
#pragma once

#include "documents/model_drawing.h"
#include "documents/test_motion.h"
#include "panels/panels.h"
#include "scenes/scenes.h"

namespace flg::gallery {

using namespace panels;

cli::ModelDrawing drawing_of(const char* name);

// What one setting of thresholds makes of a drawing.
class DrawnModel {
public:
    // A surface of about so many vertices.
    DrawnModel(const cli::ModelDrawing& drawing, uint32_t vertices);
    DrawnModel(const DrawnModel&) = delete;
    DrawnModel& operator=(const DrawnModel&) = delete;

    // Takes the pose at this time of the test motion, seconds; at rest to begin with.
    void pose(float time);
    void rest();

    SkinLayer surface() const;
    const FlgModelView& bones() const { return bones_; }
    std::vector<glm::vec3> joints() const;  // in the pose
    // Smooth curves along the joints to each end, from where they leave the body, as they lie on the surface for who
    // looks along `sight`: radii are the shape's, metres, normals point to the eye.
    std::vector<scenes::Curve> limbs(const glm::vec3& sight) const;
    // Straight bones, and a ball a joint.
    std::vector<scenes::Curve> straight_bones() const;
    std::vector<scenes::Curve> joint_balls() const;

private:
    void take_pose(const float* rotations, const float* translation);
    void lift(scenes::Curve& curve, const glm::vec3& to_eye) const;

    cli::Report report_;
    cli::Session session_;
    FlgModelView bones_ = flgModelViewDefaults();
    FlgSkinView skin_ = flgSkinViewDefaults();
    cli::TestMotion motion_;
    render::SurfaceLook look_;
    std::vector<float> matrices_, dual_quaternions_, posed_;
};

}  // namespace flg::gallery
