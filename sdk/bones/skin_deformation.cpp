// SPDX-License-Identifier: MIT
// Source: Kavan, Collins, Zara, O'Sullivan, Geometric skinning with approximate dual quaternion blending, ACM TOG 27(4),
// 2008: algorithm 1 (DLB).
// Departures: signs are told by the joint of the largest weight, so that the sum is never shorter than that weight.
// shaders/skin.glsl is this in float.
#include "bones/skin_deformation.h"

namespace flg {

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
