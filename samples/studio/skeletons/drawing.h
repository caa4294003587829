// SPDX-License-Identifier: MIT
// What the user has drawn: parts in their places, the picture they are drawn over, and the pose. Copies are cheap
// (contours are shared), so undo keeps whole drawings.
#pragma once

#include <array>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "documents/model_drawing.h"
#include "filigree/filigree_model.h"
#include "filigree_renderer/camera.h"
#include "skeletons/contour.h"
#include "skeletons/pull_record.h"
#include "skeletons/weight_strokes.h"

namespace flg::studio {

// How fine bones are unless the drawing says otherwise: for toys, as in samples/models.
constexpr FlgBoneThresholds kUsualBones = {.struct_size = sizeof(FlgBoneThresholds),
                                           .simplify = 0.008f,
                                           .merge = 0.04f,
                                           .prune = 0.075f,
                                           .collapse = 0.03f,
                                           .detail = 1.0f};

struct DrawnPart {
    uint32_t id = 0;  // never given again
    std::string name;
    ContourPtr contour;
    glm::dvec3 at{0.0};    // metres
    glm::dvec3 turn{0.0};  // degrees about x, then y, then z
    double scale = 1.0;
    float thickness = 0.8f;
    float depth = 0.0f;  // of two parts that cross, the one with more passes in front
    bool mirrored = false;
    bool visible = true;
    glm::vec3 color{0.694f, 0.266f, 0.047f};  // linear
    float metallic = 0.0f, roughness = 0.5f;
    std::optional<FlgBoneThresholds> thresholds;  // none: the drawing's
    std::vector<float> branch_simplify;  // one a branch of its axis, negative: the part's; empty: all the part's

    // From the contour's plane to the model's space.
    glm::dmat4 matrix() const;
    std::array<double, 12> placement() const;  // its rows
    glm::dvec3 centre() const;                 // of the contour, where it is
    // Turned and scaled about its centre, which stays.
    void place(const glm::dvec3& turn_degrees, double size);
};

// What was set about a joint, as FlgJointEdit has it.
using cli::JointEdit;

// Pictures lie in the plane z = 0.
struct TracedPicture {
    std::string path;  // empty: none
    glm::dvec2 centre{0.0};
    double height = 1.0;  // metres
    float opacity = 0.55f;
    bool operator==(const TracedPicture&) const = default;
};

// Of the skin's joints, by their keys: those that are not there any more are kept until they come back.
struct Pose {
    std::map<std::string, glm::quat> turns;  // within the parent's frame
    glm::vec3 shift{0.0f};                   // of the roots, metres
    bool is_rest() const { return turns.empty() && shift == glm::vec3(0.0f); }
};

struct Drawing {
    std::vector<DrawnPart> parts;  // each hangs on an earlier one
    glm::vec4 mirror{1.0f, 0.0f, 0.0f, 0.0f};
    FlgBoneThresholds thresholds = kUsualBones;
    TracedPicture picture;
    Pose pose;
    std::vector<JointEdit> joint_edits;           // in the order they were made
    std::vector<WeightStrokePtr> weight_strokes;  // likewise
    Pulls pulls;
    std::vector<std::array<std::string, 2>> apart;  // parts that are not welded, by name

    const DrawnPart* find(uint32_t id) const;
    DrawnPart* find(uint32_t id);
    // Ready for one more part: `base`, or it with a number.
    std::string free_name(const std::string& base, uint32_t but_of = 0) const;
    bool has_mirrored_parts() const;
    // Where all visible parts are, mirror images included, as deep as they are about wide.
    render::Box box() const;
};

glm::dvec3 mirrored(const glm::vec4& plane, const glm::dvec3& point);

// How far from the mirror's plane z = 0 a part must be so that it and its image are two limbs of the body that it
// meets.
double depth_beside(const Drawing& drawing, const Ring& outline, float thickness);

// A placement of rotation, one scale and translation, as at, turn and scale.
void set_placement(DrawnPart& part, const std::array<double, 12>& rows);

}  // namespace flg::studio
