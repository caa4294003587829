// SPDX-License-Identifier: MIT
// samples/ogre_viewer as a user starts it, and what is to be seen in its pictures.
#include <gtest/gtest.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include "tools/program.h"

namespace flg::test {
namespace {

constexpr int kWidth = 400, kHeight = 225;

using Rgb = std::array<int, 3>;

struct Picture {
    std::unique_ptr<stbi_uc, decltype(&std::free)> pixels{nullptr, std::free};

    Rgb at(int x, int y) const {
        const stbi_uc* const p = pixels.get() + 3 * (y * kWidth + x);
        return {p[0], p[1], p[2]};
    }
};

Picture read(const std::string& path) {
    int width = 0, height = 0, channels = 0;
    Picture picture;
    picture.pixels.reset(stbi_load(path.c_str(), &width, &height, &channels, 3));
    if (width != kWidth || height != kHeight) picture.pixels.reset();
    return picture;
}

// Shares of the picture, from its upper left corner.
struct Area {
    double left, top, right, bottom;
};
constexpr Area kBouquet = {0.10, 0.0, 0.43, 0.38}, kVase = {0.18, 0.38, 0.40, 0.92},
               kFlourish = {0.44, 0.02, 0.85, 0.36}, kCat = {0.46, 0.54, 0.82, 0.99};

template <class Counts>
int count(const Area& area, Counts counts) {
    int found = 0;
    for (int y = static_cast<int>(area.top * kHeight); y < static_cast<int>(area.bottom * kHeight); ++y)
        for (int x = static_cast<int>(area.left * kWidth); x < static_cast<int>(area.right * kWidth); ++x)
            found += counts(x, y);
    return found;
}

int spread(const Rgb& c) {
    return std::max({c[0], c[1], c[2]}) - std::min({c[0], c[1], c[2]});
}

// Floor, air and shadows are grey.
int coloured(const Picture& picture, const Area& area) {
    return count(area, [&](int x, int y) { return spread(picture.at(x, y)) > 40; });
}

int changed(const Picture& a, const Picture& b, const Area& area) {
    return count(area, [&](int x, int y) {
        const Rgb p = a.at(x, y), q = b.at(x, y);
        return std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]) > 60;
    });
}

// Of the vase's glazes; pixels between two of them are neither.
struct Glaze {
    const char* name;
    bool (*is)(const Rgb& c);
};
constexpr Glaze kGlazes[] = {
    {"cream", [](const Rgb& c) { return c[0] > 180 && c[1] > 165 && c[2] > 130 && c[0] - c[2] > 18; }},
    {"blue", [](const Rgb& c) { return c[2] > 80 && c[2] - c[0] > 60; }},
    {"rust", [](const Rgb& c) { return c[0] > 110 && c[0] - c[1] > 70 && c[1] < 110; }},
    {"gold", [](const Rgb& c) { return c[0] > 150 && c[1] > 110 && c[1] - c[2] > 50; }},
    {"sage", [](const Rgb& c) { return c[1] - c[0] > 12 && c[1] - c[2] > 8; }},
};

Outcome view(const Folder& folder, const std::string& frames, const std::string& picture) {
    return run_program(FLG_OGRE_VIEWER_PROGRAM,
                       {"--frames", frames, "--rate", "15", "--width", std::to_string(kWidth), "--height",
                        std::to_string(kHeight), "--screenshot", picture},
                       folder.path());
}

void expect_nothing_said_but_the_report(const Outcome& outcome, const std::string& frames) {
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("until all was made, " + frames + " after that"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find(" 0 bytes left"), std::string::npos) << outcome.out;
    const size_t jobs = outcome.out.find("jobs: ");
    ASSERT_NE(jobs, std::string::npos) << outcome.out;
    EXPECT_GT(std::atoi(outcome.out.c_str() + jobs + 6), 20) << outcome.out;
}

TEST(OgreViewer, ShowsStrokesOrnamentAndAWalkingCatInOgresScene) {
    const Folder folder;
    const Outcome outcome = view(folder, "12", "early.png");
    if (!std::getenv("DISPLAY")) {  // tools/test starts one
        EXPECT_EQ(outcome.status, 1);
        EXPECT_NE(outcome.err.find("X display"), std::string::npos) << outcome.err;
        return;
    }
    expect_nothing_said_but_the_report(outcome, "12");
    expect_nothing_said_but_the_report(view(folder, "34", "late.png"), "34");
    const Picture early = read(folder / "early.png"), late = read(folder / "late.png");
    ASSERT_TRUE(early.pixels && late.pixels);

    EXPECT_GT(coloured(late, kBouquet), 600);
    EXPECT_GT(coloured(late, kVase), 2000);
    EXPECT_GT(coloured(late, kCat), 3000);
    for (const Glaze& glaze : kGlazes)
        EXPECT_GT(count(kVase, [&](int x, int y) { return glaze.is(late.at(x, y)); }), 100) << glaze.name;

    // The cat walks, the flourish grows, and what is done stays as it is.
    EXPECT_GT(changed(early, late, kCat), 300);
    EXPECT_GT(coloured(late, kFlourish), 1.5 * coloured(early, kFlourish));
    EXPECT_GT(coloured(early, kFlourish), 60);
    EXPECT_EQ(changed(early, late, kBouquet), 0);
}

TEST(OgreViewer, SaysWhatIsWrongWithItsArguments) {
    const Folder folder;
    EXPECT_NE(run_program(FLG_OGRE_VIEWER_PROGRAM, {"--rate", "0"}, folder.path()).status, 0);
}

}  // namespace
}  // namespace flg::test
