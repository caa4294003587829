// SPDX-License-Identifier: MIT
// Parts in their places, for the tests, and what is made of them.
#pragma once

#include <algorithm>
#include <deque>

#include "inflation/bone_weights.h"
#include "inflation/four_joints.h"
#include "inflation/merge_parts.h"
#include "inflation/shapes.h"

namespace flg::test {

// A turn about an axis, a scale, maybe a mirror in x before them, and a place.
inline std::array<double, 12> placement(const Vec3& at, double scale = 1, double angle = 0,
                                        const Vec3& axis = Vec3::UnitY(), bool mirrored = false) {
    Eigen::Matrix3d m = scale * Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
    if (mirrored) m.col(0) *= -1;
    return {m(0, 0), m(0, 1), m(0, 2), at.x(), m(1, 0), m(1, 1), m(1, 2), at.y(), m(2, 0), m(2, 1), m(2, 2), at.z()};
}

struct Model {
    std::deque<InflatedPart> shapes;
    std::vector<PlacedPart> parts;
    std::vector<BoneSegment> bones;
    std::vector<uint32_t> joint_parents;  // the first of each chain turns with the nearest bone before

    BoneRig rig() const { return {bones, joint_parents}; }
    void add(const Rings& rings, const std::array<double, 12>& place, double thickness = 1) {
        shapes.push_back(part_of(rings));
        parts.push_back({&shapes.back(), place, thickness});
    }
    void repeat(size_t part, const std::array<double, 12>& place) {
        parts.push_back({parts[part].part, place, parts[part].thickness});
    }
    // Bones from point to point, in the space of the part that was added last.
    void chain(const std::vector<Vec3>& points, double radius) {
        const auto part = static_cast<uint32_t>(parts.size() - 1);
        const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> m(parts.back().placement.data());
        const Vec3 begin = m * points[0].homogeneous();
        const auto from_begin = [&](const BoneSegment& bone) { return ((bone.from + bone.to) / 2 - begin).norm(); };
        const auto nearest = std::min_element(
            bones.begin(), bones.end(), [&](const auto& a, const auto& b) { return from_begin(a) < from_begin(b); });
        uint32_t parent = bones.empty() ? no_joint : nearest->joint;
        for (size_t i = 0; i + 1 < points.size(); ++i) {
            joint_parents.push_back(parent);
            parent = static_cast<uint32_t>(bones.size());
            bones.push_back({m * points[i].homogeneous(), m * points[i + 1].homogeneous(), radius, radius,
                             static_cast<uint32_t>(bones.size()), part});
        }
    }
};

inline MergedMesh merged(const Model& model, const MergeOptions& options = {}, bool haltingly = false) {
    return made([&](Pace& pace) { return merge_parts(pace, model.parts, options); }, haltingly);
}

inline BoneWeights weights_of(const MergedMesh& mesh, const Model& model, const BoneWeightOptions& options = {},
                              bool haltingly = false) {
    return made([&](Pace& pace) { return bone_weights(pace, mesh, model.parts, model.rig(), options); }, haltingly);
}

inline ManyWeights many_weights_of(const MergedMesh& mesh, const Model& model) {
    return made([&](Pace& pace) { return many_weights(pace, mesh, model.parts, model.rig(), {}); }, false);
}

inline BoneWeights four_of(const MergedMesh& mesh, const ManyWeights& many, const Model& model) {
    return made([&](Pace& pace) { return keep_four_joints(pace, mesh, many, model.rig()); }, false);
}

// A body with a head, four legs, a tail and an ear, symmetric but for the last three.
inline Model animal() {
    Model model;
    model.add({ellipse(0, 0, 1.2, 0.6)}, placement({0, 0, 0}), 0.9);
    model.chain({{-0.8, 0, 0}, {-0.3, 0.05, 0}, {0.3, 0.05, 0}, {0.8, 0.1, 0}}, 0.5);
    model.add({ellipse(0, 0, 0.45, 0.42)}, placement({1.2, 0.6, 0}));
    model.chain({{0, -0.1, 0}, {0, 0.2, 0}}, 0.4);
    const std::vector<Vec3> leg = {{0, 0, 0}, {0.05, -0.5, 0}, {0.1, -1, 0}};
    model.add({capsule(0, 0, 0.2, 0.1, -1, 0.14)}, placement({0.7, -0.3, 0.3}, 1, 0.2), 0.75);
    model.chain(leg, 0.17);
    model.repeat(2, placement({0.7, -0.3, -0.3}, 1, -0.2));
    model.chain(leg, 0.17);
    model.repeat(2, placement({-0.7, -0.3, 0.3}, 1, -0.2, Vec3::UnitY(), true));
    model.chain(leg, 0.17);
    model.repeat(2, placement({-0.7, -0.3, -0.3}, 1, 0.2, Vec3::UnitY(), true));
    model.chain(leg, 0.17);
    model.add({capsule(0, 0, 0.12, -0.9, 0.7, 0.06)}, placement({-1.0, 0.2, 0}), 0.71);
    model.chain({{0, 0, 0}, {-0.3, 0.23, 0}, {-0.6, 0.47, 0}, {-0.9, 0.7, 0}}, 0.09);
    model.add({{{-0.2, 0}, {0, 0.5}, {0.2, 0}}}, placement({1.0, 0.9, 0.15}, 1, 0.4));
    model.chain({{0, 0, 0}, {0, 0.4, 0}}, 0.1);
    return model;
}

}  // namespace flg::test
