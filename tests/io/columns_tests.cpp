// SPDX-License-Identifier: MIT
// Curves with columns of all kinds, in text and in glTF.
#include <cmath>

#include "io/gltf_files.h"

namespace flg::test {
namespace {

constexpr FlgAttribute user_0 = FLG_ATTRIBUTE_USER;
constexpr FlgAttribute user_7 = static_cast<FlgAttribute>(FLG_ATTRIBUTE_USER + 7);

// Three curves, one of them closed and one of a single point, with values that no rule minds.
struct Rich {
    std::vector<uint32_t> offsets{0, 3, 7, 8};
    std::vector<uint8_t> flags{0, FLG_CURVE_CLOSED, 0};
    std::vector<FlgColumn> columns;
    std::vector<std::pair<FlgAttribute, Floats>> values;

    explicit Rich(const std::vector<std::pair<FlgAttribute, uint32_t>>& attributes) {
        for (const auto& [attribute, components] : attributes) {
            Floats column;
            for (uint32_t i = 0; i < 8 * components; ++i) {
                column.push_back(0.1f * static_cast<float>(attribute + 1) + 0.013f * static_cast<float>(i * i % 97));
            }
            values.emplace_back(attribute, std::move(column));
        }
        for (size_t k = 0; k < values.size(); ++k) {
            columns.push_back({values[k].first, attributes[k].second, values[k].second.data(), 0, 0});
        }
    }
    FlgCurveSetView view() const {
        FlgCurveSetView view = {};
        view.struct_size = sizeof view;
        view.curve_count = 3;
        view.curve_offsets = offsets.data();
        view.curve_flags = flags.data();
        view.columns = columns.data();
        view.column_count = static_cast<uint32_t>(columns.size());
        return view;
    }
};

FlgResult write_all(const std::string& path, const Rich& rich, uint32_t all_columns = 1) {
    FlgCurveFileWriteDesc desc;
    flgCurveFileWriteDescInit(&desc, sizeof desc);
    desc.all_columns = all_columns;
    const FlgCurveSetView view = rich.view();
    return flgCurveFileWrite(path.c_str(), &view, &desc);
}

void expect_same(const Read& again, const Rich& rich) {
    ASSERT_EQ(again.result, FLG_OK) << again.error;
    EXPECT_EQ(again.offsets, rich.offsets);
    EXPECT_EQ(again.flags, rich.flags);
    EXPECT_EQ(again.columns.size(), rich.values.size());
    for (const auto& [attribute, values] : rich.values) EXPECT_EQ(again.column(attribute), values) << attribute;
    EXPECT_EQ(again.warnings, "1 curve: of a single point (first: curve 2)\n");
}

TEST(CurveColumns, TextRoundTripsExactly) {
    const Folder folder;
    const Rich rich({{FLG_ATTRIBUTE_POSITION, 3},
                     {FLG_ATTRIBUTE_TANGENT, 3},
                     {FLG_ATTRIBUTE_NORMAL, 3},
                     {FLG_ATTRIBUTE_RADIUS, 1},
                     {FLG_ATTRIBUTE_COLOR, 4},
                     {FLG_ATTRIBUTE_ORIENTATION, 4},
                     {FLG_ATTRIBUTE_TIME, 1},
                     {FLG_ATTRIBUTE_PRESSURE, 1},
                     {FLG_ATTRIBUTE_STYLE_INDEX, 1},
                     {FLG_ATTRIBUTE_RADII, 3},
                     {FLG_ATTRIBUTE_ANGLE, 1},
                     {FLG_ATTRIBUTE_WIDTH, 1},
                     {FLG_ATTRIBUTE_SPEED, 1},
                     {FLG_ATTRIBUTE_DISPLACEMENT, 3},
                     {user_0, 1},
                     {user_7, 16}});
    ASSERT_EQ(write_all(folder.at("a.xyz"), rich), FLG_OK) << flgIoErrorGetMessage();
    expect_same(read(folder.at("a.xyz")), rich);
    // The radius is where readers that know nothing of columns look for it.
    EXPECT_EQ(slurp(folder.at("a.xyz")).rfind("# columns x y z radius tangent_0 tangent_1 tangent_2 nx ny nz red", 0),
              0u);
    // And without being asked for there are colours, and nothing else.
    ASSERT_EQ(write_all(folder.at("b.xyz"), rich, 0), FLG_OK);
    const Read plain = read(folder.at("b.xyz"));
    EXPECT_EQ(plain.columns.size(), 3u);
    EXPECT_EQ(plain.column(FLG_ATTRIBUTE_RADIUS), rich.values[3].second);
    EXPECT_EQ(plain.column(FLG_ATTRIBUTE_COLOR), rich.values[4].second);
}

TEST(CurveColumns, GltfRoundTripsExactly) {
    const Folder folder;
    Rich rich({{FLG_ATTRIBUTE_POSITION, 3},
               {FLG_ATTRIBUTE_RADIUS, 1},
               {FLG_ATTRIBUTE_TIME, 1},
               {FLG_ATTRIBUTE_PRESSURE, 1},
               {FLG_ATTRIBUTE_STYLE_INDEX, 1},
               {FLG_ATTRIBUTE_RADII, 3},
               {FLG_ATTRIBUTE_ANGLE, 1},
               {FLG_ATTRIBUTE_WIDTH, 1},
               {FLG_ATTRIBUTE_SPEED, 1},
               {FLG_ATTRIBUTE_DISPLACEMENT, 3},
               {FLG_ATTRIBUTE_NORMAL, 3},
               {user_0, 2},
               {user_7, 4}});
    for (size_t i = 0; i < 24; ++i) rich.values[10].second[i] = i % 3 == i / 8 ? 1.0f : 0.0f;
    ASSERT_EQ(write_all(folder.at("a.glb"), rich), FLG_OK) << flgIoErrorGetMessage();
    expect_same(read(folder.at("a.glb")), rich);
    ASSERT_EQ(write_all(folder.at("b.glb"), rich, 0), FLG_OK);
    EXPECT_EQ(read(folder.at("b.glb")).columns.size(), 2u);

    ASSERT_EQ(write_all(folder.at("c.glb"), Rich({{FLG_ATTRIBUTE_POSITION, 3}, {user_7, 5}})),
              FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgIoErrorGetMessage()).find("view.columns[1].components: is 5, .glb holds at most 4"),
              std::string::npos)
        << flgIoErrorGetMessage();
}

TEST(CurveColumns, AreReadByName) {
    const Folder folder;
    const Read curves =
        read(folder.put("a.xyz",
                        "# a comment\n#columns x y z  user3_1 width user3_0 red green blue\n# columns of "
                        "the temple\n# closed\n1 2 3 4 5 6 0.1 0.2 0.3 # tail\n4 5 6 7 0 8 0.4 0.5 0.6\n"
                        "0 0 1 2 3 4 0 0 0\n1 2 3 4 5 6 0.1 0.2 0.3\n\n7 8 9 0 0 0 1 1 1\n"));
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    EXPECT_EQ(curves.positions(), (Floats{1, 2, 3, 4, 5, 6, 0, 0, 1, 7, 8, 9}));  // the repeated point is left out
    EXPECT_EQ(curves.column(FLG_ATTRIBUTE_WIDTH), (Floats{5, 0, 3, 0}));
    EXPECT_EQ(curves.column(static_cast<FlgAttribute>(FLG_ATTRIBUTE_USER + 3)), (Floats{6, 4, 8, 7, 4, 2, 0, 0}));
    EXPECT_EQ(curves.column(FLG_ATTRIBUTE_COLOR),
              (Floats{0.1f, 0.2f, 0.3f, 1, 0.4f, 0.5f, 0.6f, 1, 0, 0, 0, 1, 1, 1, 1, 1}));
    // None but the coordinates: then a fourth number is no radius.
    EXPECT_EQ(read(folder.put("b.xyz", "# columns x y z\n1 2 3\n")).positions(), (Floats{1, 2, 3}));
    // Files of before: a comment that only begins with the word, and lines without names.
    EXPECT_EQ(read(folder.put("c.xyz", "# columns: x y z\n1 2 3 4\n")).column(FLG_ATTRIBUTE_RADIUS), (Floats{4}));
}

TEST(CurveColumns, HostileTextIsRefusedWithTheLine) {
    const Folder folder;
    const auto refuse = [&](const std::string& text, const char* place, const char* reason) {
        expect_refused(folder.put("a.xyz", text), FLG_ERROR_FORMAT, place, reason);
    };
    refuse("# columns x y z weight\n0 0 0 1\n", "1", "no column is called so, or not all of it is there: 'weight'");
    refuse("# columns x y z radii_0 radii_1\n0 0 0 1 1\n", "1", "'radii_0'");
    refuse("# columns x y z user4294967296\n0 0 0 1\n", "1", "'user4294967296'");
    refuse("# columns x y z user-1\n0 0 0 1\n", "1", "'user-1'");
    refuse("# columns x y z width width\n0 0 0 1 1\n", "1", "twice 'width'");
    refuse("# columns x y z x\n0 0 0 1\n", "1", "twice 'x'");
    refuse("\n# columns x y z width\n# columns x y z\n0 0 0 1\n", "3", "once only");
    refuse("0 0 0\n\n# columns x y z width\n0 0 0 1\n", "3", "before the first point");
    refuse("0 0 0\n# columns x y z width\n", "2", "before the first point");
    refuse("# columns x y z width\n0 0 0 1\n0 0 0\n", "3", "the width is missing");
    refuse("# columns x y z width\n0 0 0 1 2\n", "2", "more numbers than columns: '2'");
    refuse("# columns x y z\n0 0 0 1\n", "2", "more numbers than columns: '1'");
    refuse("# columns x y z angle\n0 0 0 nan\n", "2", "the angle must be finite");
    refuse("# columns x y z width\n0 0 0 -1\n", "2", "the width is -1, must be >= 0");
    refuse("# columns x y z radii_0 radii_1 radii_2\n0 0 0 1 -2 -3\n", "2", "the radii_1 is -2, must be >= 0");
    refuse("# columns x y z speed\n0 0 0 0\n", "2", "the speed is 0, must be above 0");
    std::string many = "# columns x y z", more = many;
    for (int i = 0; i < 300; ++i) many += " user" + std::to_string(i);
    refuse(many + "\n0 0 0\n", "1", "303 names, more than 256");
    for (int i = 0; i < 16; ++i) more += " user" + std::to_string(i);
    refuse(more + "\n0 0 0\n", "1", "'user15'");
}

// Radii (1, 2, 0.5), a direction and a width at each of the four points.
Document with_columns() {
    Document document;
    document.primitive = R"({"attributes": {"POSITION": 0, "_RADII": 1, "_DISPLACEMENT": 1, "NORMAL": 1, "_WIDTH": 2},
        "mode": 3})";
    Floats values;
    for (int i = 0; i < 4; ++i) values.insert(values.end(), {1, 2, 0.5f});
    values.insert(values.end(), {3, 3, 3, 3});
    document.more = bytes_of(values);
    document.views = R"(, {"buffer": 0, "byteOffset": 48, "byteLength": 64})";
    document.accessors = R"(, {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 1, "byteOffset": 48, "componentType": 5126, "count": 4, "type": "SCALAR"})";
    return document;
}

TEST(CurveColumns, OfGltfGoWithTheirNodes) {
    const Folder folder;
    Document document = with_columns();
    // A quarter turn about z and twice the size.
    document.nodes = R"("scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "matrix": [0,2,0,0, -2,0,0,0, 0,0,2,0, 5,0,0,1]}],)";
    const Read curves = read(folder.put("a.gltf", document.text()));
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    EXPECT_EQ(curves.column(FLG_ATTRIBUTE_WIDTH), (Floats{6, 6, 6, 6}));
    const Floats radii = curves.column(FLG_ATTRIBUTE_RADII), moved = curves.column(FLG_ATTRIBUTE_DISPLACEMENT),
                 normals = curves.column(FLG_ATTRIBUTE_NORMAL);
    ASSERT_EQ(radii.size(), 12u);
    EXPECT_EQ(Floats(radii.begin(), radii.begin() + 3), (Floats{2, 4, 0.5f}));
    EXPECT_EQ(Floats(moved.begin(), moved.begin() + 3), (Floats{-4, 2, 1}));
    const float length = std::sqrt(5.25f);
    const float expected[3] = {-2 / length, 1 / length, 0.5f / length};
    for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(normals[k], expected[k], 1e-6);
}

TEST(CurveColumns, OfSomeGltfCurvesAreLeftOut) {
    const Folder folder;
    Document document = with_columns();
    document.primitive += R"(, {"attributes": {"POSITION": 0, "_WIDTH": 2, "_SPEED": 2}, "mode": 3})";
    const Read curves = read(folder.put("a.gltf", document.text()));
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    EXPECT_EQ(curves.columns.size(), 2u);
    EXPECT_EQ(curves.column(FLG_ATTRIBUTE_WIDTH), Floats(8, 3));
    EXPECT_NE(curves.warnings.find("other columns than the curves before"), std::string::npos) << curves.warnings;
}

TEST(CurveColumns, HostileGltfIsRefused) {
    const Folder folder;
    const auto refuse = [&](const std::string& attributes, const char* place, const char* reason) {
        Document document = with_columns();
        document.primitive = R"({"attributes": {"POSITION": 0, )" + attributes + R"(}, "mode": 3})";
        document.accessors += R"(, {"bufferView": 1, "componentType": 5126, "count": 3, "type": "SCALAR"})";
        expect_refused(folder.put("a.gltf", document.text()), FLG_ERROR_FORMAT, place, reason);
    };
    refuse(R"("_WIDTH": 3)", "accessors[3]", "no values fit for 4 vertices");
    refuse(R"("_ANGLE": 1)", "accessors[1]", "no values fit");
    refuse(R"("_RADII": 2)", "accessors[2]", "no values fit");
    refuse(R"("_USER1": 9)", "meshes[0].primitives[0].attributes._USER1", "accessors");
    refuse(R"("_USER1": 2, "_USER01": 2)", "accessors[2]", "there already");
    Document document = with_columns();
    Floats values(12, 1.0f);
    values.insert(values.end(), {1, -1, 1, 1});
    document.more = bytes_of(values);
    expect_refused(folder.put("b.gltf", document.text()), FLG_ERROR_FORMAT, "accessors[2]",
                   "vertex 1 gives -1: must be >= 0");
    values[14] = INFINITY;
    values[13] = 1;
    document.more = bytes_of(values);
    expect_refused(folder.put("c.gltf", document.text()), FLG_ERROR_FORMAT, "accessors[2]", "vertex 2 gives inf");
}

}  // namespace
}  // namespace flg::test
