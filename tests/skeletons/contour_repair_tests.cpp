// SPDX-License-Identifier: MIT
#include "skeletons/contour_repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/random.h"
#include "runtime/run_now.h"
#include "skeletons/random_contours.h"

namespace flg::test {
namespace {

Contour repaired(const Rings& rings, bool haltingly = false) {
    std::vector<Point2> points;
    std::vector<uint32_t> offsets = {0};
    for (const auto& ring : rings) {
        points.insert(points.end(), ring.begin(), ring.end());
        offsets.push_back(static_cast<uint32_t>(points.size()));
    }
    const Contour drawn = gather_contour(points, offsets, std::pmr::new_delete_resource());
    return run_now(
        std::pmr::new_delete_resource(), [&](Pace& pace) { return repair_contour(pace, drawn); }, haltingly);
}

double area_of(const Contour& contour) {
    double twice = 0;
    for (uint32_t i = 0; i < contour.size(); ++i) {
        const Point2 &a = contour.points[i], &b = contour.points[contour.next(i)], &o = contour.points[0];
        twice += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
    }
    return twice / 2;
}

// Simple: its skeleton is made, with all invariants.
void expect_skeleton(const Contour& contour, const std::string& of) {
    try {
        const StraightSkeleton skeleton = skeleton_of(contour);
        EXPECT_EQ(joined(broken_invariants(contour, skeleton, skeleton.residual > 1e-10 ? 1e-6 : 1e-9)), "") << of;
    } catch (const Failure& failure) {
        ADD_FAILURE() << of << ": " << failure.what();
    }
}

int winding(const std::vector<Point2>& ring, const Point2& p) {
    int turns = 0;
    for (size_t i = 0; i < ring.size(); ++i) {
        const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        const int side = orientation(a, b, p);
        turns += b.y > p.y ? (side > 0) : -(side < 0);
    }
    return turns;
}

bool is_inside(const Rings& rings, const Point2& p) {
    int holes = 0;
    for (size_t r = 1; r < rings.size(); ++r) holes += winding(rings[r], p) != 0;
    return winding(rings[0], p) != 0 && holes == 0;
}

constexpr size_t picture_width = 150;

Point2 pixel(size_t i) {
    return {(double(i % picture_width) + 0.3719) / picture_width, (double(i / picture_width) + 0.6138) / picture_width};
}

size_t drawn_pixels(const Rings& rings) {
    size_t count = 0;
    for (size_t i = 0; i < picture_width * picture_width; ++i) count += is_inside(rings, pixel(i));
    return count;
}

// In pixels: what is inside of the result winds around in the drawing; where it ends the region does, but
// where it is thinner than a pixel.
void expect_same_region(const Contour& contour, const Rings& rings, uint64_t seed) {
    Rings result;
    for (uint32_t r = 0; r < contour.ring_count(); ++r)
        result.push_back(
            {contour.points.begin() + contour.offsets[r], contour.points.begin() + contour.offsets[r + 1]});
    std::vector<uint8_t> is_drawn(picture_width * picture_width), is_kept(picture_width * picture_width);
    size_t kept = 0, wrong = 0, torn = 0;
    for (size_t i = 0; i < picture_width * picture_width; ++i) {
        const Point2 p = pixel(i);
        is_drawn[i] = is_inside(rings, p);
        is_kept[i] = is_inside(result, p);
        kept += is_kept[i];
        wrong += is_kept[i] && !is_drawn[i];
        for (const size_t before : {i % picture_width > 0 ? i - 1 : i, i >= picture_width ? i - picture_width : i})
            torn += is_drawn[i] && is_drawn[before] && is_kept[i] != is_kept[before];
    }
    EXPECT_EQ(wrong, 0u) << seed;
    EXPECT_LE(torn, 5 + kept / 50) << seed;
}

const std::vector<Point2> square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};

std::vector<Point2> box(double x, double y, double width) {
    return {{x, y}, {x, y + width}, {x + width, y + width}, {x + width, y}};
}

TEST(ContourRepair, SimpleContoursStayToTheBit) {
    for (uint64_t seed = 0; seed < 60; ++seed) {
        const Rings rings = seed % 3 == 0   ? random_tour(seed, 40)
                            : seed % 3 == 1 ? star_with_holes(seed, 24, 3, 6)
                                            : pixel_shape(seed, 9, true);
        const Contour was = contour_of(rings), is = repaired(rings);
        ASSERT_EQ(is.size(), was.size()) << seed;
        ASSERT_EQ(is.ring_count(), was.ring_count()) << seed;
        std::vector<std::pair<double, double>> a, b;
        for (uint32_t i = 0; i < was.size(); ++i) {
            a.push_back({was.points[i].x, was.points[i].y});
            b.push_back({is.points[i].x, is.points[i].y});
        }
        std::sort(a.begin(), a.end());
        std::sort(b.begin(), b.end());
        EXPECT_EQ(a, b) << seed;
    }
}

TEST(ContourRepair, OfAFigureOfEightTheLargerLobe) {
    const Contour contour = repaired({{{0, 0}, {4, 4}, {4, 0}, {0, 2}}});
    ASSERT_EQ(contour.size(), 3u);
    EXPECT_NEAR(area_of(contour), 0.5 * 4 * (4 - 4.0 / 3), 1e-6);
    uint32_t crossings = 0;
    for (const uint32_t point : contour.input_points) crossings += point == no_input_point;
    EXPECT_EQ(crossings, 1u);
    expect_skeleton(contour, "eight");
}

// The middle of a pentagram is wound around twice.
TEST(ContourRepair, APentagramIsAStar) {
    std::vector<Point2> ring;
    for (int i = 0; i < 5; ++i) ring.push_back({std::sin(4 * M_PI * i / 5), std::cos(4 * M_PI * i / 5)});
    for (const bool turned : {false, true}) {
        if (turned) std::reverse(ring.begin(), ring.end());
        const Contour contour = repaired({ring});
        EXPECT_EQ(contour.size(), 10u);
        EXPECT_EQ(contour.ring_count(), 1u);
        const double side = std::sqrt(5 - 2 * std::sqrt(5));  // of its outline, by its height
        EXPECT_NEAR(area_of(contour), 5 * std::sin(M_PI / 5) * std::sin(M_PI / 10) / std::sin(7 * M_PI / 10), 1e-6)
            << side;
        expect_skeleton(contour, "pentagram");
    }
}

TEST(ContourRepair, SpikesGo) {
    const Contour contour = repaired({{{0, 0}, {10, 0}, {10, 10}, {10, 15}, {10, 10}, {0, 10}, {-5, 10}, {0, 10}}});
    EXPECT_NEAR(area_of(contour), 100, 1e-5);
    expect_skeleton(contour, "spikes");
}

TEST(ContourRepair, HolesThatMeet) {
    // Two that overlap, one over the border, one outside, one in another.
    const Contour overlap = repaired({square, box(2, 2, 3), box(4, 4, 3)});
    EXPECT_EQ(overlap.ring_count(), 2u);
    EXPECT_NEAR(area_of(overlap), 100 - 9 - 9 + 1, 1e-5);
    expect_skeleton(overlap, "overlap");
    const Contour bay = repaired({square, box(8, 4, 4)});
    EXPECT_EQ(bay.ring_count(), 1u);
    EXPECT_NEAR(area_of(bay), 100 - 8, 1e-5);
    expect_skeleton(bay, "bay");
    EXPECT_EQ(repaired({square, box(20, 2, 3)}).size(), 4u);
    EXPECT_NEAR(area_of(repaired({square, box(2, 2, 6), box(3, 3, 2)})), 100 - 36, 1e-5);
}

// Holes that touch in a point, and the border: parted by little.
TEST(ContourRepair, TouchingHolesArePartedOrJoined) {
    const Contour two = repaired({square, box(2, 2, 3), box(5, 5, 2)});
    EXPECT_NEAR(area_of(two), 100 - 9 - 4, 1e-4);
    expect_skeleton(two, "two holes");
    const Contour border = repaired({square, {{0, 5}, {3, 7}, {3, 3}}});
    EXPECT_NEAR(area_of(border), 100 - 6, 1e-4);
    EXPECT_EQ(border.ring_count(), 1u);
    expect_skeleton(border, "border");
    const Contour side = repaired({square, box(0, 2, 3)});
    EXPECT_NEAR(area_of(side), 100 - 9, 1e-5);
    expect_skeleton(side, "side");
}

TEST(ContourRepair, AStrokeThatRunsOverItself) {
    // Twice around, the second time a bit further out: all of it is wound around.
    std::vector<Point2> ring;
    for (int i = 0; i < 200; ++i) {
        const double angle = 4 * M_PI * i / 200, radius = 1 + 0.1 * i / 200;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const Contour contour = repaired({ring});
    EXPECT_EQ(contour.ring_count(), 1u);
    EXPECT_GT(area_of(contour), M_PI);
    expect_skeleton(contour, "stroke");
}

TEST(ContourRepair, NothingIsRefused) {
    for (const Rings& rings :
         {Rings{{{0, 0}, {1, 1}, {2, 2}}}, Rings{{{0, 0}, {1, 0}, {1, 1}, {1, 0}}}, Rings{square, square}}) {
        try {
            repaired(rings);
            ADD_FAILURE() << "something is left";
        } catch (const Failure& failure) {
            EXPECT_EQ(failure.result(), FLG_ERROR_INVALID_ARGUMENT);
            EXPECT_STREQ(failure.what(), "contour: its rings go around nothing that has an area");
        }
    }
}

// Points anywhere, also on grids: against pixels.
TEST(ContourRepair, ClosedWaysAnywhere) {
    const char* text = std::getenv("FLG_SKELETON_ROUNDS");
    const uint64_t rounds = text ? std::strtoull(text, nullptr, 10) : 1;
    for (uint64_t seed = 0; seed < 150 * rounds; ++seed) {
        Rings rings(1 + seed % 3);
        for (size_t r = 0; r < rings.size(); ++r) {
            const uint32_t n = 4 + random_below(seed, r, 9, r == 0 ? 30 : 6), grid = seed % 2 == 0 ? 8 : 1 << 20;
            for (uint32_t i = 0; i < n; ++i)
                rings[r].push_back({random_below(seed, 100 * r + i, 0, grid) / double(grid),
                                    random_below(seed, 100 * r + i, 1, grid) / double(grid)});
        }
        Contour contour(std::pmr::new_delete_resource());
        try {
            contour = repaired(rings);
        } catch (const Failure& failure) {
            EXPECT_EQ(drawn_pixels(rings), 0u) << seed << ": " << failure.what();
            continue;
        }
        expect_skeleton(contour, "seed " + std::to_string(seed));
        if (seed < 150) expect_same_region(contour, rings, seed);
    }
}

TEST(ContourRepair, SlicesDoNotMatter) {
    std::vector<Point2> ring;
    for (uint32_t i = 0; i < 40; ++i) ring.push_back({random_unit(7, i, 0), random_unit(7, i, 1)});
    const Contour one = repaired({ring}), other = repaired({ring}, true);
    EXPECT_GT(one.size(), 40u);
    EXPECT_EQ(one.points, other.points);
    EXPECT_EQ(one.input_points, other.input_points);
    EXPECT_EQ(one.offsets, other.offsets);
}

// Counts what is taken and given back.
class CountedMemory final : public Memory {
public:
    uint32_t calls = 0;

private:
    void* do_allocate(size_t size, size_t alignment) override {
        ++calls;
        return std::pmr::new_delete_resource()->allocate(size, alignment);
    }
    void do_deallocate(void* block, size_t size, size_t alignment) override {
        ++calls;
        std::pmr::new_delete_resource()->deallocate(block, size, alignment);
    }
    bool do_is_equal(const Memory& other) const noexcept override { return this == &other; }
};

// Some 5,000 crossings, as many cuts of an edge as there are corners. A thousand calls of an allocator are 100 us.
TEST(ContourRepair, NoSliceTakesOrGivesBackMuchMemoryAtOnce) {
    constexpr uint32_t corners = 101, step = 50;
    std::vector<Point2> points;
    for (uint32_t i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * (i * step % corners) / corners;
        points.push_back({std::cos(angle), std::sin(angle)});
    }
    const std::vector<uint32_t> offsets = {0, corners};
    const Contour drawn = gather_contour(points, offsets, std::pmr::new_delete_resource());
    CountedMemory memory;
    uint32_t most = 0, slices = 0;
    const Contour whole = run_haltingly(
        &memory, [&](Pace& pace) { return repair_contour(pace, drawn); },
        [&](const auto& slice) {
            const uint32_t before = memory.calls;
            slice();
            most = std::max(most, memory.calls - before);
            ++slices;
        });
    EXPECT_LT(most, 1'000u);
    EXPECT_GT(slices, 1'000u);
    // The largest piece is all of it: its outer corners, and between each two the point where their edges cross.
    EXPECT_EQ(whole.size(), 2 * corners);
    EXPECT_EQ(whole.ring_count(), 1u);
}

}  // namespace
}  // namespace flg::test
