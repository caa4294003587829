// SPDX-License-Identifier: MIT
// Surfaces of samples, and meshes to take them from.
#pragma once

#include "runtime/run_now.h"
#include "splines/manifolds/mesh_samples.h"
#include "splines/surface_checks.h"
#include "surfaces/test_meshes.h"

namespace flg::test {

// Closed in both directions: 2 * count times count cells, radii 1 and 0.4.
inline Soup closed_torus(uint32_t count) {
    Soup soup;
    const double step = 2 * std::numbers::pi / count;
    for (uint32_t j = 0; j < count; ++j) {
        for (uint32_t i = 0; i < 2 * count; ++i) {
            const double a = 0.5 * step * i, b = step * j;
            const double out = 1 + 0.4 * std::cos(b);
            soup.positions.push_back(to_position(Vec3(out * std::cos(a), out * std::sin(a), 0.4 * std::sin(b))));
        }
    }
    const auto at = [&](uint32_t i, uint32_t j) { return j % count * 2 * count + i % (2 * count); };
    for (uint32_t j = 0; j < count; ++j) {
        for (uint32_t i = 0; i < 2 * count; ++i) {
            soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return soup;
}

// Twelve triangles, around the origin.
inline Soup box(const Vec3& size) {
    Soup soup;
    for (uint32_t i = 0; i < 8; ++i) {
        soup.positions.push_back(to_position(size.cwiseProduct(Vec3(i & 1, i >> 1 & 1, i >> 2) - Vec3(0.5, 0.5, 0.5))));
    }
    for (const auto& [a, b, c, d] : std::initializer_list<std::array<uint32_t, 4>>{
             {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
        soup.triangles.push_back({a, b, c});
        soup.triangles.push_back({a, c, d});
    }
    return soup;
}

inline SampledSurface sample(const Mesh& mesh, bool haltingly = false, double smoothing_scale = 0) {
    return run_now(
        test_memory(), [&](Pace& pace) { return sample_mesh(pace, mesh, smoothing_scale); }, haltingly);
}

// Points anywhere on the mesh.
inline std::vector<Vec3> points_on(const Mesh& mesh, size_t count) {
    std::vector<Vec3> points(count);
    for (size_t i = 0; i < count; ++i) {
        const Triple& corners = mesh.triangles[random_below(7, i, 0, mesh.triangle_count())];
        double u = random_unit(7, i, 1), v = random_unit(7, i, 2);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        points[i] =
            (1 - u - v) * mesh.position(corners[0]) + u * mesh.position(corners[1]) + v * mesh.position(corners[2]);
    }
    return points;
}

// The largest errors against the closed form at points that were projected.
struct SurfaceErrors {
    double place = 0, normal = 0, form = 0;
};

inline SurfaceErrors errors_against(const Hypersurface& exact, const OrientedSamples& surface,
                                    const std::vector<Vec3>& points) {
    SurfaceErrors errors;
    for (const Vec3& start : points) {
        std::vector<double> hint = fresh_hint(surface);
        Vec3 x = start;
        EXPECT_TRUE(surface.project(x.data(), hint.data()));
        const SurfaceValue right = evaluate_at(exact, x), here = evaluate_at(surface, x, hint);
        errors.place = std::max(errors.place, std::abs(right.value));
        errors.normal = std::max(errors.normal, (right.gradient - here.gradient.normalized()).norm());
        Eigen::Matrix<double, 3, 2> basis;
        surface.tangent_basis(x.data(), hint.data(), basis.data());
        Eigen::Matrix2d form, right_form;
        surface.second_form(x.data(), hint.data(), basis.data(), right.gradient.data(), form.data());
        exact.second_form(x.data(), nullptr, basis.data(), right.gradient.data(), right_form.data());
        errors.form = std::max(errors.form, (form - right_form).norm());
    }
    return errors;
}

}  // namespace flg::test
