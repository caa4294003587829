// SPDX-License-Identifier: MIT
// The meshes that all workspaces share: drawn, picked, and one of them active. What a workspace puts beside them (strokes,
// bones, splines) is its own.
#pragma once

#include <future>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "filigree/filigree.hpp"
#include "filigree/filigree_pick.h"
#include "filigree_renderer/renderer.h"
#include "shell/jobs.h"
#include "shell/view.h"

namespace flg::studio {

struct SceneMesh {
    uint32_t id = 0;            // never given again; its number in the picking scene
    std::string name;           // for the user
    std::string source;         // a path, or builtin:NAME
    filigree::Surface surface;  // in the making while !ready
    bool ready = false;         // made, and not being changed just now; surface.view() may be read
    bool missing = false;       // its file could not be read: kept by name, so that saving does not lose it
    bool visible = true;
    render::Box box;  // when it was made
    render::SurfaceId drawn{};

    // Set by whoever decorates it, then Scene::redraw().
    render::SurfaceLook look{};
    std::vector<uint32_t>
        label_of{};  // by region: the label it is drawn with, so that some look as one; empty: its own

    uint32_t shown_revision = 0;
    bool stale = true;  // look or revision is newer than what is drawn
    bool pickable = false;
    uint32_t picked_revision = 0;
};

struct MeshHit {
    SceneMesh* mesh;
    FlgHit hit;
    glm::vec3 position() const { return {hit.position[0], hit.position[1], hit.position[2]}; }
    glm::vec3 normal() const { return {hit.normal[0], hit.normal[1], hit.normal[2]}; }
    FlgSurfacePoint point() const { return {hit.element, hit.u, hit.v}; }
};

class Scene {
public:
    Scene(filigree::Context& context, render::Renderer& renderer, Jobs& jobs);
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    // From a file (.obj, .ply, .stl, .glb, .gltf) or builtin:NAME, which becomes the active one. A job makes the surface; where that
    // fails the mesh goes again, with a notice. Throws StudioError if it can't be read.
    SceneMesh& open(const std::string& source);
    void remove(uint32_t id);
    void clear();

    const std::vector<std::unique_ptr<SceneMesh>>& meshes() const { return meshes_; }
    SceneMesh* find(uint32_t id) const;
    SceneMesh* active() const { return find(active_); }  // null: none
    void set_active(uint32_t id) { active_ = id; }
    void set_visible(SceneMesh& mesh, bool visible);
    // Of a mesh whose look was changed. Surfaces that were changed by jobs are seen by themselves.
    void redraw(SceneMesh& mesh) { mesh.stale = true; }
    // The visible mesh that the ray meets first; none too while the picking scene is being built, which large meshes take seconds for
    // when they come and a thread of their own.
    std::optional<MeshHit> hit(const Ray& ray) const;
    // The mesh's place nearest to a point of space.
    std::optional<MeshHit> nearest(const SceneMesh& mesh, const glm::vec3& position) const;
    render::Box box() const;

    // Whether all meshes are shown and can be picked.
    bool settled() const;

    // Once a frame, after the tick: shows and makes pickable what is ready.
    void update();
    void device_lost();
    nlohmann::json save() const;
    // Replaces all; throws StudioError if a mesh can't be read, which is then kept as missing, once the others are there.
    void load(const nlohmann::json& part);

private:
    void show(SceneMesh& mesh, const FlgSurfaceView& view);
    void make_pickable(const SceneMesh& mesh, const FlgSurfaceView& view, uint32_t since_revision);
    bool can_pick() const { return !building_.valid(); }

    filigree::Context& context_;
    render::Renderer& renderer_;
    Jobs& jobs_;
    FlgPickScene pick_ = nullptr;
    std::future<FlgResult> building_;  // of the picking scene, which nobody may use meanwhile
    bool pick_changed_ = false;
    std::vector<uint32_t> unpicked_;  // removed while it was being built
    std::vector<std::unique_ptr<SceneMesh>> meshes_;
    uint32_t last_id_ = 0, active_ = 0;
};

}  // namespace flg::studio
