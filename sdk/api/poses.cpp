// SPDX-License-Identifier: MIT
// Poses of skins: skins and animations are checked at the door. No context: nothing is kept.
#include <algorithm>
#include <array>
#include <vector>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "bones/skin_pose.h"
#include "filigree/filigree_model.h"
#include "skeletons/bone_tree.h"

namespace flg {

namespace {

constexpr uint32_t max_joints = 65535;
constexpr double length_tolerance = 1e-3;  // of quaternions of length 1
constexpr float weight_tolerance = 1e-4f;  // of weights whose sum is 1
constexpr size_t joints_on_stack = 256;

void check_coordinates(const float* values, size_t index, const char* name) {
    for (size_t k = 3 * index; k < 3 * index + 3; ++k) {
        if (is_coordinate(values[k])) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%zu] is %g, must be finite and at most 1e30 in size", name, k,
                      double{values[k]});
    }
}

void check_rotation(const float* rotations, size_t index, const char* name) {
    const float* q = rotations + 4 * index;
    const double length = std::hypot(std::hypot(double{q[0]}, q[1]), std::hypot(double{q[2]}, q[3]));
    if (std::abs(length - 1) <= length_tolerance) return;
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%zu]: the quaternion (%g, %g, %g, %g) is %g long, must be 1", name,
                  4 * index, double{q[0]}, double{q[1]}, double{q[2]}, double{q[3]}, length);
}

void check_joint_count(uint32_t count, const char* name) {
    check_range(count >= 1 && count <= max_joints, name, count, "1 to 65535");
}

void check_joints(const FlgSkinView& skin) {
    check_joint_count(skin.joint_count, "skin.joint_count");
    require(skin.joint_positions, "skin.joint_positions");
    require(skin.joint_parents, "skin.joint_parents");
    for (uint32_t j = 0; j < skin.joint_count; ++j) {
        check_coordinates(skin.joint_positions, j, "skin.joint_positions");
        const uint32_t parent = skin.joint_parents[j];
        if (parent == FLG_NO_INDEX || parent < j) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "skin.joint_parents[%u] is %u, must be lower than the joint, or FLG_NO_INDEX", j, parent);
    }
}

void check_binding(const FlgSkinView& skin, size_t vertex) {
    const uint16_t* joints = skin.vertex_joints + 4 * vertex;
    const float* weights = skin.vertex_weights + 4 * vertex;
    for (size_t k = 0; k < 4; ++k) {
        if (joints[k] >= skin.joint_count)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "skin.vertex_joints[%zu] is %u, but there are %u joints",
                          4 * vertex + k, joints[k], skin.joint_count);
        if (!(weights[k] >= 0 && weights[k] <= 1 + weight_tolerance))
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "skin.vertex_weights[%zu] is %g, must be 0 to 1", 4 * vertex + k,
                          double{weights[k]});
        if (weights[k] > weights[0])
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "skin.vertex_weights[%zu] is %g after %g: a vertex' largest weight must be its first",
                          4 * vertex + k, double{weights[k]}, double{weights[0]});
    }
    const float sum = weights[0] + weights[1] + weights[2] + weights[3];
    if (std::abs(sum - 1) <= weight_tolerance) return;
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "skin.vertex_weights: those of vertex %zu sum up to %g, must be 1",
                  vertex, double{sum});
}

void check_vertices(const FlgSkinView& skin, bool with_normals) {
    if (skin.vertex_count == 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "skin.vertex_count is 0, must be at least 1");
    require(skin.positions, "skin.positions");
    require(skin.vertex_joints, "skin.vertex_joints");
    require(skin.vertex_weights, "skin.vertex_weights");
    if (with_normals) require(skin.normals, "skin.normals");
    for (size_t v = 0; v < skin.vertex_count; ++v) {
        check_coordinates(skin.positions, v, "skin.positions");
        if (with_normals) check_coordinates(skin.normals, v, "skin.normals");
        check_binding(skin, v);
    }
}

void check_transforms(const float* transforms, FlgSkinning skinning, uint32_t joint_count) {
    require(transforms, "transforms");
    const size_t size = skinning == FLG_SKINNING_LINEAR ? 12 : 8;
    for (size_t i = 0; i < size * joint_count; ++i) {
        if (is_coordinate(transforms[i])) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "transforms[%zu] is %g, must be finite and at most 1e30 in size", i,
                      double{transforms[i]});
    }
    // Matrices may be any; of quaternions a length tells that the other kind was meant.
    for (size_t j = 0; skinning != FLG_SKINNING_LINEAR && j < joint_count; ++j) {
        check_rotation(transforms, 2 * j, "transforms");
    }
}

void check_keys(const FlgSkinAnimation& animation) {
    if (animation.key_count == 0)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "animation.key_count is 0, must be at least 1");
    require(animation.times, "animation.times");
    require(animation.rotations, "animation.rotations");
    float before = -1;
    for (uint32_t k = 0; k < animation.key_count; ++k) {
        const float time = animation.times[k];
        if (!(time >= 0 && is_coordinate(time) && time > before))
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "animation.times[%u] is %g, must be finite, rising from 0 or later", k, double{time});
        before = time;
    }
}

// The keys around a time, and how far it is from the first to the second.
struct KeySpan {
    size_t first, second;
    double share;
};

KeySpan find_keys(const FlgSkinAnimation& animation, float time) {
    const float* end = animation.times + animation.key_count;
    const float* after = std::upper_bound(animation.times, end, time);
    if (after == animation.times) return {0, 0, 0};
    const size_t first = static_cast<size_t>(after - animation.times) - 1;
    if (after == end) return {first, first, 0};
    const double from = animation.times[first];
    return {first, first + 1, (time - from) / (double{*after} - from)};
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgSkinViewInit(FlgSkinView* view, uint32_t struct_size) {
    return init_view(view, struct_size);
}

FlgResult flgSkinAnimationInit(FlgSkinAnimation* animation, uint32_t struct_size) {
    return init(animation, struct_size, sized<FlgSkinAnimation>(), "animation");
}

FlgResult flgSkinPose(const FlgSkinView* skin, const float* rotations, const float* translation, float* out_matrices,
                      float* out_dual_quaternions) {
    return guarded([&] {
        const FlgSkinView read = read_struct(skin, sized<FlgSkinView>(), "skin");
        check_joints(read);
        for (size_t j = 0; rotations && j < read.joint_count; ++j) check_rotation(rotations, j, "rotations");
        if (translation) check_coordinates(translation, 0, "translation");
        if (!out_matrices && !out_dual_quaternions)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "out_matrices and out_dual_quaternions are both null");
        std::array<JointMotion, joints_on_stack> few;
        std::vector<JointMotion> many(read.joint_count > joints_on_stack ? read.joint_count : 0);
        const std::span<JointMotion> motions(many.empty() ? few.data() : many.data(), read.joint_count);
        pose_joints(read.joint_positions, read.joint_parents, rotations, translation, motions);
        for (size_t j = 0; j < motions.size(); ++j) {
            if (out_matrices) store_matrix(motions[j], out_matrices + 12 * j);
            if (out_dual_quaternions) store_dual_quaternion(motions[j], out_dual_quaternions + 8 * j);
        }
    });
}

FlgResult flgSkinAnimationSample(const FlgSkinAnimation* animation, uint32_t joint_count, float time,
                                 float* out_rotations, float* out_translation) {
    return guarded([&] {
        const FlgSkinAnimation read = read_struct(animation, sized<FlgSkinAnimation>(), "animation");
        check_joint_count(joint_count, "joint_count");
        check_keys(read);
        check_range(is_coordinate(time), "time", time, "finite and at most 1e30 in size");
        require(out_rotations, "out_rotations");
        const auto [first, second, share] = find_keys(read, time);
        for (const size_t key : {first, second}) {
            for (size_t j = 0; j < joint_count; ++j)
                check_rotation(read.rotations, key * joint_count + j, "animation.rotations");
            if (read.translations) check_coordinates(read.translations, key, "animation.translations");
        }
        for (size_t j = 0; j < joint_count; ++j) {
            const Quaternion from = load_quaternion(read.rotations + 4 * (first * joint_count + j));
            const Quaternion to = load_quaternion(read.rotations + 4 * (second * joint_count + j));
            store_quaternion(turn_between(from, to, share), out_rotations + 4 * j);
        }
        if (!out_translation) return FLG_OK;
        const Vec3 from = read.translations ? load_vec3(read.translations + 3 * first) : Vec3::Zero();
        const Vec3 to = read.translations ? load_vec3(read.translations + 3 * second) : Vec3::Zero();
        store_vec3(from + share * (to - from), out_translation);
        return FLG_OK;
    });
}

FlgResult flgSkinDeform(const FlgSkinView* skin, FlgSkinning skinning, const float* transforms, float* out_positions,
                        float* out_normals) {
    return guarded([&] {
        const FlgSkinView read = read_struct(skin, sized<FlgSkinView>(), "skin");
        check_enum(skinning, FLG_SKINNING_LINEAR, FLG_SKINNING_DUAL_QUATERNION, "skinning", "FLG_SKINNING_");
        check_joint_count(read.joint_count, "skin.joint_count");
        check_vertices(read, out_normals != nullptr);
        check_transforms(transforms, skinning, read.joint_count);
        require(out_positions, "out_positions");
        for (size_t v = 0; v < read.vertex_count; ++v) {
            const VertexBinding binding{read.vertex_joints + 4 * v, read.vertex_weights + 4 * v};
            const VertexMotion motion = skinning == FLG_SKINNING_LINEAR ? blend_matrices(binding, transforms)
                                                                        : blend_dual_quaternions(binding, transforms);
            const Vec3 moved = motion.linear * load_vec3(read.positions + 3 * v) + motion.translation;
            store_vec3(moved, out_positions + 3 * v);
            if (out_normals) store_vec3(turned_normal(motion, load_vec3(read.normals + 3 * v)), out_normals + 3 * v);
        }
    });
}

}  // extern "C"
