// SPDX-License-Identifier: MIT
// Undo and redo by whole states: what differs from the last settled one when nothing is being dragged is a step.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "splines/model.h"

namespace flg::studio::splines {

class History {
public:
    explicit History(Document& document) : document_(document) {}

    bool has_news() const { return !(document_ == settled_); }
    // Takes a step if there is something new; true if there was.
    bool settle() {
        if (document_ == settled_) return false;
        undo_.push_back(std::exchange(settled_, document_));
        redo_.clear();
        if (undo_.size() > kMost) undo_.erase(undo_.begin());
        return true;
    }
    // The document as it is becomes the start: nothing before it can come back.
    void reset() {
        settled_ = document_;
        undo_.clear();
        redo_.clear();
    }
    // To the last settled state, for what was begun and is given up; true if it was another one.
    bool revert() {
        if (document_ == settled_) return false;
        settled_.last_id = std::max(settled_.last_id, document_.last_id);
        document_ = settled_;
        return true;
    }
    void forget_undone() { redo_.clear(); }
    bool can_undo() const { return !undo_.empty(); }
    bool can_redo() const { return !redo_.empty(); }
    void undo() { step(undo_, redo_); }
    void redo() { step(redo_, undo_); }

private:
    static constexpr size_t kMost = 200;

    void step(std::vector<Document>& from, std::vector<Document>& to) {
        if (from.empty()) return;
        to.push_back(std::move(settled_));
        settled_ = std::move(from.back());
        from.pop_back();
        // Numbers are not given twice: what is drawn and made goes by them.
        settled_.last_id = std::max(settled_.last_id, document_.last_id);
        document_ = settled_;
    }

    Document& document_;
    Document settled_;
    std::vector<Document> undo_, redo_;
};

}  // namespace flg::studio::splines
