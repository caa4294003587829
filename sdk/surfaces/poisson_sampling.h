// SPDX-License-Identifier: MIT
// Poisson-disk points in the geodesic metric by farthest points: sec. 4.2, algorithm 2 of Nazzaro, Puppo, Pellacini:
// geoTangle (2021). Each point is the vertex that is furthest from those before it; the field of distances is extended by it,
// which visits only what it is nearest to. At the end labels are the Voronoi cells of the points.
//
// Of vertices that are equally far, such as all at the beginning and those of components without a point, the seed draws one.
//
// Departure. The furthest vertex is not searched among all: vertices are in groups, and since distances only fall what was
// the furthest in a group bounds it from then on. The group with the largest bound is looked at, until its bound holds.
//
// Departure. The first points change the whole field over and over: of 130, the first dozen cost half of all. On meshes where
// that matters they are chosen in space (spaced_points.h) and extend the field together, as long as they are about as far
// apart as the wanted number of points can be on the surface's area; so those that come after them still find room between
// them. With few points a component that is near others in space may have none.
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "surfaces/distance_field.h"
#include "surfaces/mesh_measures_normals.h"
#include "surfaces/region_cursor.h"
#include "surfaces/spaced_points.h"

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
          cursor_(mesh, regions),
          solver_(solver),
          radius_(radius),
          max_count_(max_count),
          seed_(seed),
          inside_(mesh.vertex_count(), memory),
          memory_(memory),
          candidates_(memory),
          spaced_(mesh, seed, memory),
          groups_(memory),
          samples_(memory) {}

    // A unit is a unit of the solver, a triangle, a point, or 64 vertices: at most 0.5 us. True when no point fits any more.
    bool run(uint32_t count) {
        for (; count > 0 && pass_ != Pass::done; --count) step();
        return pass_ == Pass::done;
    }

    // Vertices in the order they were chosen; the solver's labels are their places in it.
    const std::pmr::deque<uint32_t>& samples() const { return samples_; }

private:
    enum class Pass { clear, mark, collect, thin, space, extend_together, group, choose, extend, done };
    static constexpr uint32_t group_size = 64;
    static constexpr size_t large = 16'384;  // candidates; with fewer all points are the furthest of all vertices

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
                cursor_.next_64([this](uint32_t triangle) {
                    for (const uint32_t vertex : mesh_.triangles[triangle]) inside_[vertex] = 1;
                });
                if (!cursor_.at_end()) return;
                break;
            case Pass::collect:
                size = inside_.size();
                for (const size_t end = std::min<size_t>(size, at_ + group_size); at_ < end; ++at_) {
                    if (inside_[at_] != 0) candidates_.push_back(static_cast<uint32_t>(at_));
                }
                break;
            case Pass::thin:
                if (candidates_.size() < large || max_count_ == 0) {
                    at_ = 0;
                    pass_ = Pass::group;
                    return;
                }
                size = thinned_size();
                if (at_ < size) thin(at_);
                if (++at_ == size) begin_spacing();
                break;
            case Pass::space:
                if (!spaced_.run(1)) return;
                take_spaced();
                break;
            case Pass::extend_together:
                if (!solver_.run(1)) return;
                break;
            case Pass::group:
                size = candidates_.size();
                if (at_ < size) add_group(static_cast<uint32_t>(at_));
                at_ += group_size;
                break;
            case Pass::choose: return choose();
            case Pass::extend:
                if (!solver_.run(1)) return;
                pass_ = Pass::choose;
                return;
            case Pass::done: return;
        }
        if (at_ < size) return;
        at_ = 0;
        pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
    }

    // From how many vertices spaced points are chosen.
    size_t thinned_size() const {
        return std::min(candidates_.size(), size_t{std::min(max_count_, SpacedPointsKernel::most_points)} *
                                                SpacedPointsKernel::vertices_a_point);
    }

    // One of each run of candidates, drawn; its share of the area stands for the run's.
    void thin(size_t run) {
        const size_t first = run * candidates_.size() / thinned_size();
        const size_t end = (run + 1) * candidates_.size() / thinned_size();
        const auto length = static_cast<uint32_t>(end - first);
        const uint32_t vertex = candidates_[first + random_below(seed_, run, 1, length)];
        spaced_.add(vertex, solver_.distance(vertex));
        const Corner begin = mesh_.corner_of_vertex[vertex];
        Corner corner = begin;
        do {
            area_ += length * vector_area(mesh_, triangle_of(corner)).norm() / 3;
            corner = mesh_.turn(corner);
        } while (corner != begin && corner != no_index);
    }

    // Of what as many points as are wanted are apart in a hexagonal lattice, the densest one: the last of furthest points are
    // 0.70 to 0.80 of that apart, on spheres and tori.
    void begin_spacing() {
        const double lattice = std::sqrt(2 / std::numbers::sqrt3 * area_ / max_count_);
        spaced_.begin(std::max(radius_, static_cast<float>(0.75 * lattice)), max_count_);
    }

    void take_spaced() {
        first_seeds_ = Buffer<Seed>(spaced_.point_count(), memory_);
        for (uint32_t i = 0; i < spaced_.point_count(); ++i) {
            samples_.push_back(spaced_.points()[i]);
            first_seeds_[i] = {samples_.back(), 0, i};
        }
        std::sort(first_seeds_.begin(), first_seeds_.end(),
                  [](const Seed& a, const Seed& b) { return a.vertex < b.vertex; });
        solver_.extend({first_seeds_.data(), first_seeds_.size()}, limits_);
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
        if (groups_.empty() || samples_.size() >= max_count_) {
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
    RegionCursor cursor_;
    Solver& solver_;
    const float radius_;
    const uint32_t max_count_;
    const uint64_t seed_;
    const SolveLimits limits_;
    Buffer<uint8_t> inside_;  // by vertex: is one of the regions
    Memory* memory_;
    std::pmr::deque<uint32_t> candidates_;
    SpacedPointsKernel spaced_;
    double area_ = 0;  // square metres, about
    Buffer<Seed> first_seeds_;
    std::pmr::deque<Group> groups_;  // a heap
    std::pmr::deque<uint32_t> samples_;
    Seed added_{};
    Pass pass_ = Pass::clear;
    size_t at_ = 0;
};

}  // namespace flg
