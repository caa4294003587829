// SPDX-License-Identifier: MIT
#include "tangles/tangle_operators.h"

#include <map>

#include "core/failure.h"
#include "filigree/filigree_surface.h"
#include "filigree/filigree_tangle.h"
#include "runtime/each.h"
#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/cutting/cut_curves.h"
#include "surfaces/cutting/cut_isolines.h"
#include "surfaces/field_levels.h"
#include "surfaces/mesh/extra_column.h"
#include "surfaces/mesh/mesh_edit.h"
#include "surfaces/mesh/surface_place.h"
#include "surfaces/surface_update.h"
#include "surfaces/tracing_jobs.h"
#include "tangles/region_partition.h"
#include "tangles/region_specks.h"
#include "tangles/region_tree.h"
#include "tangles/room_work.h"
#include "tangles/stream_lines.h"
#include "tangles/voronoi_borders.h"

namespace flg {

namespace {

// Numbers for pairs, each new one the next.
class PairNumbers {
public:
    explicit PairNumbers(Memory* memory) : numbers_(memory) {}

    template <class Next>
    uint32_t number(uint32_t a, uint32_t b, Next next) {
        const auto [found, is_new] = numbers_.try_emplace({a, b}, 0);
        if (is_new) found->second = next();
        return found->second;
    }

private:
    std::pmr::map<std::pair<uint32_t, uint32_t>, uint32_t> numbers_;
};

uint32_t group_of_part(LeafRules rules, uint32_t part) {
    switch (rules.grouping) {
        case FLG_TANGLE_GROUPING_TWO: return part % 2;
        case FLG_TANGLE_GROUPING_CYCLE: return part % rules.cycle;
        default: return 0;
    }
}

}  // namespace

Task<Buffer<RegionId>> add_leaves(Pace& pace, RegionTree& tree, TreeEdit& edit, const Buffer<NewLeaf>& leaves,
                                  LeafRules rules) {
    const uint32_t first = tree.size();
    if (first + uint64_t{leaves.size()} > uint64_t{FLG_REGION_MAX} + 1) {
        throw Failure(FLG_ERROR_LIMIT, "%zu more regions beside %u are too many, the largest identifier is %u",
                      leaves.size(), first, FLG_REGION_MAX);
    }
    const Groups by_parent =
        co_await group_by(pace, leaves.size(), first, [&](uint32_t i) { return leaves[i].parent; });
    PairNumbers groups(pace.memory()), looks(pace.memory());
    const uint32_t operation = tree.add_operation();
    Buffer<RegionId> regions(leaves.size(), pace.memory());
    co_await each(pace, leaves.size(), Cost::hundreds_of_ns, [&](uint32_t n) {
        const uint32_t i = by_parent.items[n];
        const NewLeaf& leaf = leaves[i];
        RegionNode node;
        node.operation = operation;
        node.part = leaf.part;
        node.scaffold = rules.scaffold;
        const uint32_t look = tree[leaf.parent].look;
        node.look = rules.scaffold ? look : looks.number(look, leaf.part, [&] { return tree.add_look(); });
        if (rules.grouping == FLG_TANGLE_GROUPING_EACH) {
            node.group = tree.add_group();
        } else {
            node.group = groups.number(tree.visible_group(leaf.parent), group_of_part(rules, leaf.part),
                                       [&] { return tree.add_group(); });
        }
        regions[i] = tree.add_child(edit, leaf.parent, node);
    });
    co_return regions;
}

namespace {

// What an operator looks at: where it acts.
struct Scene {
    Surface& surface;
    const LeafSet& leaves;
    const DivideRequest& request;
    uint32_t revision;
};

// Sec. 3.2: distances from a or, with b, the blend between them.
Task<void> solve_or_blend(Pace& pace, Tangle& tangle, const Scene& scene, FieldExtent extent, DistanceField& field) {
    pace.stage("field");
    co_await solve_seeds(pace, tangle.tree, tangle.surface, scene.leaves, scene.request.a, "desc.a",
                         scene.request.perturbation(), FieldKind{extent, false}, field);
    if (scene.request.b.empty()) co_return;
    DistanceField other;
    co_await solve_seeds(pace, tangle.tree, tangle.surface, scene.leaves, scene.request.b, "desc.b",
                         scene.request.perturbation(), FieldKind{extent, false}, other);
    co_await each_value(pace, field, Cost::some_ns,
                        [&](uint32_t v) { field.distances[v] = blend(field.distances[v], other.distances[v]); });
}

// What becomes of a partition's components: leaves, specks going with those beside them.
struct Division {
    Buffer<NewLeaf> leaves;
    Buffer<uint32_t> leaf_of;  // each component
    bool divides = false;      // there are two parts at least
};

// `components`: as leaves, each its own.
Task<Division> divide_components(Pace& pace, const Tangle& tangle, const RegionPartition& partition,
                                 const Buffer<NewLeaf>& components) {
    Buffer<uint32_t> parents(components.size(), pace.memory());
    co_await each(pace, parents.size(), Cost::some_ns, [&](uint32_t c) { parents[c] = components[c].parent; });
    Division division;
    division.leaf_of = co_await merge_specks(pace, partition, parents, tangle.least_area);
    Buffer<uint32_t> numbers(components.size(), pace.memory());  // of those that become leaves
    uint32_t count = 0;
    co_await each(pace, numbers.size(), Cost::some_ns,
                  [&](uint32_t c) { numbers[c] = division.leaf_of[c] == c ? count++ : no_index; });
    division.leaves = Buffer<NewLeaf>(count, pace.memory());
    co_await each(pace, numbers.size(), Cost::some_ns, [&](uint32_t c) {
        if (numbers[c] != no_index) division.leaves[numbers[c]] = components[c];
        division.leaf_of[c] = numbers[division.leaf_of[c]];
    });
    co_await each(pace, count, Cost::some_ns,
                  [&](uint32_t i) { division.divides |= division.leaves[i].part != division.leaves[0].part; });
    co_return division;
}

// Makes the leaves and labels the triangles with them.
Task<void> make_leaves(Pace& pace, Tangle& tangle, const Scene& scene, const RegionPartition& partition,
                       const Division& division, MeshEdit& edit, TreeEdit& tree_edit) {
    const RegionId first = tangle.tree.size();
    const LeafRules rules{scene.request.desc.grouping, scene.request.desc.cycle, scene.request.desc.scaffold != 0};
    const Buffer<RegionId> regions = co_await add_leaves(pace, tangle.tree, tree_edit, division.leaves, rules);
    Mesh& mesh = scene.surface.mesh();
    RegionCursor cursor(mesh, partition.leaves);
    co_await RegionBlocks::restart(pace, mesh.region_blocks, first);
    co_await each_within(pace, cursor, Cost::tens_of_ns, [&](uint32_t t) {
        const RegionId region = regions[division.leaf_of[partition.component_of(t)]];
        mesh.region_blocks.add(region, t);  // also where it is the label of the cut
        edit.set_region(mesh, t, region);
    });
}

// ---- Contours

// While it is cut, leaf i of the list has the labels first + i * (levels + 1) and up, one a band between levels.
Task<void> cut_contours(Pace& pace, Tangle& tangle, const Scene& scene, const DistanceField& field, TangleStep& step) {
    LevelRequest asked;
    asked.count = scene.request.desc.count;
    asked.first = asked.every = scene.request.desc.delta;
    const Buffer<float> levels = co_await list_levels(pace, field, asked, max_cut_levels);
    const auto bands = static_cast<uint32_t>(levels.size() + 1);
    const uint32_t first = tangle.tree.size();
    const uint64_t end = first + uint64_t{scene.leaves.list.size()} * bands;
    if (end > uint64_t{FLG_REGION_MAX} + 1) {
        throw Failure(FLG_ERROR_LIMIT, "%zu leaves with %u bands each are too many", scene.leaves.list.size(), bands);
    }
    Buffer<RegionLevels> labels(scene.leaves.list.size(), pace.memory());
    co_await each(pace, labels.size(), Cost::some_ns, [&](uint32_t i) {
        labels[i] = {scene.leaves.list[i], first + i * bands};
    });
    Buffer<uint32_t> band_labels(end - first, pace.memory());
    co_await each(pace, band_labels.size(), Cost::some_ns, [&](uint32_t i) { band_labels[i] = first + i; });
    GrowingBuffer<float> values(field.distances.size(), pace.memory());
    co_await each_value(pace, field, Cost::some_ns,
                        [to = values.data(), from = field.distances.data()](uint32_t v) { to[v] = from[v]; });

    pace.stage("cut");
    pace.commit();
    MeshEdit& edit = step.edit.emplace(pace.memory());
    edit.begin(scene.surface.mesh());
    {
        const ExtraColumn column(scene.surface.columns, std::move(values));
        const CutLevels cut_levels({levels.data(), levels.size()}, {labels.data(), labels.size()});
        co_await embed_isolines(pace, scene.surface.mesh(), scene.surface.columns, column.index(), cut_levels, edit);
    }
    pace.stage("regions");
    const RegionSet cut(band_labels.data(), static_cast<uint32_t>(band_labels.size()), pace.memory());
    const std::pmr::deque<Corner> no_edges(pace.memory());
    const RegionPartition partition = co_await partition_regions(pace, scene.surface.mesh(), cut, no_edges);
    Buffer<NewLeaf> components(partition.components.size(), pace.memory());
    co_await each(pace, components.size(), Cost::tens_of_ns, [&](uint32_t c) {
        const uint32_t label = partition.components[c].label - first;
        components[c] = {scene.leaves.list[label / bands], label % bands};
    });
    const Division division = co_await divide_components(pace, tangle, partition, components);
    if (!division.divides) {
        pace.settle();
        MeshEditReplay back(scene.surface.mesh(), scene.surface.columns, edit, MeshEditReplay::Direction::abandon);
        while (!back.run(2 * static_cast<uint32_t>(Cost::some_ns))) co_await pace;
        step.edit.reset();
        co_return;
    }
    const size_t of_cut = edit.labels().size();
    co_await make_leaves(pace, tangle, scene, partition, division, edit, step.tree);
    co_await forget_passing_labels(pace, scene.surface.mesh(), of_cut, edit);
    co_await update_after_edit(pace, scene.surface, edit, scene.revision);
}

// ---- Curves

// The part to the left of the edge between two vertices; no_index if that is none of the regions', or there is no
// such edge.
uint32_t part_left_of(const RegionPartition& partition, uint32_t from, uint32_t to) {
    const Mesh& mesh = partition.mesh;
    // The corner of the edge's first vertex that its second one follows.
    const Corner begin = mesh.corner_of_vertex[from];
    Corner corner = begin;
    do {
        if (mesh.vertex_at(next_corner(corner)) == to) break;
        corner = mesh.turn(corner);
    } while (corner != begin && corner != no_index);
    if (corner == no_index || !partition.is_within(triangle_of(corner))) return no_index;
    return partition.components[partition.component_of(triangle_of(corner))].part;
}

// body(curve, vertex, next vertex) for every edge of curves as they were embedded; each is some hundreds of ns.
template <class Body>
Task<void> each_edge(Pace& pace, const SurfaceCurves& curves, const EmbeddedCurves& embedded, Body body) {
    uint32_t c = 0;
    co_await each(pace, embedded.vertices.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
        while (i == embedded.offsets[c + 1]) ++c;
        const bool last = i + 1 == embedded.offsets[c + 1];
        if (last && !curves.closed[c]) return;
        body(c, embedded.vertices[i], embedded.vertices[last ? embedded.offsets[c] : i + 1]);
    });
}

// Strips between streams: the part to the left of curve c has the number c + 1, what no curve has to its left 0.
// Parts to the left of several curves go by the first.
Task<void> number_strips(Pace& pace, const SurfaceCurves& curves, uint32_t stream_count, const EmbeddedCurves& embedded,
                         const RegionPartition& partition, Buffer<uint32_t>& numbers) {
    co_await each_edge(pace, curves, embedded, [&](uint32_t c, uint32_t from, uint32_t to) {
        if (c >= stream_count) return;
        const uint32_t part = part_left_of(partition, from, to);
        if (part != no_index && numbers[part] == 0) numbers[part] = c + 1;
    });
}

// Sides of lines: 0 for parts of whose border more metres have them to their left than to their right, else 1. So a
// spike or a small loop the wrong way round does not count.
Task<void> number_sides(Pace& pace, const SurfaceCurves& curves, const EmbeddedCurves& embedded,
                        const RegionPartition& partition, Buffer<uint32_t>& numbers) {
    const Mesh& mesh = partition.mesh;
    Buffer<double> left(numbers.size(), pace.memory());
    co_await each(pace, left.size(), Cost::some_ns, [&](uint32_t p) { left[p] = 0; });
    co_await each_edge(pace, curves, embedded, [&](uint32_t, uint32_t from, uint32_t to) {
        const double length = (mesh.position(to) - mesh.position(from)).norm();
        const uint32_t at_left = part_left_of(partition, from, to);
        const uint32_t at_right = part_left_of(partition, to, from);
        if (at_left != no_index) left[at_left] += length;
        if (at_right != no_index) left[at_right] -= length;
    });
    co_await each(pace, numbers.size(), Cost::some_ns, [&](uint32_t p) { numbers[p] = left[p] > 0 ? 0 : 1; });
}

// One number a part: of strips, of sides, or by their order.
Task<Buffer<uint32_t>> number_parts(Pace& pace, const Scene& scene, const SurfaceCurves& curves, uint32_t stream_count,
                                    const EmbeddedCurves& embedded, const RegionPartition& partition) {
    const bool strips = scene.request.desc.kind == FLG_TANGLE_OPERATOR_STREAM;
    Buffer<uint32_t> numbers(partition.part_count, pace.memory());
    co_await each(pace, numbers.size(), Cost::some_ns, [&](uint32_t p) { numbers[p] = strips ? 0 : p; });
    if (strips) co_await number_strips(pace, curves, stream_count, embedded, partition, numbers);
    if (scene.request.desc.kind == FLG_TANGLE_OPERATOR_POLYLINE && scene.request.a.curves) {
        co_await number_sides(pace, curves, embedded, partition, numbers);
    }
    co_return numbers;
}

// `stream_count`: of the curves, those that part strips.
Task<void> cut_along(Pace& pace, Tangle& tangle, const Scene& scene, const SurfaceCurves& curves, uint32_t stream_count,
                     TangleStep& step) {
    if (curves.curve_count() == 0) co_return;
    pace.stage("cut");
    pace.commit();
    const Mesh& mesh = scene.surface.mesh();
    MeshEdit& edit = step.edit.emplace(pace.memory());
    edit.begin(mesh);
    EmbeddedCurves embedded(pace.memory());
    co_await embed_curves(pace, scene.surface.mesh(), scene.surface.columns, curves, edit, embedded);
    pace.stage("regions");
    // Streams of each leaf's borders stay in it.
    const bool of_each =
        scene.request.desc.kind == FLG_TANGLE_OPERATOR_STREAM && scene.request.a.borders == FLG_TANGLE_BORDERS_EACH;
    const RegionPartition partition = co_await partition_regions(pace, mesh, scene.leaves.set, embedded.edges,
                                                                 of_each ? Parts::within_leaves : Parts::across_leaves);
    const Buffer<uint32_t> numbers = co_await number_parts(pace, scene, curves, stream_count, embedded, partition);
    if (partition.part_count > 1) {
        Buffer<NewLeaf> components(partition.components.size(), pace.memory());
        co_await each(pace, components.size(), Cost::tens_of_ns, [&](uint32_t c) {
            const RegionComponent& component = partition.components[c];
            components[c] = {component.label, numbers[component.part]};
        });
        const Division division = co_await divide_components(pace, tangle, partition, components);
        co_await make_leaves(pace, tangle, scene, partition, division, edit, step.tree);
    }
    co_await update_after_edit(pace, scene.surface, edit, scene.revision);
}

Task<void> trace_cells(Pace& pace, Tangle& tangle, const Scene& scene, SurfaceCurves& curves) {
    pace.stage("field");
    DistanceField cells;
    co_await solve_seeds(pace, tangle.tree, tangle.surface, scene.leaves, scene.request.a, "desc.a",
                         scene.request.perturbation(), FieldKind{FieldExtent::local, true}, cells);
    pace.stage("cells");
    curves = co_await voronoi_borders(pace, scene.surface.mesh(), scene.leaves.set, cells);
}

Task<void> trace_shortest_ways(Pace& pace, const Scene& scene, SurfaceCurves& curves) {
    const Buffer<SurfacePoint>& points = scene.request.a.points;
    RegionSet bound = scene.leaves.set;
    Buffer<uint32_t> offsets(2, pace.memory());
    offsets[0] = 0;
    offsets[1] = static_cast<uint32_t>(points.size());
    Buffer<SurfacePoint> copies(points.size(), pace.memory());
    co_await each(pace, points.size(), Cost::some_ns, [&](uint32_t i) { copies[i] = points[i]; });
    const Paths paths{.offsets = std::move(offsets),
                      .points = std::move(copies),
                      .closed = scene.request.desc.closed != 0,
                      .regions = std::move(bound)};
    co_await trace_polylines(pace, scene.surface, paths, "desc.a.points", curves);
}

// The piece of a line that runs within regions, while it grows.
class LinePiece {
public:
    LinePiece(const Mesh& mesh, const SurfaceCurves& lines, SurfaceCurves& out)
        : mesh_(mesh), lines_(lines), out_(out) {}

    void add(uint32_t point) {
        out_.points.push_back(lines_.points[point]);
        triangle_ = lines_.points[point].triangle;
    }
    // The last point is one of the last stretch's triangle.
    void end(uint32_t line, uint32_t last) {
        if (out_.points.size() == out_.offsets.back()) return;
        SurfacePoint end = lines_.points[last];
        if (end.triangle != triangle_) find_in(mesh_, place_in(mesh_, end.triangle, weights_of(end)), triangle_, end);
        out_.points.push_back(end);
        close(line, false);
    }
    void close(uint32_t line, bool closed) {
        out_.offsets.push_back(static_cast<uint32_t>(out_.points.size()));
        out_.closed.push_back(closed);
        out_.values.push_back(lines_.values[line]);
    }

private:
    const Mesh& mesh_;
    const SurfaceCurves& lines_;
    SurfaceCurves& out_;
    uint32_t triangle_ = 0;  // of the last stretch
};

// Adds the parts of lines that run within regions. A closed line that stays within stays closed; others begin and end
// where they come in and go out.
Task<void> add_lines_within(Pace& pace, const Mesh& mesh, const RegionSet& regions, const SurfaceCurves& lines,
                            SurfaceCurves& out) {
    LinePiece piece(mesh, lines, out);
    Slice slice(Cost::tens_of_ns);
    for (uint32_t line = 0; line < lines.curve_count(); ++line) {
        const uint32_t first = lines.offsets[line], end = lines.offsets[line + 1];
        const bool closed = lines.closed[line];
        bool all_within = true;
        for (uint32_t i = first; i + (closed ? 0 : 1) < end; ++i) {  // the stretch from a point to the next
            if (regions.contains(mesh.regions[lines.points[i].triangle])) {
                piece.add(i);
            } else {
                all_within = false;
                piece.end(line, i);
            }
            if (slice.is_over()) co_await pace;
        }
        if (closed && all_within) {
            piece.close(line, true);
        } else {
            piece.end(line, closed ? first : end - 1);
        }
        if (slice.is_over()) co_await pace;
    }
}

// Between points, and along lines.
Task<void> trace_polyline(Pace& pace, const Scene& scene, SurfaceCurves& curves) {
    const TangleSeeds& a = scene.request.a;
    if (!a.points.empty()) co_await trace_shortest_ways(pace, scene, curves);
    if (a.curves) co_await add_lines_within(pace, scene.surface.mesh(), scene.leaves.set, a.curves->curves, curves);
}

}  // namespace

Task<void> divide_regions(Pace& pace, Tangle& tangle, const DivideRequest& request, uint32_t revision,
                          TangleStep& step) {
    const LeafSet leaves = co_await list_leaves(pace, tangle.tree, request.regions, "desc.regions");
    const Scene scene{*tangle.surface, leaves, request, revision};
    if (request.desc.kind == FLG_TANGLE_OPERATOR_CONTOUR) {
        DistanceField field;
        co_await solve_or_blend(pace, tangle, scene, FieldExtent::local, field);
        co_await cut_contours(pace, tangle, scene, field, step);
        co_return;
    }
    SurfaceCurves curves(pace.memory());
    if (request.desc.kind == FLG_TANGLE_OPERATOR_STREAM) {
        DistanceField field;
        co_await solve_or_blend(pace, tangle, scene, FieldExtent::whole, field);
        StreamLines lines = co_await trace_streams(pace, tangle, leaves, request, field);
        co_await cut_along(pace, tangle, scene, lines.curves, lines.stream_count, step);
        co_return;
    }
    if (request.desc.kind == FLG_TANGLE_OPERATOR_VORONOI) co_await trace_cells(pace, tangle, scene, curves);
    if (request.desc.kind == FLG_TANGLE_OPERATOR_POLYLINE) co_await trace_polyline(pace, scene, curves);
    co_await cut_along(pace, tangle, scene, curves, 0, step);
}

}  // namespace flg
