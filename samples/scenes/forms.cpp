// SPDX-License-Identifier: MIT
// Surfaces of 70 thousand to 1.5 million triangles, made here: turned on a lathe, blown up from a cube, hung as a
// cloth.
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <span>

#include "scenes/scenes.h"

namespace flg::scenes {
namespace {

using Triangle = std::array<uint32_t, 3>;

// Squares between `width` vertices in a row, the last row of vertices being there; diagonals change from one to the
// next. The right neighbour of the last vertex of a row is the first one if `around`.
void add_squares(Mesh& mesh, uint32_t first, uint32_t width, uint32_t height, bool around) {
    for (uint32_t row = 0; row + 1 < height; ++row) {
        for (uint32_t i = 0; i + (around ? 0 : 1) < width; ++i) {
            const uint32_t right = (i + 1) % width, low = first + row * width, high = low + width;
            const uint32_t a = low + i, b = low + right, c = high + right, d = high + i;
            if ((row + i) % 2 == 0) {
                mesh.triangles.insert(mesh.triangles.end(), {Triangle{a, b, c}, Triangle{a, c, d}});
            } else {
                mesh.triangles.insert(mesh.triangles.end(), {Triangle{a, b, d}, Triangle{b, c, d}});
            }
        }
    }
}

// Radius and height of a smooth curve through points: Catmull and Rom's.
glm::vec2 point_of_profile(std::span<const glm::vec2> points, double share) {
    const double at = share * static_cast<double>(points.size() - 1);
    const auto i = std::min(static_cast<size_t>(at), points.size() - 2);
    const auto t = static_cast<float>(at - static_cast<double>(i));
    const glm::vec2 b = points[i], c = points[i + 1], a = i == 0 ? 2.0f * b - c : points[i - 1],
                    d = i + 2 == points.size() ? 2.0f * c - b : points[i + 2];
    return b + 0.5f * t * (c - a + t * (2.0f * a - 5.0f * b + 4.0f * c - d + t * (3.0f * (b - c) + d - a)));
}

Mesh turned(std::span<const glm::vec2> profile, uint32_t columns, uint32_t rows) {
    Mesh mesh;
    for (uint32_t row = 0; row < rows; ++row) {
        const glm::vec2 p = point_of_profile(profile, row / (rows - 1.0));
        for (uint32_t i = 0; i < columns; ++i) {
            const double angle = -2.0 * std::numbers::pi * i / columns;
            mesh.vertices.push_back(
                {p.x * static_cast<float>(std::cos(angle)), p.y, p.x * static_cast<float>(std::sin(angle))});
        }
    }
    add_squares(mesh, 0, columns, rows, true);
    return mesh;
}

// A cube of side * side vertices a face, blown up to a ball of the radius 1, whose points `place` then moves.
template <class Place>
Mesh blown(uint32_t side, Place&& place) {
    Mesh mesh;
    for (int face = 0; face < 6; ++face) {
        const auto first = static_cast<uint32_t>(mesh.vertices.size());
        for (uint32_t row = 0; row < side; ++row) {
            for (uint32_t i = 0; i < side; ++i) {
                // Equal angles along the middle of a face, so that triangles are of much the same size.
                const auto along = [&](uint32_t k) {
                    return static_cast<float>(std::tan(std::numbers::pi / 4 * (2.0 * k / (side - 1.0) - 1.0)));
                };
                glm::vec3 p(0.0f);
                const int axis = face / 2;
                const float sign = face % 2 == 0 ? 1.0f : -1.0f;
                p[axis] = sign;
                p[(axis + 1) % 3] = sign * along(i);
                p[(axis + 2) % 3] = along(row);
                p = place(glm::normalize(p));
                mesh.vertices.push_back({p.x, p.y, p.z});
            }
        }
        add_squares(mesh, first, side, side, false);
    }
    return mesh;
}

}  // namespace

Mesh make_vase(uint32_t columns) {
    constexpr glm::vec2 kProfile[] = {{0.17f, 0.00f}, {0.15f, 0.07f}, {0.27f, 0.27f}, {0.35f, 0.47f}, {0.34f, 0.66f},
                                      {0.23f, 0.83f}, {0.14f, 0.95f}, {0.14f, 1.06f}, {0.19f, 1.14f}};
    return turned(kProfile, columns, columns / 2);
}

Mesh make_dish() {
    constexpr glm::vec2 kProfile[] = {{0.50f, 0.00f}, {0.46f, 0.13f}, {0.37f, 0.21f},
                                      {0.26f, 0.24f}, {0.17f, 0.23f}, {0.11f, 0.20f}};
    Mesh mesh = turned(kProfile, 480, 160);
    for (Point& p : mesh.vertices) {
        // Lobes grow with the radius.
        const float radius = std::hypot(p.x, p.z), angle = std::atan2(p.z, p.x);
        const float larger = 1.0f + 0.28f * radius * radius * std::cos(5.0f * angle);
        p = {larger * p.x, p.y, larger * p.z};
    }
    return mesh;
}

Mesh make_ball_mesh() {
    constexpr uint32_t kSide = 150;
    constexpr float kRadius = 0.5f;
    return blown(kSide, [](glm::vec3 p) { return kRadius * p; });
}

Mesh make_egg() {
    constexpr uint32_t kSide = 355;
    return blown(kSide, [](glm::vec3 p) {
        const float width = 0.37f * (1.0f - p.y * (0.16f + 0.02f * p.y));
        return glm::vec3(width * p.x, 0.5f + 0.5f * p.y, width * p.z);
    });
}

Mesh make_cloth() {
    constexpr uint32_t kSide = 260;
    Mesh mesh;
    for (uint32_t row = 0; row < kSide; ++row) {
        for (uint32_t i = 0; i < kSide; ++i) {
            const auto x = static_cast<float>(i / (kSide - 1.0)), y = static_cast<float>(row / (kSide - 1.0));
            const float height = 0.035f * (std::cos(6.3f * x) + std::cos(6.3f * y));
            mesh.vertices.push_back({x, height, 1.0f - y});
        }
    }
    add_squares(mesh, 0, kSide, kSide, false);
    return mesh;
}

Mesh make_torus() {
    constexpr uint32_t kAround = 320, kAcross = 128;
    constexpr float kRing = 0.28f, kTube = 0.12f;
    Mesh mesh;
    for (uint32_t row = 0; row < kAround; ++row) {
        const double along = -2.0 * std::numbers::pi * row / kAround;
        for (uint32_t i = 0; i < kAcross; ++i) {
            const double across = 2.0 * std::numbers::pi * i / kAcross;
            const double radius = kRing + kTube * std::cos(across);
            mesh.vertices.push_back({static_cast<float>(radius * std::sin(along)),
                                     static_cast<float>(kTube * (1.0 + std::sin(across))),
                                     static_cast<float>(radius * std::cos(along))});
        }
    }
    add_squares(mesh, 0, kAcross, kAround, true);
    // The last ring and the first.
    const uint32_t last = (kAround - 1) * kAcross;
    for (uint32_t i = 0; i < kAcross; ++i) {
        const uint32_t right = (i + 1) % kAcross;
        mesh.triangles.insert(mesh.triangles.end(),
                              {Triangle{last + i, last + right, right}, Triangle{last + i, right, i}});
    }
    return mesh;
}

}  // namespace flg::scenes
