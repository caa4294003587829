// SPDX-License-Identifier: MIT
// Source of turn_between: Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985.
// Invariant: a motion takes its joint's place at rest to its place in the pose; joint and parent stay as far apart as at rest.
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

}  // namespace flg
