// SPDX-License-Identifier: MIT
// Curves that grow show what an upload of all of their points shows, for the price of the new ones.
#include <array>
#include <random>

#include "curves.h"

namespace flg::render::test {
namespace {

constexpr uint32_t sides = 160;

// The points of `all` from `first` on, as a live stroke hands them out.
struct Piece {
    std::vector<FlgColumn> columns;
    std::array<uint32_t, 2> offsets{};
    FlgCurveSetView view{};

    Piece(Curves& all, uint32_t first, uint32_t count) : offsets{0, count} {
        view = all.view();
        columns.assign(view.columns, view.columns + view.column_count);
        for (FlgColumn& column : columns)
            column.data = static_cast<const float*>(column.data) + first * column.components;
        view.curve_count = 1;
        view.curve_offsets = offsets.data();
        view.curve_flags = nullptr;
        view.columns = columns.data();
    }
};

uint32_t point_count(const Curves& curves) {
    return static_cast<uint32_t>(curves.positions.size() / 3);
}

// Winds along x and stays in sight; some points come twice.
Curves winding(uint32_t points) {
    Curves curves;
    std::mt19937 random(7);
    for (uint32_t i = 0; i < points; ++i) {
        if (i > 0 && random() % 16 == 0) {
            const std::vector<float> last(curves.positions.end() - 3, curves.positions.end());
            curves.positions.insert(curves.positions.end(), last.begin(), last.end());
        } else {
            const float t = static_cast<float>(i) / static_cast<float>(points);
            curves.add({t - 0.5f, 0.3f * std::sin(40 * t), 0.3f * std::cos(31 * t)});
        }
        curves.radii.push_back(0.01f + 0.01f * std::sin(0.1f * static_cast<float>(i)));
    }
    curves.end();
    return curves;
}

// The first normals lie along the curve and say nothing; others are leant, or on the other side.
void give_normals(Curves& curves, uint32_t silent) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> number(-1, 1);
    for (uint32_t i = 0; i < point_count(curves); ++i) {
        const bool says = i >= silent && random() % 4 != 0;
        for (int k = 0; k < 3; ++k) curves.normals.push_back(says ? number(random) : 0.0f);
    }
}

CurveLook plain(Shape shape) {
    return {.shape = shape, .color_end = CurveLook{}.color};
}

class GrowingTest : public RendererTest {
protected:
    void SetUp() override {
        without_ground();
        other.set_scene(renderer.scene());
    }
    void TearDown() override {
        RendererTest::TearDown();
        expect_silence(other);
    }
    // By another renderer, in which it stays until the next.
    Image whole(Curves& curves, uint32_t points, const CurveLook& look) {
        other.clear();
        other.upload(Piece(curves, 0, points).view, look);
        other.draw(other_target, front_camera());
        return other.capture(other_target);
    }
    // In pieces of random length; frames are drawn in between, or not.
    void append(CurvesId id, Curves& curves, uint32_t first, uint32_t last, uint32_t seed) {
        std::mt19937 random(seed);
        while (first < last) {
            const uint32_t count = std::min(static_cast<uint32_t>(random() % 90), last - first);
            renderer.append(id, Piece(curves, first, count).view);
            first += count;
            if (random() % 3 == 0) renderer.draw(target, front_camera());
        }
    }
    Target target{renderer, sides, sides};
    Renderer other{options()};
    Target other_target{other, sides, sides};
};

TEST_F(GrowingTest, ShowsWhatAnUploadOfAllShows) {
    const uint32_t points = 700;
    for (const bool with_normals : {false, true}) {
        Curves curves = winding(points);
        if (with_normals) give_normals(curves, 200);
        for (const Shape shape : {Shape::ribbon, Shape::tube, Shape::line}) {
            const Image expected = whole(curves, points, plain(shape));
            for (uint32_t seed = 0; seed < 4; ++seed) {
                const CurvesId id = renderer.begin_growing(plain(shape), points);
                append(id, curves, 0, points, seed);
                EXPECT_EQ(differing_pixels(picture(target), expected), 0u)
                    << "shape " << static_cast<int>(shape) << ", normals " << with_normals << ", seed " << seed;
                renderer.remove(id);
            }
        }
    }
}

TEST_F(GrowingTest, EachFrameShowsThePointsSoFar) {
    Curves curves = winding(140);
    give_normals(curves, 3);
    const CurvesId id = renderer.begin_growing(plain(Shape::ribbon), 140);
    for (uint32_t points = 0; points < 140; ++points) {
        const Image expected = whole(curves, points, plain(Shape::ribbon));
        ASSERT_EQ(differing_pixels(picture(target), expected), 0u) << points << " points";
        EXPECT_EQ(renderer.bounds().min, other.bounds().min);
        EXPECT_EQ(renderer.bounds().max, other.bounds().max);
        renderer.append(id, Piece(curves, points, 1).view);
    }
}

TEST_F(GrowingTest, PointsTakenOffLeaveNoTrace) {
    const uint32_t points = 500;
    Curves curves = winding(points);
    give_normals(curves, 100);
    for (const Shape shape : {Shape::ribbon, Shape::tube}) {
        const CurvesId id = renderer.begin_growing(plain(shape), points);
        append(id, curves, 0, points, 1);
        for (const uint32_t left : {499u, 450u, 449u, 257u, 130u, 101u, 100u, 99u, 65u, 64u, 2u, 1u, 0u}) {
            renderer.truncate(id, left);
            const Image expected = whole(curves, left, plain(shape));
            EXPECT_EQ(differing_pixels(picture(target), expected), 0u) << left << " left";
        }
        append(id, curves, 0, points, 2);
        const Image grown = picture(target);
        renderer.remove(id);
        EXPECT_EQ(differing_pixels(grown, whole(curves, points, plain(shape))), 0u);
    }
}

TEST_F(GrowingTest, UploadsTheNewPointsAlone) {
    const uint32_t points = 100'000;
    Curves curves = winding(points);
    give_normals(curves, 0);
    const CurvesId id = renderer.begin_growing({}, points);
    picture(target);
    const uint64_t held = renderer.stats().device_bytes;
    uint64_t least = ~0ull, most = 0, all = 0;
    uint32_t appended = 0;
    const auto grow = [&](uint32_t count) {
        renderer.append(id, Piece(curves, appended, count).view);
        appended += count;
        renderer.draw(target, front_camera());
        all += renderer.stats().uploaded_bytes;
        return renderer.stats().uploaded_bytes;
    };
    grow(10);
    for (const uint32_t length : {10u, 100u, 1'000u, 10'000u, 50'000u, points - 60}) {
        while (appended < length) grow(std::min(length - appended, 900u));
        for (int i = 0; i < 10; ++i) {
            const uint64_t bytes = grow(5);
            least = std::min(least, bytes);
            most = std::max(most, bytes);
        }
    }
    // Five points and the one before at 24 bytes, a chunk's record, or two; repeated points don't count.
    EXPECT_LE(most, 6 * 24 + 2 * 16u);
    EXPECT_GE(least, 2 * 24 + 16u);
    EXPECT_LT(all, 26ull * points);
    EXPECT_LE(renderer.stats().device_bytes, held + (8 << 20)) << "staging, taken once";
    renderer.draw(target, front_camera());
    EXPECT_EQ(renderer.stats().uploaded_bytes, 0u);
}

TEST_F(GrowingTest, RefusesWhatItCannotTakeAndStaysAsItWas) {
    Curves curves = winding(100);
    const CurvesId id = renderer.begin_growing(plain(Shape::tube), 100);
    renderer.append(id, Piece(curves, 0, 60).view);
    const Image before = picture(target);
    expect_error([&] { renderer.append(id, Piece(curves, 0, 41).view); },
                 "60 points; 41 more are beyond its capacity, 100");
    expect_error([&] { renderer.truncate(id, 61); }, "61 can't be left");
    Curves broken = winding(5);
    broken.positions[14] = std::nanf("");
    expect_error([&] { renderer.append(id, broken.view()); }, "Point 4");
    Curves two = winding(5);
    two.add({9, 9, 9});
    two.radii.push_back(1);
    two.end();
    expect_error([&] { renderer.append(id, two.view()); }, "2 curves");
    expect_error([&] { renderer.set_magnitude_offset(id, 1.0f); }, "DISPLACEMENT");
    expect_error([&] { renderer.append({77}, curves.view()); }, "no curves with the id 77");
    expect_error([&] { renderer.begin_growing({}, 1); }, "capacity is 1");
    expect_error([&] { renderer.begin_growing({}, (1u << 22) + 1); }, "capacity is 4194305");
    expect_error([&] { renderer.begin_growing({.radius = -1}, 10); }, "radius");
    EXPECT_EQ(differing_pixels(picture(target), before), 0u);

    FlgCurveSetView nothing{};
    renderer.append(id, nothing);
    renderer.update(id, curves.view(), plain(Shape::tube));
    const Image replaced = picture(target);
    expect_error([&] { renderer.append(id, curves.view()); }, "do not grow");
    renderer.remove(id);
    EXPECT_EQ(differing_pixels(replaced, whole(curves, 100, plain(Shape::tube))), 0u);
}

}  // namespace
}  // namespace flg::render::test
