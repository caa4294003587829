// SPDX-License-Identifier: MIT
#include "scene/scene_steps.h"

namespace flg::studio {

void SceneSteps::push(uint32_t mesh, MeshState before) {
    done_.push_back({mesh, std::move(before)});
    undone_.clear();
    ++changes_;
    timeline_.push(*this);
}

SceneMesh& SceneSteps::open(const std::string& source) {
    SceneMesh& mesh = scene_.open(source);
    MeshState before = scene_.state(mesh.id);
    before.is_there = false;
    push(mesh.id, std::move(before));
    return mesh;
}

void SceneSteps::remove(uint32_t id) {
    MeshState before = scene_.state(id);
    if (!before.is_there) return;
    MeshState after = before;
    after.is_there = false;
    scene_.set_state(id, after);
    push(id, std::move(before));
}

void SceneSteps::set_visible(SceneMesh& mesh, bool visible) {
    MeshState before = scene_.state(mesh.id);
    scene_.set_visible(mesh, visible);
    push(mesh.id, std::move(before));
}

void SceneSteps::placed(const SceneMesh& mesh, const render::Placement& before) {
    if (mesh.placement == before) return;
    MeshState state = scene_.state(mesh.id);
    state.placement = before;
    push(mesh.id, std::move(state));
}

void SceneSteps::swap(std::vector<Step>& from, std::vector<Step>& to) {
    Step step = std::move(from.back());
    from.pop_back();
    const MeshState now = scene_.state(step.mesh);
    // Where it has been put meanwhile is no part of its coming and going.
    if (now.is_there != step.other.is_there) step.other.placement = now.placement;
    scene_.set_state(step.mesh, step.other);
    step.other = now;
    to.push_back(std::move(step));
    ++changes_;
}

void SceneSteps::reset() {
    done_.clear();
    undone_.clear();
}

}  // namespace flg::studio
