// SPDX-License-Identifier: MIT
// Source of turn_between: Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985.
// Invariant: a motion takes its joint's place at rest to its place in the pose; joint and parent stay as far apart as
// at rest.
//
// Source: Kavan, Collins, Zara, O'Sullivan, Geometric skinning with approximate dual quaternion blending, ACM TOG
// 27(4), 2008: algorithm 1 (DLB).
// Departures: signs are told by the joint of the largest weight, so that the sum is never shorter than that weight.
// shaders/skin.glsl is this in float.
#include "bones/skin_pose.h"

#include <cmath>

#include "skeletons/bone_tree.h"

namespace flg {

void pose_joints(const float* joint_positions, const uint32_t* joint_parents, const float* rotations,
                 const float* translation, std::span<JointMotion> out) {
    const Vec3 moved = translation ? load_vec3(translation) : Vec3::Zero();
    for (size_t j = 0; j < out.size(); ++j) {
        const Vec3 at = load_vec3(joint_positions + 3 * j);
        Quaternion rotation = rotations ? load_quaternion(rotations + 4 * j) : Quaternion::Identity();
        Vec3 place = at + moved;
        if (joint_parents[j] != no_joint) {
            const JointMotion& parent = out[joint_parents[j]];
            place = parent.rotation * at + parent.translation;
            rotation = (parent.rotation * rotation).normalized();
        }
        out[j] = {rotation, place - rotation * at};
    }
}

void store_matrix(const JointMotion& motion, float* out) {
    const Eigen::Matrix3d turned = motion.rotation.toRotationMatrix();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) out[4 * row + column] = static_cast<float>(turned(row, column));
        out[4 * row + 3] = static_cast<float>(motion.translation[row]);
    }
}

void store_dual_quaternion(const JointMotion& motion, float* out) {
    const Vec3& t = motion.translation;
    Quaternion dual = Quaternion(0, t.x(), t.y(), t.z()) * motion.rotation;
    dual.coeffs() *= 0.5;
    store_quaternion(motion.rotation, out);
    store_quaternion(dual, out + 4);
}

Quaternion turn_between(const Quaternion& from, const Quaternion& to, double share) {
    // Nearer than this the sine of the angle says too little, and a straight line is as good.
    constexpr double nearly_one = 1 - 1e-9;
    const double dot = from.dot(to);
    const double sign = dot < 0 ? -1 : 1;
    double a = 1 - share, b = share;
    if (std::abs(dot) < nearly_one) {
        const double angle = std::acos(std::abs(dot)), sine = std::sin(angle);
        a = std::sin((1 - share) * angle) / sine;
        b = std::sin(share * angle) / sine;
    }
    return Quaternion(Eigen::Vector4d(a * from.coeffs() + sign * b * to.coeffs())).normalized();
}

namespace {

constexpr size_t joints_a_vertex = 4;

}  // namespace

VertexMotion blend_matrices(const VertexBinding& binding, const float* matrices) {
    VertexMotion motion{Eigen::Matrix3d::Zero(), Vec3::Zero()};
    double sum = 0;
    for (size_t k = 0; k < joints_a_vertex; ++k) {
        const double weight = binding.weights[k];
        if (weight == 0) continue;
        sum += weight;
        const float* m = matrices + 12 * size_t{binding.joints[k]};
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) motion.linear(row, column) += weight * m[4 * row + column];
            motion.translation[row] += weight * m[4 * row + 3];
        }
    }
    motion.linear /= sum;
    motion.translation /= sum;
    return motion;
}

VertexMotion blend_dual_quaternions(const VertexBinding& binding, const float* dual_quaternions) {
    using Four = Eigen::Vector4d;
    const auto load = [&](size_t k, size_t part) {
        const float* q = dual_quaternions + 8 * size_t{binding.joints[k]} + 4 * part;
        return Four(q[0], q[1], q[2], q[3]);
    };
    const Four pivot = load(0, 0);
    Four real = Four::Zero(), dual = Four::Zero();
    for (size_t k = 0; k < joints_a_vertex; ++k) {
        if (binding.weights[k] == 0) continue;
        const Four r = load(k, 0);
        const double weight = r.dot(pivot) < 0 ? -binding.weights[k] : binding.weights[k];
        real += weight * r;
        dual += weight * load(k, 1);
    }
    const double size = real.norm();
    real /= size;
    dual /= size;
    const Vec3 r = real.head<3>(), d = dual.head<3>();
    const Eigen::Quaterniond rotation(real.w(), r.x(), r.y(), r.z());
    return {rotation.toRotationMatrix(), 2 * (real.w() * d - dual.w() * r + r.cross(d))};
}

Vec3 turned_normal(const VertexMotion& motion, const Vec3& normal) {
    const Vec3 turned = motion.linear * normal;
    const double size = turned.norm();
    return size > 0 ? Vec3(turned / size) : normal;
}

}  // namespace flg
