// SPDX-License-Identifier: MIT
// The triangles that a path on a mesh runs through, one after the other across shared edges.
//
// Invariants: neighbours in the sleeve are neighbours in the mesh; only the first triangle holds the path's start and only
// the last its end; it never goes back to where it has just come from. All of its triangles are of the regions.
#pragma once

#include <deque>

#include "surfaces/region_set.h"
#include "surfaces/surface_place.h"

namespace flg {

// Grows at its end; clear() takes no time and keeps the memory.
template <class T>
class ReusedDeque {
public:
    explicit ReusedDeque(Memory* memory) : values_(memory) {}
    uint32_t size() const { return size_; }
    T& operator[](uint32_t i) { return values_[i]; }
    const T& operator[](uint32_t i) const { return values_[i]; }
    T& back() { return values_[size_ - 1]; }
    const T& back() const { return values_[size_ - 1]; }
    void clear() { size_ = 0; }
    void pop_back() { --size_; }
    void push_back(const T& value) {
        if (size_ < values_.size()) {
            values_[size_] = value;
        } else {
            values_.push_back(value);
        }
        ++size_;
    }

private:
    std::pmr::deque<T> values_;
    uint32_t size_ = 0;
};

class GeodesicSleeve {
public:
    GeodesicSleeve(const Mesh& mesh, const RegionSet& regions, const SurfacePlace& from, const SurfacePlace& to,
                   Memory* memory)
        : mesh_(mesh), regions_(regions), from_(from), to_(to), triangles_(memory) {}

    uint32_t size() const { return triangles_.size(); }
    uint32_t operator[](uint32_t i) const { return triangles_[i]; }
    uint32_t last() const { return triangles_.back(); }
    bool is_complete() const { return complete_; }

    void clear();
    // Goes on into a neighbour of the last triangle, or stays in it. Where that holds the start, the sleeve begins there;
    // where it holds the end it is complete, and further triangles are ignored.
    void enter(uint32_t triangle);
    // Goes on about a vertex of the last triangle to another of its triangles, over as few as possible. False if the
    // mesh or the regions end on both ways. `cost` rises by the triangles looked at.
    bool turn_to(uint32_t vertex, uint32_t triangle, uint32_t& cost);
    // Goes on about a vertex: counter-clockwise or clockwise until `triangle`: the mesh and the regions go on that far.
    void turn(uint32_t vertex, bool counter_clockwise, uint32_t triangle);

private:
    const Mesh& mesh_;
    const RegionSet& regions_;
    const SurfacePlace from_, to_;
    ReusedDeque<uint32_t> triangles_;
    bool complete_ = false;
};

// The next triangle about a vertex; no_index where the mesh or the regions end.
uint32_t next_about(const Mesh& mesh, const RegionSet& regions, uint32_t vertex, uint32_t triangle,
                    bool counter_clockwise);

}  // namespace flg
