// SPDX-License-Identifier: MIT
// The one history. Workspaces and the scene keep their own steps, each as it suits them; here is the order in which
// they were done, over all of them, so that Ctrl+Z takes back what was done last, wherever that was.
#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "scene/scene.h"

namespace flg::studio {

// Who has steps of its own. It tells the timeline of each that it makes.
class UndoSource {
public:
    virtual ~UndoSource() = default;

    virtual bool can_undo() const = 0;
    virtual bool can_redo() const = 0;
    virtual void undo() = 0;
    virtual void redo() = 0;
    // What was taken back can't be made again: something else was done.
    virtual void forget_undone() = 0;
    // What is in hand is let go of as if it had not been begun: true if there was something.
    virtual bool give_up() { return false; }
    // What is under way becomes a step, or nothing; it may take until is_settled().
    virtual void settle() {}
    virtual bool is_settled() const { return true; }
};

class Timeline {
public:
    explicit Timeline(Scene& scene) : scene_(scene) {}

    // Of `source`, which has just made a step.
    void push(UndoSource& source);
    // The step that `source` was to take back (or make again) could not be: it stays as it was.
    void not_done(UndoSource& source, bool was_redo);
    // Nothing before can come back. `steps`: of one source, which it brought along.
    void reset();
    void adopt(UndoSource& source, size_t steps);

    // What `front` has in hand is let go of; else the last step is taken back, once all are settled.
    void undo(UndoSource& front);
    void redo();
    bool can_undo() const { return !done_.empty(); }
    bool can_redo() const { return !undone_.empty(); }
    size_t done() const { return done_.size(); }
    size_t undone() const { return undone_.size(); }
    // Once a frame, with all who have steps.
    void update(std::span<UndoSource* const> sources);
    bool busy() const { return !asked_.empty(); }

    // Called with whose step was taken back or made again.
    std::function<void(UndoSource&)> show;

private:
    // The scene's active meshes before and after the step.
    struct Step {
        UndoSource* source;
        uint32_t before, after;
    };
    void undo_last();
    void redo_last();

    Scene& scene_;
    std::vector<Step> done_, undone_;
    std::deque<bool> asked_;  // true: a redo
    uint32_t active_ = 0;     // when the last step was done
};

}  // namespace flg::studio
