// SPDX-License-Identifier: MIT
#include "inflation/inflate_part.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "inflation/part_mesh.h"
#include "inflation/part_raster.h"
#include "runtime/each.h"
#include "runtime/pace.h"

namespace flg {

namespace {

constexpr double source = 4;
// Keeps heights above zero where triangles are obtuse; it is felt nowhere else.
constexpr double min_weight = 1e-6;

}  // namespace

Task<void> height_field(Pace& pace, InflatedPart& part) {
    Memory* memory = pace.memory();
    const size_t vertices = part.points.size(), triangles = part.triangles.size();
    Buffer<uint32_t> row_of_vertex(vertices, memory);
    Buffer<double> load(vertices, memory);
    std::pmr::vector<Vec3> places(memory);
    places.reserve(vertices);
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t v) {
        load[v] = 0;
        row_of_vertex[v] = part.on_border[v] ? no_row : static_cast<uint32_t>(places.size());
        if (!part.on_border[v]) places.emplace_back(part.points[v].x, part.points[v].y, 0);
    });
    const auto rows = static_cast<uint32_t>(places.size());

    Buffer<std::array<double, 3>> cotangents(triangles, memory);
    co_await each(pace, triangles, Cost::tens_of_ns, [&](uint32_t i) {
        const TriangleVertices& t = part.triangles[i];
        const Point2 &a = part.points[t[0]], &b = part.points[t[1]], &c = part.points[t[2]];
        const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        const auto cotangent = [twice](const Point2& at, const Point2& p, const Point2& q) {
            return 0.5 * ((p.x - at.x) * (q.x - at.x) + (p.y - at.y) * (q.y - at.y)) / twice;
        };
        cotangents[i] = {cotangent(a, b, c), cotangent(b, c, a), cotangent(c, a, b)};
        for (const uint32_t vertex : t) load[vertex] += source * twice / 6;
    });
    const LaplacianInput input{.triangles = {part.triangles.data(), triangles},
                               .cotangents = {cotangents.data(), triangles},
                               .row_of_vertex = {row_of_vertex.data(), vertices},
                               .row_count = rows,
                               .min_weight = min_weight};
    const CholeskyFactor factor = co_await factorize_laplacian(pace, input, places);

    // One right-hand side; the others are 0.
    Buffer<double> right(size_t{solve_width} * rows, memory);
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t v) {
        if (row_of_vertex[v] == no_row) return;
        double* row = &right[size_t{solve_width} * row_of_vertex[v]];
        std::fill_n(row, solve_width, 0);
        row[0] = load[v];
    });
    co_await solve(pace, factor, {right.data(), right.size()});

    part.squares = Buffer<double>(vertices, memory);
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t v) {
        const uint32_t row = row_of_vertex[v];
        part.squares[v] = row == no_row ? 0 : std::max(0.0, right[size_t{solve_width} * row]);
        part.highest = std::max(part.highest, part.thickness * std::sqrt(part.squares[v]));
    });
}

Task<PartSurface> two_sided_mesh(Pace& pace, const InflatedPart& part) {
    const auto vertices = static_cast<uint32_t>(part.points.size());
    const auto triangles = static_cast<uint32_t>(part.triangles.size());
    Buffer<uint32_t> below(vertices, pace.memory());  // by vertex, that of the other side
    uint32_t count = vertices;
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t v) { below[v] = part.on_border[v] ? v : count++; });
    PartSurface surface{Buffer<Vec3>(count, pace.memory()),
                        Buffer<TriangleVertices>(2 * size_t{triangles}, pace.memory())};
    co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) {
        const Point2& p = part.points[v];
        const double height = part.thickness * std::sqrt(part.squares[v]);
        std::construct_at(&surface.positions[v], p.x, p.y, height);
        if (below[v] != v) std::construct_at(&surface.positions[below[v]], p.x, p.y, -height);
    });
    co_await each(pace, triangles, Cost::some_ns, [&](uint32_t i) {
        const TriangleVertices& t = part.triangles[i];
        surface.triangles[i] = t;
        surface.triangles[triangles + i] = {below[t[2]], below[t[1]], below[t[0]]};
    });
    co_return surface;
}

Task<void> inflate_part(Pace& pace, InflationOptions options, InflatedPart& part) {
    pace.stage("inflate");
    co_await part_mesh(pace, options, part);
    co_await height_field(pace, part);
    co_await part_raster(pace, part);
}

}  // namespace flg
