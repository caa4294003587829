// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <glm/gtc/type_ptr.hpp>
#include <limits>

#include "scene/free_place.h"
#include "scene/mesh_sources.h"
#include "scene/placement_json.h"
#include "shell/studio_error.h"

namespace flg::studio {
namespace {

// Unglazed porcelain.
constexpr render::Material kPorcelain{.color = {0.60f, 0.55f, 0.49f}, .metallic = 0.0f, .roughness = 0.55f};

constexpr const char* kDrawing = "drawing";  // a source

auto stood_with(const render::Box& box) {
    return [&box](const auto& stood) { return stood.first.min == box.min && stood.first.max == box.max; };
}

// With the labels that its materials go by.
class LabelledMesh {
public:
    LabelledMesh(const SceneMesh& mesh, const FlgMeshView& view) : view_(view) {
        if (mesh.label_of.empty() || view.regions == nullptr) return;
        labels_.assign(view.regions, view.regions + view.triangle_count);
        for (uint32_t& label : labels_) label = label < mesh.label_of.size() ? mesh.label_of[label] : 0;
        view_.regions = labels_.data();
    }
    LabelledMesh(const LabelledMesh&) = delete;
    LabelledMesh& operator=(const LabelledMesh&) = delete;
    const FlgMeshView& view() const { return view_; }

private:
    FlgMeshView view_;
    std::vector<uint32_t> labels_;
};

}  // namespace

bool SceneMesh::is_drawing() const {
    return source == kDrawing;
}

Scene::Scene(filigree::Context& context, render::Renderer& renderer, Jobs& jobs)
    : context_(context), renderer_(renderer), jobs_(jobs) {}

SceneMesh& Scene::open(const std::string& source) {
    auto mesh = std::make_unique<SceneMesh>();
    mesh->id = ++last_id_;
    mesh->look.material = kPorcelain;
    if (is_builtin_mesh(source)) {
        OpenedMesh opened = open_builtin(context_, source);
        mesh->name = free_name(opened.name);
        mesh->source = source;
        build(*mesh, std::move(opened));
    } else {
        mesh->reading = read_mesh(source);
        mesh->name = free_name(std::filesystem::path(source).stem().string());
        mesh->source = std::filesystem::absolute(source).string();
    }
    meshes_.push_back(std::move(mesh));
    active_ = last_id_;
    return *meshes_.back();
}

void Scene::build(SceneMesh& mesh, OpenedMesh opened) {
    mesh.surface = std::move(opened.surface);
    jobs_.add("Building " + mesh.name, std::move(opened.job), [this, id = mesh.id](const FlgJobStatus& status) {
        if (status.result != FLG_OK) remove(id);
    });
}

void Scene::take(SceneMesh& mesh) {
    const MeshFile file = mesh.reading.get();
    if (file.file != nullptr) return build(mesh, open_file(context_, file, mesh.source));
    if (mesh.is_of_document) {
        mesh.missing = true;
        mesh.name = "missing: " + std::filesystem::path(mesh.source).filename().string();
    } else {
        remove(mesh.id);
    }
    throw StudioError(file.error);
}

std::string Scene::free_name(const std::string& base) const {
    const auto is_taken = [&](const std::string& name) {
        const auto has_name = [&](const auto& mesh) { return mesh->name == name; };
        return std::any_of(meshes_.begin(), meshes_.end(), has_name) ||
               std::any_of(taken_out_.begin(), taken_out_.end(), has_name);
    };
    std::string name = base;
    for (int number = 2; is_taken(name); ++number) name = base + " " + std::to_string(number);
    return name;
}

void Scene::remove(uint32_t id) {
    MeshState state = this->state(id);
    state.is_there = false;
    set_state(id, state);
    std::erase_if(taken_out_, [id](const auto& mesh) { return mesh->id == id; });
}

void Scene::clear() {
    while (!meshes_.empty()) remove(meshes_.back()->id);
    taken_out_.clear();
}

MeshState Scene::state(uint32_t id) const {
    for (size_t i = 0; i < meshes_.size(); ++i)
        if (meshes_[i]->id == id) return {true, i, meshes_[i]->visible, meshes_[i]->placement};
    const SceneMesh* mesh = kept(id);
    return mesh == nullptr ? MeshState{} : MeshState{false, mesh->was_at, mesh->visible, mesh->placement};
}

void Scene::set_state(uint32_t id, const MeshState& state) {
    const auto has_id = [id](const auto& mesh) { return mesh->id == id; };
    const auto there = std::find_if(meshes_.begin(), meshes_.end(), has_id),
               away = std::find_if(taken_out_.begin(), taken_out_.end(), has_id);
    if (state.is_there && away != taken_out_.end()) {
        const size_t at = std::min(state.at, meshes_.size());
        meshes_.insert(meshes_.begin() + static_cast<std::ptrdiff_t>(at), std::move(*away));
        taken_out_.erase(away);
    } else if (!state.is_there && there != meshes_.end()) {
        renderer_.remove(std::exchange((*there)->drawn, {}));
        (*there)->is_shown_bent = (*there)->plays = false;
        (*there)->bend.rest();
        (*there)->was_at = static_cast<size_t>(there - meshes_.begin());
        taken_out_.push_back(std::move(*there));
        meshes_.erase(there);
        if (active_ == id) active_ = meshes_.empty() ? 0 : meshes_.back()->id;
    }
    SceneMesh* mesh = kept(id);
    if (mesh == nullptr) return;
    set_visible(*mesh, state.visible);
    if (mesh->is_placed) set_placement(*mesh, state.placement);
}

SceneMesh* Scene::drawing() const {
    for (const auto& mesh : meshes_)
        if (mesh->is_drawing()) return mesh.get();
    return nullptr;
}

void Scene::set_drawing(bool is_there) {
    const SceneMesh* now = drawing();
    if (is_there == (now != nullptr)) return;
    const auto away =
        std::find_if(taken_out_.begin(), taken_out_.end(), [](const auto& mesh) { return mesh->is_drawing(); });
    if (now == nullptr && away == taken_out_.end()) {
        auto mesh = std::make_unique<SceneMesh>();
        mesh->id = ++last_id_;
        mesh->name = free_name("Drawing");
        mesh->source = kDrawing;
        mesh->look.material = kPorcelain;
        meshes_.push_back(std::move(mesh));
        return;
    }
    const uint32_t id = now != nullptr ? now->id : (*away)->id;
    MeshState state = this->state(id);
    state.is_there = is_there;
    set_state(id, state);
}

void Scene::supply(SceneMesh& mesh, filigree::Surface surface, filigree::Job job) {
    mesh.preparing = {};
    mesh.surface = std::move(surface);
    ++mesh.generation;
    mesh.ready = false;
    mesh.box = {};
    mesh.label_of.clear();
    mesh.look.regions.clear();
    mesh.stale = true;
    mesh.picker.forget();
    jobs_.add("Building " + mesh.name, std::move(job), {}, Jobs::Shown::quiet);
}

SceneMesh* Scene::kept(uint32_t id) const {
    for (const auto& mesh : taken_out_)
        if (mesh->id == id) return mesh.get();
    return find(id);
}

SceneMesh* Scene::find(uint32_t id) const {
    for (const auto& mesh : meshes_)
        if (mesh->id == id) return mesh.get();
    return nullptr;
}

std::vector<uint32_t> Scene::ids() const {
    std::vector<uint32_t> ids;
    for (const auto& mesh : meshes_) ids.push_back(mesh->id);
    return ids;
}

void Scene::set_visible(SceneMesh& mesh, bool visible) {
    mesh.visible = visible;
    if (mesh.drawn.value != 0) renderer_.set_visible(mesh.drawn, visible);
}

void Scene::set_placement(SceneMesh& mesh, const render::Placement& placement) {
    if (mesh.is_placed && !(mesh.placement == placement)) mesh.is_moved = true;
    mesh.placement = placement;
    if (mesh.is_drawing() && !mesh.box.empty()) {
        const auto known = std::find_if(mesh.stood.begin(), mesh.stood.end(), stood_with(mesh.box));
        if (known != mesh.stood.end()) mesh.stood.erase(known);
        mesh.stood.emplace_back(mesh.box, placement);
    }
    mesh.is_placed = true;
    if (mesh.drawn.value != 0) renderer_.set_placement(mesh.drawn, placement);
}

render::Placement Scene::find_place(const render::Box& own) const {
    std::vector<render::Box> others = beside ? beside() : std::vector<render::Box>{};
    for (const auto& mesh : meshes_)
        if (mesh->is_placed) others.push_back(mesh->placed_box());
    const bool has_floor = std::any_of(meshes_.begin(), meshes_.end(),
                                       [](const auto& mesh) { return mesh->is_placed && !mesh->box.empty(); });
    render::Placement place = free_place(own, others);
    if (has_floor) place.at.y += floor() - place.box(own).min.y;
    return place;
}

std::optional<MeshHit> Scene::hit(const Ray& ray) const {
    std::optional<MeshHit> first;
    float least = std::numeric_limits<float>::infinity();
    for (const auto& mesh : meshes_) {
        if (!mesh->visible || !mesh->is_placed) continue;
        const render::Placement into = mesh->placement.inverse();
        const auto hit = mesh->picker.hit(into.point(ray.origin), into.direction(ray.direction));
        if (!hit || hit->distance * mesh->placement.scale >= least) continue;
        least = hit->distance * mesh->placement.scale;
        first = MeshHit{mesh.get(), *hit};
    }
    return first;
}

std::optional<MeshHit> Scene::nearest(const SceneMesh& mesh, const glm::vec3& position) const {
    const auto hit = mesh.picker.nearest(mesh.placement.inverse().point(position));
    if (!hit) return std::nullopt;
    return MeshHit{find(mesh.id), *hit};
}

render::Box Scene::box() const {
    render::Box box;
    for (const auto& mesh : meshes_)
        if (mesh->visible && mesh->is_placed) box.add(mesh->placed_box());
    return box;
}

float Scene::floor() const {
    render::Box box = this->box();
    if (box.empty())
        for (const auto& mesh : meshes_)
            if (mesh->is_placed) box.add(mesh->placed_box());
    return box.empty() ? 0.0f : box.min.y;
}

size_t Scene::overlap_count() const {
    size_t count = 0;
    for (size_t i = 0; i < meshes_.size(); ++i) {
        for (size_t k = 0; k < i; ++k) {
            const render::Box a = meshes_[i]->placed_box(), b = meshes_[k]->placed_box();
            const bool both = meshes_[i]->visible && meshes_[k]->visible && !a.empty() && !b.empty();
            if (both && glm::all(glm::lessThan(a.min, b.max)) && glm::all(glm::lessThan(b.min, a.max))) ++count;
        }
    }
    return count;
}

bool Scene::is_placed() const {
    return std::all_of(meshes_.begin(), meshes_.end(),
                       [](const auto& mesh) { return mesh->is_placed || mesh->missing || !mesh->is_coming(); });
}

void Scene::update() {
    for (const std::vector<std::unique_ptr<SceneMesh>>* list : {&meshes_, &taken_out_})
        for (const auto& mesh : *list)
            if (mesh->reading.valid() && mesh->reading.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
                return take(*mesh);  // the others with the next frames: it may remove itself
    bool may_place = true;           // in their order, so that places don't depend on which is made first
    for (const auto& mesh : meshes_) {
        FlgSurfaceView view = flgSurfaceViewDefaults();
        // A surface whose job failed is removed by that job.
        mesh->ready = flgSurfaceGetView(context_.get(), mesh->surface.get(), &view) == FLG_OK && prepare(*mesh, view);
        if (mesh->ready && mesh->box.empty()) {
            const FlgSurfaceReport report = mesh->surface.report();
            mesh->box = {glm::make_vec3(report.box_min), glm::make_vec3(report.box_max)};
            if (mesh->is_drawing() && mesh->is_placed) stand_again(*mesh);
        }
        if (mesh->ready && !mesh->is_placed && may_place) set_placement(*mesh, find_place(mesh->box));
        may_place = may_place && (mesh->is_placed || mesh->missing || !mesh->is_coming());
        if (!mesh->ready || !mesh->is_placed) continue;
        const bool is_new = mesh->stale || view.revision != mesh->shown_revision;
        if (mesh->bend.is_bent() && mesh->drawn.value != 0)
            show_bent(*mesh, view);
        else if (is_new || mesh->drawn.value == 0 || mesh->is_shown_bent)
            show(*mesh, view);
        mesh->picker.update(mesh->surface, view);
    }
}

void Scene::stand_again(SceneMesh& mesh) {
    const auto known = std::find_if(mesh.stood.begin(), mesh.stood.end(), stood_with(mesh.box));
    if (known != mesh.stood.end()) return set_placement(mesh, render::Placement(known->second));
    if (mesh.stood.empty()) return set_placement(mesh, render::Placement(mesh.placement));
    if (!mesh.is_moved) {
        mesh.is_placed = false;  // a place is found
        return;
    }
    const auto& [box, placement] = mesh.stood.back();
    render::Placement now = mesh.placement;
    now.at.y += placement.box(box).min.y - now.box(mesh.box).min.y;
    set_placement(mesh, now);
}

bool Scene::settled() const {
    for (const auto& mesh : meshes_) {
        if (mesh->missing || !mesh->is_coming()) continue;
        if (!mesh->ready || !mesh->is_placed || mesh->stale || mesh->bending.valid()) return false;
        if (!mesh->picker.knows(mesh->shown_revision)) return false;
    }
    return true;
}

bool Scene::prepare(SceneMesh& mesh, const FlgSurfaceView& view) {
    constexpr uint32_t kLarge = 200'000;  // triangles: beyond, it would be felt
    if (mesh.was_shown || view.mesh->triangle_count < kLarge) return true;
    if (!mesh.preparing.valid()) {
        mesh.picker.begin(view);
        mesh.preparing = std::async(std::launch::async, [shown = *view.mesh, look = mesh.look] {
            return render::PreparedSurface(shown, look);
        });
    }
    if (mesh.preparing.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
    if (!mesh.picker.is_built()) return false;
    mesh.was_shown = true;
    mesh.drawn = renderer_.upload(mesh.preparing.get());
    renderer_.set_visible(mesh.drawn, mesh.visible);
    renderer_.set_placement(mesh.drawn, mesh.placement);
    mesh.shown_revision = view.revision;
    mesh.stale = false;
    return true;
}

void Scene::show(SceneMesh& mesh, const FlgSurfaceView& view) {
    const LabelledMesh labelled(mesh, *view.mesh);
    const FlgMeshView& shown = labelled.view();
    mesh.is_shown_bent = false;
    mesh.bending = {};
    if (mesh.drawn.value == 0)
        mesh.drawn = renderer_.upload(shown, mesh.look);
    else
        renderer_.update(mesh.drawn, shown, mesh.look);
    renderer_.set_visible(mesh.drawn, mesh.visible);
    renderer_.set_placement(mesh.drawn, mesh.placement);
    mesh.shown_revision = view.revision;
    mesh.stale = false;
}

void Scene::show_bent(SceneMesh& mesh, const FlgSurfaceView& view) {
    const bool is_current = mesh.is_shown_bent && !mesh.stale && view.revision == mesh.shown_revision;
    if (!is_current && !mesh.bending.valid()) {
        const LabelledMesh labelled(mesh, *view.mesh);
        mesh.bending = std::async(std::launch::async, [copy = MeshCopy(labelled.view(), mesh.look),
                                                       skin = mesh.bend.skin()] { return bend_mesh(copy, *skin); });
        mesh.shown_revision = view.revision;
        mesh.stale = false;
    }
    const std::span<const float> joints = mesh.bend.dual_quaternions();
    if (mesh.bending.valid() && mesh.bending.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        const BentMesh bent = mesh.bending.get();
        renderer_.update(mesh.drawn, bent.view(joints.size() / 8), bent.look);
        mesh.is_shown_bent = true;
    }
    if (mesh.is_shown_bent) renderer_.set_pose(mesh.drawn, FLG_SKINNING_DUAL_QUATERNION, joints);
}

bool Scene::plays() const {
    return std::any_of(meshes_.begin(), meshes_.end(), [](const auto& mesh) { return mesh->plays; });
}

void Scene::stop_playing() {
    for (const auto& mesh : meshes_) {
        mesh->plays = false;
        mesh->bend.rest();
    }
}

void Scene::device_lost() {
    for (const auto& mesh : meshes_) {
        mesh->drawn = {};
        mesh->is_shown_bent = false;
    }
}

nlohmann::json Scene::save() const {
    nlohmann::json list = nlohmann::json::array();
    for (const auto& mesh : meshes_) {
        nlohmann::json entry = {{"source", mesh->source}, {"name", mesh->name}, {"visible", mesh->visible}};
        if (mesh->is_placed) entry["placement"] = to_json(mesh->placement);
        list.push_back(std::move(entry));
    }
    nlohmann::json part = {{"meshes", std::move(list)}};
    for (size_t i = 0; i < meshes_.size(); ++i)
        if (meshes_[i]->id == active_) part["active"] = i;
    return part;
}

void Scene::load(const nlohmann::json& part) {
    clear();
    if (!part.contains("meshes")) return;
    std::string refusal;
    for (const nlohmann::json& entry : part.at("meshes")) {
        const auto source = entry.at("source").get<std::string>();
        try {
            if (source == kDrawing)
                set_drawing(true);
            else
                open(source);
        } catch (const StudioError& error) {
            if (refusal.empty()) refusal = error.what();
            auto absent = std::make_unique<SceneMesh>();
            absent->id = ++last_id_;
            absent->source = source;
            absent->name = "missing: " + std::filesystem::path(source).filename().string();
            absent->missing = true;
            meshes_.push_back(std::move(absent));
        }
        SceneMesh& mesh = *meshes_.back();
        mesh.is_of_document = true;
        const std::string name = entry.value("name", "");
        if (!name.empty()) mesh.name = name;
        mesh.visible = entry.value("visible", true);
        // Documents from before there were placements have all meshes where they were made.
        mesh.is_placed = !mesh.is_drawing() || entry.contains("placement");
        if (!entry.contains("placement")) continue;
        mesh.is_moved = true;
        try {
            mesh.placement = to_placement(entry.at("placement"));
        } catch (const std::exception& error) {
            if (refusal.empty()) refusal = error.what();
        }
    }
    const size_t active = part.value("active", size_t{0});
    if (active < meshes_.size()) active_ = meshes_[active]->id;
    if (!refusal.empty()) throw StudioError(refusal);
}

}  // namespace flg::studio
