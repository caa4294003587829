// SPDX-License-Identifier: MIT
#include "gallery/spline_forms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace flg::gallery {
namespace {

scenes::Point point(const glm::dvec3& p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

// Onto the manifold, 64 at a time.
void project(Workshop& workshop, const filigree::Manifold& manifold, std::vector<double>& points) {
    constexpr size_t kMost = 64;
    for (size_t i = 0; i < points.size(); i += 3 * kMost) {
        const auto count = static_cast<uint32_t>(std::min(kMost, (points.size() - i) / 3));
        filigree::check(
            flgManifoldProject(workshop.context().get(), manifold.get(), points.data() + i, count, nullptr));
    }
}

}  // namespace

scenes::Mesh sheet(uint32_t columns, uint32_t rows, bool around,
                   const std::function<glm::dvec3(double u, double v)>& place) {
    scenes::Mesh mesh;
    for (uint32_t row = 0; row < rows; ++row) {
        for (uint32_t i = 0; i < columns; ++i)
            mesh.vertices.push_back(point(place(i / (around ? columns : columns - 1.0), row / (rows - 1.0))));
    }
    for (uint32_t row = 0; row + 1 < rows; ++row) {
        for (uint32_t i = 0; i + (around ? 0 : 1) < columns; ++i) {
            const uint32_t a = row * columns + i, b = row * columns + (i + 1) % columns, c = b + columns,
                           d = a + columns;
            if ((row + i) % 2 == 0) {
                mesh.triangles.push_back({a, b, c}), mesh.triangles.push_back({a, c, d});
            } else {
                mesh.triangles.push_back({a, b, d}), mesh.triangles.push_back({b, c, d});
            }
        }
    }
    return mesh;
}

Solid solid(Workshop& workshop, double half_side, uint32_t cells,
            const std::function<double(const glm::dvec3& p)>& value) {
    const uint32_t n = cells + 1;
    const double spacing = 2 * half_side / cells;
    std::vector<float> values(size_t{n} * n * n);
    const auto index = [n](uint32_t x, uint32_t y, uint32_t z) { return (size_t{z} * n + y) * n + x; };
    const auto place = [&](double x, double y, double z) { return spacing * glm::dvec3(x, y, z) - half_side; };
    for (uint32_t z = 0; z < n; ++z) {
        for (uint32_t y = 0; y < n; ++y) {
            for (uint32_t x = 0; x < n; ++x) values[index(x, y, z)] = static_cast<float>(value(place(x, y, z)));
        }
    }
    FlgManifoldFromGridDesc desc = flgManifoldFromGridDefaults();
    for (int c = 0; c < 3; ++c) desc.counts[c] = n, desc.corner[c] = -half_side;
    desc.spacing = spacing;
    desc.values = values.data();
    filigree::Manifold manifold = workshop.finished(workshop.context().manifold_from_grid(desc));
    // A vertex in the middle of each cell with both signs at its corners; a square across each edge with both.
    std::vector<uint32_t> vertex(values.size(), UINT32_MAX);
    std::vector<double> points;
    for (uint32_t z = 0; z < cells; ++z) {
        for (uint32_t y = 0; y < cells; ++y) {
            for (uint32_t x = 0; x < cells; ++x) {
                // The middle of where the cell's edges go through.
                glm::dvec3 sum(0.0);
                int crossed = 0;
                for (uint32_t k = 0; k < 8; ++k) {
                    for (uint32_t bit = 1; bit < 8; bit *= 2) {
                        const auto corner = [&](uint32_t j) {
                            return glm::uvec3(x + (j & 1), y + (j >> 1 & 1), z + (j >> 2));
                        };
                        const glm::uvec3 from = corner(k), to = corner(k | bit);
                        const double a = values[index(from.x, from.y, from.z)], b = values[index(to.x, to.y, to.z)];
                        if ((k & bit) != 0 || (a < 0) == (b < 0)) continue;
                        sum += glm::mix(glm::dvec3(from), glm::dvec3(to), a / (a - b));
                        ++crossed;
                    }
                }
                if (crossed == 0) continue;
                vertex[index(x, y, z)] = static_cast<uint32_t>(points.size() / 3);
                sum /= crossed;
                const glm::dvec3 p = place(sum.x, sum.y, sum.z);
                points.insert(points.end(), {p.x, p.y, p.z});
            }
        }
    }
    scenes::Mesh mesh;
    const std::array<size_t, 3> step = {1, n, size_t{n} * n};
    for (uint32_t z = 1; z < cells; ++z) {
        for (uint32_t y = 1; y < cells; ++y) {
            for (uint32_t x = 1; x < cells; ++x) {
                const size_t at = index(x, y, z);
                for (size_t axis = 0; axis < 3; ++axis) {
                    const bool low = values[at] < 0, high = values[at + step[axis]] < 0;
                    if (low == high) continue;
                    const size_t u = step[(axis + 1) % 3], v = step[(axis + 2) % 3];
                    uint32_t a = vertex[at - u - v], b = vertex[at - v], c = vertex[at], d = vertex[at - u];
                    if (!low) std::swap(b, d);
                    mesh.triangles.push_back({a, b, c}), mesh.triangles.push_back({a, c, d});
                }
            }
        }
    }
    project(workshop, manifold, points);
    for (size_t i = 0; i < points.size(); i += 3)
        mesh.vertices.push_back(point({points[i], points[i + 1], points[i + 2]}));
    filigree::Surface surface = surface_of(workshop, mesh);
    return {std::move(manifold), std::move(surface)};
}

scenes::Mesh box_mesh(const glm::dvec3& centre, const glm::dvec3& half) {
    scenes::Mesh mesh;
    // Corners a face of their own, so that edges stay sharp.
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            const auto first = static_cast<uint32_t>(mesh.vertices.size());
            for (uint32_t k = 0; k < 4; ++k) {
                glm::dvec3 p(0.0);
                p[axis] = sign * half[axis];
                p[(axis + 1) % 3] = half[(axis + 1) % 3] * (k == 1 || k == 2 ? sign : -sign);
                p[(axis + 2) % 3] = half[(axis + 2) % 3] * (k >= 2 ? 1 : -1);
                mesh.vertices.push_back(point(centre + p));
            }
            mesh.triangles.push_back({first, first + 1, first + 2});
            mesh.triangles.push_back({first, first + 2, first + 3});
        }
    }
    return mesh;
}

scenes::Mesh capsule_mesh(const glm::dvec3& from, const glm::dvec3& to, double radius) {
    const double length = glm::distance(from, to);
    const glm::dvec3 z = length > 0 ? (to - from) / length : glm::dvec3(0, 1, 0),
                     x = glm::normalize(glm::cross(std::abs(z.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), z)),
                     y = glm::cross(z, x);
    constexpr uint32_t kAround = 64, kRows = 66;
    constexpr double kPole = 1e-3;  // left out, of the way from pole to pole
    return sheet(kAround, kRows, true, [&](double u, double v) {
        const double angle = 2 * std::numbers::pi * u, rise = std::numbers::pi * (kPole + (1 - 2 * kPole) * v - 0.5);
        const glm::dvec3 out = std::cos(rise) * (std::cos(angle) * x + std::sin(angle) * y) + std::sin(rise) * z;
        return (rise < 0 ? from : to) + radius * out;
    });
}

}  // namespace flg::gallery
