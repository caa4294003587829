// SPDX-License-Identifier: MIT
// Poisson-disk points in the geodesic metric by farthest points: sec. 4.2, algorithm 2 of Nazzaro, Puppo, Pellacini:
// geoTangle (2021). Each point is the vertex that is furthest from those before it; the field of distances is extended
// by it, which visits only what it is nearest to. At the end labels are the Voronoi cells of the points.
//
// Of vertices that are equally far, such as all at the beginning and those of components without a point, the seed
// draws one.
//
// Departure. The furthest vertex is not searched among all: vertices are in groups, and since distances only fall what
// was the furthest in a group bounds it from then on. The group with the largest bound is looked at, until its bound
// holds.
//
// Departure. The first points change the whole field over and over: of 130, the first dozen cost half of all. On meshes
// where that matters they are chosen in space (spaced_points.h) and extend the field together, as long as they are
// about as far apart as the wanted number of points can be on the surface's area; so those that come after them still
// find room between them. With few points a component that is near others in space may have none.
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "runtime/each.h"
#include "surfaces/geodesics/refined_solver.h"
#include "surfaces/mesh/mesh_measures.h"
#include "surfaces/mesh/region_vertices.h"
#include "surfaces/sampling/spaced_points.h"

namespace flg {

namespace detail {

// Ordered by how far the furthest vertex is; of those equally far by a number drawn for it.
struct SampleGroup {
    float distance;
    uint64_t draw;
    uint32_t vertex;
    uint32_t first;  // of its candidates
    bool operator<(const SampleGroup& other) const {
        return distance != other.distance ? distance < other.distance : draw < other.draw;
    }
};

// The first points: chosen in space among as many of the candidates as that takes, drawn evenly. `distances`: of each
// of those from what points keep away from.
template <class Solver>
Task<void> sample_in_space(Pace& pace, const Mesh& mesh, const Buffer<uint32_t>& candidates, Solver& solver,
                           float radius, uint32_t max_count, uint64_t seed, std::pmr::deque<uint32_t>& samples) {
    const size_t count =
        std::min(candidates.size(), size_t{std::min(max_count, max_spaced_points)} * vertices_a_spaced_point);
    Buffer<SpacedCandidate> thinned(count, pace.memory());
    double area = 0;  // square metres, about
    // One of each run of candidates; its share of the area stands for the run's.
    co_await each(pace, count, Cost::hundreds_of_ns, [&](uint32_t run) {
        const size_t first = run * candidates.size() / count, end = (run + size_t{1}) * candidates.size() / count;
        const auto length = static_cast<uint32_t>(end - first);
        const uint32_t vertex = candidates[first + random_below(seed, run, 1, length)];
        thinned[run] = {vertex, solver.distance(vertex)};
        const Corner begin = mesh.corner_of_vertex[vertex];
        Corner corner = begin;
        do {
            area += length * vector_area(mesh, triangle_of(corner)).norm() / 3;
            corner = mesh.turn(corner);
        } while (corner != begin && corner != no_index);
    });
    // Of what as many points as are wanted are apart in a hexagonal lattice, the densest one: the last of furthest
    // points are 0.70 to 0.80 of that apart, on spheres and tori.
    const double lattice = std::sqrt(2 / std::numbers::sqrt3 * area / max_count);
    const float spacing = std::max(radius, static_cast<float>(0.75 * lattice));
    const std::pmr::vector<uint32_t> points =
        co_await choose_spaced_points(pace, mesh, thinned, spacing, max_count, seed);
    Buffer<Seed> seeds(points.size(), pace.memory());
    for (uint32_t i = 0; i < points.size(); ++i) {
        samples.push_back(points[i]);
        seeds[i] = {points[i], 0, i};
    }
    std::sort(seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) { return a.vertex < b.vertex; });
    const SolveLimits limits;
    const std::span<const Seed> together(seeds.data(), seeds.size());
    co_await extend_distances(pace, solver, together, limits);
}

}  // namespace detail

// Vertices of the regions in the order they were chosen, no two nearer to each other than `radius` (metres, > 0) and
// at most max_count many; the solver's labels become their places in it. With RefinedSolver, or another solver of its
// kind. Its field is complete, is labelled if cells are wanted, and keeps to the regions. What that has at the
// beginning keeps points away: none of it if it was made without sources; as in the paper, half a radius from borders
// if those are its sources at distance radius / 2.
template <class Solver>
Task<Buffer<uint32_t>> sample_poisson(Pace& pace, const Mesh& mesh, const RegionSet& regions, Solver& solver,
                                      float radius, uint32_t max_count, uint64_t seed) {
    constexpr uint32_t group_size = 64;
    constexpr size_t large = 16'384;  // candidates; with fewer all points are the furthest of all vertices
    std::pmr::deque<uint32_t> samples(pace.memory());
    const Buffer<uint32_t> candidates = co_await vertices_of(pace, mesh, regions, RegionRim::without);
    if (candidates.size() >= large && max_count != 0)
        co_await detail::sample_in_space(pace, mesh, candidates, solver, radius, max_count, seed, samples);

    std::pmr::deque<detail::SampleGroup> groups(pace.memory());  // a heap
    const auto add_group = [&](uint32_t first) {
        detail::SampleGroup group{-1, 0, no_index, first};
        const size_t end = std::min<size_t>(candidates.size(), size_t{first} + group_size);
        for (size_t i = first; i < end; ++i) {
            const uint32_t vertex = candidates[i];
            const float distance = solver.distance(vertex);
            if (distance < group.distance) continue;
            const detail::SampleGroup other{distance, random_bits(seed, vertex, 0), vertex, first};
            if (group < other) group = other;
        }
        groups.push_back(group);
        std::push_heap(groups.begin(), groups.end());
    };
    co_await each(pace, (candidates.size() + group_size - 1) / group_size, Cost::hundreds_of_ns,
                  [&](uint32_t g) { add_group(g * group_size); });

    const SolveLimits limits;
    Slice slice(Cost::hundreds_of_ns);
    while (!groups.empty() && samples.size() < max_count && groups.front().distance >= radius) {
        const detail::SampleGroup furthest = groups.front();
        if (solver.distance(furthest.vertex) == furthest.distance) {
            const Seed added = {furthest.vertex, 0, static_cast<uint32_t>(samples.size())};
            samples.push_back(furthest.vertex);
            const std::span<const Seed> one(&added, 1);
            co_await extend_distances(pace, solver, one, limits);
        } else {
            std::pop_heap(groups.begin(), groups.end());
            groups.pop_back();
            add_group(furthest.first);
            if (slice.is_over()) co_await pace;
        }
    }
    Buffer<uint32_t> chosen(samples.size(), pace.memory());
    co_await each(pace, samples.size(), Cost::some_ns, [&](uint32_t i) { chosen[i] = samples[i]; });
    co_return chosen;
}

}  // namespace flg
