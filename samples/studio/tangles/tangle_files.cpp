// SPDX-License-Identifier: MIT
// What of the tangles workspace goes to files and comes from them.
#include <filesystem>
#include <fstream>

#include "tangles/history_text.h"
#include "tangles/tangles_workspace.h"

namespace flg::studio {
namespace {

constexpr size_t kMostDocument = size_t{16} << 20;  // bytes of a .json that is looked into

}  // namespace

// Only of tangles that no step of is under way.
TanglesWorkspace::Kept TanglesWorkspace::kept() const {
    Kept all{{}, to_json(palette_), acts_};
    for (const auto& [mesh, ornament] : ornaments_) {
        if (ornament->regions.count() == 0) continue;
        const FlgTangleHistory history = ornament->tangle.history();
        if (history.step_count == 0 && ornament->paints.empty()) continue;
        nlohmann::json paints = nlohmann::json::array();
        for (const auto& [region, material] : ornament->paints) paints.push_back({region, material});
        all.ornaments[mesh] = {{"history", history_to_json(history)}, {"paints", std::move(paints)}};
    }
    // What is being tried counts as kept.
    if (const Ornament* ornament = trying(); ornament != nullptr && ornament->live->is_made)
        all.acts.push({.kind = Act::Kind::step, .mesh = ornament->mesh_id()});
    return all;
}

void TanglesWorkspace::take_snapshot() {
    constexpr double kRest_s = 0.4;
    if (snapshot_changes_ == desk_.changes || !all_idle()) return;
    // Not with each of a slider's previews: it may take milliseconds.
    if (desk_.seconds < snapshot_after_s_) return;
    snapshot_after_s_ = desk_.seconds + kRest_s;
    snapshot_changes_ = desk_.changes;
    snapshot_ = kept();
}

nlohmann::json TanglesWorkspace::save() const {
    const Kept all = all_idle() ? kept() : snapshot_;
    if (all.palette.is_null()) return nlohmann::json::object();  // nothing was ever done
    nlohmann::json meshes = nlohmann::json::array();
    std::map<uint32_t, size_t> number_of;
    for (const auto& mesh : desk_.scene.meshes()) {
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
    Acts acts;
    struct Read {
        uint32_t mesh;
        HistoryFile history;
        Paints paints;
        nlohmann::json json;
    };
    std::vector<Read> read;
    try {
        if (!part.empty()) {
            palette = palette_from_json(part.at("palette"));
            std::vector<uint32_t> mesh_of;
            for (const auto& mesh : desk_.scene.meshes()) mesh_of.push_back(mesh->id);
            acts = Acts::from_json(part.at("acts"), mesh_of);
            for (const nlohmann::json& entry : part.at("meshes")) {
                Read one{mesh_of.at(entry.at("mesh").get<size_t>()), history_from_json(entry.at("history")), {}, entry};
                for (const nlohmann::json& p : entry.at("paints")) {
                    const uint32_t material = p.at(1).get<uint32_t>();
                    if (material >= palette.materials.size())
                        throw StudioError("A tangle is painted with no material.");
                    one.paints.emplace(p.at(0).get<uint32_t>(), material);
                }
                read.push_back(std::move(one));
            }
        }
    } catch (const StudioError&) {
        throw;
    } catch (const std::exception& error) {
        throw StudioError(std::string("The tangles of the document can't be read: ") + error.what());
    }
    commands_.clear();
    ornaments_.clear();
    selected_.clear();
    hovered_.clear();
    palette_ = std::move(palette);
    acts_ = std::move(acts);
    snapshot_ = {{}, to_json(palette_), acts_};
    for (Read& one : read) {
        snapshot_.ornaments[one.mesh] = std::move(one.json);
        Ornament& ornament = make_ornament(*desk_.scene.find(one.mesh));
        ornament.paints = std::move(one.paints);
        replay(ornament, history_of(one.history));
    }
}

void TanglesWorkspace::replay(Ornament& ornament, const FlgTangleHistory& history) {
    ornament.run("Making the ornament of " + ornament.mesh()->name, ornament.tangle.replay(history), owner(),
                 Jobs::Shown::listed, [this, mesh = ornament.mesh_id()](const FlgJobStatus& status) {
                     if (status.result == FLG_OK) return;
                     acts_.forget_mesh(mesh);
                     if (Ornament* failed = find(mesh)) failed->paints.clear();
                 });
}

bool TanglesWorkspace::open(const std::string& path) {
    std::error_code error;
    if (std::filesystem::path(path).extension() != ".json" || std::filesystem::file_size(path, error) > kMostDocument)
        return false;
    std::ifstream file(path);
    const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
    if (!json.is_object() || json.value("filigree", nlohmann::json()) != "tangle") return false;
    SceneMesh* mesh = desk_.scene.active();
    if (mesh == nullptr) throw StudioError("Open the mesh of " + path + " first, then the tangle.");
    Ornament* ornament = find(mesh->id);
    if (ornament != nullptr && (ornament->live || ornament->regions.undo_count() > 0 || ornament->running()))
        throw StudioError(mesh->name + " has an ornament; open its mesh once more for that of " + path + ".");
    const HistoryFile history = read_history(path);
    if (ornament == nullptr) ornament = &make_ornament(*mesh);
    const FlgTangleHistory steps = history_of(history);
    ornament->run("Making the ornament of " + mesh->name, ornament->tangle.replay(steps), owner(), Jobs::Shown::listed,
                  [this, id = mesh->id, count = steps.made_count](const FlgJobStatus& status) {
                      if (status.result != FLG_OK) return;
                      for (uint32_t i = 0; i < count; ++i) acts_.push({.kind = Act::Kind::step, .mesh = id});
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
        throw StudioError("There is no ornament to export; divide a mesh first.");
    if (!ornament->idle()) throw StudioError("A step is under way; export again when it is done.");
    if (std::string(what.extension) == ".json") {
        const FlgTangleHistory history = ornament->tangle.history();
        if (flgTangleFileWrite(path.c_str(), &history) != FLG_OK) throw StudioError(flgIoLastError());
        return;
    }
    FlgMeshView mesh = ornament->mesh()->surface.view().mesh;
    std::vector<uint32_t> labels(mesh.regions, mesh.regions + mesh.triangle_count);
    for (uint32_t& label : labels) label = ornament->material_of(label);
    mesh.regions = labels.data();
    std::vector<FlgMeshMaterial> table;
    for (const TangleMaterial& m : palette_.materials) {
        const glm::vec3& line = m.border_px > 0.0f ? m.border_color : palette_.border_color;
        table.push_back({.name = m.name.c_str(),
                         .color = {m.color.x, m.color.y, m.color.z},
                         .metallic = m.metallic,
                         .roughness = m.roughness,
                         .border_color = {line.x, line.y, line.z},
                         .border_width_px = m.border_px > 0.0f ? m.border_px : palette_.border_px,
                         .reserved = 0});
    }
    FlgMeshWriteDesc desc{};
    if (flgMeshWriteDescInit(&desc, sizeof desc) != FLG_OK) throw StudioError(flgIoLastError());
    desc.split_regions = 1;
    desc.materials = table.data();
    desc.material_count = static_cast<uint32_t>(table.size());
    if (flgMeshFileWrite(path.c_str(), &mesh, &desc) != FLG_OK) throw StudioError(flgIoLastError());
}

}  // namespace flg::studio
