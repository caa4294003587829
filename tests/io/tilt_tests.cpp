// SPDX-License-Identifier: MIT
// .tilt sketches: what is read of a sound or merely odd one, and what is refused.
#include <cmath>
#include <limits>

#include "io/files.h"
#include "io/tilt_files.h"

namespace flg::test {
namespace {

TEST(Tilt, ConvertsUnitsAxesColoursAndWidths) {
    const Folder folder;
    TiltStroke stroke = sample_stroke();
    const float half = std::sqrt(0.5f);
    for (TiltPoint& point : stroke.points) {
        point.orientation[0] = half;
        point.orientation[2] = half;
        point.orientation[3] = 0;
    }
    const Read sketch = read(folder.put("a.tilt", tilt_file(tilt_sketch({stroke, stroke}))));
    ASSERT_EQ(sketch.result, FLG_OK) << sketch.error;
    EXPECT_EQ(sketch.format, "tilt");
    EXPECT_EQ(sketch.units, "decimetres, left-handed");
    EXPECT_EQ(sketch.offsets, (std::vector<uint32_t>{0, 4, 8}));
    EXPECT_EQ(sketch.warnings, "");
    for (size_t i = 0; i < 4; ++i) {
        const float x = static_cast<float>(i);
        EXPECT_FLOAT_EQ(sketch.positions()[3 * i], 0.1f * x);
        EXPECT_FLOAT_EQ(sketch.positions()[3 * i + 1], 1.0f);
        EXPECT_FLOAT_EQ(sketch.positions()[3 * i + 2], -0.1f * x * x);
        EXPECT_EQ(sketch.column(FLG_ATTRIBUTE_ORIENTATION)[4 * i], -half);
        EXPECT_EQ(sketch.column(FLG_ATTRIBUTE_ORIENTATION)[4 * i + 2], half);
        EXPECT_EQ(sketch.column(FLG_ATTRIBUTE_PRESSURE)[i], 0.25f * x);
        EXPECT_FLOAT_EQ(sketch.column(FLG_ATTRIBUTE_TIME)[i], 0.25f * x);
        // Size 2 at scale 0.5 is 1 dm wide.
        EXPECT_FLOAT_EQ(sketch.column(FLG_ATTRIBUTE_RADIUS)[i], 0.05f * (0.1f + 0.9f * 0.25f * x));
        EXPECT_NEAR(sketch.column(FLG_ATTRIBUTE_COLOR)[4 * i], 0.2140411f, 1e-6f);
        EXPECT_EQ(sketch.column(FLG_ATTRIBUTE_COLOR)[4 * i + 1], 1.0f);
    }
    ASSERT_EQ(sketch.strokes.size(), 2u);
    EXPECT_STREQ(sketch.strokes[0].brush, "Ink");
    EXPECT_FLOAT_EQ(sketch.strokes[0].size, 0.1f);
    EXPECT_EQ(sketch.strokes[0].flags, 2u);
    EXPECT_EQ(sketch.strokes[0].group, 77u);
    EXPECT_EQ(sketch.strokes[0].start_ms, 1000u);
}

TEST(Tilt, AllFormsOfContainerHoldTheSame) {
    const Folder folder;
    const std::string sketch = tilt_sketch({sample_stroke()});
    const Read stored = read(folder.put("stored.tilt", tilt_file(sketch)));
    ASSERT_EQ(stored.result, FLG_OK) << stored.error;
    folder.put("folder.tilt/data.sketch", sketch);
    folder.put("folder.tilt/metadata.json", tilt_metadata);
    const std::vector<ZipMember> members = {{"metadata.json", tilt_metadata}, {"data.sketch", sketch}};
    const std::string others[] = {
        folder.put("packed.tilt", tilt_file(sketch, true)),
        folder.put("LongHeader.TILT", tilt_header(40) + zip(members)),
        folder.put("true_offsets.tilt", tilt_header() + zip(members, 16)),
        folder.put("old.tilt", tilt_header() + zip({{"main.json", tilt_metadata}, {"data.sketch", sketch}})),
        folder.at("folder.tilt"),
        folder.at("folder.tilt/"),
    };
    for (const std::string& other : others) {
        const Read again = read(other);
        ASSERT_EQ(again.result, FLG_OK) << again.error;
        EXPECT_EQ(again.columns, stored.columns) << other;
    }
}

TEST(Tilt, SkipsUnknownExtensionsOfStrokesAndPoints) {
    const Folder folder;
    TiltStroke stroke = sample_stroke();
    const Read plain = read(folder.put("plain.tilt", tilt_file(tilt_sketch({stroke}))));
    stroke.stroke_mask |= 1u << 9 | 1u << 20;
    put<uint32_t>(stroke.extensions, 0xffffffff);
    put<uint32_t>(stroke.extensions, 5);
    stroke.extensions += "12345";
    stroke.point_mask |= 1u << 2 | 1u << 31;
    stroke.point_extra = "abcdefgh";
    const Read extended = read(folder.put("extended.tilt", tilt_file(tilt_sketch({stroke, stroke}, 6))));
    ASSERT_EQ(extended.result, FLG_OK) << extended.error;
    EXPECT_EQ(std::vector<float>(extended.positions().begin() + 12, extended.positions().end()), plain.positions());
    EXPECT_NE(extended.warnings.find("2 strokes: unknown stroke extensions"), std::string::npos);
    EXPECT_NE(extended.warnings.find("2 strokes: unknown point extensions"), std::string::npos);
}

TEST(Tilt, MissingPressureAndTimeHaveTheirDefaults) {
    const Folder folder;
    TiltStroke stroke = sample_stroke();
    stroke.point_mask = 0;
    const Read sketch = read(folder.put("a.tilt", tilt_file(tilt_sketch({stroke}))));
    ASSERT_EQ(sketch.result, FLG_OK) << sketch.error;
    EXPECT_EQ(sketch.column(FLG_ATTRIBUTE_PRESSURE), std::vector<float>(4, 1.0f));
    EXPECT_EQ(sketch.column(FLG_ATTRIBUTE_TIME), std::vector<float>(4, 0.0f));
    stroke.point_mask = 2;
    const Read timed = read(folder.put("b.tilt", tilt_file(tilt_sketch({stroke}))));
    EXPECT_EQ(timed.column(FLG_ATTRIBUTE_TIME)[3], 0.75f);
}

TEST(Tilt, OdditiesBecomeWarnings) {
    const Folder folder;
    std::vector<TiltStroke> strokes(7, sample_stroke());
    strokes[0].points.clear();
    strokes[1].brush = 9;
    strokes[2].brush = 1;
    strokes[3].points[2].time = 10;
    strokes[4].points[1].pressure = 1.5f;
    strokes[4].points[1].orientation[3] = 0;
    strokes[5].color[1] = -2;
    strokes[5].points[1] = strokes[5].points[0];
    strokes[6].points.resize(1);
    const Read sketch = read(folder.put("a.tilt", tilt_file(tilt_sketch(strokes) + "rest")));
    ASSERT_EQ(sketch.result, FLG_OK) << sketch.error;
    EXPECT_EQ(sketch.flags.size(), 6u);
    for (const char* sentence :
         {"1 stroke: no points, left out (first: stroke 0)", "1 stroke: the brush's number is not in BrushIndex",
          "1 stroke: the brush is not known by name", "1 stroke: time stamps run backwards (first: stroke 3)",
          "1 stroke: pressures are not within 0 to 1", "1 stroke: orientations are no unit quaternions",
          "1 stroke: the colour is not within 0 to 1", "4 bytes follow the last stroke",
          "1 curve: has points repeated in a row", "1 curve: of a single point"}) {
        EXPECT_NE(sketch.warnings.find(sentence), std::string::npos) << sentence << " in\n" << sketch.warnings;
    }
    EXPECT_STREQ(sketch.strokes[0].brush, "unknown");
    EXPECT_STREQ(sketch.strokes[1].brush, "01234567-0000-0000-0000-000000000000");
    EXPECT_LT(sketch.column(FLG_ATTRIBUTE_TIME)[2 * 4 + 2], 0.0f);
}

TEST(Tilt, EmptySketchIsNoError) {
    const Folder folder;
    const Read sketch = read(folder.put("a.tilt", tilt_file(tilt_sketch({}))));
    ASSERT_EQ(sketch.result, FLG_OK) << sketch.error;
    EXPECT_EQ(sketch.offsets, std::vector<uint32_t>{0});
    EXPECT_EQ(sketch.warnings, "the sketch holds no strokes\n");
}

TEST(Tilt, RefusesContainersThatCannotBeRight) {
    const Folder folder;
    const std::string sketch = tilt_sketch({sample_stroke()});
    const std::string good = tilt_file(sketch);
    std::string bad = good;
    bad[0] = 'T';
    expect_refused(folder.put("magic.tilt", bad), FLG_ERROR_FORMAT, "@0", "no .tilt sketch");
    expect_refused(folder.put("header.tilt", tilt_header(12) + zip({})), FLG_ERROR_FORMAT, "@4", "12 bytes");
    expect_refused(folder.put("version.tilt", tilt_header(16, 2) + zip({})), FLG_ERROR_FORMAT, "@6", "version 2");
    expect_refused(folder.put("nozip.tilt", tilt_header() + "something else"), FLG_ERROR_FORMAT, "@16", "no zip");
    expect_refused(folder.put("nosketch.tilt", tilt_header() + zip({{"metadata.json", tilt_metadata}})),
                   FLG_ERROR_FORMAT, "data.sketch", "not in the archive");
    expect_refused(folder.put("nometa.tilt", tilt_header() + zip({{"data.sketch", sketch}})), FLG_ERROR_FORMAT,
                   "metadata.json", "not in the archive");
    expect_refused(folder.put("json.tilt", tilt_header() + zip({{"metadata.json", "{,"}, {"data.sketch", sketch}})),
                   FLG_ERROR_FORMAT, "metadata.json@2", "no JSON");
    expect_refused(folder.put("index.tilt", tilt_header() + zip({{"metadata.json", R"({"BrushIndex": [3]})"},
                                                                 {"data.sketch", sketch}})),
                   FLG_ERROR_FORMAT, "metadata.json.BrushIndex[0]", "no string");
    expect_refused(
        folder.put(
            "twice.tilt",
            tilt_header() + zip({{"metadata.json", tilt_metadata}, {"metadata.json", "{}"}, {"data.sketch", sketch}})),
        FLG_ERROR_FORMAT, "metadata.json", "twice");
    bad = good;
    bad[bad.find("no picture") + 80] ^= 1;  // inside data.sketch
    expect_refused(folder.put("sum.tilt", bad), FLG_ERROR_FORMAT, "data.sketch", "check sum");
    folder.put("half.tilt/metadata.json", tilt_metadata);
    expect_refused(folder.at("half.tilt"), FLG_ERROR_FILE, "data.sketch", "can't be opened");
}

TEST(Tilt, RefusesValuesThatCannotBeRight) {
    const Folder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    const auto refuse = [&](const TiltStroke& stroke, const char* place, const char* reason) {
        expect_refused(folder.put("a.tilt", tilt_file(tilt_sketch({stroke}))), FLG_ERROR_FORMAT, place, reason);
    };
    TiltStroke stroke = sample_stroke();
    const TiltStroke good = stroke;
    stroke.points[1].position[1] = nan;
    refuse(stroke, "data.sketch@104", "position of nan");
    stroke = good;
    stroke.points[0].position[0] = 3e31f;
    refuse(stroke, "data.sketch@68", "position of 3e+31");
    stroke = good;
    stroke.points[0].orientation[0] = inf;
    refuse(stroke, "data.sketch@68", "orientation of inf");
    stroke = good;
    stroke.points[3].pressure = nan;
    refuse(stroke, "data.sketch@176", "pressure of nan");
    stroke = good;
    stroke.color[2] = inf;
    refuse(stroke, "data.sketch@20", "colour of inf");
    stroke = good;
    stroke.size = -1;
    refuse(stroke, "data.sketch@20", "size -1");
    std::string sketch = tilt_sketch({good});
    const int32_t many = 0x7fffffff;
    std::memcpy(&sketch[64], &many, sizeof many);
    expect_refused(folder.put("points.tilt", tilt_file(sketch)), FLG_ERROR_FORMAT, "data.sketch@20",
                   "2147483647 points");
    std::memcpy(&sketch[16], &many, sizeof many);
    expect_refused(folder.put("strokes.tilt", tilt_file(sketch)), FLG_ERROR_FORMAT, "data.sketch@16",
                   "2147483647 strokes");
    expect_refused(folder.put("v7.tilt", tilt_file(tilt_sketch({}, 7))), FLG_ERROR_FORMAT, "data.sketch@4",
                   "version 7");
    expect_refused(folder.put("s.tilt", tilt_file("nothing at all")), FLG_ERROR_FORMAT, "data.sketch@0", "no strokes");
}

TEST(Tilt, ZipThatUnpacksWithoutEndIsStopped) {
    const Folder folder;
    const auto bomb = [&](size_t size, uint32_t declared) {
        return folder.put("bomb.tilt", tilt_header() + zip({{"data.sketch", std::string(size, '\0'), true, declared},
                                                            {"metadata.json", tilt_metadata}}));
    };
    constexpr size_t unpacked = size_t{1} << 24;
    expect_refused(bomb(unpacked, 1000), FLG_ERROR_FORMAT, "data.sketch", "more than the 1000 bytes");
    expect_refused(bomb(unpacked, 0x7f000000), FLG_ERROR_FORMAT, "data.sketch", "can't unpack to");
    expect_refused(bomb(unpacked, unpacked + 5), FLG_ERROR_FORMAT, "data.sketch", "but declares 16777221");
    expect_refused(bomb(unpacked, 0xf0000000), FLG_ERROR_LIMIT, "data.sketch", "2 GiB");
    // Honest about its size, and still refused before it is unpacked.
    constexpr size_t much = size_t{1} << 26;
    expect_refused(bomb(much, much), FLG_ERROR_LIMIT, "data.sketch", "declares 67108864 bytes of");
}

// Numbers packed so well that a document of them would take gigabytes; read, they are passed over.
TEST(Tilt, MetadataIsNotKeptAndHasALimit) {
    const Folder folder;
    const std::string sketch = tilt_sketch({sample_stroke()});
    const auto metadata_of = [](size_t count) {
        std::string text = R"({"junk": [)";
        for (size_t i = 0; i < count; ++i) text += "[],";
        return text + R"(0], "BrushIndex": ["c0012095-3ffd-4040-8ee1-fc180d346eaa"]})";
    };
    const auto file_of = [&](const std::string& metadata) {
        return folder.put("bomb.tilt",
                          tilt_header() + zip({{"metadata.json", metadata, true}, {"data.sketch", sketch}}));
    };
    const Read sound = read(file_of(metadata_of(100)));
    ASSERT_EQ(sound.result, FLG_OK) << sound.error;
    EXPECT_STREQ(sound.strokes.at(0).brush, "Ink");

    constexpr size_t limit = size_t{16} << 20;
    expect_refused(file_of(metadata_of(limit / 3)), FLG_ERROR_LIMIT, "metadata.json", "the limit of 16 MiB");
    folder.put("folder.tilt/data.sketch", sketch);
    folder.put("folder.tilt/metadata.json", metadata_of(limit / 3));
    expect_refused(folder.at("folder.tilt"), FLG_ERROR_LIMIT, "metadata.json", "the limit of 16 MiB");

    const std::string deep = R"({"junk": )" + std::string(1000, '[') + std::string(1000, ']') + "}";
    expect_refused(file_of(deep), FLG_ERROR_LIMIT, "metadata.json", "deep");
    std::string many = R"({"BrushIndex": [)";
    for (int i = 0; i < 1 << 16; ++i) many += R"("",)";
    expect_refused(file_of(many + R"(""]})"), FLG_ERROR_LIMIT, "metadata.json.BrushIndex", "65536");
    expect_refused(file_of(R"({"BrushIndex": {}})"), FLG_ERROR_FORMAT, "metadata.json.BrushIndex", "no array");
    expect_refused(file_of(R"({"BrushIndex": [[]]})"), FLG_ERROR_FORMAT, "metadata.json.BrushIndex[0]", "no string");
    expect_refused(file_of(R"({"a": {"BrushIndex": []}})"), FLG_ERROR_FORMAT, "metadata.json", "no BrushIndex");
}

TEST(Tilt, TruncatedAnywhereIsRefused) {
    const Folder folder;
    for (const bool packed : {false, true}) {
        const std::string whole = tilt_file(tilt_sketch({sample_stroke(), sample_stroke()}), packed);
        for (size_t size = 0; size < whole.size(); ++size) {
            const Read cut = read(folder.put("cut.tilt", std::string_view(whole).substr(0, size)));
            ASSERT_EQ(cut.result, FLG_ERROR_FORMAT) << size;
        }
    }
    // Without the archive's sums.
    const std::string sketch = tilt_sketch({sample_stroke(), sample_stroke()});
    folder.put("cut2.tilt/metadata.json", tilt_metadata);
    for (size_t size = 0; size < sketch.size(); ++size) {
        folder.put("cut2.tilt/data.sketch", std::string_view(sketch).substr(0, size));
        ASSERT_EQ(read(folder.at("cut2.tilt")).result, FLG_ERROR_FORMAT) << size;
    }
}

}  // namespace
}  // namespace flg::test
