// SPDX-License-Identifier: MIT
#include "settled_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "documents/failure.h"
#include "support/curve_source.h"

namespace flg::cli {
namespace {

constexpr int kMaxRounds = 8;
constexpr double kFirstMove = 1e-6;  // of the way into the vertex' triangles; doubled until the place is a new one

using Place = std::array<float, 3>;

// -0 is where 0 is.
Place place_of(const float* p) {
    return {p[0] + 0.0f, p[1] + 0.0f, p[2] + 0.0f};
}

// What stands in for the positions of a surface's view.
std::vector<FlgColumn> columns_with(const FlgMeshView& mesh, const std::vector<float>& positions) {
    std::vector<FlgColumn> columns(mesh.columns, mesh.columns + mesh.column_count);
    for (FlgColumn& column : columns) {
        if (column.attribute == FLG_ATTRIBUTE_POSITION) column = {FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0};
    }
    return columns;
}

}  // namespace

SettledMesh::SettledMesh(Session& session, const MeshSurface& surface, Report& report) : view_(*surface.view().mesh) {
    const FlgContext context = session.context();
    for (int round = 0; round < kMaxRounds; ++round) {
        if (!separate()) {
            report.counts["moved_vertices"] = moved_;
            report.quality["farthest_move"] = farthest_;
            return;
        }
        // As a reader makes it.
        FlgSurfaceDesc desc;
        flgSurfaceDescInit(&desc, sizeof desc);
        desc.mesh = &view_;
        FlgSurface made = {};
        FlgJob job = {};
        check(flgSurfaceCreate(context, &desc, &made, &job), surface.name());
        session.finish({{{job, surface.name()}}}, report);
        view_ = *view_of(context, made).mesh;
    }
    throw InputError(surface.name() +
                     ": can't be repaired so that it needs no further repair: its sheets touch too often");
}

bool SettledMesh::separate() {
    const FlgColumn& from = positions_of(view_);
    std::vector<float> positions;
    for (uint32_t v = 0; v < view_.vertex_count; ++v) {
        const float* p = samples::value_at(from, v);
        positions.insert(positions.end(), p, p + 3);
    }
    std::set<Place> taken;
    std::vector<uint32_t> moving;
    for (uint32_t v = 0; v < view_.vertex_count; ++v) {
        if (!taken.insert(place_of(&positions[3 * size_t{v}])).second) moving.push_back(v);
    }
    if (moving.empty()) return false;

    // Sums of the corners of a vertex' triangles, and how many.
    std::vector<std::array<double, 4>> around(view_.vertex_count);
    for (size_t i = 0; i < 3 * size_t{view_.triangle_count}; ++i) {
        std::array<double, 4>& sum = around[view_.triangles[i]];
        const size_t first = i - i % 3;
        for (size_t corner = first; corner < first + 3; ++corner) {
            for (size_t k = 0; k < 3; ++k)
                sum[k] += static_cast<double>(positions[3 * size_t{view_.triangles[corner]} + k]);
            sum[3] += 1.0;
        }
    }
    for (const uint32_t v : moving) {
        float* p = &positions[3 * size_t{v}];
        const Place start = {p[0], p[1], p[2]};
        for (double share = kFirstMove; share < 1.0; share *= 2.0) {
            for (size_t k = 0; k < 3; ++k) {
                const double middle = around[v][k] / around[v][3];
                p[k] = static_cast<float>(double{start[k]} + share * (middle - double{start[k]}));
            }
            if (taken.insert(place_of(p)).second) break;
        }
        ++moved_;
        farthest_ = std::max(farthest_, std::hypot(double{p[0]} - double{start[0]}, double{p[1]} - double{start[1]},
                                                   double{p[2]} - double{start[2]}));
    }
    positions_ = std::move(positions);
    columns_ = columns_with(view_, positions_);
    view_.columns = columns_.data();
    return true;
}

}  // namespace flg::cli
