// SPDX-License-Identifier: MIT
#include "shell/timeline.h"

#include <algorithm>
#include <utility>

namespace flg::studio {

void Timeline::push(UndoSource& source) {
    for (const Step& step : std::exchange(undone_, {}))
        if (step.source != &source) step.source->forget_undone();
    const SceneMesh* active = scene_.active();
    const uint32_t after = active != nullptr ? active->id : 0;
    done_.push_back({&source, std::exchange(active_, after), after});
}

void Timeline::not_done(UndoSource& source, bool was_redo) {
    std::vector<Step>&from = was_redo ? done_ : undone_, &to = was_redo ? undone_ : done_;
    if (from.empty() || from.back().source != &source) return;
    to.push_back(from.back());
    from.pop_back();
}

void Timeline::reset() {
    done_.clear();
    undone_.clear();
    asked_.clear();
    const SceneMesh* active = scene_.active();
    active_ = active != nullptr ? active->id : 0;
}

void Timeline::adopt(UndoSource& source, size_t steps) {
    for (size_t i = 0; i < steps; ++i) done_.push_back({&source, active_, active_});
}

void Timeline::undo(UndoSource& front) {
    if (asked_.empty() && front.give_up()) return;
    asked_.push_back(false);
}

void Timeline::redo() {
    asked_.push_back(true);
}

void Timeline::update(std::span<UndoSource* const> sources) {
    while (!asked_.empty()) {
        for (UndoSource* source : sources) source->settle();
        if (!std::all_of(sources.begin(), sources.end(), [](const UndoSource* source) { return source->is_settled(); }))
            return;
        if (std::exchange(asked_.front(), false))
            redo_last();
        else
            undo_last();
        if (!asked_.empty()) asked_.pop_front();
    }
}

void Timeline::undo_last() {
    while (!done_.empty()) {
        const Step step = done_.back();
        done_.pop_back();
        // Its oldest steps a source may have forgotten.
        if (!step.source->can_undo()) continue;
        undone_.push_back(step);
        step.source->undo();
        scene_.set_active(step.before);
        active_ = step.before;
        if (show) show(*step.source);
        return;
    }
}

void Timeline::redo_last() {
    while (!undone_.empty()) {
        const Step step = undone_.back();
        undone_.pop_back();
        if (!step.source->can_redo()) continue;
        done_.push_back(step);
        step.source->redo();
        scene_.set_active(step.after);
        active_ = step.after;
        if (show) show(*step.source);
        return;
    }
}

}  // namespace flg::studio
