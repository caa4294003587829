// SPDX-License-Identifier: MIT
// Bodies of parts and skins of models behind the C ABI.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "api/part_inputs.h"

namespace flg::test {
namespace {

std::vector<double> ellipse(double x, double y, double rx, double ry, uint32_t n = 120) {
    std::vector<double> points;
    for (uint32_t i = 0; i < n; ++i) {
        points.push_back(x + rx * std::cos(2 * M_PI * i / n));
        points.push_back(y + ry * std::sin(2 * M_PI * i / n));
    }
    return points;
}

struct SkinHost : PartHost {
    using PartHost::PartHost;

    // A body and an arm that is there twice.
    FlgModel model() const {
        FlgModelPart parts[2] = {flgModelPartDefaults(), flgModelPartDefaults()};
        parts[0].part = part(ellipse(0, 0, 1, 2));
        parts[0].name = "body";
        parts[1].part = part(ellipse(1.6, 0.8, 1.2, 0.35));
        parts[1].name = "arm";
        parts[1].mirrored = 1;
        FlgModelDesc desc = flgModelDefaults();
        desc.parts = parts;
        desc.part_count = 2;
        FlgModel model{};
        EXPECT_EQ(flgModelCreate(context, &desc, &model, nullptr), FLG_OK) << flgErrorGetMessage();
        return model;
    }
    FlgSkinView skin(uint32_t vertices, FlgSkin* out_skin = nullptr) const {
        FlgSkinDesc desc = flgSkinDefaults();
        desc.model = model();
        desc.vertex_count = vertices;
        FlgSkin skin{};
        EXPECT_EQ(flgSkinCreate(context, &desc, &skin, nullptr), FLG_OK) << flgErrorGetMessage();
        FlgSkinView view = flgSkinViewDefaults();
        EXPECT_EQ(flgSkinGetView(context, skin, &view), FLG_NOT_READY);
        finish();
        EXPECT_EQ(flgSkinGetView(context, skin, &view), FLG_OK) << flgErrorGetMessage();
        if (out_skin) *out_skin = skin;
        return view;
    }
};

// Each side belongs to two triangles that go along it in opposite directions.
void expect_closed(const uint32_t* triangles, uint32_t count) {
    std::map<std::pair<uint32_t, uint32_t>, int> sides;
    for (uint32_t t = 0; t < count; ++t)
        for (uint32_t k = 0; k < 3; ++k) ++sides[{triangles[3 * t + k], triangles[3 * t + (k + 1) % 3]}];
    for (const auto& [side, times] : sides) {
        ASSERT_EQ(times, 1);
        ASSERT_EQ(sides.count({side.second, side.first}), 1u);
    }
}

TEST(PartMesh, OfADiscIsABall) {
    const SkinHost host;
    FlgPartMeshDesc desc = flgPartMeshDefaults();
    desc.part = host.part(ellipse(3, 4, 2, 2, 200));
    FlgPartMesh mesh{};
    ASSERT_EQ(flgPartMeshCreate(host.context, &desc, &mesh, nullptr), FLG_OK) << flgErrorGetMessage();
    FlgPartMeshView view = flgPartMeshViewDefaults();
    EXPECT_EQ(flgPartMeshGetView(host.context, mesh, &view), FLG_NOT_READY);
    host.finish();
    ASSERT_EQ(flgPartMeshGetView(host.context, mesh, &view), FLG_OK) << flgErrorGetMessage();
    ASSERT_GT(view.vertex_count, 100u);
    expect_closed(view.triangles, view.triangle_count);
    for (uint32_t v = 0; v < view.vertex_count; ++v) {
        const float* p = view.positions + 3 * v;
        EXPECT_NEAR(std::hypot(p[0] - 3, p[1] - 4, p[2]), 2, 0.06);
    }
    EXPECT_EQ(flgPartMeshRelease(host.context, mesh), FLG_OK);
}

TEST(Skin, IsOneClosedSurfaceBoundToItsJoints) {
    const SkinHost host;
    const FlgSkinView view = host.skin(3000);
    EXPECT_NEAR(view.vertex_count, 3000, 450);
    expect_closed(view.triangles, view.triangle_count);
    for (uint32_t v = 0; v < view.vertex_count; ++v) {
        float sum = 0;
        for (uint32_t k = 0; k < 4; ++k) {
            const float weight = view.vertex_weights[4 * v + k];
            ASSERT_GE(weight, 0);
            ASSERT_LE(weight, 1.0001f);
            ASSERT_LT(view.vertex_joints[4 * v + k], view.joint_count);
            sum += weight;
        }
        ASSERT_NEAR(sum, 1, 1e-4);
        ASSERT_LT(view.vertex_parts[v], 3u);
        const float* n = view.normals + 3 * v;
        ASSERT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-4);
    }
    // The far end of each arm moves with that arm alone.
    for (const float side : {-1.0f, 1.0f}) {
        uint32_t end = 0;
        for (uint32_t v = 0; v < view.vertex_count; ++v)
            if (side * view.positions[3 * v] > side * view.positions[3 * end]) end = v;
        for (uint32_t k = 0; k < 4; ++k) {
            if (view.vertex_weights[4 * end + k] < 0.01f) continue;
            const std::string name = view.joint_names[view.vertex_joints[4 * end + k]];
            EXPECT_EQ(name.substr(0, 4), "arm_");
            EXPECT_EQ(name.back(), side > 0 ? 'L' : 'R');
        }
    }
}

TEST(Skin, HasAsManyVerticesAsAskedFor) {
    const SkinHost host;
    for (const uint32_t vertices : {1000u, 7000u}) EXPECT_EQ(host.skin(vertices).vertex_count, vertices);
    // Its arms are too thin for so few.
    EXPECT_GT(host.skin(500).vertex_count, 500u);
}

// Texture coordinates of triangles of a part are where its picture has them, an image's mirrored.
TEST(Skin, ShowsPicturesOfItsParts) {
    const SkinHost host;
    FlgModelPart parts[2] = {flgModelPartDefaults(), flgModelPartDefaults()};
    parts[0].part = host.part(ellipse(0, 0, 1, 2));
    parts[1].part = host.part(ellipse(1.6, 0.8, 1.2, 0.35));
    parts[1].mirrored = 1;
    for (FlgModelPart& part : parts) {
        const double box[] = {-4, -3, 4, 5};
        std::copy(std::begin(box), std::end(box), part.picture);
    }
    FlgModelDesc model_desc = flgModelDefaults();
    model_desc.parts = parts;
    model_desc.part_count = 2;
    FlgSkinDesc desc = flgSkinDefaults();
    ASSERT_EQ(flgModelCreate(host.context, &model_desc, &desc.model, nullptr), FLG_OK) << flgErrorGetMessage();
    desc.vertex_count = 2000;
    FlgSkin skin{}, level{};
    ASSERT_EQ(flgSkinCreate(host.context, &desc, &skin, nullptr), FLG_OK);
    FlgSkinSimplifyDesc simplify = flgSkinSimplifyDefaults();
    simplify.skin = skin;
    simplify.vertex_count = 400;
    ASSERT_EQ(flgSkinSimplify(host.context, &simplify, &level, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    for (const FlgSkin& made : {skin, level}) {
        FlgSkinView view = flgSkinViewDefaults();
        ASSERT_EQ(flgSkinGetView(host.context, made, &view), FLG_OK) << flgErrorGetMessage();
        EXPECT_EQ(view.vertex_count, made.id == skin.id ? 2000u : 400u);
        expect_closed(view.triangles, view.triangle_count);
        ASSERT_NE(view.corner_uvs, nullptr);
        uint32_t of_part[3] = {};
        for (size_t c = 0; c < size_t{3} * view.triangle_count; ++c) {
            const uint32_t part = view.triangle_parts[c / 3];
            ASSERT_LT(part, 3u);
            ++of_part[part];
            const float* p = view.positions + size_t{3} * view.triangles[c];
            EXPECT_NEAR(view.corner_uvs[2 * c], ((part == 2 ? -1 : 1) * p[0] + 4) / 8, 1e-5f);
            EXPECT_NEAR(view.corner_uvs[2 * c + 1], (5 - p[1]) / 8, 1e-5f);
        }
        for (const uint32_t corners : of_part) EXPECT_GT(corners, 30u);
    }
    parts[1].picture[2] = -5;
    EXPECT_EQ(flgModelCreate(host.context, &model_desc, &desc.model, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgErrorGetMessage()).find("desc.parts[1].picture is -4 to -5"), std::string::npos)
        << flgErrorGetMessage();
    simplify.vertex_count = 3;
    EXPECT_EQ(flgSkinSimplify(host.context, &simplify, &level, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    simplify.vertex_count = 100;
    simplify.skin = {};
    EXPECT_EQ(flgSkinSimplify(host.context, &simplify, &level, nullptr), FLG_ERROR_INVALID_HANDLE);
}

TEST(Skin, TakesWeightsOfTheHost) {
    const SkinHost host;
    FlgSkinSetWeightsDesc desc = flgSkinSetWeightsDefaults();
    const FlgSkinView made = host.skin(600, &desc.skin);
    std::vector<uint16_t> joints(made.vertex_joints, made.vertex_joints + 4 * made.vertex_count);
    std::vector<float> weights(made.vertex_weights, made.vertex_weights + 4 * made.vertex_count);
    const auto set = [&](size_t vertex, std::array<uint16_t, 4> of, std::array<float, 4> with) {
        std::copy(of.begin(), of.end(), joints.begin() + 4 * vertex);
        std::copy(with.begin(), with.end(), weights.begin() + 4 * vertex);
    };
    set(0, {1, 0, 1, 2}, {0.25f, 0.4f, 0.25f, 0.1f});  // a joint twice
    set(1, {0, 65535, 1, 0}, {0.4995f, 0, 0.5f, 0});   // a sum just below 1, no such joint for a weight of 0
    desc.vertex_count = made.vertex_count;
    desc.vertex_joints = joints.data();
    desc.vertex_weights = weights.data();
    FlgSkin skin{};
    const auto refusal = [&](FlgSkinSetWeightsDesc wrong) {
        if (flgSkinSetWeights(host.context, &wrong, &skin, nullptr) == FLG_OK) {
            host.finish();
            FlgSkinView none = flgSkinViewDefaults();
            EXPECT_EQ(flgSkinGetView(host.context, skin, &none), FLG_ERROR_INVALID_ARGUMENT);
        }
        return std::string(flgErrorGetMessage());
    };
    ASSERT_EQ(flgSkinSetWeights(host.context, &desc, &skin, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    FlgSkinView view = flgSkinViewDefaults();
    ASSERT_EQ(flgSkinGetView(host.context, skin, &view), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(std::vector<float>(view.positions, view.positions + 3 * view.vertex_count),
              std::vector<float>(made.positions, made.positions + 3 * made.vertex_count));
    EXPECT_EQ(view.triangle_count, made.triangle_count);
    EXPECT_STREQ(view.joint_names[1], made.joint_names[1]);
    EXPECT_EQ(view.vertex_joints[0], 1);
    EXPECT_FLOAT_EQ(view.vertex_weights[0], 0.5f);
    EXPECT_EQ(view.vertex_joints[2], 2);
    EXPECT_EQ(view.vertex_weights[3], 0);
    EXPECT_EQ(view.vertex_joints[4], 1);
    EXPECT_FLOAT_EQ(view.vertex_weights[4] + view.vertex_weights[5], 1);
    for (size_t i = 8; i < weights.size(); ++i) EXPECT_NEAR(view.vertex_weights[i], made.vertex_weights[i], 1e-6f);
    // Levels of detail are of the new weights.
    FlgSkinSimplifyDesc simplify = flgSkinSimplifyDefaults();
    simplify.skin = skin;
    simplify.vertex_count = 200;
    FlgSkin level{};
    ASSERT_EQ(flgSkinSimplify(host.context, &simplify, &level, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    ASSERT_EQ(flgSkinGetView(host.context, level, &view), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(view.vertex_count, 200u);

    desc.vertex_count = 7;
    EXPECT_NE(refusal(desc).find("desc.vertex_count is 7, but the skin has "), std::string::npos) << refusal(desc);
    desc.vertex_count = made.vertex_count;
    set(2, {65535, 0, 0, 0}, {1, 0, 0, 0});
    EXPECT_NE(refusal(desc).find("vertex 2 has joint 65535, but there are "), std::string::npos) << refusal(desc);
    set(2, {0, 1, 0, 0}, {0.5f, 0.4f, 0, 0});
    EXPECT_NE(refusal(desc).find("those of vertex 2 sum up to 0.9, must be 1"), std::string::npos) << refusal(desc);
    for (const float wrong : {NAN, -0.5f, 1.5f, INFINITY}) {
        set(2, {0, 1, 0, 0}, {1, wrong, 0, 0});
        EXPECT_NE(refusal(desc).find("desc.vertex_weights[9] is "), std::string::npos) << refusal(desc);
    }
    desc.vertex_joints = nullptr;
    EXPECT_NE(refusal(desc).find("desc.vertex_joints"), std::string::npos) << refusal(desc);
    desc.vertex_joints = joints.data();
    desc.skin = {};
    EXPECT_EQ(flgSkinSetWeights(host.context, &desc, &skin, nullptr), FLG_ERROR_INVALID_HANDLE);
}

TEST(Skin, IsTheSameUnderWorkers) {
    std::vector<float> positions, weights;
    for (const uint32_t workers : {0u, 2u}) {
        const SkinHost host(workers);
        const FlgSkinView view = host.skin(1000);
        const std::vector<float> p(view.positions, view.positions + 3 * view.vertex_count);
        const std::vector<float> w(view.vertex_weights, view.vertex_weights + 4 * view.vertex_count);
        if (workers == 0) positions = p, weights = w;
        EXPECT_EQ(p, positions);
        EXPECT_EQ(w, weights);
    }
}

// Two legs that cross.
TEST(Skin, JointsOfLimbsThatCrossMoveOutOfTheDrawing) {
    const SkinHost host;
    FlgModelPart parts[3] = {flgModelPartDefaults(), flgModelPartDefaults(), flgModelPartDefaults()};
    parts[0].part = host.part(ellipse(0, 0, 1.6, 0.9));
    parts[1].part = host.part({-1.05, -0.2, 0.85, -4, 1.25, -3.9, -0.65, -0.1});
    parts[2].part = host.part({0.65, -0.1, -1.25, -3.9, -0.85, -4, 1.05, -0.2});
    FlgModelDesc desc = flgModelDefaults();
    desc.parts = parts;
    desc.part_count = 3;
    // The front of the two, by how far their last joints are in front of the drawing.
    const auto front = [&] {
        FlgModel model{};
        EXPECT_EQ(flgModelCreate(host.context, &desc, &model, nullptr), FLG_OK) << flgErrorGetMessage();
        FlgSkinDesc of_skin = flgSkinDefaults();
        of_skin.model = model;
        of_skin.vertex_count = 3000;
        FlgSkin skin{};
        EXPECT_EQ(flgSkinCreate(host.context, &of_skin, &skin, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        FlgSkinView view = flgSkinViewDefaults();
        FlgModelView bones = flgModelViewDefaults();
        EXPECT_EQ(flgSkinGetView(host.context, skin, &view), FLG_OK) << flgErrorGetMessage();
        EXPECT_EQ(flgModelGetView(host.context, model, &bones), FLG_OK);
        float depth[3] = {0, 0, 0};
        for (uint32_t j = 0; j < bones.joint_count; ++j) {
            EXPECT_EQ(bones.joint_positions[3 * j + 2], 0);
            EXPECT_EQ(view.joint_positions[3 * j], bones.joint_positions[3 * j]);
            float& own = depth[bones.joint_parts[j]];
            if (std::abs(view.joint_positions[3 * j + 2]) > std::abs(own)) own = view.joint_positions[3 * j + 2];
        }
        EXPECT_EQ(depth[0], 0);
        EXPECT_GT(std::abs(depth[1] - depth[2]), 0.2f);
        return depth[1] > depth[2] ? 1 : 2;
    };
    EXPECT_EQ(front(), 2);
    parts[1].depth = 1;
    EXPECT_EQ(front(), 1);
}

TEST(Skin, PartsThatMeetNoneStayPieces) {
    const SkinHost host;
    const FlgPart disc = host.part(ellipse(0, 0, 1, 1));
    FlgModelPart parts[2] = {flgModelPartDefaults(), flgModelPartDefaults()};
    parts[0].part = parts[1].part = disc;
    parts[1].placement[3] = 5;
    FlgModelDesc model_desc = flgModelDefaults();
    model_desc.parts = parts;
    model_desc.part_count = 2;
    FlgSkinDesc desc = flgSkinDefaults();
    ASSERT_EQ(flgModelCreate(host.context, &model_desc, &desc.model, nullptr), FLG_OK);
    desc.vertex_count = 1000;
    FlgSkin skin{};
    ASSERT_EQ(flgSkinCreate(host.context, &desc, &skin, nullptr), FLG_OK);
    host.finish();
    FlgSkinView view = flgSkinViewDefaults();
    ASSERT_EQ(flgSkinGetView(host.context, skin, &view), FLG_OK) << flgErrorGetMessage();
    expect_closed(view.triangles, view.triangle_count);
    // Two balls have Euler number 4.
    EXPECT_EQ(static_cast<int64_t>(view.vertex_count) - view.triangle_count / 2, 4);
    for (uint32_t v = 0; v < view.vertex_count; ++v) {
        const uint32_t part = view.positions[3 * v] > 2.5f;
        EXPECT_EQ(view.vertex_parts[v], part);
        EXPECT_EQ(view.joint_names[view.vertex_joints[4 * v]][4], part ? '1' : '0');
    }
}

TEST(Skin, RefusesNumbersOutOfTheirRange) {
    const SkinHost host;
    const FlgModel model = host.model();
    const auto refused = [&](const std::function<void(FlgSkinDesc&)>& change, const std::string& words) {
        FlgSkinDesc desc = flgSkinDefaults();
        desc.model = model;
        change(desc);
        FlgSkin skin{77};
        EXPECT_LT(flgSkinCreate(host.context, &desc, &skin, nullptr), 0);
        EXPECT_EQ(skin.id, 0u);
        EXPECT_NE(std::string(flgErrorGetMessage()).find(words), std::string::npos) << flgErrorGetMessage();
    };
    refused([](FlgSkinDesc& d) { d.vertex_count = 10; }, "desc.vertex_count is 10");
    refused([](FlgSkinDesc& d) { d.max_vertices = 5; }, "desc.max_vertices is 5");
    refused([](FlgSkinDesc& d) { d.blend = NAN; }, "desc.blend is nan");
    refused([](FlgSkinDesc& d) { d.corner_angle = 4; }, "desc.corner_angle is 4");
    refused([](FlgSkinDesc& d) { d.model = {}; }, "desc.model is null");
    FlgPartMeshDesc desc = flgPartMeshDefaults();
    desc.part = host.part(ellipse(0, 0, 1, 1));
    FlgPartMesh mesh{};
    desc.thickness = 0;
    EXPECT_EQ(flgPartMeshCreate(host.context, &desc, &mesh, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgErrorGetMessage()).find("desc.thickness is 0"), std::string::npos) << flgErrorGetMessage();
    desc.thickness = 1;
    desc.spacing = -1;
    EXPECT_EQ(flgPartMeshCreate(host.context, &desc, &mesh, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgErrorGetMessage()).find("desc.spacing is -1"), std::string::npos) << flgErrorGetMessage();
    // Only the job knows how long the part is.
    for (const double spacing : {1e-5, 100.0}) {
        desc.spacing = spacing;
        ASSERT_EQ(flgPartMeshCreate(host.context, &desc, &mesh, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        FlgPartMeshView view = flgPartMeshViewDefaults();
        EXPECT_EQ(flgPartMeshGetView(host.context, mesh, &view), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(std::string(flgErrorGetMessage()).find("of the part's length"), std::string::npos)
            << flgErrorGetMessage();
    }
}

// What becomes of a skin of some 1,000 vertices, and at most 5,000.
FlgResult made_of(const SkinHost& host, const FlgModelPart* parts, uint32_t count) {
    FlgModelDesc model_desc = flgModelDefaults();
    model_desc.parts = parts;
    model_desc.part_count = count;
    FlgSkinDesc desc = flgSkinDefaults();
    EXPECT_EQ(flgModelCreate(host.context, &model_desc, &desc.model, nullptr), FLG_OK);
    desc.vertex_count = 1000;
    desc.max_vertices = 5000;
    FlgSkin skin{};
    EXPECT_EQ(flgSkinCreate(host.context, &desc, &skin, nullptr), FLG_OK);
    host.finish();
    FlgSkinView view = flgSkinViewDefaults();
    return flgSkinGetView(host.context, skin, &view);
}

TEST(Skin, AThinPartNeedsMoreVerticesThanAllowed) {
    const SkinHost host;
    FlgModelPart parts[2] = {flgModelPartDefaults(), flgModelPartDefaults()};
    parts[0].part = host.part(ellipse(0, 0, 5, 5));
    parts[1].part = host.part(ellipse(5, 0, 3, 0.02));
    parts[1].name = "hair";
    EXPECT_EQ(made_of(host, parts, 2), FLG_ERROR_LIMIT) << flgErrorGetMessage();
}

// Vertices are floats: far enough from the origin all would lie in one place, and the surface would leave its grid.
TEST(Skin, ItsPartsMayNotBeTooFarFromTheOrigin) {
    for (const auto& [place, expected] :
         {std::pair(1e4, FLG_OK), std::pair(1e7, FLG_ERROR_LIMIT), std::pair(-1e30, FLG_ERROR_LIMIT)}) {
        const SkinHost host;
        FlgModelPart part = flgModelPartDefaults();
        part.part = host.part(ellipse(0, 0, 2, 1));
        part.placement[3] = place;
        EXPECT_EQ(made_of(host, &part, 1), expected) << place << ": " << flgErrorGetMessage();
    }
}

}  // namespace
}  // namespace flg::test
