// SPDX-License-Identifier: MIT
// Surfaces that follow joints: what the shaders make of a pose is what flgSkinDeform makes of it.
#include <random>

#include "meshes.h"
#include "skins/test_skins.h"

namespace flg::render::test {
namespace {

using flg::test::about;
using flg::test::bar;
using flg::test::no_turns;
using flg::test::TestSkin;
using flg::test::turn;

constexpr FlgSkinning both[] = {FLG_SKINNING_LINEAR, FLG_SKINNING_DUAL_QUATERNION};

// Into the picture of front_camera(), which is about two metres wide.
TestSkin scaled(TestSkin skin, float scale, glm::vec3 offset) {
    for (std::vector<float>* points : {&skin.positions, &skin.joint_positions})
        for (size_t i = 0; i < points->size(); ++i)
            (*points)[i] = scale * (*points)[i] + offset[static_cast<int>(i % 3)];
    return skin;
}

TestSkin small_bar() {
    return scaled(bar(65, 24), 0.45f, {-0.9f, 0, 0});
}

TestSkin small_cross() {
    return scaled(flg::test::cross(33, 24), 0.35f, {0, 0, 0});
}

// Bent by turn about z, twisted about x, and turned as a whole.
std::vector<float> bent(const TestSkin& skin, float angle) {
    std::vector<float> rotations = no_turns(skin.joint_count());
    turn(rotations, 0, about({0, 1, 0}, 0.3f * angle));
    for (uint32_t j = 1; j < skin.joint_count(); ++j)
        turn(rotations, j, j % 2 ? about({0, 0, 1}, angle) : about({1, 0, 0}, 1.5f * angle));
    return rotations;
}

std::vector<float> pose_of(TestSkin& skin, FlgSkinning skinning, const std::vector<float>& rotations) {
    const bool linear = skinning == FLG_SKINNING_LINEAR;
    std::vector<float> transforms((linear ? 12 : 8) * size_t{skin.joint_count()});
    const FlgSkinView view = skin.view();
    EXPECT_EQ(flgSkinPose(&view, rotations.data(), nullptr, linear ? transforms.data() : nullptr,
                          linear ? nullptr : transforms.data()),
              FLG_OK)
        << flgErrorGetMessage();
    return transforms;
}

// The skin as a plain mesh, deformed by the processor.
Mesh deformed(TestSkin& skin, FlgSkinning skinning, const std::vector<float>& transforms) {
    Mesh mesh;
    mesh.positions.resize(skin.vertex_count());
    mesh.normals.resize(skin.vertex_count());
    mesh.triangles = skin.triangles;
    const FlgSkinView view = skin.view();
    EXPECT_EQ(flgSkinDeform(&view, skinning, transforms.data(), &mesh.positions[0].x, &mesh.normals[0].x), FLG_OK)
        << flgErrorGetMessage();
    return mesh;
}

class SkinsTest : public RendererTest {
protected:
    void SetUp() override {
        // Sheets behind all and behind the camera: the shadow map spans the same, whatever stands between.
        Scene scene;
        scene.ground = false;
        scene.sun_direction = {0.5f, 0.7f, 1};
        renderer.set_scene(scene);
        Mesh back = sheet(6, 6, 2, 2, -0.8f), behind = sheet(6, 6, 1, 1, 6.0f);
        renderer.upload(back.view(), {.casts_shadow = false});
        renderer.upload(behind.view(), {.casts_shadow = false});
        empty_ = picture(target_);
    }
    static uint32_t clearly_different(const Image& a, const Image& b) {
        uint32_t count = 0;
        for (size_t i = 0; i < a.pixels.size(); i += 4) count += max_difference(&a.pixels[i], &b.pixels[i]) > 4;
        return count;
    }
    Image of_mesh(Mesh mesh, const SurfaceLook& look = {}) {
        const SurfaceId id = renderer.upload(mesh.view(), look);
        const Image image = picture(target_);
        renderer.remove(id);
        return image;
    }
    Target target_{renderer, picture_size, picture_size};
    Image empty_;
};

TEST_F(SkinsTest, RestIsThePlainSurface) {
    TestSkin skin = small_cross();
    const std::vector<float> rest = no_turns(skin.joint_count());
    const Image plain = of_mesh(deformed(skin, FLG_SKINNING_LINEAR, pose_of(skin, FLG_SKINNING_LINEAR, rest)));
    EXPECT_GT(clearly_different(plain, empty_), 20000u);
    const SurfaceId id = renderer.upload(skin.view());
    int most = 0;
    const auto compare = [&](const Image& image) {
        for (size_t i = 0; i < plain.pixels.size(); i += 4)
            most = std::max(most, max_difference(&plain.pixels[i], &image.pixels[i]));
    };
    compare(picture(target_));  // before any pose
    for (const FlgSkinning skinning : both) {
        renderer.set_pose(id, skinning, pose_of(skin, skinning, rest));
        compare(picture(target_));
    }
    EXPECT_LE(most, 1);
}

// Colours of vertices are times those of materials: as a mesh with the products in its COLOR column, and as parts whose
// materials have them.
TEST_F(SkinsTest, VertexColorsAreTimesTheMaterials) {
    TestSkin skin = small_cross();
    const std::vector<float> rest = no_turns(skin.joint_count());
    const glm::vec3 red(0.8f, 0.3f, 0.2f);
    std::vector<float> colors;
    Mesh mesh = deformed(skin, FLG_SKINNING_LINEAR, pose_of(skin, FLG_SKINNING_LINEAR, rest));
    for (uint32_t v = 0; v < skin.vertex_count(); ++v) {
        const glm::vec3 color(v % 3 == 0 ? 1.0f : 0.25f, 0.9f, 0.5f + 0.5f * std::sin(0.1f * static_cast<float>(v)));
        colors.insert(colors.end(), {color.x, color.y, color.z, 1});
        mesh.colors.emplace_back(red * color, 1.0f);
    }
    SurfaceLook look;
    look.material.color = red;
    const Image plain = of_mesh(mesh);
    const Image without = of_mesh(deformed(skin, FLG_SKINNING_LINEAR, pose_of(skin, FLG_SKINNING_LINEAR, rest)), look);
    EXPECT_GT(clearly_different(plain, without), 10000u);
    look.vertex_colors = colors;
    const SurfaceId id = renderer.upload(skin.view(), look);
    EXPECT_LE(clearly_different(plain, picture(target_)), 0u);
    // Of parts, too.
    look.regions = {look.material, look.material};
    renderer.update(id, skin.view(), look);
    EXPECT_LE(clearly_different(plain, picture(target_)), 0u);
    look.vertex_colors = {colors.data(), 4};
    EXPECT_THROW(renderer.update(id, skin.view(), look), Error);
    colors[7] = 1.5f;
    look.vertex_colors = colors;
    EXPECT_THROW(renderer.update(id, skin.view(), look), Error);
}

// Shadows on the sheet included, for skins of two shapes, before and after the pose changes.
TEST_F(SkinsTest, PosesAreTheDeformedMesh) {
    for (TestSkin skin : {small_bar(), small_cross()}) {
        struct Shown {
            FlgSkinning skinning;
            std::vector<float> transforms;
            Image image;
        };
        std::vector<Shown> poses;
        const SurfaceId id = renderer.upload(skin.view());
        const Image rest = picture(target_);
        for (const FlgSkinning skinning : both) {
            for (const float angle : {0.4f, 0.9f}) {
                const std::vector<float> transforms = pose_of(skin, skinning, bent(skin, angle));
                renderer.set_pose(id, skinning, transforms);
                poses.push_back({skinning, transforms, picture(target_)});
                EXPECT_EQ(renderer.stats().uploaded_bytes, 0u);
            }
        }
        renderer.remove(id);
        for (const Shown& pose : poses) {
            const Image should = of_mesh(deformed(skin, pose.skinning, pose.transforms));
            EXPECT_LT(clearly_different(pose.image, should), picture_size * picture_size / 1000);
            EXPECT_GT(clearly_different(pose.image, rest), 5000u);
        }
    }
}

// The two ways differ where a joint is twisted, as they must.
TEST_F(SkinsTest, ATwistIsThinByLinearBlendingOnly) {
    TestSkin skin = small_bar();
    std::vector<float> rotations = no_turns(4);
    turn(rotations, 2, about({1, 0, 0}, 3.1f));
    const SurfaceId id = renderer.upload(skin.view());
    const glm::ivec2 near_edge = pixel_of(-0.9f + 0.45f * 2.0f, 0.45f * 0.2f);
    const auto covered = [&](FlgSkinning skinning) {
        renderer.set_pose(id, skinning, pose_of(skin, skinning, rotations));
        const Image image = picture(target_);
        return max_difference(image.at(near_edge.x, near_edge.y), empty_.at(near_edge.x, near_edge.y)) > 4;
    };
    EXPECT_TRUE(covered(FLG_SKINNING_DUAL_QUATERNION));
    EXPECT_FALSE(covered(FLG_SKINNING_LINEAR));
}

TEST_F(SkinsTest, EachFrameHasItsOwnPose) {
    TestSkin skin = small_bar();
    const SurfaceId id = renderer.upload(skin.view());
    std::vector<Image> pictures;
    const auto pose = [&](int i) {
        const FlgSkinning skinning = both[i % 2];
        return std::pair(skinning, pose_of(skin, skinning, bent(skin, 0.2f * static_cast<float>(i))));
    };
    for (int i = 0; i < 5; ++i) {
        const auto [skinning, transforms] = pose(i);
        renderer.set_pose(id, skinning, transforms);
        pictures.push_back(picture(target_));
    }
    // Two frames in flight, poses changed right after: the last must have the last pose.
    for (int i = 0; i < 5; ++i) {
        for (const int before : {(i + 1) % 5, (i + 2) % 5, i}) {
            const auto [skinning, transforms] = pose(before);
            renderer.set_pose(id, skinning, transforms);
            renderer.draw(target_, front_camera());
        }
        EXPECT_EQ(differing_pixels(renderer.capture(target_), pictures[static_cast<size_t>(i)]), 0u);
    }
}

TEST_F(SkinsTest, ManySkinsAtOnce) {
    TestSkin a = scaled(bar(33, 12), 0.2f, {-0.9f, 0.5f, 0}),
             b = scaled(flg::test::cross(17, 12), 0.2f, {0.3f, -0.3f, 0});
    const SurfaceId id_a = renderer.upload(a.view()), id_b = renderer.upload(b.view());
    const std::vector<float> pose_a = pose_of(a, FLG_SKINNING_DUAL_QUATERNION, bent(a, 0.5f));
    const std::vector<float> pose_b = pose_of(b, FLG_SKINNING_LINEAR, bent(b, 0.5f));
    renderer.set_pose(id_a, FLG_SKINNING_DUAL_QUATERNION, pose_a);
    renderer.set_pose(id_b, FLG_SKINNING_LINEAR, pose_b);
    const Image shown = picture(target_);
    renderer.remove(id_a);
    renderer.remove(id_b);
    Mesh mesh_a = deformed(a, FLG_SKINNING_DUAL_QUATERNION, pose_a), mesh_b = deformed(b, FLG_SKINNING_LINEAR, pose_b);
    renderer.upload(mesh_a.view());
    EXPECT_LT(clearly_different(shown, of_mesh(mesh_b)), picture_size * picture_size / 1000);
}

// The frames' room for joints grows, and stays when it is no longer needed.
TEST_F(SkinsTest, JointsMayBecomeMany) {
    TestSkin few = small_bar(), many = few;
    for (uint32_t j = 0; j < 5000; ++j) many.add_joint(0, 0, 0, 3, "more");
    const SurfaceId id = renderer.upload(few.view());
    const std::vector<float> pose = pose_of(few, FLG_SKINNING_LINEAR, bent(few, 0.5f));
    renderer.set_pose(id, FLG_SKINNING_LINEAR, pose);
    const Image shown = picture(target_);
    for (int round = 0; round < 3; ++round) {
        renderer.update(id, many.view());
        std::vector<float> rotations = bent(few, 0.5f);
        const std::vector<float> rest = no_turns(5000);
        rotations.insert(rotations.end(), rest.begin(), rest.end());
        renderer.set_pose(id, FLG_SKINNING_LINEAR, pose_of(many, FLG_SKINNING_LINEAR, rotations));
        EXPECT_EQ(differing_pixels(picture(target_), shown), 0u);
        renderer.update(id, few.view());
        renderer.set_pose(id, FLG_SKINNING_LINEAR, pose);
        EXPECT_EQ(differing_pixels(picture(target_), shown), 0u);
    }
}

// Parts have their materials, and keep them in a pose.
TEST_F(SkinsTest, PartsAreRegions) {
    TestSkin skin = small_cross();
    SurfaceLook look;
    look.regions.resize(4);
    for (size_t i = 0; i < 4; ++i) look.regions[i].color = {0.1f, i == 1 ? 0.8f : 0.1f, i == 2 ? 0.8f : 0.1f};
    const SurfaceId id = renderer.upload(skin.view(), look);
    const std::vector<float> transforms = pose_of(skin, FLG_SKINNING_LINEAR, bent(skin, 0.3f));
    renderer.set_pose(id, FLG_SKINNING_LINEAR, transforms);
    const Image shown = picture(target_);
    renderer.remove(id);
    Mesh mesh = deformed(skin, FLG_SKINNING_LINEAR, transforms);
    for (size_t i = 0; i < skin.triangles.size(); i += 3) mesh.regions.push_back(skin.parts[skin.triangles[i]]);
    EXPECT_LT(clearly_different(shown, of_mesh(mesh, look)), picture_size * picture_size / 1000);
    mesh.regions.clear();
    EXPECT_GT(clearly_different(shown, of_mesh(mesh)), 5000u);
}

// Bounds hold every vertex of every pose; at rest they are those of the vertices.
TEST_F(SkinsTest, BoundsHoldAllVertices) {
    renderer.clear();
    std::mt19937 random(5);
    std::normal_distribution<float> normal;
    for (TestSkin skin : {bar(33, 12), flg::test::cross(17, 12)}) {
        const SurfaceId id = renderer.upload(skin.view());
        const float length = renderer.bounds().diagonal();
        double widest = 0;
        for (int round = 0; round < 50; ++round) {
            std::vector<float> rotations;
            for (uint32_t j = 0; j < skin.joint_count(); ++j) {
                glm::vec4 q(normal(random), normal(random), normal(random), normal(random));
                q = glm::normalize(round == 0 ? glm::vec4(0, 0, 0, 1) : q);
                rotations.insert(rotations.end(), {q.x, q.y, q.z, q.w});
            }
            for (const FlgSkinning skinning : both) {
                const std::vector<float> transforms = pose_of(skin, skinning, rotations);
                renderer.set_pose(id, skinning, transforms);
                const Box box = renderer.bounds();
                Box tight;
                for (const glm::vec3& p : deformed(skin, skinning, transforms).positions) tight.add({p, p});
                for (int k = 0; k < 3; ++k) {
                    EXPECT_LE(box.min[k], tight.min[k] + 1e-5f);
                    EXPECT_GE(box.max[k], tight.max[k] - 1e-5f);
                    if (round > 0) continue;
                    EXPECT_NEAR(box.min[k], tight.min[k], 1e-6f);
                    EXPECT_NEAR(box.max[k], tight.max[k], 1e-6f);
                }
                widest = std::max(widest, double{box.diagonal()} / length);
            }
        }
        EXPECT_LT(widest, 2.5);  // joints turned by any angle
        renderer.remove(id);
    }
}

TEST_F(SkinsTest, CurvesInFrontAreOverEverything) {
    TestSkin skin = small_bar();
    const SurfaceId body_id = renderer.upload(skin.view());
    const Image body = picture(target_);
    flg::render::test::Curves bone;
    bone.add({-0.8f, 0, 0});
    bone.add({0.8f, 0, 0});
    bone.end();
    CurveLook look{.shape = Shape::tube, .radius = 0.02f, .casts_shadow = false};
    const CurvesId id = renderer.upload(bone.view(), look);
    EXPECT_EQ(differing_pixels(picture(target_), body), 0u);
    look.in_front = true;
    renderer.update(id, bone.view(), look);
    const float expected = 1.6f * 0.04f * pixels_per_metre() * pixels_per_metre();
    EXPECT_NEAR(differing_pixels(picture(target_), body), expected, 0.1f * expected);
    // Without the body's shadow: it looks as it does alone.
    const Image within = picture(target_);
    renderer.remove(body_id);
    const Image alone = picture(target_);
    const glm::ivec2 middle = pixel_of(0.1f, 0);
    EXPECT_LE(max_difference(within.at(middle.x, middle.y), alone.at(middle.x, middle.y)), 1);
    renderer.upload(skin.view());
    // What is not in front is drawn as before, in whatever order.
    look.in_front = false;
    flg::render::test::Curves before = bone;
    for (size_t i = 2; i < before.positions.size(); i += 3) before.positions[i] = 0.5f;
    renderer.upload(before.view(), look);
    EXPECT_GT(differing_pixels(picture(target_), body), 2000u);
}

TEST_F(SkinsTest, SkinsAndPlainSurfacesReplaceEachOther) {
    TestSkin skin = small_bar();
    Mesh mesh = deformed(skin, FLG_SKINNING_LINEAR, pose_of(skin, FLG_SKINNING_LINEAR, no_turns(4)));
    const SurfaceId id = renderer.upload(skin.view());
    const Image rest = picture(target_);
    renderer.update(id, mesh.view());
    EXPECT_LT(clearly_different(picture(target_), rest), 10u);
    expect_error([&] { renderer.set_pose(id, FLG_SKINNING_LINEAR, std::vector<float>(48)); }, "has no joints");
    renderer.update(id, skin.view());
    EXPECT_EQ(differing_pixels(picture(target_), rest), 0u);
    renderer.remove(id);
    EXPECT_EQ(differing_pixels(picture(target_), empty_), 0u);
    EXPECT_THROW(renderer.set_pose(id, FLG_SKINNING_LINEAR, std::vector<float>(48)), Error);
    EXPECT_THROW(renderer.update(id, skin.view()), Error);
}

TEST_F(SkinsTest, BadSkinsAreRefused) {
    const TestSkin sound = small_bar();
    TestSkin skin = sound;
    const auto refused = [&](const char* part, const SurfaceLook& look = {}) {
        expect_error([&] { renderer.upload(skin.view(), look); }, part);
        skin = sound;
    };
    skin.joints[5] = 4;
    refused("Vertex 1 names joint 4; the skin has 4");
    skin.weights[4] = NAN;
    refused("Vertex 1 has the weight nan");
    skin.weights[5] = -0.25f;
    refused("Vertex 1 has the weight -0.25");
    skin.weights[4] = 0.25f;
    skin.weights[5] = 0.75f;
    refused("Vertex 1 has the weight 0.75");
    skin.weights[4] = 0.5f;
    refused("weights of vertex 1 sum up to 0.5");
    skin.positions[3] = INFINITY;
    refused("Vertex 1 is at");
    skin.triangles[4] = 1u << 20;
    refused("Triangle 1 names vertex 1048576");
    skin.triangles[4] = 1u << 20;
    SurfaceLook regions;
    regions.regions.resize(2);
    refused("Triangle 1 names vertex 1048576", regions);
    refused("border_width_px must be 0", {.border_width_px = 1});
    regions.regions[1].border_width_px = 1;
    refused("border_width_px must be 0", regions);
    FlgSkinView view = skin.view();
    view.joint_count = 0;
    expect_error([&] { renderer.upload(view); }, "has 0 joints");
    view = skin.view();
    view.positions = nullptr;
    expect_error([&] { renderer.upload(view); }, "no positions");
    view = skin.view();
    view.vertex_joints = nullptr;
    expect_error([&] { renderer.upload(view); }, "no positions");
    view = skin.view();
    view.triangles = nullptr;
    expect_error([&] { renderer.upload(view); }, "no triangles");
}

TEST_F(SkinsTest, BadPosesAreRefusedAndChangeNothing) {
    TestSkin skin = small_bar();
    const SurfaceId id = renderer.upload(skin.view());
    const std::vector<float> good = pose_of(skin, FLG_SKINNING_DUAL_QUATERNION, bent(skin, 0.5f));
    renderer.set_pose(id, FLG_SKINNING_DUAL_QUATERNION, good);
    const Image shown = picture(target_);
    expect_error([&] { renderer.set_pose(id, FLG_SKINNING_LINEAR, good); }, "has 32 floats; 4 joints take 48");
    expect_error([&] { renderer.set_pose(id, static_cast<FlgSkinning>(2), good); }, "skinning is 2");
    std::vector<float> bad = good;
    bad[9] = NAN;
    expect_error([&] { renderer.set_pose(id, FLG_SKINNING_DUAL_QUATERNION, bad); }, "float 9 is nan");
    bad = good;
    for (size_t k = 8; k < 12; ++k) bad[k] *= 2;
    expect_error([&] { renderer.set_pose(id, FLG_SKINNING_DUAL_QUATERNION, bad); }, "joint 1 is 2 long");
    EXPECT_EQ(differing_pixels(picture(target_), shown), 0u);
}

// A flat skin whose parts meet in a column of squares: the border runs through the middles of edges, straight from top
// to bottom, and not along the triangles.
TEST_F(SkinsTest, PartsMeetInASharpStraightLine) {
    without_ground();
    const Mesh mesh = sheet(1.6f, 1.6f, 5, 5);
    TestSkin skin;
    skin.add_joint(0, 0, 0, FLG_NO_INDEX, "root");
    for (const glm::vec3& p : mesh.positions) {
        skin.positions.insert(skin.positions.end(), {p.x, p.y, p.z});
        skin.normals.insert(skin.normals.end(), {0, 0, 1});
        skin.parts.push_back(p.x < 0 ? 0 : 1);
        skin.bind(0, 0, 0.0f);
    }
    skin.triangles = mesh.triangles;
    SurfaceLook look;
    look.regions = {Material{.color = {0.8f, 0.05f, 0.05f}}, Material{.color = {0.05f, 0.05f, 0.8f}}};
    renderer.upload(skin.view(), look);
    const Image image = picture(target_);
    const int border = pixel_of(0, 0).x;  // vertices at +-0.16 m, 26 pixels away
    for (int y = pixel_of(0, 0.75f).y; y < pixel_of(0, -0.75f).y; ++y)
        for (int x = border - 24; x < border + 24; ++x) {
            if (std::abs(x - border) <= 1) continue;
            const uint8_t* pixel = image.at(x, y);
            const int redder = pixel[0] - pixel[2];
            ASSERT_GT(x < border ? redder : -redder, 60) << x << ", " << y;
        }
}

}  // namespace
}  // namespace flg::render::test
