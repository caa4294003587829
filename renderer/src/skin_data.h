// SPDX-License-Identifier: MIT
// What a skinned surface has besides a surface: what moves each vertex, and where all of it may be in a pose. Host
// only.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "filigree/filigree_model.h"
#include "filigree_renderer/camera.h"
#include "filigree_renderer/surface_look.h"
#include "surface_data.h"

namespace flg::render {

// Mirrors the vertex input of shaders/skin.glsl. Weights are shares of 65535, which they come to exactly.
struct SkinVertex {
    uint16_t joints[4];
    uint16_t weights[4];
};

// A box around a skin in any pose, from some boxes at rest instead of all vertices.
//
// A vertex p with the weights w_i, the largest w_0, is moved to y. With x_i where joint i alone takes it, and D the
// largest of |x_i - x_0|: by the mean of matrices |y - x_0| = |sum w_i (x_i - x_0)| <= (1 - w_0) D. By dual
// quaternions, seen from joint 0 and p (they do not depend on the frame): y - x_0 is the sum of w_i u_i q_i, times a
// conjugate, over the square of |sum w_i q_i|, with u_i = x_i - x_0, unit q_i, and real parts >= 0 as signs are told by
// joint 0, whose q is 1. That length is w_0 or more, and so |y - x_0| <= (1 - w_0) D / w_0. D is convex in p: the
// largest in a box is at a corner.
class SkinBounds {
public:
    explicit SkinBounds(uint32_t joint_count) : joints_(joint_count) {}

    void add(const glm::vec3& position, const uint16_t* joints, const float* weights);
    // Exact if no joint moves, else as wide as the vertices or wider.
    Box at(FlgSkinning skinning, std::span<const float> transforms) const;

private:
    struct Other {
        uint32_t joint;
        Box box;  // at rest, of the vertices that it moves along
    };
    struct Joint {
        Box box;  // at rest, of the vertices whose largest weight it has
        float linear_reach = 0.0f, dual_reach = 0.0f;
        std::vector<Other> others;
    };
    std::vector<Joint> joints_;
};

struct SkinData {
    SurfaceData surface;
    std::vector<SkinVertex> vertices;
    SkinBounds bounds;
};

// Throws Error for a skin or a look that can't be used.
SkinData prepare_skin(const FlgSkinView& skin, const SurfaceLook& look);

// Floats a joint has in a pose.
uint32_t floats_of(FlgSkinning skinning);

// Throws Error unless they are transforms of so many joints.
void check_pose(FlgSkinning skinning, std::span<const float> transforms, uint32_t joint_count);

}  // namespace flg::render
