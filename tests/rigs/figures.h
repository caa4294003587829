// SPDX-License-Identifier: MIT
// Skeletons of sticks whose limbs are known.
#pragma once

#include <memory_resource>
#include <string>
#include <vector>

#include "rigs/joint_limits.h"
#include "rigs/limb_roles.h"
#include "rigs/rig.h"

namespace flg::test {

struct Figure {
    std::vector<Vec3> at;
    std::vector<double> radii;
    std::vector<uint32_t> parents;
    std::vector<std::string> names;

    uint32_t add(const std::string& name, const Vec3& place, uint32_t parent, double radius = 0.1) {
        at.push_back(place);
        radii.push_back(radius);
        parents.push_back(parent);
        names.push_back(name);
        return static_cast<uint32_t>(at.size() - 1);
    }
    // Joints name_0, name_1, ... one after the other.
    uint32_t add_path(const std::string& name, uint32_t parent, const std::vector<Vec3>& places, double radius = 0.1) {
        for (size_t i = 0; i < places.size(); ++i)
            parent = add(name + "_" + std::to_string(i), places[i], parent, radius);
        return parent;
    }
    // The same on both sides of x = 0: name.L_0, ..., name.R_0, ...
    void add_pair(const std::string& name, uint32_t parent, std::vector<Vec3> places, double radius = 0.1) {
        add_path(name + ".L", parent, places, radius);
        for (Vec3& place : places) place.x() = -place.x();
        add_path(name + ".R", parent, places, radius);
    }
    uint32_t find(const std::string& name) const {
        for (uint32_t j = 0; j < names.size(); ++j)
            if (names[j] == name) return j;
        return FLG_NO_INDEX;
    }
};

// Looks along z, arms slanting down. Two joints of the spine, a neck, feet.
inline Figure human() {
    Figure f;
    const uint32_t hips = f.add("hips", {0, 1, 0}, FLG_NO_INDEX, 0.15);
    const uint32_t chest = f.add_path("spine", hips, {{0, 1.2, 0}, {0, 1.45, 0}}, 0.15);
    f.add_path("head", chest, {{0, 1.55, 0}, {0, 1.7, 0}}, 0.08);
    f.radii.back() = 0.12;
    f.add_pair("arm", chest, {{0.2, 1.4, 0}, {0.45, 1.25, 0}, {0.65, 1.05, 0}, {0.7, 1.0, 0}}, 0.04);
    f.add_pair("leg", hips, {{0.12, 0.95, 0}, {0.12, 0.5, 0.02}, {0.12, 0.08, 0}, {0.12, 0.02, 0.12}}, 0.06);
    return f;
}

// Looks along z.
inline Figure quadruped() {
    Figure f;
    const uint32_t root = f.add("root", {0, 1, 0}, FLG_NO_INDEX, 0.2);
    const uint32_t shoulders = f.add("shoulders", {0, 1.05, 0.5}, root, 0.2);
    const uint32_t croup = f.add("croup", {0, 1, -0.5}, root, 0.2);
    f.add_path("head", shoulders, {{0, 1.25, 0.75}, {0, 1.4, 1}, {0, 1.35, 1.2}}, 0.1);
    f.radii[f.find("head_1")] = 0.15;
    f.add_pair("ear", f.find("head_1"), {{0.08, 1.55, 1}}, 0.03);
    f.add_path("tail", croup, {{0, 1.05, -0.7}, {0, 0.9, -0.9}, {0, 0.7, -1}}, 0.03);
    f.add_pair("front", shoulders, {{0.15, 0.9, 0.5}, {0.15, 0.5, 0.45}, {0.15, 0.05, 0.5}}, 0.06);
    f.add_pair("hind", croup, {{0.15, 0.9, -0.5}, {0.15, 0.5, -0.4}, {0.15, 0.05, -0.5}}, 0.06);
    return f;
}

// Legs that lie to the sides, so many pairs; claws in front.
inline Figure spider(uint32_t pairs) {
    Figure f;
    const uint32_t root = f.add("root", {0, 0.5, 0}, FLG_NO_INDEX, 0.2);
    f.add_path("head", root, {{0, 0.55, 0.35}}, 0.12);
    for (uint32_t p = 0; p < pairs; ++p) {
        const double z = 0.3 - 0.6 * p / (pairs - 1);
        f.add_pair("leg" + std::to_string(p), root, {{0.2, 0.5, z}, {0.6, 0.8, 2 * z}, {1, 0, 3 * z}}, 0.03);
    }
    return f;
}

// The quadruped as it is drawn from the side, flat, with one leg of each pair; looks along -x.
inline Figure side_view() {
    const Figure whole = quadruped();
    Figure f;
    std::vector<uint32_t> numbers(whole.at.size(), FLG_NO_INDEX);
    for (uint32_t j = 0; j < whole.at.size(); ++j) {
        if (whole.names[j].find(".R") != std::string::npos || whole.names[j].starts_with("ear")) continue;
        const uint32_t parent = whole.parents[j];
        numbers[j] = f.add(whole.names[j], Vec3(-whole.at[j].z(), whole.at[j].y(), 0),
                           parent == FLG_NO_INDEX ? parent : numbers[parent], whole.radii[j]);
    }
    return f;
}

// A figure's rig, with its memory.
struct FigureRig {
    explicit FigureRig(const Figure& of, const Vec3& left = Vec3::Zero()) : figure(of), joints(of.at.size()) {
        const RigSkeleton skeleton{figure.at, figure.radii, figure.parents};
        frame = find_limbs(skeleton, Vec3::UnitY(), left, joints, std::pmr::new_delete_resource());
        set_limits(skeleton, frame, joints);
        for (const Vec3& place : figure.at)
            for (int k = 0; k < 3; ++k) positions.push_back(static_cast<float>(place[k]));
    }
    FigureRig(const FigureRig&) = delete;

    const FlgRigJoint& joint(const std::string& name) const { return joints[figure.find(name)]; }
    Rig rig() const {
        FlgRig view = {};
        view.struct_size = sizeof view;
        view.joint_count = static_cast<uint32_t>(joints.size());
        view.joint_positions = positions.data();
        view.joint_parents = figure.parents.data();
        view.joints = joints.data();
        store_vec3(frame.up, view.up);
        store_vec3(frame.left, view.left);
        store_vec3(frame.forward, view.forward);
        for (const FlgRigJoint& j : joints) {
            view.leg_count += j.limb == FLG_LIMB_LEG && j.index == 0;
            view.arm_count += j.limb == FLG_LIMB_ARM && j.index == 0;
        }
        return Rig(view);
    }

    Figure figure;
    std::vector<FlgRigJoint> joints;
    std::vector<float> positions;
    RigFrame frame;
};

}  // namespace flg::test
