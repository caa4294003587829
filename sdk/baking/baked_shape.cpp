// SPDX-License-Identifier: MIT
#include "baking/baked_shape.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "runtime/each.h"
#include "surfaces/mesh/source_weights.h"

namespace flg {

namespace {

constexpr double rounding = 1e-6;  // of the box: heights below are none

Vec3 place_of(const SourceWeights& lies, const Buffer<Position>& positions) {
    const double first = 1 - double{lies.weights[0]} - double{lies.weights[1]};
    Vec3 place = first * load_vec3(positions[lies.vertices[0]].data());
    for (size_t i = 1; i < 3 && lies.vertices[i] != no_index; ++i)
        place += double{lies.weights[i - 1]} * load_vec3(positions[lies.vertices[i]].data());
    return place;
}

// The normals of a triangle of the mesh, as long as twice its area.
Vec3 double_area(const Triple& corners, const Buffer<Position>& positions) {
    const Vec3 origin = load_vec3(positions[corners[0]].data());
    return (load_vec3(positions[corners[1]].data()) - origin).cross(load_vec3(positions[corners[2]].data()) - origin);
}

double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// Turned where repair turned the triangle: outwards as the surface's.
Vec3 unit_normal(const Mesh& mesh, uint32_t t, const Buffer<Triple>& inputs, const BakeRequest& request,
                 const Buffer<Position>& places) {
    const Vec3 normal = double_area(inputs[mesh.source_triangles[t]], request.positions).stableNormalized();
    return double_area(mesh.triangles[t], places).dot(normal) < 0 ? Vec3(-normal) : normal;
}

}  // namespace

Task<BakedShape> find_shape(Pace& pace, const Surface& surface, const BakeRequest& request) {
    const Mesh& mesh = surface.mesh();
    if (!surface.input_triangles) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.tangle: its surface does not know what it was made of: set FlgSurfaceDesc.provenance");
    }
    const Buffer<Triple>& inputs = *surface.input_triangles;
    const auto vertices = static_cast<uint32_t>(request.positions.size());
    if (inputs.size() != request.triangle_count()) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.mesh has %u triangles, but the surface was made of %zu",
                      request.triangle_count(), inputs.size());
    }
    co_await each(pace, inputs.size(), Cost::some_ns, [&](uint32_t t) {
        for (const uint32_t v : inputs[t])
            if (v >= vertices)
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.mesh has %u vertices, but the surface was made of more",
                              vertices);
    });
    BakedShape shape;
    const MeshColumn& sources = surface.columns.back();
    const double least = rounding * (surface.extent.upper - surface.extent.lower).norm();
    bool moved = false;
    shape.places = Buffer<Position>(mesh.vertex_count(), pace.memory());
    co_await each(pace, mesh.vertex_count(), Cost::tens_of_ns, [&](uint32_t v) {
        const Vec3 place = place_of(load_sources(sources, v), request.positions);
        store_vec3(place, shape.places[v].data());
        moved |= (mesh.position(v) - place).norm() > least;
    });
    if (!moved || !request.wants_heights()) co_return shape;

    // Angle-weighted normals of the mesh; then heights along them.
    const Buffer<Position>& places = shape.places;
    shape.slopes = Buffer<Position>(mesh.vertex_count(), pace.memory());
    shape.heights = Buffer<float>(mesh.vertex_count(), pace.memory());
    Buffer<float> areas(mesh.vertex_count(), pace.memory());
    Buffer<Position>& sums = shape.slopes;
    const auto clear = [&](uint32_t v) { sums[v] = {0, 0, 0}; };
    const auto add = [&](uint32_t v, const Vec3& term) {
        store_vec3(load_vec3(sums[v].data()) + term, sums[v].data());
    };
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, clear);
    co_await each(pace, mesh.triangle_count(), Cost::hundreds_of_ns, [&](uint32_t t) {
        const Vec3 normal = unit_normal(mesh, t, inputs, request, places);
        const Triple& corners = mesh.triangles[t];
        for (uint32_t k = 0; k < 3; ++k) {
            const Vec3 here = load_vec3(places[corners[k]].data());
            const Vec3 next = load_vec3(places[corners[(k + 1) % 3]].data());
            const Vec3 previous = load_vec3(places[corners[(k + 2) % 3]].data());
            add(corners[k], angle_between(next - here, previous - here) * normal);
        }
    });
    co_await each(pace, mesh.vertex_count(), Cost::tens_of_ns, [&](uint32_t v) {
        const Vec3 move = mesh.position(v) - load_vec3(places[v].data());
        const double height = move.dot(load_vec3(sums[v].data()).stableNormalized());
        shape.heights[v] = std::abs(height) > least ? static_cast<float>(height) : 0.0f;
        areas[v] = 0;
        clear(v);
    });
    // The mean of the triangles' gradients, by area: half the sum of heights times the turned opposite edges.
    co_await each(pace, mesh.triangle_count(), Cost::hundreds_of_ns, [&](uint32_t t) {
        const Triple& corners = mesh.triangles[t];
        const double area = 0.5 * double_area(corners, places).norm();
        const Vec3 normal = unit_normal(mesh, t, inputs, request, places);
        Vec3 gradient = Vec3::Zero();
        for (uint32_t k = 0; k < 3; ++k) {
            const Vec3 edge =
                load_vec3(places[corners[(k + 2) % 3]].data()) - load_vec3(places[corners[(k + 1) % 3]].data());
            gradient += 0.5 * double{shape.heights[corners[k]]} * normal.cross(edge);
        }
        for (const uint32_t v : corners) {
            areas[v] += static_cast<float>(area);
            add(v, gradient);
        }
    });
    co_await each(pace, mesh.vertex_count(), Cost::tens_of_ns, [&](uint32_t v) {
        if (areas[v] > 0) store_vec3(load_vec3(sums[v].data()) / double{areas[v]}, sums[v].data());
    });
    areas = {};
    co_await pace;
    co_return shape;
}

}  // namespace flg
