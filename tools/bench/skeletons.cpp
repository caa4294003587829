// SPDX-License-Identifier: MIT
// Straight skeletons: of the parts of a drawn animal, of stars of many points, and beside CGAL where it is installed
// (a peer under the GPL, for this table only).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/groups.h"
#if defined(FLG_WITH_CGAL)
#include "bench/cgal_skeleton.h"
#endif
#include "bench/outlines.h"
#include "bench/pool.h"
#include "core/random.h"
#include "runtime/run_now.h"
#include "skeletons/straight_skeleton.h"

namespace flg::bench {
namespace {

constexpr int kSkeletonRuns = 15, kChunkRounds = 4;

// Within one job.
Task<void> time_skeletons(Pace& pace, const std::vector<Contour>& contours, double& ms) {
    const double begin_ms = thread_ms();
    for (const Contour& contour : contours) {
        StraightSkeleton skeleton(pace.memory());
        co_await straight_skeleton(pace, contour, skeleton);
    }
    ms = thread_ms() - begin_ms;
}

double skeleton_ms(const std::vector<Ring>& rings, int runs = kSkeletonRuns) {
    Memory* memory = std::pmr::new_delete_resource();
    std::vector<Contour> contours;
    for (const Ring& ring : rings) {
        const uint32_t offsets[] = {0, static_cast<uint32_t>(ring.size())};
        contours.push_back(clean_contour(ring, offsets, memory));
    }
    return median_ms(runs, [&] {
        double ms = 0;
        run_now(memory, [&](Pace& pace) { return time_skeletons(pace, contours, ms); });
        return ms;
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

// Teeth of one length over a straight edge, turned: half of all changes come at one time, in triangles that are flat
// together.
Ring comb(uint32_t teeth, double angle) {
    Ring ring = {{0, 0}, {2.0 * teeth - 1, 0}};
    for (uint32_t i = teeth; i-- > 0;) {
        const double x = 2.0 * i;
        ring.insert(ring.end(), {{x + 1, 5}, {x, 5}});
        if (i > 0) ring.insert(ring.end(), {{x, 1}, {x - 1, 1}});
    }
    for (Point2& p : ring)
        p = {p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle)};
    return ring;
}

// All changes come at one time, in one place.
Ring regular(uint32_t n) {
    Ring ring;
    for (uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        ring.push_back({std::cos(angle), std::sin(angle)});
    }
    return ring;
}

// A host's pool, as the SDK's memory.
class PoolMemory final : public Memory {
public:
    explicit PoolMemory(Pool& pool) : hooks_(pool.hooks()) {}

private:
    void* do_allocate(size_t size, size_t alignment) override {
        return hooks_.allocate(hooks_.user_data, size, alignment);
    }
    void do_deallocate(void* memory, size_t size, size_t alignment) override {
        hooks_.free(hooks_.user_data, memory, size, alignment);
    }
    bool do_is_equal(const Memory& other) const noexcept override { return this == &other; }

    FlgAllocator hooks_;
};

// The longest of the chunks of one large skeleton, each the least of some rounds: what the machine does besides falls
// into another chunk each time.
double max_slice_us(const Ring& ring) {
    Pool pool;
    PoolMemory memory(pool);
    const uint32_t offsets[] = {0, static_cast<uint32_t>(ring.size())};
    const Contour contour = clean_contour(ring, offsets, &memory);
    std::vector<double> min_us;
    for (int round = 0; round < kChunkRounds; ++round) {
        StraightSkeleton skeleton(&memory);
        size_t chunk = 0;
        const auto time = [&](const auto& slice) {
            const double us = 1e3 * time_ms(slice);
            if (chunk == min_us.size()) min_us.push_back(us);
            min_us[chunk] = std::min(min_us[chunk], us);
            ++chunk;
        };
        run_haltingly(
            &memory, [&](Pace& pace) { return straight_skeleton(pace, contour, skeleton); }, time);
    }
    return *std::max_element(min_us.begin(), min_us.end());
}

#if defined(FLG_WITH_CGAL)
// How many times as long CGAL takes: the least ratio of all outlines of a class. Both take small ones again and again:
// the clock and a cold cache would take longer than either.
Row beside_cgal(const OutlineClass& outlines, double bar) {
    constexpr size_t points_a_timing = 3000;
    double least = HUGE_VAL;
    size_t least_points = 0;
    for (const Ring& ring : outlines.rings) {
        const size_t times = std::max<size_t>(1, points_a_timing / ring.size());
        const double own = skeleton_ms(std::vector<Ring>(times, ring));
        const double peer = median_ms(ring.size() < 100 ? 7 : 1, [&] {
            return time_ms([&] {
                for (size_t i = 0; i < times; ++i) cgal_skeleton(&ring.data()->x, static_cast<uint32_t>(ring.size()));
            });
        });
        if (peer / own >= least) continue;
        least = peer / own;
        least_points = ring.size();
    }
    return at_least(std::string("straight skeletons: beside CGAL, ") + outlines.name, least, "x", bar,
                    "the least of " + std::to_string(outlines.rings.size()) + " outlines, of " +
                        std::to_string(least_points) + " points");
}
#endif

}  // namespace

std::vector<Row> run_skeletons() {
    // As many points as the parts of a published cat have, drawn and simplified.
    std::vector<Row> rows = {
        below("straight skeletons: 7 parts of an animal, 125 points", skeleton_ms(parts({27, 18, 18, 16, 16, 21, 9})),
              "ms", 0.15),
        below("straight skeletons: 7 parts as drawn, 1,688 points",
              skeleton_ms(parts({300, 260, 270, 250, 255, 216, 137})), "ms", 4),
        below("straight skeleton: star of 15", skeleton_ms({star(15)}), "ms", 0.05),
        below("straight skeleton: star of 100", skeleton_ms({star(100)}), "ms", 0.2),
        below("straight skeleton: star of 1,000", skeleton_ms({star(1000)}), "ms", 4),
        below("straight skeleton: star of 3,000", skeleton_ms({star(3000)}), "ms", 20),
        below("straight skeleton: comb of 100,000", skeleton_ms({comb(25'000, 0)}, 3), "ms", 800),
        below("straight skeleton: comb of 100,000, turned", skeleton_ms({comb(25'000, 0.3)}, 3), "ms", 800),
        below("straight skeleton: regular polygon of 70,000", skeleton_ms({regular(70'000)}, 3), "ms", 1000),
        below("straight skeleton: regular polygon of 200,000", skeleton_ms({regular(200'000)}, 3), "ms", 3000),
        below("straight skeleton: longest chunk of a star of 100,000", max_slice_us(star(100'000)), "us", 100)};
#if defined(FLG_WITH_CGAL)
    constexpr double bars[] = {8, 20, 40, 200};
    const std::vector<OutlineClass> classes = outline_classes();
    for (size_t i = 0; i < classes.size(); ++i) rows.push_back(beside_cgal(classes[i], bars[i]));
#endif
    return rows;
}

}  // namespace flg::bench
