// SPDX-License-Identifier: MIT
#include "io/checked_skin.h"

#include <cmath>

#include "io/checked_mesh.h"
#include "io/entry_point.h"
#include "io/json_text.h"
#include "io/skin_data.h"

namespace flg::io {

namespace {

constexpr double length_tolerance = 1e-3;
constexpr double sum_tolerance = 1e-4;
constexpr size_t longest_name = 255;
constexpr uint32_t most_parts = 1u << 24;  // floats tell them apart

std::string at(const std::string& array, size_t index) {
    return array + "[" + std::to_string(index) + "]";
}

void check_floats(const float* values, size_t count, const std::string& name) {
    check_argument(values, name.c_str());
    for (size_t i = 0; i < count; ++i) {
        if (std::abs(values[i]) <= max_coordinate) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, at(name, i), "is %g, must be finite and at most 1e30 in size",
             double{values[i]});
    }
}

void check_name(const char* name, const std::string& place) {
    if (!name || (strnlen(name, longest_name + 1) <= longest_name && is_utf8(name))) return;
    fail(FLG_ERROR_INVALID_ARGUMENT, place, "must be UTF-8 of at most 255 bytes");
}

}  // namespace

FlgSkinFileDesc skin_file_defaults() {
    FlgSkinFileDesc desc = {};
    desc.struct_size = sizeof desc;
    return desc;
}

CheckedSkin::CheckedSkin(const FlgSkinFileDesc* desc) {
    check_argument(desc, "desc");
    check_size<FlgSkinFileDesc>(desc->struct_size, "desc");
    std::memcpy(&desc_, desc, sizeof desc_);
    check_argument(desc_.skin, "desc.skin");
    check_size<FlgSkinView>(desc_.skin->struct_size, "desc.skin");
    std::memcpy(&skin_, desc_.skin, sizeof skin_);
    check_name(desc_.name, "desc.name");
    check_joints();
    check_vertices();
    check_triangles();
    if (desc_.animation_count != 0) check_argument(desc_.animations, "desc.animations");
    for (uint32_t i = 0; i < desc_.animation_count; ++i) check_animation(i);
    check_materials();
}

void CheckedSkin::check_joints() const {
    if (skin_.joint_count == 0 || skin_.joint_count > most_joints) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.skin.joint_count", "is %u, must be 1 to %u", skin_.joint_count,
             most_joints);
    }
    check_floats(skin_.joint_positions, 3 * joint_count(), "desc.skin.joint_positions");
    check_argument(skin_.joint_parents, "desc.skin.joint_parents");
    for (uint32_t j = 0; j < skin_.joint_count; ++j) {
        const uint32_t parent = skin_.joint_parents[j];
        if (parent != FLG_NO_INDEX && parent >= j) {
            fail(FLG_ERROR_INVALID_ARGUMENT, at("desc.skin.joint_parents", j),
                 "is %u, must be lower than the joint, or FLG_NO_INDEX", parent);
        }
        if (!skin_.joint_names) continue;
        check_argument(skin_.joint_names[j], at("desc.skin.joint_names", j).c_str());
        check_name(skin_.joint_names[j], at("desc.skin.joint_names", j));
    }
}

void CheckedSkin::check_vertices() const {
    if (skin_.vertex_count == 0) fail(FLG_ERROR_INVALID_ARGUMENT, "desc.skin.vertex_count", "is 0, must be at least 1");
    check_floats(skin_.positions, 3 * vertex_count(), "desc.skin.positions");
    check_floats(skin_.normals, 3 * vertex_count(), "desc.skin.normals");
    check_argument(skin_.vertex_joints, "desc.skin.vertex_joints");
    check_argument(skin_.vertex_weights, "desc.skin.vertex_weights");
    for (size_t v = 0; v < vertex_count(); ++v) {
        check_binding(v);
        if (part(v) < most_parts) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, at("desc.skin.vertex_parts", v), "is %u, must be below %u", part(v),
             most_parts);
    }
}

void CheckedSkin::check_binding(size_t vertex) const {
    const uint16_t* joints = skin_.vertex_joints + joints_a_vertex * vertex;
    const float* weights = skin_.vertex_weights + joints_a_vertex * vertex;
    double sum = 0;
    for (size_t k = 0; k < joints_a_vertex; ++k) {
        const size_t i = joints_a_vertex * vertex + k;
        if (joints[k] >= skin_.joint_count) {
            fail(FLG_ERROR_INVALID_ARGUMENT, at("desc.skin.vertex_joints", i), "is %u, but there are %u joints",
                 joints[k], skin_.joint_count);
        }
        if (!(weights[k] >= 0 && weights[k] <= 1 + sum_tolerance)) {
            fail(FLG_ERROR_INVALID_ARGUMENT, at("desc.skin.vertex_weights", i), "is %g, must be 0 to 1",
                 double{weights[k]});
        }
        for (size_t other = 0; weights[k] > 0 && other < k; ++other) {
            if (joints[other] != joints[k] || weights[other] == 0) continue;
            fail(FLG_ERROR_INVALID_ARGUMENT, at("desc.skin.vertex_joints", i), "is %u, which vertex %zu has already",
                 joints[k], vertex);
        }
        sum += weights[k];
    }
    if (std::abs(sum - 1) <= sum_tolerance) return;
    fail(FLG_ERROR_INVALID_ARGUMENT, at("desc.skin.vertex_weights", joints_a_vertex * vertex),
         "and the next three sum up to %g, must be 1", sum);
}

void CheckedSkin::check_triangles() const {
    if (skin_.triangle_count == 0) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.skin.triangle_count", "is 0: there is nothing to write");
    }
    check_argument(skin_.triangles, "desc.skin.triangles");
    for (size_t i = 0; i < 3 * size_t{skin_.triangle_count}; ++i) {
        if (skin_.triangles[i] < skin_.vertex_count) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, at("desc.skin.triangles", i), "is %u, but there are %u vertices",
             skin_.triangles[i], skin_.vertex_count);
    }
}

void CheckedSkin::check_animation(uint32_t index) const {
    const std::string place = at("desc.animations", index);
    const FlgSkinAnimation& animation = desc_.animations[index];
    check_size<FlgSkinAnimation>(animation.struct_size, place.c_str());
    check_name(animation.name, place + ".name");
    if (animation.key_count == 0) fail(FLG_ERROR_INVALID_ARGUMENT, place + ".key_count", "is 0, must be at least 1");
    check_floats(animation.times, animation.key_count, place + ".times");
    float before = -1;
    for (uint32_t key = 0; key < animation.key_count; ++key) {
        if (!(animation.times[key] >= 0 && animation.times[key] > before)) {
            fail(FLG_ERROR_INVALID_ARGUMENT, at(place + ".times", key), "is %g after %g; times rise from 0 or later",
                 double{animation.times[key]}, double{before});
        }
        before = animation.times[key];
    }
    const size_t turns = animation.key_count * joint_count();
    check_floats(animation.rotations, 4 * turns, place + ".rotations");
    for (size_t i = 0; i < turns; ++i) {
        const float* q = animation.rotations + 4 * i;
        const double size = std::hypot(std::hypot(double{q[0]}, q[1]), std::hypot(double{q[2]}, q[3]));
        if (std::abs(size - 1) <= length_tolerance) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, at(place + ".rotations", 4 * i),
             "starts a quaternion that is %g long, must be 1", size);
    }
    if (animation.translations)
        check_floats(animation.translations, 3 * size_t{animation.key_count}, place + ".translations");
}

void CheckedSkin::check_materials() const {
    if (desc_.material_count == 0) return;
    check_argument(desc_.materials, "desc.materials");
    for (uint32_t i = 0; i < desc_.material_count; ++i)
        check_material(desc_.materials[i], at("desc.materials", i) + ".");
    for (size_t v = 0; desc_.material_count > 1 && v < vertex_count(); ++v) {
        if (part(v) < desc_.material_count) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, at("desc.skin.vertex_parts", v), "is %u, but there are %u materials", part(v),
             desc_.material_count);
    }
}

}  // namespace flg::io
