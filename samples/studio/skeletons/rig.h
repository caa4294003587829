// SPDX-License-Identifier: MIT
// The joints of a model, and what pulling one of them does to its pose.
#pragma once

#include <span>

#include "skeletons/drawing.h"

namespace flg::studio {

// Parents come first.
struct Rig {
    std::vector<glm::vec3> rest;    // metres
    std::vector<float> radii;       // of the shape around, metres
    std::vector<uint32_t> parents;  // FLG_NO_INDEX: a root
    std::vector<uint32_t> child_counts;
    std::vector<uint32_t> parts;           // id of the drawn part that each lies in
    std::vector<std::string> names, keys;  // as they are called; what stays when they are renamed
    std::vector<glm::dvec3> places;        // in the drawings of their parts
    std::vector<bool> pinned, is_image;    // the second: of a part's mirror image
    float size = 0.0f;                     // what thresholds are shares of, metres

    size_t count() const { return rest.size(); }
    size_t bone_count() const;
};

// `sources`: ids of the drawn parts in the order that the model was given them.
Rig rig_of(const FlgModelView& model, std::span<const uint32_t> sources);

// Within the parents' frames, one a joint.
std::vector<glm::quat> turns_of(const Rig& rig, const Pose& pose);
// The other way round: joints that are not turned are left out.
void set_turns(Pose& pose, const Rig& rig, std::span<const glm::quat> turns);

struct PosedJoints {
    std::vector<glm::vec3> at;
    std::vector<glm::quat> turned;  // against rest, in the model's space
};
PosedJoints posed(const Rig& rig, std::span<const glm::quat> turns, const glm::vec3& shift);

// The joints that turn when a joint is pulled, its parent first: up to the next joint that carries others too, or the
// root.
std::vector<uint32_t> chain_of(const Rig& rig, uint32_t joint);

// Turns the joints of the chain so that the joint comes as near to a place as it can: cyclic coordinate descent (Wang
// and Chen 1991). A root takes the model with it. Bones keep their lengths.
void pull(const Rig& rig, Pose& pose, uint32_t joint, const glm::vec3& to);
// Turns the bone that ends at the joint about itself, with all that hangs on its upper joint; of a root the whole model
// about y.
void twist(const Rig& rig, Pose& pose, uint32_t joint, float angle_rad);

}  // namespace flg::studio
