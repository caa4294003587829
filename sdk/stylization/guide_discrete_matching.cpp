// SPDX-License-Identifier: MIT
#include "stylization/guide_discrete_matching.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace flg {

namespace {

constexpr double impossible = std::numeric_limits<double>::infinity();

}  // namespace

DiscreteMatching::DiscreteMatching(const SmoothStyleCurve& style, const Vec3* guide, uint32_t count, double beta,
                                   Memory* memory)
    : style_(style),
      guide_(guide),
      count_(count),
      beta_(beta),
      before_(style.count(), memory),
      now_(style.count(), memory),
      previous_(size_t{count} * style.count(), memory),
      least_(impossible),
      delta_(count, memory) {}

bool DiscreteMatching::run(uint32_t n) {
    const uint32_t columns = style_.count();
    while (phase_ != Phase::done) {
        if (n == 0) return false;
        const uint32_t units = std::min(n, columns - column_);
        switch (phase_) {
            case Phase::start:  // the first point stays at the style's start
                for (const uint32_t end = column_ + units; column_ < end; ++column_) {
                    before_[column_] = column_ == 0 ? 0.0 : impossible;
                }
                n -= units;
                if (column_ == columns) {
                    column_ = 0;
                    phase_ = row_ + 1 < count_ ? Phase::table : Phase::choose;
                }
                break;
            case Phase::table:
                fill_row(column_ + units);
                n -= units;
                break;
            case Phase::choose:
                choose(column_ + units);
                n -= units;
                break;
            default:
                --n;
                delta_[row_] = column_ * style_.spacing();
                column_ = previous_[size_t{row_} * columns + column_];
                if (--row_ == 0) phase_ = Phase::done;
                break;
        }
    }
    return true;
}

void DiscreteMatching::fill_row(uint32_t end) {
    const Vec3 point = guide_[row_];
    const double even = style_.length() * row_ / (count_ - 1);
    uint16_t* previous = previous_.data() + size_t{row_} * style_.count();
    for (; column_ < end; ++column_) {
        if (before_[column_] < least_) {
            least_ = before_[column_];
            least_column_ = static_cast<uint16_t>(column_);
        }
        const double late = column_ * style_.spacing() - even;
        now_[column_] = least_ + beta_ * (point - style_.points()[column_]).squaredNorm() + (1.0 - beta_) * late * late;
        previous[column_] = least_column_;
    }
    if (column_ < style_.count()) return;
    std::swap(before_, now_);
    least_ = impossible;
    column_ = 0;
    if (++row_ + 1 == count_) phase_ = Phase::choose;
}

// The best place of the last point but one; from there the table leads back.
void DiscreteMatching::choose(uint32_t end) {
    for (; column_ < end; ++column_) {
        if (before_[column_] < least_) {
            least_ = before_[column_];
            least_column_ = static_cast<uint16_t>(column_);
        }
    }
    if (column_ < style_.count()) return;
    energy_ = least_;
    delta_[0] = 0;
    delta_[count_ - 1] = style_.length();
    column_ = least_column_;
    row_ = count_ - 2;
    phase_ = row_ > 0 ? Phase::trace : Phase::done;
}

}  // namespace flg
