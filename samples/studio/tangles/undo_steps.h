// SPDX-License-Identifier: MIT
// What was done, in order, over all meshes: steps of tangles, which the SDK remembers, and paint, which is remembered
// here.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "tangles/coloring.h"

namespace flg::studio {

struct PaintChange {
    uint32_t region;
    std::optional<uint32_t> before, after;  // places in the palette; none: as what is around it
};

struct UndoStep {
    enum class Kind { step, paint, palette };
    Kind kind = Kind::step;
    uint32_t mesh = 0;  // 0: of a palette
    // Of an edit of the history: the mesh's paints on the other side of it, and how many edits it is.
    std::shared_ptr<std::map<uint32_t, uint32_t>> other_paints{};
    uint32_t times = 1;
    std::vector<PaintChange> paints{};
    Palette before{}, after{};
};

class UndoSteps {
public:
    void push(UndoStep step);
    // A new step makes those that were taken back impossible.
    void forget_undone() { undo_steps_.resize(done_); }
    // The last step becomes one edit more, if it is an edit of the mesh's history; else false.
    bool extend_edit(uint32_t mesh);
    // What was done to a mesh whose history was edited becomes as many steps as that has now.
    void count_anew(uint32_t mesh, uint32_t steps);
    // Returns how many were of it and done.
    size_t forget_mesh(uint32_t mesh);

    bool can_undo() const { return done_ > 0; }
    bool can_redo() const { return done_ < undo_steps_.size(); }
    // The one that is now to be taken back, or made again.
    const UndoStep& undo() { return undo_steps_[--done_]; }
    const UndoStep& redo() { return undo_steps_[done_++]; }
    size_t done() const { return done_; }
    size_t count() const { return undo_steps_.size(); }

    // What is done, not what was taken back. Meshes are numbers from `number_of`; acts on others, which are gone, are
    // left out.
    nlohmann::json to_json(const std::map<uint32_t, size_t>& number_of) const;
    // `mesh_of`: their identifiers now. Throws nlohmann's exceptions and StudioError.
    static UndoSteps from_json(const nlohmann::json& json, const std::vector<uint32_t>& mesh_of);

private:
    std::vector<UndoStep> undo_steps_;
    size_t done_ = 0;
};

}  // namespace flg::studio
