// SPDX-License-Identifier: MIT
#include "scene/bend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <utility>

#include "filigree/filigree.hpp"

namespace flg::studio {
namespace {

constexpr size_t kNearest = 4;  // vertices of the skin that hold a place
constexpr size_t kHolds = 4;    // joints of a place, as the renderer takes them

// The mean of a triangle's edges, from some of them.
float edge_length(const FlgSkinView& skin) {
    constexpr uint32_t kSome = 1000;
    const uint32_t step = std::max(skin.triangle_count / kSome, 1u);
    double sum = 0.0;
    uint32_t count = 0;
    for (uint32_t t = 0; t < skin.triangle_count; t += step, ++count) {
        const uint32_t* corners = skin.triangles + size_t{3} * t;
        sum += glm::distance(glm::make_vec3(skin.positions + size_t{3} * corners[0]),
                             glm::make_vec3(skin.positions + size_t{3} * corners[1]));
    }
    return std::max(static_cast<float>(sum / std::max(count, 1u)), 1e-6f);
}

// The heaviest joints, the largest weight first, with the sum 1.
void push_heaviest(std::map<uint16_t, float>& weight_of, SkinWeights& out) {
    std::array<std::pair<float, uint16_t>, kHolds> best{};
    for (const auto& [joint, weight] : weight_of) {
        if (weight <= best.back().first) continue;
        best.back() = {weight, joint};
        for (size_t k = kHolds - 1; k > 0 && best[k].first > best[k - 1].first; --k) std::swap(best[k], best[k - 1]);
    }
    float sum = 0.0f;
    for (const auto& [weight, joint] : best) sum += weight;
    for (const auto& [weight, joint] : best) {
        out.joints.push_back(joint);
        out.weights.push_back(weight / sum);
    }
}

// As the renderer makes them: means of the triangles around, by their angles.
std::vector<glm::vec3> smooth_normals(const MeshCopy& mesh) {
    std::vector<glm::vec3> normals(mesh.positions.size(), glm::vec3(0.0f));
    for (size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const uint32_t* corners = &mesh.triangles[i];
        for (int k = 0; k < 3; ++k) {
            const glm::vec3& at = mesh.positions[corners[k]];
            const glm::vec3 to_next = mesh.positions[corners[(k + 1) % 3]] - at;
            const glm::vec3 to_last = mesh.positions[corners[(k + 2) % 3]] - at;
            const glm::vec3 across = glm::cross(to_next, to_last);
            const float area = glm::length(across);
            if (area > 0.0f) normals[corners[k]] += std::atan2(area, glm::dot(to_next, to_last)) / area * across;
        }
    }
    for (glm::vec3& normal : normals) {
        const float length = glm::length(normal);
        normal = length > 0.0f ? normal / length : glm::vec3(0.0f, 1.0f, 0.0f);
    }
    return normals;
}

}  // namespace

SkinCopy::SkinCopy(const FlgSkinView& skin) : cell_(1.5f * edge_length(skin)) {
    positions_.reserve(skin.vertex_count);
    for (uint32_t v = 0; v < skin.vertex_count; ++v) {
        positions_.push_back(glm::make_vec3(skin.positions + size_t{3} * v));
        cells_[cell_of(positions_.back(), glm::ivec3(0))].push_back(v);
    }
    const size_t count = kHolds * skin.vertex_count;
    hold_ = {{skin.vertex_joints, skin.vertex_joints + count}, {skin.vertex_weights, skin.vertex_weights + count}};
}

uint64_t SkinCopy::cell_of(const glm::vec3& place, const glm::ivec3& beside) const {
    constexpr int64_t kMiddle = 1 << 20, kMask = (1 << 21) - 1;
    uint64_t cell = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const int64_t at = static_cast<int64_t>(std::floor(place[axis] / cell_)) + beside[axis] + kMiddle;
        cell = cell << 21 | static_cast<uint64_t>(at & kMask);
    }
    return cell;
}

SkinWeights SkinCopy::hold(std::span<const glm::vec3> places) const {
    constexpr int kFarthest = 6;  // cells; farther away any vertex is as good
    SkinWeights hold;
    std::map<uint16_t, float> weight_of;
    for (const glm::vec3& place : places) {
        std::array<std::pair<float, uint32_t>, kNearest> nearest;
        nearest.fill({std::numeric_limits<float>::infinity(), 0});
        const auto look = [&](uint32_t v) {
            const glm::vec3 way = positions_[v] - place;
            const float square = glm::dot(way, way);
            if (square >= nearest.back().first) return;
            nearest.back() = {square, v};
            for (size_t k = kNearest - 1; k > 0 && nearest[k].first < nearest[k - 1].first; --k)
                std::swap(nearest[k], nearest[k - 1]);
        };
        bool is_found = false;
        for (int reach = 1; reach <= kFarthest && !is_found; reach += reach) {
            for (int x = -reach; x <= reach; ++x)
                for (int y = -reach; y <= reach; ++y)
                    for (int z = -reach; z <= reach; ++z)
                        if (const auto cell = cells_.find(cell_of(place, {x, y, z})); cell != cells_.end())
                            for (const uint32_t v : cell->second) look(v);
            is_found = std::isfinite(nearest.back().first);
            if (!is_found) nearest.fill({std::numeric_limits<float>::infinity(), 0});
        }
        if (!is_found)
            for (uint32_t v = 0; v < positions_.size(); ++v) look(v);
        // By the inverse square of the distance: vertices of the skin itself are held as they are.
        constexpr float kSame = 1e-6f;  // of a cell
        const float least = kSame * cell_ * kSame * cell_;
        weight_of.clear();
        for (const auto& [square, v] : nearest) {
            if (!std::isfinite(square)) continue;
            for (size_t k = 0; k < kHolds; ++k)
                weight_of[hold_.joints[kHolds * v + k]] += hold_.weights[kHolds * v + k] / (square + least);
        }
        push_heaviest(weight_of, hold);
    }
    return hold;
}

void Bend::take(const FlgSkinView& skin) {
    skin_ = std::make_shared<const SkinCopy>(skin);
    rest();
}

void Bend::rest() {
    if (!is_bent()) return;
    dual_quaternions_.clear();
    ++revision_;
}

void Bend::pose(std::vector<float> dual_quaternions) {
    if (dual_quaternions == dual_quaternions_) return;
    dual_quaternions_ = std::move(dual_quaternions);
    ++revision_;
}

void Bend::move(const SkinWeights& hold, std::vector<glm::vec3>& positions, std::vector<glm::vec3>& normals) const {
    FlgSkinView view = flgSkinViewDefaults();
    view.vertex_count = static_cast<uint32_t>(positions.size());
    view.joint_count = static_cast<uint32_t>(dual_quaternions_.size() / 8);
    const std::vector<glm::vec3> at_rest = positions, normals_at_rest = normals;
    view.positions = &at_rest[0].x;
    view.normals = &normals_at_rest[0].x;
    view.vertex_joints = hold.joints.data();
    view.vertex_weights = hold.weights.data();
    filigree::check(
        flgSkinDeform(&view, FLG_SKINNING_DUAL_QUATERNION, dual_quaternions_.data(), &positions[0].x, &normals[0].x));
}

FlgSkinView BentMesh::view(size_t joint_count) const {
    FlgSkinView view = flgSkinViewDefaults();
    view.vertex_count = static_cast<uint32_t>(positions.size());
    view.triangle_count = static_cast<uint32_t>(triangles.size() / 3);
    view.joint_count = static_cast<uint32_t>(joint_count);
    view.positions = &positions[0].x;
    view.normals = &normals[0].x;
    view.triangles = triangles.data();
    view.vertex_joints = hold.joints.data();
    view.vertex_weights = hold.weights.data();
    view.vertex_parts = parts.data();
    return view;
}

MeshCopy::MeshCopy(const FlgMeshView& mesh, render::SurfaceLook of) : look(std::move(of)) {
    for (uint32_t c = 0; c < mesh.column_count; ++c) {
        const FlgColumn& column = mesh.columns[c];
        const size_t stride = column.stride != 0 ? column.stride / sizeof(float) : column.components;
        std::vector<glm::vec3>* out = column.attribute == FLG_ATTRIBUTE_POSITION ? &positions
                                      : column.attribute == FLG_ATTRIBUTE_COLOR  ? &colors
                                                                                 : nullptr;
        if (out == nullptr) continue;
        for (uint32_t v = 0; v < mesh.vertex_count; ++v) out->push_back(glm::make_vec3(column.data + stride * v));
    }
    triangles.assign(mesh.triangles, mesh.triangles + size_t{3} * mesh.triangle_count);
    if (mesh.regions != nullptr) labels.assign(mesh.regions, mesh.regions + mesh.triangle_count);
}

BentMesh bend_mesh(const MeshCopy& mesh, const SkinCopy& skin) {
    BentMesh bent;
    bent.look = mesh.look;
    bent.look.border_width_px = 0.0f;
    for (render::Material& material : bent.look.regions) material.border_width_px = 0.0f;
    const std::vector<glm::vec3> normals = smooth_normals(mesh);
    const bool has_regions = !mesh.labels.empty() && !mesh.look.regions.empty();
    if (!has_regions) bent.look.regions.clear();
    std::map<std::array<float, 3>, uint32_t> label_of;  // of a colour, where there are no regions
    const auto label_at = [&](size_t triangle, uint32_t vertex) {
        if (has_regions) return mesh.labels[triangle];
        const glm::vec3 color = mesh.colors.empty() ? mesh.look.material.color : mesh.colors[vertex];
        const auto [found, is_new] =
            label_of.emplace(std::array{color.x, color.y, color.z}, static_cast<uint32_t>(bent.look.regions.size()));
        if (is_new) {
            bent.look.regions.push_back(mesh.look.material);
            bent.look.regions.back().color = color;
            bent.look.regions.back().border_width_px = 0.0f;
        }
        return found->second;
    };
    // A vertex between regions is there once in each.
    std::unordered_map<uint64_t, uint32_t> copy_of;
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        const uint32_t vertex = mesh.triangles[i], label = label_at(i / 3, vertex);
        const auto [found, is_new] =
            copy_of.emplace(uint64_t{label} << 32 | vertex, static_cast<uint32_t>(bent.positions.size()));
        if (is_new) {
            bent.positions.push_back(mesh.positions[vertex]);
            bent.normals.push_back(normals[vertex]);
            bent.parts.push_back(label);
        }
        bent.triangles.push_back(found->second);
    }
    bent.hold = skin.hold(bent.positions);
    return bent;
}

}  // namespace flg::studio
