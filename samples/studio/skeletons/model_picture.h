// SPDX-License-Identifier: MIT
// Body and bones in the 3D picture.
#pragma once

#include <array>

#include "filigree_renderer/renderer.h"
#include "skeletons/live_model.h"

namespace flg::studio {

class ModelPicture {
public:
    explicit ModelPicture(render::Renderer& renderer) : renderer_(renderer) {}
    ~ModelPicture();
    ModelPicture(const ModelPicture&) = delete;
    ModelPicture& operator=(const ModelPicture&) = delete;

    // The body of a new skin, or in other colours. Null: none. True if it was uploaded, so that it is at rest again.
    bool show_body(const LiveModel::Skinned* skin, uint64_t revision, const Drawing& drawing, uint32_t selected);
    // The same mesh elsewhere, or coloured by one number a vertex, 0 to 1, in place of the body. `positions`: 3 per
    // vertex; `field`: empty: in the parts' colours. `revision`: of both.
    void show_shape(const LiveModel::Skinned& skin, std::span<const float> positions, std::span<const float> field,
                    const std::array<uint64_t, 3>& revision);
    void hide_shape();
    void pose_body(FlgSkinning skinning, std::span<const float> transforms);
    void set_body_visible(bool visible);

    // Seen through the body. Joints of the part that is selected are golden, those in `bright` larger and brighter.
    struct BonesLook {
        uint32_t selected_part = 0;
        std::vector<uint32_t> bright;
        bool operator==(const BonesLook&) const = default;
    };
    // Nothing for an empty rig. `revision`: of the rig.
    void show_bones(const Rig& rig, uint64_t revision, const std::vector<glm::vec3>& at, const BonesLook& look);
    void device_lost();

private:
    render::Renderer& renderer_;
    render::SurfaceId body_{}, shape_{};
    render::CurvesId bones_{};
    bool is_body_visible_ = true;
    // What is shown.
    uint64_t body_revision_ = 0, bones_revision_ = 0;
    std::array<uint64_t, 3> shape_revision_{};
    std::vector<render::Material> materials_;
    std::vector<glm::vec3> bones_at_;
    BonesLook bones_look_;
};

// Of a joint's ball, metres.
float joint_radius(const Rig& rig, size_t joint);

}  // namespace flg::studio
