// SPDX-License-Identifier: MIT
// The steps of an ornament as a stack: one is chosen to change its numbers, to mute, move or delete it.
#include <imgui.h>

#include <algorithm>

#include "shell/widgets.h"
#include "tangles/tangles_workspace.h"

namespace flg::studio {
namespace {

std::optional<uint32_t> stays(uint32_t step, uint32_t, uint32_t) {
    return step;
}

std::optional<uint32_t> is_deleted(uint32_t step, uint32_t edited, uint32_t) {
    if (step == edited) return std::nullopt;
    return step > edited ? step - 1 : step;
}

std::optional<uint32_t> is_moved(uint32_t step, uint32_t edited, uint32_t to) {
    if (step == edited) return to;
    if (step > edited && step <= to) return step - 1;
    if (step < edited && step >= to) return step + 1;
    return step;
}

const char* suffix(FlgTangleStepState state) {
    if (state == FLG_TANGLE_STEP_STATE_MUTED) return " (muted)";
    return state == FLG_TANGLE_STEP_STATE_LOST ? " (lost)" : "";
}

}  // namespace

// Once nothing else is under way. `begin` starts it.
void TanglesWorkspace::edit_history(const char* name, uint32_t to, EditKind kind) {
    later([this] { keep(); });
    later([this, name, to, kind] {
        Ornament* ornament = active();
        if (ornament == nullptr || !step_edit_ || step_edit_->step >= ornament->steps.size()) return;
        const uint32_t step = step_edit_->step;
        const bool muted = ornament->steps[step].state == FLG_TANGLE_STEP_STATE_MUTED;
        filigree::Job job;
        switch (kind) {
            case EditKind::mute: job = ornament->tangle.mute_step(step, muted ? 0 : 1); break;
            case EditKind::move: job = ornament->tangle.move_step(step, to); break;
            case EditKind::remove: job = ornament->tangle.remove_step(step); break;
        }
        const auto moved = kind == EditKind::mute ? &stays : kind == EditKind::move ? &is_moved : &is_deleted;
        run_edit(*ornament, name, std::move(job), moved, to, false);
        if (kind == EditKind::move) step_edit_->step = to;
        if (kind == EditKind::remove) step_edit_.reset();
    });
}

void TanglesWorkspace::run_edit(Ornament& ornament, const char* name, filigree::Job job, Ornament::Moved moved,
                                uint32_t to, bool goes_on) {
    undo_steps_.forget_undone();
    const auto before = std::make_shared<Paints>(ornament.paints);
    ornament.carry_paints(moved, step_edit_->step, to);
    ornament.run(name, std::move(job), owner(), Jobs::Shown::listed,
                 [this, before, goes_on, mesh = ornament.mesh_id()](const FlgJobStatus& status) {
                     Ornament* edited = find(mesh);
                     if (status.result != FLG_OK) {
                         if (edited != nullptr) edited->forget_carried();
                         if (step_edit_) step_edit_->error = status.error;
                         return;
                     }
                     if (goes_on && undo_steps_.extend_edit(mesh)) return;
                     did({.kind = UndoStep::Kind::step, .mesh = mesh, .other_paints = before});
                 });
}

// While a slider is dragged each of its values is tried, as soon as the one before is done.
void TanglesWorkspace::try_edit() {
    Ornament* ornament = active();
    if (!step_edit_ || ornament == nullptr || !ornament->idle() || ornament->live || !commands_.empty()) return;
    StepEdit& edit = *step_edit_;
    if (edit.step >= ornament->steps.size() || edit.mesh != ornament->mesh_id()) {
        step_edit_.reset();
        return;
    }
    if (edit.now == edit.tried) return;
    const bool goes_on = edit.tries++ > 0;
    edit.tried = edit.now;
    edit.error.clear();
    run_edit(*ornament, "Changing a step", change_step(ornament->tangle, edit.step, edit.now), &stays, 0, goes_on);
}

void TanglesWorkspace::draw_history(Ornament& ornament) {
    if (ornament.steps.empty() || !ui::section("Steps", false)) return;
    for (uint32_t i = 0; i < ornament.steps.size(); ++i) {
        const HistoryStep& step = ornament.steps[i];
        const bool chosen = step_edit_ && step_edit_->step == i;
        const std::string label =
            std::to_string(i + 1) + ". " + step.name + suffix(step.state) + "##step " + std::to_string(i + 1);
        if (ui::selectable(label.c_str(), chosen, step.why.empty() ? nullptr : step.why.c_str())) {
            if (ornament.live) later([this] { keep(); });
            step_edit_ = {ornament.mesh_id(), i, step.numbers, step.numbers, step.numbers};
        }
        ui::mark_last("step " + std::to_string(i + 1));
    }
    if (step_edit_ && step_edit_->step < ornament.steps.size()) draw_step_edit(ornament);
}

void TanglesWorkspace::draw_step_edit(const Ornament& ornament) {
    StepEdit& edit = *step_edit_;
    const HistoryStep& step = ornament.steps[edit.step];
    const uint32_t last = static_cast<uint32_t>(ornament.steps.size()) - 1;
    const bool muted = step.state == FLG_TANGLE_STEP_STATE_MUTED;
    if (ui::row_button("Mute", 4, "Leaves the step out, until it is pressed again.", {.pressed = muted}))
        edit_history("Muting", 0, EditKind::mute);
    ui::same_row();
    if (ui::row_button("Earlier", 4, "Moves the step before the one above.", {.enabled = edit.step > 0}))
        edit_history("Moving", edit.step - 1, EditKind::move);
    ui::same_row();
    if (ui::row_button("Later", 4, "Moves the step behind the one below.", {.enabled = edit.step < last}))
        edit_history("Moving", edit.step + 1, EditKind::move);
    ui::same_row();
    if (ui::row_button("Delete##step", 4, "Deletes the step.")) edit_history("Deleting", 0, EditKind::remove);
    const std::string& said = edit.error.empty() ? step.why : edit.error;
    if (!said.empty()) ui::hint(said.c_str());
    StepNumbers& n = edit.now;
    const StepNumbers& first = edit.first;
    const auto metres = [](const char* label, float* value, float middle, const char* tip) {
        ui::length(label, value, 0.2f * middle, 5.0f * middle, tip, true);
    };
    const bool divides = step.kind == FLG_TANGLE_STEP_KIND_DIVIDE, is_macro = step.kind == FLG_TANGLE_STEP_KIND_MACRO;
    if (divides && step.which == FLG_TANGLE_OPERATOR_CONTOUR && step.blends)
        ui::slider("Step share", &n.delta, 0.02f, 0.9f, "%.2f", "Width of a band, as a share of the way.");
    else if (divides && step.which <= FLG_TANGLE_OPERATOR_STREAM)
        metres("Step width", &n.delta, first.delta, "Width of the bands or stripes of this step.");
    if (divides && step.which == FLG_TANGLE_OPERATOR_CONTOUR)
        ui::slider("Step lines", &n.count, 0, 40, "%d", "Most lines. 0 cuts as many as there is room for.");
    if (is_macro) {
        metres("Step size", &n.size, first.size, "Size of what this step makes.");
        metres("Step spacing", &n.spacing, first.spacing, "Distance between what this step scatters.");
        ui::slider("Step count", &n.count, 1, 40, "%d", "Frames, petals or rows.");
    }
    if (divides || is_macro) ui::slider("Step seed", &n.seed, 1, 99, "%d", "Number of the random choice.");
    if (step.kind != FLG_TANGLE_STEP_KIND_DISPLACE) return;
    const float most = std::max(4.0f * std::abs(first.amount), 1e-4f);
    ui::length("Step height", &n.amount, -most, most, "Height of the middle above the borders.");
    ui::slider("Step bias", &n.bias, 0.05f, 0.95f, "%.2f", "Below 0.5 makes spikes, above 0.5 makes domes.");
    ui::slider("Step gain", &n.gain, 0.05f, 0.95f, "%.2f", "Below 0.5 is steep at half height.");
}

}  // namespace flg::studio
