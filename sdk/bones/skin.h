// SPDX-License-Identifier: MIT
// Skins as hosts hold them, and the job that makes them: a model's parts inflated, merged, bound to its joints.
#pragma once

#include <deque>
#include <string>

#include "bones/model.h"
#include "inflation/bone_weights.h"
#include "inflation/merge_parts.h"

namespace flg {

class HeldSkin final : public Product {
public:
    explicit HeldSkin(Memory* memory) : tree(memory), names(memory), columns_(memory) {}

    std::shared_ptr<const HeldModel> model;  // null: of a mesh that nobody drew
    Origin origin{};
    Vec3 mirror_normal = Vec3::Zero();  // to the left; of length 0: it is not its own mirror image
    double mirror_offset = 0;
    MergeOptions options;
    BoneTree tree;  // the model's, with joints of lifted parts where these are
    MergedMesh mesh;
    BoneWeights weights;
    std::pmr::deque<std::pmr::string> names;  // of joints

    // The mesh and joints as hosts see them, one by one.
    void show_vertex(size_t vertex);
    void show_corner(size_t corner);
    void show_joint(size_t joint);
    const float* positions() const { return columns_.positions.data(); }
    const float* normals() const { return columns_.normals.data(); }
    const FlgSkinView& view() const { return view_; }

private:
    struct Columns {
        explicit Columns(Memory* memory)
            : positions(memory),
              normals(memory),
              corner_uvs(memory),
              joint_positions(memory),
              joint_radii(memory),
              joint_parents(memory),
              joint_names(memory) {}
        std::pmr::vector<float> positions, normals, corner_uvs, joint_positions, joint_radii;
        std::pmr::vector<uint32_t> joint_parents;
        std::pmr::vector<const char*> joint_names;
    };

    void show() noexcept override;

    Columns columns_;
    FlgSkinView view_{};
};

// The whole of flgSkinCreate.
Task<void> make_skin(Pace& pace, std::shared_ptr<HeldSkin> skin);

// The whole of flgSkinSimplify: `skin` is that of its options' vertices, and of the source's model.
Task<void> make_simpler_skin(Pace& pace, std::shared_ptr<const HeldSkin> source, std::shared_ptr<HeldSkin> skin);

// The whole of flgSkinSetWeights: `skin` has its weights already.
Task<void> make_bound_skin(Pace& pace, std::shared_ptr<const HeldSkin> source, std::shared_ptr<HeldSkin> skin);

}  // namespace flg
