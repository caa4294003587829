// SPDX-License-Identifier: MIT
// A tangle as hosts hold it: a surface, the tree of its regions, and how they came about.
//
// What lives in this room: the algebra of regions (region_tree.h), the operators that divide them and what these are
// made of (each a task of its own), macros, displacement, history. What does not: meshes, distances and cuts
// (surfaces/), files.
//
// Invariants
// - A triangle's label is its leaf of the tree, at all times a host can see.
// - Each step changes everything it says, or nothing; each can be taken back and made again, to the bit.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <optional>

#include "surfaces/mesh/mesh_edit.h"
#include "surfaces/mesh/mesh_measures.h"
#include "surfaces/surface.h"
#include "tangles/region_tree.h"

namespace flg {

struct StepRecord;

// Whether a step does something: a muted one does nothing, nor does one that can't be made where it stands.
enum class StepState : uint8_t { made, muted, lost };

struct TangleStep {
    explicit TangleStep(Memory* memory) : tree(memory) {}

    std::shared_ptr<StepRecord> record;
    std::optional<MeshEdit> edit;  // none: only the tree changed
    TreeEdit tree;
    bool goes_on = false;  // it is taken back and made again together with the one before it
    StepState state = StepState::made;
    uint32_t identity = 0;        // of all that go on together, through all edits
    std::array<char, 256> why{};  // a sentence, of a lost step or one that has lost some of its regions
};

using TangleSteps = std::pmr::deque<std::shared_ptr<TangleStep>>;

// The other end of a history that was edited: before the edit, or once it was taken back, after it.
struct StepTail {
    StepTail(size_t at, const TangleSteps::allocator_type& allocator) : first(at), steps(allocator) {}

    size_t first;  // step of the tangle in whose place it begins
    TangleSteps steps;
};

class Tangle final : public Product {
public:
    Tangle(std::shared_ptr<Surface> of_surface, Memory* memory)
        : surface(std::move(of_surface)),
          revision(surface->order.revision()),
          tree(memory),
          steps(memory),
          acts(memory) {}

    std::shared_ptr<Surface> surface;
    // Host's thread: the surface's, after the last change that was started for the tangle; the arrays of the history
    // that it was shown last.
    uint32_t revision;
    std::shared_ptr<void> shown_history;

    // Jobs, as the surface's order lets them.
    RegionTree tree;
    MeshFingerprint base;   // of the mesh it began with
    double least_area = 0;  // square metres: what an operator cuts off that is smaller is a speck
    // Those made, then those taken back; while a job makes steps, these behind all others.
    TangleSteps steps;
    size_t made = 0;
    // What undo takes back, one by one: a step (null), or an edit of those before. Those done, then those taken back.
    std::pmr::deque<std::shared_ptr<StepTail>> acts;
    size_t done = 0;
    uint32_t last_identity = 0;
    uint32_t computed = 0;  // operators, displacements and joins, by the last change
};

}  // namespace flg
