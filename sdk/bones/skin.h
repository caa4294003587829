// SPDX-License-Identifier: MIT
// Skins as hosts hold them, and the job that makes them: a model's parts inflated, merged, bound to its joints.
#pragma once

#include "bones/model.h"
#include "inflation/bone_weights.h"
#include "inflation/merge_parts.h"

namespace flg {

class HeldSkin final : public Product {
public:
    explicit HeldSkin(Memory* memory) : columns_(memory) {}

    std::shared_ptr<const HeldModel> model;
    MergeOptions options;
    MergedMesh mesh;
    BoneWeights weights;

    // The mesh as hosts see it, vertex by vertex.
    void show_vertex(size_t vertex);
    const float* positions() const { return columns_.positions.data(); }
    const float* normals() const { return columns_.normals.data(); }
    const FlgSkinView& view() const { return view_; }

private:
    struct Columns {
        explicit Columns(Memory* memory) : positions(memory), normals(memory) {}
        std::pmr::vector<float> positions, normals;
    };

    void show() noexcept override;

    Columns columns_;
    FlgSkinView view_{};
};

// The whole of flgSkinCreate.
Task<void> make_skin(Pace& pace, std::shared_ptr<HeldSkin> skin);

}  // namespace flg
