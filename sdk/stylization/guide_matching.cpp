// SPDX-License-Identifier: MIT
#include "stylization/guide_matching.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "runtime/each.h"

namespace flg {

namespace {

// The most cells a point of the guide that a table over the whole band may have: without coarser ones before it, and as
// the coarsest of several. What a coarser one could spare in time it loses in the choice of the right minimum.
constexpr double cells_without_coarser = 16.0;
constexpr double cells_of_coarsest = 60.0;
constexpr uint32_t refinement = 3;
// Newton's model has at least this second derivative of a point's energy, whose plain part is 2.
constexpr double min_curvature = 0.25;
// A point rests when its next move is below this part of the style's spacing; that move is still made, and
// leaves an error of about its square.
constexpr double small_move = 0.005;
constexpr uint32_t max_descent_steps = 12;
constexpr uint32_t max_sweeps = 12;

struct Model {  // of a point's energy around a place on the style
    double place;
    double energy;
    double slope;
    double curvature;  // > 0
    double minimum;    // where the model is least, within reach of `place`
};

struct Energy {
    uint32_t count() const { return static_cast<uint32_t>(guide.size()); }
    double even_place(uint32_t i) const { return style.length() * i / (count() - 1); }

    Model model(uint32_t i, double place, const SmoothStyleCurve::Jet& jet) const {
        const Vec3 apart = guide[i] - jet.position;
        const double late = place - even_place(i);
        const double far = 1.0 - beta;
        Model result;
        result.place = place;
        result.energy = beta * apart.squaredNorm() + far * late * late;
        result.slope = 2.0 * (far * late - beta * apart.dot(jet.derivative));
        const double second = 2.0 * (far + beta * (jet.derivative.squaredNorm() - apart.dot(jet.second_derivative)));
        result.curvature = std::max(second, min_curvature);
        const double max_move = style.spacing();
        const double move = std::clamp(-result.slope / result.curvature, -max_move, max_move);
        // Within reach of both ends.
        const double from_end = style.length() - farthest_step * (count() - 1 - i);
        result.minimum = std::clamp(place + move, std::max(0.0, from_end), std::min(style.length(), farthest_step * i));
        return result;
    }

    // A point by itself at the minimum next to point `near` of the style, found in some evaluations.
    Model minimum_near(uint32_t i, uint32_t near, uint32_t& evaluations) const {
        double place = near * style.spacing();
        double low = std::max(place - style.spacing(), 0.0);
        double high = std::min(place + style.spacing(), style.length());
        Model found = model(i, place, style.at_point(near));
        for (evaluations = 1;; ++evaluations) {
            (found.slope > 0.0 ? high : low) = place;
            const bool at_rest = std::abs(found.minimum - place) <= small_move * style.spacing();
            if (at_rest || evaluations == max_descent_steps) return found;
            if (found.minimum < low || found.minimum > high) found.minimum = 0.5 * (low + high);
            place = found.minimum;
            found = model(i, place, style.evaluate(place));
        }
    }

    SmoothStyleCurve style;
    std::span<const Vec3> guide;
    double beta;
    double farthest_step;
};

// By guide point: which points of the style are looked at.
struct Band {
    Band(uint32_t count, Memory* memory) : low(count, memory), high(count, memory) {}

    Buffer<uint32_t> low, high;
    uint64_t width_sum = 0;
};

// How far each point would go alone, and the monotone hull of that.
Task<Band> reach(Pace& pace, const Energy& energy) {
    const SmoothStyleCurve& style = energy.style;
    const uint32_t count = energy.count();
    Band band(count, pace.memory());
    const double slack = std::sqrt(energy.beta / (1.0 - energy.beta)) / style.spacing();
    const double last = style.count() - 1;
    const double places_per_point = last / (count - 1);
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        const double place = std::min(i * places_per_point, last);
        const Vec3& there = style.points()[static_cast<uint32_t>(std::min(place + 0.5, last))];
        const double radius = slack * (energy.guide[i] - there).norm();
        band.low[i] = static_cast<uint32_t>(std::max(place - radius, 0.0));
        band.high[i] = static_cast<uint32_t>(std::min(place + radius + 1.0, last));
        if (i > 0) band.high[i] = std::max(band.high[i], band.high[i - 1]);
    });
    co_await each(pace, count, Cost::some_ns, [&](uint32_t k) {
        const uint32_t i = count - 1 - k;
        if (k > 0) band.low[i] = std::min(band.low[i], band.low[i + 1]);
        band.width_sum += band.high[i] - band.low[i];
    });
    co_return band;
}

// The table of one stride: a row for each row_stride-th point of the guide, a column for each stride-th one of the
// style.
struct Table {
    Table(const Energy& energy, Memory* memory)
        : first_column(energy.count(), memory),
          last_column(energy.count(), memory),
          row_start(energy.count(), memory),
          cost(energy.style.count(), memory),
          next_cost(energy.style.count(), memory),
          chosen(energy.count(), memory) {}

    void begin_row(const Energy& energy, const Band& band, uint32_t row) {
        const uint32_t i = row * row_stride;
        row_start[row] = row_start[row - 1] + (last_column[row - 1] - first_column[row - 1] + 1);
        first_column[row] = band.low[i] / stride;
        last_column[row] = std::min((band.high[i] + stride - 1) / stride, (energy.style.count() - 1) / stride);
        running = std::numeric_limits<double>::infinity();
    }

    // next_cost[column] = the least energy of the points up to this row's, with this one's place at or before the
    // column.
    void fill(const Energy& energy, uint32_t row, uint32_t begin, uint32_t end) {
        const double column_length = energy.style.spacing() * stride;
        const Vec3* const points = energy.style.points();
        const double beta = energy.beta, far = 1.0 - beta;
        const Vec3 point = energy.guide[row * row_stride];
        const double even = energy.even_place(row * row_stride);
        const uint32_t last_before = last_column[row - 1];
        const uint32_t first = first_column[row];
        uint32_t* const best_of_row = best.data() + row_start[row];
        const double* const before = cost.data();
        double* const now = next_cost.data();
        double least = running;
        uint32_t min_column = running_column;
        for (uint32_t column = begin; column < end; ++column) {
            const double late = column * column_length - even;
            const double total = beta * (point - points[column * stride]).squaredNorm() + far * late * late +
                                 before[std::min(column, last_before)];
            min_column = total < least ? column : min_column;
            least = total < least ? total : least;
            now[column] = least;
            best_of_row[column - first] = min_column;
        }
        running = least;
        running_column = min_column;
    }

    uint32_t stride = 1, row_stride = 1, last_row = 0;
    Buffer<uint32_t> first_column;  // by row; row 0 is the first point, which stays
    Buffer<uint32_t> last_column;
    Buffer<uint32_t> row_start;  // into best
    Buffer<uint32_t> best;       // by cell: the best column of the row up to here
    Buffer<double> cost;         // of the last row, by column: the least cost up to here
    Buffer<double> next_cost;
    Buffer<uint32_t> chosen;  // by row: the point of the style on the best path
    double running = 0.0;     // of the row up to here
    uint32_t running_column = 0;
};

// Rows are half as far apart as columns: what they skip, the next table sees.
uint32_t row_stride_of(const Energy& energy, uint32_t stride) {
    if (stride == 1) return 1;
    const double guide_points = 0.5 * (stride + 1) * (energy.count() - 1) / (energy.style.count() - 1);
    return std::max(static_cast<uint32_t>(guide_points), 1U);
}

uint32_t coarsest_stride(const Energy& energy, const Band& band) {
    const double width = static_cast<double>(band.width_sum) / energy.count();
    uint32_t stride = 1;
    if (width > cells_without_coarser) stride = refinement;
    while (width > cells_of_coarsest * stride * row_stride_of(energy, stride)) stride *= refinement;
    return stride;
}

// The best path through the band, in chosen.
Task<void> find_path(Pace& pace, const Energy& energy, const Band& band, uint32_t stride, Table& table) {
    table.stride = stride;
    table.row_stride = row_stride_of(energy, stride);
    table.last_row = (energy.count() - 2) / table.row_stride;
    // Rounding outwards adds at most two columns a row, and both ends of the range are in it.
    table.best = Buffer<uint32_t>(band.width_sum / stride + 3 * uint64_t{energy.count()}, pace.memory());
    table.first_column[0] = table.last_column[0] = table.row_start[0] = 0;
    table.best[0] = table.chosen[0] = 0;
    table.cost[0] = 0.0;
    Slice slice(Cost::some_ns);
    for (uint32_t row = 1; row <= table.last_row; ++row) {
        table.begin_row(energy, band, row);
        for (Portion part(slice, table.first_column[row], table.last_column[row] + 1); part.next();) {
            table.fill(energy, row, part.begin, part.end);
            if (part.is_over()) co_await pace;
        }
        std::swap(table.cost, table.next_cost);
    }
    uint32_t column = std::numeric_limits<uint32_t>::max();
    co_await each(pace, table.last_row, Cost::some_ns, [&](uint32_t k) {
        const uint32_t row = table.last_row - k;
        column = table.best[table.row_start[row] + std::min(column, table.last_column[row]) - table.first_column[row]];
        table.chosen[row] = column * table.stride;
    });
}

// The band of the next table: one step around the path of this one.
Task<void> narrow(Pace& pace, const Energy& energy, const Table& table, Band& band) {
    const uint32_t last = energy.style.count() - 1, stride = table.stride;
    band.width_sum = 0;
    co_await each(pace, energy.count(), Cost::some_ns, [&, last, stride](uint32_t i) {
        const uint32_t row = std::min(i / table.row_stride, table.last_row);
        const uint32_t from = table.chosen[row];
        const uint32_t to = row < table.last_row ? table.chosen[row + 1] : last;
        band.low[i] = from > stride ? from - stride : 0;
        band.high[i] = std::min((i == row * table.row_stride ? from : to) + stride, last);
        band.width_sum += band.high[i] - band.low[i];
    });
}

// The points' models minimized in order, with no step longer than `farthest_step`, exactly: dynamic programming from
// the first point to the last over the derivative of the least energy so far, by the last point's place. That is
// piecewise linear and rises; where it is zero, the points so far are best on their own. A step on to the next point
// leaves what is left of the zero, moves what is right of it by farthest_step, and is flat in between; the next model
// adds a line.
class Chain {
public:
    Chain(uint32_t count, Memory* memory)
        : left_(2 * size_t{count}, memory), right_(2 * size_t{count}, memory), zeros_(count, memory) {}

    void begin(double farthest_step) {
        farthest_step_ = farthest_step;
        shift_ = slope_ = 0;
        left_count_ = right_count_ = 0;
    }
    // The step from the point before, and the model. find_zero() follows.
    void add(const Model& model) {
        if (slope_ > 0) {
            left_[left_count_++] = {zero_, slope_};
            right_[right_count_++] = {zero_ - shift_, slope_};
            shift_ += farthest_step_;
        }
        slope_ = model.curvature;
        zero_ = model.minimum;
    }
    // Over one knot towards the zero; true when it is found, of point `point`.
    bool find_zero(uint32_t point) {
        if (left_count_ > 0 && zero_ < left_[left_count_ - 1].place) {
            const Knot knot = left_[--left_count_];
            right_[right_count_++] = {knot.place - shift_, -knot.bend};
            cross(knot.place, knot.bend);
            return false;
        }
        if (right_count_ > 0 && zero_ > right_[right_count_ - 1].place + shift_) {
            const Knot knot = right_[--right_count_];
            left_[left_count_++] = {knot.place + shift_, -knot.bend};
            cross(knot.place + shift_, knot.bend);
            return false;
        }
        zeros_[point] = zero_;
        return true;
    }
    // Of a point, where the one behind it is known.
    double place(uint32_t point, double next) const { return std::clamp(zeros_[point], next - farthest_step_, next); }

private:
    // Where the derivative bends: how much steeper it is beyond, seen from the zero.
    struct Knot {
        double place, bend;
    };

    void cross(double place, double bend) {
        const double value = slope_ * (place - zero_);
        slope_ += bend;
        zero_ = place - value / slope_;
    }

    Buffer<Knot> left_, right_;  // of the zero, the nearest at the end; those on the right shift_ further right
    Buffer<double> zeros_;       // by point
    double farthest_step_ = 0, shift_ = 0;
    double slope_ = 0, zero_ = 0;  // of the piece that has the zero
    uint32_t left_count_ = 0, right_count_ = 0;
};

// Places the points. Those that are not where they would be alone get a new model there; returns how far they moved at
// most.
Task<double> settle(Pace& pace, const Energy& energy, const Chain& chain, Buffer<Model>& models, GuideMatch& match) {
    double largest_move = 0.0;
    const uint32_t last = energy.count() - 1;
    double place = energy.style.length();
    match.energy = 0.0;
    co_await each(pace, 1, last, Cost::tens_of_ns, [&](uint32_t k) {
        const uint32_t i = last - k;
        place = chain.place(i, place);
        Model& own = models[i];
        if (place != own.minimum) {
            largest_move = std::max(largest_move, std::abs(place - match.places[i]));
            own = energy.model(i, place, energy.style.evaluate(place));
        }
        match.places[i] = place;
        const double move = place - own.place;
        match.energy += own.energy + move * (own.slope + 0.5 * own.curvature * move);
    });
    co_return largest_move;
}

// From the path's places to the minimum of E', in order.
Task<void> descend(Pace& pace, const Energy& energy, const Buffer<uint32_t>& path, GuideMatch& match) {
    const uint32_t count = energy.count();
    const double rest = small_move * energy.style.spacing();
    Buffer<Model> models(count, pace.memory());
    Chain chain(count, pace.memory());
    Slice slice(Cost::tens_of_ns);
    for (uint32_t i = 1; i + 1 < count; ++i) {
        uint32_t evaluations = 0;
        models[i] = energy.minimum_near(i, path[i], evaluations);
        if (slice.is_over(evaluations)) co_await pace;
    }
    for (;;) {
        chain.begin(energy.farthest_step);
        for (uint32_t i = 1; i + 1 < count; ++i) {
            chain.add(models[i]);
            do {
                if (slice.is_over()) co_await pace;
            } while (!chain.find_zero(i));
        }
        const double moved = co_await settle(pace, energy, chain, models, match);
        if (moved <= rest || ++match.sweeps == max_sweeps) co_return;
    }
}

}  // namespace

Task<GuideMatch> match_guide(Pace& pace, SmoothStyleCurve style, std::span<const Vec3> guide, double beta,
                             double farthest_step) {
    const Energy energy{style, guide, beta, farthest_step};
    const uint32_t count = energy.count();
    GuideMatch match{Buffer<double>(count, pace.memory())};
    // Points that share a place from the first on have moved.
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) { match.places[i] = -HUGE_VAL; });
    match.places[0] = 0.0;
    match.places[count - 1] = style.length();
    Band band = co_await reach(pace, energy);
    Table table(energy, pace.memory());
    for (uint32_t stride = coarsest_stride(energy, band);; stride /= refinement) {
        co_await find_path(pace, energy, band, stride, table);
        if (stride == 1) break;
        co_await narrow(pace, energy, table, band);
    }
    co_await descend(pace, energy, table.chosen, match);
    co_return match;
}

}  // namespace flg
