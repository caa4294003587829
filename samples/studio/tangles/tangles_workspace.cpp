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

std::unique_ptr<Workspace> make_tangles(AppContext& app) {
    return std::make_unique<TanglesWorkspace>(app);
}

TanglesWorkspace::TanglesWorkspace(AppContext& app)
    : Workspace(app),
      selection_lines_(app.renderer, kSelectionColor, 3.0f),
      hover_lines_(app.renderer, kHoverColor, 2.0f),
      grip_lines_(app.renderer, kGripColor, 4.0f) {}

std::string TanglesWorkspace::help() const {
    if (const Ornament* ornament = trying()) {
        const Recipe& recipe = ornament->live->recipe;
        const SeedChoice& seeds = edits_towards_ ? recipe.towards : recipe.from;
        if (is_operator(recipe.action) && seeds.kind == SeedKind::points)
            return "Click to add points, drag to move them, Delete to remove one. Enter keeps the step, Escape "
                   "discards it.";
        if (is_operator(recipe.action) && seeds.kind == SeedKind::picked)
            return "Click a border or drag along it. Enter keeps the step, Escape discards it.";
        return "Adjust the sliders. Enter keeps the step, Escape discards it.";
    }
    if (paints_) return "Click regions to paint them. Escape ends painting.";
    return "Click a region to select it, then press a button under Divide. Shift-click adds to the selection.";
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
    const SceneMesh* mesh = app_.scene.active();
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
    auto ornament = std::make_unique<Ornament>(app_, mesh, palette_);
    Ornament& made = *ornament;
    ornaments_.emplace(mesh.id, std::move(ornament));
    made.make(owner());
    return made;
}

void TanglesWorkspace::update() {
    std::erase_if(ornaments_, [&](const auto& one) {
        if (app_.scene.kept(one.first) != nullptr) return false;
        undo_steps_.forget_mesh(one.first);
        return true;
    });
    const SceneMesh* mesh = app_.scene.active();
    const bool is_wanted = in_front_ && mesh != nullptr && mesh->ready && find(mesh->id) == nullptr;
    if (is_wanted && !waiting_.contains(mesh->id)) make_ornament(*mesh);
    make_waiting();
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
        if (ornament->wants_try() && ornament->mesh()->ready) try_again(*ornament);
    try_edit();
    if (Ornament* ornament = active(); ornament != nullptr && ornament->idle())
        selected_ = ornament->regions.existing(selected_);
    refresh_highlights();
    take_snapshot();
}

void TanglesWorkspace::make_waiting() {
    // Of a surface that was made anew, what is on the old one is made on the new one.
    for (auto it = ornaments_.begin(); it != ornaments_.end();) {
        Ornament& ornament = *it->second;
        if (ornament.generation() == ornament.mesh()->generation || ornament.running()) {
            ++it;
            continue;
        }
        if (ornament.live) keep();
        if (ornament.running()) return;
        if (ornament.regions.count() > 0) {
            const nlohmann::json json = to_json(ornament);
            if (!json.is_null()) waiting_[it->first] = {json};
        }
        it = ornaments_.erase(it);
    }
    for (auto it = waiting_.begin(); it != waiting_.end();) {
        SceneMesh* mesh = app_.scene.kept(it->first);
        if (mesh == nullptr) {
            it = waiting_.erase(it);
        } else if (mesh->ready && mesh->generation != it->second.failed_generation && find(mesh->id) == nullptr) {
            Waiting waiting = std::move(it->second);
            it = waiting_.erase(it);
            replay(make_ornament(*mesh), std::move(waiting));
        } else {
            ++it;
        }
    }
}

void TanglesWorkspace::refresh_highlights() {
    const Ornament* ornament = active();
    if (!in_front_ || ornament == nullptr || !ornament->mesh()->visible || ornament->mesh()->plays) {
        selection_lines_.clear();
        hover_lines_.clear();
        grip_lines_.clear();
        selection_shown_ = hover_shown_ = {};
        return;
    }
    // What was traced last is shown while a step is under way.
    if (!ornament->idle() || !ornament->mesh()->ready) return;
    const float lift = kLift * ornament->mesh()->box.diagonal();
    const render::Placement& placement = ornament->mesh()->placement;
    const auto refresh = [&](const Regions& regions, Shown& shown, Highlight& lines) {
        const Shown wanted = {ornament->mesh_id(), ornament->revision(), regions, placement};
        if (wanted == shown) return;
        shown = wanted;
        lines.clear();
        if (regions.empty()) return;
        const Outline outline =
            trace_outline(ornament->mesh()->surface.view(), ornament->regions.leaves_below(regions));
        lines.show(outline.loops, lift, placement, app_.scale);
    };
    refresh(selected_, selection_shown_, selection_lines_);
    refresh(hovered_mesh_ == ornament->mesh_id() ? hovered_ : Regions{}, hover_shown_, hover_lines_);
    grip_lines_.clear();
    if (!ornament->live || !is_operator(ornament->live->recipe.action)) return;
    const std::vector<BorderLoop>& loops = ornament->live->before.outline.loops;
    const std::optional<Grip>& grip = dragged_grip_ ? dragged_grip_ : hovered_grip_;
    if (grip && grip->loop < loops.size()) grip_lines_.show({&loops[grip->loop], 1}, lift, placement, app_.scale);
}

void TanglesWorkspace::try_action(Action action) {
    refusal_.clear();
    later([this] { keep(); });
    later([this, action] {
        Ornament* ornament = active();
        if (ornament == nullptr || !ornament->idle())
            throw StudioError("There is no mesh to divide. Add a mesh first.");
        need_visible(*ornament);
        const Regions on = selected_.empty() ? Regions{0} : selected_;
        ornament->begin(action, on);
        const ActionInfo& info = info_of(action);
        const size_t borders = ornament->live->before.outline.loops.size();
        if (borders < info.borders) {
            ornament->live.reset();
            const std::string has = borders == 0 ? "none" : std::to_string(borders);
            refusal_ = std::string(info.name) + " needs a selection with " +
                       (info.borders == 1 ? "a border" : "two borders") + "; this one has " + has +
                       ". Divide the mesh first, with Contour for example, then click a part.";
            return;
        }
        edits_towards_ = false;
        hovered_.clear();
    });
}

void TanglesWorkspace::try_again(Ornament& ornament) {
    if (missing(ornament.live->recipe).empty()) undo_steps_.forget_undone();
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
    if (ornament->live->is_made) did({.kind = UndoStep::Kind::step, .mesh = ornament->mesh_id()});
    UndoStep painted = paint_of_step(*ornament);
    ornament->live.reset();
    do_paint(std::move(painted));
    hovered_point_.reset();
    hovered_grip_.reset();
    dragged_point_.reset();
    dragged_grip_.reset();
    ++app_.changes;
}

void TanglesWorkspace::discard() {
    Ornament* ornament = trying();
    if (ornament == nullptr) return;
    if (ornament->live->is_made) ornament->run("Undoing", ornament->tangle.undo(), owner(), Jobs::Shown::quiet);
    ornament->live.reset();
    hovered_point_.reset();
    hovered_grip_.reset();
    dragged_point_.reset();
    dragged_grip_.reset();
}

void TanglesWorkspace::need_visible(const Ornament& ornament) const {
    if (!ornament.mesh()->visible)
        throw StudioError(ornament.mesh()->name + " is hidden. Show it in the scene's list to divide it.");
}

void TanglesWorkspace::change_regions(const char* name, filigree::Job (*begin)(Ornament&, const Regions&)) {
    later([this] { keep(); });
    later([this, name, begin] {
        Ornament* ornament = active();
        if (ornament == nullptr || selected_.empty()) throw StudioError("Select regions of the mesh first.");
        need_visible(*ornament);
        undo_steps_.forget_undone();
        ornament->run(name, begin(*ornament, selected_), owner(), Jobs::Shown::listed,
                      [this, mesh = ornament->mesh_id()](const FlgJobStatus& status) {
                          if (status.result == FLG_OK) did({.kind = UndoStep::Kind::step, .mesh = mesh});
                      });
    });
}

void TanglesWorkspace::paint(uint32_t material, Regions on) {
    later([this] { keep(); });
    later([this, material, on = std::move(on)] {
        Ornament* ornament = active();
        if (ornament == nullptr) return;
        do_paint(paint_of(*ornament, material, on));
    });
}

UndoStep TanglesWorkspace::paint_of(const Ornament& ornament, uint32_t material, const Regions& on) const {
    UndoStep step{.kind = UndoStep::Kind::paint, .mesh = ornament.mesh_id()};
    Regions seen;
    for (const uint32_t leaf : ornament.regions.leaves_below(on)) seen.push_back(seen_region(ornament.regions, leaf));
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    for (const uint32_t region : seen) {
        const auto painted = ornament.paints.find(region);
        const auto before = painted == ornament.paints.end() ? std::nullopt : std::optional<uint32_t>(painted->second);
        if (before != material) step.paints.push_back({region, before, material});
    }
    return step;
}

UndoStep TanglesWorkspace::paint_of_step(const Ornament& ornament) const {
    const LiveStep& live = *ornament.live;
    if (!live.is_made || !live.material) return {.kind = UndoStep::Kind::paint};
    return paint_of(ornament, *live.material, ornament.new_parts());
}

void TanglesWorkspace::do_paint(UndoStep step) {
    if (step.paints.empty()) return;
    apply(step, true);
    did(std::move(step));
}

void TanglesWorkspace::choose_material(uint32_t material) {
    material_ = material;
    if (Ornament* ornament = trying()) {
        ornament->live->material = material;
        if (ornament->idle()) ornament->recolor();
        ++app_.changes;
    } else if (!selected_.empty()) {
        paint(material, selected_);
    } else {
        paints_ = true;
    }
}

void TanglesWorkspace::did(UndoStep step) {
    undo_steps_.push(std::move(step));
    app_.timeline.push(*this);
}

void TanglesWorkspace::apply(const UndoStep& step, bool forward) {
    ++app_.changes;
    if (step.kind == UndoStep::Kind::palette) {
        palette_ = forward ? step.after : step.before;
        recolor_all();
        return;
    }
    Ornament* ornament = find(step.mesh);
    if (ornament == nullptr) return;
    if (step.kind == UndoStep::Kind::paint) {
        for (const PaintChange& change : step.paints) {
            const std::optional<uint32_t>& now = forward ? change.after : change.before;
            if (now)
                ornament->paints.insert_or_assign(change.region, *now);
            else
                ornament->paints.erase(change.region);
        }
        ornament->recolor();
        return;
    }
    step_edit_.reset();
    for (uint32_t i = 1; i < step.times; ++i)
        ornament->run("Undoing", forward ? ornament->tangle.redo() : ornament->tangle.undo(), owner(),
                      Jobs::Shown::quiet);
    ornament->run(forward ? "Redoing" : "Undoing", forward ? ornament->tangle.redo() : ornament->tangle.undo(), owner(),
                  Jobs::Shown::listed,
                  [this, forward, mesh = step.mesh, other = step.other_paints](const FlgJobStatus& status) {
                      if (Ornament* done = find(mesh); status.result == FLG_OK && other && done != nullptr)
                          std::swap(done->paints, *other);
                      if (status.result == FLG_OK) return;
                      forward ? undo_steps_.undo() : undo_steps_.redo();
                      app_.timeline.not_done(*this, forward);
                  });
}

void TanglesWorkspace::recolor_all() {
    for (const auto& [id, ornament] : ornaments_) ornament->recolor();
}

void TanglesWorkspace::settle() {
    if (trying() != nullptr && commands_.empty()) later([this] { keep(); });
}

void TanglesWorkspace::undo() {
    later([this] { apply(undo_steps_.undo(), false); });
}

void TanglesWorkspace::redo() {
    later([this] { apply(undo_steps_.redo(), true); });
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
    static constexpr Shortcut kKeys[] = {{"Click", "Select; Shift adds, Ctrl selects one region"},
                                         {"Ctrl+A", "Select all regions"},
                                         {"U", "Select the parents of the selected regions"},
                                         {"R, G, A", "Clicks select a region, its group, its colour"},
                                         {"B", "Paint with clicks"},
                                         {"Enter", "Keep the current step"},
                                         {"Escape", "Discard the step, or clear the selection"},
                                         {"Delete", "Remove a point"}};
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
    if (name == "acts") return static_cast<double>(undo_steps_.done());
    if (name == "undone") return static_cast<double>(undo_steps_.count() - undo_steps_.done());
    if (name == "trying") return trying() != nullptr ? 1.0 : 0.0;
    if (name == "regions") return ornament != nullptr ? ornament->regions.count() : 0.0;
    if (name == "leaves") return ornament != nullptr ? static_cast<double>(ornament->regions.leaves().size()) : 0.0;
    const auto count_steps = [&](FlgTangleStepState state) {
        if (ornament == nullptr) return 0.0;
        return static_cast<double>(std::count_if(ornament->steps.begin(), ornament->steps.end(),
                                                 [state](const HistoryStep& step) { return step.state == state; }));
    };
    if (name == "steps") return ornament != nullptr ? static_cast<double>(ornament->steps.size()) : 0.0;
    if (name == "muted") return count_steps(FLG_TANGLE_STEP_STATE_MUTED);
    if (name == "lost") return count_steps(FLG_TANGLE_STEP_STATE_LOST);
    if (name == "painted") return ornament != nullptr ? static_cast<double>(ornament->paints.size()) : 0.0;
    if (name == "unpainted")
        return ornament != nullptr ? static_cast<double>(ornament->regions.leaves().size()) -
                                         static_cast<double>(ornament->paints.size())
                                   : 0.0;
    if (name == "groups") {
        std::vector<uint32_t> groups;
        if (ornament != nullptr)
            for (const uint32_t leaf : ornament->regions.leaves()) groups.push_back(ornament->regions[leaf].group);
        std::sort(groups.begin(), groups.end());
        return static_cast<double>(std::unique(groups.begin(), groups.end()) - groups.begin());
    }
    throw StudioError("tangles has no value named " + name + ".");
}

}  // namespace flg::studio
