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

#include <deque>
#include <memory>
#include <optional>

#include "surfaces/mesh/mesh_edit.h"
#include "surfaces/mesh/mesh_measures.h"
#include "surfaces/surface.h"
#include "tangles/region_tree.h"

namespace flg {

struct StepRecord;

struct TangleStep {
    explicit TangleStep(Memory* memory) : tree(memory) {}

    std::shared_ptr<StepRecord> record;
    std::optional<MeshEdit> edit;  // none: only the tree changed
    TreeEdit tree;
    bool goes_on = false;  // it is taken back and made again together with the one before it
};

class Tangle final : public Product {
public:
    Tangle(std::shared_ptr<Surface> of_surface, Memory* memory)
        : surface(std::move(of_surface)), revision(surface->order.revision()), tree(memory), steps(memory) {}

    std::shared_ptr<Surface> surface;
    // Host's thread: the surface's, after the last change that was started for the tangle; the arrays of the history
    // that it was shown last.
    uint32_t revision;
    std::shared_ptr<void> shown_history;

    // Jobs, as the surface's order lets them.
    RegionTree tree;
    MeshFingerprint base;  // of the mesh it began with
    // Those made, then those taken back; while a job makes steps, these behind all others.
    std::pmr::deque<std::shared_ptr<TangleStep>> steps;
    size_t made = 0;
};

}  // namespace flg
