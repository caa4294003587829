// SPDX-License-Identifier: MIT
#include "skin_data.h"

#include <algorithm>
#include <cmath>

#include "packing.h"
#include "vk.h"

namespace flg::render {
namespace {

constexpr float sum_tolerance = 1e-4f;
constexpr float length_tolerance = 1e-3f;
constexpr uint32_t max_joints = 65535;
constexpr float whole = 65535.0f;
constexpr float no_reach = 1e-6f;  // weights that are 1 but for rounding

void check_skin(const FlgSkinView& skin) {
    if (skin.joint_count == 0 || skin.joint_count > max_joints)
        fail("The skin has %u joints; it must have 1 to %u.", skin.joint_count, max_joints);
    if (!skin.positions || !skin.vertex_joints || !skin.vertex_weights)
        fail("The skin has no positions, vertex_joints or vertex_weights.");
    for (size_t i = 0; i < 4 * size_t{skin.vertex_count}; i += 4) {
        const uint16_t* joints = skin.vertex_joints + i;
        const float* weights = skin.vertex_weights + i;
        float sum = 0.0f;
        for (int k = 0; k < 4; ++k) {
            if (joints[k] >= skin.joint_count)
                fail("Vertex %zu names joint %u; the skin has %u.", i / 4, joints[k], skin.joint_count);
            if (!(weights[k] >= 0.0f && weights[k] <= weights[0]))
                fail("Vertex %zu has the weight %g; it must be 0 to that of its first joint, %g.", i / 4, weights[k],
                     weights[0]);
            sum += weights[k];
        }
        if (!(std::abs(sum - 1.0f) <= sum_tolerance))
            fail("The weights of vertex %zu sum up to %g; it must be 1.", i / 4, sum);
    }
}

void check_look(const SurfaceLook& look) {
    const bool has_lines =
        std::ranges::any_of(look.regions, [](const Material& m) { return m.border_width_px != 0.0f; });
    if (has_lines || look.border_width_px != 0.0f)
        fail("A skinned surface has no lines between its parts: border_width_px must be 0.");
}

SkinVertex pack_vertex(const uint16_t* joints, const float* weights) {
    SkinVertex vertex;
    uint32_t left = static_cast<uint32_t>(whole);
    for (int k = 1; k < 4; ++k) {
        const auto share = static_cast<uint32_t>(whole * weights[k] + 0.5f);
        vertex.weights[k] = static_cast<uint16_t>(std::min(share, left));
        left -= vertex.weights[k];
    }
    vertex.weights[0] = static_cast<uint16_t>(left);
    std::copy_n(joints, 4, vertex.joints);
    return vertex;
}

// The skin's, else the part that two of a triangle's corners are of, else the first's.
std::vector<uint32_t> triangle_parts(const FlgSkinView& skin) {
    std::vector<uint32_t> parts;
    parts.reserve(skin.triangle_count);
    for (size_t i = 0; i < 3 * size_t{skin.triangle_count}; i += 3) {
        const uint32_t* corners = skin.triangles + i;
        for (int k = 0; k < 3; ++k)
            if (corners[k] >= skin.vertex_count)
                fail("Triangle %zu names vertex %u; the mesh has %u vertices.", i / 3, corners[k], skin.vertex_count);
        if (skin.triangle_parts) {
            parts.push_back(skin.triangle_parts[i / 3]);
            continue;
        }
        const uint32_t a = skin.vertex_parts[corners[0]], b = skin.vertex_parts[corners[1]];
        parts.push_back(b == skin.vertex_parts[corners[2]] ? b : a);
    }
    return parts;
}

// Triangles with corners of two parts get corners of their own, which say whose each is: the shader draws the border
// between, through the middles of edges, rather than along them. Of three parts two are told apart.
void mark_other_parts(SurfaceData& data, const FlgSkinView& skin, const SurfaceLook& look) {
    const auto part_of = [&](uint32_t vertex) {
        return skin.vertex_parts[vertex < skin.vertex_count ? vertex : data.copied[vertex - skin.vertex_count]];
    };
    for (size_t i = 0; i < data.indices.size(); i += 3) {
        uint32_t* corners = &data.indices[i];
        const uint32_t parts[3] = {part_of(corners[0]), part_of(corners[1]), part_of(corners[2])};
        const uint32_t own = parts[1] == parts[2] ? parts[1] : parts[0];  // as triangle_parts() has it
        const auto other = std::ranges::find_if(parts, [&](uint32_t part) { return part != own; });
        if (other == std::end(parts)) continue;
        const glm::vec3 other_color = look.regions[*other % look.regions.size()].color;
        for (int k = 0; k < 3; ++k) {
            const uint32_t from = corners[k];
            SurfaceVertex vertex = data.vertices[from];
            const uint32_t source = from < skin.vertex_count ? from : data.copied[from - skin.vertex_count];
            vertex.other_color = packed_color(other_color * vertex_color(look, source));
            if (parts[k] != own) vertex.material &= ~own_part;
            if (data.positions.size() == max_vertices)
                fail("The skin has more than %u vertices, those between parts counted once a triangle.", max_vertices);
            corners[k] = static_cast<uint32_t>(data.positions.size());
            data.copied.push_back(source);
            data.positions.push_back(glm::vec3(data.positions[from]));
            data.vertices.push_back(vertex);
        }
    }
}

struct Rows {
    glm::vec4 row[3];
    glm::vec3 operator()(const glm::vec3& p) const {
        const glm::vec4 q(p, 1.0f);
        return {glm::dot(row[0], q), glm::dot(row[1], q), glm::dot(row[2], q)};
    }
};

Rows rows_of(FlgSkinning skinning, const float* t) {
    if (skinning == FLG_SKINNING_LINEAR)
        return {{{t[0], t[1], t[2], t[3]}, {t[4], t[5], t[6], t[7]}, {t[8], t[9], t[10], t[11]}}};
    const glm::vec3 r(t[0], t[1], t[2]), d(t[4], t[5], t[6]);
    const glm::vec3 moved = 2.0f * (t[3] * d - t[7] * r + glm::cross(r, d));
    Rows rows{};
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 unit(0.0f);
        unit[axis] = 1.0f;
        const glm::vec3 turned = unit + 2.0f * glm::cross(r, glm::cross(r, unit) + t[3] * unit);
        for (int row = 0; row < 3; ++row) rows.row[row][axis] = turned[row];
    }
    for (int row = 0; row < 3; ++row) rows.row[row][3] = moved[row];
    return rows;
}

glm::vec3 corner_of(const Box& box, int index) {
    return {index & 1 ? box.max.x : box.min.x, index & 2 ? box.max.y : box.min.y, index & 4 ? box.max.z : box.min.z};
}

}  // namespace

void SkinBounds::add(const glm::vec3& position, const uint16_t* joints, const float* weights) {
    const Box point{position, position};
    Joint& joint = joints_[joints[0]];
    joint.box.add(point);
    const float rest = std::max(1.0f - weights[0], 0.0f) + no_reach;
    bool is_shared = false;
    for (int k = 1; k < 4; ++k) {
        if (weights[k] == 0.0f) continue;
        is_shared = true;
        const auto found =
            std::ranges::find_if(joint.others, [&](const Other& other) { return other.joint == joints[k]; });
        if (found == joint.others.end()) {
            joint.others.push_back({joints[k], point});
        } else {
            found->box.add(point);
        }
    }
    if (!is_shared) return;
    joint.linear_reach = std::max(joint.linear_reach, rest);
    joint.dual_reach = std::max(joint.dual_reach, rest / weights[0]);
}

Box SkinBounds::at(FlgSkinning skinning, std::span<const float> transforms) const {
    const size_t size = floats_of(skinning);
    Box all;
    for (size_t j = 0; j < joints_.size(); ++j) {
        const Joint& joint = joints_[j];
        if (joint.box.empty()) continue;
        const Rows motion = rows_of(skinning, &transforms[size * j]);
        float furthest = 0.0f;
        for (const Other& other : joint.others) {
            const Rows others = rows_of(skinning, &transforms[size * other.joint]);
            for (int c = 0; c < 8; ++c) {
                const glm::vec3 corner = corner_of(other.box, c);
                furthest = std::max(furthest, glm::length(others(corner) - motion(corner)));
            }
        }
        const glm::vec3 reach(furthest * (skinning == FLG_SKINNING_LINEAR ? joint.linear_reach : joint.dual_reach));
        for (int c = 0; c < 8; ++c) {
            const glm::vec3 corner = motion(corner_of(joint.box, c));
            all.add({corner - reach, corner + reach});
        }
    }
    return all;
}

SkinData prepare_skin(const FlgSkinView& skin, const SurfaceLook& look) {
    check_skin(skin);
    check_look(look);
    std::vector<FlgColumn> columns = {{FLG_ATTRIBUTE_POSITION, 3, skin.positions, 0, 0}};
    if (skin.normals) columns.push_back({FLG_ATTRIBUTE_NORMAL, 3, skin.normals, 0, 0});
    FlgMeshView mesh{};
    mesh.struct_size = sizeof mesh;
    mesh.vertex_count = skin.vertex_count;
    mesh.triangle_count = skin.triangle_count;
    mesh.columns = columns.data();
    mesh.column_count = static_cast<uint32_t>(columns.size());
    mesh.triangles = skin.triangles;
    std::vector<uint32_t> parts;
    if (skin.vertex_parts && skin.triangles && look.regions.size() > 1) parts = triangle_parts(skin);
    mesh.regions = parts.empty() ? nullptr : parts.data();
    SurfaceLook own = look;
    if (skin.corner_uvs) own.corner_uvs = {skin.corner_uvs, 6 * size_t{skin.triangle_count}};
    SkinData data{prepare_surface(mesh, own, {}), {}, SkinBounds(skin.joint_count)};
    // Textures leave no room for another part's colour.
    if (!parts.empty() && !skin.triangle_parts && data.surface.uvs.empty()) mark_other_parts(data.surface, skin, look);
    data.vertices.reserve(data.surface.positions.size());
    for (size_t v = 0; v < skin.vertex_count; ++v) {
        const uint16_t* joints = skin.vertex_joints + 4 * v;
        const float* weights = skin.vertex_weights + 4 * v;
        data.vertices.push_back(pack_vertex(joints, weights));
        data.bounds.add(data.surface.positions[v], joints, weights);
    }
    for (const uint32_t source : data.surface.copied) data.vertices.push_back(data.vertices[source]);
    return data;
}

uint32_t floats_of(FlgSkinning skinning) {
    return skinning == FLG_SKINNING_LINEAR ? 12 : 8;
}

void check_pose(FlgSkinning skinning, std::span<const float> transforms, uint32_t joint_count) {
    if (skinning != FLG_SKINNING_LINEAR && skinning != FLG_SKINNING_DUAL_QUATERNION)
        fail("The skinning is %d; it must be one of FLG_SKINNING_...", static_cast<int>(skinning));
    const size_t size = floats_of(skinning);
    if (transforms.size() != size * joint_count)
        fail("The pose has %zu floats; %u joints take %zu.", transforms.size(), joint_count, size * joint_count);
    for (size_t i = 0; i < transforms.size(); ++i)
        if (!(std::abs(transforms[i]) <= largest_coordinate))
            fail("The pose's float %zu is %g; it must be finite, at most 1e30.", i, transforms[i]);
    for (size_t i = 0; skinning != FLG_SKINNING_LINEAR && i < transforms.size(); i += size) {
        const float length =
            glm::length(glm::vec4(transforms[i], transforms[i + 1], transforms[i + 2], transforms[i + 3]));
        if (!(std::abs(length - 1.0f) <= length_tolerance))
            fail("The quaternion of joint %zu is %g long; it must be 1.", i / size, length);
    }
}

}  // namespace flg::render
