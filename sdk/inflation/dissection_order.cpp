// SPDX-License-Identifier: MIT
#include "inflation/dissection_order.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace flg {

namespace {

constexpr uint32_t batch = 16;  // rows a unit
constexpr uint32_t leaf = 64;   // rows that are not cut any more

constexpr uint32_t looked_at = 1500;  // rows of sets that are cut where few entries cross
constexpr double least_share = 0.2;   // of a set, that a side gets

}  // namespace

DissectionOrder::DissectionOrder(const SymmetricMatrix& matrix, std::span<const Vec3> places, Memory* memory)
    : matrix_(matrix),
      places_(places),
      order_(matrix.size(), memory),
      sorted_(matrix.size(), memory),
      side_(matrix.size(), memory),
      touches_(matrix.size(), memory),
      stack_(memory) {
    stack_.reserve(64);
}

bool DissectionOrder::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

void DissectionOrder::step() {
    const uint32_t size = matrix_.size();
    const auto each = [&](uint32_t end, auto&& action) {
        const uint32_t stop = std::min(end, at_ + batch);
        for (; at_ < stop; ++at_) action(at_);
        return at_ == end;
    };
    switch (pass_) {
        case Pass::fill:
            if (each(size, [&](uint32_t i) {
                    order_[i] = i;
                    side_[i] = UINT32_MAX;
                })) {
                stack_.push_back({0, size});
                pass_ = Pass::next;
            }
            break;
        case Pass::next:
            if (stack_.empty()) {
                pass_ = Pass::done;
                break;
            }
            range_ = stack_.back();
            stack_.pop_back();
            if (range_.end - range_.begin <= leaf) {
                begin_leaf();
                break;
            }
            ++stamp_;
            low_ = high_ = places_[order_[range_.begin]];
            sum_.setZero();
            at_ = range_.begin;
            pass_ = Pass::measure;
            break;
        case Pass::measure:
            if (each(range_.end, [&](uint32_t i) {
                    const Vec3& p = places_[order_[i]];
                    low_ = low_.cwiseMin(p);
                    high_ = high_.cwiseMax(p);
                    sum_ += p;
                    side_[order_[i]] = 2 * stamp_;
                }))
                measure_end();
            break;
        case Pass::bin:
            if (each(range_.end, [&](uint32_t i) { put_in_bins(order_[i]); })) {
                at_ = range_.begin;
                pass_ = Pass::scan;
            }
            break;
        case Pass::scan:
            if (each(range_.end, [&](uint32_t i) { scan(order_[i]); })) scan_end();
            break;
        case Pass::divide:
            if (each(range_.end, [&](uint32_t i) {
                    const uint32_t side = places_[order_[i]][axis_] > cut_;
                    side_[order_[i]] = 2 * stamp_ + side;
                    ++counts_[side];
                })) {
                at_ = range_.begin;
                // All on one side, by rounding: they stay as they are.
                pass_ = counts_[0] == 0 || counts_[1] == 0 ? Pass::next : Pass::touch;
            }
            break;
        case Pass::touch:
            if (each(range_.end, [&](uint32_t i) {
                    touches_[order_[i]] = touches_other(order_[i]);
                    touching_[side_[order_[i]] & 1] += touches_[order_[i]];
                })) {
                separator_ = touching_[1] < touching_[0];
                const uint32_t first = counts_[0] - (separator_ == 0 ? touching_[0] : 0),
                               second = counts_[1] - (separator_ == 1 ? touching_[1] : 0);
                ends_[0] = range_.begin;
                ends_[1] = range_.begin + first;
                ends_[2] = ends_[1] + second;
                stack_.push_back({ends_[0], ends_[1]});
                stack_.push_back({ends_[1], ends_[2]});
                at_ = range_.begin;
                pass_ = Pass::sort;
            }
            break;
        case Pass::sort:
            if (each(range_.end, [&](uint32_t i) {
                    const uint32_t row = order_[i], side = side_[row] & 1;
                    sorted_[ends_[side == separator_ && touches_[row] ? 2 : side]++] = row;
                })) {
                at_ = range_.begin;
                pass_ = Pass::copy;
            }
            break;
        case Pass::copy:
            if (each(range_.end, [&](uint32_t i) { order_[i] = sorted_[i]; })) pass_ = Pass::next;
            break;
        case Pass::gather:
            gather(at_);
            if (++at_ == range_.end - range_.begin) {
                at_ = range_.begin;
                pass_ = Pass::eliminate;
            }
            break;
        case Pass::eliminate: eliminate(); break;
        case Pass::done: break;
    }
}

void DissectionOrder::measure_end() {
    if (range_.end - range_.begin >= looked_at) {
        for (auto* all : {&in_bin_, &crossing_})
            for (auto& axis : *all) axis.fill(0);
        at_ = range_.begin;
        pass_ = Pass::bin;
        return;
    }
    const Vec3 extent = high_ - low_;
    axis_ = extent.x() >= extent.y() && extent.x() >= extent.z() ? 0 : extent.y() >= extent.z() ? 1 : 2;
    cut_ = sum_[axis_] / (range_.end - range_.begin);
    begin_division();
}

// A byte an axis, in sorted_.
void DissectionOrder::put_in_bins(uint32_t row) {
    uint32_t all = 0;
    for (uint32_t axis = 0; axis < 3; ++axis) {
        const double extent = high_[axis] - low_[axis];
        const double share = extent > 0 ? (places_[row][axis] - low_[axis]) / extent : 0;
        const uint32_t bin = std::min(bins - 1, static_cast<uint32_t>(share * bins));
        ++in_bin_[axis][bin];
        all |= bin << (8 * axis);
    }
    sorted_[row] = all;
}

void DissectionOrder::scan(uint32_t row) {
    const uint32_t own = sorted_[row];
    for (uint32_t e = matrix_.offsets[row]; e < matrix_.offsets[row + 1]; ++e) {
        const uint32_t other = matrix_.columns[e];
        if (side_[other] != 2 * stamp_ || sorted_[other] == own) continue;
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const uint32_t here = own >> (8 * axis) & 255, there = sorted_[other] >> (8 * axis) & 255;
            if (there <= here) continue;
            ++crossing_[axis][here];
            --crossing_[axis][there];
        }
    }
}

// Few crossings, but none of the sides too small.
void DissectionOrder::scan_end() {
    const double count = range_.end - range_.begin;
    double best = HUGE_VAL;
    for (uint32_t axis = 0; axis < 3; ++axis) {
        int32_t crossings = 0, below = 0;
        for (uint32_t k = 0; k + 1 < bins; ++k) {
            crossings += crossing_[axis][k];
            below += in_bin_[axis][k];
            const double share = below / count;
            if (share < least_share || share > 1 - least_share) continue;
            const double cost = crossings / (share * (1 - share));
            if (cost >= best) continue;
            best = cost;
            axis_ = axis;
            cut_ = low_[axis] + (high_ - low_)[axis] * (k + 1) / bins;
        }
    }
    if (best == HUGE_VAL) {
        // Nearly all at one place.
        const Vec3 extent = high_ - low_;
        axis_ = extent.x() >= extent.y() && extent.x() >= extent.z() ? 0 : extent.y() >= extent.z() ? 1 : 2;
        cut_ = sum_[axis_] / count;
    }
    begin_division();
}

void DissectionOrder::begin_division() {
    ++stamp_;
    counts_[0] = counts_[1] = touching_[0] = touching_[1] = 0;
    at_ = range_.begin;
    pass_ = Pass::divide;
}

bool DissectionOrder::touches_other(uint32_t row) const {
    const uint32_t other = side_[row] ^ 1;
    for (uint32_t e = matrix_.offsets[row]; e < matrix_.offsets[row + 1]; ++e)
        if (side_[matrix_.columns[e]] == other) return true;
    return false;
}

void DissectionOrder::begin_leaf() {
    const uint32_t count = range_.end - range_.begin;
    if (count < 3) return;
    ++stamp_;
    for (uint32_t i = 0; i < count; ++i) {
        leaf_rows_[i] = order_[range_.begin + i];
        side_[leaf_rows_[i]] = 2 * stamp_;
        sorted_[leaf_rows_[i]] = i;
    }
    left_ = count == leaf ? ~uint64_t{0} : (uint64_t{1} << count) - 1;
    halo_count_ = 0;
    at_ = 0;
    pass_ = Pass::gather;
}

// What one row of the leaf touches. Of what is around it the first 64 are counted.
void DissectionOrder::gather(uint32_t member) {
    leaf_[member] = halo_[member] = 0;
    const uint32_t row = leaf_rows_[member];
    for (uint32_t e = matrix_.offsets[row]; e < matrix_.offsets[row + 1]; ++e) {
        const uint32_t other = matrix_.columns[e];
        if (side_[other] == 2 * stamp_) {
            leaf_[member] |= uint64_t{1} << sorted_[other];
            continue;
        }
        const auto found = static_cast<uint32_t>(std::find(halo_rows_, halo_rows_ + halo_count_, other) - halo_rows_);
        if (found == 64) continue;
        if (found == halo_count_) halo_rows_[halo_count_++] = other;
        halo_[member] |= uint64_t{1} << found;
    }
    degrees_[member] = static_cast<uint32_t>(std::popcount(leaf_[member]) + std::popcount(halo_[member]));
}

// Orders the row that touches the fewest, and joins all that it touches with each other.
void DissectionOrder::eliminate() {
    uint32_t best = 0, least = UINT32_MAX;
    for (uint64_t rest = left_; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<uint32_t>(std::countr_zero(rest));
        if (degrees_[i] >= least) continue;
        least = degrees_[i];
        best = i;
    }
    order_[at_] = leaf_rows_[best];
    left_ &= ~(uint64_t{1} << best);
    const uint64_t touched = leaf_[best], around = halo_[best];
    for (uint64_t rest = touched; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<uint32_t>(std::countr_zero(rest));
        leaf_[i] = (leaf_[i] | touched) & ~((uint64_t{1} << best) | (uint64_t{1} << i));
        halo_[i] |= around;
        degrees_[i] = static_cast<uint32_t>(std::popcount(leaf_[i]) + std::popcount(halo_[i]));
    }
    if (++at_ == range_.end) pass_ = Pass::next;
}

}  // namespace flg
