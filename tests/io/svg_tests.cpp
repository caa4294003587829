// SPDX-License-Identifier: MIT
// Outlines of SVG drawings: shapes whose points are known, and what is refused.
#include <cmath>

#include "io/files.h"

namespace flg::test {
namespace {

using Floats = std::vector<float>;

Read read_svg(const Folder& folder, const std::string& elements) {
    return read(folder.put("a.svg", "<svg xmlns='http://www.w3.org/2000/svg'>\n" + elements + "\n</svg>\n"));
}

Read read_path(const Folder& folder, const std::string& data) {
    return read_svg(folder, "<path d='" + data + "'/>");
}

// The area that a closed curve encloses, positive where it runs counter-clockwise with y upwards.
double area(const Read& curves, size_t curve) {
    double sum = 0;
    const uint32_t first = curves.offsets[curve], end = curves.offsets[curve + 1];
    const Floats& p = curves.positions();
    for (uint32_t i = first; i < end; ++i) {
        const uint32_t next = i + 1 == end ? first : i + 1;
        sum += double(p[3 * i]) * p[3 * next + 1] - double(p[3 * next]) * p[3 * i + 1];
    }
    return sum / 2;
}

TEST(Svg, PathsAbsoluteAndRelative) {
    const Folder folder;
    const Floats square = {1, -1, 0, 3, -1, 0, 3, -4, 0, 1, -4, 0};
    for (const char* data : {"M1 1L3 1L3 4L1 4Z", "M1,1 3,1 3,4 1,4 z", "m1 1 2 0 0 3-2 0z", "M1 1H3V4H1V1z",
                             "m1 1h2v3h-2z", "M1e0+1 L30e-1,1 L3.,4 L1 4z"}) {
        const Read curves = read_path(folder, data);
        ASSERT_EQ(curves.result, FLG_OK) << data << ": " << curves.error;
        EXPECT_EQ(curves.positions(), square) << data;
        EXPECT_EQ(curves.flags, (std::vector<uint8_t>{FLG_CURVE_CLOSED})) << data;
        EXPECT_EQ(curves.format, "svg");
    }
    const Read two = read_path(folder, "M0 0l1 0 0 1zl0 5M7 7.5.5.25");
    ASSERT_EQ(two.result, FLG_OK) << two.error;
    EXPECT_EQ(two.offsets, (std::vector<uint32_t>{0, 3, 5, 7})) << "behind z the path goes on where it began";
    EXPECT_EQ(two.flags, (std::vector<uint8_t>{FLG_CURVE_CLOSED, 0, 0}));
    EXPECT_EQ(Floats(two.positions().end() - 3, two.positions().end()), (Floats{0.5f, -0.25f, 0}));
}

TEST(Svg, CurvesLieOnWhatTheyFlatten) {
    const Folder folder;
    // Half circles by arcs, either way round, and by radii that are too small and grow.
    for (const char* data : {"M1 0A1 1 0 0 0 -1 0A1 1 0 0 0 1 0z", "M1 0a1 1 0 00-2 0 1 1 0 002 0z",
                             "M1 0A.1 .1 45 1 0 -1 0A.1 .1 0 0 0 1 0z"}) {
        const Read curves = read_path(folder, data);
        ASSERT_EQ(curves.result, FLG_OK) << curves.error;
        for (size_t i = 0; i < curves.positions().size(); i += 3) {
            EXPECT_NEAR(std::hypot(curves.positions()[i], curves.positions()[i + 1]), 1, 1e-6) << data;
        }
        EXPECT_NEAR(area(curves, 0), M_PI, 2e-3 * M_PI) << data << ": against the sun, with y downwards";
    }
    // y = x^2, by a quadratic, by its cubic, and by two halves of which the second is mirrored.
    for (const char* data : {"M-1 1Q0-1 1 1", "M-1 1q1-2 2 0", "M-1 1C-.333333-.333333.333333-.333333 1 1",
                             "M-1 1Q-.5 0 0 0T1 1M5 5L6 6"}) {
        const Read curves = read_path(folder, data);
        ASSERT_EQ(curves.result, FLG_OK) << curves.error;
        EXPECT_GT(curves.offsets[1], 10u);
        for (uint32_t i = 0; i < curves.offsets[1] && data[6] != '.'; ++i) {
            const double x = curves.positions()[3 * i], y = -curves.positions()[3 * i + 1];
            EXPECT_NEAR(y, x * x, 1e-5) << data;
        }
    }
    // A smooth cubic goes on along the tangent.
    const Read smooth = read_path(folder, "M0 0C0 1 1 2 2 2S4 1 4 0");
    ASSERT_EQ(smooth.result, FLG_OK) << smooth.error;
    for (size_t i = 0; i < smooth.positions().size(); i += 3) {
        const size_t mirrored = smooth.positions().size() - 3 - i;
        EXPECT_NEAR(smooth.positions()[i], 4 - smooth.positions()[mirrored], 1e-6);
        EXPECT_NEAR(smooth.positions()[i + 1], smooth.positions()[mirrored + 1], 1e-6);
    }
}

TEST(Svg, ShapesHaveTheirAreas) {
    const Folder folder;
    const Read curves =
        read_svg(folder,
                 "<circle cx='5' cy='6' r='2'/><ellipse rx='3px' ry='1'/><rect x='1' width='4' height='2'/>"
                 "<rect width='4' height='2' rx='1'/><polygon points='0,0 4,0 0,3'/>"
                 "<polyline points='0 0 1 1'/><line x1='1' x2='2'/>");
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    const double areas[] = {4 * M_PI, 3 * M_PI, 8, 8 - (4 - M_PI), 6};
    ASSERT_EQ(curves.flags.size(), 7u);
    for (size_t c = 0; c < 5; ++c) {
        EXPECT_EQ(curves.flags[c], FLG_CURVE_CLOSED);
        EXPECT_NEAR(-area(curves, c), areas[c], 2e-3 * areas[c]) << c;
    }
    EXPECT_EQ(curves.flags[5] + curves.flags[6], 0);
}

TEST(Svg, TransformsFollowEachOther) {
    const Folder folder;
    const auto end_of = [&](const std::string& transform) {
        const Read curves = read_svg(folder, "<g transform='" + transform + "'><path d='M0 0 1 0'/></g>");
        EXPECT_EQ(curves.result, FLG_OK) << curves.error;
        const Floats& p = curves.positions();
        return std::pair(std::round(p[3] * 1e4) / 1e4, std::round(-p[4] * 1e4) / 1e4 + 0.0);
    };
    EXPECT_EQ(end_of("translate(2 3)"), (std::pair(3.0, 3.0)));
    EXPECT_EQ(end_of("translate(2)"), (std::pair(3.0, 0.0)));
    EXPECT_EQ(end_of("scale(2,5)"), (std::pair(2.0, 0.0)));
    EXPECT_EQ(end_of("rotate(90)"), (std::pair(0.0, 1.0)));
    EXPECT_EQ(end_of("rotate(90, 1, 1)"), (std::pair(2.0, 1.0)));
    EXPECT_EQ(end_of("matrix(0 2 -2 0 7 8)"), (std::pair(7.0, 10.0)));
    EXPECT_EQ(end_of("skewY(45)"), (std::pair(1.0, 1.0)));
    EXPECT_EQ(end_of("translate(2 3),scale(2) rotate(90)"), (std::pair(2.0, 5.0)));
    const Read nested =
        read_svg(folder, "<g transform='scale(2)'><g transform='translate(1 0)'><path d='M0 0 1 0'/></g></g>");
    EXPECT_EQ(nested.positions()[3], 4.0f);
}

TEST(Svg, PassesOverWhatIsNotDrawn) {
    const Folder folder;
    const Read curves = read(folder.put(
        "a.svg",
        "\xef\xbb\xbf<?xml version='1.0'?>\n<!DOCTYPE svg>\n<!-- <path d='M0 0 9 9'/> -->\n"
        "<svg:svg><title>a > b</title><defs><path d='M0 0 1 1'/></defs><use href='#x'/><style><![CDATA[<a>]]></style>"
        "<path d=\"M0 0 2 2\" fill = 'red'></path></svg:svg>"));
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    EXPECT_EQ(curves.positions(), (Floats{0, 0, 0, 2, -2, 0}));
    EXPECT_EQ(curves.warnings,
              "1 element: what it uses is not in the file, or has a view of its own (first: element 4)\n");
}

// What is kept in defs is drawn where it is used, moved and turned, as often as it is.
TEST(Svg, DrawsWhatElementsUse) {
    const Folder folder;
    const Read curves = read_svg(folder,
                                 "<defs><path id='leg' d='M0 0 1 2'/><g id='pair'><use xlink:href='#leg'/>"
                                 "<use href='#leg' x='5' transform='scale(2)'/></g></defs>"
                                 "<use href='#pair' y='10'/><use href='#leg'/>"
                                 "<symbol id='eye'><path d='M0 0 3 0'/></symbol><use href='#eye' x='1' y='1'/>");
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    EXPECT_EQ(curves.positions(), (Floats{0, -10, 0, 1, -12, 0, 10, -10, 0, 12, -14, 0,  //
                                          0, 0,   0, 1, -2,  0, 1,  -1,  0, 4,  -1,  0}));
    EXPECT_EQ(curves.warnings, "");
    const Read viewed = read_svg(folder,
                                 "<symbol id='eye' viewBox='0 0 9 9'><path d='M0 0 3 0'/></symbol>"
                                 "<use href='#eye'/><path d='M0 0 1 0'/>");
    EXPECT_EQ(viewed.warnings,
              "1 element: what it uses is not in the file, or has a view of its own (first: element 3)\n");
    expect_refused(folder.put("a.svg", "<svg>\n<g id='a'><use href='#a'/></g></svg>"), FLG_ERROR_LIMIT, "2",
                   "use each other more than 16 deep");
    // Ten uses in ten uses in ten.
    std::string laughs = "<svg>\n<g id='a0'><g/></g>";
    for (int i = 1; i < 9; ++i) {
        laughs += "<g id='a" + std::to_string(i) + "'>";
        for (int k = 0; k < 10; ++k) laughs += "<use href='#a" + std::to_string(i - 1) + "'/>";
        laughs += "</g>";
    }
    expect_refused(folder.put("b.svg", laughs + "</svg>"), FLG_ERROR_LIMIT, "2", "more than 2^20 elements");
}

TEST(Svg, PassesOverWhatIsHidden) {
    const Folder folder;
    const Read curves = read_svg(folder,
                                 "<path display='none' d='M0 0 1 1'/><g style='fill: red; display:none'><path d='M0 0 "
                                 "1 1' display='inline'/></g><g visibility='hidden'><path d='M0 0 1 1'/><path "
                                 "style='visibility:visible' d='M0 0 2 2'/></g>");
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    EXPECT_EQ(curves.positions(), (Floats{0, 0, 0, 2, -2, 0}));
}

TEST(Svg, RefusesWithTheLine) {
    const Folder folder;
    const auto refuse = [&](const std::string& elements, const char* reason, FlgResult result = FLG_ERROR_FORMAT) {
        expect_refused(folder.put("a.svg", "<svg>\n" + elements + "</svg>"), result, "2", reason);
    };
    refuse("<path d='M0 0 X'/>", "no command of paths: 'X'");
    refuse("<path d='L0 0'/>", "does not begin with M");
    refuse("<path d='M0'/>", "no number");
    refuse("<path d='M0 0L1 nan'/>", "no number, or one beyond 1e30: 'nan'");
    refuse("<path d='M0 0L1 -inf'/>", "beyond 1e30: '-inf'");
    refuse("<path d='M0 0L1 1e31'/>", "beyond 1e30: '1e31'");
    refuse("<path d='M0 0L1 1e999'/>", "beyond 1e30: '1e999'");
    refuse("<path d='M0 0zz 1 2'/>", "numbers without a command: '1 2'");
    refuse("<path d='M0 0A1 1 0 2 0 1 1'/>", "no number, or one beyond 1e30: '2 0 1 1'");
    refuse("<polygon points='0 0 1'/>", "no number");
    refuse("<circle r='1mm'/>", "'r' is in other units than px: '1mm'");
    refuse("<g transform='wobble(1)'><path d='M0 0 1 1'/></g>", "no transform, or not so many numbers: 'wobble'");
    refuse("<g transform='scale(1 2 3)'/>", "'scale'");
    refuse("<g transform='scale(1'/>", "does not end: 'scale'");
    refuse("<g transform='scale'/>", "no transform: 'scale'");
    refuse("<g transform='scale(1e20)'><g transform='scale(1e20)'><path d='M0 0 1 1'/></g></g>", "beyond 1e30");
    refuse("<g></a>", "closes another element than the last: 'a'");
    refuse("<path d=M0/>", "the attribute 'd' has no value in quotes");
    refuse("<path d/>", "or an attribute has no value");
    refuse("<!-- ", "'<!--' does not end");
    std::string deep;
    for (int i = 0; i < 300; ++i) deep += "<g>";
    refuse(deep, "more than 256 deep", FLG_ERROR_LIMIT);
    expect_refused(folder.put("a.svg", "<html>"), FLG_ERROR_FORMAT, "1", "the first element is not svg: 'html'");
    expect_refused(folder.put("a.svg", ""), FLG_ERROR_FORMAT, "", "the file has no svg element");
    expect_refused(folder.put("a.svg", "<svg/>"), FLG_ERROR_FORMAT, "", "the drawing has no outlines");
    expect_refused(folder.put("a.svg", "<svg><path d='M0 0 1 1'/>"), FLG_ERROR_FORMAT, "1", "an element is not closed");
}

}  // namespace
}  // namespace flg::test
