// SPDX-License-Identifier: MIT
// Poses of skins and their vertices, by what has a closed form.
#include <functional>
#include <random>

#include "api/host.h"
#include "skins/test_skins.h"

namespace flg::test {
namespace {

constexpr float pi = 3.14159265f;
using Point = std::array<double, 3>;

struct Pose {
    std::vector<float> matrices, duals;
};

Pose pose_of(TestSkin& skin, const std::vector<float>& rotations, const float* translation = nullptr) {
    Pose pose{std::vector<float>(12 * size_t{skin.joint_count()}), std::vector<float>(8 * size_t{skin.joint_count()})};
    const FlgSkinView view = skin.view();
    EXPECT_EQ(flgSkinPose(&view, rotations.empty() ? nullptr : rotations.data(), translation, pose.matrices.data(),
                          pose.duals.data()),
              FLG_OK)
        << flgErrorGetMessage();
    return pose;
}

struct Deformed {
    std::vector<float> positions, normals;
    Point at(size_t v) const { return {positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]}; }
};

Deformed deformed(TestSkin& skin, const Pose& pose, FlgSkinning skinning) {
    Deformed out{std::vector<float>(skin.positions.size()), std::vector<float>(skin.positions.size())};
    const FlgSkinView view = skin.view();
    const bool linear = skinning == FLG_SKINNING_LINEAR;
    EXPECT_EQ(flgSkinDeform(&view, skinning, (linear ? pose.matrices : pose.duals).data(), out.positions.data(),
                            out.normals.data()),
              FLG_OK)
        << flgErrorGetMessage();
    return out;
}

Point by_matrix(const float* m, const Point& p) {
    Point q;
    for (size_t r = 0; r < 3; ++r)
        q[r] = double{m[4 * r]} * p[0] + double{m[4 * r + 1]} * p[1] + double{m[4 * r + 2]} * p[2] + m[4 * r + 3];
    return q;
}

// By the definition: t = 2 d r*, x goes to r x r* + t.
Point by_dual(const float* q, const Point& p) {
    const auto multiply = [](const std::array<double, 4>& a, const std::array<double, 4>& b) {
        return std::array<double, 4>{a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
                                     a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
                                     a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
                                     a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
    };
    const std::array<double, 4> real = {q[0], q[1], q[2], q[3]}, back = {-q[0], -q[1], -q[2], q[3]},
                                dual = {q[4], q[5], q[6], q[7]};
    const auto turned = multiply(multiply(real, {p[0], p[1], p[2], 0}), back), moved = multiply(dual, back);
    return {turned[0] + 2 * moved[0], turned[1] + 2 * moved[1], turned[2] + 2 * moved[2]};
}

void expect_near(const Point& a, const Point& b, double tolerance) {
    for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << k;
}

// Around the bar's axis, of the vertex of a ring.
double distance_from_axis(const Point& p) {
    return std::hypot(p[1], p[2]);
}

std::vector<float> random_rotations(uint32_t joint_count, uint32_t seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> normal;
    std::vector<float> rotations;
    for (uint32_t j = 0; j < joint_count; ++j) {
        float q[4], sum = 0;
        for (float& c : q) {
            c = normal(random);
            sum += c * c;
        }
        for (const float c : q) rotations.push_back(c / std::sqrt(sum));
    }
    return rotations;
}

TEST(Poses, RestIsTheIdentityBitForBit) {
    TestSkin skin = cross();
    for (const std::vector<float>& rotations : {std::vector<float>(), no_turns(skin.joint_count())}) {
        const Pose pose = pose_of(skin, rotations);
        const float unit[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        const float still[8] = {0, 0, 0, 1, 0, 0, 0, 0};
        for (size_t j = 0; j < skin.joint_count(); ++j) {
            for (size_t k = 0; k < 12; ++k) EXPECT_EQ(pose.matrices[12 * j + k], unit[k]);
            for (size_t k = 0; k < 8; ++k) EXPECT_EQ(pose.duals[8 * j + k], still[k]);
        }
        EXPECT_EQ(deformed(skin, pose, FLG_SKINNING_LINEAR).positions, skin.positions);
        EXPECT_EQ(deformed(skin, pose, FLG_SKINNING_DUAL_QUATERNION).positions, skin.positions);
    }
}

// The root's motion takes the whole along, by either way of skinning.
TEST(Poses, TheRootMovesAllRigidly) {
    TestSkin skin = cross();
    std::vector<float> rotations = no_turns(skin.joint_count());
    turn(rotations, 0, about({0, 0, 1}, 0.5f * pi));
    const float translation[] = {5, -7, 11};
    const Pose pose = pose_of(skin, rotations, translation);
    for (const FlgSkinning skinning : {FLG_SKINNING_LINEAR, FLG_SKINNING_DUAL_QUATERNION}) {
        const Deformed out = deformed(skin, pose, skinning);
        for (size_t v = 0; v < skin.vertex_count(); ++v) {
            const float *p = &skin.positions[3 * v], *n = &skin.normals[3 * v], *turned = &out.normals[3 * v];
            expect_near(out.at(v), {5.0 - p[1], -7.0 + p[0], 11.0 + p[2]}, 2e-6);
            expect_near({turned[0], turned[1], turned[2]}, {-n[1], n[0], n[2]}, 1e-6);
        }
    }
}

// A joint turns what hangs on it about its own place, in the frame of its parent; bones keep their lengths.
TEST(Poses, JointsTurnAboutTheirPlacesInTheirParentsFrames) {
    TestSkin skin = bar();
    std::vector<float> rotations = no_turns(4);
    turn(rotations, 1, about({0, 0, 1}, 0.5f * pi));
    turn(rotations, 2, about({1, 0, 0}, 0.5f * pi));  // about the bone, wherever that points by now
    turn(rotations, 3, about({0, 0, 1}, 0.5f * pi));
    const Pose pose = pose_of(skin, rotations);
    const auto joint_at = [&](size_t joint, const Point& rest) { return by_matrix(&pose.matrices[12 * joint], rest); };
    expect_near(joint_at(0, {0, 0, 0}), {0, 0, 0}, 1e-6);
    expect_near(joint_at(1, {2, 0, 0}), {1, 1, 0}, 1e-6);
    expect_near(joint_at(2, {3, 0, 0}), {1, 2, 0}, 1e-6);
    // After the turn of joint 2 about the bone (+y by now) its z is +x: joint 3 bends from +y to +z.
    expect_near(joint_at(3, {4, 0, 0}), {1, 2, 1}, 1e-6);
}

TEST(Poses, MatricesAndDualQuaternionsAreTheSameMotions) {
    TestSkin skin = cross();
    const float translation[] = {0.5f, 100, -3};
    for (uint32_t seed = 0; seed < 20; ++seed) {
        const Pose pose = pose_of(skin, random_rotations(skin.joint_count(), seed), translation);
        for (size_t j = 0; j < skin.joint_count(); ++j) {
            const Point p = {0.3 * seed, -2, 1};
            expect_near(by_matrix(&pose.matrices[12 * j], p), by_dual(&pose.duals[8 * j], p), 4e-5);
            double length = 0;
            for (size_t k = 0; k < 4; ++k) length += double{pose.duals[8 * j + k]} * pose.duals[8 * j + k];
            EXPECT_NEAR(length, 1, 1e-6);
        }
        for (size_t j = 1; j < skin.joint_count(); ++j) {
            const auto place = [&](size_t joint, size_t of) {
                const float* p = &skin.joint_positions[3 * of];
                return by_matrix(&pose.matrices[12 * joint], {p[0], p[1], p[2]});
            };
            // A joint is where its parent takes it.
            expect_near(place(j, j), place(skin.parents[j], j), 4e-5);
        }
    }
}

// Vertices of one joint alone go with it.
TEST(Poses, OneJointIsRigid) {
    TestSkin skin = bar(9, 8);
    std::fill(skin.joints.begin(), skin.joints.end(), uint16_t{0});
    for (size_t i = 0; i < skin.weights.size(); ++i) skin.weights[i] = i % 4 == 0;
    skin.parents = {FLG_NO_INDEX};
    skin.names = {"all"};
    skin.joint_positions = {0.5f, 0.25f, -1};
    const Pose pose = pose_of(skin, random_rotations(1, 7));
    for (const FlgSkinning skinning : {FLG_SKINNING_LINEAR, FLG_SKINNING_DUAL_QUATERNION}) {
        const Deformed out = deformed(skin, pose, skinning);
        for (size_t v = 0; v < skin.vertex_count(); ++v) {
            const float* p = &skin.positions[3 * v];
            expect_near(out.at(v), by_matrix(pose.matrices.data(), {p[0], p[1], p[2]}), 1e-5);
        }
    }
}

// Half a turn of joint 2: linear blending of weights 1/2 and 1/2 makes the girth cos(angle / 2) times as large, and
// that of a to 1 - a is |a + (1 - a) e^(i angle)|; dual quaternions keep it.
TEST(Poses, ATwistedBarIsThinByLinearBlendingOnly) {
    TestSkin skin = bar();
    for (const float angle : {0.5f, 1.5f, 2.5f, 3.1f}) {
        std::vector<float> rotations = no_turns(4);
        turn(rotations, 2, about({1, 0, 0}, angle));
        const Pose pose = pose_of(skin, rotations);
        const Deformed linear = deformed(skin, pose, FLG_SKINNING_LINEAR);
        const Deformed dual = deformed(skin, pose, FLG_SKINNING_DUAL_QUATERNION);
        uint32_t middle_count = 0;
        for (size_t v = 0; v + 2 < skin.vertex_count(); ++v) {  // the last two are the ends' middles
            const double x = skin.positions[3 * v];
            const double share = std::clamp(x - 1.5, 0.0, 1.0);  // of joint 2
            const double girth =
                std::hypot(1 - share + share * std::cos(double{angle}), share * std::sin(double{angle}));
            EXPECT_NEAR(distance_from_axis(linear.at(v)), girth * bar_radius, 1e-6) << x;
            EXPECT_NEAR(distance_from_axis(dual.at(v)), bar_radius, 1e-6) << x;
            EXPECT_NEAR(dual.at(v)[0], x, 1e-6);
            if (x != 2.0) continue;
            EXPECT_NEAR(distance_from_axis(linear.at(v)), std::cos(0.5 * angle) * bar_radius, 1e-6);
            ++middle_count;
        }
        EXPECT_EQ(middle_count, 16u);
    }
}

// A quaternion and its opposite are one rotation: no bit of the pose's shape may depend on the choice.
TEST(Poses, OppositeQuaternionsAreTheSame) {
    TestSkin skin = bar();
    std::vector<float> rotations = no_turns(4);
    turn(rotations, 1, about({0, 0, 1}, 0.7f));
    turn(rotations, 2, about({1, 0, 0}, 2.0f));
    const Deformed plain = deformed(skin, pose_of(skin, rotations), FLG_SKINNING_DUAL_QUATERNION);
    for (size_t joint = 0; joint < 4; ++joint) {
        std::vector<float> opposite = rotations;
        for (size_t k = 0; k < 4; ++k) opposite[4 * joint + k] *= -1;
        const Deformed other = deformed(skin, pose_of(skin, opposite), FLG_SKINNING_DUAL_QUATERNION);
        for (size_t i = 0; i < plain.positions.size(); ++i) {
            ASSERT_NEAR(plain.positions[i], other.positions[i], 1e-6);
            ASSERT_NEAR(plain.normals[i], other.normals[i], 1e-6);
        }
    }
}

// Turned as the surface is: normals across the edges of bent triangles, of length 1.
TEST(Poses, NormalsFollow) {
    TestSkin skin = bar(65, 24);
    std::vector<float> rotations = no_turns(4);
    for (uint32_t j = 1; j < 4; ++j) turn(rotations, j, about({0, 0, 1}, 0.4f));
    const Pose pose = pose_of(skin, rotations);
    for (const FlgSkinning skinning : {FLG_SKINNING_LINEAR, FLG_SKINNING_DUAL_QUATERNION}) {
        const Deformed out = deformed(skin, pose, skinning);
        double agreement = 0, count = 0;
        for (size_t t = 0; t < skin.triangles.size(); t += 3) {
            const uint32_t* c = &skin.triangles[t];
            if (std::max({c[0], c[1], c[2]}) >= skin.vertex_count() - 2) continue;  // the flat ends
            const Point a = out.at(c[0]), b = out.at(c[1]), d = out.at(c[2]);
            const Point u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v = {d[0] - a[0], d[1] - a[1], d[2] - a[2]};
            const Point n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
            const float* given = &out.normals[3 * size_t{c[0]}];
            EXPECT_NEAR(std::hypot(given[0], given[1], given[2]), 1, 1e-6);
            agreement += (n[0] * given[0] + n[1] * given[1] + n[2] * given[2]) / std::hypot(n[0], n[1], n[2]);
            ++count;
        }
        EXPECT_GT(agreement / count, 0.98);
    }
}

TEST(Poses, LargeSkinsAndLongChains) {
    TestSkin skin;
    for (uint32_t j = 0; j < 65535; ++j) skin.add_joint(static_cast<float>(j), 0, 0, j == 0 ? FLG_NO_INDEX : j - 1, "");
    // A polygon of 65534 sides: the chain closes.
    std::vector<float> rotations = no_turns(65535);
    for (uint32_t j = 1; j < 65535; ++j) turn(rotations, j, about({0, 0, 1}, 2 * pi / 65534));
    const Pose pose = pose_of(skin, rotations);
    const Point end = by_matrix(&pose.matrices[12 * 65534], {65534, 0, 0});
    // Angles in float are wrong by 1e-7 of a turn each; their sum shows.
    EXPECT_LT(std::hypot(end[0], end[1]), 100);
    EXPECT_EQ(end[2], 0);
}

TEST(Animations, KeysAreHitAndTurnsAreEven) {
    const TestAnimation animation = curl(4);
    const FlgSkinAnimation view = animation.view();
    std::vector<float> rotations(16);
    float translation[3] = {1, 1, 1};
    for (size_t key = 0; key < 3; ++key) {
        ASSERT_EQ(flgSkinAnimationSample(&view, 4, animation.times[key], rotations.data(), translation), FLG_OK);
        for (size_t i = 0; i < 16; ++i) EXPECT_NEAR(rotations[i], animation.rotations[16 * key + i], 1e-7);
    }
    EXPECT_EQ(translation[0], 0);
    for (const float time : {0.25f, 0.5f, 1.75f}) {
        ASSERT_EQ(flgSkinAnimationSample(&view, 4, time, rotations.data(), nullptr), FLG_OK);
        EXPECT_NEAR(2 * std::atan2(rotations[4 + 2], rotations[4 + 3]), 0.45 * time, 1e-6);
    }
    // Before and after, it stays.
    ASSERT_EQ(flgSkinAnimationSample(&view, 4, -3, rotations.data(), nullptr), FLG_OK);
    EXPECT_NEAR(rotations[4 + 3], 1, 1e-7);
    ASSERT_EQ(flgSkinAnimationSample(&view, 4, 99, rotations.data(), nullptr), FLG_OK);
    EXPECT_NEAR(2 * std::atan2(rotations[4 + 2], rotations[4 + 3]), 0.9, 1e-6);
}

TEST(Animations, TheShortWayIsTaken) {
    TestAnimation animation{"", {}, {}, {}};
    std::vector<float> to = no_turns(1);
    turn(to, 0, about({0, 1, 0}, 1.0f));
    for (float& c : to) c = -c;
    animation.add_key(0, no_turns(1));
    animation.add_key(1, to);
    animation.translations = {0, 0, 0, 1, 2, 4};
    const FlgSkinAnimation view = animation.view();
    float q[4], t[3];
    ASSERT_EQ(flgSkinAnimationSample(&view, 1, 0.5f, q, t), FLG_OK);
    EXPECT_NEAR(q[1], std::sin(0.25), 1e-6);
    EXPECT_NEAR(q[3], std::cos(0.25), 1e-6);
    EXPECT_EQ(t[0], 0.5f);
    EXPECT_EQ(t[2], 2.0f);
    // Equal keys, and opposite ones, are no division by zero.
    animation.rotations = {0, 0, 0, 1, 0, 0, 0, -1};
    const FlgSkinAnimation still = animation.view();
    ASSERT_EQ(flgSkinAnimationSample(&still, 1, 0.5f, q, nullptr), FLG_OK);
    EXPECT_EQ(q[3], 1);
}

class PoseRefusals : public ::testing::Test {
protected:
    // The sentence of a pose of a changed skin; nothing may be written.
    std::string pose(const std::function<void(FlgSkinView&)>& change, const float* rotations = nullptr,
                     const float* translation = nullptr) {
        FlgSkinView view = skin_.view();
        change(view);
        float matrices[48];
        std::fill_n(matrices, 48, 77.0f);
        EXPECT_EQ(flgSkinPose(&view, rotations, translation, matrices, nullptr), FLG_ERROR_INVALID_ARGUMENT);
        for (const float value : matrices) EXPECT_EQ(value, 77.0f);
        return flgErrorGetMessage();
    }
    std::string deform(const std::function<void(FlgSkinView&)>& change) {
        FlgSkinView view = skin_.view();
        change(view);
        std::vector<float> out(skin_.positions.size(), 77);
        const std::vector<float> matrices(48, 0.5f);
        EXPECT_EQ(flgSkinDeform(&view, FLG_SKINNING_LINEAR, matrices.data(), out.data(), nullptr),
                  FLG_ERROR_INVALID_ARGUMENT);
        for (const float value : out) EXPECT_EQ(value, 77.0f);
        return flgErrorGetMessage();
    }
    std::string sample(const std::function<void(FlgSkinAnimation&)>& change, float time = 0.5f,
                       uint32_t joint_count = 4) {
        FlgSkinAnimation view = animation_.view();
        change(view);
        float out[16];
        std::fill_n(out, 16, 77.0f);
        EXPECT_EQ(flgSkinAnimationSample(&view, joint_count, time, out, nullptr), FLG_ERROR_INVALID_ARGUMENT);
        for (const float value : out) EXPECT_EQ(value, 77.0f);
        return flgErrorGetMessage();
    }
    static void none(FlgSkinView&) {}
    static void no_change(FlgSkinAnimation&) {}

    TestSkin skin_ = bar();
    TestAnimation animation_ = curl(4);
};

using View = FlgSkinView;
using Animation = FlgSkinAnimation;

TEST_F(PoseRefusals, Joints) {
    EXPECT_NE(pose([](View& v) { v.struct_size = 8; }).find("skin: struct_size is 8"), std::string::npos);
    EXPECT_EQ(pose([](View& v) { v.joint_count = 0; }), "skin.joint_count is 0, must be 1 to 65535");
    EXPECT_EQ(pose([](View& v) { v.joint_count = 65536; }), "skin.joint_count is 65536, must be 1 to 65535");
    EXPECT_EQ(pose([](View& v) { v.joint_positions = nullptr; }), "skin.joint_positions is null");
    EXPECT_EQ(pose([](View& v) { v.joint_parents = nullptr; }), "skin.joint_parents is null");
    skin_.parents[2] = 2;
    EXPECT_EQ(pose(none), "skin.joint_parents[2] is 2, must be lower than the joint, or FLG_NO_INDEX");
    skin_.parents[2] = 3;
    EXPECT_EQ(pose(none), "skin.joint_parents[2] is 3, must be lower than the joint, or FLG_NO_INDEX");
    skin_.parents[2] = 1;
    skin_.joint_positions[7] = NAN;
    EXPECT_EQ(pose(none), "skin.joint_positions[7] is nan, must be finite and at most 1e30 in size");
}

TEST_F(PoseRefusals, RotationsAndTranslation) {
    std::vector<float> rotations = no_turns(4);
    rotations[4 + 3] = 1.01f;
    EXPECT_EQ(pose(none, rotations.data()), "rotations[4]: the quaternion (0, 0, 0, 1.01) is 1.01 long, must be 1");
    rotations[4 + 3] = 0;
    EXPECT_EQ(pose(none, rotations.data()), "rotations[4]: the quaternion (0, 0, 0, 0) is 0 long, must be 1");
    rotations[4 + 3] = NAN;
    EXPECT_EQ(pose(none, rotations.data()), "rotations[4]: the quaternion (0, 0, 0, nan) is nan long, must be 1");
    const float far[] = {0, INFINITY, 0};
    EXPECT_EQ(pose(none, nullptr, far), "translation[1] is inf, must be finite and at most 1e30 in size");
    const View view = skin_.view();
    EXPECT_EQ(flgSkinPose(&view, nullptr, nullptr, nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgErrorGetMessage(), "out_matrices and out_dual_quaternions are both null");
    EXPECT_EQ(flgSkinPose(nullptr, nullptr, nullptr, nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgErrorGetMessage(), "skin is null");
}

TEST_F(PoseRefusals, Vertices) {
    EXPECT_EQ(deform([](View& v) { v.vertex_count = 0; }), "skin.vertex_count is 0, must be at least 1");
    EXPECT_EQ(deform([](View& v) { v.positions = nullptr; }), "skin.positions is null");
    EXPECT_EQ(deform([](View& v) { v.vertex_joints = nullptr; }), "skin.vertex_joints is null");
    EXPECT_EQ(deform([](View& v) { v.vertex_weights = nullptr; }), "skin.vertex_weights is null");
    const TestSkin sound = skin_;
    skin_.joints[9] = 4;
    EXPECT_EQ(deform(none), "skin.vertex_joints[9] is 4, but there are 4 joints");
    skin_ = sound;
    skin_.weights[4] = -0.5f;
    EXPECT_EQ(deform(none), "skin.vertex_weights[4] is -0.5, must be 0 to 1");
    skin_.weights[4] = NAN;
    EXPECT_EQ(deform(none), "skin.vertex_weights[4] is nan, must be 0 to 1");
    skin_ = sound;
    skin_.weights[4] = 0.5f;
    EXPECT_EQ(deform(none), "skin.vertex_weights: those of vertex 1 sum up to 0.5, must be 1");
    skin_.weights[4] = 0.25f;
    skin_.weights[6] = 0.75f;
    EXPECT_EQ(deform(none), "skin.vertex_weights[6] is 0.75 after 0.25: a vertex' largest weight must be its first");
    skin_ = sound;
    skin_.positions[5] = -INFINITY;
    EXPECT_EQ(deform(none), "skin.positions[5] is -inf, must be finite and at most 1e30 in size");
}

TEST_F(PoseRefusals, Transforms) {
    const View view = skin_.view();
    std::vector<float> out(skin_.positions.size()), transforms(48);
    const auto refusal = [&](int32_t skinning, const float* values) {
        EXPECT_EQ(flgSkinDeform(&view, static_cast<FlgSkinning>(skinning), values, out.data(), nullptr),
                  FLG_ERROR_INVALID_ARGUMENT);
        return std::string(flgErrorGetMessage());
    };
    EXPECT_EQ(refusal(2, transforms.data()), "skinning is 2, must be one of FLG_SKINNING_...");
    EXPECT_EQ(refusal(FLG_SKINNING_LINEAR, nullptr), "transforms is null");
    // Matrices where dual quaternions are meant, or nothing at all.
    EXPECT_EQ(refusal(FLG_SKINNING_DUAL_QUATERNION, transforms.data()),
              "transforms[0]: the quaternion (0, 0, 0, 0) is 0 long, must be 1");
    transforms[13] = NAN;
    EXPECT_EQ(refusal(FLG_SKINNING_LINEAR, transforms.data()),
              "transforms[13] is nan, must be finite and at most 1e30 in size");
    EXPECT_EQ(flgSkinDeform(&view, FLG_SKINNING_LINEAR, std::vector<float>(48).data(), nullptr, nullptr),
              FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgErrorGetMessage(), "out_positions is null");
    View without = view;
    without.normals = nullptr;
    std::vector<float> normals(out.size());
    const std::vector<float> zeros(48);
    EXPECT_EQ(flgSkinDeform(&without, FLG_SKINNING_LINEAR, zeros.data(), out.data(), normals.data()),
              FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgErrorGetMessage(), "skin.normals is null");
}

TEST_F(PoseRefusals, Animations) {
    EXPECT_NE(sample([](Animation& a) { a.struct_size = 8; }).find("animation: struct_size is 8"), std::string::npos);
    EXPECT_EQ(sample([](Animation& a) { a.key_count = 0; }), "animation.key_count is 0, must be at least 1");
    EXPECT_EQ(sample([](Animation& a) { a.times = nullptr; }), "animation.times is null");
    EXPECT_EQ(sample([](Animation& a) { a.rotations = nullptr; }), "animation.rotations is null");
    EXPECT_EQ(sample(no_change, NAN), "time is nan, must be finite and at most 1e30 in size");
    EXPECT_EQ(sample(no_change, 0, 0), "joint_count is 0, must be 1 to 65535");
    animation_.rotations[7] = 3;
    EXPECT_EQ(sample(no_change), "animation.rotations[4]: the quaternion (0, 0, 0, 3) is 3 long, must be 1");
    animation_ = curl(4);
    animation_.translations = {0, 0, 0, 0, NAN, 0, 0, 0, 0};
    EXPECT_EQ(sample(no_change), "animation.translations[4] is nan, must be finite and at most 1e30 in size");
    for (const float bad : {-1.0f, 0.0f, NAN, INFINITY}) {
        animation_ = curl(4);
        animation_.times[1] = bad;
        EXPECT_NE(sample(no_change).find("animation.times[1] is"), std::string::npos);
    }
}

}  // namespace
}  // namespace flg::test
