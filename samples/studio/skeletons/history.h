// SPDX-License-Identifier: MIT
// Undo by keeping what there was before each act.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace flg::studio {

template <class State>
class History {
public:
    // An act begins: what is done until commit() is one step. Acts of the same name that were not committed go on;
    // another name commits the one before. Returns whether it did.
    bool begin(const State& state, const std::string& act) {
        if (before_ && act == act_) return false;
        const bool was_act = commit();
        before_ = state;
        act_ = act;
        return was_act;
    }
    // Whether there was an act.
    bool commit() {
        if (!before_) return false;
        if (undo_.size() == kMost) undo_.pop_front();
        undo_.push_back(std::move(*before_));
        before_.reset();
        redo_.clear();
        return true;
    }
    bool is_acting() const { return before_.has_value(); }
    // What there was before the act that is not committed, which then has not been.
    std::optional<State> cancel() { return std::exchange(before_, std::nullopt); }
    bool can_undo() const { return before_ || !undo_.empty(); }
    bool can_redo() const { return !before_ && !redo_.empty(); }
    // Given what there is, what there was.
    State undo(State now) {
        State then = std::move(undo_.back());
        undo_.pop_back();
        redo_.push_back(std::move(now));
        return then;
    }
    State redo(State now) {
        State then = std::move(redo_.back());
        redo_.pop_back();
        undo_.push_back(std::move(now));
        return then;
    }
    void clear() { *this = {}; }
    void forget_undone() { redo_.clear(); }

private:
    static constexpr size_t kMost = 500;
    std::deque<State> undo_;
    std::vector<State> redo_;
    std::optional<State> before_;
    std::string act_;
};

}  // namespace flg::studio
