// SPDX-License-Identifier: MIT
// Skins of other programs, by what the format says of them; and files that can't be right.
#include <algorithm>
#include <array>
#include <cmath>

#include "io/gltf_files.h"
#include "io/skin_files.h"
#include "io/tinygltf_model.h"

namespace flg::test {
namespace {

using Matrix = std::array<double, 16>;  // column by column

Matrix multiply(const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (size_t column = 0; column < 4; ++column)
        for (size_t row = 0; row < 4; ++row)
            for (size_t k = 0; k < 4; ++k) c[4 * column + row] += a[4 * k + row] * b[4 * column + k];
    return c;
}

Matrix matrix_of(const tinygltf::Node& node) {
    const auto part = [](const std::vector<double>& values, std::vector<double> otherwise) {
        return values.empty() ? otherwise : values;
    };
    const std::vector<double> t = part(node.translation, {0, 0, 0}), r = part(node.rotation, {0, 0, 0, 1});
    const double x = r[0], y = r[1], z = r[2], w = r[3];
    const Matrix turn = {1 - 2 * (y * y + z * z),
                         2 * (x * y + z * w),
                         2 * (x * z - y * w),
                         0,
                         2 * (x * y - z * w),
                         1 - 2 * (x * x + z * z),
                         2 * (y * z + x * w),
                         0,
                         2 * (x * z + y * w),
                         2 * (y * z - x * w),
                         1 - 2 * (x * x + y * y),
                         0,
                         t[0],
                         t[1],
                         t[2],
                         1};
    const std::vector<double> s = part(node.scale, {1, 1, 1});
    const Matrix size = {s[0], 0, 0, 0, 0, s[1], 0, 0, 0, 0, s[2], 0, 0, 0, 0, 1};
    return multiply(turn, size);
}

// Where the format says that vertices are, with the nodes turned as their key 1 says.
std::vector<double> literal_positions(tinygltf::Model model) {
    for (const tinygltf::AnimationChannel& channel : model.animations.at(0).channels) {
        const std::vector<float> values =
            values_of<float>(model, model.animations[0].samplers[static_cast<size_t>(channel.sampler)].output);
        const std::vector<double> value(values.begin() + (channel.target_path == "rotation" ? 4 : 3),
                                        values.begin() + (channel.target_path == "rotation" ? 8 : 6));
        tinygltf::Node& node = model.nodes[static_cast<size_t>(channel.target_node)];
        (channel.target_path == "rotation" ? node.rotation : node.translation) = value;
    }
    std::vector<Matrix> global(model.nodes.size());
    const std::function<void(int, const Matrix&)> walk = [&](int index, const Matrix& parent) {
        const auto node = static_cast<size_t>(index);
        global[node] = multiply(parent, matrix_of(model.nodes[node]));
        for (const int child : model.nodes[node].children) walk(child, global[node]);
    };
    const Matrix identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    for (const int root : model.scenes[0].nodes) walk(root, identity);
    const auto& attributes = model.meshes[0].primitives[0].attributes;
    const std::vector<float> points = values_of<float>(model, attributes.at("POSITION"));
    const std::vector<float> weights = values_of<float>(model, attributes.at("WEIGHTS_0"));
    const std::vector<uint16_t> joints = values_of<uint16_t>(model, attributes.at("JOINTS_0"));
    const std::vector<float> bind = values_of<float>(model, model.skins[0].inverseBindMatrices);
    std::vector<double> placed(points.size());
    for (size_t v = 0; v < points.size() / 3; ++v) {
        for (size_t k = 0; k < 4; ++k) {
            const size_t joint = joints[4 * v + k];
            Matrix inverse_bind;
            std::copy_n(bind.begin() + static_cast<std::ptrdiff_t>(16 * joint), 16, inverse_bind.begin());
            const Matrix m = multiply(global[static_cast<size_t>(model.skins[0].joints[joint])], inverse_bind);
            for (size_t row = 0; row < 3; ++row) {
                double value = m[12 + row];
                for (size_t i = 0; i < 3; ++i) value += m[4 * i + row] * points[3 * v + i];
                placed[3 * v + row] += weights[4 * v + k] * value;
            }
        }
    }
    return placed;
}

// Vertices of the pose at the second key by the mean of what the joints do, without flgSkin..., which are in another
// library.
std::vector<double> posed(const TestSkin& skin, const TestAnimation& animation, size_t key) {
    std::vector<Matrix> motions(skin.joint_count());
    for (size_t j = 0; j < motions.size(); ++j) {
        tinygltf::Node turn, back;
        const float* p = &skin.joint_positions[3 * j];
        const float* q = &animation.rotations[4 * (key * motions.size() + j)];
        turn.rotation = {q[0], q[1], q[2], q[3]};
        turn.translation = {p[0], p[1], p[2]};
        back.translation = {-p[0], -p[1], -p[2]};
        Matrix motion = multiply(matrix_of(turn), matrix_of(back));
        if (skin.parents[j] != FLG_NO_INDEX) {
            motion = multiply(motions[skin.parents[j]], motion);
        } else if (!animation.translations.empty()) {
            for (size_t k = 0; k < 3; ++k) motion[12 + k] += animation.translations[3 * key + k];
        }
        motions[j] = motion;
    }
    std::vector<double> placed(skin.positions.size());
    for (size_t v = 0; v < placed.size() / 3; ++v)
        for (size_t k = 0; k < 4; ++k)
            for (size_t row = 0; row < 3; ++row) {
                const Matrix& m = motions[skin.joints[4 * v + k]];
                double value = m[12 + row];
                for (size_t i = 0; i < 3; ++i) value += m[4 * i + row] * skin.positions[3 * v + i];
                placed[3 * v + row] += skin.weights[4 * v + k] * value;
            }
    return placed;
}

class ForeignSkin : public ::testing::Test {
protected:
    ForeignSkin() {
        TestSkin skin = bar(9, 8);
        TestAnimation animation = curl(4);
        turn_root(animation);
        EXPECT_EQ(write_skin(folder_.at("own.glb"), skin, {animation}), FLG_OK) << flgIoErrorGetMessage();
        own_ = slurp(folder_.at("own.glb"));
    }
    static void turn_root(TestAnimation& animation) {
        for (size_t key = 0; key < 3; ++key) {
            const Quat q = about({0, 0.6f, 0.8f}, 0.4f * static_cast<float>(key));
            std::copy_n(&q.x, 4, animation.rotations.begin() + static_cast<std::ptrdiff_t>(16 * key));
        }
        animation.translations = {0, 0, 0, 1, 2, 3, 0, 0, 0};
    }
    // Each vertex moves as the format says it does.
    void expect_moves_as_the_format_says(const Glb& glb) {
        const std::string path = folder_.put("foreign.glb", glb.bytes());
        const ReadSkin read = read_skin(path);
        ASSERT_EQ(read.result, FLG_OK) << read.error;
        ASSERT_EQ(read.animations.size(), 1u);
        const auto key = std::find(read.animations[0].times.begin(), read.animations[0].times.end(), 1.0f);
        ASSERT_NE(key, read.animations[0].times.end());
        const std::vector<double> is =
            posed(read.skin, read.animations[0], static_cast<size_t>(key - read.animations[0].times.begin()));
        const std::vector<double> should = literal_positions(load_model(path));
        ASSERT_EQ(is.size(), should.size());
        double largest = 0;
        for (size_t i = 0; i < is.size(); ++i) {
            EXPECT_NEAR(is[i], should[i], 1e-5) << i;
            largest = std::max(largest, std::abs(is[i] - read.skin.positions[i]));
        }
        EXPECT_GT(largest, 0.5);  // it did move
    }
    const Folder folder_;
    std::string own_;
};

TEST_F(ForeignSkin, OwnFilesMoveAsTheFormatSays) {
    expect_moves_as_the_format_says(Glb(own_));
}

// Joints that are turned at rest: nodes with rotations, and bind matrices that undo them.
TEST_F(ForeignSkin, TurnedJointsAreBaked) {
    Glb glb(own_);
    // Node of joint 1 turned by a right angle about z: the next one is 1 m along its -y. Its own matrix undoes the
    // turn.
    glb.replace(R"("name":"bar 1","translation":[1,0,0])",
                R"("name":"bar 1","translation":[1,0,0],"rotation":[0,0,0.7071067811865476,0.7071067811865476])");
    glb.replace(R"("name":"bar 2","translation":[1,0,0])",
                R"("name":"bar 2","translation":[0,-1,0],"rotation":[0,0,-0.7071067811865476,0.7071067811865476])");
    const float turned[] = {0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1};  // Rz(-90) after a move by -1 along x
    for (size_t k = 0; k < 16; ++k) glb.put(glb.binary.size() - 3 * 64 + 4 * k, turned[k]);
    expect_moves_as_the_format_says(glb);
    const ReadSkin read = read_skin(folder_.at("foreign.glb"));
    EXPECT_EQ(read.skin.joint_positions, bar().joint_positions);
}

// Nodes above the joints place the whole, here upright and a hundredth of the size; they may be turned in an animation.
TEST_F(ForeignSkin, NodesAboveTheJointsPlaceTheWhole) {
    Glb glb(own_);
    glb.replace(R"("name":"model skeleton",)",
                R"("name":"model skeleton","translation":[0,5,0],"scale":[2,2,2],"rotation":[0.6,0,0,0.8],)");
    expect_moves_as_the_format_says(glb);
}

TEST_F(ForeignSkin, ChildrenMayComeBeforeTheirParents) {
    Glb glb(own_);
    glb.replace(R"("joints":[2,3,4,5])", R"("joints":[5,4,3,2])");
    // As many vertices as before, now named by the other numbers: 0 is what was 3.
    const size_t vertices = bar(9, 8).vertex_count();
    const TestSkin plain = bar(9, 8);
    for (size_t i = 0; i < 4 * vertices; ++i)
        glb.put(24 * vertices + 2 * i, static_cast<uint16_t>(3 - plain.joints[i]));
    const size_t bind = glb.binary.size() - 4 * 64;
    for (size_t j = 0; j < 4; ++j) glb.put(bind + 64 * j + 48, -static_cast<float>(3 - j));
    expect_moves_as_the_format_says(glb);
    const ReadSkin read = read_skin(folder_.at("foreign.glb"));
    EXPECT_EQ(read.skin.parents, (std::vector<uint32_t>{FLG_NO_INDEX, 0, 1, 2}));
    EXPECT_EQ(read.skin.names, (std::vector<std::string>{"bar 0", "bar 1", "bar 2", "bar 3"}));
}

// Bytes for joints, and for weights whose sum they can't hold exactly.
TEST_F(ForeignSkin, BytesAreRead) {
    Glb glb(own_);
    const size_t count = bar(9, 8).vertex_count();
    glb.replace(R"("componentType":5123)", R"("componentType":5121)");
    const size_t weights = glb.json.find(R"("bufferView":3)");
    ASSERT_NE(weights, std::string::npos);
    const size_t type = glb.json.find("5126", weights);
    glb.json.replace(type, 4, R"(5121,"normalized":true)");
    for (size_t v = 0; v < count; ++v) {
        const uint8_t joints[] = {1, 2, 3, 0}, shares[] = {100, 128, 28, 0};  // 256 of 255
        for (size_t k = 0; k < 4; ++k)
            glb.put(24 * count + 8 * v + k, joints[k]).put(32 * count + 16 * v + k, shares[k]);
    }
    const ReadSkin read = read_skin(folder_.put("a.glb", glb.bytes()));
    ASSERT_EQ(read.result, FLG_OK) << read.error;
    for (size_t v = 0; v < count; ++v) {
        EXPECT_EQ(std::vector<uint16_t>(&read.skin.joints[4 * v], &read.skin.joints[4 * v] + 4),
                  (std::vector<uint16_t>{2, 1, 3, 0}));
        EXPECT_FLOAT_EQ(read.skin.weights[4 * v], 0.5f);
        EXPECT_FLOAT_EQ(read.skin.weights[4 * v + 2], 28.0f / 256.0f);
    }
}

// Joint 1 has keys at 1 and 2 s alone: it stays as at 1 s before. All joints get keys at all times.
TEST_F(ForeignSkin, KeysAreBroughtTogether) {
    Glb glb(own_);
    glb.replace(R"(],"bufferViews":[)",
                R"(,{"bufferView":6,"byteOffset":4,"componentType":5126,"count":2,"type":"SCALAR",)"
                R"("min":[1],"max":[2]},{"bufferView":8,"byteOffset":16,"componentType":5126,)"
                R"("count":2,"type":"VEC4"}],"bufferViews":[)");
    glb.replace(R"({"input":6,"output":8})", R"({"input":13,"output":14})");
    const ReadSkin own = read_skin(folder_.at("own.glb")), read = read_skin(folder_.put("a.glb", glb.bytes()));
    ASSERT_EQ(read.result, FLG_OK) << read.error;
    const TestAnimation &a = own.animations.at(0), &b = read.animations.at(0);
    EXPECT_EQ(b.times, a.times);
    for (size_t key = 0; key < 3; ++key) {
        for (size_t joint = 0; joint < 4; ++joint) {
            const size_t from = key == 0 && joint == 1 ? 1 : key;
            for (size_t k = 0; k < 4; ++k)
                EXPECT_NEAR(b.rotations[16 * key + 4 * joint + k], a.rotations[16 * from + 4 * joint + k], 1e-6);
        }
    }
    expect_moves_as_the_format_says(Glb(own_));
}

TEST_F(ForeignSkin, FilesWithoutASkinAreNoError) {
    const ReadSkin read = read_skin(folder_.put("a.gltf", Document{}.text()));
    EXPECT_EQ(read.result, FLG_OK) << read.error;
    EXPECT_FALSE(read.has_skin);
    Glb glb(own_);
    glb.replace(R"("nodes":[0,1])", R"("nodes":[1])");  // not shown
    EXPECT_FALSE(read_skin(folder_.put("b.glb", glb.bytes())).has_skin);
    EXPECT_EQ(read_skin(folder_.put("a.obj", "v 0 0 0\n")).result, FLG_ERROR_FORMAT);
    EXPECT_EQ(read_skin(folder_.at("nosuch.glb")).result, FLG_ERROR_FILE);
    FlgSkinFile file = nullptr;
    EXPECT_EQ(flgSkinFileRead(nullptr, nullptr, &file), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(flgSkinFileRead("a", nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    flgSkinFileRelease(nullptr);
}

TEST_F(ForeignSkin, NormalsAreMadeAndWeightsSorted) {
    Glb glb(own_);
    glb.replace(R"("NORMAL":1,)", "");
    const size_t weights = 32 * size_t{bar(9, 8).vertex_count()}, joints = 24 * size_t{bar(9, 8).vertex_count()};
    const float given[] = {0.125f, 0.25f, 0.375f, 0.25f};
    const uint16_t named[] = {1, 2, 3, 2};
    for (size_t k = 0; k < 4; ++k) glb.put(weights + 4 * k, given[k]).put(joints + 2 * k, named[k]);
    const ReadSkin read = read_skin(folder_.put("a.glb", glb.bytes()));
    ASSERT_EQ(read.result, FLG_OK) << read.error;
    EXPECT_EQ(std::vector<float>(read.skin.weights.begin(), read.skin.weights.begin() + 4),
              (std::vector<float>{0.5f, 0.375f, 0.125f, 0}));
    EXPECT_EQ(std::vector<uint16_t>(read.skin.joints.begin(), read.skin.joints.begin() + 4),
              (std::vector<uint16_t>{2, 3, 1, 0}));
    const TestSkin plain = bar(9, 8);
    for (size_t v = 16; v < 24; ++v)
        for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(read.skin.normals[3 * v + k], plain.normals[3 * v + k], 1e-5);
}

// ---- Files that can't be right, or say what no FlgSkinAnimation can

class BadSkin : public ForeignSkin {
protected:
    void refuse(Glb glb, const std::string& place, const std::string& reason, FlgResult result = FLG_ERROR_FORMAT) {
        const std::string path = folder_.put("bad.glb", glb.bytes());
        const ReadSkin read = read_skin(path);
        EXPECT_EQ(read.result, result) << read.error;
        EXPECT_FALSE(read.has_skin);
        EXPECT_EQ(read.error.rfind(path + ":" + place + ": ", 0), 0u) << read.error;
        EXPECT_NE(read.error.find(reason), std::string::npos) << read.error;
    }
    Glb own() const { return Glb(own_); }
    const size_t vertices_ = bar(9, 8).vertex_count();
};

TEST_F(BadSkin, Attributes) {
    const std::string attributes = "meshes[0].primitives[0].attributes";
    refuse(own().replace(R"("JOINTS_0":2,)", ""), attributes, "has no JOINTS_0");
    refuse(own().replace(R"("WEIGHTS_0":3,)", ""), attributes, "has no WEIGHTS_0");
    refuse(own().replace(R"("POSITION":0,)", ""), attributes, "has no POSITION");
    refuse(own().replace(R"("WEIGHTS_0":3)", R"("WEIGHTS_0":1)"), "accessors[1]", "not four floats");
    refuse(own().replace(R"("JOINTS_0":2)", R"("JOINTS_0":3)"), "accessors[3]", "not four bytes");
    refuse(own().replace(R"("JOINTS_0":2)", R"("JOINTS_0":99)"), attributes + ".JOINTS_0", "accessors 99");
    refuse(own().replace(R"("_PART":4)", R"("_PART":3)"), "accessors[3]", "not one number");
    refuse(own().put(48 * vertices_, 0.5f), "accessors[4]", "of part 0.5");
    refuse(own().put(48 * vertices_, -1.0f), "accessors[4]", "of part -1");
    const std::string one_less = std::to_string(vertices_ - 1);
    Glb fewer = own();
    const size_t at = fewer.json.find(R"("componentType":5123,"count":)") + 29;
    ASSERT_EQ(fewer.json.substr(at, one_less.size() + 1), std::to_string(vertices_) + ",");
    fewer.json.replace(at, std::to_string(vertices_).size(), one_less);
    refuse(fewer, "accessors[2].count", "is " + one_less + ", but there are " + std::to_string(vertices_));
}

TEST_F(BadSkin, Bindings) {
    refuse(own().put(24 * vertices_ + 8, uint16_t{4}), "accessors[2]", "vertex 1 names joint 4, but there are 4");
    refuse(own().put(32 * vertices_, NAN), "accessors[3]", "vertex 0 has the weight nan");
    refuse(own().put(32 * vertices_, -0.5f), "accessors[3]", "vertex 0 has the weight -0.5");
    refuse(own().put(32 * vertices_, 0.25f), "accessors[3]", "the weights of vertex 0 sum up to 0.25");
    refuse(own().put(0, INFINITY), "accessors[0]", "vertex 0 gives inf");
    refuse(own().put(12 * vertices_, NAN), "accessors[1]", "vertex 0 gives nan");
}

TEST_F(BadSkin, Nodes) {
    refuse(own().replace(R"("name":"bar 3",)", R"("name":"bar 3","children":[2],)"), "nodes[2]",
           "is a child of nodes[1] and of nodes[5]");
    refuse(own()
               .replace(R"("children":[2])", R"("children":[])")
               .replace(R"("name":"bar 3",)", R"("name":"bar 3","children":[2],)"),
           "nodes[2]", "is below itself");
    refuse(own().replace(R"("children":[2])", R"("children":[77])"), "nodes[1].children", "nodes 77 of 6");
    refuse(own().replace(R"("translation":[0,0,0])", R"("translation":[0,0])"), "nodes[2].translation",
           "must be 3 numbers");
}

TEST_F(BadSkin, Skins) {
    refuse(own().replace(R"("skin":0)", R"("skin":3)"), "skins[3]", "refers to skins 3 of 1");
    refuse(own().replace(R"("joints":[2,3,4,5])", R"("joints":[])"), "skins[0]", "has no joints");
    refuse(own().replace(R"("joints":[2,3,4,5])", R"("joints":[2,3,4])"), "accessors[2]",
           "names joint 3, but there are 3");
    refuse(own().replace(R"("joints":[2,3,4,5])", R"("joints":[2,3,4,4])"), "skins[0].joints[3]", "as joint 2 is");
    refuse(own().replace(R"("joints":[2,3,4,5])", R"("joints":[2,3,4,9])"), "skins[0].joints[3]", "nodes 9 of 6");
    refuse(own().replace(R"("joints":[2,3,4,5])", R"("joints":[2,3,4,5,0])"), "accessors[12].count",
           "is 4, but there are 5 joints");
    refuse(own().replace(R"("inverseBindMatrices":)", R"("inverseBindMatrices":1,"was":)"), "accessors[1].type",
           "is not MAT4");
    refuse(own().put(own().binary.size() - 64, NAN), "accessors[12]", "matrix of joint 3 is not finite");
    refuse(own().put(own().binary.size() - 64, 0.0f), "accessors[12]", "has no inverse");
}

TEST_F(BadSkin, Animations) {
    refuse(own().replace(R"("samplers":[{)", R"("samplers":[{"interpolation":"CUBICSPLINE",)"),
           "animations[0].samplers[0].interpolation", "only LINEAR is supported");
    refuse(own().replace(R"({"sampler":1,)", R"({"sampler":9,)"), "animations[0].channels[1].sampler",
           "is 9, but there are 5");
    refuse(own().replace(R"({"sampler":1,"target":{"node":3)", R"({"sampler":1,"target":{"node":2)"),
           "animations[0].channels[1]", "another channel moves");
    refuse(own().replace(R"("path":"rotation")", R"("path":"scale")"), "accessors[7]", "does not hold 3 floats a key");
    refuse(own().replace(R"("target":{"node":2)", R"("target":{"node":88)"), "animations[0].channels[0].target.node",
           "nodes 88 of 6");
    // The root's quaternions come behind the three times, which come behind the indices.
    const size_t times = 52 * vertices_ + 4 * bar(9, 8).triangles.size();
    refuse(own().put(times + 4, 0.0f), "accessors[6]", "time 1 is 0: times rise");
    refuse(own().put(times, -1.0f), "accessors[6]", "time 0 is -1");
    refuse(own().put(times, NAN), "accessors[6]", "time 0 is nan");
    refuse(own().put(times + 12 + 12, 2.0f), "accessors[7]", "quaternion of key 0 is 2 long");
    refuse(own().put(times + 12, NAN), "accessors[7]", "key 0 gives nan");
    // What a skin here can't do: bones that get longer, and larger joints.
    refuse(own().replace(R"("node":2,"path":"translation")", R"("node":4,"path":"translation")"), "animations[0]",
           "joint 'bar 2' leaves its parent");
    refuse(own().replace(R"("name":"bar 2",)", R"("name":"bar 2","scale":[1,2,1],)"), "animations[0]",
           "joint 'bar 2' is scaled");
}

TEST_F(BadSkin, RootsThatPart) {
    TestSkin skin = bar(9, 8);
    skin.parents[2] = FLG_NO_INDEX;
    TestAnimation animation = curl(4);
    turn_root(animation);
    ASSERT_EQ(write_skin(folder_.at("two.glb"), skin, {animation}), FLG_OK) << flgIoErrorGetMessage();
    Glb glb(slurp(folder_.at("two.glb")));
    // The second root's moves are the last before the bind matrices: three numbers a key.
    glb.put(glb.binary.size() - 4 * 64 - 24, 77.0f);
    refuse(glb, "animations[0]", "at 1 s joint 'bar 2' moves otherwise than the other roots");
}

}  // namespace
}  // namespace flg::test
