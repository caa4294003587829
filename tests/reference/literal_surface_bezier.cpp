// SPDX-License-Identifier: MIT
#include "reference/literal_surface_bezier.h"

#include <memory_resource>

#include "reference/literal_geodesics.h"
#include "runtime/run_now.h"
#include "surfaces/tracing/geodesic_path.h"
#include "surfaces/tracing/straight_walk.h"

namespace flg::literal {

namespace {

Memory* const memory = std::pmr::new_delete_resource();

SurfacePath shortest(const Mesh& mesh, const SurfacePoint& from, const SurfacePoint& to) {
    // Distances along edges say which side is shorter.
    std::vector<Seed> seeds;
    for (const uint32_t vertex : mesh.triangles[to.triangle])
        seeds.push_back({vertex, static_cast<float>((mesh.position(vertex) - position_of(mesh, to)).norm()), 0});
    const GraphField field(geodesic_graph(mesh), seeds);
    const RegionSet all(memory);
    SurfaceCurves drawn(memory);
    run_now(memory, [&](Pace& pace) { return add_geodesic_path(pace, mesh, from, to, field.distances, all, drawn); });
    SurfacePath path(memory);
    if (drawn.points.empty()) path.add(mesh, from);
    for (const SurfacePoint& point : drawn.points) path.add(mesh, point);
    return path;
}

SurfacePoint middle(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
    const SurfacePath path = shortest(mesh, a, b);
    return point_at(mesh, path, 0.5 * path.length());
}

void add_points(const Mesh& mesh, const std::array<SurfacePoint, 4>& p, uint32_t halvings,
                std::vector<SurfacePoint>& out) {
    if (halvings == 0) return out.push_back(p[3]);
    const SurfacePoint a = middle(mesh, p[0], p[1]), b = middle(mesh, p[1], p[2]), c = middle(mesh, p[2], p[3]);
    const SurfacePoint d = middle(mesh, a, b), e = middle(mesh, b, c), f = middle(mesh, d, e);
    add_points(mesh, {p[0], a, d, f}, halvings - 1, out);
    add_points(mesh, {f, e, c, p[3]}, halvings - 1, out);
}

// Towards the next point and the last one, as vectors in the point's triangle as long as the paths.
Vec3 way_to(const Mesh& mesh, const SurfacePoint& from, const SurfacePoint& to) {
    const SurfacePath path = shortest(mesh, from, to);
    uint32_t triangle = 0;
    return path.length() * first_way(mesh, path, triangle).normalized();
}

SurfacePoint walked(const Mesh& mesh, const SurfacePoint& from, const Vec3& way) {
    SurfacePath path(memory);
    run_now(memory, [&](Pace& pace) { return walk_straight(pace, mesh, {from, way.normalized()}, way.norm(), path); });
    return path.points.back();
}

}  // namespace

std::vector<SurfacePoint> surface_bezier(const Mesh& mesh, const std::array<SurfacePoint, 4>& control,
                                         uint32_t halvings) {
    std::vector<SurfacePoint> out = {control[0]};
    add_points(mesh, control, halvings, out);
    return out;
}

std::vector<std::array<SurfacePoint, 4>> surface_handles(const Mesh& mesh, const std::vector<SurfacePoint>& given,
                                                         bool closed) {
    const size_t count = given.size(), segments = count - (closed ? 0 : 1);
    std::vector<std::array<SurfacePoint, 4>> all(segments);
    for (size_t i = 0; i < count; ++i) {
        if (!closed && (i == 0 || i + 1 == count)) continue;
        const Vec3 next = way_to(mesh, given[i], given[(i + 1) % count]),
                   last = way_to(mesh, given[i], given[(i + count - 1) % count]);
        const double d1 = next.norm(), d0 = last.norm();
        const Vec3 tangent = (d0 * next / d1 - d1 * last / d0) / (d0 + d1);
        all[(i + segments - 1) % segments][2] = walked(mesh, given[i], -tangent * d0 / 3);
        all[i % segments][1] = walked(mesh, given[i], tangent * d1 / 3);
    }
    for (size_t s = 0; s < segments; ++s) {
        all[s][0] = given[s];
        all[s][3] = given[(s + 1) % count];
    }
    if (closed) return all;
    all.front()[1] = middle(mesh, given.front(), all.front()[2]);
    all.back()[2] = middle(mesh, all.back()[1], given.back());
    return all;
}

}  // namespace flg::literal
