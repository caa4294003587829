// SPDX-License-Identifier: MIT
// What was done, in order, over all meshes: steps of tangles, which the SDK remembers, and paint, which is remembered here.
#pragma once

#include <optional>

#include "tangles/coloring.h"

namespace flg::studio {

struct PaintChange {
    uint32_t region;
    std::optional<uint32_t> before, after;  // places in the palette; none: as what is around it
};

struct Act {
    enum class Kind { step, paint, palette };
    Kind kind = Kind::step;
    uint32_t mesh = 0;  // 0: of a palette
    std::vector<PaintChange> paints{};
    Palette before{}, after{};
};

class Acts {
public:
    void push(Act act);
    // A new step makes those that were taken back impossible.
    void forget_undone() { acts_.resize(done_); }
    void forget_mesh(uint32_t mesh);
    void clear() { *this = {}; }

    bool can_undo() const { return done_ > 0; }
    bool can_redo() const { return done_ < acts_.size(); }
    // The one that is now to be taken back, or made again.
    const Act& undo() { return acts_[--done_]; }
    const Act& redo() { return acts_[done_++]; }
    size_t done() const { return done_; }
    size_t count() const { return acts_.size(); }

    // Meshes are numbers from `number_of`; acts on others, which are gone, are left out.
    nlohmann::json to_json(const std::map<uint32_t, size_t>& number_of) const;
    // `mesh_of`: their identifiers now. Throws nlohmann's exceptions and StudioError.
    static Acts from_json(const nlohmann::json& json, const std::vector<uint32_t>& mesh_of);

private:
    std::vector<Act> acts_;
    size_t done_ = 0;
};

}  // namespace flg::studio
