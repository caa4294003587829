// SPDX-License-Identifier: MIT
// The meshes that all workspaces share: drawn, picked, and one of them active. What a workspace puts on them or beside
// them (strokes, ornament, splines) is its own.
//
// A mesh has a space of its own, and a placement from there into the world. Surfaces, tangles, picking structures and
// the points of splines stay in the mesh's own space, whatever becomes of its placement; the renderer places what it
// draws of them. A stroke stays in the world in which it was drawn, and remembers how its mesh stood then.
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "filigree/filigree.hpp"
#include "filigree_renderer/renderer.h"
#include "scene/bend.h"
#include "scene/mesh_picker.h"
#include "scene/mesh_sources.h"
#include "shell/jobs.h"
#include "shell/view.h"

namespace flg::studio {

struct SceneMesh {
    uint32_t id = 0;            // never given again
    uint32_t generation = 0;    // of its surface: counts how often it was another one
    std::string name;           // for the user
    std::string source;         // a path, or builtin:NAME
    filigree::Surface surface;  // in the making while !ready
    // For its first picture, while it is large. It is not ready before.
    std::future<render::PreparedSurface> preparing{};
    std::future<MeshFile> reading{};  // of its file, which comes before its surface
    bool ready = false;               // made, and not being changed just now; surface.view() may be read
    bool was_shown = false;
    bool is_of_document = false;  // then it is kept by name, should its file turn out to be damaged
    bool missing = false;         // its file could not be read: kept by name, so that saving does not lose it
    bool visible = true;
    render::Box box;  // when it was made, in its own space
    render::Placement placement;
    bool is_placed = false;  // else a place is found once it is made
    size_t was_at = 0;       // in the list, before it was taken out
    render::SurfaceId drawn{};

    // Set by whoever decorates it, then Scene::redraw().
    render::SurfaceLook look{};
    std::vector<uint32_t>
        label_of{};  // by region: the label it is drawn with, so that some look as one; empty: its own

    uint32_t shown_revision = 0;
    bool stale = true;  // look or revision is newer than what is drawn
    MeshPicker picker;

    // Of a drawn model, which grows while it is drawn: where it stood with each of its boxes, and whether by hand.
    std::vector<std::pair<render::Box, render::Placement>> stood;
    bool is_moved = false;
    // And whether its test motion is wanted, and how it stands in it.
    bool plays = false;
    Bend bend;
    std::future<BentMesh> bending{};
    bool is_shown_bent = false;
    // Null while it is seen at rest. What is on it follows this.
    const Bend* bent() const { return is_shown_bent && bend.is_bent() ? &bend : nullptr; }

    // The model that is drawn in Skeletons. It comes and goes with the drawing.
    bool is_drawing() const;
    // It is there, or will be.
    bool is_coming() const { return reading.valid() || surface; }
    render::Box placed_box() const { return placement.box(box); }
};

// What of a mesh is the user's to change.
struct MeshState {
    bool is_there = false;
    size_t at = 0;  // in the list
    bool visible = true;
    render::Placement placement;
};

struct MeshHit {
    SceneMesh* mesh;
    FlgHit hit;  // in the mesh's own space
    glm::vec3 own_position() const { return {hit.position[0], hit.position[1], hit.position[2]}; }
    glm::vec3 own_normal() const { return {hit.normal[0], hit.normal[1], hit.normal[2]}; }
    glm::vec3 position() const { return mesh->placement.point(own_position()); }
    glm::vec3 normal() const { return mesh->placement.direction(own_normal()); }
    FlgSurfacePoint point() const { return {hit.element, hit.u, hit.v}; }
};

class Scene {
public:
    Scene(filigree::Context& context, render::Renderer& renderer, Jobs& jobs);
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    // From a file (.obj, .ply, .stl, .glb, .gltf) or builtin:NAME, which becomes the active one. A thread reads it, a
    // job makes the surface; where one of them fails the mesh goes again, with a notice. Throws StudioError for a file
    // that isn't there.
    SceneMesh& open(const std::string& source);
    // For good. What is only taken out is kept, with all that is on it, by set_state().
    void remove(uint32_t id);
    void clear();
    // Also of those that were taken out; the least, of none that was ever there.
    MeshState state(uint32_t id) const;
    void set_state(uint32_t id, const MeshState& state);
    // The drawn model is one of the meshes while there is a drawing. Its surface comes when it is made, and each time
    // that is made anew.
    void set_drawing(bool is_there);
    SceneMesh* drawing() const;
    void supply(SceneMesh& mesh, filigree::Surface surface, filigree::Job job);
    // The same as find(), but for those that were taken out, too.
    SceneMesh* kept(uint32_t id) const;

    const std::vector<std::unique_ptr<SceneMesh>>& meshes() const { return meshes_; }
    SceneMesh* find(uint32_t id) const;
    std::vector<uint32_t> ids() const;                   // in their order
    SceneMesh* active() const { return find(active_); }  // null: none
    void set_active(uint32_t id) { active_ = id; }
    void set_visible(SceneMesh& mesh, bool visible);
    void set_placement(SceneMesh& mesh, const render::Placement& placement);
    // Whether the scene is looked at: else nothing on its meshes or beside them is drawn. Not of the document.
    bool in_sight() const { return in_sight_; }
    void set_in_sight(bool in_sight) { in_sight_ = in_sight; }
    // A free place for what comes into the scene, beside the meshes and what `beside` tells of.
    render::Placement find_place(const render::Box& own) const;
    std::function<std::vector<render::Box>()> beside;
    // Of a mesh whose look was changed. Surfaces that were changed by jobs are seen by themselves.
    void redraw(SceneMesh& mesh) { mesh.stale = true; }
    // The visible mesh that the ray meets first.
    std::optional<MeshHit> hit(const Ray& ray) const;
    // The mesh's place nearest to a place of the world.
    std::optional<MeshHit> nearest(const SceneMesh& mesh, const glm::vec3& position) const;
    // Of all that are visible and have a place.
    render::Box box() const;
    // Height of the floor, metres: of the lowest mesh at rest, whatever is drawn and however a model is bent. Hidden
    // ones count while none is visible.
    float floor() const;
    // Pairs of visible meshes whose boxes meet.
    size_t overlap_count() const;
    // Whether all have a place, but for what can't be made.
    bool is_placed() const;

    // Whether a drawn model plays its motion.
    bool plays() const;
    // It is at rest at once: the mouse picks it there.
    void stop_playing();
    // Whether all meshes are shown and can be picked.
    bool settled() const;

    // Once a frame, after the tick: shows and makes pickable what is ready.
    void update();
    void device_lost();
    nlohmann::json save() const;
    // Replaces all; throws StudioError if a mesh can't be read, which is then kept as missing, once the others are
    // there.
    void load(const nlohmann::json& part);

private:
    void show(SceneMesh& mesh, const FlgSurfaceView& view);
    // Of a large mesh that is new: false while a thread makes it ready to be shown and picked.
    bool prepare(SceneMesh& mesh, const FlgSurfaceView& view);
    // Makes its bent picture in a thread, and shows that once it is there.
    void show_bent(SceneMesh& mesh, const FlgSurfaceView& view);
    // A drawn model has another box: it stands as it did with that, else beside the others, else with its feet as high.
    void stand_again(SceneMesh& mesh);
    // Takes over a file that was read. Throws StudioError if it could not be.
    void take(SceneMesh& mesh);
    void build(SceneMesh& mesh, OpenedMesh opened);
    std::string free_name(const std::string& base) const;

    filigree::Context& context_;
    render::Renderer& renderer_;
    Jobs& jobs_;
    std::vector<std::unique_ptr<SceneMesh>> meshes_, taken_out_;
    uint32_t last_id_ = 0, active_ = 0;
    bool in_sight_ = true;
};

}  // namespace flg::studio
