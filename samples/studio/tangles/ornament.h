// SPDX-License-Identifier: MIT
// The tangle of one mesh of the scene: its regions, what they are painted with, and the step that is being tried out.
// Its jobs run one after the other; what is here stays as after the last one until all are done.
#pragma once

#include <functional>
#include <optional>

#include "shell/workspace.h"
#include "tangles/coloring.h"
#include "tangles/history_list.h"
#include "tangles/recipe.h"

namespace flg::studio {

// A copy of the mesh as it was before a step: seeds are places on it, whatever the step has made of the mesh since.
struct MeshBefore {
    std::vector<glm::vec3> positions;
    std::vector<uint32_t> triangles;  // of the step's regions: 3 vertices each
    std::vector<uint32_t> numbers;    // and their numbers
    Outline outline;

    // The nearest place within the step's regions, if it is no farther away than `reach`.
    std::optional<SeedPoint> nearest(const glm::vec3& place, float reach) const;
};

struct LiveStep {
    Recipe recipe;
    Recipe first;                 // as it was proposed: what sliders are about
    std::optional<Recipe> tried;  // last
    bool is_made = false;         // it is the tangle's last step
    uint32_t undo_count = 0;      // of the tangle without it
    std::string error;            // of the last try
    uint32_t region_count = 0;    // of the tangle without it
    // A place in the palette, for what it makes; none: as operators colour it.
    std::optional<uint32_t> material;
    MeshBefore before;
};

class Ornament {
public:
    // The palette outlives it.
    Ornament(AppContext& app, const SceneMesh& mesh, const Palette& palette);

    uint32_t mesh_id() const { return mesh_id_; }
    // Of the mesh's surface, that it was made on.
    uint32_t generation() const { return generation_; }
    SceneMesh* mesh() const { return app_.scene.kept(mesh_id_); }
    // No job is under way, and the tangle is there.
    bool idle() const { return running_ == 0 && regions.count() > 0; }
    bool running() const { return running_ > 0; }
    bool failed() const { return failed_; }
    // Counts what was made of it.
    uint32_t revision() const { return revision_; }

    using Then = std::function<void(const FlgJobStatus&)>;
    // `owner` finds this ornament when the job is done, which may be gone by then.
    using Owner = std::function<Ornament*(uint32_t mesh_id)>;
    void run(const std::string& name, filigree::Job job, const Owner& owner, Jobs::Shown shown, Then then = {});
    void make(const Owner& owner);

    // The next job edits the history: paints follow their regions.
    using Moved = std::optional<uint32_t> (*)(uint32_t step, uint32_t edited, uint32_t to);
    void carry_paints(Moved moved, uint32_t edited, uint32_t to);
    void forget_carried() { carried_.reset(); }

    // What the step that is tried has made and that looks other than what it lies in; all that it raises.
    Regions new_parts() const;

    // Begins to try a step on regions; the surface must be idle.
    void begin(Action action, const Regions& on);
    // Takes the step back that was tried last, and makes it as the recipe now is. Idle only.
    void try_again(const Owner& owner);
    bool wants_try() const;

    // After all that may change colours; shows it.
    void recolor();
    // With those of the step that is tried.
    Paints shown_paints() const;
    // Nothing was divided or painted: the mesh shows its own colour.
    bool is_bare() const { return !shown_paints().contains(0) && regions.leaves() == Regions{0}; }
    uint32_t material_of(uint32_t region) const { return region < materials_.size() ? materials_[region] : 0; }
    // Places in the palette, by label.
    const std::vector<uint32_t>& materials() const { return materials_; }

    filigree::Tangle tangle;
    RegionList regions;
    std::vector<HistoryStep> steps;
    Paints paints;
    std::optional<LiveStep> live;
    bool shows_scaffolds = false;

private:
    void finished();

    AppContext& app_;
    const Palette& palette_;
    const uint32_t mesh_id_, generation_;
    int running_ = 0;
    uint32_t revision_ = 0;
    bool failed_ = false;
    struct Carrying {
        CarriedPaints paints;
        Moved moved;
        uint32_t edited, to;
    };
    std::optional<Carrying> carried_;
    std::vector<uint32_t> materials_;
};

}  // namespace flg::studio
