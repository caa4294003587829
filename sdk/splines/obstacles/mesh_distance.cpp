// SPDX-License-Identifier: MIT
#include "splines/obstacles/mesh_distance.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "splines/obstacles/triangle_place.h"

namespace flg {

namespace {

constexpr double clearly_less = 1 - 1e-6;  // triangles that share the nearest point do not take turns
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double band = 1.5;  // cells around a triangle that get its distance at once
constexpr double border = 3;  // cells beyond the reach, where the spline's ends are felt
constexpr uint32_t polish_steps = 16;
constexpr uint32_t max_sweeps = 255;  // more than any mesh needs: a path of nearest triangles turns a few times
constexpr double max_hop = 1.7321;    // of the spacing, to a neighbour

// The nodes of a box.
struct NodeBox {
    uint32_t size() const { return (last[0] - first[0] + 1) * (last[1] - first[1] + 1) * (last[2] - first[2] + 1); }
    std::array<uint32_t, 3> cell(uint32_t i) const {
        const uint32_t x = last[0] - first[0] + 1, y = last[1] - first[1] + 1;
        return {first[0] + i % x, first[1] + i / x % y, first[2] + i / (x * y)};
    }
    void step(std::array<uint32_t, 3>& at) const {
        if (++at[0] <= last[0]) return;
        at[0] = first[0];
        if (++at[1] <= last[1]) return;
        at[1] = first[1];
        ++at[2];
    }

    std::array<uint32_t, 3> first{}, last{};
};

struct Distances {
    Vec3 place(const std::array<uint32_t, 3>& cell) const {
        return {grid.origin[0] + grid.spacing * cell[0], grid.origin[1] + grid.spacing * cell[1],
                grid.origin[2] + grid.spacing * cell[2]};
    }

    // Takes the triangle if it is nearer than the node's, and than `max`.
    bool try_triangle(uint32_t node, uint32_t triangle, const Vec3& x, double max) {
        const Triple& t = mesh.triangles[triangle];
        const double away = triangle_foot(x, mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])).to.norm();
        if (!(away < clearly_less * double(values[node])) || away > max) return false;
        values[node] = static_cast<float>(away);
        nearest[node] = triangle;
        return true;
    }

    // The nodes in the box of a triangle, made wider by so many cells; false if there are none.
    bool nodes_around(uint32_t triangle, double wider, NodeBox& box) const {
        const Triple& t = mesh.triangles[triangle];
        for (uint32_t k = 0; k < 3; ++k) {
            const int i = static_cast<int>(k);
            const double a = mesh.position(t[0])[i], b = mesh.position(t[1])[i], c = mesh.position(t[2])[i];
            const double low = std::ceil((std::min({a, b, c}) - grid.origin[k]) / grid.spacing - wider);
            const double high = std::floor((std::max({a, b, c}) - grid.origin[k]) / grid.spacing + wider);
            if (low > high) return false;
            box.first[k] = static_cast<uint32_t>(std::clamp(low, 0.0, grid.counts[k] - 1.0));
            box.last[k] = static_cast<uint32_t>(std::clamp(high, 0.0, grid.counts[k] - 1.0));
        }
        return true;
    }

    // Some of the nodes around a triangle try it.
    void splat(uint32_t triangle, const NodeBox& box, uint32_t begin, uint32_t end) {
        std::array<uint32_t, 3> cell = box.cell(begin);
        for (uint32_t i = begin; i < end; ++i, box.step(cell)) {
            const uint32_t node = grid.node(cell);
            if (try_triangle(node, triangle, place(cell), band * grid.spacing)) changed[node] = 7;
        }
    }

    // A node tries the triangles of the seven neighbours that the sweep has passed: those that are new within eight
    // sweeps, in which it comes past each neighbour, and that may be nearer, as they are as near to the neighbour.
    bool sweep_node(const std::array<uint32_t, 3>& cell, uint32_t sweep) {
        const uint32_t node = grid.node(cell);
        bool found = false;
        for (uint32_t subset = 1; subset < 8; ++subset) {
            std::array<uint32_t, 3> from = cell;
            bool inside = true;
            for (uint32_t axis = 0; axis < 3; ++axis) {
                if ((subset >> axis & 1) == 0) continue;
                from[axis] += (sweep >> axis & 1) != 0 ? 1u : -1u;
                inside = inside && from[axis] < grid.counts[axis];
            }
            if (!inside) continue;
            const uint32_t other = grid.node(from);
            if (changed[other] + 8u < sweep || nearest[other] == no_index || nearest[other] == nearest[node]) continue;
            if (values[other] - values[node] > max_hop * grid.spacing) continue;
            if (!try_triangle(node, nearest[other], place(cell), infinite)) continue;
            changed[node] = static_cast<uint8_t>(sweep);
            found = true;
        }
        return found;
    }

    // From the node's triangle to those across its edges and on, as long as they are nearer.
    void polish(uint32_t node) {
        const Obstacle::Place at = grid.place(node);
        const Vec3 x(at[0], at[1], at[2]);
        for (uint32_t from = no_index, step = 0; from != nearest[node] && step < polish_steps; ++step) {
            from = nearest[node];
            for (const uint32_t side : mesh.neighbours[from]) {
                if (side == no_index) continue;
                for (const uint32_t triangle :
                     {side, mesh.neighbours[side][0], mesh.neighbours[side][1], mesh.neighbours[side][2]}) {
                    if (triangle == no_index || triangle == from) continue;
                    try_triangle(node, triangle, x, infinite);
                }
            }
        }
    }

    const Mesh& mesh;
    SweepGrid grid;
    Buffer<float> values{};      // a node's distance, m
    Buffer<uint32_t> nearest{};  // a node's triangle
    Buffer<uint8_t> changed{};   // the sweep it is from; sweeps are counted from 8
};

SweepGrid grid_around(const Obstacle::Box& box, double reach, uint32_t cells) {
    double longest = 0;
    for (uint32_t k = 0; k < 3; ++k) longest = std::max(longest, box.upper[k] - box.lower[k]);
    SweepGrid grid;
    grid.dimension = 3;
    grid.spacing = (longest + 2 * reach) / cells;
    const double around = reach + border * grid.spacing;
    for (uint32_t k = 0; k < 3; ++k) {
        const double side = box.upper[k] - box.lower[k] + 2 * around;
        grid.counts[k] = static_cast<uint32_t>(std::ceil(side / grid.spacing - 1e-6)) + 1;
        const double middle = 0.5 * (box.lower[k] + box.upper[k]);
        grid.origin[k] = middle - 0.5 * grid.spacing * (grid.counts[k] - 1);
    }
    return grid;
}

// Distances of nodes next to triangles; then outwards, sweep by sweep.
Task<void> spread(Pace& pace, Distances& d) {
    Slice slice(Cost::tens_of_ns);
    for (uint32_t triangle = 0; triangle < d.mesh.triangle_count(); ++triangle) {
        if (slice.is_over()) co_await pace;
        NodeBox box;
        if (!d.nodes_around(triangle, band, box)) continue;
        for (Portion part(slice, 0, box.size()); part.next();) {
            d.splat(triangle, box, part.begin, part.end);
            if (part.is_over()) co_await pace;
        }
    }
    // The order of a sweep is its number, bit k: backwards along axis k.
    const std::array<uint32_t, 3> counts = d.grid.counts;
    for (uint32_t sweep = 8, last_change = 8; sweep <= last_change + 8 && sweep != max_sweeps; ++sweep) {
        std::array<uint32_t, 3> cell;
        for (uint32_t axis = 0; axis < 3; ++axis) cell[axis] = (sweep >> axis & 1) != 0 ? counts[axis] - 1 : 0;
        co_await each(pace, d.grid.size(), Cost::hundreds_of_ns, [&, sweep](uint32_t) {
            if (d.sweep_node(cell, sweep)) last_change = sweep;
            for (uint32_t axis = 0; axis < 3; ++axis) {
                const bool backwards = (sweep >> axis & 1) != 0;
                if (cell[axis] != (backwards ? 0 : counts[axis] - 1)) {
                    cell[axis] += backwards ? -1u : 1u;
                    break;
                }
                cell[axis] = backwards ? counts[axis] - 1 : 0;
            }
        });
    }
    co_await each(pace, d.grid.size(), Cost::microseconds, [&](uint32_t node) { d.polish(node); });
}

// A triangle seen along an axis: for some of the lines of nodes around it, the first node behind it gets its sense if
// the line crosses it.
void cross(const Distances& d, uint32_t triangle, uint32_t axis, const NodeBox& box, uint32_t begin, uint32_t end,
           Buffer<int16_t>& windings) {
    const SweepGrid& grid = d.grid;
    const uint32_t u = (axis + 1) % 3, v = (axis + 2) % 3, wide = box.last[u] - box.first[u] + 1;
    Vec3 p[3];
    for (uint32_t k = 0; k < 3; ++k) p[k] = d.mesh.position(d.mesh.triangles[triangle][k]);
    for (uint32_t i = begin; i < end; ++i) {
        std::array<uint32_t, 3> cell{};
        cell[u] = box.first[u] + i % wide;
        cell[v] = box.first[v] + i / wide;
        Vec3 line = Vec3::Zero();
        line[static_cast<int>(u)] = grid.origin[u] + grid.spacing * cell[u];
        line[static_cast<int>(v)] = grid.origin[v] + grid.spacing * cell[v];
        double at = 0;
        const int turns = crossing_of_line(p, line, static_cast<int>(axis), &at);
        if (turns == 0) continue;
        cell[axis] = static_cast<uint32_t>(std::floor((at - grid.origin[axis]) / grid.spacing)) + 1;
        windings[grid.node(cell)] = static_cast<int16_t>(windings[grid.node(cell)] - turns);
    }
}

// Along an axis: how often each node is inside.
Task<void> count_crossings(Pace& pace, const Distances& d, uint32_t axis, Buffer<int16_t>& windings) {
    windings = Buffer<int16_t>(d.grid.size(), pace.memory());
    co_await each(pace, d.grid.size(), Cost::some_ns, [&](uint32_t node) { windings[node] = 0; });
    const uint32_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    Slice slice(Cost::tens_of_ns);
    for (uint32_t triangle = 0; triangle < d.mesh.triangle_count(); ++triangle) {
        if (slice.is_over()) co_await pace;
        NodeBox box;
        if (!d.nodes_around(triangle, 1, box)) continue;
        const uint32_t lines = (box.last[u] - box.first[u] + 1) * (box.last[v] - box.first[v] + 1);
        for (Portion part(slice, 0, lines); part.next();) {
            cross(d, triangle, axis, box, part.begin, part.end, windings);
            if (part.is_over()) co_await pace;
        }
    }
    const std::array<uint32_t, 3>& n = d.grid.counts;
    const uint32_t stride = d.grid.stride(axis);
    co_await each(pace, d.grid.size() / n[axis], Cost::hundreds_of_ns, [&, axis, stride](uint32_t i) {
        const uint32_t start = axis == 0 ? i * n[0] : axis == 1 ? i / n[0] * n[0] * n[1] + i % n[0] : i;
        int16_t* const line = windings.data() + start;
        for (uint32_t k = 1; k < n[axis]; ++k)
            line[k * stride] = static_cast<int16_t>(line[k * stride] + line[(k - 1) * stride]);
    });
}

}  // namespace

Task<SampledDistance> mesh_distance(Pace& pace, const Mesh& mesh, double reach, uint32_t cells, bool has_sign) {
    if (!(reach > 0) || !std::isfinite(reach)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "the reach of a mesh's distance is %g, it must be finite and positive", reach);
    }
    if (cells < min_distance_cells || cells > max_distance_cells) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "a mesh's distance has %u cells along its side, there must be %u to %u", cells,
                      min_distance_cells, max_distance_cells);
    }
    if (mesh.triangle_count() == 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the mesh has no triangles");

    SampledDistance out;
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [&](uint32_t vertex) {
        const Vec3 x = mesh.position(vertex);
        for (uint32_t i = 0; i < 3; ++i) {
            double &lower = out.box.lower[i], &upper = out.box.upper[i];
            const double v = x[static_cast<int>(i)];
            lower = vertex == 0 ? v : std::min(lower, v);
            upper = vertex == 0 ? v : std::max(upper, v);
        }
    });
    out.grid = grid_around(out.box, reach, cells);
    out.reach = reach;
    out.shift = has_sign ? 0 : std::max(0.5 * reach, out.grid.spacing);
    const uint32_t nodes = out.grid.size();
    Distances d{.mesh = mesh, .grid = out.grid};
    d.values = Buffer<float>(nodes, pace.memory());
    d.nearest = Buffer<uint32_t>(nodes, pace.memory());
    d.changed = Buffer<uint8_t>(nodes, pace.memory());
    co_await each(pace, nodes, Cost::some_ns, [&](uint32_t node) {
        d.values[node] = std::numeric_limits<float>::infinity();
        d.nearest[node] = no_index;
        d.changed[node] = 0;
    });
    co_await spread(pace, d);
    std::array<Buffer<int16_t>, 3> windings;
    for (uint32_t axis = 0; axis < 3 && has_sign; ++axis) co_await count_crossings(pace, d, axis, windings[axis]);
    // A distance without sign gets values of both signs: it is less than the shift next to the mesh and more at the
    // grid's sides.
    co_await each(pace, nodes, Cost::some_ns, [&](uint32_t node) {
        int votes = 0;
        for (const Buffer<int16_t>& winding : windings) votes += has_sign && winding[node] != 0;
        const double away = d.values[node];
        d.values[node] = static_cast<float>((votes >= 2 ? -away : away) - out.shift);
        out.deepest = std::max(out.deepest, votes >= 2 ? away : 0.0);
    });
    if (has_sign && !(out.deepest > 0)) {
        throw Failure(
            FLG_ERROR_INVALID_ARGUMENT,
            "a mesh that is to be a solid holds no node of a grid with a spacing of %g: it is open or too thin",
            out.grid.spacing);
    }
    const GridInput input{out.grid.counts, out.grid.origin, out.grid.spacing, d.values.data()};
    DistanceGrid spline = co_await interpolate(pace, input);
    out.spline.emplace(std::move(spline));
    co_return out;
}

}  // namespace flg
