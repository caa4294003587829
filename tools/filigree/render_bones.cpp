// SPDX-License-Identifier: MIT
#include "render_bones.h"

namespace flg::cli {
namespace {

// Shares of the size of what is drawn.
constexpr float kBoneRadius = 1.0f / 200.0f, kBoneEndRadius = 1.0f / 600.0f;
constexpr float kJointRadius = 1.0f / 110.0f;
// A ball is a tube as short as this, in its radius, with round ends.
constexpr float kBallLength = 0.02f;
constexpr glm::vec3 kBoneColor{0.90f, 0.88f, 0.80f}, kJointColor{0.85f, 0.20f, 0.02f};

// Curves of two points.
struct Segments {
    std::vector<float> positions, radii;
    std::vector<uint32_t> offsets{0};

    void add(const glm::vec3& from, const glm::vec3& to, float from_radius, float to_radius) {
        positions.insert(positions.end(), {from.x, from.y, from.z, to.x, to.y, to.z});
        radii.insert(radii.end(), {from_radius, to_radius});
        offsets.push_back(offsets.back() + 2);
    }

    void upload(render::Renderer& renderer, const glm::vec3& color) const {
        if (radii.empty()) return;
        const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0},
                                     {FLG_ATTRIBUTE_RADIUS, 1, radii.data(), 0, 0}};
        FlgCurveSetView view = {};
        view.struct_size = sizeof view;
        view.curve_count = static_cast<uint32_t>(offsets.size() - 1);
        view.curve_offsets = offsets.data();
        view.columns = columns;
        view.column_count = 2;
        render::CurveLook look;
        look.shape = render::Shape::tube;
        look.color = look.color_end = color;
        look.casts_shadow = false;
        look.in_front = true;
        renderer.upload(view, look);
    }
};

}  // namespace

void upload_bones(render::Renderer& renderer, const FlgSkinView& skin, const std::vector<float>& joint_positions,
                  float size) {
    Segments bones, joints;
    const auto at = [&](size_t joint) {
        return glm::vec3(joint_positions[3 * joint], joint_positions[3 * joint + 1], joint_positions[3 * joint + 2]);
    };
    for (uint32_t j = 0; j < skin.joint_count; ++j) {
        const float radius = kJointRadius * size;
        const glm::vec3 half(0.5f * kBallLength * radius, 0.0f, 0.0f);
        joints.add(at(j) - half, at(j) + half, radius, radius);
        const uint32_t parent = skin.joint_parents[j];
        if (parent == FLG_NO_INDEX) continue;
        bones.add(at(parent), at(j), kBoneRadius * size, kBoneEndRadius * size);
    }
    bones.upload(renderer, kBoneColor);
    joints.upload(renderer, kJointColor);
}

}  // namespace flg::cli
