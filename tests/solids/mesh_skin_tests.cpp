// SPDX-License-Identifier: MIT
// Meshes that nobody drew get bones, names and weights.
#include "solids/mesh_skin.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <string>

#include "core/failure.h"
#include "solids/solid_grid.h"
#include "solids/solid_meshes.h"

namespace flg::test {
namespace {

struct Made {
    std::shared_ptr<HeldSkin> skin;
    std::map<std::string, uint32_t> joints;

    Vec3 at(const std::string& name) const { return skin->tree.joints[joints.at(name)].at; }
    bool has(const std::string& name) const { return joints.contains(name); }
};

Made skin_of(const Triangles& triangles, bool haltingly = false, float detail = 1, uint32_t cells = 200000) {
    auto request = std::make_shared<MeshSkinRequest>();
    auto input = std::make_shared<MeshInput>(test_memory());
    FlgColumn column;
    input->view = view_of(triangles, column);
    input->columns.push_back(column);
    input->view.columns = input->columns.data();
    request->mesh = input;
    request->repair.weld_distance = 0.0f;
    request->thresholds = {sizeof request->thresholds, 0.01f, 0.03f, 0.03f, 0.01f, detail};
    request->cells = cells;
    Made out{std::make_shared<HeldSkin>(test_memory()), {}};
    run_now(
        test_memory(), [&](Pace& pace) { return make_mesh_skin(pace, out.skin, request); }, haltingly);
    for (uint32_t j = 0; j < out.skin->names.size(); ++j) out.joints[std::string(out.skin->names[j])] = j;
    return out;
}

std::string list(const Made& made) {
    std::string out;
    for (uint32_t j = 0; j < made.skin->names.size(); ++j) {
        const BoneJoint& joint = made.skin->tree.joints[j];
        out += std::string(made.skin->names[j]) + " on " +
               (joint.parent == no_joint ? "nothing" : std::string(made.skin->names[joint.parent])) + " (" +
               std::to_string(joint.at.x()) + " " + std::to_string(joint.at.y()) + " " + std::to_string(joint.at.z()) +
               ")\n";
    }
    return out;
}

TEST(MeshSkin, Person) {
    const Made made = skin_of(solid_person());
    SCOPED_TRACE(list(made));
    for (const char* name :
         {"body_0", "arm_0.L", "arm_1.L", "arm_2.L", "arm_0.R", "leg_0.L", "leg_1.L", "leg_2.L", "leg_0.R", "head_0"})
        ASSERT_TRUE(made.has(name)) << name;
    // The root is in the trunk's middle, an elbow where the arm bends.
    EXPECT_LT((made.at("body_0") - Vec3(0, 1.17, 0)).norm(), 0.15);
    EXPECT_LT((made.at("arm_1.L") - Vec3(0.5, 1.42, 0)).norm(), 0.06);
    EXPECT_GT(made.at("leg_0.L").x(), 0);
    EXPECT_LT((made.skin->mirror_normal - Vec3::UnitX()).norm(), 1e-6);
}

TEST(MeshSkin, MirrorImagesAreExact) {
    const Made made = skin_of(solid_person());
    for (const auto& [name, joint] : made.joints) {
        if (!name.ends_with(".L")) continue;
        const std::string other = name.substr(0, name.size() - 1) + "R";
        ASSERT_TRUE(made.has(other)) << other;
        const Vec3 a = made.at(name), b = made.at(other);
        EXPECT_LT((a - Vec3(-b.x(), b.y(), b.z())).norm(), 1e-6) << name;
    }
}

TEST(MeshSkin, AnAnimalLooksWhereItsHeadIs) {
    const Made made = skin_of(solid_animal());
    SCOPED_TRACE(list(made));
    for (const char* name : {"leg_0.L", "leg_0.R", "leg2_0.L", "leg2_0.R", "head_0", "tail_0"})
        ASSERT_TRUE(made.has(name)) << name;
    // It looks along -z, so its left is -x.
    EXPECT_LT((made.skin->mirror_normal + Vec3::UnitX()).norm(), 1e-6);
    EXPECT_LT(made.at("leg_0.L").x(), 0);
    EXPECT_LT(made.at("leg_0.L").z(), made.at("leg2_0.L").z());
}

// By the distance from the solid the triangles enclose.
TEST(MeshSkin, JointsAreInside) {
    for (const Triangles& triangles : {solid_person(), solid_animal()}) {
        const Made made = skin_of(triangles);
        const RepairedTriangles mesh(triangles);
        const SolidGrid grid =
            run_now(test_memory(), [&](Pace& pace) { return fill_solid(pace, mesh.mesh(), SolidFrame(), 1000000); });
        for (const BoneJoint& joint : made.skin->tree.joints) {
            const Vec3 local = grid.local(joint.at);
            EXPECT_TRUE(grid.inside[grid.number(static_cast<uint32_t>(local.x()), static_cast<uint32_t>(local.y()),
                                                static_cast<uint32_t>(local.z()))]);
            EXPECT_GT(joint.radius, 0);
        }
    }
}

TEST(MeshSkin, VerticesTrianglesAndOrderStay) {
    Triangles triangles = solid_person();
    triangles.add({9, 9, 9});  // no triangle has it
    triangles.corners.insert(triangles.corners.end(), {0, 0, 1});
    const Made made = skin_of(triangles);
    const HeldSkin& skin = *made.skin;
    ASSERT_EQ(skin.mesh.positions.size(), triangles.vertex_count());
    ASSERT_EQ(skin.mesh.triangles.size(), triangles.corners.size() / 3);
    for (uint32_t v = 0; v < triangles.vertex_count(); ++v) EXPECT_EQ(skin.mesh.positions[v], triangles.at(v));
    EXPECT_EQ(std::memcmp(skin.mesh.triangles.data(), triangles.corners.data(), 4 * triangles.corners.size()), 0);
    for (size_t v = 0; v < skin.weights.weights.size(); ++v) {
        float sum = 0;
        for (uint32_t k = 0; k < 4; ++k) {
            sum += skin.weights.weights[v][k];
            EXPECT_GE(skin.weights.weights[v][k], 0);
            EXPECT_LT(skin.weights.joints[v][k], skin.tree.joints.size());
        }
        EXPECT_NEAR(sum, 1, 1e-5);
        EXPECT_NEAR(skin.mesh.normals[v].norm(), 1, 1e-6);
    }
}

// A leg's vertices move with their own leg, however near the other is.
TEST(MeshSkin, LegsDoNotPullEachOther) {
    const Made made = skin_of(solid_person());
    const HeldSkin& skin = *made.skin;
    for (size_t v = 0; v < skin.mesh.positions.size(); ++v) {
        const Vec3& at = skin.mesh.positions[v];
        if (at.y() > 0.6) continue;
        for (uint32_t k = 0; k < 4; ++k) {
            const double weight = static_cast<double>(skin.weights.weights[v][k]);
            const std::string name(skin.names[skin.weights.joints[v][k]]);
            if (weight > 0.01) {
                EXPECT_TRUE(name.ends_with(at.x() > 0 ? ".L" : ".R")) << name << " at " << at.transpose();
            }
        }
    }
}

TEST(MeshSkin, TurnsWithTheMesh) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.6, Vec3::UnitY()).toRotationMatrix();
    const Made own = skin_of(solid_person()), turned = skin_of(solid_person().turned(turn));
    ASSERT_EQ(own.skin->tree.joints.size(), turned.skin->tree.joints.size()) << list(own) << list(turned);
    // Rounding decides which cells are inside: by no more than a cell.
    for (const BoneJoint& joint : own.skin->tree.joints) {
        double least = HUGE_VAL;
        for (const BoneJoint& other : turned.skin->tree.joints)
            least = std::min(least, (turn * joint.at - other.at).norm());
        EXPECT_LT(least, 0.03);
    }
}

TEST(MeshSkin, MoreDetailMoreJoints) {
    size_t before = 0;
    for (const float detail : {0.5f, 1.0f, 2.0f}) {
        const size_t joints = skin_of(solid_person(), false, detail).skin->tree.joints.size();
        EXPECT_GT(joints, before) << detail;
        before = joints;
    }
}

TEST(MeshSkin, WhatHasNoLimbsHasFewJoints) {
    Triangles ball;
    ball.add_ball({0, 0, 0}, 1);
    EXPECT_LE(skin_of(ball).skin->tree.joints.size(), 3u);
    Triangles flat;
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}}) flat.add(Vec3(x, y, 0));
    flat.corners = {0, 1, 2};
    EXPECT_THROW(skin_of(flat), Failure) << "bones have no room in a sheet";
    // A plate of one to ten.
    Triangles plate;
    for (const double z : {0.0, 0.1})
        for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) plate.add(Vec3(x, y, z));
    plate.corners = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                     1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
    EXPECT_LE(skin_of(plate).skin->tree.joints.size(), 5u);
}

TEST(MeshSkin, SameBitsWhereverItPauses) {
    const Made whole = skin_of(solid_animal(), false, 1, 20000), halting = skin_of(solid_animal(), true, 1, 20000);
    ASSERT_EQ(whole.skin->tree.joints.size(), halting.skin->tree.joints.size());
    for (size_t j = 0; j < whole.skin->tree.joints.size(); ++j)
        EXPECT_EQ(whole.skin->tree.joints[j].at, halting.skin->tree.joints[j].at);
    const size_t count = whole.skin->weights.weights.size();
    EXPECT_EQ(std::memcmp(whole.skin->weights.weights.data(), halting.skin->weights.weights.data(), 16 * count), 0);
    EXPECT_EQ(std::memcmp(whole.skin->weights.joints.data(), halting.skin->weights.joints.data(), 8 * count), 0);
}

TEST(MeshSkin, NothingIsRefused) {
    Triangles nothing;
    nothing.add({0, 0, 0});
    nothing.corners = {0, 0, 0};
    try {
        skin_of(nothing);
        FAIL();
    } catch (const Failure& failure) {
        EXPECT_NE(std::string(failure.what()), "");
    }
}

}  // namespace
}  // namespace flg::test
