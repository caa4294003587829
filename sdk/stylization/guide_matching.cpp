// SPDX-License-Identifier: MIT
#include "stylization/guide_matching.h"

#include <cmath>
#include <limits>
#include <utility>

namespace flg {

namespace {

// The most cells a point of the guide that a table over the whole band may have: without coarser ones before it, and as
// the coarsest of several. What a coarser one could spare in time it loses in the choice of the right minimum.
constexpr double cells_without_coarser = 16.0;
constexpr double cells_of_coarsest = 60.0;
constexpr uint32_t refinement = 3;
// Newton's model is trusted above this second derivative of a point's energy; below, the paper's constant 2 replaces it.
constexpr double least_curvature = 0.25;
constexpr double plain_curvature = 2.0;
// A point rests when its next move is below this part of the style's spacing; that move is still made, and
// leaves an error of about its square.
constexpr double small_move = 0.02;
constexpr uint32_t max_descent_steps = 12;
constexpr uint32_t max_sweeps = 12;

}  // namespace

GuideMatching::GuideMatching(const SmoothStyleCurve& style, const Vec3* guide, uint32_t count, double beta,
                             Memory* memory)
    : style_(style),
      guide_(guide),
      count_(count),
      beta_(beta),
      memory_(memory),
      low_(count, memory),
      high_(count, memory),
      first_column_(count, memory),
      last_column_(count, memory),
      row_start_(count, memory),
      cost_(style.count(), memory),
      next_cost_(style.count(), memory),
      chosen_(count, memory),
      delta_(count, memory),
      models_(count, memory),
      blocks_(count, memory) {}

bool GuideMatching::run(uint32_t n) {
    const uint32_t end = n < count_ - index_ ? index_ + n : count_;
    switch (phase_) {
        case Phase::reach: reach(end); break;
        case Phase::reach_back: reach_back(end); break;
        case Phase::table: table(n); break;
        case Phase::trace: trace(n); break;
        case Phase::narrow: narrow(end); break;
        case Phase::descend: descend(n); break;
        case Phase::settle: settle(end); break;
        case Phase::pool: pool(n); break;
        case Phase::done: break;
    }
    return phase_ == Phase::done;
}

void GuideMatching::enter(Phase phase) {
    phase_ = phase;
    index_ = 0;
    block_count_ = 0;
}

// The band of each point, and the monotone hull of its upper side.
void GuideMatching::reach(uint32_t end) {
    const double slack = std::sqrt(beta_ / (1.0 - beta_)) / style_.spacing();
    const double last = style_.count() - 1;
    const double places_per_point = last / (count_ - 1);
    for (; index_ < end; ++index_) {
        const double place = std::min(index_ * places_per_point, last);
        const Vec3& there = style_.points()[static_cast<uint32_t>(std::min(place + 0.5, last))];
        const double radius = slack * (guide_[index_] - there).norm();
        low_[index_] = static_cast<uint32_t>(std::max(place - radius, 0.0));
        high_[index_] = static_cast<uint32_t>(std::min(place + radius + 1.0, last));
        if (index_ > 0) high_[index_] = std::max(high_[index_], high_[index_ - 1]);
    }
    if (index_ == count_) enter(Phase::reach_back);
}

void GuideMatching::reach_back(uint32_t end) {
    for (; index_ < end; ++index_) {
        const uint32_t i = count_ - 1 - index_;
        if (index_ > 0) low_[i] = std::min(low_[i], low_[i + 1]);
        band_width_sum_ += high_[i] - low_[i];
    }
    if (index_ == count_) choose_stride();
}

// Rows are half as far apart as columns: what they skip, the next table sees.
uint32_t GuideMatching::row_stride(uint32_t stride) const {
    if (stride == 1) return 1;
    const double guide_points = 0.5 * (stride + 1) * (count_ - 1) / (style_.count() - 1);
    return std::max(static_cast<uint32_t>(guide_points), 1U);
}

void GuideMatching::choose_stride() {
    const double width = static_cast<double>(band_width_sum_) / count_;
    uint32_t stride = 1;
    if (width > cells_without_coarser) stride = refinement;
    while (width > cells_of_coarsest * stride * row_stride(stride)) stride *= refinement;
    begin_table(stride);
}

void GuideMatching::begin_table(uint32_t stride) {
    stride_ = stride;
    row_stride_ = row_stride(stride);
    last_row_ = (count_ - 2) / row_stride_;
    // Rounding outwards adds at most two columns a row, and both ends of the range are in it.
    best_ = Buffer<uint32_t>(band_width_sum_ / stride_ + 3 * static_cast<uint64_t>(count_), memory_);
    enter(Phase::table);
    first_column_[0] = last_column_[0] = 0;
    row_start_[0] = 0;
    best_[0] = 0;
    cost_[0] = 0.0;
    chosen_[0] = 0;
    index_ = 1;
    begin_row();
}

void GuideMatching::begin_row() {
    if (index_ > last_row_) return;
    const uint32_t i = index_ * row_stride_;
    row_start_[index_] = row_start_[index_ - 1] + (last_column_[index_ - 1] - first_column_[index_ - 1] + 1);
    first_column_[index_] = low_[i] / stride_;
    last_column_[index_] = std::min((high_[i] + stride_ - 1) / stride_, (style_.count() - 1) / stride_);
    column_ = first_column_[index_];
    running_ = std::numeric_limits<double>::infinity();
}

// cost(row, column) = least energy of the points up to this row's, with this one's place at or before the column.
void GuideMatching::table(uint32_t n) {
    const double column_length = style_.spacing() * stride_;
    const Vec3* const points = style_.points();
    const double far = 1.0 - beta_;
    while (n > 0 && index_ <= last_row_) {
        const Vec3 point = guide_[index_ * row_stride_];
        const double even = even_place(index_ * row_stride_);
        const uint32_t last = last_column_[index_];
        const uint32_t last_before = last_column_[index_ - 1];
        const uint32_t first = first_column_[index_];
        uint32_t* const best = best_.data() + row_start_[index_];
        uint32_t column = column_;
        const uint32_t stop = n < last + 1 - column ? column + n : last + 1;
        n -= stop - column;
        double running = running_;
        uint32_t running_column = running_column_;
        for (; column < stop; ++column) {
            const double late = column * column_length - even;
            const double total = beta_ * (point - points[column * stride_]).squaredNorm() + far * late * late +
                                 cost_[std::min(column, last_before)];
            running_column = total < running ? column : running_column;
            running = total < running ? total : running;
            next_cost_[column] = running;
            best[column - first] = running_column;
        }
        column_ = column;
        running_ = running;
        running_column_ = running_column;
        if (column <= last) return;
        std::swap(cost_, next_cost_);
        ++index_;
        begin_row();
    }
    if (index_ <= last_row_) return;
    column_ = std::numeric_limits<uint32_t>::max();
    enter(Phase::trace);
    index_ = last_row_;
}

// The best path, from the last row on.
void GuideMatching::trace(uint32_t n) {
    for (; n > 0 && index_ > 0; --n, --index_) {
        column_ = best_[row_start_[index_] + std::min(column_, last_column_[index_]) - first_column_[index_]];
        chosen_[index_] = column_ * stride_;
    }
    if (index_ > 0) return;
    if (stride_ > 1) {
        band_width_sum_ = 0;
        return enter(Phase::narrow);
    }
    delta_[0] = 0.0;
    delta_[count_ - 1] = style_.length();
    enter(Phase::descend);
    index_ = 1;
}

// The band of the next table: one step around the path of this one.
void GuideMatching::narrow(uint32_t end) {
    const uint32_t last = style_.count() - 1;
    for (; index_ < end; ++index_) {
        const uint32_t row = std::min(index_ / row_stride_, last_row_);
        const uint32_t from = chosen_[row];
        const uint32_t to = row < last_row_ ? chosen_[row + 1] : last;
        low_[index_] = from > stride_ ? from - stride_ : 0;
        high_[index_] = std::min((index_ == row * row_stride_ ? from : to) + stride_, last);
        band_width_sum_ += high_[index_] - low_[index_];
    }
    if (index_ == count_) begin_table(stride_ / refinement);
}

GuideMatching::Model GuideMatching::model(uint32_t i, double place, const SmoothStyleCurve::Jet& style,
                                          double longest_move) const {
    const Vec3 apart = guide_[i] - style.position;
    const double late = place - even_place(i);
    const double far = 1.0 - beta_;
    Model result;
    result.place = place;
    result.energy = beta_ * apart.squaredNorm() + far * late * late;
    result.slope = 2.0 * (far * late - beta_ * apart.dot(style.derivative));
    const double second = 2.0 * (far + beta_ * (style.derivative.squaredNorm() - apart.dot(style.second_derivative)));
    result.curvature = second > least_curvature ? second : plain_curvature;
    const double move = std::clamp(-result.slope / result.curvature, -longest_move, longest_move);
    result.minimum = std::clamp(place + move, 0.0, style_.length());
    return result;
}

// Pools the last two blocks if they are out of order.
bool GuideMatching::merge_last_blocks() {
    if (block_count_ < 2) return false;
    Block& into = blocks_[block_count_ - 2];
    const Block& from = blocks_[block_count_ - 1];
    if (into.place <= from.place) return false;
    const double weight = into.weight + from.weight;
    into.place += from.weight / weight * (from.place - into.place);
    into.weight = weight;
    into.end = from.end;
    --block_count_;
    return true;
}

// Every point by itself to the minimum next to its place on the path. A unit is an evaluation or a merger.
void GuideMatching::descend(uint32_t n) {
    while (n > 0) {
        if (merge_last_blocks()) {
            --n;
            continue;
        }
        if (index_ == count_ - 1) return enter(Phase::settle);
        double place = chosen_[index_] * style_.spacing();
        double low = std::max(place - style_.spacing(), 0.0);
        double high = std::min(place + style_.spacing(), style_.length());
        Model& found = models_[index_];
        found = model(index_, place, style_.at_point(chosen_[index_]), style_.spacing());
        for (uint32_t step = 1;; ++step) {
            n -= n > 0 ? 1 : 0;
            (found.slope > 0.0 ? high : low) = place;
            const bool at_rest = std::abs(found.minimum - place) <= small_move * style_.spacing();
            if (at_rest || step == max_descent_steps) break;
            if (found.minimum < low || found.minimum > high) found.minimum = 0.5 * (low + high);
            place = found.minimum;
            found = model(index_, place, style_.evaluate(place), style_.spacing());
        }
        ++index_;
        blocks_[block_count_++] = {found.curvature, found.minimum, index_};
    }
}

// Places the points of the blocks. Those that share a block get a new model there.
void GuideMatching::settle(uint32_t end) {
    if (index_ == 0) {
        energy_ = 0.0;
        largest_move_ = 0.0;
        ++index_;
    }
    const uint32_t last = std::min(end, count_ - 1);
    for (; index_ < last; ++index_) {
        if (index_ == blocks_[block_count_].end) ++block_count_;
        const double place = blocks_[block_count_].place;
        const uint32_t first = block_count_ > 0 ? blocks_[block_count_ - 1].end : 1;
        Model& own = models_[index_];
        if (blocks_[block_count_].end - first > 1) {
            largest_move_ = std::max(largest_move_, std::abs(place - delta_[index_]));
            own = model(index_, place, style_.evaluate(place), style_.spacing());
        }
        delta_[index_] = place;
        const double move = place - own.place;
        energy_ += own.energy + move * (own.slope + 0.5 * own.curvature * move);
    }
    if (index_ < count_ - 1) return;
    if (largest_move_ <= small_move * style_.spacing() || ++sweeps_ == max_sweeps) return enter(Phase::done);
    enter(Phase::pool);
    index_ = 1;
}

// The minimum of the models in order. A unit is a point or a merger.
void GuideMatching::pool(uint32_t n) {
    for (; n > 0; --n) {
        if (merge_last_blocks()) continue;
        if (index_ == count_ - 1) return enter(Phase::settle);
        const Model& own = models_[index_];
        ++index_;
        blocks_[block_count_++] = {own.curvature, own.minimum, index_};
    }
}

}  // namespace flg
