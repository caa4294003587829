// SPDX-License-Identifier: MIT
// Rigs: skeletons, and what hosts say of them, are checked at the door. No context: nothing is kept.
#include "filigree/filigree_rig.h"

#include <array>
#include <cstddef>
#include <memory_resource>
#include <vector>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "rigs/humanoid.h"
#include "rigs/joint_limits.h"
#include "rigs/rig_motion.h"

namespace flg {

namespace {

constexpr float most_radians = 3.15f;
constexpr size_t bytes_on_stack = 16384;

FlgRigFindDesc default_rig_find_desc() {
    auto desc = sized<FlgRigFindDesc>();
    desc.up[1] = 1;
    return desc;
}

void check_numbers(const float* values, size_t count, const char* name) {
    for (size_t i = 0; i < count; ++i) {
        if (is_coordinate(values[i])) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%zu] is %g, must be finite and at most 1e30 in size", name, i,
                      double{values[i]});
    }
}

void check_skeleton(uint32_t count, const float* positions, const uint32_t* parents, const char* subject) {
    char name[64];
    const auto named = [&](const char* field) {
        std::snprintf(name, sizeof name, "%s.%s", subject, field);
        return name;
    };
    check_range(count >= 1 && count <= FLG_RIG_MAX_JOINTS, named("joint_count"), count, "1 to 1024");
    require(positions, named("joint_positions"));
    require(parents, named("joint_parents"));
    check_numbers(positions, size_t{3} * count, named("joint_positions"));
    for (uint32_t j = 0; j < count; ++j) {
        if (parents[j] == FLG_NO_INDEX || parents[j] < j) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%u] is %u, must be lower than the joint, or FLG_NO_INDEX",
                      named("joint_parents"), j, parents[j]);
    }
}

void check_joint(const FlgRigJoint& joint, uint32_t index) {
    const auto check = [&](bool holds, const char* what) {
        if (!holds) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "rig.joints[%u]: %s", index, what);
    };
    const int32_t limb = number_of(joint.limb), place = number_of(joint.place);
    check(limb >= FLG_LIMB_TRUNK && limb <= FLG_LIMB_OTHER, "limb is none of FLG_LIMB_...");
    check(place >= FLG_LIMB_PLACE_NONE && place <= FLG_LIMB_PLACE_END, "place is none of FLG_LIMB_PLACE_...");
    check(joint.side >= -1 && joint.side <= 1, "side must be -1 to 1");
    check(joint.pair < FLG_RIG_MAX_JOINTS && joint.index < FLG_RIG_MAX_JOINTS, "pair and index must be below 1024");
    check(std::abs(load_vec3(joint.limit_axis).norm() - 1) <= 1e-3, "limit_axis must be of length 1");
    check(joint.limit_swing >= 0 && joint.limit_swing <= most_radians, "limit_swing must be 0 to pi");
    check(joint.limit_twist_min >= -most_radians && joint.limit_twist_min <= 0 && joint.limit_twist_max >= 0 &&
              joint.limit_twist_max <= most_radians,
          "limit_twist_min and limit_twist_max must be -pi to 0 and 0 to pi");
}

Rig read_rig(const FlgRig* rig) {
    const FlgRig read = read_struct(rig, sized<FlgRig>(), "rig");
    check_skeleton(read.joint_count, read.joint_positions, read.joint_parents, "rig");
    require(read.joints, "rig.joints");
    for (uint32_t j = 0; j < read.joint_count; ++j) {
        check_joint(read.joints[j], j);
        const uint32_t next = read.joints[j].next;
        if (next == FLG_NO_INDEX || (next < read.joint_count && read.joint_parents[next] == j)) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "rig.joints[%u].next is %u, must be one of its children or none", j,
                      next);
    }
    const Rig checked(read);
    Eigen::Matrix3d frame;
    frame << checked.left, checked.up, checked.forward;
    if (!((frame * frame.transpose() - Eigen::Matrix3d::Identity()).norm() <= 1e-3 && frame.determinant() > 0))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "rig.left, rig.up and rig.forward must be of length 1, at right angles, and forward left x up");
    return checked;
}

// Where joints of two limbs are looked for, both must be of one tree.
void check_one_tree(const Rig& rig) {
    uint32_t root = FLG_NO_INDEX;
    for (uint32_t j = 0; j < rig.count(); ++j) {
        if (rig.joint(j).limb == FLG_LIMB_OTHER || rig.joint(j).index != 0) continue;
        uint32_t top = j;
        while (rig.parent(top) != FLG_NO_INDEX) top = rig.parent(top);
        if (root == FLG_NO_INDEX) root = top;
        if (root != top)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "rig.joints[%u] begins a limb of another tree than joint %u", j,
                          root);
    }
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgRigFindDescInit(FlgRigFindDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_rig_find_desc());
}

FlgResult flgRigInit(FlgRig* rig, uint32_t struct_size) {
    return init(rig, struct_size, sized<FlgRig>(), "rig");
}

FlgResult flgRigFind(const FlgRigFindDesc* desc, FlgRigJoint* out_joints, FlgRig* out_rig) {
    return guarded([&] {
        const FlgRigFindDesc read = read_struct(desc, default_rig_find_desc(), "desc");
        check_skeleton(read.joint_count, read.joint_positions, read.joint_parents, "desc");
        require(read.joint_radii, "desc.joint_radii");
        for (uint32_t j = 0; j < read.joint_count; ++j) {
            if (read.joint_radii[j] >= 0 && is_coordinate(read.joint_radii[j])) continue;
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.joint_radii[%u] is %g, must be 0 to 1e30", j,
                          double{read.joint_radii[j]});
        }
        check_numbers(read.up, 3, "desc.up");
        check_numbers(read.left, 3, "desc.left");
        const Vec3 up = load_vec3(read.up).stableNormalized(), left = load_vec3(read.left).stableNormalized();
        check_range(up.norm() > 0, "desc.up", 0, "of a length above 0");
        if (left.norm() > 0 && left.cross(up).norm() < 1e-3)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.left must not lie along desc.up");
        require(out_joints, "out_joints");
        check_struct_size<FlgRig>(require(out_rig, "out_rig").struct_size, "out_rig");

        alignas(std::max_align_t) std::array<std::byte, bytes_on_stack> near;
        std::pmr::monotonic_buffer_resource room(near.data(), near.size(), std::pmr::new_delete_resource());
        std::pmr::vector<Vec3> at(read.joint_count, &room);
        std::pmr::vector<double> radii(read.joint_radii, read.joint_radii + read.joint_count, &room);
        for (size_t j = 0; j < at.size(); ++j) at[j] = load_vec3(read.joint_positions + 3 * j);
        std::pmr::vector<FlgRigJoint> joints(read.joint_count, &room);
        const RigSkeleton skeleton{at, radii, {read.joint_parents, read.joint_count}};
        const RigFrame frame = find_limbs(skeleton, up, left, joints, &room);
        set_limits(skeleton, frame, joints);

        auto rig = sized<FlgRig>();
        rig.joint_count = read.joint_count;
        rig.joint_positions = read.joint_positions;
        rig.joint_parents = read.joint_parents;
        rig.joints = out_joints;
        store_vec3(frame.up, rig.up);
        store_vec3(frame.left, rig.left);
        store_vec3(frame.forward, rig.forward);
        rig.ground = static_cast<float>(frame.ground);
        for (size_t j = 0; j < joints.size(); ++j) {
            out_joints[j] = joints[j];
            rig.leg_count += joints[j].limb == FLG_LIMB_LEG && joints[j].index == 0;
            rig.arm_count += joints[j].limb == FLG_LIMB_ARM && joints[j].index == 0;
        }
        write_struct(out_rig, rig, "out_rig");
    });
}

FlgResult flgRigGetNames(const FlgRig* rig, FlgRigStandard standard, const char** out_names) {
    return guarded([&] {
        const Rig read = read_rig(rig);
        check_one_tree(read);
        check_enum(standard, FLG_RIG_STANDARD_VRM, FLG_RIG_STANDARD_UNREAL, "standard", "FLG_RIG_STANDARD_");
        require(out_names, "out_names");
        name_humanoid(read, standard, out_names);
    });
}

FlgResult flgRigGetTPose(const FlgRig* rig, float* out_rotations) {
    return guarded([&] {
        const Rig read = read_rig(rig);
        require(out_rotations, "out_rotations");
        pose_t(read, out_rotations);
    });
}

FlgResult flgRigMotionSample(const FlgRig* rig, FlgRigMotion motion, float phase, float* out_rotations,
                             float* out_translation, float* out_travel) {
    return guarded([&] {
        const Rig read = read_rig(rig);
        check_enum(motion, FLG_RIG_MOTION_WALK, FLG_RIG_MOTION_WAVE, "motion", "FLG_RIG_MOTION_");
        check_range(is_coordinate(phase), "phase", phase, "finite and at most 1e30 in size");
        require(out_rotations, "out_rotations");
        require(out_translation, "out_translation");
        MotionPose pose{out_rotations};
        sample_motion(read, motion, double{phase} - std::floor(double{phase}), pose);
        store_vec3(pose.translation, out_translation);
        if (out_travel) store_vec3(pose.travel, out_travel);
    });
}

}  // extern "C"
