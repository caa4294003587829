// SPDX-License-Identifier: MIT
// What of the tangles workspace goes to files and comes from them.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tangles/history_text.h"
#include "tangles/tangles_workspace.h"

namespace flg::studio {
namespace {

constexpr size_t kMaxDocument = size_t{16} << 20;  // bytes of a .json that is looked into

Paints paints_of(const nlohmann::json& ornament) {
    Paints paints;
    for (const nlohmann::json& p : ornament.at("paints"))
        paints.emplace(p.at(0).get<uint32_t>(), p.at(1).get<uint32_t>());
    return paints;
}

}  // namespace

// Null for nothing.
nlohmann::json TanglesWorkspace::to_json(const Ornament& ornament) const {
    FlgTangleHistory history = ornament.tangle.history();
    history.step_count = history.made_count;  // what was taken back is not kept
    const Paints shown = ornament.shown_paints();
    if (history.step_count == 0 && shown.empty()) return {};
    nlohmann::json paints = nlohmann::json::array();
    for (const auto& [region, material] : shown) paints.push_back({region, material});
    return {{"history", history_to_json(history)}, {"paints", std::move(paints)}};
}

// Only of tangles that no step of is under way.
TanglesWorkspace::Kept TanglesWorkspace::kept() const {
    Kept all{{}, studio::to_json(palette_), undo_steps_};
    for (const auto& [mesh, waiting] : waiting_) all.ornaments[mesh] = waiting.json;
    for (const auto& [mesh, ornament] : ornaments_) {
        if (ornament->regions.count() == 0) continue;
        if (nlohmann::json json = to_json(*ornament); !json.is_null()) all.ornaments[mesh] = std::move(json);
        all.acts.count_anew(mesh, static_cast<uint32_t>(ornament->steps.size()));
    }
    // What is being tried counts as kept.
    if (const Ornament* ornament = trying(); ornament != nullptr && ornament->live->is_made) {
        all.acts.push({.kind = UndoStep::Kind::step, .mesh = ornament->mesh_id()});
        if (UndoStep painted = paint_of_step(*ornament); !painted.paints.empty()) all.acts.push(std::move(painted));
    }
    return all;
}

void TanglesWorkspace::take_snapshot() {
    constexpr double kRest_s = 0.4;
    if (snapshot_changes_ == app_.changes || !all_idle()) return;
    // Not with each of a slider's previews: it may take milliseconds.
    if (app_.seconds < snapshot_after_s_) return;
    snapshot_after_s_ = app_.seconds + kRest_s;
    snapshot_changes_ = app_.changes;
    snapshot_ = kept();
}

nlohmann::json TanglesWorkspace::save() const {
    const Kept all = all_idle() ? kept() : snapshot_;
    if (all.palette.is_null()) return nlohmann::json::object();  // nothing was ever done
    nlohmann::json meshes = nlohmann::json::array();
    std::map<uint32_t, size_t> number_of;
    for (const auto& mesh : app_.scene.meshes()) {
        const size_t number = number_of.size();
        number_of.emplace(mesh->id, number);
        const auto found = all.ornaments.find(mesh->id);
        if (found == all.ornaments.end()) continue;
        meshes.push_back(found->second);
        meshes.back()["mesh"] = number;
    }
    return {{"meshes", std::move(meshes)}, {"palette", all.palette}, {"acts", all.acts.to_json(number_of)}};
}

void TanglesWorkspace::load(const nlohmann::json& part) {
    Palette palette = house_palette();
    UndoSteps acts;
    std::map<uint32_t, Waiting> waiting;
    try {
        if (!part.empty()) {
            palette = palette_from_json(part.at("palette"));
            std::vector<uint32_t> mesh_of;
            for (const auto& mesh : app_.scene.meshes()) mesh_of.push_back(mesh->id);
            acts = UndoSteps::from_json(part.at("acts"), mesh_of);
            for (const nlohmann::json& entry : part.at("meshes")) {
                history_from_json(entry.at("history"));  // throws for what is damaged
                for (const auto& [region, material] : paints_of(entry))
                    if (material >= palette.materials.size())
                        throw StudioError("The document paints a region with a material that does not exist.");
                Waiting one{entry};
                one.json.erase("mesh");
                waiting.emplace(mesh_of.at(entry.at("mesh").get<size_t>()), std::move(one));
            }
        }
    } catch (const StudioError&) {
        throw;
    } catch (const std::exception& error) {
        throw StudioError(std::string("The ornament in the document cannot be read: ") + error.what());
    }
    commands_.clear();
    ornaments_.clear();
    selected_.clear();
    hovered_.clear();
    palette_ = std::move(palette);
    undo_steps_ = std::move(acts);
    waiting_ = std::move(waiting);
    app_.timeline.adopt(*this, undo_steps_.done());
    snapshot_ = kept();
}

void TanglesWorkspace::replay(Ornament& ornament, Waiting waiting) {
    const HistoryFile file = history_from_json(waiting.json.at("history"));
    FlgTangleHistory history = history_of(file);
    if (const SceneMesh& mesh = *ornament.mesh(); mesh.is_drawing()) {
        // It has grown or shrunk by a part, perhaps. What is on the other parts stays where it is.
        std::copy_n(&mesh.box.min.x, 3, history.box_min);
        std::copy_n(&mesh.box.max.x, 3, history.box_max);
    }
    ornament.paints = paints_of(waiting.json);
    waiting.failed_generation = ornament.generation();
    ornament.run("Building the ornament of " + ornament.mesh()->name, ornament.tangle.replay(history), owner(),
                 Jobs::Shown::listed, [this, mesh = ornament.mesh_id(), waiting](const FlgJobStatus& status) {
                     if (status.result == FLG_OK) return;
                     // It may be possible on the surface that comes next.
                     if (Ornament* failed = find(mesh)) failed->paints.clear();
                     waiting_[mesh] = waiting;
                 });
}

bool TanglesWorkspace::open(const std::string& path) {
    std::error_code error;
    if (std::filesystem::path(path).extension() != ".json" || std::filesystem::file_size(path, error) > kMaxDocument)
        return false;
    std::ifstream file(path);
    const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
    if (!json.is_object() || json.value("filigree", nlohmann::json()) != "tangle") return false;
    SceneMesh* mesh = app_.scene.active();
    if (mesh == nullptr) throw StudioError("Open the mesh for " + path + " first, then open the ornament.");
    Ornament* ornament = find(mesh->id);
    if (ornament != nullptr && (ornament->live || ornament->regions.undo_count() > 0 || ornament->running()))
        throw StudioError(mesh->name + " already has an ornament. Add the mesh again to open " + path + " on it.");
    const HistoryFile history = read_history(path);
    if (ornament == nullptr) ornament = &make_ornament(*mesh);
    const FlgTangleHistory steps = history_of(history);
    ornament->run("Building the ornament of " + mesh->name, ornament->tangle.replay(steps), owner(),
                  Jobs::Shown::listed, [this, id = mesh->id, count = steps.made_count](const FlgJobStatus& status) {
                      if (status.result != FLG_OK) return;
                      for (uint32_t i = 0; i < count; ++i) did({.kind = UndoStep::Kind::step, .mesh = id});
                  });
    return true;
}

std::span<const Workspace::Export> TanglesWorkspace::exports() const {
    static constexpr Export kFormats[] = {{"Ornament", ".glb"}, {"Tangle", ".json"}};
    return kFormats;
}

void TanglesWorkspace::write(const Export& what, const std::string& path) {
    const Ornament* ornament = active();
    if (ornament == nullptr || ornament->regions.count() == 0)
        throw StudioError("There is no ornament to export. Divide a mesh first.");
    if (!ornament->idle()) throw StudioError("A step is still running. Export again when it is done.");
    if (std::string(what.extension) == ".json") {
        const FlgTangleHistory history = ornament->tangle.history();
        if (flgTangleFileWrite(path.c_str(), &history, nullptr) != FLG_OK) throw StudioError(flgIoErrorGetMessage());
        return;
    }
    FlgMeshView mesh = ornament->mesh()->surface.view().mesh;
    std::vector<uint32_t> labels(mesh.regions, mesh.regions + mesh.triangle_count);
    for (uint32_t& label : labels) label = ornament->material_of(label);
    mesh.regions = labels.data();
    std::vector<FlgMeshMaterial> table;
    for (const TangleMaterial& m : palette_.materials) {
        const glm::vec3& line = m.border_px > 0.0f ? m.border_color : palette_.border_color;
        FlgMeshMaterial& material = table.emplace_back(flgMeshMaterialDefaults());
        material.name = m.name.c_str();
        std::copy_n(&m.color.x, 3, material.color);
        material.metallic = m.metallic;
        material.roughness = m.roughness;
        std::copy_n(&line.x, 3, material.border_color);
        material.border_width_px = m.border_px > 0.0f ? m.border_px : palette_.border_px;
    }
    FlgMeshFileWriteDesc desc{};
    if (flgMeshFileWriteDescInit(&desc, sizeof desc) != FLG_OK) throw StudioError(flgIoErrorGetMessage());
    desc.split_regions = 1;
    desc.materials = table.data();
    desc.material_count = static_cast<uint32_t>(table.size());
    if (flgMeshFileWrite(path.c_str(), &mesh, &desc) != FLG_OK) throw StudioError(flgIoErrorGetMessage());
}

}  // namespace flg::studio
