// SPDX-License-Identifier: MIT
// What is done to the scene itself, as steps of the one history: meshes come, go, are hidden and placed. A mesh that
// was taken out is kept with all that is on it, until the document is closed.
#pragma once

#include "shell/timeline.h"

namespace flg::studio {

class SceneSteps final : public UndoSource {
public:
    // `changes`: as AppContext's.
    SceneSteps(Scene& scene, Timeline& timeline, uint64_t& changes)
        : scene_(scene), timeline_(timeline), changes_(changes) {}

    // Throws StudioError if it can't be read.
    SceneMesh& open(const std::string& source);
    void remove(uint32_t id);
    void set_visible(SceneMesh& mesh, bool visible);
    // It was moved about since it stood at `before`.
    void placed(const SceneMesh& mesh, const render::Placement& before);

    bool can_undo() const override { return !done_.empty(); }
    bool can_redo() const override { return !undone_.empty(); }
    void undo() override { swap(done_, undone_); }
    void redo() override { swap(undone_, done_); }
    void forget_undone() override { undone_.clear(); }
    // Another document.
    void reset();

private:
    // A mesh, and what it was or is to be.
    struct Step {
        uint32_t mesh;
        MeshState other;
    };
    void push(uint32_t mesh, MeshState before);
    void swap(std::vector<Step>& from, std::vector<Step>& to);

    Scene& scene_;
    Timeline& timeline_;
    uint64_t& changes_;
    std::vector<Step> done_, undone_;
};

}  // namespace flg::studio
