// SPDX-License-Identifier: MIT
#include "tangles/undo_steps.h"

#include <algorithm>
#include <utility>

#include "shell/studio_error.h"

namespace flg::studio {
namespace {

nlohmann::json color_json(const std::optional<uint32_t>& color) {
    return color ? nlohmann::json(*color) : nlohmann::json();
}

std::optional<uint32_t> color_from(const nlohmann::json& json) {
    if (json.is_null()) return std::nullopt;
    return json.get<uint32_t>();
}

}  // namespace

void UndoSteps::push(UndoStep step) {
    forget_undone();
    undo_steps_.push_back(std::move(step));
    ++done_;
}

bool UndoSteps::extend_edit(uint32_t mesh) {
    if (done_ == 0 || done_ != undo_steps_.size()) return false;
    UndoStep& last = undo_steps_.back();
    if (last.mesh != mesh || !last.other_paints) return false;
    ++last.times;
    return true;
}

void UndoSteps::count_anew(uint32_t mesh, uint32_t steps) {
    const auto is_edit = [mesh](const UndoStep& step) { return step.mesh == mesh && step.other_paints; };
    if (std::none_of(undo_steps_.begin(), undo_steps_.end(), is_edit)) return;
    forget_undone();
    forget_mesh(mesh);
    undo_steps_.insert(undo_steps_.begin(), steps, {.kind = UndoStep::Kind::step, .mesh = mesh});
    done_ = undo_steps_.size();
}

size_t UndoSteps::forget_mesh(uint32_t mesh) {
    size_t kept = 0, done = 0;
    for (size_t i = 0; i < undo_steps_.size(); ++i) {
        if (undo_steps_[i].mesh == mesh) continue;
        if (i < done_) ++done;
        if (kept != i) undo_steps_[kept] = std::move(undo_steps_[i]);
        ++kept;
    }
    undo_steps_.resize(kept);
    return std::exchange(done_, done) - done;
}

nlohmann::json UndoSteps::to_json(const std::map<uint32_t, size_t>& number_of) const {
    nlohmann::json list = nlohmann::json::array();
    for (size_t i = 0; i < done_; ++i) {
        const UndoStep& step = undo_steps_[i];
        if (step.kind != UndoStep::Kind::palette && !number_of.contains(step.mesh)) continue;
        switch (step.kind) {
            case UndoStep::Kind::step: list.push_back({{"step", number_of.at(step.mesh)}}); break;
            case UndoStep::Kind::paint: {
                nlohmann::json paints = nlohmann::json::array();
                for (const PaintChange& p : step.paints)
                    paints.push_back({p.region, color_json(p.before), color_json(p.after)});
                list.push_back({{"paint", number_of.at(step.mesh)}, {"regions", std::move(paints)}});
                break;
            }
            case UndoStep::Kind::palette:
                list.push_back({{"palette", {studio::to_json(step.before), studio::to_json(step.after)}}});
                break;
        }
    }
    const size_t done = list.size();
    return {{"list", std::move(list)}, {"done", done}};
}

UndoSteps UndoSteps::from_json(const nlohmann::json& json, const std::vector<uint32_t>& mesh_of) {
    UndoSteps acts;
    for (const nlohmann::json& entry : json.at("list")) {
        UndoStep step;
        if (entry.contains("palette")) {
            step.kind = UndoStep::Kind::palette;
            step.before = palette_from_json(entry.at("palette").at(0));
            step.after = palette_from_json(entry.at("palette").at(1));
        } else if (entry.contains("paint")) {
            step.kind = UndoStep::Kind::paint;
            step.mesh = mesh_of.at(entry.at("paint").get<size_t>());
            for (const nlohmann::json& p : entry.at("regions"))
                step.paints.push_back({p.at(0).get<uint32_t>(), color_from(p.at(1)), color_from(p.at(2))});
        } else {
            step.mesh = mesh_of.at(entry.at("step").get<size_t>());
        }
        acts.undo_steps_.push_back(std::move(step));
    }
    acts.done_ = json.at("done").get<size_t>();
    if (acts.done_ > acts.undo_steps_.size())
        throw StudioError("The history of the ornament in the document is incomplete.");
    return acts;
}

}  // namespace flg::studio
