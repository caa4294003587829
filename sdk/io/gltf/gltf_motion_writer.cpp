// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.10 cameras, 3.11 animations). One node: its mesh and its camera stand
// still in it, and it moves. A quaternion and its negative are one rotation, but between them a player that does not
// look for the shorter way turns once around: each is on the side of the one before.
#include "io/gltf/gltf_motion_writer.h"

#include <cmath>
#include <numbers>

#include "io/base/entry_point.h"
#include "io/base/json_text.h"
#include "io/base/limits.h"
#include "io/gltf/gltf_mesh.h"
#include "io/gltf/gltf_rotations.h"

namespace flg::io {

namespace {

constexpr size_t pose_size = 12;
constexpr double rotation_tolerance = 1e-3;
constexpr size_t max_name = 255;
// Metres; the format asks for one. There is no far end.
constexpr const char* near_plane = "0.01";

String at(const char* array, size_t index) {
    return String(array) + "[" + to_text(index) + "]";
}

// The rows of a pose as columns.
Transform transform_of(const double* pose) {
    Transform m;
    for (size_t column = 0; column < 4; ++column) {
        for (size_t row = 0; row < 3; ++row) m[3 * column + row] = pose[4 * row + column];
    }
    return m;
}

String numbers(const float* values, size_t count) {
    String list = "[";
    for (size_t i = 0; i < count; ++i) {
        if (i != 0) list += ',';
        list += json_number(values[i]);
    }
    list += ']';
    return list;
}

}  // namespace

CheckedMotion::CheckedMotion(const FlgMotionFileWriteDesc* desc) {
    desc_ = read_given(desc, "desc");
    if (desc_.position_count == 0) fail(FLG_ERROR_INVALID_ARGUMENT, "desc.position_count", "is 0, must be at least 1");
    check_argument(desc_.times, "desc.times");
    check_argument(desc_.poses, "desc.poses");
    if (desc_.name && (strnlen(desc_.name, max_name + 1) > max_name || !is_utf8(desc_.name)))
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.name", "must be UTF-8 of at most 255 bytes");
    if (!(desc_.camera_fov_rad >= 0 && double{desc_.camera_fov_rad} < std::numbers::pi)) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.camera_fov_rad", "is %g, must be 0 or above and below pi",
             double{desc_.camera_fov_rad});
    }
    check_positions();
    check_origin(desc_.origin, "desc.origin");
    if (!desc_.mesh) return;
    mesh_.emplace(desc_.mesh, desc_.mesh_desc);
    if (mesh_->origin() != Origin{})
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.mesh.origin", "must be 0: the mesh's coordinates are the body's");
}

float CheckedMotion::time(size_t position) const {
    return static_cast<float>(position < desc_.position_count ? desc_.times[position] : desc_.end_time);
}

void CheckedMotion::check_positions() const {
    float before = -1;
    for (size_t i = 0; i < position_count(); ++i) {
        const bool end = i == desc_.position_count;
        const double given = end ? desc_.end_time : desc_.times[i];
        if (!(given >= 0 && given <= max_coordinate && time(i) > before)) {
            fail(FLG_ERROR_INVALID_ARGUMENT, end ? "desc.end_time" : at("desc.times", i),
                 "is %.9g after %.9g; times rise from 0 or later, as floats", given, double{before});
        }
        before = time(i);
    }
    for (size_t i = 0; i < desc_.position_count; ++i) {
        for (size_t k = 0; k < pose_size; ++k) {
            if (std::abs(pose(i)[k]) <= max_coordinate) continue;
            fail(FLG_ERROR_INVALID_ARGUMENT, at("desc.poses", pose_size * i + k),
                 "is %g, must be finite and at most 1e30 in size", pose(i)[k]);
        }
        if (is_rigid(transform_of(pose(i)), rotation_tolerance)) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, at("desc.poses", pose_size * i),
             "starts a pose that is no rotation: it must keep lengths within 0.001 and turn nothing inside out");
    }
}

String write_glb_motion(const CheckedMotion& motion) {
    GlbBuilder glb;
    const String materials = motion.mesh() ? add_mesh(glb, *motion.mesh()) : "";
    const size_t count = motion.position_count();
    Vector<float> times, translations, rotations;
    Rotation before = {0, 0, 0, 1};
    for (size_t i = 0; i < count; ++i) {
        const Transform m = transform_of(motion.pose(i));
        times.push_back(motion.time(i));
        for (size_t k = 9; k < m.size(); ++k) translations.push_back(static_cast<float>(m[k]));
        const Rotation q = rotation_of(m);
        const double sign = dot(q, before) < 0 ? -1 : 1;
        for (size_t k = 0; k < q.size(); ++k) {
            before[k] = sign * q[k];
            rotations.push_back(static_cast<float>(before[k]));
        }
    }
    const size_t input = glb.add_times(times);
    const auto sampler = [&](const Vector<float>& values, const char* type) {
        const size_t output = glb.add_accessor(glb.add_plain_view(values), 0, count, glb_float, type);
        return "{\"input\":" + to_text(input) + ",\"output\":" + to_text(output) + "}";
    };
    const String name = json_text(motion.name());
    const String samplers = sampler(translations, "VEC3") + "," + sampler(rotations, "VEC4");
    const String translation = json_translation(motion.origin());
    String top = "\"scene\":0,\"scenes\":[{\"nodes\":[";
    top += translation.empty() ? "0" : "1";
    top += "]}],\"nodes\":[{\"name\":" + name;
    if (motion.mesh()) top += ",\"mesh\":0";
    if (motion.camera_fov_rad() > 0) top += ",\"camera\":0";
    top +=
        ",\"translation\":" + numbers(translations.data(), 3) + ",\"rotation\":" + numbers(rotations.data(), 4) + "}";
    if (!translation.empty()) top += ",{\"children\":[0]" + translation + "}";
    top += "],";
    if (motion.camera_fov_rad() > 0) {
        top +=
            "\"cameras\":[{\"type\":\"perspective\",\"perspective\":{\"yfov\":" + json_number(motion.camera_fov_rad()) +
            ",\"znear\":" + near_plane + "}}],";
    }
    top += "\"animations\":[{\"name\":" + name +
           ",\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"translation\"}},"
           "{\"sampler\":1,\"target\":{\"node\":0,\"path\":\"rotation\"}}],\"samplers\":[" +
           samplers + "]}],";
    return glb.finish_scene(top + materials, motion.name());
}

}  // namespace flg::io
