// SPDX-License-Identifier: MIT
#include "tangles/tangle_displacement.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "surfaces/geodesic_jobs.h"
#include "surfaces/mesh/fan_walk.h"
#include "surfaces/mesh/marks.h"
#include "surfaces/mesh/mesh_measures.h"
#include "surfaces/surface_update.h"
#include "tangles/room_work.h"

namespace flg {

namespace {

// How much of the largest distance a crease in it is rounded by, and how much of the height what normals show is
// smoothed by: in metres, from the sharpest to what is gone.
constexpr double rounded_distance = 0.06, smoothed_height = 0.5;
constexpr uint32_t least_sweeps = 2, most_sweeps = 12;
// Rounds in which heights are lowered where a triangle would turn over, and less beside it.
constexpr uint32_t most_rounds = 60;
constexpr float lowered = 0.75f;
// Of a triangle's area, that must be left seen from where it was. Slivers, and what lies on its side between smoothed
// normals, are left alone: nobody sees them turn, but the pit they would make.
constexpr double upright_area = 0.02, upright_normal = 0.5, sliver = 0.15;

// Four values of a vertex.
using Four = float __attribute__((vector_size(16)));

// The vertices of leaves and the edges between them, in few arrays: for values that are smoothed over regions many
// times. Neighbours in space are neighbours in memory, and nothing lies outside.
struct LeafGraph {
    LeafGraph(const GeodesicBlocks& of_blocks, Memory* memory)
        : blocks(of_blocks), marks((size_t{of_blocks.rank_count()} + 63) / 64, memory), before(marks.size(), memory) {}

    size_t size() const { return vertices.size(); }
    // Where a vertex of the leaves stands.
    uint32_t place_of(uint32_t vertex) const {
        const uint32_t rank = blocks.rank_of_vertex[vertex], word = rank / 64;
        const uint64_t below = marks[word] & ((uint64_t{1} << rank % 64) - 1);
        return before[word] + static_cast<uint32_t>(std::popcount(below));
    }

    bool has(uint32_t vertex) const {
        const uint32_t rank = blocks.rank_of_vertex[vertex];
        return (marks[rank / 64] >> rank % 64 & 1) != 0;
    }

    const GeodesicBlocks& blocks;
    Buffer<uint64_t> marks;   // a bit a rank
    Buffer<uint32_t> before;  // how many are marked in the words before
    Buffer<uint32_t> vertices;
    // Each one's normal, as in mesh/chord_normal.h, and 0.
    Buffer<Four> normals;
    // By their weights (Floater: Mean value coordinates, 2003) neighbours in a plane have the vertex as their mean.
    struct Neighbour {
        uint32_t place;
        float weight;  // their sum: 1
    };
    Buffer<uint32_t> offsets;  // of each one's neighbours, and of the end
    GrowingBuffer<Neighbour> neighbours;
};

// A vertex's neighbours and its normal.
void add_neighbours(const Mesh& mesh, uint32_t place, LeafGraph& graph) {
    constexpr double steepest = 20;  // tangent of half an angle: flat triangles are no reason to follow one neighbour
    const uint32_t vertex = graph.vertices[place];
    const Vec3 centre = mesh.position(vertex);
    auto& neighbours = graph.neighbours;
    const size_t begin = neighbours.size();
    Vec3 normal = Vec3::Zero(), before = Vec3::Zero();
    double length_before = 0, sum = 0;
    uint32_t first = no_index;
    size_t at = no_index, at_before = no_index;  // of the neighbour, and of the one before; no_index: not of the leaves
    const auto add_weight = [&](size_t to, double weight) {
        constexpr double most = 1e30;  // of an edge that has next to no length
        if (to == no_index || !std::isfinite(weight)) return;
        weight = std::min(weight, most);
        neighbours[to].weight += static_cast<float>(weight);
        sum += weight;
    };
    visit_fan(mesh, vertex, [&](uint32_t neighbour, Corner opposite) {
        const Vec3 edge = mesh.position(neighbour) - centre;
        const double length = edge.norm();
        if (neighbour == first) {
            at = begin < neighbours.size() && graph.has(first) ? begin : no_index;
        } else {
            at = no_index;
            if (graph.has(neighbour) && neighbours.size() < neighbours.capacity()) {
                at = neighbours.size();
                neighbours.push_back({graph.place_of(neighbour), 0});
            }
        }
        if (opposite == no_index) {
            first = neighbour;
        } else {
            const double product = length_before * length, rest = product + before.dot(edge);
            const Vec3 across = before.cross(edge);
            const double size = across.norm();
            if (product * rest > 0) normal += across / std::sqrt(product * rest);
            const double tangent = size > steepest * rest ? steepest : rest > 0 ? size / rest : 0.0;
            add_weight(at_before, tangent / length_before);
            add_weight(at, tangent / length);
        }
        before = edge;
        length_before = length;
        at_before = at;
    });
    const Vec3 unit = normal.stableNormalized();
    graph.normals[place] =
        Four{static_cast<float>(unit.x()), static_cast<float>(unit.y()), static_cast<float>(unit.z()), 0};
    const float equal = 1 / static_cast<float>(std::max<size_t>(neighbours.size() - begin, 1));
    for (size_t n = begin; n < neighbours.size(); ++n)
        neighbours[n].weight = sum > 0 ? neighbours[n].weight / static_cast<float>(sum) : equal;
}

// `blocks`: the surface's. Of more than 4096 neighbours the first count. About 0.1 us a vertex, 40 bytes.
Task<LeafGraph> make_leaf_graph(Pace& pace, const Mesh& mesh, const GeodesicBlocks& blocks, const RegionSet& leaves) {
    LeafGraph graph(blocks, pace.memory());
    Buffer<uint64_t>& words = graph.marks;
    co_await each(pace, words.size(), Cost::some_ns, [&](uint32_t word) { words[word] = 0; });
    RegionCursor cursor(mesh, leaves);
    co_await repeat(pace, Cost::tens_of_ns, [&] {
        const uint32_t triangle = cursor.next();
        if (triangle == no_index) return !cursor.at_end();
        for (const uint32_t vertex : mesh.triangles[triangle]) {
            const uint32_t rank = blocks.rank_of_vertex[vertex];
            words[rank / 64] |= uint64_t{1} << rank % 64;
        }
        return true;
    });
    uint32_t count = 0;
    co_await each(pace, words.size(), Cost::some_ns, [&](uint32_t word) {
        graph.before[word] = count;
        count += static_cast<uint32_t>(std::popcount(words[word]));
    });
    graph.vertices = Buffer<uint32_t>(count, pace.memory());
    graph.offsets = Buffer<uint32_t>(count + size_t{1}, pace.memory());
    co_await each(pace, words.size(), Cost::tens_of_ns, [&](uint32_t word) {
        uint32_t place = graph.before[word];
        for (uint64_t left = words[word]; left != 0; left &= left - 1)
            graph.vertices[place++] = blocks.vertex_of_rank[64 * word + static_cast<uint32_t>(std::countr_zero(left))];
    });
    graph.normals = Buffer<Four>(count, pace.memory());
    // It grows where vertices have more.
    graph.neighbours = GrowingBuffer<LeafGraph::Neighbour>(size_t{7} * count, pace.memory());
    graph.neighbours.resize(0);
    constexpr size_t most_at_once = 4096;
    Slice slice(Cost::hundreds_of_ns);
    for (uint32_t place = 0; place < count; ++place) {
        if (place % fans_fetched == 0) {
            const uint32_t* const vertices = &graph.vertices[place];
            fetch_fans(
                mesh, [=](uint32_t k) { return vertices[k]; }, count - place,
                [&](uint32_t vertex) __attribute__((always_inline)) {
                    __builtin_prefetch(&blocks.rank_of_vertex[vertex]);
                    __builtin_prefetch(&mesh.positions[vertex]);
                });
        }
        graph.offsets[place] = static_cast<uint32_t>(graph.neighbours.size());
        add_neighbours(mesh, place, graph);
        if (graph.neighbours.capacity() - graph.neighbours.size() < most_at_once) {
            graph.neighbours.begin_growth(graph.neighbours.capacity() * 5 / 4 + 2 * most_at_once);
            while (!graph.neighbours.grow(most_at_once)) co_await pace;
        }
        if (slice.is_over()) co_await pace;
    }
    graph.offsets[count] = static_cast<uint32_t>(graph.neighbours.size());
    co_return graph;
}

[[gnu::noinline]] void sweep(const LeafGraph& graph, const Marks& fixed, const Four& strength, const Four& relaxation,
                             const Four* before, const Four* values, Four* result, uint32_t begin, uint32_t end) {
    const Four share = 1.0f / (1.0f + strength);
    for (uint32_t i = begin; i < end; ++i) {
        const uint32_t first = graph.offsets[i], last = graph.offsets[i + 1];
        Four sum = {};
        for (uint32_t n = first; n < last; ++n) sum += graph.neighbours[n].weight * values[graph.neighbours[n].place];
        const Four mean = last > first ? sum : values[i];
        const Four next = (before[i] + strength * mean) * share;
        Four relaxed = relaxation * (next - result[i]) + result[i];
        if (fixed.has(i)) relaxed[3] = before[i][3];
        result[i] = relaxed;
    }
}

// Smooths values as heat does in a short time: those that solve x - strength (mean of neighbours - x) = x before, up to
// some percent, by Chebyshev's iteration on Jacobi's (Golub, Varga: Chebyshev semi-iterative methods, 1961). What is
// smaller than about sqrt(strength) / 2 edges is gone. `strength`: of each of the four, below 0.8 sweeps^2. Those in
// `fixed` keep their last one. About 15 ns a vertex and sweep.
Task<void> smooth(Pace& pace, const LeafGraph& graph, const Marks& fixed, Four strength, uint32_t sweeps,
                  Buffer<Four>& values) {
    Buffer<Four> before(values.size(), pace.memory()), other(values.size(), pace.memory());
    co_await each(pace, values.size(), Cost::some_ns, [&](uint32_t i) { before[i] = other[i] = values[i]; });
    const Four radius = strength / (1.0f + strength), square = radius * radius;
    Four relaxation = {1, 1, 1, 1};
    for (uint32_t k = 0; k < sweeps; ++k) {
        if (k == 1) relaxation = 1.0f / (1.0f - square / 2.0f);
        if (k > 1) relaxation = 1.0f / (1.0f - square * relaxation / 4.0f);
        constexpr uint32_t step = 256;
        for (uint32_t begin = 0; begin < values.size(); begin += step) {
            const auto end = static_cast<uint32_t>(std::min(values.size(), size_t{begin} + step));
            sweep(graph, fixed, strength, relaxation, before.data(), values.data(), other.data(), begin, end);
            co_await pace;
        }
        std::swap(values, other);
    }
}

// The largest distance from its borders in each leaf, by label. `distance_at(vertex)`: not below 0.
template <class DistanceAt>
Task<Buffer<float>> measure_leaves(Pace& pace, const Mesh& mesh, const RegionSet& leaves, uint32_t label_count,
                                   DistanceAt distance_at) {
    Buffer<float> largest(label_count, pace.memory());
    co_await each(pace, label_count, Cost::some_ns, [&](uint32_t label) { largest[label] = 0; });
    co_await each_within(pace, mesh, leaves, Cost::tens_of_ns, [&](uint32_t t) {
        float& of_leaf = largest[mesh.regions[t]];
        for (const uint32_t vertex : mesh.triangles[t]) {
            of_leaf = std::max(of_leaf, distance_at(vertex));
        }
    });
    co_return largest;
}

// Of the leaves' vertices: their normals and, last, their distances from the borders; those that stay where they are.
struct Relief {
    Relief(LeafGraph of_graph, Memory* memory)
        : graph(std::move(of_graph)), values(graph.size(), memory), fixed(graph.size(), memory) {}

    LeafGraph graph;
    Buffer<Four> values;
    Marks fixed;
};

Vec3 direction(const Four& values) {
    return Vec3(values[0], values[1], values[2]);
}

// Its ridges are rounded and its normals smoothed; both to widths in metres.
Task<Relief> make_relief(Pace& pace, Surface& surface, const LeafSet& leaves, const DistanceField& field,
                         double distance_width, double normal_width) {
    const Mesh& mesh = surface.mesh();
    const GeodesicBlocks& blocks = blocks_of(surface);
    Relief relief(co_await make_leaf_graph(pace, mesh, blocks, leaves.set), pace.memory());
    co_await each(pace, relief.fixed.words().size(), Cost::some_ns,
                  [&](uint32_t word) { relief.fixed.words()[word] = 0; });
    co_await each(pace, relief.graph.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
        const uint32_t vertex = relief.graph.vertices[i];
        const float distance = field.distances[vertex];
        const bool is_inside = distance > 0 && std::isfinite(distance);
        if (!is_inside) relief.fixed.set(i);
        relief.values[i] = relief.graph.normals[i];
        relief.values[i][3] = is_inside ? distance : 0.0f;
    });
    // A strength of 4 takes away what is smaller than an edge.
    const double edge = blocks.edges.mean(), most = most_sweeps * most_sweeps / 4.0;
    const auto strength = [=](double width) { return std::min(4 * (width / edge) * (width / edge), most); };
    const double of_normals = strength(normal_width), of_distances = strength(distance_width);
    const double largest = std::max(of_normals, of_distances);
    const uint32_t sweeps =
        std::clamp(static_cast<uint32_t>(std::ceil(2 * std::sqrt(largest))), least_sweeps, most_sweeps);
    const auto n = static_cast<float>(of_normals), d = static_cast<float>(of_distances);
    co_await smooth(pace, relief.graph, relief.fixed, Four{n, n, n, d}, sweeps, relief.values);
    co_await each(pace, relief.graph.size(), Cost::tens_of_ns, [&](uint32_t i) {
        Four& values = relief.values[i];
        const Vec3 unit = direction(values).stableNormalized();
        values =
            Four{static_cast<float>(unit.x()), static_cast<float>(unit.y()), static_cast<float>(unit.z()), values[3]};
    });
    co_return relief;
}

// Lowers heights until no triangle turns over.
Task<void> keep_upright(Pace& pace, const Mesh& mesh, const RegionSet& leaves, const Relief& relief,
                        Buffer<float>& heights) {
    Marks turned = co_await no_marks(pace, heights.size());
    for (uint32_t round = 0; round < most_rounds; ++round) {
        bool any = false;
        co_await each_within(pace, mesh, leaves, Cost::hundreds_of_ns, [&](uint32_t t) {
            const std::array<uint32_t, 3> places = {relief.graph.place_of(mesh.triangles[t][0]),
                                                    relief.graph.place_of(mesh.triangles[t][1]),
                                                    relief.graph.place_of(mesh.triangles[t][2])};
            std::array<Vec3, 3> moved;
            Vec3 upwards = Vec3::Zero();
            for (uint32_t k = 0; k < 3; ++k) {
                const Vec3 normal = direction(relief.values[places[k]]);
                upwards += normal;
                moved[k] = mesh.position(mesh.triangles[t][k]) + double{heights[places[k]]} * normal;
            }
            const Vec3 own = 2 * vector_area(mesh, t), area = (moved[1] - moved[0]).cross(moved[2] - moved[0]);
            if (area.dot(own) >= upright_area * own.squaredNorm()) return;
            double longest = 0;  // edge, squared
            for (uint32_t k = 0; k < 3; ++k) {
                const Vec3 edge = mesh.position(mesh.triangles[t][k]) - mesh.position(mesh.triangles[t][(k + 1) % 3]);
                longest = std::max(longest, edge.squaredNorm());
            }
            if (own.norm() < sliver * longest || own.dot(upwards) < upright_normal * own.norm() * upwards.norm())
                return;
            any = true;
            for (const uint32_t place : places) turned.set(place);
        });
        if (!any) co_return;
        co_await each(pace, heights.size(), Cost::tens_of_ns, [&](uint32_t i) {
            if (heights[i] == 0) return;
            float share = 0;  // of the neighbours that turned
            for (uint32_t n = relief.graph.offsets[i]; n < relief.graph.offsets[i + 1]; ++n) {
                if (turned.has(relief.graph.neighbours[n].place)) share += relief.graph.neighbours[n].weight;
            }
            heights[i] *= turned.has(i) ? lowered : 1 - share * (1 - lowered);
        });
        co_await each(pace, turned.words().size(), Cost::some_ns, [&](uint32_t w) { turned.words()[w] = 0; });
    }
}

}  // namespace

double schlick_bias(double t, double bias) {
    return t / ((1 / bias - 2) * (1 - t) + 1);
}

double schlick_gain(double t, double gain) {
    const double slope = (1 / gain - 2) * (1 - 2 * t);
    return t < 0.5 ? t / (slope + 1) : (slope - t) / (slope - 1);
}

Task<void> displace_regions(Pace& pace, Tangle& tangle, const DisplaceRequest& request, uint32_t revision,
                            TangleStep& step) {
    const FlgTangleDisplaceDesc& desc = request.desc;
    Surface& surface = *tangle.surface;
    Mesh& mesh = surface.mesh();
    pace.stage("field");
    const LeafSet leaves = co_await list_leaves(pace, tangle.tree, request.regions, "desc.regions");
    TangleSeeds borders(pace.memory());
    borders.borders = FLG_TANGLE_BORDERS_EACH;
    DistanceField field;
    co_await solve_seeds(pace, tangle.tree, tangle.surface, leaves, borders, "desc.regions", {},
                         FieldKind{FieldExtent::local, false}, field);

    pace.stage("displace");
    const auto distance_at = [&](uint32_t vertex) {
        const float distance = field.distances[vertex];
        return std::isfinite(distance) ? distance : 0.0f;
    };
    const Buffer<float> furthest = co_await measure_leaves(pace, mesh, leaves.set, tangle.tree.size(), distance_at);
    double typical = 0;  // reach
    co_await each(pace, leaves.list.size(), Cost::some_ns, [&](uint32_t i) { typical += furthest[leaves.list[i]]; });
    typical /= static_cast<double>(leaves.list.size());
    if (desc.reach > 0) typical = std::min<double>(typical, desc.reach);
    const Relief relief = co_await make_relief(pace, surface, leaves, field, rounded_distance * typical,
                                               smoothed_height * std::abs(double{desc.amount}));
    const Buffer<float> largest =
        co_await measure_leaves(pace, mesh, leaves.set, tangle.tree.size(),
                                [&](uint32_t vertex) { return relief.values[relief.graph.place_of(vertex)][3]; });
    Buffer<float> heights(relief.graph.size(), pace.memory());
    co_await each(pace, heights.size(), Cost::some_ns, [&](uint32_t i) { heights[i] = 0; });
    co_await each_within(pace, mesh, leaves.set, Cost::tens_of_ns, [&](uint32_t t) {
        const double reach = desc.reach > 0 ? desc.reach : largest[mesh.regions[t]];
        for (const uint32_t vertex : mesh.triangles[t]) {
            const uint32_t i = relief.graph.place_of(vertex);
            if (relief.fixed.has(i) || heights[i] != 0 || !(reach > 0)) continue;
            const double share = std::clamp(relief.values[i][3] / reach, 0.0, 1.0);
            heights[i] = static_cast<float>(desc.amount * schlick_gain(schlick_bias(share, desc.bias), desc.gain));
        }
    });
    co_await keep_upright(pace, mesh, leaves.set, relief, heights);

    pace.commit();
    MeshEdit& edit = step.edit.emplace(pace.memory());
    edit.begin(mesh);
    co_await each(pace, heights.size(), Cost::tens_of_ns, [&](uint32_t i) {
        if (heights[i] == 0) return;
        const uint32_t vertex = relief.graph.vertices[i];
        Position to;
        store_vec3(mesh.position(vertex) + double{heights[i]} * direction(relief.values[i]), to.data());
        edit.set_position(mesh, vertex, to);
    });
    edit.end(mesh);
    co_await update_after_edit(pace, surface, edit, revision);
}

}  // namespace flg
