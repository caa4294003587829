// SPDX-License-Identifier: MIT
#include "tangles/tangle_displacement.h"

#include <algorithm>
#include <cmath>

#include "surfaces/mesh_measures_normals.h"
#include "surfaces/surface_update.h"

namespace flg {

namespace {

// Each about 10 us.
constexpr uint32_t scan_chunk = 2000;
constexpr uint32_t move_chunk = 20;
constexpr uint32_t write_chunk = 500;

struct Move {
    uint32_t vertex;
    Position to;
};

// The largest distance from its borders in each leaf, by label.
Task<Buffer<float>> measure_leaves(Pace& pace, const Mesh& mesh, const RegionSet& leaves, uint32_t label_count,
                                   const DistanceField& field) {
    Buffer<float> largest(label_count, pace.memory());
    std::fill(largest.begin(), largest.end(), 0.0f);
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        if (t % scan_chunk == 0) co_await pace;
        const uint32_t label = mesh.regions[t];
        if (!leaves.contains(label)) continue;
        for (const uint32_t vertex : mesh.triangles[t]) {
            const float distance = field.distances[vertex];
            if (std::isfinite(distance)) largest[label] = std::max(largest[label], distance);
        }
    }
    co_return largest;
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
    Surface& surface = *tangle.surface;
    Mesh& mesh = surface.mesh();
    pace.stage("field");
    const LeafSet leaves = co_await list_leaves(pace, tangle.tree, request.regions, "desc.regions");
    TangleSeeds borders(pace.memory());
    borders.borders = FLG_TANGLE_BORDERS_EACH;
    DistanceField field;
    co_await solve_seeds(pace, tangle.tree, tangle.surface, leaves, borders, "desc.regions", {}, false, field);

    pace.stage("displace");
    const Buffer<float> largest = co_await measure_leaves(pace, mesh, leaves.set, tangle.tree.size(), field);
    Buffer<uint8_t> seen(mesh.vertex_count(), pace.memory());
    for (size_t v = 0; v < seen.size(); ++v) {
        seen[v] = 0;
        if (v % scan_chunk == 0) co_await pace;
    }
    // All are found before any moves: normals are those of the surface as it was.
    std::pmr::deque<Move> moves(pace.memory());
    uint32_t normals = 0;
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        if (t % scan_chunk == 0) co_await pace;
        const uint32_t label = mesh.regions[t];
        if (!leaves.set.contains(label)) continue;
        const double reach = request.reach > 0 ? request.reach : largest[label];
        for (const uint32_t vertex : mesh.triangles[t]) {
            const float distance = field.distances[vertex];
            if (seen[vertex] != 0 || !(distance > 0) || !std::isfinite(distance)) continue;
            seen[vertex] = 1;
            const double share = std::min(distance / reach, 1.0);
            const double height = request.amount * schlick_gain(schlick_bias(share, request.bias), request.gain);
            const Vec3 to = mesh.position(vertex) + height * vertex_normal(mesh, vertex);
            moves.push_back(
                {vertex, {static_cast<float>(to.x()), static_cast<float>(to.y()), static_cast<float>(to.z())}});
            if (++normals % move_chunk == 0) co_await pace;
        }
    }

    pace.commit();
    MeshEdit& edit = step.edit.emplace(pace.memory());
    edit.begin(mesh);
    for (size_t i = 0; i < moves.size(); ++i) {
        edit.set_position(mesh, moves[i].vertex, moves[i].to);
        if (i % write_chunk == 0) co_await pace;
    }
    edit.end(mesh);
    co_await update_after_edit(pace, surface, edit, revision);
}

}  // namespace flg
