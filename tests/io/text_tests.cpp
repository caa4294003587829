// SPDX-License-Identifier: MIT
// The text formats: .xyz and OBJ.
#include <clocale>
#include <cstring>
#include <random>

#include "io/files.h"

namespace flg::test {
namespace {

using Floats = std::vector<float>;

TEST(Xyz, ReadsItsGrammar) {
    const Folder folder;
    const Read curves =
        read(folder.put("a.xyz",
                        "\xef\xbb\xbf# any \xc3\xa9 comment, even closed\r\n1 2 3\r\n\t+4 -5e0 .5  # tail\r\n"
                        "# in between\r\n7 8 9\r\n \t \r\n\r\n#closed\n# and more\n1e-60 0 0\n1 0 0\n0 1 0"));
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    EXPECT_EQ(curves.positions(), (Floats{1, 2, 3, 4, -5, 0.5f, 7, 8, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(curves.offsets, (std::vector<uint32_t>{0, 3, 6}));
    EXPECT_EQ(curves.flags, (std::vector<uint8_t>{0, FLG_CURVE_CLOSED}));
    EXPECT_EQ(curves.format, "xyz");
    EXPECT_TRUE(curves.column(FLG_ATTRIBUTE_RADIUS).empty());
    EXPECT_EQ(curves.warnings, "");
}

TEST(Xyz, RadiiOfSomeCurvesAreFilledUp) {
    const Folder folder;
    const Read curves = read(folder.put("a.txt", "0 0 0\n1 0 0\n\n0 0 0 0.5\n1 0 0 0.25\n"));
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    EXPECT_EQ(curves.column(FLG_ATTRIBUTE_RADIUS), (Floats{0.005f, 0.005f, 0.5f, 0.25f}));
    EXPECT_EQ(curves.warnings, "1 curve: no radius where others have one, set to 0.005 m (first: curve 0)\n");
}

TEST(Xyz, ClosedCurvesDoNotRepeatTheirFirstPoint) {
    const Folder folder;
    const Read curves = read(folder.put("a.xyz", "# closed\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 0 1\n"));
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    EXPECT_EQ(curves.offsets.back(), 3u);
    EXPECT_EQ(curves.column(FLG_ATTRIBUTE_RADIUS).size(), 3u);
    EXPECT_NE(curves.warnings.find("repeated at the end"), std::string::npos);
}

TEST(Xyz, ColorsAreCommentsToOthers) {
    const Folder folder;
    const Read curves = read(folder.put("a.xyz",
                                        "0 0 0\n# color 1 0.5 0.25\n1 0 0\n# color blue\n# color 1 2\n2 0 0\n\n"
                                        "3 0 0\n#color 0 0 1 0.5\n4 0 0\n"));
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    EXPECT_EQ(curves.column(FLG_ATTRIBUTE_COLOR),
              (Floats{1, 1, 1, 1, 1, 0.5f, 0.25f, 1, 1, 0.5f, 0.25f, 1, 1, 0.5f, 0.25f, 1, 0, 0, 1, 0.5f}));
    EXPECT_TRUE(curves.column(FLG_ATTRIBUTE_RADIUS).empty());
    EXPECT_TRUE(read(folder.put("b.xyz", "0 0 0\n1 0 0\n# color blue\n")).column(FLG_ATTRIBUTE_COLOR).empty());
    const Read closed =
        read(folder.put("c.xyz", "# closed\n# color 1 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n# color 0 1 0\n"));
    EXPECT_EQ(closed.column(FLG_ATTRIBUTE_COLOR), (Floats{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}));
}

TEST(Xyz, ColorsAreKeptWithoutAsking) {
    const Folder folder;
    const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0};
    const std::vector<float> colors = {1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5f, 0, 1, 0, 0.5f, 0, 1};
    const uint32_t offsets[] = {0, 3, 4};
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0},
                                 {FLG_ATTRIBUTE_COLOR, 4, colors.data(), 0, 0}};
    FlgCurveSetView view = {};
    view.struct_size = sizeof view;
    view.curve_count = 2;
    view.curve_offsets = offsets;
    view.columns = columns;
    view.column_count = 2;
    const std::string path = folder.at("a.xyz");
    ASSERT_EQ(flgCurveFileWrite(path.c_str(), &view, nullptr), FLG_OK) << flgIoErrorGetMessage();
    EXPECT_EQ(slurp(path), "# color 1 0 0 1\n0 0 0\n1 0 0\n# color 0 0.5 0 1\n2 0 0\n\n3 0 0\n");
    EXPECT_EQ(read(path).column(FLG_ATTRIBUTE_COLOR), colors);
}

TEST(Xyz, RefusesWithTheLine) {
    const Folder folder;
    const auto refuse = [&](const char* text, const char* place, const char* reason) {
        expect_refused(folder.put("a.xyz", text), FLG_ERROR_FORMAT, place, reason);
    };
    refuse("0 0 0\n1 0 0 0.5\n", "2", "a radius");
    refuse("0 0 0 1\n\n# x\n1 0 0 1\n2 2 2", "5", "no radius");
    refuse("0 0\n", "1", "the z is missing");
    refuse("0 0 0 1 2\n", "1", "more than four numbers: '2'");
    refuse("0 0 zero\n", "1", "no number: 'zero'");
    refuse("0 0 0x1p3\n", "1", "no number: '0x1p3'");
    refuse("1,5 0 0\n", "1", "no number: '1,5'");
    refuse("0 0 +-1\n", "1", "no number");
    refuse("\n0 nan 0\n", "2", "finite");
    refuse("0 0 -inf\n", "1", "finite");
    refuse("0 0 1e31\n", "1", "1e30 in size: '1e31'");
    refuse("0 0 1e999999999999\n", "1", "1e30 in size");
    refuse("0 0 0 -1\n", "1", "radius is -1");
    refuse("1 2 3\n# closed\n4 5 6\n", "2", "blank line");
    refuse("", "", "no points");
    refuse("# only\n# closed\n", "2", "no points");
}

TEST(Xyz, TinyNumbersAreZeroOrDenormal) {
    const Folder folder;
    const std::string zeros = "0." + std::string(500, '0') + "1";
    const Read curves = read(folder.put("a.xyz", "1e-400 " + zeros + " 1e-40\n1e-99999999999 -1e-300 0\n"));
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    EXPECT_EQ(curves.positions(), (Floats{0, 0, 1e-40f, 0, 0, 0}));
    expect_refused(folder.put("b.xyz", "1" + std::string(500, '0') + ".0 0 0"), FLG_ERROR_FORMAT, "1", "1e30");
}

TEST(Xyz, DoesNotDependOnTheLocale) {
    const Folder folder;
    std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C"}) {
        std::setlocale(LC_ALL, locale);
        EXPECT_EQ(read(folder.put("a.xyz", "1.5 2.25 3\n")).positions(), (Floats{1.5f, 2.25f, 3}));
    }
    std::setlocale(LC_ALL, before.c_str());
}

// Floats of all sizes, some ugly.
Curves random_curves(bool with_radii) {
    std::mt19937 random(7);
    Curves curves;
    for (int c = 0; c < 40; ++c) {
        const uint32_t count = 1 + random() % 20;
        for (uint32_t i = 0; i < 3 * count; ++i) {
            const uint32_t bits = random() & 0xbfffffffu;  // below 2 in size, denormals included
            float value;
            std::memcpy(&value, &bits, sizeof value);
            curves.positions.push_back(i % 2 ? value : value * 1e6f);
        }
        curves.end(c % 3 == 0 && count > 2);
    }
    for (size_t i = 0; with_radii && i < curves.positions.size() / 3; ++i) {
        curves.radii.push_back(static_cast<float>(random()) * 1e-10f);
    }
    return curves;
}

TEST(TextRoundTrip, XyzIsExact) {
    const Folder folder;
    for (const bool radii : {false, true}) {
        Curves curves = random_curves(radii);
        ASSERT_EQ(write(folder.at("a.xyz"), curves), FLG_OK) << flgIoErrorGetMessage();
        const Read again = read(folder.at("a.xyz"));
        ASSERT_EQ(again.result, FLG_OK) << again.error;
        EXPECT_EQ(again.positions(), curves.positions);
        EXPECT_EQ(again.column(FLG_ATTRIBUTE_RADIUS), curves.radii);
        EXPECT_EQ(again.offsets, curves.offsets);
        EXPECT_EQ(again.flags, curves.flags);
    }
}

TEST(TextRoundTrip, ObjIsExact) {
    const Folder folder;
    Curves curves = random_curves(true);
    ASSERT_EQ(write(folder.at("a.obj"), curves), FLG_OK) << flgIoErrorGetMessage();
    const Read again = read(folder.at("a.obj"));
    ASSERT_EQ(again.result, FLG_OK) << again.error;
    EXPECT_EQ(again.positions(), curves.positions);
    EXPECT_EQ(again.offsets, curves.offsets);
    EXPECT_EQ(again.flags, curves.flags);
}

TEST(Obj, ReadsLinesOfAllForms) {
    const Folder folder;
    const Read curves = read(folder.put("a.obj",
                                        "# lines\nmtllib x.mtl\no thing\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\n"
                                        "v 0 1 0\nvt 0 0\nl 1/1 2/1 3\nl -4 -3 \\\n-2 -1 -4\nf 1 2 3\nl 2 2\n"
                                        "l 1 2\nl 2 3\nl 4 3\nl 3 1\nl 1 4\n"));
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    // A strip, a loop, a lone point, then edges: 1 2 3 goes on no further, 4 3 1 closes.
    EXPECT_EQ(curves.offsets, (std::vector<uint32_t>{0, 3, 7, 8, 11, 14}));
    EXPECT_EQ(curves.flags, (std::vector<uint8_t>{0, 1, 0, 0, 1}));
    EXPECT_EQ(curves.warnings.substr(0, 7), "1 face:");
    EXPECT_EQ(Floats(curves.positions().begin() + 33, curves.positions().end()), (Floats{0, 1, 0, 1, 1, 0, 0, 0, 0}));
}

TEST(Obj, RefusesWithTheLine) {
    const Folder folder;
    const auto refuse = [&](const std::string& text, const char* place, const char* reason) {
        expect_refused(folder.put("a.obj", text), FLG_ERROR_FORMAT, place, reason);
    };
    refuse("v 0 0 0\nv 1 0 0\nf 1 2 1\n", "3", "no lines");
    const std::string two = "v 0 0 0\nv 1 0 0\n";
    refuse(two + "l 1 3\n", "3", "index 3 is out of range: the file has 2");
    refuse(two + "l 0 1\n", "3", "'0' is out of range");
    refuse(two + "l -3 1\n", "3", "'-3' is out of range");
    refuse(two + "l 99999999999999999999 1\n", "3", "out of range");
    refuse(two + "l 1 x\n", "3", "no vertex index: 'x'");
    refuse(two + "l 1\n", "3", "fewer than two");
    refuse("v 0 0 nan\n", "1", "finite");
    refuse("v 0 0\n", "1", "z is missing");
}

}  // namespace
}  // namespace flg::test
