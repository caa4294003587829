// SPDX-License-Identifier: MIT
// Bones for meshes that nobody drew, and pulling at them, behind the C ABI.
#include <functional>

#include "api/host.h"
#include "filigree/filigree_model.h"
#include "filigree/filigree_pull.h"
#include "filigree/filigree_rig.h"
#include "solids/solid_meshes.h"

namespace flg::test {
namespace {

struct MeshHost : Host {
    using Host::Host;

    FlgSkin start_skin(const FlgMeshView& mesh, uint32_t cells = 60000) const {
        FlgSkinFromMeshDesc desc = flgSkinFromMeshDefaults();
        desc.mesh = &mesh;
        desc.cell_count = cells;
        FlgSkin skin{};
        EXPECT_EQ(flgSkinCreateFromMesh(context, &desc, &skin, nullptr), FLG_OK) << flgErrorGetMessage();
        return skin;
    }
    FlgSkinView skin_of(const FlgMeshView& mesh) const {
        const FlgSkin skin = start_skin(mesh);
        finish();
        FlgSkinView view = flgSkinViewDefaults();
        EXPECT_EQ(flgSkinGetView(context, skin, &view), FLG_OK) << flgErrorGetMessage();
        return view;
    }
    FlgPull pull_of(const FlgMeshView& mesh) const {
        FlgPullDesc desc = flgPullDefaults();
        desc.mesh = &mesh;
        FlgPull pull{};
        EXPECT_EQ(flgPullCreate(context, &desc, &pull, nullptr), FLG_OK) << flgErrorGetMessage();
        return pull;
    }
};

FlgPullHandle handle_at(const Triangles& mesh, uint32_t vertex, const Vec3& by) {
    FlgPullHandle handle = flgPullHandleDefaults();
    for (uint32_t& v : handle.vertices) v = vertex;
    store_vec3(mesh.at(vertex) + by, handle.position);
    return handle;
}

TEST(MeshSkins, AreRiggedPosedAndTheSameUnderAnyWorkers) {
    const Triangles mesh = solid_person();
    FlgColumn column;
    const FlgMeshView view = view_of(mesh, column);
    std::vector<std::vector<float>> all;
    for (const uint32_t workers : {0u, 1u, 3u}) {
        MeshHost host(workers);
        const FlgSkinView skin = host.skin_of(view);
        ASSERT_EQ(skin.vertex_count, mesh.vertex_count());
        auto& bits = all.emplace_back(skin.joint_positions, skin.joint_positions + 3 * size_t{skin.joint_count});
        bits.insert(bits.end(), skin.vertex_weights, skin.vertex_weights + 4 * size_t{skin.vertex_count});
        if (workers > 0) {
            EXPECT_EQ(bits, all[0]);
            continue;
        }
        FlgRigFindDesc desc = flgRigFindDefaults();
        desc.joint_count = skin.joint_count;
        desc.joint_positions = skin.joint_positions;
        desc.joint_radii = skin.joint_radii;
        desc.joint_parents = skin.joint_parents;
        std::copy_n(skin.mirror, 3, desc.left);
        std::vector<FlgRigJoint> joints(skin.joint_count);
        FlgRig rig = flgRigDefaults();
        ASSERT_EQ(flgRigFind(&desc, joints.data(), &rig), FLG_OK) << flgErrorGetMessage();
        EXPECT_EQ(rig.leg_count, 2u);
        EXPECT_EQ(rig.arm_count, 2u);
        std::vector<const char*> names(skin.joint_count);
        EXPECT_EQ(flgRigGetNames(&rig, FLG_RIG_STANDARD_VRM, names.data()), FLG_OK) << flgErrorGetMessage();
        std::vector<float> rotations(4 * size_t{skin.joint_count}), matrices(12 * size_t{skin.joint_count}),
            positions(3 * size_t{skin.vertex_count});
        float translation[3];
        ASSERT_EQ(flgRigMotionSample(&rig, FLG_RIG_MOTION_WALK, 0.3f, rotations.data(), translation, nullptr), FLG_OK);
        ASSERT_EQ(flgSkinPose(&skin, rotations.data(), translation, matrices.data(), nullptr), FLG_OK);
        EXPECT_EQ(flgSkinDeform(&skin, FLG_SKINNING_LINEAR, matrices.data(), positions.data(), nullptr), FLG_OK);
    }
}

TEST(MeshSkins, Refusals) {
    MeshHost host;
    Triangles mesh = solid_person();
    FlgColumn column;
    FlgMeshView view = view_of(mesh, column);
    const auto expect = [&](const char* what, const std::function<void(FlgSkinFromMeshDesc&)>& spoil,
                            FlgResult result = FLG_ERROR_INVALID_ARGUMENT) {
        FlgSkinFromMeshDesc desc = flgSkinFromMeshDefaults();
        desc.mesh = &view;
        spoil(desc);
        FlgSkin skin{};
        EXPECT_EQ(flgSkinCreateFromMesh(host.context, &desc, &skin, nullptr), result) << what;
        EXPECT_NE(std::string(flgErrorGetMessage()).find(what), std::string::npos) << flgErrorGetMessage();
        EXPECT_EQ(skin.id, 0u);
    };
    expect("desc.mesh", [](FlgSkinFromMeshDesc& desc) { desc.mesh = nullptr; });
    expect("desc.cell_count", [](FlgSkinFromMeshDesc& desc) { desc.cell_count = 999; });
    expect("desc.up", [](FlgSkinFromMeshDesc& desc) { desc.up[1] = 0; });
    expect("desc.left", [](FlgSkinFromMeshDesc& desc) { desc.left[0] = NAN; });
    expect("desc.weld_distance", [](FlgSkinFromMeshDesc& desc) { desc.weld_distance = INFINITY; });
    const float before = mesh.positions[7];
    mesh.positions[7] = NAN;
    expect("vertex 2", [](FlgSkinFromMeshDesc&) {});
    mesh.positions[7] = before;
    view.vertex_count = (1u << 20) + 1;
    expect(
        "limit", [](FlgSkinFromMeshDesc&) {}, FLG_ERROR_LIMIT);
}

TEST(MeshSkins, AFailedJobSaysWhy) {
    MeshHost host;
    Triangles mesh = solid_person();
    mesh.corners[5] = 123456;
    FlgColumn column;
    const FlgMeshView view = view_of(mesh, column);
    const FlgSkin skin = host.start_skin(view);
    host.finish();
    FlgSkinView shown = flgSkinViewDefaults();
    EXPECT_EQ(flgSkinGetView(host.context, skin, &shown), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgErrorGetMessage()).find("123456"), std::string::npos) << flgErrorGetMessage();
}

// Bones have no room in a sheet; one end of a tube may be open.
TEST(MeshSkins, SheetsAreRefused) {
    Triangles sheet;
    sheet.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    sheet.corners = {0, 1, 2, 0, 2, 3};
    MeshHost host;
    FlgColumn column;
    const FlgMeshView view = view_of(sheet, column);
    const FlgSkin skin = host.start_skin(view);
    host.finish();
    FlgSkinView shown = flgSkinViewDefaults();
    EXPECT_EQ(flgSkinGetView(host.context, skin, &shown), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgErrorGetMessage()).find("is a sheet: 4 of its edges"), std::string::npos)
        << flgErrorGetMessage();
    Triangles open = solid_person();
    open.corners.resize(open.corners.size() - 3);
    FlgColumn open_column;
    const FlgMeshView open_view = view_of(open, open_column);
    const FlgSkin open_skin = host.start_skin(open_view);
    host.finish();
    EXPECT_EQ(flgSkinGetView(host.context, open_skin, &shown), FLG_OK) << flgErrorGetMessage();
}

TEST(PulledMeshes, FollowHandlesAndAreTheSameUnderAnyWorkers) {
    Triangles mesh;
    mesh.add_tube({0, 0, 0}, 0.2, {0, 2, 0}, 0.2);
    // A vertex that is there twice stays together, one without triangles stays.
    const uint32_t twin = mesh.add(mesh.at(40));
    mesh.corners.insert(mesh.corners.end(), {twin, 41, 65});
    const uint32_t alone = mesh.add({5, 5, 5});
    FlgColumn column;
    const FlgMeshView view = view_of(mesh, column);
    std::vector<std::vector<float>> all;
    for (const uint32_t workers : {0u, 2u}) {
        MeshHost host(workers);
        FlgPulledDesc desc = flgPulledDefaults();
        desc.pull = host.pull_of(view);
        FlgPullHandle handles[] = {handle_at(mesh, 0, {0, 0, 0}), handle_at(mesh, 500, {0, 0, 0})};
        desc.handles = handles;
        desc.handle_count = 2;
        FlgPulledView shown = flgPulledViewDefaults();
        for (int frame = 0; frame < 5; ++frame) {
            handles[1].position[0] += 0.1f;
            FlgPulled pulled{};
            ASSERT_EQ(flgPulledCreate(host.context, &desc, &pulled, nullptr), FLG_OK) << flgErrorGetMessage();
            if (frame > 0) {
                ASSERT_EQ(flgPulledRelease(host.context, desc.previous), FLG_OK);
            }
            desc.previous = pulled;
        }
        host.finish();
        ASSERT_EQ(flgPulledGetView(host.context, desc.previous, &shown), FLG_OK) << flgErrorGetMessage();
        ASSERT_EQ(shown.vertex_count, mesh.vertex_count());
        const auto at = [&](uint32_t v) { return load_vec3(shown.positions + size_t{3} * v); };
        for (const FlgPullHandle& handle : handles)
            EXPECT_LT((at(handle.vertices[0]) - load_vec3(handle.position)).norm(), 1e-5);
        EXPECT_EQ(at(twin), at(40));
        EXPECT_EQ(at(alone), mesh.at(alone));
        all.emplace_back(shown.positions, shown.positions + 3 * size_t{shown.vertex_count});
        EXPECT_EQ(all.back(), all.front());
    }
}

TEST(PulledMeshes, AddToPoses) {
    const Triangles mesh = solid_person();
    FlgColumn column;
    const FlgMeshView view = view_of(mesh, column);
    MeshHost host;
    std::vector<float> pose = mesh.positions;
    for (float& value : pose) value += 1;
    FlgPulledDesc desc = flgPulledDefaults();
    desc.pull = host.pull_of(view);
    desc.positions = pose.data();
    FlgPulled pulled{};
    ASSERT_EQ(flgPulledCreate(host.context, &desc, &pulled, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    FlgPulledView shown = flgPulledViewDefaults();
    ASSERT_EQ(flgPulledGetView(host.context, pulled, &shown), FLG_OK);
    EXPECT_TRUE(std::equal(pose.begin(), pose.end(), shown.positions));
}

TEST(PulledMeshes, Refusals) {
    const Triangles mesh = solid_person();
    FlgColumn column;
    const FlgMeshView view = view_of(mesh, column);
    MeshHost host;
    const FlgPull pull = host.pull_of(view), other = host.pull_of(view);
    FlgPullHandle handle = handle_at(mesh, 0, {0, 0, 0});
    const auto expect = [&](const char* what, const std::function<void(FlgPulledDesc&)>& spoil) {
        FlgPulledDesc desc = flgPulledDefaults();
        desc.pull = pull;
        desc.handles = &handle;
        desc.handle_count = 1;
        spoil(desc);
        FlgPulled pulled{};
        EXPECT_NE(flgPulledCreate(host.context, &desc, &pulled, nullptr), FLG_OK) << what;
        EXPECT_NE(std::string(flgErrorGetMessage()).find(what), std::string::npos) << flgErrorGetMessage();
        handle = handle_at(mesh, 0, {0, 0, 0});
    };
    expect("desc.pull", [](FlgPulledDesc& desc) { desc.pull = {}; });
    expect("desc.rounds", [](FlgPulledDesc& desc) { desc.rounds = 0; });
    expect("desc.handles", [](FlgPulledDesc& desc) { desc.handles = nullptr; });
    expect("desc.handle_count", [](FlgPulledDesc& desc) { desc.handle_count = 257; });
    expect("desc.handles[0].shares", [&](FlgPulledDesc&) { handle.shares[0] = 0.5f; });
    expect("desc.handles[0].position", [&](FlgPulledDesc&) { handle.position[1] = NAN; });
    expect("desc.handles[0].compliance", [&](FlgPulledDesc&) { handle.compliance = -1; });
    expect("desc.handles[0].radius", [&](FlgPulledDesc&) { handle.radius = INFINITY; });
    FlgPullHandle two[] = {handle, handle_at(mesh, 0, {0.1f, 0, 0})};
    const auto take_two = [&](FlgPulledDesc& desc) { desc.handles = two, desc.handle_count = 2; };
    expect("desc.handles[0] and desc.handles[1] hold one point in two places", take_two);
    FlgPulledDesc desc = flgPulledDefaults();
    FlgPulled pulled{};
    desc.pull = pull;
    take_two(desc);
    two[1].compliance = 0.1f;
    EXPECT_EQ(flgPulledCreate(host.context, &desc, &pulled, nullptr), FLG_OK) << flgErrorGetMessage();
    desc = flgPulledDefaults();
    desc.pull = other;
    ASSERT_EQ(flgPulledCreate(host.context, &desc, &pulled, nullptr), FLG_OK);
    expect("desc.previous", [&](FlgPulledDesc& wrong) { wrong.previous = pulled; });
    handle.vertices[1] = 1u << 30;
    desc.handles = &handle;
    desc.handle_count = 1;
    ASSERT_EQ(flgPulledCreate(host.context, &desc, &pulled, nullptr), FLG_OK);
    host.finish();
    FlgPulledView shown = flgPulledViewDefaults();
    EXPECT_EQ(flgPulledGetView(host.context, pulled, &shown), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgErrorGetMessage()).find("desc.handles[0].vertices[1]"), std::string::npos);
}

}  // namespace
}  // namespace flg::test
