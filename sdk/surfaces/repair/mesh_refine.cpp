// SPDX-License-Identifier: MIT
#include "surfaces/repair/mesh_refine.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/failure.h"
#include "runtime/each.h"
#include "surfaces/mesh/source_weights.h"

namespace flg {

namespace {

// Edges are numbered by one of their corners: the one of the triangle with the lesser index.
bool is_edge_owner(const Mesh& mesh, Corner corner) {
    return mesh.neighbour_at(corner) > triangle_of(corner);  // no_index is greater, too
}

// ---- Triangles

Task<Mesh> room_for_finer(Pace& pace, const Mesh& coarse) {
    uint32_t border_edges = 0;
    co_await each(pace, coarse.triangle_count(), Cost::some_ns, [&](uint32_t t) {
        for (const uint32_t neighbour : coarse.neighbours[t]) border_edges += neighbour == no_index;
    });
    const size_t triangles = coarse.triangles.size(), edges = (3 * triangles + border_edges) / 2;
    Memory* const memory = pace.memory();
    Mesh fine(memory);
    fine.positions = GrowingBuffer<Position>(coarse.positions.size() + edges, memory);
    fine.corner_of_vertex = GrowingBuffer<uint32_t>(coarse.positions.size() + edges, memory);
    fine.triangles = GrowingBuffer<Triple>(4 * triangles, memory);
    fine.neighbours = GrowingBuffer<Triple>(4 * triangles, memory);
    fine.regions = GrowingBuffer<uint32_t>(4 * triangles, memory);
    if (coarse.source_triangles.size() != 0) fine.source_triangles = GrowingBuffer<uint32_t>(4 * triangles, memory);
    co_return fine;
}

// In rising order: vertices on edges are numbered as their owners come. `next_vertex` is the next of them.
void split(const Mesh& coarse, uint32_t triangle, uint32_t& next_vertex, Mesh& fine) {
    const uint32_t middle = 4 * triangle + 3;
    Triple& halves = fine.triangles[middle];  // the vertices on the edges
    Triple across[3];                         // beyond the first half of each edge, and beyond the second
    for (uint32_t k = 0; k < 3; ++k) {
        const Corner other = coarse.opposite(3 * triangle + k);
        if (is_edge_owner(coarse, 3 * triangle + k)) {
            // The first corner of the new vertex's fan, should this be a border.
            fine.corner_of_vertex[next_vertex] = 3 * (4 * triangle + (k + 1) % 3) + 2;
            halves[k] = next_vertex++;
        } else {
            halves[k] = fine.triangles[4 * triangle_of(other) + 3][other % 3];
        }
        const bool is_open = other == no_index;
        across[k][0] = is_open ? no_index : 4 * triangle_of(other) + next_corner(other) % 3;
        across[k][1] = is_open ? no_index : 4 * triangle_of(other) + other % 3;
    }
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t before = (k + 2) % 3, part = 4 * triangle + k, vertex = coarse.triangles[triangle][k];
        fine.triangles[part] = {vertex, halves[k], halves[before]};
        fine.neighbours[part] = {across[k][0], middle, across[before][1]};
        fine.neighbours[middle][before] = part;
        if (coarse.corner_of_vertex[vertex] == 3 * triangle + k) fine.corner_of_vertex[vertex] = 3 * part;
    }
    for (uint32_t k = 0; k < 4; ++k) {
        fine.regions[4 * triangle + k] = coarse.regions[triangle];
        if (coarse.source_triangles.size() != 0)
            fine.source_triangles[4 * triangle + k] = coarse.source_triangles[triangle];
    }
}

// ---- Values: positions and columns, vertex by vertex

class Blend {
public:
    // Makes `fine_columns`, which is empty. All but `memory` outlive this.
    Blend(const Mesh& coarse, const MeshColumns& columns, Mesh& fine, MeshColumns& fine_columns, Memory* memory)
        : channels_(memory), sums_(memory) {
        channels_.push_back({3, coarse.positions.data()->data(), fine.positions.data()->data()});
        size_t components = 3;
        fine_columns.reserve(columns.size());
        for (const MeshColumn& column : columns) {
            GrowingBuffer<float> values(column.components * fine.positions.size(), memory);
            fine_columns.push_back({column.components, std::move(values), column.of_sources});
            if (column.of_sources) continue;
            channels_.push_back({column.components, column.values.data(), fine_columns.back().values.data()});
            components += column.components;
        }
        sums_.resize(components);
    }

    // What one vertex that is added costs.
    Cost cost() const { return sums_.size() <= 8 ? Cost::tens_of_ns : Cost::hundreds_of_ns; }

    void clear() { std::fill(sums_.begin(), sums_.end(), 0.0); }
    void add(uint32_t vertex, double weight) {
        double* sum = sums_.data();
        for (const Channel& channel : channels_) {
            const float* values = channel.in + size_t{channel.components} * vertex;
            for (uint32_t k = 0; k < channel.components; ++k) *sum++ += weight * double{values[k]};
        }
    }
    void scale(double factor) {
        for (double& sum : sums_) sum *= factor;
    }
    void store(uint32_t vertex) {
        const double* sum = sums_.data();
        for (const Channel& channel : channels_) {
            float* values = channel.out + size_t{channel.components} * vertex;
            for (uint32_t k = 0; k < channel.components; ++k) values[k] = static_cast<float>(*sum++);
        }
    }

private:
    struct Channel {
        uint32_t components;
        const float* in;
        float* out;
    };
    std::pmr::vector<Channel> channels_;  // the position, then the columns
    std::pmr::vector<double> sums_;       // of all channels' components, for the vertex at hand
};

// Where vertices are on the input: those there were where they had been, others halfway, whatever the rule makes of
// their positions.
Task<void> place_on_input(Pace& pace, const Mesh& coarse, const MeshColumn& column, const Mesh& fine,
                          MeshColumn& fine_column) {
    co_await each(pace, coarse.vertex_count(), Cost::some_ns,
                  [&](uint32_t v) { store(load_sources(column, v), fine_column, v); });
    co_await each(pace, size_t{3} * coarse.triangle_count(), Cost::tens_of_ns, [&](uint32_t corner) {
        if (!is_edge_owner(coarse, corner)) return;
        const uint32_t a = coarse.vertex_at(corner), b = coarse.vertex_at(next_corner(corner));
        store(mix(column, {a, b, b}, {0.5, 0.5, 0}), fine_column,
              fine.triangles[4 * triangle_of(corner) + 3][corner % 3]);
    });
}

// Of each neighbour of an inner vertex of so many: Loop, 1987.
double loop_weight(uint32_t valence) {
    const double root = 3.0 / 8 + std::cos(2 * std::numbers::pi / valence) / 4;
    return (5.0 / 8 - root * root) / valence;
}

// Pauses within fans as well: they may be of any length.
Task<void> move_vertices(Pace& pace, const Mesh& coarse, Blend& blend) {
    Slice slice(blend.cost());
    for (uint32_t vertex = 0; vertex < coarse.vertex_count(); ++vertex) {
        const Corner first = coarse.corner_of_vertex[vertex];
        Corner corner = first, last = first;
        uint32_t valence = 0;
        blend.clear();
        do {
            blend.add(coarse.vertex_at(next_corner(corner)), 1);
            ++valence;
            last = corner;
            corner = coarse.turn(corner);
            if (slice.is_over()) co_await pace;
        } while (corner != first && corner != no_index);
        double own_weight;
        if (corner == no_index) {
            // At a border only the neighbours along it count.
            blend.clear();
            blend.add(coarse.vertex_at(next_corner(first)), 1.0 / 8);
            blend.add(coarse.vertex_at(previous_corner(last)), 1.0 / 8);
            own_weight = 3.0 / 4;
        } else {
            const double weight = loop_weight(valence);
            blend.scale(weight);
            own_weight = 1 - weight * valence;
        }
        blend.add(vertex, own_weight);
        blend.store(vertex);
    }
}

void place_on_edge(const Mesh& coarse, Corner corner, RefineRule rule, uint32_t vertex, Blend& blend) {
    const Corner other = coarse.opposite(corner);
    const bool is_smooth = rule == RefineRule::loop && other != no_index;
    const double end_weight = is_smooth ? 3.0 / 8 : 1.0 / 2;
    blend.clear();
    blend.add(coarse.vertex_at(corner), end_weight);
    blend.add(coarse.vertex_at(next_corner(corner)), end_weight);
    if (is_smooth) {
        blend.add(coarse.vertex_at(previous_corner(corner)), 1.0 / 8);
        blend.add(coarse.vertex_at(previous_corner(other)), 1.0 / 8);
    }
    blend.store(vertex);
}

Task<void> place_vertices(Pace& pace, const Mesh& coarse, const Mesh& fine, RefineRule rule, Blend& blend) {
    if (rule == RefineRule::loop) {
        co_await move_vertices(pace, coarse, blend);
    } else {
        co_await each(pace, coarse.vertex_count(), blend.cost(), [&](uint32_t v) {
            blend.clear();
            blend.add(v, 1);
            blend.store(v);
        });
    }
    co_await each(pace, size_t{3} * coarse.triangle_count(), blend.cost(), [&](uint32_t corner) {
        if (!is_edge_owner(coarse, corner)) return;
        place_on_edge(coarse, corner, rule, fine.triangles[4 * triangle_of(corner) + 3][corner % 3], blend);
    });
}

}  // namespace

Task<void> refine_mesh(Pace& pace, Mesh& mesh, MeshColumns& columns, RefineRule rule, uint32_t levels) {
    uint64_t corners = uint64_t{3} * mesh.triangle_count();
    for (uint32_t level = 0; level < levels; ++level) {
        corners *= 4;
        if (corners > max_mesh_corners) {
            throw Failure(FLG_ERROR_LIMIT, "%u triangles refined %u times would be more than the limit of %u",
                          mesh.triangle_count(), levels, max_mesh_corners / 3);
        }
    }
    for (uint32_t level = 0; level < levels; ++level) {
        Mesh fine = co_await room_for_finer(pace, mesh);
        uint32_t next_vertex = mesh.vertex_count();
        co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns,
                      [&](uint32_t t) { split(mesh, t, next_vertex, fine); });
        MeshColumns fine_columns(pace.memory());
        Blend blend(mesh, columns, fine, fine_columns, pace.memory());
        co_await place_vertices(pace, mesh, fine, rule, blend);
        for (size_t c = 0; c < columns.size(); ++c)
            if (columns[c].of_sources) co_await place_on_input(pace, mesh, columns[c], fine, fine_columns[c]);
        std::swap(mesh, fine);
        columns.swap(fine_columns);
        co_await give_back(pace, fine, fine_columns);
    }
}

}  // namespace flg
