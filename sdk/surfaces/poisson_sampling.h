// SPDX-License-Identifier: MIT
// Poisson-disk points in the geodesic metric by farthest points: sec. 4.2, algorithm 2 of Nazzaro, Puppo, Pellacini:
// geoTangle (2021). Each point is the vertex that is furthest from those before it; the field of distances is extended by it,
// which visits only what it is nearest to. At the end labels are the Voronoi cells of the points.
//
// Of vertices that are equally far, such as all at the beginning and those of components without a point, the seed draws one.
//
// Departure. The furthest vertex is not searched among all: vertices are in groups, and since distances only fall what was
// the furthest in a group bounds it from then on. The group with the largest bound is looked at, until its bound holds.
#pragma once

#include <algorithm>
#include <deque>
#include <vector>

#include "core/random.h"
#include "surfaces/distance_field.h"
#include "surfaces/region_set.h"

namespace flg {

// With GraphSolver or RefinedSolver. What the solver's field has at the beginning keeps points away: none of it if it was
// made without sources; as in the paper, half a radius from borders if those are its sources at distance radius / 2.
template <class Solver>
class PoissonSamplingKernel {
public:
    // The solver's field is complete, is labelled if cells are wanted, and keeps to the regions. Points are vertices of these,
    // no two nearer to each other than `radius` (metres, > 0) and at most max_count many. All outlive the kernel.
    PoissonSamplingKernel(const Mesh& mesh, const RegionSet& regions, Solver& solver, float radius, uint32_t max_count,
                          uint64_t seed, Memory* memory)
        : mesh_(mesh),
          regions_(regions),
          solver_(solver),
          radius_(radius),
          max_count_(max_count),
          seed_(seed),
          inside_(mesh.vertex_count(), memory),
          candidates_(memory),
          groups_(memory),
          samples_(memory) {}

    // A unit is a unit of the solver, a triangle, or a group of vertices: at most 0.5 us. True when no point fits any more.
    bool run(uint32_t count) {
        for (; count > 0 && pass_ != Pass::done; --count) step();
        return pass_ == Pass::done;
    }

    // Vertices in the order they were chosen; the solver's labels are their places in it.
    const std::pmr::deque<uint32_t>& samples() const { return samples_; }

private:
    enum class Pass { clear, mark, collect, group, choose, extend, done };
    static constexpr uint32_t group_size = 64;

    // Ordered by how far the furthest vertex is; of those equally far by a number drawn for it.
    struct Group {
        float distance;
        uint64_t draw;
        uint32_t vertex;
        uint32_t first;  // of its candidates
        bool operator<(const Group& other) const {
            return distance != other.distance ? distance < other.distance : draw < other.draw;
        }
    };

    void step() {
        size_t size = 0;
        switch (pass_) {
            case Pass::clear:
                size = inside_.size();
                for (const size_t end = std::min<size_t>(size, at_ + group_size); at_ < end; ++at_) inside_[at_] = 0;
                break;
            case Pass::mark:
                size = mesh_.triangle_count();
                if (at_ < size && regions_.contains(mesh_.regions[at_])) {
                    for (uint32_t vertex : mesh_.triangles[at_]) inside_[vertex] = 1;
                }
                ++at_;
                break;
            case Pass::collect:
                size = inside_.size();
                if (at_ < size && inside_[at_] != 0) candidates_.push_back(static_cast<uint32_t>(at_));
                ++at_;
                break;
            case Pass::group:
                size = candidates_.size();
                if (at_ < size) add_group(static_cast<uint32_t>(at_));
                at_ += group_size;
                break;
            case Pass::choose: return choose();
            case Pass::extend:
                if (!solver_.run(1)) return;
                pass_ = samples_.size() < max_count_ ? Pass::choose : Pass::done;
                return;
            case Pass::done: return;
        }
        if (at_ < size) return;
        at_ = 0;
        pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
    }

    void add_group(uint32_t first) {
        Group group{-1, 0, no_index, first};
        const size_t end = std::min<size_t>(candidates_.size(), size_t{first} + group_size);
        for (size_t i = first; i < end; ++i) {
            const uint32_t vertex = candidates_[i];
            const float distance = solver_.distance(vertex);
            if (distance < group.distance) continue;
            const Group other{distance, random_bits(seed_, vertex, 0), vertex, first};
            if (group < other) group = other;
        }
        groups_.push_back(group);
        std::push_heap(groups_.begin(), groups_.end());
    }

    void choose() {
        if (groups_.empty() || max_count_ == 0) {
            pass_ = Pass::done;
            return;
        }
        const Group furthest = groups_.front();
        if (furthest.distance < radius_) {
            pass_ = Pass::done;
        } else if (solver_.distance(furthest.vertex) == furthest.distance) {
            added_ = {furthest.vertex, 0, static_cast<uint32_t>(samples_.size())};
            samples_.push_back(furthest.vertex);
            solver_.extend({&added_, 1}, limits_);
            pass_ = Pass::extend;
        } else {
            std::pop_heap(groups_.begin(), groups_.end());
            groups_.pop_back();
            add_group(furthest.first);
        }
    }

    const Mesh& mesh_;
    const RegionSet& regions_;
    Solver& solver_;
    const float radius_;
    const uint32_t max_count_;
    const uint64_t seed_;
    const SolveLimits limits_;
    Buffer<uint8_t> inside_;  // by vertex: is one of the regions
    std::pmr::deque<uint32_t> candidates_;
    std::pmr::deque<Group> groups_;  // a heap
    std::pmr::deque<uint32_t> samples_;
    Seed added_{};
    Pass pass_ = Pass::clear;
    size_t at_ = 0;
};

}  // namespace flg
