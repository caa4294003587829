// SPDX-License-Identifier: MIT
#include "stylization/patch_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flg {

namespace {

constexpr uint32_t block_size = 256;

// The three components of the displacements, from some point on.
struct Points {
    const double* t;
    const double* n;
    const double* b;

    Points(const Displacement& d, uint32_t from)
        : t(d.along_tangent.data() + from), n(d.along_normal.data() + from), b(d.along_binormal.data() + from) {}
};

// sums[c] += |point - others[c]|^2
void add_distances(double* __restrict sums, const Points& point, const Points& others, uint32_t count) {
    const double pt = *point.t, pn = *point.n, pb = *point.b;
    const double* __restrict ot = others.t, * __restrict on = others.n, * __restrict ob = others.b;
    for (uint32_t c = 0; c < count; ++c) {
        const double t = ot[c] - pt, n = on[c] - pn, b = ob[c] - pb;
        sums[c] += t * t + n * n + b * b;
    }
}

// row[c] = before[c] + |entering - others_in[c]|^2 - |leaving - others_out[c]|^2
void roll_distances(double* __restrict row, const double* __restrict before, const Points& entering,
                    const Points& others_in, const Points& leaving, const Points& others_out, uint32_t count) {
    const double et = *entering.t, en = *entering.n, eb = *entering.b;
    const double lt = *leaving.t, ln = *leaving.n, lb = *leaving.b;
    const double* __restrict it = others_in.t, * __restrict in = others_in.n, * __restrict ib = others_in.b;
    const double* __restrict ot = others_out.t, * __restrict on = others_out.n, * __restrict ob = others_out.b;
    for (uint32_t c = 0; c < count; ++c) {
        const double t = it[c] - et, n = in[c] - en, b = ib[c] - eb;
        const double u = ot[c] - lt, v = on[c] - ln, w = ob[c] - lb;
        row[c] = before[c] + ((t * t + n * n + b * b) - (u * u + v * v + w * w));
    }
}

struct Line {
    double operator()(double a, double b) const { return (a - b) * (a - b); }
};

struct Circle {
    double period;
    double operator()(double a, double b) const {
        const double way = std::abs(a - b);
        const double other = period - way;
        const double shorter = way < other ? way : other;
        return shorter * shorter;
    }
};

// sums[c] += distance_sq(value, others[c])
template <class DistanceSq>
void add_channel(double* __restrict sums, double value, const double* __restrict others, uint32_t count,
                 DistanceSq distance_sq) {
    for (uint32_t c = 0; c < count; ++c) sums[c] += distance_sq(others[c], value);
}

// row[c] += distance_sq(entering, in[c]) - distance_sq(leaving, out[c])
template <class DistanceSq>
void roll_channel(double* __restrict row, double entering, const double* __restrict in, double leaving,
                  const double* __restrict out, uint32_t count, DistanceSq distance_sq) {
    for (uint32_t c = 0; c < count; ++c) row[c] += distance_sq(in[c], entering) - distance_sq(out[c], leaving);
}

template <class Body>
void with_distance(const PatchChannel& channel, const Body& body) {
    if (channel.period > 0) {
        body(Circle{channel.period});
    } else {
        body(Line{});
    }
}

}  // namespace

PatchRows::PatchRows(const StyleScene& scene, uint32_t patch, Memory* memory)
    : scene_(scene),
      patch_(patch),
      current_(scene.node_count() + 2, memory),
      previous_(scene.node_count() + 2, memory),
      first_rows_(static_cast<size_t>(scene.node_count()) * scene.curve_count(), memory) {
    for (uint32_t curve = 0; curve < scene.curve_count(); ++curve) {
        if (scene.end_patch(curve) > scene.first_patch(curve)) last_row_ = scene.end_patch(curve) - 1;
    }
}

bool PatchRows::advance(uint32_t& units) {
    if (stage_ == Stage::fill && !fill(units)) return false;
    if (stage_ == Stage::first_rows && !sum_first_rows(units)) return false;
    if (complete_) begin_row();
    while (column_curve_ < scene_.curve_count()) {
        if (units == 0) return false;
        --units;
        const uint32_t end = block_end();
        compute_block(end);
        if (next_channel()) continue;
        column_ = end;
        if (column_ == scene_.end_patch(column_curve_)) begin_columns(column_curve_ + 1);
    }
    complete_ = true;
    return true;
}

uint32_t PatchRows::block_end() const {
    return std::min(column_ + block_size, scene_.end_patch(column_curve_));
}

uint32_t PatchRows::skip_empty(uint32_t curve) const {
    while (curve < scene_.curve_count() && scene_.end_patch(curve) == scene_.first_patch(curve)) ++curve;
    return curve;
}

void PatchRows::begin_columns(uint32_t curve) {
    column_curve_ = skip_empty(curve);
    if (column_curve_ < scene_.curve_count()) column_ = scene_.first_patch(column_curve_);
}

bool PatchRows::fill(uint32_t& units) {
    const uint32_t count = static_cast<uint32_t>(current_.size());
    while (column_ < count) {
        if (units == 0) return false;
        --units;
        const uint32_t end = std::min(column_ + block_size, count);
        for (double* row : {current_.data(), previous_.data()}) {
            std::fill(row + column_, row + end, std::numeric_limits<double>::infinity());
        }
        column_ = end;
    }
    stage_ = Stage::first_rows;
    curve_ = skip_empty(0);
    begin_columns(0);
    return true;
}

// Term by term over a block of columns, so that no unit depends on p.
bool PatchRows::sum_first_rows(uint32_t& units) {
    while (curve_ < scene_.curve_count()) {
        while (column_curve_ < scene_.curve_count()) {
            if (units == 0) return false;
            --units;
            const uint32_t end = block_end();
            sum_block(end);
            if (next_channel()) continue;
            if (++term_ <= 2 * patch_) continue;
            term_ = 0;
            column_ = end;
            if (column_ == scene_.end_patch(column_curve_)) begin_columns(column_curve_ + 1);
        }
        curve_ = skip_empty(curve_ + 1);
        begin_columns(0);
    }
    stage_ = Stage::rows;
    curve_ = skip_empty(0);
    row_ = scene_.first_patch(curve_);
    return true;
}

// Moves on to the block's next channel, or back to the displacement if there is none.
bool PatchRows::next_channel() {
    channel_ = channel_ < scene_.channels.size() ? channel_ + 1 : 0;
    return channel_ > 0;
}

void PatchRows::sum_block(uint32_t end) {
    double* sums = first_row(curve_) + column_;
    const uint32_t count = end - column_;
    const uint32_t point = scene_.first_patch(curve_) - patch_ + term_;
    const uint32_t others = column_ - patch_ + term_;
    if (channel_ > 0) {
        const PatchChannel& channel = scene_.channels[channel_ - 1];
        const double* values = channel.values.data();
        with_distance(channel,
                      [&](auto distance_sq) { add_channel(sums, values[point], values + others, count, distance_sq); });
        return;
    }
    if (term_ == 0) std::fill(sums, sums + count, 0.0);
    const Displacement& d = *scene_.displacement;
    add_distances(sums, Points(d, point), Points(d, others), count);
}

void PatchRows::begin_row() {
    complete_ = false;
    begin_columns(0);
    if (row_ + 1 < scene_.end_patch(curve_)) {
        ++row_;
        std::swap(current_, previous_);
        return;
    }
    curve_ = skip_empty(curve_ + 1);
    row_ = scene_.first_patch(curve_);
}

void PatchRows::compute_block(uint32_t end) {
    double* row = current_.data() + 1;
    uint32_t begin = column_;
    if (row_ == scene_.first_patch(curve_)) {
        const double* sums = first_row(curve_);
        if (channel_ == 0) std::copy(sums + begin, sums + end, row + begin);
        return;
    }
    if (begin == scene_.first_patch(column_curve_)) {
        row[begin] = first_row(column_curve_)[row_];
        ++begin;
    }
    const uint32_t entering = row_ + patch_, entering_others = begin + patch_;
    const uint32_t leaving = row_ - 1 - patch_, leaving_others = begin - 1 - patch_;
    if (channel_ > 0) {
        const PatchChannel& channel = scene_.channels[channel_ - 1];
        const double* values = channel.values.data();
        with_distance(channel, [&](auto distance_sq) {
            roll_channel(row + begin, values[entering], values + entering_others, values[leaving],
                         values + leaving_others, end - begin, distance_sq);
        });
        return;
    }
    const Displacement& d = *scene_.displacement;
    roll_distances(row + begin, previous_.data() + begin, Points(d, entering), Points(d, entering_others),
                   Points(d, leaving), Points(d, leaving_others), end - begin);
}

}  // namespace flg
