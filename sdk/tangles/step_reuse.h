// SPDX-License-Identifier: MIT
// What an edit of the history changed of the mesh so far, and steps whose results are used again because it did not
// reach what they read.
//
// Vertices and triangles that were there before the first changed step keep their numbers; what a step adds that is
// used again has other numbers, in the same order. So all that an operator does with its region comes to the same bits:
// nothing in it depends on numbers but by their order.
//
// Invariants
// - A vertex is clean if it, its fan and the places of both are those before the edit; a triangle is, if its label
//   means the same region.
// - What a step reads are the triangles of its leaves and of those of its seeds, and the fans of their vertices.
#pragma once

#include <vector>

#include "tangles/region_names.h"
#include "tangles/step_record.h"

namespace flg {

// From numbers before the edit to those after it.
class NumberMap {
public:
    explicit NumberMap(Memory* memory) : ranges_(memory) {}

    void begin(uint32_t base) { base_ = base; }
    void add(uint32_t old, uint32_t count, uint32_t now) {
        if (count > 0) ranges_.push_back({old, count, now});
    }
    size_t range_count() const { return ranges_.size(); }
    void forget_after(size_t range_count) {
        while (ranges_.size() > range_count) ranges_.pop_back();
    }
    // no_index: it is not there.
    uint32_t operator[](uint32_t old) const {
        if (old < base_ || old == no_index) return old;
        if (last_ < ranges_.size() && ranges_[last_].has(old)) return ranges_[last_].now + (old - ranges_[last_].old);
        for (last_ = 0; last_ < ranges_.size(); ++last_)
            if (ranges_[last_].has(old)) return ranges_[last_].now + (old - ranges_[last_].old);
        return no_index;
    }

private:
    struct Range {
        uint32_t old, count, now;
        bool has(uint32_t i) const { return i >= old && i - old < count; }
    };
    uint32_t base_ = 0;
    std::pmr::vector<Range> ranges_;
    mutable size_t last_ = 0;
};

// Marks of a growing number of things; at first none has one.
class GrowingMarks {
public:
    explicit GrowingMarks(Memory* memory) : words_(memory) {}
    void set(uint32_t i) {
        while (words_.size() <= i / 64) words_.push_back(0);
        words_[i / 64] |= uint64_t{1} << i % 64;
    }
    bool has(uint32_t i) const { return i / 64 < words_.size() && (words_[i / 64] >> i % 64 & 1) != 0; }
    std::pmr::deque<uint64_t>& words() { return words_; }

private:
    std::pmr::deque<uint64_t> words_;
};

// A step that was taken back, and what is known of it.
struct OldStep {
    OldStep(std::shared_ptr<TangleStep> of_step, Memory* memory) : step(std::move(of_step)), touched(memory) {}

    std::shared_ptr<TangleStep> step;
    std::pmr::deque<uint32_t> touched;  // vertices of the mesh before it
    uint32_t read = no_index;           // triangles; no_index: it can't be used again
};

class MeshChanges {
public:
    explicit MeshChanges(Memory* memory) : vertices(memory), triangles(memory), shapes_(memory), labels_(memory) {}

    bool shape_changed(uint32_t vertex) const { return shapes_.has(vertex); }
    bool label_changed(uint32_t triangle) const { return labels_.has(triangle); }

    // The mesh before the first changed step.
    friend Task<void> begin(Pace& pace, MeshChanges& changes, const Mesh& mesh);
    // A step is not there any more as it was.
    friend Task<void> mark_old(Pace& pace, const OldStep& old, MeshChanges& changes);
    // A step was made anew; before any other.
    friend Task<void> mark_new(Pace& pace, const Mesh& mesh, const TangleStep& step, MeshChanges& changes);

    NumberMap vertices, triangles;

private:
    GrowingMarks shapes_, labels_;  // by the numbers after the edit
};

Task<void> begin(Pace& pace, MeshChanges& changes, const Mesh& mesh);
Task<void> mark_old(Pace& pace, const OldStep& old, MeshChanges& changes);
Task<void> mark_new(Pace& pace, const Mesh& mesh, const TangleStep& step, MeshChanges& changes);

// What has to be known of a step to use it again, or not. It was just taken back. Cost: some ns a triangle it read and
// a word it changed.
Task<void> look_back(Pace& pace, const Tangle& tangle, OldStep& old);

// Gives a step the result of an old one whose record it has, by its own points and regions: false, and nothing changed,
// if that read what has changed. Cost: like making a step again.
Task<bool> use_again(Pace& pace, Tangle& tangle, const OldStep& old, uint32_t revision, MeshChanges& changes,
                     RegionMap& regions, TangleStep& step);

// Whether points of seeds are where they were, and their new numbers.
Task<bool> move_points(Pace& pace, const Mesh& mesh, const MeshChanges& changes, Buffer<SurfacePoint>& points);

}  // namespace flg
