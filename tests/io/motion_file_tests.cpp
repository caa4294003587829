// SPDX-License-Identifier: MIT
// Motions of rigid bodies as another reader (tinygltf) sees them, and what is refused.
#include <cmath>
#include <functional>
#include <limits>

#include "io/files.h"
#include "io/tinygltf_model.h"

namespace flg::test {
namespace {

// Turns about an axis, by any angle, on its way along a line.
struct Motion {
    std::vector<double> times, poses;
    FlgMotionFileWriteDesc desc = {};

    explicit Motion(size_t count) {
        for (size_t i = 0; i < count; ++i) {
            const double t = 0.1 * static_cast<double>(i), angle = angle_at(i), c = std::cos(angle),
                         s = std::sin(angle);
            times.push_back(t);
            // About x, y and z by turns of the motion's parts would tell less: about the axis (0.6, 0, 0.8).
            const double x = 0.6, z = 0.8, k = 1 - c;
            poses.insert(poses.end(), {c + x * x * k, -z * s, x * z * k, t,  //
                                       z * s, c, -x * s, 2 * t,              //
                                       x * z * k, x * s, c + z * z * k, 1 - 0.5 * t});
        }
        EXPECT_EQ(flgMotionFileWriteDescInit(&desc, sizeof desc), FLG_OK);
    }
    static double angle_at(size_t i) { return 0.4 * static_cast<double>(i); }
    FlgResult write(const std::string& path) {
        desc.position_count = static_cast<uint32_t>(times.size());
        desc.times = times.data();
        desc.poses = poses.data();
        return flgMotionFileWrite(path.c_str(), &desc);
    }
};

struct Triangle {
    std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
    std::vector<uint32_t> corners{0, 1, 2};
    FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0};
    FlgMeshView view = {};
    Triangle() {
        view.struct_size = sizeof view;
        view.vertex_count = 3;
        view.triangle_count = 1;
        view.triangles = corners.data();
        view.columns = &column;
        view.column_count = 1;
    }
};

// The rules of glTF 2.0 for this kind of file.
void expect_valid(const tinygltf::Model& model) {
    ASSERT_EQ(model.scenes.size(), 1u);
    EXPECT_EQ(model.scenes[0].nodes, std::vector<int>{0});
    ASSERT_EQ(model.nodes.size(), 1u);
    ASSERT_EQ(model.animations.size(), 1u);
    ASSERT_EQ(model.animations[0].channels.size(), 2u);
    std::vector<std::string> paths;
    for (const tinygltf::AnimationChannel& channel : model.animations[0].channels) {
        EXPECT_EQ(channel.target_node, 0);
        paths.push_back(channel.target_path);
        const tinygltf::AnimationSampler& sampler =
            model.animations[0].samplers.at(static_cast<size_t>(channel.sampler));
        EXPECT_EQ(sampler.interpolation, "LINEAR");
        const tinygltf::Accessor& input = model.accessors.at(static_cast<size_t>(sampler.input));
        const tinygltf::Accessor& output = model.accessors.at(static_cast<size_t>(sampler.output));
        EXPECT_EQ(input.count, output.count);
        for (const tinygltf::Accessor* accessor : {&input, &output})
            EXPECT_EQ(model.bufferViews.at(static_cast<size_t>(accessor->bufferView)).target, 0);
        const std::vector<float> times = values_of<float>(model, sampler.input);
        EXPECT_GE(times.front(), 0);
        EXPECT_EQ(input.minValues.at(0), times.front());
        EXPECT_EQ(input.maxValues.at(0), times.back());
        for (size_t i = 1; i < times.size(); ++i) EXPECT_LT(times[i - 1], times[i]);
    }
    EXPECT_EQ(paths, (std::vector<std::string>{"translation", "rotation"}));
}

std::vector<float> channel(const tinygltf::Model& model, size_t index) {
    return values_of<float>(model, model.animations[0].samplers[index].output);
}

TEST(MotionFile, MovesAMesh) {
    const Folder folder;
    Motion motion(40);
    const Triangle triangle;
    FlgMeshMaterial red = flgMeshMaterialDefaults();
    red.name = "red \"paint\"";
    red.color[1] = red.color[2] = 0;
    red.roughness = 0.5f;
    FlgMeshFileWriteDesc mesh = {};
    ASSERT_EQ(flgMeshFileWriteDescInit(&mesh, sizeof mesh), FLG_OK);
    mesh.split_regions = mesh.material_count = 1;
    mesh.materials = &red;
    motion.desc.mesh = &triangle.view;
    motion.desc.mesh_desc = &mesh;
    motion.desc.name = "falling \"leaf\"";
    ASSERT_EQ(motion.write(folder.at("a.glb")), FLG_OK) << flgIoErrorGetMessage();
    EXPECT_EQ(folder.entries(), 1u);
    const tinygltf::Model model = load_model(folder.at("a.glb"));
    expect_valid(model);
    EXPECT_EQ(model.nodes[0].name, "falling \"leaf\"");
    EXPECT_EQ(model.nodes[0].mesh, 0);
    EXPECT_EQ(model.nodes[0].camera, -1);
    EXPECT_EQ(model.materials.at(0).name, "red \"paint\"");
    EXPECT_EQ(model.meshes.at(0).primitives.size(), 1u);
    const std::vector<float> places = channel(model, 0), turns = channel(model, 1);
    ASSERT_EQ(places.size(), 3 * motion.times.size());
    ASSERT_EQ(turns.size(), 4 * motion.times.size());
    for (size_t i = 0; i < motion.times.size(); ++i) {
        for (size_t k = 0; k < 3; ++k)
            EXPECT_EQ(places[3 * i + k], static_cast<float>(motion.poses[12 * i + 4 * k + 3]));
        // Continuous over several whole turns, where sines of half the angle change signs: the angle itself, never the
        // other way.
        const double half = 0.5 * Motion::angle_at(i);
        const double expected[] = {0.6 * std::sin(half), 0, 0.8 * std::sin(half), std::cos(half)};
        for (size_t k = 0; k < 4; ++k) EXPECT_NEAR(turns[4 * i + k], expected[k], 1e-7) << i;
    }
    for (size_t k = 0; k < 3; ++k) EXPECT_EQ(static_cast<float>(model.nodes[0].translation.at(k)), places[k]);
    for (size_t k = 0; k < 4; ++k) EXPECT_EQ(static_cast<float>(model.nodes[0].rotation.at(k)), turns[k]);
}

TEST(MotionFile, MovesACameraOrNothing) {
    const Folder folder;
    Motion motion(3);
    motion.desc.camera_fov_rad = 0.75f;
    ASSERT_EQ(motion.write(folder.at("camera.glb")), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model model = load_model(folder.at("camera.glb"));
    expect_valid(model);
    EXPECT_EQ(model.nodes[0].camera, 0);
    EXPECT_EQ(model.nodes[0].mesh, -1);
    EXPECT_TRUE(model.meshes.empty());
    ASSERT_EQ(model.cameras.size(), 1u);
    EXPECT_EQ(model.cameras[0].type, "perspective");
    EXPECT_EQ(static_cast<float>(model.cameras[0].perspective.yfov), 0.75f);
    EXPECT_GT(model.cameras[0].perspective.znear, 0);
    Motion alone(1);
    ASSERT_EQ(alone.write(folder.at("alone.glb")), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model nothing = load_model(folder.at("alone.glb"));
    expect_valid(nothing);
    EXPECT_TRUE(nothing.cameras.empty() && nothing.meshes.empty());
}

TEST(MotionFile, ClosedMotionsComeBack) {
    const Folder folder;
    Motion motion(12);
    motion.desc.end_time = 1.5;
    ASSERT_EQ(motion.write(folder.at("a.glb")), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model model = load_model(folder.at("a.glb"));
    expect_valid(model);
    const std::vector<float> times = values_of<float>(model, model.animations[0].samplers[0].input);
    const std::vector<float> places = channel(model, 0), turns = channel(model, 1);
    ASSERT_EQ(times.size(), 13u);
    EXPECT_EQ(times.back(), 1.5f);
    for (size_t k = 0; k < 3; ++k) EXPECT_EQ(places[36 + k], places[k]);
    // The rotation of the first pose, on the side of the one before.
    double with_first = 0, with_last = 0;
    for (size_t k = 0; k < 4; ++k) {
        with_first += double{turns[48 + k]} * turns[k];
        with_last += double{turns[48 + k]} * turns[44 + k];
    }
    EXPECT_NEAR(std::abs(with_first), 1, 1e-6);
    EXPECT_GT(with_last, 0);
}

TEST(MotionFile, RefusesWhatIsNoMotion) {
    const Folder folder;
    const auto expect_refusal = [&](const std::string& sentence, const std::function<void(Motion&)>& spoil) {
        Motion motion(4);
        spoil(motion);
        EXPECT_EQ(motion.write(folder.at("a.glb")), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(std::string(flgIoErrorGetMessage()).substr(folder.at("a.glb").size()), sentence);
        EXPECT_EQ(folder.entries(), 0u);
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const std::string rotation =
        "starts a pose that is no rotation: it must keep lengths within 0.001 and turn nothing inside out";
    expect_refusal(":desc.poses[12]: " + rotation, [](Motion& m) { m.poses[13] += 0.01; });
    expect_refusal(":desc.poses[24]: " + rotation, [](Motion& m) {
        for (size_t k = 0; k < 3; ++k) m.poses[24 + 4 * k] *= -1;
    });
    expect_refusal(":desc.poses[15]: is nan, must be finite and at most 1e30 in size",
                   [](Motion& m) { m.poses[15] = nan; });
    const std::string rise = "; times rise from 0 or later, as floats";
    expect_refusal(":desc.times[0]: is -0.1 after -1" + rise, [](Motion& m) { m.times[0] = -0.1; });
    expect_refusal(":desc.times[2]: is nan after 0.100000001" + rise, [](Motion& m) { m.times[2] = nan; });
    expect_refusal(":desc.times[2]: is 0.1 after 0.100000001" + rise, [](Motion& m) { m.times[2] = 0.1 + 1e-12; });
    expect_refusal(":desc.end_time: is 0.25 after 0.300000012" + rise, [](Motion& m) { m.desc.end_time = 0.25; });
    expect_refusal(":desc.camera_fov_rad: is 4, must be 0 or above and below pi",
                   [](Motion& m) { m.desc.camera_fov_rad = 4; });
    expect_refusal(":desc.name: must be UTF-8 of at most 255 bytes", [](Motion& m) { m.desc.name = "\xff"; });
    expect_refusal(":desc.position_count: is 0, must be at least 1", [](Motion& m) {
        m.times.clear();
        m.poses.clear();
    });
    const Triangle triangle;
    FlgMeshView broken = triangle.view;
    broken.vertex_count = 2;
    expect_refusal(":view.triangles[2]: is 2, but there are 2 vertices", [&](Motion& m) { m.desc.mesh = &broken; });
    Motion motion(2);
    EXPECT_EQ(motion.write(folder.at("a.gltf")), FLG_ERROR_FORMAT);
    EXPECT_EQ(flgMotionFileWrite(nullptr, &motion.desc), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(flgMotionFileWrite(folder.at("a.glb").c_str(), nullptr), FLG_ERROR_INVALID_ARGUMENT);
    motion.desc.struct_size = 8;
    EXPECT_EQ(motion.write(folder.at("a.glb")), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace flg::test
