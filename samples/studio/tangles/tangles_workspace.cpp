// SPDX-License-Identifier: MIT
#include "tangles/tangles_workspace.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "workspaces.h"

namespace flg::studio {
namespace {

constexpr glm::vec3 kSelectionColor{1.0f, 0.42f, 0.02f}, kHoverColor{1.0f, 0.97f, 0.90f},
    kGripColor{0.02f, 0.75f, 0.9f};
constexpr float kLift = 0.002f;  // of highlights above the mesh, of its size

}  // namespace

std::unique_ptr<Workspace> make_tangles(Desk& desk) {
    return std::make_unique<TanglesWorkspace>(desk);
}

TanglesWorkspace::TanglesWorkspace(Desk& desk)
    : Workspace(desk),
      selection_lines_(desk.renderer, kSelectionColor, 3.0f),
      hover_lines_(desk.renderer, kHoverColor, 2.0f),
      grip_lines_(desk.renderer, kGripColor, 4.0f) {}

std::string TanglesWorkspace::help() const {
    if (const Ornament* ornament = trying()) {
        const Recipe& recipe = ornament->live->recipe;
        const SeedChoice& seeds = edits_towards_ ? recipe.towards : recipe.from;
        if (is_operator(recipe.deed) && seeds.kind == SeedKind::points)
            return "Click to add points, drag them, Delete takes one away; Enter keeps the step, Escape discards it.";
        if (is_operator(recipe.deed) && seeds.kind == SeedKind::picked)
            return "Click a border or drag along it; Enter keeps the step, Escape discards it.";
        return "Move the sliders: the mesh follows. Enter keeps the step, Escape discards it.";
    }
    if (paints_) return "Click regions to paint them; Escape ends painting.";
    return "Click a part of the mesh, then press a button under Divide. Shift-click adds, Ctrl-click takes one region.";
}

void TanglesWorkspace::leave() {
    in_front_ = false;
    waiting_clicks_.clear();
    hovered_.clear();
    hovered_grip_.reset();
    hovered_point_.reset();
    dragged_point_.reset();
    dragged_grip_.reset();
    later([this] { keep(); });
}

Ornament* TanglesWorkspace::find(uint32_t mesh) const {
    const auto found = ornaments_.find(mesh);
    return found == ornaments_.end() ? nullptr : found->second.get();
}

Ornament* TanglesWorkspace::active() const {
    const SceneMesh* mesh = desk_.scene.active();
    return mesh == nullptr ? nullptr : find(mesh->id);
}

Ornament* TanglesWorkspace::trying() const {
    for (const auto& [id, ornament] : ornaments_)
        if (ornament->live) return ornament.get();
    return nullptr;
}

Ornament::Owner TanglesWorkspace::owner() {
    return [this](uint32_t mesh) { return find(mesh); };
}

bool TanglesWorkspace::all_idle() const {
    return std::none_of(ornaments_.begin(), ornaments_.end(), [](const auto& one) { return one.second->running(); });
}

bool TanglesWorkspace::busy() const {
    const bool wants = std::any_of(ornaments_.begin(), ornaments_.end(),
                                   [](const auto& one) { return one.second->running() || one.second->wants_try(); });
    return wants || !commands_.empty() || !waiting_clicks_.empty();
}

Ornament& TanglesWorkspace::make_ornament(const SceneMesh& mesh) {
    auto ornament = std::make_unique<Ornament>(desk_, mesh, palette_);
    Ornament& made = *ornament;
    ornaments_.emplace(mesh.id, std::move(ornament));
    made.make(owner());
    return made;
}

void TanglesWorkspace::update() {
    std::erase_if(ornaments_, [&](const auto& one) {
        if (desk_.scene.find(one.first) != nullptr) return false;
        acts_.forget_mesh(one.first);
        return true;
    });
    const SceneMesh* mesh = desk_.scene.active();
    if (in_front_ && mesh != nullptr && mesh->ready && find(mesh->id) == nullptr) make_ornament(*mesh);
    while (!commands_.empty() && all_idle()) {
        const std::function<void()> command = std::move(commands_.front());
        commands_.pop_front();
        command();
    }
    if (selected_mesh_ != (mesh != nullptr ? mesh->id : 0)) {
        selected_.clear();
        selected_mesh_ = mesh != nullptr ? mesh->id : 0;
    }
    for (const auto& [id, ornament] : ornaments_)
        if (ornament->wants_try() && desk_.scene.find(id)->ready) try_again(*ornament);
    if (Ornament* ornament = active(); ornament != nullptr && ornament->idle())
        selected_ = ornament->regions.existing(selected_);
    refresh_highlights();
    take_snapshot();
}

void TanglesWorkspace::refresh_highlights() {
    const Ornament* ornament = active();
    if (!in_front_ || ornament == nullptr) {
        selection_lines_.clear();
        hover_lines_.clear();
        grip_lines_.clear();
        selection_shown_ = hover_shown_ = {};
        return;
    }
    // What was traced last is shown while a step is under way.
    if (!ornament->idle() || !ornament->mesh()->ready) return;
    const float lift = kLift * ornament->mesh()->box.diagonal();
    const auto refresh = [&](const Regions& regions, Shown& shown, Highlight& lines) {
        const Shown wanted = {ornament->mesh_id(), ornament->revision(), regions};
        if (wanted == shown) return;
        shown = wanted;
        lines.clear();
        if (regions.empty()) return;
        const Outline outline =
            trace_outline(ornament->mesh()->surface.view(), ornament->regions.leaves_below(regions));
        lines.show(outline.loops, lift, desk_.scale);
    };
    refresh(selected_, selection_shown_, selection_lines_);
    refresh(hovered_mesh_ == ornament->mesh_id() ? hovered_ : Regions{}, hover_shown_, hover_lines_);
    grip_lines_.clear();
    if (!ornament->live || !is_operator(ornament->live->recipe.deed)) return;
    const std::vector<BorderLoop>& loops = ornament->live->before.outline.loops;
    const std::optional<Grip>& grip = dragged_grip_ ? dragged_grip_ : hovered_grip_;
    if (grip && grip->loop < loops.size()) grip_lines_.show({&loops[grip->loop], 1}, lift, desk_.scale);
}

void TanglesWorkspace::try_deed(Deed deed) {
    refusal_.clear();
    later([this] { keep(); });
    later([this, deed] {
        Ornament* ornament = active();
        if (ornament == nullptr || !ornament->idle())
            throw StudioError("There is no mesh to ornament; open one first.");
        const Regions on = selected_.empty() ? Regions{0} : selected_;
        ornament->begin(deed, on);
        const DeedInfo& info = info_of(deed);
        const size_t borders = ornament->live->before.outline.loops.size();
        if (borders < info.borders) {
            ornament->live.reset();
            const std::string has = borders == 0 ? "none" : std::to_string(borders);
            refusal_ = std::string(info.name) + " needs regions with " +
                       (info.borders == 1 ? "a border" : "two borders or more") + ", and the selected ones have " +
                       has + ". Divide the mesh first, by a Contour for instance, and click a part.";
            return;
        }
        edits_towards_ = false;
        hovered_.clear();
    });
}

void TanglesWorkspace::try_again(Ornament& ornament) {
    if (missing(ornament.live->recipe).empty()) acts_.forget_undone();
    ornament.try_again(owner());
}

void TanglesWorkspace::keep() {
    Ornament* ornament = trying();
    if (ornament == nullptr) return;
    // What the mouse changed last may not have been tried yet.
    if (ornament->wants_try()) {
        try_again(*ornament);
        commands_.push_front([this] { keep(); });
        return;
    }
    if (ornament->live->is_made) acts_.push({.kind = Act::Kind::step, .mesh = ornament->mesh_id()});
    ornament->live.reset();
    hovered_point_.reset();
    hovered_grip_.reset();
    dragged_point_.reset();
    dragged_grip_.reset();
    ++desk_.changes;
}

void TanglesWorkspace::discard() {
    Ornament* ornament = trying();
    if (ornament == nullptr) return;
    if (ornament->live->is_made) ornament->run("Taking back", ornament->tangle.undo(), owner(), Jobs::Shown::quiet);
    ornament->live.reset();
    hovered_point_.reset();
    hovered_grip_.reset();
    dragged_point_.reset();
    dragged_grip_.reset();
}

void TanglesWorkspace::change_regions(const char* name, filigree::Job (*begin)(Ornament&, FlgContext, const Regions&)) {
    later([this] { keep(); });
    later([this, name, begin] {
        Ornament* ornament = active();
        if (ornament == nullptr || selected_.empty()) throw StudioError("Click regions of the mesh first.");
        acts_.forget_undone();
        ornament->run(name, begin(*ornament, desk_.context.get(), selected_), owner(), Jobs::Shown::listed,
                      [this, mesh = ornament->mesh_id()](const FlgJobStatus& status) {
                          if (status.result == FLG_OK) acts_.push({.kind = Act::Kind::step, .mesh = mesh});
                      });
    });
}

void TanglesWorkspace::paint(uint32_t material, Regions on) {
    later([this] { keep(); });
    later([this, material, on = std::move(on)] {
        Ornament* ornament = active();
        if (ornament == nullptr) return;
        Act act{.kind = Act::Kind::paint, .mesh = ornament->mesh_id()};
        Regions seen;
        for (const uint32_t leaf : ornament->regions.leaves_below(on))
            seen.push_back(seen_region(ornament->regions, leaf));
        std::sort(seen.begin(), seen.end());
        seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
        for (const uint32_t region : seen) {
            const auto painted = ornament->paints.find(region);
            const auto before =
                painted == ornament->paints.end() ? std::nullopt : std::optional<uint32_t>(painted->second);
            if (before != material) act.paints.push_back({region, before, material});
        }
        if (act.paints.empty()) return;
        apply(act, true);
        acts_.push(std::move(act));
    });
}

void TanglesWorkspace::apply(const Act& act, bool forward) {
    ++desk_.changes;
    if (act.kind == Act::Kind::palette) {
        palette_ = forward ? act.after : act.before;
        recolor_all();
        return;
    }
    Ornament* ornament = find(act.mesh);
    if (ornament == nullptr) return;
    if (act.kind == Act::Kind::paint) {
        for (const PaintChange& change : act.paints) {
            const std::optional<uint32_t>& now = forward ? change.after : change.before;
            if (now)
                ornament->paints.insert_or_assign(change.region, *now);
            else
                ornament->paints.erase(change.region);
        }
        ornament->recolor();
        return;
    }
    ornament->run(forward ? "Redo" : "Undo", forward ? ornament->tangle.redo() : ornament->tangle.undo(), owner(),
                  Jobs::Shown::listed, [this, forward](const FlgJobStatus& status) {
                      if (status.result != FLG_OK) forward ? acts_.undo() : acts_.redo();
                  });
}

void TanglesWorkspace::recolor_all() {
    for (const auto& [id, ornament] : ornaments_) ornament->recolor();
}

bool TanglesWorkspace::can_undo() const {
    return acts_.can_undo() || trying() != nullptr;
}

void TanglesWorkspace::undo() {
    later([this] { keep(); });
    later([this] {
        if (acts_.can_undo()) apply(acts_.undo(), false);
    });
}

void TanglesWorkspace::redo() {
    later([this] {
        if (trying() == nullptr && acts_.can_redo()) apply(acts_.redo(), true);
    });
}

void TanglesWorkspace::select(Regions regions) {
    std::sort(regions.begin(), regions.end());
    regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
    selected_ = std::move(regions);
    refusal_.clear();
}

void TanglesWorkspace::select_parents() {
    if (const Ornament* ornament = active()) select(ornament->regions.parents(selected_));
}

void TanglesWorkspace::select_all() {
    if (const Ornament* ornament = active()) select(ornament->regions.leaves());
}

Regions TanglesWorkspace::meant(const Ornament& ornament, uint32_t leaf) const {
    const RegionList& regions = ornament.regions;
    if (leaf >= regions.count()) return {};
    if (picks_ == Picks::group) return regions.of_group(regions[leaf].group);
    if (picks_ == Picks::region) return {leaf};
    Regions alike;
    for (const uint32_t other : regions.leaves())
        if (ornament.material_of(other) == ornament.material_of(leaf)) alike.push_back(other);
    return alike;
}

bool TanglesWorkspace::shortcut(const Chord& chord) {
    if (chord.control && chord.key == GLFW_KEY_A) {
        select_all();
        return true;
    }
    if (chord.control) return false;
    switch (chord.key) {
        case GLFW_KEY_ENTER:
        case GLFW_KEY_KP_ENTER: later([this] { keep(); }); return true;
        case GLFW_KEY_ESCAPE:
            if (trying() != nullptr)
                later([this] { discard(); });
            else if (paints_)
                paints_ = false;
            else
                selected_.clear();
            return true;
        case GLFW_KEY_DELETE:
        case GLFW_KEY_BACKSPACE: return delete_point();
        case GLFW_KEY_U: select_parents(); return true;
        case GLFW_KEY_R: picks_ = Picks::region; return true;
        case GLFW_KEY_G: picks_ = Picks::group; return true;
        case GLFW_KEY_A: picks_ = Picks::alike; return true;
        case GLFW_KEY_B: paints_ = !paints_; return true;
        default: return false;
    }
}

std::span<const Workspace::Shortcut> TanglesWorkspace::shortcuts() const {
    static constexpr Shortcut kKeys[] = {{"Click", "Select; with Shift add, with Ctrl one region"},
                                         {"Ctrl+A", "Select all regions"},
                                         {"U", "Select what the selected regions are parts of"},
                                         {"R, G, A", "Clicks mean a region, its group, all of its colour"},
                                         {"B", "Paint with clicks"},
                                         {"Enter", "Keep the step that is tried"},
                                         {"Escape", "Discard it; else select nothing"},
                                         {"Delete", "Take a point of the seeds away"}};
    return kKeys;
}

void TanglesWorkspace::device_lost() {
    selection_lines_.device_lost();
    hover_lines_.device_lost();
    grip_lines_.device_lost();
    selection_shown_ = hover_shown_ = {};
}

double TanglesWorkspace::count(const std::string& name) const {
    const Ornament* ornament = active();
    if (name == "selected") return static_cast<double>(selected_.size());
    if (name == "acts") return static_cast<double>(acts_.done());
    if (name == "undone") return static_cast<double>(acts_.count() - acts_.done());
    if (name == "trying") return trying() != nullptr ? 1.0 : 0.0;
    if (name == "regions") return ornament != nullptr ? ornament->regions.count() : 0.0;
    if (name == "leaves") return ornament != nullptr ? static_cast<double>(ornament->regions.leaves().size()) : 0.0;
    if (name == "painted") return ornament != nullptr ? static_cast<double>(ornament->paints.size()) : 0.0;
    if (name == "groups") {
        std::vector<uint32_t> groups;
        if (ornament != nullptr)
            for (const uint32_t leaf : ornament->regions.leaves()) groups.push_back(ornament->regions[leaf].group);
        std::sort(groups.begin(), groups.end());
        return static_cast<double>(std::unique(groups.begin(), groups.end()) - groups.begin());
    }
    throw StudioError("Tangles count no " + name + ".");
}

}  // namespace flg::studio
