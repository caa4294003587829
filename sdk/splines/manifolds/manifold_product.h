// SPDX-License-Identifier: MIT
// Manifolds as hosts hold them.
#pragma once

#include <optional>

#include "core/origin.h"
#include "filigree/filigree_spline.h"
#include "runtime/product.h"
#include "splines/manifolds/manifold.h"
#include "splines/manifolds/mesh_border.h"
#include "surfaces/mesh/nearest_points.h"
#include "surfaces/surface.h"

namespace flg {

// What else may be done with one: obstacles are in space, or on a Hypersurface of R^3.
enum class ManifoldKind { other, space, hypersurface };

class ManifoldProduct final : public Product {
public:
    Origin origin{};  // of its coordinates; 0 of free space, which is everywhere, and unless in R^3. Set at once
    std::shared_ptr<const ManifoldProduct> base;  // that an image manifold is of; it looks into that
    std::shared_ptr<const Manifold> manifold;     // there once the job that makes it is done
    // A mesh that it is made of, for first curves along it where projected chords do not lead there; or null.
    std::shared_ptr<Surface> surface;
    Buffer<uint32_t> components;           // of its vertices; empty if it is all of one piece
    std::optional<NearestPoints> nearest;  // of its triangles, as many as there were
    uint32_t nearest_triangles = 0;
    std::optional<MeshBorder> border;  // of the mesh, where it is open
    // How far vertices or points it is made of are from it, at most and root mean square, m; 0 where it is exact.
    double largest_deviation = 0, mean_deviation = 0;
    // So many coordinates of a point are given and shown, the first ones; the others come from projection. Set at once.
    uint32_t given_ambient = 3;
    ManifoldKind kind = ManifoldKind::other;
    // Whether it is a surface in R^3.
    bool has_normals() const { return manifold->ambient() == 3 && manifold->dimension() == 2; }
    // Whether curves can be laid over its triangles.
    bool has_triangles() const { return surface && has_normals(); }

    const FlgManifoldView& view() const { return view_; }

private:
    void show() noexcept override {
        view_ = {.struct_size = sizeof view_,
                 .ambient = given_ambient,
                 .dimension = manifold->dimension(),
                 .reserved = 0,
                 .size = manifold->size(),
                 .largest_deviation = largest_deviation,
                 .mean_deviation = mean_deviation,
                 .origin = {}};
        write_origin(origin, view_.origin);
    }

    FlgManifoldView view_{};
};

// To search the triangles of held.surface: those that are there, or anew after a cut.
inline Task<NearestPoints> nearest_on(Pace& pace, const ManifoldProduct& held) {
    if (held.nearest && held.nearest_triangles == held.surface->mesh().triangle_count()) co_return *held.nearest;
    NearestPoints nearest(held.surface->mesh());
    co_await build(pace, nearest);
    co_return nearest;
}

}  // namespace flg
