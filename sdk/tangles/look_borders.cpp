// SPDX-License-Identifier: MIT
#include "tangles/look_borders.h"

#include <algorithm>

#include "surfaces/region_loops.h"
#include "tangles/passes.h"

namespace flg {

namespace {

constexpr size_t clear_step = 16;

}  // namespace

LookBordersKernel::LookBordersKernel(const Mesh& mesh, const RegionTree& tree, SurfaceCurves& out, Memory* memory)
    : mesh_(mesh),
      tree_(tree),
      out_(out),
      ends_(mesh.vertex_count(), memory),
      taken_((3 * size_t{mesh.triangle_count()} + 63) / 64, memory) {}

bool LookBordersKernel::is_border(Corner edge) const {
    const uint32_t across = mesh_.neighbour_at(edge);
    if (across == no_index) return false;
    const uint32_t here = mesh_.regions[triangle_of(edge)], there = mesh_.regions[across];
    return here != there && tree_[here].look != tree_[there].look;
}

void LookBordersKernel::count_ends(uint32_t triangle) {
    for (Corner edge = 3 * triangle; edge < 3 * triangle + 3; ++edge) {
        if (mesh_.neighbour_at(edge) == no_index) {
            // Curves end at borders of the surface.
            ends_[mesh_.vertex_at(edge)] = ends_[mesh_.vertex_at(next_corner(edge))] = 3;
        } else if (triangle < mesh_.neighbour_at(edge) && is_border(edge)) {
            for (const uint32_t v : {mesh_.vertex_at(edge), mesh_.vertex_at(next_corner(edge))}) {
                ends_[v] = std::min<uint8_t>(3, static_cast<uint8_t>(ends_[v] + 1));
            }
        }
    }
}

void LookBordersKernel::begin(Corner edge) {
    first_vertex_ = mesh_.vertex_at(edge);
    length_ = 0;
    edge_ = no_index;
    turning_ = edge;
}

// Of open curves an edge that leaves an end; of closed ones any.
void LookBordersKernel::look_for_start(uint32_t triangle) {
    for (Corner edge = 3 * triangle; edge < 3 * triangle + 3; ++edge) {
        if (!is_border(edge) || is_taken(edge)) continue;
        if (pass_ == Pass::open && ends_[mesh_.vertex_at(edge)] == 2) continue;
        return begin(edge);
    }
    ++at_;
}

void LookBordersKernel::end(bool closed) {
    if (!closed) {
        // The last point, in the triangle of the stretch before it.
        const uint32_t k = next_corner(edge_) % 3;
        out_.points.push_back({triangle_of(edge_), k == 1 ? 1.0f : 0.0f, k == 2 ? 1.0f : 0.0f});
    }
    out_.offsets.push_back(static_cast<uint32_t>(out_.points.size()));
    out_.closed.push_back(closed);
    out_.values.push_back(static_cast<float>(length_));
    turning_ = no_index;
}

// `turning_` is an edge that starts where the curve has come to: the next one, or one to turn on from.
void LookBordersKernel::walk() {
    if (!is_border(turning_) || is_taken(turning_)) {
        turning_ = mesh_.turn(turning_);
        return;
    }
    edge_ = turning_;
    take(edge_);
    take(mesh_.opposite(edge_));
    const uint32_t k = edge_ % 3;
    out_.points.push_back({triangle_of(edge_), k == 1 ? 1.0f : 0.0f, k == 2 ? 1.0f : 0.0f});
    length_ += edge_length(mesh_, edge_);
    const uint32_t vertex = mesh_.vertex_at(next_corner(edge_));
    if (vertex == first_vertex_ && ends_[vertex] == 2) {
        end(true);
    } else if (ends_[vertex] != 2) {
        end(false);
    } else {
        turning_ = next_corner(edge_);
    }
}

// A unit; false at the end of a pass.
bool LookBordersKernel::step() {
    const size_t triangles = mesh_.triangle_count();
    switch (pass_) {
        case Pass::clear_vertices:
            for (const size_t stop = std::min(ends_.size(), at_ + clear_step); at_ < stop; ++at_) ends_[at_] = 0;
            return at_ < ends_.size();
        case Pass::clear_edges:
            for (const size_t stop = std::min(taken_.size(), at_ + clear_step); at_ < stop; ++at_) taken_[at_] = 0;
            return at_ < taken_.size();
        case Pass::count:
            if (at_ < triangles) count_ends(static_cast<uint32_t>(at_++));
            return at_ < triangles;
        case Pass::open:
        case Pass::closed:
            if (turning_ != no_index) {
                walk();
                return true;
            }
            if (at_ < triangles) look_for_start(static_cast<uint32_t>(at_));
            return at_ < triangles;
        case Pass::done: break;
    }
    return false;
}

bool LookBordersKernel::run(uint32_t count) {
    return run_passes(count, pass_, at_, [this] { return step(); });
}

}  // namespace flg
