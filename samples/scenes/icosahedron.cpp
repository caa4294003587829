// SPDX-License-Identifier: MIT
// The truncated icosahedron on its sphere: 60 vertices, 90 arcs of great circles that share them.
#include <cmath>

#include "scene_makers.h"
#include "vector.h"

namespace flg::scenes {
namespace {

constexpr double kRadius = 0.5, kTubeRadius = 0.006;  // metres
constexpr uint32_t kArcPoints = 48;

std::vector<Vector> icosahedron_vertices() {
    const double golden = 0.5 * (1.0 + std::sqrt(5.0));
    std::vector<Vector> vertices;
    for (double a : {-1.0, 1.0}) {
        for (double b : {-golden, golden}) {
            vertices.insert(vertices.end(), {Vector{0.0, a, b}, Vector{a, b, 0.0}, Vector{b, 0.0, a}});
        }
    }
    return vertices;
}

Curve arc(const Vector& from, const Vector& to) {
    Curve curve;
    const double angle = std::acos(dot(from, to));
    for (uint32_t i = 0; i < kArcPoints; ++i) {
        const double u = static_cast<double>(i) / (kArcPoints - 1);
        const Vector p = (std::sin((1.0 - u) * angle) * from + std::sin(u * angle) * to);
        curve.points.push_back(to_point((kRadius / std::sin(angle)) * p));
        curve.radii.push_back(static_cast<float>(kTubeRadius));
    }
    // What is computed from both ends differs in its last bits: the vertices themselves.
    curve.points.front() = to_point(kRadius * from);
    curve.points.back() = to_point(kRadius * to);
    curve.color = {0.08f, 0.24f, 0.50f, 1.0f};
    return curve;
}

}  // namespace

std::vector<Curve> make_icosahedron() {
    const std::vector<Vector> corners = icosahedron_vertices();
    // Edges of the icosahedron are 2 long, their thirds 2/3; so are the edges of the pentagons cut off.
    constexpr double kEdge = 2.0, kThird = kEdge / 3.0, kSlack = 1e-6;
    std::vector<Vector> vertices;
    for (const Vector& a : corners) {
        for (const Vector& b : corners) {
            if (std::abs(length(a - b) - kEdge) < kSlack) vertices.push_back((1.0 / 3.0) * (2.0 * a + b));
        }
    }
    std::vector<Curve> edges;
    for (size_t i = 0; i < vertices.size(); ++i) {
        for (size_t j = i + 1; j < vertices.size(); ++j) {
            if (std::abs(length(vertices[i] - vertices[j]) - kThird) < kSlack) {
                edges.push_back(arc(unit(vertices[i]), unit(vertices[j])));
            }
        }
    }
    return edges;
}

}  // namespace flg::scenes
