// SPDX-License-Identifier: MIT
// The algebra of tangles: appendix A of Nazzaro, Puppo, Pellacini: geoTangle (2021). A tree of regions, the whole
// surface its root; the children of a region are a partition of it. It knows nothing of meshes.
//
// Invariants
// - A region's identifier is its place in the tree. It is also the label of its triangles as long as it is a leaf.
// - A region is split once: its children stand one behind the other.
// - Regions that were joined have the identifier of the lowest of them. Where they were in the tree they still are, as
//   other names for it; so it belongs to the subtrees of all their parents.
//
// Beyond the appendix: what a region looks like is told apart from where it is. A scaffold's regions look like the
// region they lie in; parts of several leaves that an operator put into one part look the same if these leaves did.
// Borders show where looks differ.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "core/memory.h"

namespace flg {

using RegionId = uint32_t;
constexpr RegionId no_region = UINT32_MAX;

struct RegionNode {
    RegionId parent = no_region;
    uint32_t group = 0;
    uint32_t look = 0;
    uint32_t operation = 0;  // that made it, counted from 1; the root: 0
    uint32_t part = 0;       // of that operation's partition
    RegionId first_child = 0;
    uint32_t child_count = 0;
    RegionId joined_into = no_region;
    bool scaffold = false;
};

// One step of a tree's history.
class TreeEdit {
public:
    explicit TreeEdit(Memory* memory) : nodes_(memory), added_(memory) {}

    // Of a step that is whole: the regions it added, in order.
    const std::pmr::deque<RegionNode>& added() const { return added_; }

private:
    friend class RegionTree;

    struct Counts {
        uint32_t nodes = 0, groups = 0, looks = 0, operations = 0;
    };
    struct Old {
        RegionId region;
        RegionNode node;  // the one the tree does not have now
    };
    Counts counts_;               // those the tree does not have now
    std::pmr::deque<Old> nodes_;  // in the order they were changed
    std::pmr::deque<RegionNode> added_;
};

class RegionTree {
public:
    explicit RegionTree(Memory* memory);

    uint32_t size() const { return static_cast<uint32_t>(nodes_.size()); }
    const RegionNode& operator[](RegionId region) const { return nodes_[region]; }
    uint32_t group_count() const { return counts_.groups; }  // all that ever were

    // The identifier a region has, also if it was joined.
    RegionId resolve(RegionId region) const;
    uint32_t depth(RegionId region) const;
    // The group that is seen: that of the nearest region around it, itself included, that is no scaffold's.
    uint32_t visible_group(RegionId region) const;

    // Appends the leaves of a region's subtree, in the order of the tree; a joined region appears each time it is met.
    class Leaves;

    // ---- Changes. Between begin and end all go into the edit; if one throws, take_back(edit) undoes them.
    void begin(TreeEdit& edit);

    // A new operation's number, a new group, a new look.
    uint32_t add_operation() { return ++counts_.operations; }
    uint32_t add_group() { return counts_.groups++; }
    uint32_t add_look() { return counts_.looks++; }
    // The children of a leaf are added one behind the other.
    RegionId add_child(TreeEdit& edit, RegionId parent, const RegionNode& child);
    void set_group(TreeEdit& edit, RegionId region, uint32_t group);
    // Joins leaves; `regions` rise. The first one gives the identifier.
    void join(TreeEdit& edit, std::span<const RegionId> regions);

    // The step is whole: keeps a copy of what it added.
    void end(TreeEdit& edit);
    // Takes the last step back: one that is whole, or one that failed, for good. Cost: about 20 ns a region it
    // changed or added.
    void take_back(TreeEdit& edit) noexcept;
    // Makes it again: all of it or, if memory runs out, nothing.
    void make_again(TreeEdit& edit);

private:
    RegionNode& change(TreeEdit& edit, RegionId region);

    std::pmr::deque<RegionNode> nodes_;
    TreeEdit::Counts counts_;
};

// A walk through a subtree's leaves.
class RegionTree::Leaves {
public:
    Leaves(const RegionTree& tree, RegionId region, Memory* memory) : tree_(tree), waiting_(memory) {
        waiting_.push_back({region, region + 1});
    }
    // The next leaf, or no_region. Cost: tens of nanoseconds, more where it is much deeper than the one before.
    RegionId next();

private:
    struct Range {
        RegionId next, end;
    };

    const RegionTree& tree_;
    std::pmr::vector<Range> waiting_;  // the last one is next; none is empty
};

}  // namespace flg
