// SPDX-License-Identifier: MIT
#include "tangles/tangle_displacement.h"

#include <algorithm>
#include <cmath>

#include "surfaces/mesh/marks.h"
#include "surfaces/mesh/mesh_measures.h"
#include "surfaces/surface_update.h"
#include "tangles/room_work.h"

namespace flg {

namespace {

struct Move {
    uint32_t vertex;
    Position to;
};

// The largest distance from its borders in each leaf, by label.
Task<Buffer<float>> measure_leaves(Pace& pace, const Mesh& mesh, const RegionSet& leaves, uint32_t label_count,
                                   const DistanceField& field) {
    Buffer<float> largest(label_count, pace.memory());
    co_await each(pace, label_count, Cost::some_ns, [&](uint32_t label) { largest[label] = 0; });
    co_await each_within(pace, mesh, leaves, Cost::some_ns, [&](uint32_t t) {
        float& of_leaf = largest[mesh.regions[t]];
        for (const uint32_t vertex : mesh.triangles[t]) {
            const float distance = field.distances[vertex];
            if (std::isfinite(distance)) of_leaf = std::max(of_leaf, distance);
        }
    });
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
    const Buffer<float> largest = co_await measure_leaves(pace, mesh, leaves.set, tangle.tree.size(), field);
    Marks seen = co_await no_marks(pace, mesh.vertex_count());
    // All are found before any moves: normals are those of the surface as it was.
    std::pmr::deque<Move> moves(pace.memory());
    co_await each_within(pace, mesh, leaves.set, Cost::hundreds_of_ns, [&](uint32_t t) {
        const double reach = desc.reach > 0 ? desc.reach : largest[mesh.regions[t]];
        for (const uint32_t vertex : mesh.triangles[t]) {
            const float distance = field.distances[vertex];
            if (!(distance > 0) || !std::isfinite(distance) || !seen.set(vertex)) continue;
            const double share = std::min(distance / reach, 1.0);
            const double height = desc.amount * schlick_gain(schlick_bias(share, desc.bias), desc.gain);
            const Vec3 to = mesh.position(vertex) + height * vertex_normal(mesh, vertex);
            moves.push_back(
                {vertex, {static_cast<float>(to.x()), static_cast<float>(to.y()), static_cast<float>(to.z())}});
        }
    });

    pace.commit();
    MeshEdit& edit = step.edit.emplace(pace.memory());
    edit.begin(mesh);
    co_await each(pace, moves.size(), Cost::tens_of_ns,
                  [&](uint32_t i) { edit.set_position(mesh, moves[i].vertex, moves[i].to); });
    edit.end(mesh);
    co_await update_after_edit(pace, surface, edit, revision);
}

}  // namespace flg
