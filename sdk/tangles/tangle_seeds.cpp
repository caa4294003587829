// SPDX-License-Identifier: MIT
#include "tangles/tangle_seeds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/failure.h"
#include "runtime/each.h"
#include "surfaces/geodesics/geodesic_seeds.h"
#include "surfaces/sampling/poisson_sampling.h"
#include "surfaces/surface_inputs.h"
#include "tangles/region_partition.h"
#include "tangles/room_work.h"

namespace flg {

namespace {

struct Beginning {
    uint32_t loop = no_index;
    uint32_t edge = 0;  // of all edges
};

// The vertex of a loop that is not taken which is nearest to a place.
Task<Beginning> find_beginning(Pace& pace, const Mesh& mesh, const RegionLoops& loops, const Buffer<uint8_t>& taken,
                               const Position& place) {
    const Vec3 wanted = load_vec3(place.data());
    Beginning best;
    double least = std::numeric_limits<double>::infinity();
    uint32_t loop = 0;
    co_await each(pace, loops.edges.size(), Cost::tens_of_ns, [&](uint32_t i) {
        while (i == loops.offsets[loop + 1]) ++loop;
        if (taken[loop] != 0) return;
        const double square = (mesh.position(mesh.vertex_at(loops.edges[i])) - wanted).squaredNorm();
        if (!(square < least)) return;
        least = square;
        best = {loop, i};
    });
    co_return best;
}

Task<void> add_loop(Pace& pace, const RegionLoops& from, Beginning beginning, RegionLoops& to) {
    const uint32_t first = from.offsets[beginning.loop], count = from.offsets[beginning.loop + 1] - first;
    co_await each(pace, count, Cost::tens_of_ns,
                  [&](uint32_t i) { to.edges.push_back(from.edges[first + (beginning.edge - first + i) % count]); });
    to.offsets.push_back(static_cast<uint32_t>(to.edges.size()));
    to.lengths.push_back(from.lengths[beginning.loop]);
}

Task<void> reorder_loops(Pace& pace, const Mesh& mesh, RegionLoops& loops, const Buffer<Position>& anchors) {
    Buffer<uint8_t> taken(loops.count(), pace.memory());
    co_await each(pace, loops.count(), Cost::some_ns, [&](uint32_t l) { taken[l] = 0; });
    RegionLoops ordered(pace.memory());
    for (const Position& anchor : anchors) {
        const Beginning beginning = co_await find_beginning(pace, mesh, loops, taken, anchor);
        if (beginning.loop == no_index) break;
        taken[beginning.loop] = 1;
        co_await add_loop(pace, loops, beginning, ordered);
    }
    Slice slice(Cost::some_ns);
    for (uint32_t l = 0; l < loops.count(); ++l) {
        if (taken[l] == 0) co_await add_loop(pace, loops, {l, loops.offsets[l]}, ordered);
        if (slice.is_over()) co_await pace;
    }
    loops = std::move(ordered);
}

}  // namespace

Task<Buffer<Position>> positions_of(Pace& pace, const Mesh& mesh, const Buffer<SurfacePoint>& points) {
    Buffer<Position> positions(points.size(), pace.memory());
    co_await each(pace, points.size(), Cost::tens_of_ns,
                  [&](uint32_t i) { store_vec3(position_of(mesh, points[i]), positions[i].data()); });
    co_return positions;
}

Task<Buffer<Position>> positions_of(Pace& pace, const Mesh& mesh, const Buffer<uint32_t>& vertices) {
    Buffer<Position> positions(vertices.size(), pace.memory());
    co_await each(pace, vertices.size(), Cost::tens_of_ns,
                  [&](uint32_t i) { positions[i] = mesh.positions[vertices[i]]; });
    co_return positions;
}

Task<void> anchor_loops(Pace& pace, const Mesh& mesh, RegionLoops& loops, SeedAnchors& anchors) {
    if (anchors.given) {
        co_await reorder_loops(pace, mesh, loops, anchors.loops);
        co_return;
    }
    Buffer<Position> found(loops.count(), pace.memory());
    co_await each(pace, loops.count(), Cost::tens_of_ns,
                  [&](uint32_t l) { found[l] = mesh.positions[mesh.vertex_at(loops.edges[loops.offsets[l]])]; });
    anchors.loops = std::move(found);
}

namespace {

// The longest loop of each piece that has two at least; of equally long ones the first, however lengths were rounded.
Task<std::pmr::vector<uint32_t>> longest_of_pieces(Pace& pace, const Mesh& mesh, const RegionSet& leaves,
                                                   const RegionLoops& loops) {
    constexpr double as_long = 1 + 1e-6;
    const std::pmr::deque<Corner> no_edges(pace.memory());
    const RegionPartition pieces = co_await partition_regions(pace, mesh, leaves, no_edges);
    struct Piece {
        uint32_t longest = no_index, count = 0;
    };
    Buffer<Piece> of_piece(pieces.part_count, pace.memory());
    co_await each(pace, of_piece.size(), Cost::some_ns, [&](uint32_t p) { of_piece[p] = {}; });
    co_await each(pace, loops.count(), Cost::tens_of_ns, [&](uint32_t l) {
        const uint32_t triangle = triangle_of(loops.edges[loops.offsets[l]]);
        Piece& piece = of_piece[pieces.components[pieces.component_of(triangle)].part];
        ++piece.count;
        if (piece.longest == no_index || loops.lengths[l] > as_long * loops.lengths[piece.longest]) piece.longest = l;
    });
    std::pmr::vector<uint32_t> longest(pace.memory());
    co_await each(pace, of_piece.size(), Cost::tens_of_ns, [&](uint32_t p) {
        if (of_piece[p].count > 1) longest.push_back(of_piece[p].longest);
    });
    co_return longest;
}

// Those loops first, the others as they are.
Task<void> move_to_front(Pace& pace, const std::pmr::vector<uint32_t>& first, RegionLoops& loops) {
    Buffer<uint8_t> is_first(loops.count(), pace.memory());
    co_await each(pace, loops.count(), Cost::some_ns, [&](uint32_t l) { is_first[l] = 0; });
    RegionLoops ordered(pace.memory());
    for (const uint32_t l : first) {
        is_first[l] = 1;
        co_await add_loop(pace, loops, {l, loops.offsets[l]}, ordered);
    }
    Slice slice(Cost::some_ns);
    for (uint32_t l = 0; l < loops.count(); ++l) {
        if (is_first[l] == 0) co_await add_loop(pace, loops, {l, loops.offsets[l]}, ordered);
        if (slice.is_over()) co_await pace;
    }
    loops = std::move(ordered);
}

Task<uint32_t> lead(Pace& pace, const Mesh& mesh, const RegionSet& leaves, const TangleSeeds& seeds,
                    const char* argument, RegionLoops& loops) {
    if (seeds.first_loop != no_index && seeds.first_loop >= loops.count())
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s begins at border %u, the regions have %u borders", argument,
                      seeds.first_loop, loops.count());
    std::pmr::vector<uint32_t> first(pace.memory());
    if (seeds.first_loop != no_index)
        first.push_back(seeds.first_loop);
    else
        first = co_await longest_of_pieces(pace, mesh, leaves, loops);
    if (first.empty() || loops.count() < 2)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the regions have one border, two are needed to go between them");
    co_await move_to_front(pace, first, loops);
    co_return static_cast<uint32_t>(first.size());
}

}  // namespace

Task<SeedLoops> find_loops(Pace& pace, const Mesh& mesh, const RegionSet& leaves, const TangleSeeds& seeds,
                           const char* argument) {
    SeedLoops found{RegionLoops(pace.memory())};
    RegionLoops& loops = found.loops;
    loops = co_await find_region_loops(pace, mesh, leaves);
    if (loops.count() == 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s asks for borders, but the regions are all of a closed surface",
                      argument);
    }
    if (seeds.loops != TangleSeeds::Loops::none)
        found.leading = co_await lead(pace, mesh, leaves, seeds, argument, loops);
    if (seeds.anchors) co_await anchor_loops(pace, mesh, loops, *seeds.anchors);
    co_return found;
}

Task<Buffer<BorderStretch>> choose_stretches(Pace& pace, const SeedLoops& found, const TangleSeeds& seeds,
                                             const char* argument) {
    const uint32_t count = found.loops.count();
    const bool named = !seeds.stretches.empty();
    const uint32_t first = seeds.loops == TangleSeeds::Loops::others ? found.leading : 0;
    const uint32_t end = seeds.loops == TangleSeeds::Loops::leading ? found.leading : count;
    Buffer<BorderStretch> chosen(named ? seeds.stretches.size() : end - first, pace.memory());
    co_await each(pace, chosen.size(), Cost::some_ns, [&](uint32_t i) {
        chosen[i] = named ? seeds.stretches[i] : BorderStretch{.loop = first + i};
        if (chosen[i].loop >= count)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s.stretches[%u].loop is %u, the regions have %u borders",
                          argument, i, chosen[i].loop, count);
    });
    co_return chosen;
}

namespace {

// The edges whose middle lies in the stretch.
Task<void> add_stretch(Pace& pace, const Mesh& mesh, const RegionLoops& loops, BorderStretch stretch,
                       std::pmr::deque<Corner>& edges) {
    const double whole = loops.lengths[stretch.loop];
    double walked = 0;
    const uint32_t first = loops.offsets[stretch.loop], end = loops.offsets[stretch.loop + 1];
    co_await each(pace, first, end, Cost::tens_of_ns, [&](uint32_t i) {
        const double length = edge_length(mesh, loops.edges[i]);
        const double middle = whole > 0 ? (walked + length / 2) / whole : 0;
        walked += length;
        if (stretch.is_whole() || (middle >= stretch.begin && middle < stretch.end) || middle + 1 < stretch.end) {
            edges.push_back(loops.edges[i]);
        }
    });
}

// Edges where leaves end, seen from within; those between two leaves once.
Task<void> add_each_border(Pace& pace, const Mesh& mesh, const RegionSet& leaves, std::pmr::deque<Corner>& edges) {
    const auto is_border = [&](uint32_t t, uint32_t across) {
        if (across == no_index) return true;
        const uint32_t other = mesh.regions[across];
        return other != mesh.regions[t] && (t < across || !leaves.contains(other));
    };
    co_await each_within(pace, mesh, leaves, Cost::tens_of_ns, [&](uint32_t t) {
        for (uint32_t k = 0; k < 3; ++k)
            if (is_border(t, mesh.neighbours[t][k])) edges.push_back(3 * t + k);
    });
}

// Half a radius from borders, by algorithm 2.
Task<void> begin_sampling(Pace& pace, Surface& surface, const RegionSet& leaves, float from_border,
                          const GeodesicRegion& bound, RefinedSolver& solver) {
    const Mesh& mesh = surface.mesh();
    const RegionLoops loops = co_await find_region_loops(pace, mesh, leaves);
    GeodesicSeeds border(mesh, mesh.positions, leaves, pace.memory(), &blocks_of(surface).flipped);
    co_await each(pace, loops.edges.size(), Cost::hundreds_of_ns,
                  [&](uint32_t i) { border.add_edge(loops.edges[i], 0); });
    Buffer<Seed> away = co_await merge_seeds(pace, border.found());
    co_await each(pace, away.size(), Cost::some_ns, [&](uint32_t i) { away[i].distance += from_border; });
    const SolveLimits limits{.distance = unreachable, .targets = std::pmr::vector<uint32_t>(pace.memory())};
    const std::span<const Seed> seeds(away.data(), away.size());
    co_await solve_distances(pace, solver, seeds, limits, false, &bound);
}

Task<float> largest_distance(Pace& pace, const RefinedSolver& solver) {
    float largest = 0;
    co_await each(pace, solver.page_count(), Cost::hundreds_of_ns, [&](uint32_t page) {
        solver.visit_page(page, [&](uint32_t, float distance, uint32_t) { largest = std::max(largest, distance); });
    });
    co_return largest;
}

Task<Buffer<uint32_t>> sample(Pace& pace, Surface& surface, const RegionSet& leaves, const TangleSeeds& seeds) {
    const GeodesicBlocks& blocks = blocks_of(surface);
    const GeodesicRegion bound = co_await bound_region(pace, surface.mesh(), surface.mesh().positions, blocks, leaves);
    auto solver = surface.solvers.pool.lend(blocks);
    float radius = seeds.sample_radius;
    if (seeds.samples_fit) {
        co_await begin_sampling(pace, surface, leaves, 0, bound, *solver);
        const float room = co_await largest_distance(pace, *solver);
        if (room > 0) radius = std::min(radius, 1.5f * room);
    }
    co_await begin_sampling(pace, surface, leaves, radius / 2, bound, *solver);
    const uint32_t most = seeds.sample_count == 0 ? no_index : seeds.sample_count;
    Buffer<uint32_t> samples = co_await sample_poisson(pace, surface.mesh(), leaves, *solver, radius, most, seeds.seed);
    solver.give_back();
    co_return samples;
}

}  // namespace

Task<LeafSet> list_leaves(Pace& pace, const RegionTree& tree, const std::pmr::vector<RegionId>& regions,
                          const char* argument) {
    Buffer<uint64_t> found((size_t{tree.size()} + 63) / 64, pace.memory());
    co_await each(pace, found.size(), Cost::some_ns, [&](uint32_t i) { found[i] = 0; });
    Slice slice(Cost::tens_of_ns);
    for (size_t i = 0; i < regions.size(); ++i) {
        if (regions[i] >= tree.size()) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%zu] is %u, the tangle has %u regions", argument, i,
                          regions[i], tree.size());
        }
        RegionTree::Leaves leaves(tree, regions[i], pace.memory());
        for (RegionId leaf = leaves.next(); leaf != no_region; leaf = leaves.next()) {
            found[leaf / 64] |= uint64_t{1} << leaf % 64;
            if (slice.is_over()) co_await pace;
        }
        if (slice.is_over()) co_await pace;
    }
    LeafSet leaves(pace.memory());
    co_await each(pace, tree.size(), Cost::some_ns, [&](RegionId r) {
        if ((found[r / 64] >> r % 64 & 1) != 0) leaves.list.push_back(r);
    });
    leaves.set = RegionSet(leaves.list.data(), static_cast<uint32_t>(leaves.list.size()), pace.memory());
    co_return leaves;
}

Task<GeodesicSources> find_sources(Pace& pace, Surface& surface, const RegionSet& leaves, const TangleSeeds& seeds,
                                   const char* argument, SeedPlaces& places) {
    const Mesh& mesh = surface.mesh();
    co_await check_points(pace, mesh, seeds.points, argument);
    GeodesicSources sources;
    sources.curves = seeds.curves;
    const bool located = seeds.anchors && seeds.anchors->given;
    if (seeds.sample_radius > 0 && !located) {
        sources.vertices = co_await sample(pace, surface, leaves, seeds);
        if (seeds.anchors) seeds.anchors->samples = co_await positions_of(pace, mesh, sources.vertices);
    }
    SurfaceCurves spaced(pace.memory());
    const bool outer = seeds.borders == FLG_TANGLE_BORDERS_OUTER;
    const bool stretched = seeds.loops != TangleSeeds::Loops::none || !seeds.stretches.empty();
    if (outer || stretched || seeds.border_spacing > 0) {
        const SeedLoops found = co_await find_loops(pace, mesh, leaves, seeds, argument);
        const RegionLoops& loops = found.loops;
        if (outer || stretched) {
            const Buffer<BorderStretch> stretches = co_await choose_stretches(pace, found, seeds, argument);
            for (const BorderStretch& stretch : stretches) {
                co_await add_stretch(pace, mesh, loops, outer ? BorderStretch{.loop = stretch.loop} : stretch,
                                     places.edges);
            }
        }
        if (seeds.border_spacing > 0) {
            Buffer<BorderStretch> whole(loops.count(), pace.memory());
            co_await each(pace, loops.count(), Cost::some_ns, [&](uint32_t l) { whole[l] = {.loop = l}; });
            co_await sample_stretches(pace, mesh, loops, whole, seeds.border_spacing, 1, spaced);
        }
    }
    if (seeds.borders == FLG_TANGLE_BORDERS_EACH) co_await add_each_border(pace, mesh, leaves, places.edges);
    if (!places.edges.empty()) sources.edges = &places.edges;
    const size_t samples = located ? seeds.anchors->sample_points.size() : 0, own = samples + seeds.points.size();
    sources.points = Buffer<SurfacePoint>(own + spaced.points.size(), pace.memory());
    co_await each(pace, sources.points.size(), Cost::some_ns, [&](uint32_t i) {
        sources.points[i] = i < samples ? seeds.anchors->sample_points[i]
                            : i < own   ? seeds.points[i - samples]
                                        : spaced.points[i - own];
    });
    // Where no sample fits there is nothing to begin at; but borders that are not there are a mistake.
    const bool none = sources.vertices.empty() && sources.points.empty() && !sources.edges && !sources.curves;
    if (none && seeds.sample_radius == 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s comes to nothing: the regions have no borders", argument);
    }
    co_return sources;
}

Task<void> solve_seeds(Pace& pace, const RegionTree& tree, const std::shared_ptr<Surface>& surface,
                       const LeafSet& leaves, const TangleSeeds& seeds, const char* argument, Perturbation perturbation,
                       FieldKind kind, DistanceField& field) {
    LeafSet own(pace.memory());
    if (!seeds.regions.empty()) own = co_await list_leaves(pace, tree, seeds.regions, argument);
    const RegionSet& within = seeds.regions.empty() ? leaves.set : own.set;
    SeedPlaces places(pace.memory());
    // What may fail comes first: GCC 12 frees members of an aggregate twice if a later one throws.
    GeodesicSources sources = co_await find_sources(pace, *surface, within, seeds, argument, places);
    RegionSet bound = leaves.set;
    const GeodesicRequest request{.surface = surface,
                                  .sources = std::move(sources),
                                  .regions = std::move(bound),
                                  .max_distance = unreachable,
                                  .targets = {},
                                  .labelled = kind.labelled,
                                  .perturbation = perturbation,
                                  .may_be_local = kind.extent == FieldExtent::local};
    co_await solve_field(pace, request, field);
}

}  // namespace flg
