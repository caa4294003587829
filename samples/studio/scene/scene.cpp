// SPDX-License-Identifier: MIT
#include "scene/scene.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <glm/gtc/type_ptr.hpp>

#include "scene/mesh_sources.h"
#include "shell/studio_error.h"

namespace flg::studio {
namespace {

// Unglazed porcelain.
constexpr render::Material kPorcelain{.color = {0.60f, 0.55f, 0.49f}, .metallic = 0.0f, .roughness = 0.55f};
constexpr float kFarthest = 1e18f;  // what picking takes

void check_pick(FlgResult result) {
    if (result < 0) throw StudioError(flgPickLastError());
}

}  // namespace

Scene::Scene(filigree::Context& context, render::Renderer& renderer, Jobs& jobs)
    : context_(context), renderer_(renderer), jobs_(jobs) {
    check_pick(flgPickSceneCreate(nullptr, &pick_));
}

Scene::~Scene() {
    if (building_.valid()) building_.wait();
    flgPickSceneDestroy(pick_);
}

SceneMesh& Scene::open(const std::string& source) {
    OpenedMesh opened = open_mesh(context_, source);
    auto mesh = std::make_unique<SceneMesh>();
    mesh->id = ++last_id_;
    mesh->name = opened.name;
    const bool is_file = !source.starts_with("builtin:");
    mesh->source = is_file ? std::filesystem::absolute(source).string() : source;
    mesh->surface = std::move(opened.surface);
    mesh->look.material = kPorcelain;
    meshes_.push_back(std::move(mesh));
    active_ = last_id_;
    jobs_.add("Making the surface of " + opened.name, std::move(opened.job),
              [this, id = last_id_](const FlgJobStatus& status) {
                  if (status.result != FLG_OK && find(id) != nullptr) remove(id);
              });
    return *meshes_.back();
}

void Scene::remove(uint32_t id) {
    const auto found = std::find_if(meshes_.begin(), meshes_.end(), [id](const auto& mesh) { return mesh->id == id; });
    if (found == meshes_.end()) return;
    renderer_.remove((*found)->drawn);
    if ((*found)->pickable) unpicked_.push_back(id);
    meshes_.erase(found);
    if (active_ == id) active_ = meshes_.empty() ? 0 : meshes_.back()->id;
}

void Scene::clear() {
    while (!meshes_.empty()) remove(meshes_.back()->id);
}

SceneMesh* Scene::find(uint32_t id) const {
    for (const auto& mesh : meshes_)
        if (mesh->id == id) return mesh.get();
    return nullptr;
}

void Scene::set_visible(SceneMesh& mesh, bool visible) {
    mesh.visible = visible;
    if (mesh.drawn.value != 0) renderer_.set_visible(mesh.drawn, visible);
}

std::optional<MeshHit> Scene::hit(const Ray& ray) const {
    if (!can_pick()) return std::nullopt;
    FlgRay shot{};
    for (int i = 0; i < 3; ++i) {
        shot.origin[i] = ray.origin[i];
        shot.direction[i] = ray.direction[i];
    }
    shot.furthest = kFarthest;
    FlgHit hit{};
    // What is hidden is shot through.
    while (flgPickRays(pick_, &shot, 1, &hit) == FLG_OK && hit.object != FLG_NO_INDEX) {
        SceneMesh* mesh = find(hit.object);
        if (mesh != nullptr && mesh->visible) return MeshHit{mesh, hit};
        const float past = std::nextafter(hit.distance * (1.0f + 1e-6f), kFarthest);
        if (!(past > shot.nearest)) break;
        shot.nearest = past;
    }
    return std::nullopt;
}

std::optional<MeshHit> Scene::nearest(const SceneMesh& mesh, const glm::vec3& position) const {
    FlgHit hit{};
    if (!can_pick() || flgPickNearest(pick_, glm::value_ptr(position), kFarthest, &hit) != FLG_OK) return std::nullopt;
    if (hit.object != mesh.id) return std::nullopt;
    return MeshHit{find(mesh.id), hit};
}

render::Box Scene::box() const {
    render::Box box;
    for (const auto& mesh : meshes_)
        if (mesh->visible) box.add(mesh->box);
    return box;
}

void Scene::update() {
    if (building_.valid() && building_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
        check_pick(building_.get());
    for (const auto& mesh : meshes_) {
        FlgSurfaceView view = flgSurfaceViewDefaults();
        // A surface whose job failed is removed by that job.
        mesh->ready = flgSurfaceGetView(context_.get(), mesh->surface.get(), &view) == FLG_OK;
        if (!mesh->ready) continue;
        if (mesh->stale || mesh->drawn.value == 0 || view.revision != mesh->shown_revision) show(*mesh, view);
        if (can_pick() && (!mesh->pickable || mesh->picked_revision != view.revision)) {
            make_pickable(*mesh, view, mesh->picked_revision);
            mesh->pickable = true;
            mesh->picked_revision = view.revision;
        }
    }
    if (!can_pick()) return;
    for (const uint32_t id : unpicked_) check_pick(flgPickSceneRemove(pick_, id));
    pick_changed_ = pick_changed_ || !unpicked_.empty();
    unpicked_.clear();
    if (!std::exchange(pick_changed_, false)) return;
    building_ = std::async(std::launch::async, [scene = pick_] { return flgPickSceneCommit(scene); });
}

bool Scene::settled() const {
    if (!can_pick()) return false;
    for (const auto& mesh : meshes_)
        if (!mesh->missing && (!mesh->ready || mesh->stale || !mesh->pickable)) return false;
    return true;
}

void Scene::show(SceneMesh& mesh, const FlgSurfaceView& view) {
    if (mesh.box.empty()) {
        const FlgSurfaceReport report = mesh.surface.report();
        mesh.box = {glm::make_vec3(report.box_min), glm::make_vec3(report.box_max)};
    }
    FlgMeshView shown = view.mesh;
    std::vector<uint32_t> labels;
    if (!mesh.label_of.empty() && shown.regions != nullptr) {
        labels.assign(shown.regions, shown.regions + shown.triangle_count);
        for (uint32_t& label : labels) label = label < mesh.label_of.size() ? mesh.label_of[label] : 0;
        shown.regions = labels.data();
    }
    if (mesh.drawn.value == 0)
        mesh.drawn = renderer_.upload(shown, mesh.look);
    else
        renderer_.update(mesh.drawn, shown, mesh.look);
    renderer_.set_visible(mesh.drawn, mesh.visible);
    mesh.shown_revision = view.revision;
    mesh.stale = false;
}

void Scene::make_pickable(const SceneMesh& mesh, const FlgSurfaceView& view, uint32_t since_revision) {
    if (mesh.pickable) {
        const std::vector<uint32_t> changed = mesh.surface.changes(since_revision);
        check_pick(
            flgPickSceneSetSurface(pick_, mesh.id, &view, changed.data(), static_cast<uint32_t>(changed.size())));
    } else {
        check_pick(flgPickSceneSetSurface(pick_, mesh.id, &view, nullptr, 0));
    }
    pick_changed_ = true;
}

void Scene::device_lost() {
    for (const auto& mesh : meshes_) mesh->drawn = {};
}

nlohmann::json Scene::save() const {
    nlohmann::json list = nlohmann::json::array();
    for (const auto& mesh : meshes_)
        list.push_back({{"source", mesh->source}, {"name", mesh->name}, {"visible", mesh->visible}});
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
        const std::string name = entry.value("name", "");
        if (!name.empty()) mesh.name = name;
        mesh.visible = entry.value("visible", true);
    }
    const size_t active = part.value("active", size_t{0});
    if (active < meshes_.size()) active_ = meshes_[active]->id;
    if (!refusal.empty()) throw StudioError(refusal);
}

}  // namespace flg::studio
