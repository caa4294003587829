// SPDX-License-Identifier: MIT
// Vertices moved by joints: sdk/skeletons/skin_deformation.cpp in float, which says where it is from.

layout(constant_id = 0) const uint skinning = 0u;  // FlgSkinning
const uint skinning_linear = 0u;

// Of all skins: three rows of a matrix, or a dual quaternion.
layout(set = 1, binding = 0, std430) readonly buffer Joints { vec4 joints[]; };

layout(location = 5) in uvec4 vertex_joints;
layout(location = 6) in vec4 vertex_weights;  // the largest first

// Rows of the 3 x 4 matrix from rest to the pose.
struct Motion {
    vec4 x, y, z;
};

Motion blend_matrices() {
    Motion motion = Motion(vec4(0), vec4(0), vec4(0));
    for (int k = 0; k < 4; ++k) {
        uint row = draw.first_joint + 3u * vertex_joints[k];
        motion.x += vertex_weights[k] * joints[row];
        motion.y += vertex_weights[k] * joints[row + 1u];
        motion.z += vertex_weights[k] * joints[row + 2u];
    }
    return motion;
}

Motion blend_dual_quaternions() {
    vec4 pivot = joints[draw.first_joint + 2u * vertex_joints.x];
    vec4 real = vec4(0), dual = vec4(0);
    for (int k = 0; k < 4; ++k) {
        uint at = draw.first_joint + 2u * vertex_joints[k];
        float weight = dot(joints[at], pivot) < 0.0 ? -vertex_weights[k] : vertex_weights[k];
        real += weight * joints[at];
        dual += weight * joints[at + 1u];
    }
    float scale = 1.0 / length(real);
    vec4 r = scale * real, d = scale * dual;
    vec3 t = 2.0 * (r.w * d.xyz - d.w * r.xyz + cross(r.xyz, d.xyz));
    vec3 twice = 2.0 * r.xyz;
    vec3 squares = twice * r.xyz, mixed = twice * r.yzx, turned = twice * r.w;  // mixed: xy, yz, zx
    return Motion(vec4(1.0 - squares.y - squares.z, mixed.x - turned.z, mixed.z + turned.y, t.x),
                  vec4(mixed.x + turned.z, 1.0 - squares.z - squares.x, mixed.y - turned.x, t.y),
                  vec4(mixed.z - turned.y, mixed.y + turned.x, 1.0 - squares.x - squares.y, t.z));
}

Motion vertex_motion() {
    if (skinning == skinning_linear) return blend_matrices();
    return blend_dual_quaternions();
}

vec3 moved(Motion motion, vec3 position) {
    vec4 p = vec4(position, 1.0);
    return vec3(dot(motion.x, p), dot(motion.y, p), dot(motion.z, p));
}

vec3 turned_normal(Motion motion, vec3 normal) {
    vec3 n = vec3(dot(motion.x.xyz, normal), dot(motion.y.xyz, normal), dot(motion.z.xyz, normal));
    float size = length(n);
    return size > 0.0 ? n / size : normal;
}
