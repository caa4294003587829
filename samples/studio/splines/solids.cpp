// SPDX-License-Identifier: MIT
#include "splines/solids.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flg::studio::splines {
namespace {

constexpr glm::vec3 kColor{0.50f, 0.44f, 0.36f}, kChosen{0.72f, 0.55f, 0.36f};

// All within a radius of a segment; a ball, where that has no length.
SolidMesh capsule(const glm::dvec3& from, const glm::dvec3& to, double radius) {
    constexpr uint32_t kAround = 48, kRows = 40;
    const double length = glm::distance(from, to);
    const glm::dvec3 z = length > 0.0 ? (to - from) / length : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 x = glm::normalize(glm::cross(std::abs(z.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), z));
    const glm::dvec3 y = glm::cross(z, x);
    SolidMesh mesh;
    // The equator is there twice: at one end and at the other.
    for (uint32_t row = 0; row < kRows; ++row) {
        const bool lower = row < kRows / 2;
        const double share = static_cast<double>(lower ? row : row - 1) / (kRows - 2);
        const double rise = std::numbers::pi * (share - 0.5);
        for (uint32_t i = 0; i < kAround; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / kAround;
            const glm::dvec3 out = std::cos(rise) * (std::cos(angle) * x + std::sin(angle) * y) + std::sin(rise) * z;
            mesh.positions.emplace_back((lower ? from : to) + radius * out);
            mesh.normals.emplace_back(out);
        }
    }
    for (uint32_t row = 0; row + 1 < kRows; ++row) {
        for (uint32_t i = 0; i < kAround; ++i) {
            const uint32_t a = row * kAround + i, b = row * kAround + (i + 1) % kAround;
            mesh.triangles.insert(mesh.triangles.end(), {a, b, b + kAround, a, b + kAround, a + kAround});
        }
    }
    return mesh;
}

// Corners a face of their own.
SolidMesh box(const glm::dvec3& centre, const glm::dvec3& half) {
    SolidMesh mesh;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            const auto first = static_cast<uint32_t>(mesh.positions.size());
            glm::dvec3 normal(0.0);
            normal[axis] = sign;
            for (uint32_t k = 0; k < 4; ++k) {
                glm::dvec3 p = normal * half;
                p[(axis + 1) % 3] = half[(axis + 1) % 3] * (k == 1 || k == 2 ? sign : -sign);
                p[(axis + 2) % 3] = half[(axis + 2) % 3] * (k >= 2 ? 1 : -1);
                mesh.positions.emplace_back(centre + p);
                mesh.normals.emplace_back(normal);
            }
            mesh.triangles.insert(mesh.triangles.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
        }
    }
    return mesh;
}

}  // namespace

SolidMesh mesh_of(const Obstacle& obstacle) {
    if (obstacle.kind == FLG_OBSTACLE_KIND_BOX) return box(obstacle.centre, obstacle.half);
    return capsule(obstacle.centre, obstacle.kind == FLG_OBSTACLE_KIND_CAPSULE ? obstacle.to : obstacle.centre,
                   obstacle.radius);
}

SolidsView::~SolidsView() {
    for (const auto& [id, drawn] : drawn_) app_.renderer.remove(drawn.id);
}

void SolidsView::update(const std::vector<Obstacle>& obstacles, uint32_t chosen) {
    std::erase_if(drawn_, [&](const auto& entry) {
        const bool stays = std::any_of(obstacles.begin(), obstacles.end(),
                                       [&](const Obstacle& obstacle) { return obstacle.id == entry.first; });
        if (!stays) app_.renderer.remove(entry.second.id);
        return !stays;
    });
    for (const Obstacle& obstacle : obstacles) {
        Drawn& drawn = drawn_[obstacle.id];
        const bool is_chosen = obstacle.id == chosen;
        if (drawn.id.value != 0 && drawn.obstacle == obstacle && drawn.chosen == is_chosen) continue;
        drawn.obstacle = obstacle;
        drawn.chosen = is_chosen;
        const SolidMesh mesh = mesh_of(obstacle);
        const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, &mesh.positions[0].x, 0, 0},
                                     {FLG_ATTRIBUTE_NORMAL, 3, &mesh.normals[0].x, 0, 0}};
        FlgMeshView view = flgMeshViewDefaults();
        view.vertex_count = static_cast<uint32_t>(mesh.positions.size());
        view.triangle_count = static_cast<uint32_t>(mesh.triangles.size() / 3);
        view.column_count = 2;
        view.columns = columns;
        view.triangles = mesh.triangles.data();
        render::SurfaceLook look;
        look.material = {is_chosen ? kChosen : kColor, 0.0f, 0.9f};
        if (drawn.id.value == 0)
            drawn.id = app_.renderer.upload(view, look);
        else
            app_.renderer.update(drawn.id, view, look);
    }
}

}  // namespace flg::studio::splines
