// SPDX-License-Identifier: MIT
#include "tangles/tangle_operators.h"

#include "core/failure.h"
#include "surfaces/cut_curves.h"
#include "surfaces/cut_isolines.h"
#include "surfaces/extra_column.h"
#include "surfaces/field_blend.h"
#include "surfaces/field_levels.h"
#include "surfaces/integral_curves.h"
#include "surfaces/mesh_edit_replay.h"
#include "surfaces/surface_update.h"
#include "surfaces/tracing_jobs.h"
#include "tangles/lines_within.h"
#include "tangles/new_leaves.h"
#include "tangles/region_partition.h"
#include "tangles/voronoi_borders.h"

namespace flg {

namespace {

// Each about 10 us.
constexpr uint32_t cut_chunk = 50;
constexpr uint32_t partition_chunk = 100;
constexpr uint32_t borders_chunk = 40;
constexpr uint32_t streams_chunk = 100;
constexpr uint32_t copy_chunk = 4000;
constexpr uint32_t list_chunk = 1000;
constexpr uint32_t line_chunk = 300;
constexpr uint32_t label_chunk = 10;

// What an operator looks at: where it acts.
struct Scene {
    Surface& surface;
    const LeafSet& leaves;
    const DivideRequest& request;
    uint32_t revision;
};

// Sec. 3.2: distances from a or, with b, the blend between them.
Task<void> solve_or_blend(Pace& pace, Tangle& tangle, const Scene& scene, DistanceField& field) {
    pace.stage("field");
    co_await solve_seeds(pace, tangle.tree, tangle.surface, scene.leaves, scene.request.a, "desc.a",
                         scene.request.perturbation, false, field);
    if (scene.request.b.empty()) co_return;
    DistanceField other;
    co_await solve_seeds(pace, tangle.tree, tangle.surface, scene.leaves, scene.request.b, "desc.b",
                         scene.request.perturbation, false, other);
    for (size_t v = 0; v < field.distances.size(); ++v) {
        field.distances[v] = blend(field.distances[v], other.distances[v]);
        if (v % copy_chunk == 0) co_await pace;
    }
}

// Makes leaves of a partition's components and labels the triangles with them.
Task<void> make_leaves(Pace& pace, Tangle& tangle, const Scene& scene, const RegionPartitionKernel& partition,
                       const Buffer<NewLeaf>& leaves, MeshEdit& edit, TreeEdit& tree_edit) {
    const LeafRules rules{scene.request.grouping, scene.request.cycle, scene.request.scaffold};
    const Buffer<RegionId> regions = co_await add_leaves(pace, tangle.tree, tree_edit, leaves, rules);
    Mesh& mesh = scene.surface.mesh();
    RegionCursor divided = partition.triangles();
    for (uint32_t passed = 1; !divided.at_end(); ++passed) {
        divided.next_64([&](uint32_t t) { edit.set_region(mesh, t, regions[partition.component_of(t)]); });
        if (passed % label_chunk == 0) co_await pace;
    }
}

bool is_divided(const Buffer<NewLeaf>& leaves) {
    for (const NewLeaf& leaf : leaves) {
        if (leaf.part != leaves[0].part) return true;
    }
    return false;
}

// ---- Contours

// While it is cut, leaf i of the list has the labels first + i * (levels + 1) and up, one a band between levels.
Task<void> cut_contours(Pace& pace, Tangle& tangle, const Scene& scene, const DistanceField& field, TangleStep& step) {
    LevelRequest asked;
    asked.count = scene.request.count;
    asked.first = asked.every = scene.request.delta;
    const Buffer<float> levels = co_await list_levels(pace, field.distances, asked, IsolineCutter::max_levels);
    const auto bands = static_cast<uint32_t>(levels.size() + 1);
    const uint32_t first = tangle.tree.size();
    const uint64_t end = first + uint64_t{scene.leaves.list.size()} * bands;
    if (end > uint64_t{FLG_REGION_MAX} + 1) {
        throw Failure(FLG_ERROR_LIMIT, "%zu leaves with %u bands each are too many", scene.leaves.list.size(), bands);
    }
    std::pmr::vector<RegionLevels> labels(pace.memory());
    std::pmr::vector<uint32_t> band_labels(pace.memory());
    for (size_t i = 0; i < scene.leaves.list.size(); ++i) {
        labels.push_back({scene.leaves.list[i], first + static_cast<uint32_t>(i) * bands});
        for (uint32_t b = 0; b < bands; ++b) band_labels.push_back(labels.back().first_label + b);
        if (i % list_chunk == 0) co_await pace;
    }
    GrowingBuffer<float> values = co_await copy_values(pace, field.distances);

    pace.stage("cut");
    pace.commit();
    MeshEdit& edit = step.edit.emplace(pace.memory());
    edit.begin(scene.surface.mesh());
    {
        const ExtraColumn column(scene.surface.columns, std::move(values));
        const CutLevels cut_levels({levels.data(), levels.size()}, labels);
        IsolineCutter cutter(scene.surface.mesh(), scene.surface.columns, column.index(), cut_levels, edit,
                             pace.memory());
        while (!cutter.run(cut_chunk)) co_await pace;
    }
    pace.stage("regions");
    const RegionSet cut(band_labels.data(), static_cast<uint32_t>(band_labels.size()), pace.memory());
    const std::pmr::deque<Corner> no_edges(pace.memory());
    RegionPartitionKernel partition(scene.surface.mesh(), cut, no_edges, pace.memory());
    while (!partition.run(partition_chunk)) co_await pace;
    Buffer<NewLeaf> leaves(partition.components().size(), pace.memory());
    for (size_t c = 0; c < leaves.size(); ++c) {
        const uint32_t label = partition.components()[c].label - first;
        leaves[c] = {scene.leaves.list[label / bands], label % bands};
        if (c % list_chunk == 0) co_await pace;
    }
    if (!is_divided(leaves)) {
        MeshEditReplay back(scene.surface.mesh(), scene.surface.columns, edit, MeshEditReplay::Direction::abandon);
        while (!back.run(copy_chunk)) co_await pace;
        step.edit.reset();
        co_return;
    }
    co_await make_leaves(pace, tangle, scene, partition, leaves, edit, step.tree);
    co_await update_after_edit(pace, scene.surface, edit, scene.revision);
}

// ---- Curves

// The part to the left of the edge between two vertices; no_index if that is none of the regions', or there is no such edge.
uint32_t part_left_of(const Mesh& mesh, const RegionPartitionKernel& partition, uint32_t from, uint32_t to) {
    // The corner of the edge's first vertex that its second one follows.
    const Corner begin = mesh.corner_of_vertex[from];
    Corner corner = begin;
    do {
        if (mesh.vertex_at(next_corner(corner)) == to) break;
        corner = mesh.turn(corner);
    } while (corner != begin && corner != no_index);
    if (corner == no_index || !partition.is_within(triangle_of(corner))) return no_index;
    return partition.components()[partition.component_of(triangle_of(corner))].part;
}

// Strips between streams: the part to the left of curve c has the number c + 1, what no curve has to its left 0. Parts to the
// left of several curves go by the first.
Task<void> number_strips(Pace& pace, const Mesh& mesh, const EmbeddedCurves& embedded,
                         const RegionPartitionKernel& partition, Buffer<uint32_t>& numbers) {
    uint32_t passed = 0;
    for (uint32_t c = 0; c + 1 < embedded.offsets.size(); ++c) {
        const uint32_t first = embedded.offsets[c], end = embedded.offsets[c + 1];
        for (uint32_t i = first; i + 1 < end; ++i) {
            const uint32_t part = part_left_of(mesh, partition, embedded.vertices[i], embedded.vertices[i + 1]);
            if (part != no_index && numbers[part] == 0) numbers[part] = c + 1;
            if (++passed % list_chunk == 0) co_await pace;
        }
    }
}

// Sides of lines: 0 for parts of whose border more metres have them to their left than to their right, else 1. So a spike or
// a small loop the wrong way round does not count.
Task<void> number_sides(Pace& pace, const Mesh& mesh, const SurfaceCurves& curves, const EmbeddedCurves& embedded,
                        const RegionPartitionKernel& partition, Buffer<uint32_t>& numbers) {
    Buffer<double> left(numbers.size(), pace.memory());
    for (size_t p = 0; p < left.size(); ++p) {
        left[p] = 0;
        if (p % copy_chunk == 0) co_await pace;
    }
    uint32_t passed = 0;
    for (uint32_t c = 0; c + 1 < embedded.offsets.size(); ++c) {
        const uint32_t first = embedded.offsets[c], end = embedded.offsets[c + 1];
        for (uint32_t i = first; i < (curves.closed[c] ? end : end - 1); ++i) {
            const uint32_t from = embedded.vertices[i], to = embedded.vertices[i + 1 < end ? i + 1 : first];
            const double length = (mesh.position(to) - mesh.position(from)).norm();
            const uint32_t at_left = part_left_of(mesh, partition, from, to);
            const uint32_t at_right = part_left_of(mesh, partition, to, from);
            if (at_left != no_index) left[at_left] += length;
            if (at_right != no_index) left[at_right] -= length;
            if (++passed % list_chunk == 0) co_await pace;
        }
    }
    for (uint32_t p = 0; p < numbers.size(); ++p) {
        numbers[p] = left[p] > 0 ? 0 : 1;
        if (p % copy_chunk == 0) co_await pace;
    }
}

// One number a part: of strips, of sides, or by their order.
Task<Buffer<uint32_t>> number_parts(Pace& pace, const Scene& scene, const SurfaceCurves& curves,
                                    const EmbeddedCurves& embedded, const RegionPartitionKernel& partition) {
    const Mesh& mesh = scene.surface.mesh();
    const bool strips = scene.request.kind == FLG_TANGLE_STREAM;
    Buffer<uint32_t> numbers(partition.part_count(), pace.memory());
    for (uint32_t p = 0; p < numbers.size(); ++p) {
        numbers[p] = strips ? 0 : p;
        if (p % copy_chunk == 0) co_await pace;
    }
    if (strips) co_await number_strips(pace, mesh, embedded, partition, numbers);
    if (scene.request.kind == FLG_TANGLE_POLYLINE && scene.request.a.curves) {
        co_await number_sides(pace, mesh, curves, embedded, partition, numbers);
    }
    co_return numbers;
}

Task<void> cut_along(Pace& pace, Tangle& tangle, const Scene& scene, const SurfaceCurves& curves, TangleStep& step) {
    if (curves.curve_count() == 0) co_return;
    pace.stage("cut");
    pace.commit();
    const Mesh& mesh = scene.surface.mesh();
    MeshEdit& edit = step.edit.emplace(pace.memory());
    edit.begin(mesh);
    EmbeddedCurves embedded(pace.memory());
    CurveCutter cutter(scene.surface.mesh(), scene.surface.columns, curves, edit, embedded, pace.memory());
    while (!cutter.run(cut_chunk)) co_await pace;
    pace.stage("regions");
    RegionPartitionKernel partition(mesh, scene.leaves.set, embedded.edges, pace.memory());
    while (!partition.run(partition_chunk)) co_await pace;
    const Buffer<uint32_t> numbers = co_await number_parts(pace, scene, curves, embedded, partition);
    if (partition.part_count() > 1) {
        Buffer<NewLeaf> leaves(partition.components().size(), pace.memory());
        for (size_t c = 0; c < leaves.size(); ++c) {
            const RegionComponent& component = partition.components()[c];
            leaves[c] = {component.label, numbers[component.part]};
            if (c % list_chunk == 0) co_await pace;
        }
        co_await make_leaves(pace, tangle, scene, partition, leaves, edit, step.tree);
    }
    co_await update_after_edit(pace, scene.surface, edit, scene.revision);
}

Task<void> trace_streams(Pace& pace, Tangle& tangle, const Scene& scene, SurfaceCurves& curves) {
    DistanceField field;
    co_await solve_or_blend(pace, tangle, scene, field);
    pace.stage("streams");
    const TangleSeeds& a = scene.request.a;
    LeafSet own(pace.memory());
    if (!a.regions.empty()) own = co_await list_leaves(pace, tangle.tree, a.regions, "desc.a");
    const RegionSet& within = a.regions.empty() ? scene.leaves.set : own.set;
    const Buffer<SurfacePoint> starts =
        co_await find_stream_starts(pace, scene.surface, within, a, scene.request.delta, "desc.a");
    const IntegralCurveOptions options;
    IntegralCurveKernel kernel(scene.surface.mesh(), {field.distances.data(), field.distances.size()}, scene.leaves.set,
                               {starts.data(), starts.size()}, options, curves, pace.memory());
    while (!kernel.run(streams_chunk)) co_await pace;
}

Task<void> trace_cells(Pace& pace, Tangle& tangle, const Scene& scene, SurfaceCurves& curves) {
    pace.stage("field");
    DistanceField cells;
    co_await solve_seeds(pace, tangle.tree, tangle.surface, scene.leaves, scene.request.a, "desc.a",
                         scene.request.perturbation, true, cells);
    pace.stage("cells");
    VoronoiBordersKernel kernel(scene.surface.mesh(), scene.leaves.set, cells, curves, pace.memory());
    while (!kernel.run(borders_chunk)) co_await pace;
}

Task<void> trace_shortest_ways(Pace& pace, const Scene& scene, SurfaceCurves& curves) {
    const Buffer<SurfacePoint>& points = scene.request.a.points;
    RegionSet bound = scene.leaves.set;
    Buffer<uint32_t> offsets(2, pace.memory());
    offsets[0] = 0;
    offsets[1] = static_cast<uint32_t>(points.size());
    Buffer<SurfacePoint> copies(points.size(), pace.memory());
    std::copy(points.begin(), points.end(), copies.begin());
    const Paths paths{.offsets = std::move(offsets),
                      .points = std::move(copies),
                      .closed = scene.request.closed,
                      .regions = std::move(bound)};
    co_await trace_polylines(pace, scene.surface, paths, "desc.a.points", curves);
}

// Between points, and along lines.
Task<void> trace_polyline(Pace& pace, const Scene& scene, SurfaceCurves& curves) {
    const TangleSeeds& a = scene.request.a;
    if (!a.points.empty()) co_await trace_shortest_ways(pace, scene, curves);
    if (!a.curves) co_return;
    LinesWithinKernel lines(scene.surface.mesh(), scene.leaves.set, a.curves->curves, curves);
    while (!lines.run(line_chunk)) co_await pace;
}

}  // namespace

Task<void> divide_regions(Pace& pace, Tangle& tangle, const DivideRequest& request, uint32_t revision,
                          TangleStep& step) {
    const LeafSet leaves = co_await list_leaves(pace, tangle.tree, request.regions, "desc.regions");
    const Scene scene{*tangle.surface, leaves, request, revision};
    if (request.kind == FLG_TANGLE_CONTOUR) {
        DistanceField field;
        co_await solve_or_blend(pace, tangle, scene, field);
        co_await cut_contours(pace, tangle, scene, field, step);
        co_return;
    }
    SurfaceCurves curves(pace.memory());
    if (request.kind == FLG_TANGLE_STREAM) co_await trace_streams(pace, tangle, scene, curves);
    if (request.kind == FLG_TANGLE_VORONOI) co_await trace_cells(pace, tangle, scene, curves);
    if (request.kind == FLG_TANGLE_POLYLINE) co_await trace_polyline(pace, scene, curves);
    co_await cut_along(pace, tangle, scene, curves, step);
}

}  // namespace flg
