// SPDX-License-Identifier: MIT
#include "linear/dissection_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t leaf_size = 64;       // rows that are not cut any more
constexpr uint32_t min_for_bins = 1500;  // rows of sets that are cut where few entries cross
constexpr double min_share = 0.2;        // of a set, that a side gets
constexpr uint32_t bins = 16;

struct Range {
    uint32_t begin, end;
};

struct Cut {
    uint32_t axis;
    double at;
};

struct Rows {
    Rows(const SymmetricMatrix& of, std::span<const Vec3> at, Memory* memory)
        : matrix(of),
          places(at),
          order(of.size(), memory),
          sorted(of.size(), memory),
          side(of.size(), memory),
          touches(of.size(), memory) {}

    std::span<const uint32_t> neighbours(uint32_t row) const {
        return {matrix.columns.data() + matrix.offsets[row], matrix.columns.data() + matrix.offsets[row + 1]};
    }
    bool touches_other_side(uint32_t row) const {
        for (const uint32_t other : neighbours(row))
            if (side[other] == (side[row] ^ 1)) return true;
        return false;
    }

    const SymmetricMatrix& matrix;
    std::span<const Vec3> places;
    Buffer<uint32_t> order, sorted;
    Buffer<uint32_t> side;    // 2 * stamp of the range + which side
    Buffer<uint8_t> touches;  // whether a row of the range touches the other side
    uint32_t stamp = 0;
};

Cut across_the_longest_axis(const Vec3& extent, const Vec3& mean) {
    const uint32_t axis = extent.x() >= extent.y() && extent.x() >= extent.z() ? 0 : extent.y() >= extent.z() ? 1 : 2;
    return {axis, mean[axis]};
}

// Along each axis: rows in each bin, and how many more entries cross the cut after it than the one before.
struct Bins {
    using Counts = std::array<std::array<int32_t, bins>, 3>;

    // A byte an axis.
    uint32_t put(const Vec3& place) {
        uint32_t all = 0;
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const double extent = high[axis] - low[axis];
            const double share = extent > 0 ? (place[axis] - low[axis]) / extent : 0;
            const uint32_t bin = std::min(bins - 1, static_cast<uint32_t>(share * bins));
            ++rows[axis][bin];
            all |= bin << (8 * axis);
        }
        return all;
    }
    void add_entry(uint32_t from, uint32_t to) {
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const uint32_t here = from >> (8 * axis) & 255, there = to >> (8 * axis) & 255;
            if (there <= here) continue;
            ++crossing[axis][here];
            --crossing[axis][there];
        }
    }
    // Few crossings, and neither side too small. False if nearly all rows are at one place.
    bool choose(double count, Cut& cut) const {
        double best = HUGE_VAL;
        for (uint32_t axis = 0; axis < 3; ++axis) {
            int32_t crossings = 0, below = 0;
            for (uint32_t k = 0; k + 1 < bins; ++k) {
                crossings += crossing[axis][k];
                below += rows[axis][k];
                const double share = below / count;
                if (share < min_share || share > 1 - min_share) continue;
                const double cost = crossings / (share * (1 - share));
                if (cost >= best) continue;
                best = cost;
                cut = {axis, low[axis] + (high - low)[axis] * (k + 1) / bins};
            }
        }
        return best < HUGE_VAL;
    }

    Vec3 low, high;
    Counts rows{}, crossing{};
};

Task<Cut> choose_cut(Pace& pace, Rows& all, Range range) {
    const uint32_t count = range.end - range.begin, stamp = 2 * ++all.stamp;
    Vec3 low = all.places[all.order[range.begin]], high = low, sum = Vec3::Zero();
    co_await each(pace, range.begin, range.end, Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t row = all.order[i];
        const Vec3& place = all.places[row];
        low = low.cwiseMin(place);
        high = high.cwiseMax(place);
        sum += place;
        all.side[row] = stamp;
    });
    Cut cut = across_the_longest_axis(high - low, sum / static_cast<double>(count));
    if (count < min_for_bins) co_return cut;
    Bins counted{.low = low, .high = high};
    co_await each(pace, range.begin, range.end, Cost::tens_of_ns,
                  [&](uint32_t i) { all.sorted[all.order[i]] = counted.put(all.places[all.order[i]]); });
    co_await each(pace, range.begin, range.end, Cost::hundreds_of_ns, [&](uint32_t i) {
        const uint32_t row = all.order[i];
        for (const uint32_t other : all.neighbours(row))
            if (all.side[other] == stamp && all.sorted[other] != all.sorted[row])
                counted.add_entry(all.sorted[row], all.sorted[other]);
    });
    counted.choose(count, cut);
    co_return cut;
}

// Cuts a set in two, orders what separates them after both, and leaves the two to be ordered.
Task<void> divide(Pace& pace, Rows& all, Range range, std::pmr::vector<Range>& left) {
    const Cut cut = co_await choose_cut(pace, all, range);
    const uint32_t stamp = 2 * ++all.stamp;
    std::array<uint32_t, 2> counts{}, touching{};
    co_await each(pace, range.begin, range.end, Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t row = all.order[i], side = all.places[row][cut.axis] > cut.at;
        all.side[row] = stamp + side;
        ++counts[side];
    });
    // All on one side, by rounding: they stay as they are.
    if (counts[0] == 0 || counts[1] == 0) co_return;
    co_await each(pace, range.begin, range.end, Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t row = all.order[i];
        all.touches[row] = all.touches_other_side(row);
        touching[all.side[row] & 1] += all.touches[row];
    });
    const uint32_t separator = touching[1] < touching[0];  // the side whose touching rows separate
    counts[separator] -= touching[separator];
    // Where the next row of each side goes, and the next that separates.
    std::array<uint32_t, 3> ends = {range.begin, range.begin + counts[0], range.begin + counts[0] + counts[1]};
    left.push_back({ends[0], ends[1]});
    left.push_back({ends[1], ends[2]});
    co_await each(pace, range.begin, range.end, Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t row = all.order[i], side = all.side[row] & 1;
        all.sorted[ends[side == separator && all.touches[row] ? 2 : side]++] = row;
    });
    co_await each(pace, range.begin, range.end, Cost::some_ns, [&](uint32_t i) { all.order[i] = all.sorted[i]; });
}

// Minimum degree in a set of at most 64 rows.
struct Leaf {
    using Bits = uint64_t;

    // What a row touches. Of what is around the leaf the first 64 are counted.
    void gather(const Rows& all, uint32_t member, uint32_t stamp) {
        for (const uint32_t other : all.neighbours(rows[member])) {
            if (all.side[other] == stamp) {
                inside[member] |= Bits{1} << all.sorted[other];
                continue;
            }
            const auto found =
                static_cast<uint32_t>(std::find(halo.begin(), halo.begin() + halo_count, other) - halo.begin());
            if (found == leaf_size) continue;
            if (found == halo_count) halo[halo_count++] = other;
            around[member] |= Bits{1} << found;
        }
        count_degree(member);
    }
    // Takes the row that touches the fewest, and joins all that it touches with each other.
    uint32_t eliminate() {
        uint32_t best = 0, least = UINT32_MAX;
        for (Bits rest = left; rest != 0; rest &= rest - 1) {
            const auto i = static_cast<uint32_t>(std::countr_zero(rest));
            if (degree[i] >= least) continue;
            least = degree[i];
            best = i;
        }
        left &= ~(Bits{1} << best);
        for (Bits rest = inside[best]; rest != 0; rest &= rest - 1) {
            const auto i = static_cast<uint32_t>(std::countr_zero(rest));
            inside[i] = (inside[i] | inside[best]) & ~(Bits{1} << best | Bits{1} << i);
            around[i] |= around[best];
            count_degree(i);
        }
        return rows[best];
    }
    void count_degree(uint32_t i) {
        degree[i] = static_cast<uint32_t>(std::popcount(inside[i]) + std::popcount(around[i]));
    }

    std::array<uint32_t, leaf_size> rows, halo, degree;
    std::array<Bits, leaf_size> inside{}, around{};  // what each row touches
    Bits left = 0;                                   // rows that are not ordered yet
    uint32_t halo_count = 0;
};

Task<void> order_leaf(Pace& pace, Rows& all, Range range) {
    const uint32_t count = range.end - range.begin;
    if (count < 3) co_return;
    Leaf leaf;
    const uint32_t stamp = 2 * ++all.stamp;
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t row = leaf.rows[i] = all.order[range.begin + i];
        all.side[row] = stamp;
        all.sorted[row] = i;
    }
    leaf.left = ~uint64_t{0} >> (leaf_size - count);
    co_await each(pace, count, Cost::hundreds_of_ns, [&](uint32_t i) { leaf.gather(all, i, stamp); });
    co_await each(pace, range.begin, range.end, Cost::hundreds_of_ns,
                  [&](uint32_t i) { all.order[i] = leaf.eliminate(); });
}

}  // namespace

Task<Buffer<uint32_t>> dissection_order(Pace& pace, const SymmetricMatrix& matrix, std::span<const Vec3> places) {
    Rows all(matrix, places, pace.memory());
    const uint32_t size = matrix.size();
    co_await each(pace, size, Cost::some_ns, [&](uint32_t i) {
        all.order[i] = i;
        all.side[i] = UINT32_MAX;
    });
    std::pmr::vector<Range> left(pace.memory());
    left.reserve(64);
    left.push_back({0, size});
    while (!left.empty()) {
        const Range range = left.back();
        left.pop_back();
        if (range.end - range.begin <= leaf_size) {
            co_await order_leaf(pace, all, range);
        } else {
            co_await divide(pace, all, range, left);
        }
    }
    co_return std::move(all.order);
}

}  // namespace flg
