// SPDX-License-Identifier: MIT
// The drawing that is being worked on: what is selected, acts with undo, and what jobs make of it. Tools and panel
// change it here and nowhere else.
#pragma once

#include <functional>

#include "shell/workspace.h"
#include "skeletons/contour_jobs.h"
#include "skeletons/history.h"
#include "skeletons/live_model.h"

namespace flg::studio {

enum class MirrorAs { single, left_right, front_back };

class Editor {
public:
    explicit Editor(AppContext& of) : app(of), live(of.context, of.jobs, of.notices), contours(of.context, of.jobs) {}

    AppContext& app;
    LiveModel live;
    ContourJobs contours;
    // What the next part is made with.
    DrawnPart brush;
    MirrorAs brush_mirror = MirrorAs::single;

    const Drawing& drawing() const { return now_.drawing; }
    // For writing: begins an act, or goes on with the one of this name.
    Drawing& change(const char* act);
    // The act ends: a step of undo.
    void commit();
    // Called with each step that is made.
    std::function<void()> did;
    // The act has not been.
    void cancel();
    bool is_acting() const { return history_.is_acting(); }
    // Rises with all that is changed or selected.
    uint64_t revision() const { return revision_; }

    uint32_t selected_id() const { return now_.selected; }
    const DrawnPart* selected() const { return now_.drawing.find(now_.selected); }
    void select(uint32_t id);
    // The part being changed; there must be a selected one.
    DrawnPart& change_selected(const char* act) { return *change(act).find(now_.selected); }

    // With a number of its own, a free name, selected; a whole act. The mirror is the drawing's: all mirrored parts
    // have one.
    void add(std::vector<DrawnPart> parts, MirrorAs as);
    void remove_selected();
    void duplicate_selected();
    // Earlier (-1) or later (1) in the list.
    void shift_selected(int by);
    void repair(uint32_t id);
    // The silhouette of the scene's active mesh becomes a part.
    void trace_mesh();
    void set_mirror(MirrorAs as);
    MirrorAs mirror_of(const DrawnPart& part) const;

    bool can_undo() const { return history_.can_undo(); }
    bool can_redo() const { return history_.can_redo(); }
    void undo();
    void redo();
    void forget_undone() { history_.forget_undone(); }
    // Another drawing in place of all there is; `drawing`'s parts get numbers.
    void replace(Drawing drawing);
    // The same as an act, for files that are opened.
    void open(Drawing drawing);

private:
    struct State {
        Drawing drawing;
        uint32_t selected = 0;
    };
    void number(Drawing& drawing);
    void set_plane(Drawing& drawing, MirrorAs as);
    void restore(State state);

    State now_;
    History<State> history_;
    uint32_t last_id_ = 0;
    uint64_t revision_ = 1;
};

}  // namespace flg::studio
