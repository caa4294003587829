// SPDX-License-Identifier: MIT
// Straight skeletons: of the parts of a drawn animal, and of stars of many points.
#include <cmath>
#include <numbers>

#include "bench/groups.h"
#include "core/random.h"
#include "skeletons/straight_skeleton.h"

namespace flg::bench {
namespace {

constexpr uint32_t kChunk = 25;
constexpr int kRuns = 15;

using Ring = std::vector<Point2>;

double skeleton_ms(const std::vector<Ring>& rings) {
    Memory* memory = std::pmr::new_delete_resource();
    std::vector<Contour> contours;
    for (const Ring& ring : rings) {
        const uint32_t offsets[] = {0, static_cast<uint32_t>(ring.size())};
        contours.push_back(clean_contour(ring, offsets, memory));
    }
    return median_ms(kRuns, [&] {
        return time_ms([&] {
            for (const Contour& contour : contours) {
                StraightSkeleton skeleton(memory);
                StraightSkeletonKernel kernel(contour, skeleton, memory);
                while (!kernel.run(kChunk)) continue;
            }
        });
    });
}

// A rounded blob with bumps: torso, head, four legs and a tail are such, some longer than others.
Ring part(uint32_t index, uint32_t n) {
    Ring ring;
    const double length = 1 + 0.6 * (index % 4), bend = 0.25 * (index % 3);
    for (uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        const double radius = 1 + 0.15 * std::sin(3 * angle + index) + 0.06 * std::sin(7 * angle + 2.0 * index);
        const double x = 100 * length * radius * std::cos(angle);
        ring.push_back({x, 60 * radius * std::sin(angle) + bend * x * x / 150});
    }
    return ring;
}

std::vector<Ring> parts(const uint32_t (&sizes)[7]) {
    std::vector<Ring> rings;
    for (uint32_t i = 0; i < 7; ++i) rings.push_back(part(i, sizes[i]));
    return rings;
}

Ring star(uint32_t n) {
    Ring ring;
    for (uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.8 * random_unit(n, i, 0)) / n,
                     radius = 0.2 + random_unit(n, i, 1);
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return ring;
}

}  // namespace

std::vector<Row> run_skeletons() {
    // As many points as the parts of a published cat have, drawn and simplified.
    return {below("straight skeletons: 7 parts of an animal, 125 points",
                  skeleton_ms(parts({27, 18, 18, 16, 16, 21, 9})), "ms", 0.15),
            below("straight skeletons: 7 parts as drawn, 1,688 points",
                  skeleton_ms(parts({300, 260, 270, 250, 255, 216, 137})), "ms", 4),
            below("straight skeleton: star of 15", skeleton_ms({star(15)}), "ms", 0.05),
            below("straight skeleton: star of 100", skeleton_ms({star(100)}), "ms", 0.2),
            below("straight skeleton: star of 1,000", skeleton_ms({star(1000)}), "ms", 4),
            below("straight skeleton: star of 3,000", skeleton_ms({star(3000)}), "ms", 20)};
}

}  // namespace flg::bench
