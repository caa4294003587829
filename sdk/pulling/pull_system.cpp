// SPDX-License-Identifier: MIT
#include "pulling/pull_system.h"

#include <algorithm>

#include "inflation/mesh_laplacian.h"
#include "linear/dissection_order.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr double least_weight = 1e-3;
constexpr double drawn_back = 1e-9;  // of what an even mesh has on its diagonal
constexpr double even_diagonal = 3.5;
constexpr double least_height = 1e-6;  // of a triangle's sides: what it has at least
constexpr uint32_t width = 4;

}  // namespace

Task<PullSystem> make_pull_system(Pace& pace, const Mesh& mesh) {
    pace.stage("factor");
    Memory* const memory = pace.memory();
    const uint32_t vertices = mesh.vertex_count(), triangles = mesh.triangle_count();
    Buffer<std::array<double, 3>> cotangents(triangles, memory);
    Buffer<double> masses(vertices, memory);
    Buffer<Vec3> places(vertices, memory);
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t v) {
        masses[v] = 0;
        std::construct_at(&places[v], mesh.position(v));
    });
    double area = 0;
    co_await each(pace, triangles, Cost::tens_of_ns, [&](uint32_t t) {
        const Triple& corners = mesh.triangles[t];
        const Vec3 p[3] = {places[corners[0]], places[corners[1]], places[corners[2]]};
        const Vec3 a = p[1] - p[0], b = p[2] - p[0];
        const double twice = std::max(a.cross(b).norm(), least_height * (a.squaredNorm() + b.squaredNorm()));
        area += twice;
        for (uint32_t k = 0; k < 3; ++k) {
            const double dot = (p[(k + 1) % 3] - p[k]).dot(p[(k + 2) % 3] - p[k]);
            cotangents[t][k] = twice > 0 ? 0.5 * dot / twice : 0;
            masses[corners[k]] += twice;
        }
    });
    const double scale = area > 0 ? drawn_back * even_diagonal * vertices / (3 * area) : 1;
    co_await each(pace, vertices, Cost::some_ns,
                  [&](uint32_t v) { masses[v] = std::max(masses[v] * scale, 1e-3 * drawn_back * even_diagonal); });
    const LaplacianInput input{.triangles = {mesh.triangles.data(), triangles},
                               .cotangents = {cotangents.data(), triangles},
                               .row_count = vertices,
                               .mass = {masses.data(), vertices},
                               .min_weight = least_weight};
    SymmetricMatrix matrix = co_await mesh_laplacian(pace, input);
    Buffer<uint32_t> order = co_await dissection_order(pace, matrix, {places.data(), vertices});
    PullSystem system;
    system.place_of = Buffer<uint32_t>(vertices, memory);
    system.masses = Buffer<double>(vertices, memory);
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t i) {
        system.place_of[order[i]] = i;
        system.masses[i] = masses[order[i]];
    });
    const uint32_t entries = matrix.offsets[vertices];
    system.offsets = Buffer<uint32_t>(vertices + size_t{1}, memory);
    system.neighbours = Buffer<uint32_t>(entries, memory);
    system.weights = Buffer<float>(entries, memory);
    uint32_t written = 0;
    system.offsets[0] = 0;
    co_await each_by_work(pace, vertices, Cost::some_ns, [&](uint32_t i) {
        const uint32_t begin = matrix.offsets[order[i]], end = matrix.offsets[order[i] + 1];
        for (uint32_t e = begin; e < end; ++e, ++written) {
            system.neighbours[written] = system.place_of[matrix.columns[e]];
            system.weights[written] = static_cast<float>(-matrix.values[e]);
        }
        system.offsets[i + 1] = written;
        return 1 + end - begin;
    });
    system.factor = co_await factorize(pace, matrix, std::move(order));
    matrix.values = {};
    co_await pace;
    co_return system;
}

Task<void> solve_points(Pace& pace, const CholeskyFactor& factor, std::span<double> values) {
    const uint32_t size = factor.size();
    double* const x = values.data();
    const size_t* const offsets = factor.offsets.data();
    const uint32_t* const rows = factor.rows.data();
    const double *const entries = factor.values.data(), *const inverses = factor.inverses.data();
    // L y = b
    co_await each_by_work(pace, size, Cost::some_ns, [=](uint32_t column) {
        double own[width];
        for (uint32_t k = 0; k < width; ++k) own[k] = x[size_t{width} * column + k] *= inverses[column];
        for (size_t e = offsets[column] + 1; e < offsets[column + 1]; ++e) {
            double* const to = x + size_t{width} * rows[e];
            for (uint32_t k = 0; k < width; ++k) to[k] -= entries[e] * own[k];
        }
        return static_cast<uint32_t>(offsets[column + 1] - offsets[column]);
    });
    // L' x = y
    co_await each_by_work(pace, size, Cost::some_ns, [=](uint32_t step) {
        const uint32_t column = size - 1 - step;
        double own[width];
        std::copy_n(x + size_t{width} * column, width, own);
        for (size_t e = offsets[column] + 1; e < offsets[column + 1]; ++e) {
            const double* const from = x + size_t{width} * rows[e];
            for (uint32_t k = 0; k < width; ++k) own[k] -= entries[e] * from[k];
        }
        for (uint32_t k = 0; k < width; ++k) x[size_t{width} * column + k] = own[k] * inverses[column];
        return static_cast<uint32_t>(offsets[column + 1] - offsets[column]);
    });
}

}  // namespace flg
