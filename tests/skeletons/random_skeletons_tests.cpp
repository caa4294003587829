// SPDX-License-Identifier: MIT
// All invariants on contours of many kinds. FLG_SKELETON_ROUNDS in the environment multiplies how many; failures name
// their seeds.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "core/random.h"
#include "skeletons/random_contours.h"

namespace flg::test {
namespace {

uint64_t rounds() {
    const char* text = std::getenv("FLG_SKELETON_ROUNDS");
    return text ? std::strtoull(text, nullptr, 10) : 1;
}

// Contours of more points are simple as they are drawn: trying all pairs would take longer than all else.
constexpr size_t max_tried = 1600;

// Simple, and not as thin as a line.
bool all_simple(const Rings& rings) {
    for (const auto& ring : rings) {
        double twice = 0;
        for (size_t i = 0; i < ring.size(); ++i) {
            const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            twice += (a.x - ring[0].x) * (b.y - ring[0].y) - (a.y - ring[0].y) * (b.x - ring[0].x);
        }
        if (!is_simple(ring) || std::fabs(twice) < 1e-6) return false;
    }
    return true;
}

// Seeds from 0; contours that touch themselves are left out. `max_perturbed` of the others may have skeletons only
// once their points were moved; each has one.
void check_all(const char* kind, uint64_t count, const std::function<Rings(uint64_t)>& draw, double tolerance = 1e-9,
               uint64_t max_perturbed = 0) {
    uint64_t checked = 0, perturbed = 0, wrong = 0;
    for (uint64_t seed = 0; seed < count * rounds(); ++seed) {
        const Rings rings = draw(seed);
        if (rings[0].size() < max_tried && !all_simple(rings)) continue;
        ++checked;
        const Contour contour = contour_of(rings);
        std::string broken, skeleton_note;
        try {
            const StraightSkeleton skeleton = skeleton_of(contour);
            perturbed += skeleton.perturbation > 0;
            skeleton_note = std::to_string(skeleton.perturbation * 1e9);
            broken = joined(broken_invariants(contour, skeleton, skeleton.perturbation > 0 ? 1e-6 : tolerance));
        } catch (const Failure& failure) {
            broken = failure.what();
        }
        if (!broken.empty() && ++wrong <= 5)
            ADD_FAILURE() << kind << ", seed " << seed << ", " << contour.size() << " points: " << broken
                          << " perturbation " << skeleton_note;
    }
    EXPECT_EQ(wrong, 0u) << kind << " of " << checked;
    EXPECT_GE(checked, count * rounds() / 4) << kind;
    EXPECT_LE(perturbed, max_perturbed * rounds()) << kind;
    testing::Test::RecordProperty(kind, static_cast<int>(checked));
    if (rounds() > 1)
        std::printf("%s: %llu checked, %llu perturbed\n", kind, (unsigned long long)checked,
                    (unsigned long long)perturbed);
}

uint32_t size_of(uint64_t seed, uint32_t least, uint32_t most) {
    const double share = random_unit(seed, 99, 0);
    return least + static_cast<uint32_t>((most - least) * share * share);
}

TEST(RandomSkeletons, Stars) {
    check_all("stars", 400, [](uint64_t seed) { return random_star(seed, size_of(seed, 3, 120)); });
}

TEST(RandomSkeletons, Tours) {
    check_all("tours", 400, [](uint64_t seed) { return random_tour(seed, size_of(seed, 3, 60)); });
}

TEST(RandomSkeletons, Grids) {
    check_all("grids", 600, [](uint64_t seed) { return grid_tour(seed, size_of(seed, 4, 40), 4 + seed % 7); });
}

TEST(RandomSkeletons, RotatedGrids) {
    check_all("rotated grids", 600, [](uint64_t seed) {
        return rotated(grid_tour(seed, size_of(seed, 4, 40), 4 + seed % 7), random_unit(seed, 0, 50),
                       0.3 + random_unit(seed, 1, 50), {random_unit(seed, 2, 50), 0});
    });
}

TEST(RandomSkeletons, JitteredGrids) {
    for (const double reach : {1e-13, 1e-11, 1e-9, 1e-6}) {
        check_all(
            "jittered grids", 300,
            [&](uint64_t seed) { return jittered(grid_tour(seed, size_of(seed, 4, 40), 4 + seed % 7), seed, reach); },
            1e-6, 3);
    }
}

TEST(RandomSkeletons, Pixels) {
    check_all("pixels", 300, [](uint64_t seed) { return pixel_shape(seed, 3 + seed % 9, seed % 2 != 0); });
}

TEST(RandomSkeletons, RotatedPixels) {
    check_all("rotated pixels", 300, [](uint64_t seed) {
        return rotated(pixel_shape(seed, 3 + seed % 9, seed % 2 != 0),
                       seed % 3 == 0 ? std::atan(1) : random_unit(seed, 0, 50));
    });
}

// Edges that are nearly on one line, and nearly face to face.
TEST(RandomSkeletons, JitteredPixels) {
    for (const double reach : {1e-13, 1e-11, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5}) {
        check_all(
            "jittered pixels", 60,
            [&](uint64_t seed) { return jittered(pixel_shape(seed, 3 + seed % 12, seed % 4 != 0), seed, reach); }, 1e-6,
            12);
    }
}

TEST(RandomSkeletons, Holes) {
    check_all("holes", 100,
              [](uint64_t seed) { return star_with_holes(seed, size_of(seed, 8, 60), 1 + seed % 4, 3 + seed % 6); });
}

// Of up to 3,000 points, simple as they are drawn.
TEST(RandomSkeletons, LargeOnes) {
    check_all("large", 16, [](uint64_t seed) {
        const uint32_t n = size_of(seed, 200, 3000);
        const double angle = random_unit(seed, 0, 50);
        switch (seed % 8) {
            case 0: return random_star(seed, n);
            case 1: return pixel_shape(seed, 12 + n / 100, false);
            case 2: return rotated(pixel_shape(seed, 12 + n / 100, true), angle);
            case 3: return rotated(even_star(n / 2, 0.3 + 0.5 * angle), angle);
            case 4: return gear(n / 4);
            case 5: return rotated(comb(n / 4, 0), angle);
            case 6: return rotated(staircase(n / 2), angle);
            default: return star_with_holes(seed, n / 2, 8, n / 130 + 3);
        }
    });
}

TEST(RandomSkeletons, LargeJitteredOnes) {
    check_all(
        "large jittered", 8,
        [](uint64_t seed) {
            const uint32_t n = size_of(seed, 200, 3000);
            if (seed % 2 == 0) return jittered(rotated(comb(n / 4, 0.001), random_unit(seed, 0, 50)), seed, 1e-4);
            return jittered(pixel_shape(seed, 12 + n / 100, true), seed, 1e-9);
        },
        1e-6, 2);
}

TEST(RandomSkeletons, ShapesThatChangeEverywhereAtOnce) {
    check_all("alike", 60, [](uint64_t seed) {
        const auto n = static_cast<uint32_t>(2 + seed / 6);
        const double angle = seed % 2 == 0 ? 0 : 0.3;
        switch (seed % 6) {
            case 0:
            case 1: return rotated(comb(n, 0), angle);
            case 2: return gear(n + 1);
            case 3: return even_star(n + 1, 0.2 + 0.07 * static_cast<double>(seed % 9));
            case 4: return rotated(spiral(4 * n + 4), angle);
            default: return rotated(staircase(n), angle);
        }
    });
}

}  // namespace
}  // namespace flg::test
